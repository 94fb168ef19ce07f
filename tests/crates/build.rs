//! Generates each device for each crate, like a build script of a firmware.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use objdict::generate::{Derive, Options, SharedCell, Target, generate};
use objdict::model::Device;

#[path = "src/devices.rs"]
mod devices;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("cargo:rerun-if-changed={}", devices::fixtures().display());
    println!("cargo:rerun-if-changed=src/devices.rs");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?);
    let (mut canopen_rs, mut dictionaries) = (String::new(), String::new());
    derived(&out)?;
    served(&out)?;
    let (mut zencan, mut nodes) = (String::new(), String::new());
    for (name, device) in devices::devices() {
        let path = written(&out.join("canopen-rs").join(&name), &device, "canopen-rs", &name)?;
        let path = path.display().to_string();
        writeln!(canopen_rs, "pub(crate) mod {name} {{ include!({path:?}); }}")?;
        writeln!(dictionaries, "({name:?}, |node_id| served({name}::od(node_id), node_id)),")?;

        let path = written(&out.join("zencan"), &device, "zencan", &name)?;
        zencan_build::build_node_from_device_config(&name, &path)
            .map_err(|error| format!("{name}: {error}"))?;
        writeln!(zencan, "pub(crate) mod {name} {{ zencan_node::include_modules!({name}); }}")?;
        let statics =
            ["NODE_MBOX", "NODE_STATE", "OD_TABLE"].map(|item| format!("&{name}::{item}")).join(", ");
        writeln!(nodes, "({name:?}, |node_id| start(node_id, {statics})),")?;
    }
    let list = "pub(crate) const DEVICES: &[(&str, Start)] = &[";
    writeln!(canopen_rs, "{list}\n{dictionaries}];")?;
    std::fs::write(out.join("canopen_rs.rs"), canopen_rs)?;
    writeln!(zencan, "{list}\n{nodes}];")?;
    std::fs::write(out.join("zencan.rs"), zencan)?;
    Ok(())
}

/// Rust tables that derive traits of other crates: with defmt for the library, which is compiled but not
/// linked because linking needs a logger; with serde for a test.
fn derived(out: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let (mut defmt, mut serde, mut list) = (String::new(), String::new(), String::new());
    for (name, device) in devices::devices() {
        for (derive, modules) in [(Derive::Defmt, &mut defmt), (Derive::Serde, &mut serde)] {
            let folder = out.join(format!("{derive:?}")).join(&name);
            std::fs::create_dir_all(&folder)?;
            let mut options = Options::default();
            options.derives = vec![derive];
            let generated = generate(&device, Target::RUST, &options)?;
            let path = folder.join(&generated.files[0].path);
            std::fs::write(&path, &generated.files[0].contents)?;
            let path = path.display().to_string();
            writeln!(modules, "/// A table.\npub mod {name} {{ include!({path:?}); }}")?;
        }
        writeln!(list, "({name:?}, |node_id| round({name}::Data::new(node_id))),")?;
    }
    std::fs::write(out.join("defmt.rs"), defmt)?;
    writeln!(
        serde,
        "/// A device and its round trip, for a node-ID.\ntype Trip = (&'static str, fn(u8));\n"
    )?;
    writeln!(serde, "const DEVICES: &[Trip] = &[\n{list}];")?;
    std::fs::write(out.join("serde.rs"), serde)?;
    Ok(())
}

/// Rust tables that use `objdict-device`, and their PDOs.
fn served(out: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let (mut modules, mut pdos) = (String::new(), String::new());
    for (name, device) in devices::devices() {
        let mut options = Options::default();
        options.runtime = true;
        options.node_id = Some(5);
        options.cell = Some(SharedCell::CriticalSection);
        options.groups = vec!["1000-1FFF=COMMUNICATION".parse()?, "6000-9FFF=APPLICATION".parse()?];
        if name == "io_401" {
            options.hooks = ["6202:1".parse()?].into();
        }
        let generated = generate(&device, Target::RUST, &options)?;
        let contents = std::str::from_utf8(&generated.files[0].contents)?;
        let path = out.join(format!("{name}_runtime.rs"));
        std::fs::write(&path, contents)?;
        writeln!(modules, "pub(crate) mod {name} {{ include!({:?}); }}", path.display().to_string())?;
        let implementations = contents.split("impl objdict_device::Pdo for ").skip(1);
        for type_name in implementations.filter_map(|rest| rest.split(' ').next()) {
            let direction = if type_name.starts_with('T') { "transmits" } else { "receives" };
            let path = format!("{name}::pdo::{type_name}");
            writeln!(pdos, "({path:?}, || {direction}::<_, {path}, _>({name}::Data::new(5))),")?;
        }
    }
    let list = "/// A PDO and its test.\ntype Exchange = (&'static str, fn() -> bool);\n\nconst PDOS: &[Exchange] = &[";
    std::fs::write(out.join("runtime.rs"), format!("{modules}{list}\n{pdos}];\n"))?;
    Ok(())
}

/// Generates into a folder; returns the path of the only file.
fn written(
    folder: &Path,
    device: &Device,
    target: &str,
    stem: &str,
) -> Result<PathBuf, Box<dyn std::error::Error>> {
    std::fs::create_dir_all(folder)?;
    let mut options = Options::default();
    options.file_stem = stem.to_owned();
    let generated = generate(device, Target::named(target)?, &options)
        .map_err(|error| format!("{stem} for {target}: {error}"))?;
    let [file] = generated.files.as_slice() else { return Err("one file was expected".into()) };
    let path = folder.join(&file.path);
    std::fs::write(&path, &file.contents)?;
    Ok(path)
}

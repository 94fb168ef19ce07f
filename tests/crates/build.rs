//! Generates each device for each crate, as the build script of a firmware would.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use objdict::generate::{Options, Target, generate};
use objdict::model::Device;

#[path = "src/devices.rs"]
mod devices;

fn main() {
    println!("cargo:rerun-if-changed={}", devices::fixtures().display());
    println!("cargo:rerun-if-changed=src/devices.rs");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets it"));
    let mut canopen_rs = String::new();
    let mut names = String::new();
    for (name, device) in devices::devices() {
        let path = written(&out.join("canopen-rs").join(&name), &device, "canopen-rs", &name);
        let path = path.display();
        let _ = write!(canopen_rs, "pub(crate) mod {name} {{ include!({:?}); }}\n", path.to_string());
        let _ = write!(names, "({name:?}, |node_id| served({name}::od(node_id), node_id)),\n");
    }
    let _ = write!(
        canopen_rs,
        "pub(crate) const DEVICES: &[(&str, fn(u8) -> Box<dyn Served>)] = &[\n{names}];\n"
    );
    std::fs::write(out.join("canopen_rs.rs"), canopen_rs).expect("the folder can be written");
}

/// Generates into a folder; the path of the file, of which there is one.
fn written(folder: &Path, device: &Device, target: &str, stem: &str) -> PathBuf {
    std::fs::create_dir_all(folder).expect("the folder can be made");
    let target = Target::named(target).expect("a target");
    let mut options = Options::default();
    options.file_stem = stem.to_owned();
    let generated = generate(device, target, &options).unwrap_or_else(|error| panic!("{stem}: {error}"));
    let [file] = generated.files.as_slice() else { panic!("{stem}: one file was expected") };
    let path = folder.join(&file.path);
    std::fs::write(&path, &file.contents).expect("the file can be written");
    path
}

//! The text generated for third-party crates: deterministic, well-formed, and no description name changes its
//! meaning. The meaning itself is tested with the crates in tests/crates.

use std::process::Command;

use objdict::generate::{Generated, Options, Target, generate};
use objdict::model::Device;

use crate::devices::{device, devices};
use crate::output::bare;
use crate::support::{self, skips::has};
use crate::verdicts::accepts;

fn generated(device: &Device, target: &str) -> Generated {
    let generated = generate(device, Target::named(target).unwrap(), &Options::default()).unwrap();
    assert_eq!(generated.files.len(), 1);
    generated
}

fn text(generated: &Generated) -> &str {
    std::str::from_utf8(&generated.files[0].contents).unwrap()
}

/// A copy of a device with malicious names.
fn hostile(plain: &Device) -> Device {
    let attack = "x */ } \"); system(\"id\"); // \u{202E} ??/ \\\n#error `\n\"\"\"\n]]\n'''";
    let mut hostile = plain.clone();
    for object in hostile.objects.values_mut() {
        object.main.name = attack.into();
        object.subs.iter_mut().for_each(|(_, entry)| entry.name = attack.into());
    }
    hostile
}

#[test]
fn output_is_always_the_same_and_harmless() {
    for (name, device) in devices() {
        for target in TARGETS {
            let first = generated(&device, target);
            assert_eq!(first, generated(&device, target), "{name}: {target}");
            let text = text(&first);
            assert!(text.ends_with('\n') && !text.ends_with("\n\n"), "{name}: {target}");
            for (number, line) in text.lines().enumerate() {
                let plain = |c: char| c == ' ' || c.is_ascii_graphic() || c.is_alphanumeric();
                assert!(
                    line.trim_end() == line && line.chars().all(plain),
                    "{name}: {target}: {number}: {line}"
                );
            }
        }
    }
}

const TARGETS: [&str; 2] = ["canopen-rs", "zencan"];

#[test]
fn canopen_rs_is_well_formed() {
    let program = std::env::var("RUSTFMT").unwrap_or_else(|_| "rustfmt".to_owned());
    if !has(&program, "rustfmt") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (name, device) in devices() {
        let path = folder.path().join("od.rs");
        std::fs::write(&path, &generated(&device, "canopen-rs").files[0].contents).unwrap();
        let mut rustfmt = Command::new(&program);
        rustfmt.current_dir(folder.path());
        rustfmt.args(["--edition=2021", "--check", "--config-path", "/dev/null", "od.rs"]);
        accepts(&mut rustfmt).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn canopen_rs_is_not_changed_by_names() {
    let plain = device(&support::fixtures().join("eds/io-401.eds"));
    let code = |device: &Device| bare(text(&generated(device, "canopen-rs")));
    assert_eq!(code(&plain), code(&hostile(&plain)));
}

#[test]
fn canopen_rs_of_a_small_device() {
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    let version = concat!("objdict ", env!("CARGO_PKG_VERSION"));
    insta::assert_snapshot!(text(&generated(&minimal, "canopen-rs")).replace(version, "objdict [version]"));
}

/// The function name is an identifier for any module name.
#[test]
fn canopen_rs_has_the_name_of_the_module() {
    let minimal = device(&support::fixtures().join("eds/minimal.eds"));
    for (module, function) in [("motor", "motor"), ("type", "type_"), ("put", "put_od")] {
        let mut options = Options::default();
        options.module = Some(module.to_owned());
        let generated = generate(&minimal, Target::named("canopen-rs").unwrap(), &options).unwrap();
        assert_eq!(generated.files[0].path, format!("{module}.rs"));
        assert!(text(&generated).contains(&format!("pub fn {function}(node_id: u8)")), "{module}");
    }
}

#[test]
fn canopen_rs_names_what_it_cannot_hold() {
    let odd = crate::odd::device();
    let notes: Vec<String> = generated(&odd, "canopen-rs").notes.iter().map(ToString::to_string).collect();
    insta::assert_snapshot!("canopen_rs_odd_notes", notes.join("\n"));
}

fn toml_of(device: &Device) -> toml::Table {
    text(&generated(device, "zencan")).parse().unwrap()
}

/// The TOML without names; their number must not change.
fn without_names(mut table: toml::Table) -> toml::Table {
    let objects = table.get_mut("objects").and_then(toml::Value::as_array_mut).unwrap();
    for object in objects.iter_mut().filter_map(toml::Value::as_table_mut) {
        assert!(object.remove("parameter_name").is_some());
        let subs = object.get_mut("subs").and_then(toml::Value::as_array_mut);
        for sub in subs.into_iter().flatten().filter_map(toml::Value::as_table_mut) {
            assert!(sub.remove("parameter_name").is_some() && sub.remove("field_name").is_some());
        }
    }
    table
}

#[test]
fn zencan_is_toml() {
    for (name, device) in devices() {
        let table = toml_of(&device);
        assert!(table.contains_key("device_name") && table.contains_key("identity"), "{name}");
    }
}

#[test]
fn zencan_is_not_changed_by_names() {
    let plain = device(&support::fixtures().join("eds/io-401.eds"));
    let hostile = hostile(&plain);
    assert_eq!(without_names(toml_of(&plain)), without_names(toml_of(&hostile)));
    let name = &hostile.objects[&0x6000].main.name;
    let text = toml_of(&hostile);
    let objects = text["objects"].as_array().unwrap();
    let object = objects.iter().find(|object| object["index"].as_integer() == Some(0x6000)).unwrap();
    assert_eq!(object["parameter_name"].as_str(), Some(&**name));
}

#[test]
fn zencan_of_a_small_device() {
    let encoder = device(&support::fixtures().join("eds/encoder-406.eds"));
    let version = concat!("objdict ", env!("CARGO_PKG_VERSION"));
    let generated = generated(&encoder, "zencan");
    insta::assert_snapshot!(text(&generated).replace(version, "objdict [version]"));
    let notes: Vec<String> = generated.notes.iter().map(ToString::to_string).collect();
    insta::assert_snapshot!("zencan_notes", notes.join("\n"));
}

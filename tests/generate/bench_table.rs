//! The table used by benches/speed/lookup.rs is the current output of the generator.

use std::path::Path;

use objdict::generate::Options;
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

use crate::compile::generate_with;

/// 76 objects with 157 entries, like the dictionary used for the project's figures.
fn device() -> Device {
    let entry = |name: String, access, number| Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(DataType::UNSIGNED32),
        access: Some(access),
        default: Some(Value::Unsigned(number)),
        ..Entry::default()
    };
    let mut device = Device::default();
    for number in 0..49_u16 {
        let main = entry(format!("Parameter {number}"), Access::Rw, u64::from(number));
        device.objects.insert(0x2000 + 7 * number, Object { main, ..Object::default() });
    }
    for number in 0..27_u16 {
        let main = Entry {
            name: format!("Axis {number}").into(),
            object_type: Some(ObjectType::Record),
            ..Entry::default()
        };
        let count = entry("Highest sub-index supported".to_owned(), Access::Const, 3);
        let subs = (1..=3).map(|sub| (sub, entry(format!("Gain {sub}"), Access::Rw, u64::from(sub))));
        let subs = std::iter::once((0, Entry { data_type: Some(DataType::UNSIGNED8), ..count }))
            .chain(subs)
            .collect();
        device.objects.insert(0x6000 + 16 * number, Object { main, subs, ..Object::default() });
    }
    device
}

/// `OBJDICT_BLESS=1 cargo test --test generate bench_table` updates the table.
#[test]
fn the_table_of_the_benchmark_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/speed/lookup/od.rs");
    let folder = tempfile::tempdir().unwrap();
    let mut options = Options::default();
    options.runtime = true; // the code that serves the table is in objdict-device
    let generated = generate_with(folder.path(), &device(), "rust", &options);
    let written = String::from_utf8(generated.files[0].contents.clone()).unwrap();
    assert!(written.contains("pub static ENTRIES: [Entry; 157]"));
    if std::env::var_os("OBJDICT_BLESS").is_some() {
        std::fs::write(&path, &written).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap();
    let behind_the_version = |text: &str| text.split_once('\n').map(|(_, rest)| rest.to_owned());
    assert!(behind_the_version(&kept) == behind_the_version(&written), "write it anew: OBJDICT_BLESS=1");
}

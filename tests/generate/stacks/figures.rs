//! The size of the plain C table on a 32-bit processor compared with CANopenNode for the same description: 76
//! objects with 157 entries, like the device used for the project's figures.

use std::path::Path;

use objdict::generate::{Options, Sizes, Target, generate, size};
use objdict::model::{Access, DataType, Device, Entry, Object, ObjectType, Value};

use crate::compile::{c_compiler, cc, succeed};
use crate::processors::build;
use crate::stacks::beside;
use crate::stacks::measure::{Measured, tools};

/// Size of the output of CANopenNode's own generator for that device on a Cortex-M4, in bytes: constants, and
/// values with the list of objects. Values with a non-zero initial value are also in flash.
const CONSTANTS: usize = 1_716;
const VALUES: usize = 1_376;

const TYPES: [DataType; 5] = [
    DataType::UNSIGNED32,
    DataType::UNSIGNED16,
    DataType::INTEGER16,
    DataType::UNSIGNED8,
    DataType::INTEGER32,
];

/// An entry with one of the types; every third one has limits.
fn entry(name: String, number: u16) -> Entry {
    let mut entry = Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(TYPES[usize::from(number) % TYPES.len()]),
        access: Some(Access::Rw),
        default: Some(Value::Unsigned(u64::from(number % 100))),
        ..Entry::default()
    };
    if number.is_multiple_of(3) {
        entry.low_limit = Some(Value::Unsigned(0));
        entry.high_limit = Some(Value::Unsigned(120));
    }
    entry
}

/// This number of VARs, and of RECORDs with three members and sub-index 0.
pub(crate) fn device(vars: u16, records: u16) -> Device {
    let mut device = Device::default();
    for number in 0..vars {
        let main = entry(format!("Parameter {number}"), number);
        device.objects.insert(0x2000 + 7 * number, Object { main, ..Object::default() });
    }
    for number in 0..records {
        let main = Entry {
            name: format!("Axis {number}").into(),
            object_type: Some(ObjectType::Record),
            ..Entry::default()
        };
        let count = Entry {
            data_type: Some(DataType::UNSIGNED8),
            access: Some(Access::Const),
            default: Some(Value::Unsigned(3)),
            ..entry("Highest sub-index supported".to_owned(), 1)
        };
        let subs = (1..=3).map(|sub: u8| (sub, entry(format!("Gain {sub}"), 3 * number + u16::from(sub))));
        let subs = std::iter::once((0, count)).chain(subs).collect();
        device.objects.insert(0x6000 + 16 * number, Object { main, subs, ..Object::default() });
    }
    device
}

fn write(folder: &Path, device: &Device, target: &str) {
    let target = Target::named(target).unwrap();
    for file in generate(device, target, &Options::default()).unwrap().files {
        std::fs::write(folder.join(&file.path), &file.contents).unwrap();
    }
}

#[test]
fn the_plain_table_takes_no_more_than_that_of_canopennode() {
    let Some(tools) = tools() else { return };
    let device = device(49, 27);
    let entries: usize = device.objects.values().map(|object| object.entries().count()).sum();
    assert_eq!((device.objects.len(), entries), (76, 157));
    let measured = |target: &str, sources: &[&str], options: &[&str]| -> Measured {
        let folder = tempfile::tempdir().unwrap();
        write(folder.path(), &device, target);
        std::fs::write(folder.path().join("data.c"), "#include \"od.h\"\nod_data_t data;\n").unwrap();
        let mut cc = tools.cc(folder.path());
        cc.arg("-I.")
            .arg(format!("-I{}", beside("canopennode", "include").display()))
            .args(sources)
            .args(options);
        succeed(&mut cc, "").unwrap();
        tools.measure(folder.path()).unwrap()
    };
    // tables only: the code is part of the stack or of `od.c`, and its size does not depend on the number of
    // entries
    let plain = measured("c", &["od.c", "data.c"], &[]);
    let stack = measured("canopennode", &["OD.c"], &[]);
    assert!(plain.flash <= stack.flash && plain.ram <= stack.ram, "{plain:?}, {stack:?}");
    assert!(plain.flash <= CONSTANTS + VALUES && plain.ram <= VALUES, "{plain:?}");
    assert!(plain.flash <= 1_750, "{plain:?}");
    let all = |measured: Measured| measured.flash + measured.ram + measured.code;
    assert!(all(plain) <= all(stack), "{plain:?}, {stack:?}"); // even including the code

    let with_names = measured("c", &["od.c", "data.c"], &["-UOD_NO_NAMES"]);
    let Sizes::Known(report) = size(&device, Target::named("c").unwrap(), &Options::default()).unwrap()
    else {
        panic!("the sizes are unknown");
    };
    assert_eq!(with_names.flash - plain.flash, report.names);
}

const COUNTS: &str = r#"
#include <stdio.h>
static unsigned long compared;
#include "od.c"

int main(void)
{
    unsigned long worst = 0u;
    unsigned long key;
    for (key = 0u; key <= 0xFFFFFFul; key += 1u + (key % 5u)) {
        compared = 0u;
        (void)od_find((uint16_t)(key >> 8), (uint8_t)(key & 0xFFu));
        worst = compared > worst ? compared : worst;
    }
    for (key = 0u; key < OD_ENTRY_COUNT; key++) {
        const uint16_t index = od_index(&od_entries[key]);
        compared = 0u;
        (void)od_find(index, od_entries[key].sub);
        worst = compared > worst ? compared : worst;
    }
    printf("%lu", worst);
    return 0;
}
"#;

/// A copy of the source counts comparisons of two keys; equality is checked once more for each of them.
#[test]
fn an_object_and_its_entry_are_found_with_log2_of_n_comparisons() {
    let Some(compiler) = c_compiler() else { return };
    for (vars, records) in [(1, 0), (2, 0), (3, 0), (64, 0), (65, 0), (49, 27), (500, 200)] {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        write(folder, &device(vars, records), "c");
        let source = std::fs::read_to_string(folder.join("od.c")).unwrap();
        let counting = ["if (od_objects[object + half].index <= index)", "if (entry[half].sub <= sub)"]
            .into_iter()
            .fold(source, |source, ordered| {
                assert_eq!(source.matches(ordered).count(), 1);
                source.replace(ordered, &format!("compared++;\n        {ordered}"))
            });
        std::fs::write(folder.join("od.c"), counting).unwrap();
        std::fs::write(folder.join("counts.c"), COUNTS).unwrap();
        let objects = f64::from(vars) + f64::from(records);
        let of_a_record = if records == 0 { 0.0 } else { 2.0 };
        let most = objects.log2().ceil() + of_a_record;
        let programs = build(cc(&compiler, folder).args(["-O1", "-I.", "-o", "counts", "counts.c"]));
        let compare = |worst: &str| match worst.parse::<f64>().unwrap() <= most {
            true => Ok(()),
            false => Err(format!("{worst} comparisons among {objects} objects")),
        };
        programs.check(&[], "", &most, compare).unwrap();
    }
}

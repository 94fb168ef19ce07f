//! A disabled object does not exist: a description with `CO_disabled` at an object is answered as the description without it.

use objdict::diagnostic::Diagnostic;
use objdict::format::{self, Description, Format, WriteOptions};
use objdict::generate::{self, Target};
use objdict::lint::changes::{DeviceChange, compare};
use objdict::model::{Device, Object};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

/// Objects without which there is no table.
const NEEDED: [u16; 3] = [0x1000, 0x1001, 0x1018];

fn read(text: Vec<u8>, format: Format) -> Description {
    let source = SourceFile::from_bytes("device", text, &SourceOptions::default()).unwrap();
    format::read(source, format)
}

/// The device in a format with the object marked, and without it.
fn both(device: &Device, index: u16, format: Format) -> [Description; 2] {
    let mut marked = device.clone();
    marked.objects.get_mut(&index).unwrap().main.stack_mut().disabled = Some(true);
    let options = WriteOptions::default();
    let without = format::write(&marked.without_disabled(), format, &options).unwrap();
    let written = format::write(&marked, format, &options).unwrap();
    let read_again = read(written.bytes, format);
    let is_kept = read_again.described().object(index).is_some_and(Object::is_disabled);
    let is_lost = written.losses.iter().any(|loss| loss.path == format!("/objects/0x{index:04X}/stack"));
    assert!(is_kept != is_lost, "{index:04X}h as {}: the mark is kept, or a loss", format.name());
    [read_again, read(without.bytes, format)]
}

fn findings(description: &Description) -> Vec<String> {
    let line = |finding: &Diagnostic| format!("{} {}", finding.rule.id, finding.message);
    let mut found: Vec<String> = objdict::check(description).iter().map(line).collect();
    // a condition that names a parameter that is gone is not written
    let others = ["cia306/disabled-object", "cia306/file-name", "cia311/missing-condition"];
    found.retain(|line| !others.iter().any(|other| line.starts_with(other)));
    found.sort();
    found
}

fn tables(description: &Description) -> Vec<Vec<u8>> {
    let made = |target| generate::generate(description.device(), target, &generate::Options::default());
    let targets = ["c", "canopennode"].map(|name| Target::named(name).unwrap());
    let files = targets.into_iter().filter_map(|target| made(target).ok()).flat_map(|made| made.files);
    files.map(|file| file.contents).collect()
}

/// The device without the groups of its parameters; like conditional support, they may name a parameter that is gone.
fn dictionary(description: &Description) -> Device {
    Device { application: Vec::new(), ..description.device().clone() }
}

#[test]
fn a_disabled_object_does_not_exist() {
    let mut tried = 0;
    for name in ["eds/io-401.eds", "xdd/press-402.xdd"] {
        let description = format::open(&support::fixtures().join(name), &SourceOptions::default()).unwrap();
        let device = description.device();
        let objects: Vec<u16> =
            device.objects.keys().copied().filter(|index| !NEEDED.contains(index)).collect();
        for index in support::skips::sample(objects) {
            for format in [Format::Eds, Format::Xdd] {
                let [marked, without] = both(device, index, format);
                let at = format!("{name}: {index:04X}h as {}", format.name());
                let kept = marked.described().object(index);
                assert!(kept.is_some(), "{at} is kept in the file");
                if !kept.is_some_and(Object::is_disabled) {
                    continue; // an XDD has no place for the mark at an object without a parameter, which is a loss
                }
                let differences = objdict::compare::differences(&dictionary(&marked), &dictionary(&without));
                let paths: Vec<&str> = differences
                    .iter()
                    .map(|one| one.path.as_str())
                    .filter(|path| !path.ends_with("/conditional_support"))
                    .collect();
                assert_eq!(paths, [""; 0], "{at}");
                assert_eq!(findings(&marked), findings(&without), "{at}");
                let changes = compare(&dictionary(&marked), &dictionary(&without));
                // conditions, and the versions that do not move with them
                let is_condition = |change: &DeviceChange| {
                    change.message.to_string().contains("conditional_support")
                        || change.rule.info.id.contains("-not-")
                };
                let changes: Vec<_> = changes.iter().filter(|change| !is_condition(change)).collect();
                assert!(changes.is_empty(), "{at}: {changes:?}");
                assert_eq!(tables(&marked), tables(&without), "{at}");
                tried += 1;
            }
        }
    }
    assert!(tried > 10, "{tried}");
}

//! What a conversion makes of what one format says and the other says otherwise, or not at all.

use objdict::format::{self, Description, Format, LossKind, WriteOptions, Written};
use objdict::model::Device;
use objdict::source::SourceFile;

use crate::support;

fn read(text: &str, format: Format) -> Description {
    format::read(SourceFile::from_text("converted", text), format)
}

/// A base of the fixtures with some lines replaced.
fn base(name: &str, changes: &[(&str, &str)]) -> Device {
    let text = std::fs::read_to_string(support::fixtures().join("bases").join(name)).unwrap();
    let changed = changes.iter().fold(text, |text, (old, new)| {
        assert!(text.contains(old), "{name} has no `{old}`");
        text.replace(old, new)
    });
    let format = if name.ends_with(".xdd") { Format::Xdd } else { Format::Eds };
    read(&changed, format).into_device()
}

fn convert(device: &Device, to: Format) -> (String, Written) {
    let mut options = WriteOptions::default();
    options.embed = true;
    let written = format::write(device, to, &options).unwrap();
    (String::from_utf8(written.bytes.clone()).unwrap(), written)
}

/// The losses of a kind, as paths.
fn paths(written: &Written, kind: LossKind) -> Vec<&str> {
    let losses = written.losses.iter().filter(|loss| loss.kind == kind);
    losses.map(|loss| loss.path.as_str()).collect()
}

#[test]
fn dates_and_times_get_the_spelling_of_the_format() {
    let device = base(
        "bare.eds",
        &[
            ("CreationTime=09:15AM", "CreationTime=9:15 pm"),
            ("CreationDate=03-04-2024", "CreationDate=17/07/2024"),
            ("ModificationTime=02:40PM", "ModificationTime=after lunch"),
            ("ModificationDate=11-18-2024", "ModificationDate=07-Aug-2024"),
        ],
    );
    let (xdd, written) = convert(&device, Format::Xdd);
    for attribute in [
        r#"fileCreationTime="21:15:00""#,
        r#"fileCreationDate="2024-07-17""#,
        r#"fileModificationDate="2024-08-07""#,
    ] {
        assert_eq!(xdd.matches(attribute).count(), 2, "{attribute}");
    }
    assert!(!xdd.contains("fileModificationTime"));
    assert!(paths(&written, LossKind::Embedded).contains(&"/file_info/misfits"));
    let back = read(&xdd, Format::Xdd).into_device();
    assert_eq!(back.file_info, device.file_info);
    let (eds, _) = convert(&back, Format::Eds);
    assert!(eds.contains("CreationTime=09:15PM\r\nCreationDate=07-17-2024\r\n"), "{eds}");
    assert!(
        eds.contains("ModificationDate=08-07-2024\r\n") && eds.contains("ModificationTime=after lunch\r\n")
    );
}

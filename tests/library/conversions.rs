//! What a conversion makes of what one format says and the other says otherwise, or not at all.

use objdict::format::{self, Description, Format, LossKind, WriteOptions, Written};
use objdict::model::Device;
use objdict::source::SourceFile;

use crate::support;

fn read(text: &str, format: Format) -> Description {
    format::read(SourceFile::from_text("converted", text), format)
}

/// A base of the fixtures with some texts replaced.
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

/// bare.eds without the lines of some keys.
fn bare_without(keys: &[&str]) -> Device {
    let text = std::fs::read_to_string(support::fixtures().join("bases/bare.eds")).unwrap();
    let is_kept = |line: &&str| !keys.iter().any(|key| line.starts_with(key));
    let lines: Vec<&str> = text.lines().filter(is_kept).collect();
    read(&lines.join("\n"), Format::Eds).into_device()
}

#[test]
fn what_the_format_demands_is_invented_and_not_read_back() {
    let bare = bare_without(&["CreatedBy", "CreationDate", "Granularity", "BaudRate_"]);
    let (xdd, written) = convert(&bare, Format::Xdd);
    assert!(xdd.contains(r#"<supportedBaudRate value="250 Kbps" />"#) && xdd.contains("1970-01-01"), "{xdd}");
    assert_eq!(
        paths(&written, LossKind::Invented),
        [
            "/device_info/baud_rates/250",
            "/device_info/granularity",
            "/file_info/created_by",
            "/file_info/creation_date"
        ]
    );
    let back = read(&xdd, Format::Xdd).into_device();
    assert_eq!((&back.device_info, &back.file_info), (&bare.device_info, &bare.file_info));
    let (eds, written) = convert(&back, Format::Eds);
    assert_eq!(paths(&written, LossKind::Invented), [""; 0]);
    assert!(
        !eds.contains("BaudRate_250") && !eds.contains("CreatedBy") && !eds.contains("CreationDate"),
        "{eds}"
    );
}

#[test]
fn the_ids_of_version_1_0_are_invented() {
    let nameless = bare_without(&["VendorNumber"]);
    let mut options = WriteOptions::default();
    options.xdd_version = format::XddVersion::V1_0;
    let written = format::write(&nameless, Format::Xdd, &options).unwrap();
    assert_eq!(paths(&written, LossKind::Invented), ["/device_info/vendor_number"]);
    let text = String::from_utf8(written.bytes).unwrap();
    let back = read(&text, Format::Xdd).into_device();
    assert_eq!(back.device_info.unwrap().vendor_number, None);
}

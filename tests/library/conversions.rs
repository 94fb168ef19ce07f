//! What a conversion makes of what one format says and the other says otherwise, or not at all.

use std::borrow::Cow;
use std::path::PathBuf;

use objdict::compare::{DatumDifference, differences};
use objdict::format::{self, Description, Dialect, Format, LossKind, WriteOptions, Written};
use objdict::model::{Access, DataType, Device, Value};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn read(text: &str, format: Format) -> Description {
    format::read(SourceFile::from_text("converted", text), format)
}

/// A base of the fixtures with some texts replaced.
fn base(name: &str, changes: &[(&str, &str)]) -> Device {
    let text = std::fs::read_to_string(support::fixtures().join("bases").join(name)).unwrap();
    let changed = changes.iter().fold(text, |text, (old, new)| {
        assert!(text.contains(old), "{name} has no `{old}`");
        text.replacen(old, new, 1)
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

#[test]
fn version_1_0_has_a_text_about_the_product() {
    let mut bare = bare_without(&["Description"]);
    let mut options = WriteOptions::default();
    options.xdd_version = format::XddVersion::V1_0;
    // an empty one says nothing either
    bare.file_info.get_or_insert_default().description = Some(String::new());
    let written = format::write(&bare, Format::Xdd, &options).unwrap();
    assert!(String::from_utf8(written.bytes).unwrap().contains(">not stated</description>"));
    bare.file_info.get_or_insert_default().description = None;
    let written = format::write(&bare, Format::Xdd, &options).unwrap();
    let text = String::from_utf8(written.bytes.clone()).unwrap();
    assert!(
        text.contains("<productText>") && text.contains(r#"<description lang="en">not stated</description>"#),
        "{text}"
    );
    assert!(paths(&written, LossKind::Invented).contains(&"/file_info/description"));
    let back = read(&text, Format::Xdd).into_device();
    assert_eq!(back.file_info.unwrap().description, None);
    assert!(back.identity.is_none_or(|identity| identity.product_text.is_empty()));
}

#[test]
fn readers_that_demand_sections_get_them_empty() {
    let device =
        read("[1003]\nParameterName=Errors\nObjectType=8\nSubNumber=255\nCompactSubObj=255\n", Format::Eds)
            .into_device();
    for dialect in [Dialect::PythonCanopen, Dialect::CanOpenEditor] {
        let written = format::write(&device, Format::Eds, &WriteOptions::from(dialect)).unwrap();
        let invented = paths(&written, LossKind::Invented);
        assert!(invented.iter().all(|path| path.starts_with("/objects/0x1003/")), "{invented:?}");
        assert_eq!(paths(&written, LossKind::Lost).len(), 1, "{:?}", written.losses);
        let text = String::from_utf8(written.bytes).unwrap();
        for section in [
            "[FileInfo]\r\n",
            "[DeviceInfo]\r\n",
            "[DummyUsage]\r\nDummy0001=0\r\n",
            "[Comments]\r\nLines=0\r\n",
        ] {
            assert!(text.contains(section), "{section} {text}");
        }
        assert!(!text.contains("CompactSubObj"), "{text}");
    }
    let written = format::write(&device, Format::Eds, &WriteOptions::default()).unwrap();
    assert!(!String::from_utf8(written.bytes).unwrap().contains("[FileInfo]"));
}

#[test]
fn keys_before_the_first_section_are_lost_in_every_dialect() {
    let device = read("Stray=5\n[1000]\nParameterName=Device type\nDataType=7\nAccessType=ro\n", Format::Eds)
        .into_device();
    for dialect in Dialect::ALL {
        let written = format::write(&device, Format::Eds, &WriteOptions::from(dialect)).unwrap();
        assert!(
            written
                .losses
                .iter()
                .any(|loss| loss.kind == LossKind::Lost && loss.value.to_string().contains("Stray")),
            "{dialect:?}"
        );
        let text = String::from_utf8(written.bytes).unwrap();
        assert!(text.starts_with('[') && !text.contains("Stray"), "{dialect:?}: {text}");
    }
}

#[test]
fn a_domain_is_rw_and_has_no_default_in_an_xdd() {
    let device = base(
        "small.eds",
        &[(
            "[ManufacturerObjects]",
            "[2F00]\nParameterName=Program\nObjectType=0x2\nDefaultValue=01A1\n\n[ManufacturerObjects]",
        )],
    );
    let program = &device.object(0x2F00).unwrap().main;
    assert_eq!(
        (program.implied_type(), program.implied_access()),
        (Some(DataType::DOMAIN), Some(Access::Rw))
    );
    assert_eq!(program.default, Some(Value::Bytes([0x01, 0xA1].into())));
    let (xdd, written) = convert(&device, Format::Xdd);
    let line = xdd.lines().find(|line| line.contains(r#"index="2F00""#)).unwrap();
    assert!(line.contains(r#"dataType="000F" accessType="rw""#) && !line.contains("defaultValue"), "{line}");
    assert!(paths(&written, LossKind::Embedded).contains(&"/objects/0x2F00/default"));
    assert_eq!(differences(&device, &read(&xdd, Format::Xdd).into_device()), []);
}

#[test]
fn an_access_type_with_a_character_that_xml_lacks_comes_back() {
    let device = base("small.eds", &[("AccessType=ro\n", "AccessType=ro\u{c}\n")]);
    let (text, _) = convert(&device, Format::Xdd);
    roxmltree::Document::parse(&text).unwrap();
    assert!(differences(&device, &read(&text, Format::Xdd).into_device()).is_empty());
}

/// An XDD with two objects, of which the second has a parameter of this access and content.
fn with_parameter(access: &str, content: &str) -> Device {
    let objects = r#"<CANopenObject index="2F00" name="Level" objectType="7" dataType="0006" uniqueIDRef="UID_LEVEL"/></CANopenObjectList>"#;
    let process = format!(
        r#"<ApplicationProcess><parameterList><parameter uniqueID="UID_LEVEL" access="{access}"><label lang="en">Level</label><UINT/>{content}</parameter></parameterList></ApplicationProcess></ProfileBody>"#
    );
    base("lamp.xdd", &[("</CANopenObjectList>", objects), ("</ProfileBody>", &process)])
}

#[test]
fn access_of_parameters_survives_an_eds() {
    for (word, access) in [
        ("noAccess", None),
        ("const", Some("const")),
        ("read", Some("ro")),
        ("write", Some("wo")),
        ("readWrite", Some("rw")),
        ("readWriteInput", Some("rwr")),
        ("readWriteOutput", Some("rww")),
    ] {
        let device = with_parameter(word, "");
        let (eds, _) = convert(&device, Format::Eds);
        let section = eds.split("[2F00]").nth(1).unwrap().split('[').next().unwrap();
        let stated = section.lines().find_map(|line| line.strip_prefix("AccessType="));
        assert_eq!(stated, access, "{word}");
        let back = read(&eds, Format::Eds).into_device();
        assert_eq!(differences(&device, &back), [], "{word}");
        let (xdd, _) = convert(&back, Format::Xdd);
        assert!(xdd.contains(&format!(r#"access="{word}""#)), "{word}: {xdd}");
    }
}

#[test]
fn steps_and_gaps_of_ranges_survive_an_eds() {
    let ranges = r#"<allowedValues><range><minValue value="10"/><maxValue value="20"/><step value="5"/></range><range><minValue value="100"/><maxValue value="120"/></range></allowedValues>"#;
    let device = with_parameter("readWrite", ranges);
    let (eds, _) = convert(&device, Format::Eds);
    assert!(eds.contains("LowLimit=10\r\nHighLimit=120\r\n"), "{eds}");
    let back = read(&eds, Format::Eds).into_device();
    assert_eq!(differences(&device, &back), []);
    let (xdd, _) = convert(&back, Format::Xdd);
    assert_eq!(differences(&device, &read(&xdd, Format::Xdd).into_device()), []);
    assert!(xdd.contains(r#"<step value="5" />"#) && xdd.contains(r#"<minValue value="100" />"#), "{xdd}");
}

/// An access type that is not one, and a data type that is missing, are those of CiA 301, else what is meant, and are reported.
#[test]
fn type_and_access_are_those_of_the_standard() {
    let text = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let mut own = "[ManufacturerObjects]\r\nSupportedObjects=2\r\n1=0x2000\r\n2=0x2001\r\n".to_owned();
    for (index, access) in [(2000, "w"), (2001, "R")] {
        own += &format!(
            "[{index}]\r\nParameterName=Own\r\nObjectType=7\r\nDataType=5\r\nAccessType={access}\r\n"
        );
    }
    let lines: Vec<&str> = text.lines().collect();
    let changed =
        lines.iter().map(|line| if line.starts_with("AccessType=") { "AccessType=r" } else { line });
    let changed: Vec<&str> = changed.filter(|line| *line != "DataType=0x0006").collect();
    let device = read(&format!("{}\r\n{own}", changed.join("\r\n")), Format::Eds).into_device();
    assert_eq!(device.object(0x1017).unwrap().main.data_type, None);
    for (options, format) in [
        (WriteOptions::from(Dialect::Lely), Format::Eds),
        (WriteOptions::from(Dialect::PythonCanopen), Format::Eds),
        (WriteOptions::default(), Format::Xdd),
    ] {
        let written = format::write(&device, format, &options).unwrap();
        let back = read(std::str::from_utf8(&written.bytes).unwrap(), format).into_device();
        let access = |index: u16| back.object(index).unwrap().main.access.unwrap();
        let found = [0x1000, 0x1017, 0x2000, 0x2001].map(access);
        assert_eq!(found, [Access::Ro, Access::Rw, Access::Wo, Access::Ro], "{format:?}");
        let invented = paths(&written, LossKind::Invented);
        assert!(
            invented.contains(&"/objects/0x1017/access")
                && invented.contains(&"/objects/0x1018/subs/0x01/access")
        );
        if format == Format::Eds {
            assert_eq!(back.object(0x1017).unwrap().main.data_type, Some(DataType::UNSIGNED16));
            assert!(invented.contains(&"/objects/0x1017/data_type"));
        }
    }
}

/// A list may name objects that the file does not describe: no conversion takes that for an error to be repaired.
#[test]
fn a_listed_object_without_a_section_stays_listed() {
    let device = base("small.eds", &[("1=0x2000\n", "1=0x2000\n2=0x2001\n3=0x2001\n")]);
    assert_eq!(device.lists.manufacturer.as_deref(), Some(&[0x2000, 0x2001, 0x2001][..]));
    for format in [Format::Eds, Format::Toml] {
        let written =
            format::convert(device.clone(), "a".as_ref(), format, false, &WriteOptions::default()).unwrap();
        let back = read(std::str::from_utf8(&written.bytes).unwrap(), format).into_device();
        assert_eq!((back.lists, written.losses), (device.lists.clone(), Vec::new()), "{format:?}");
    }
    let written =
        format::convert(device, "a".as_ref(), Format::Xdd, false, &WriteOptions::default()).unwrap();
    assert!(paths(&written, LossKind::Lost).contains(&"/lists/manufacturer"), "{:?}", written.losses);
}

/// What the reader passes over cannot be in a new text.
#[test]
fn what_is_not_read_is_listed() {
    let text = "; a comment\n[1000]\nParameterName=Type\nParameterName=Type\nDataType=7\nDataType=5\nno key\n[1000]\nParameterName=Other\n";
    let unread = format::unread(&read(text, Format::Eds));
    let said: Vec<String> = unread.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        [
            "lost: device: line 7: `no key` is not a section, key or comment",
            "lost: device: line 6: `DataType` is defined twice, as `7` and `5`; the first one is read",
            "lost: device: line 8: section `[1000]` is defined twice; the first one is read",
            "left out: device: comments are not part of the device",
        ]
    );
    assert_eq!(unread[3].value.to_string(), "\"; a comment\"");
    let xml = std::fs::read_to_string(support::fixtures().join("bases/lamp.xdd")).unwrap();
    let commented = xml.replace("<ApplicationLayers", "<!-- of the second series --><ApplicationLayers");
    let count = |text: &str| format::unread(&read(text, Format::Xdd)).len();
    assert_eq!(count(&commented), count(&xml) + 1);
}

/// Where a conversion has put other data than it says, or says what is not so; `None` if all is listed.
fn unlisted(device: &Device, format: Format, embed: bool) -> Option<String> {
    let mut options = WriteOptions::default();
    options.embed = embed;
    let name = PathBuf::from("converted");
    let written = match format::convert(device.clone(), &name, format, false, &options) {
        Ok(written) => written,
        Err(error) => return Some(error.to_string()),
    };
    let source =
        SourceFile::from_bytes("converted", written.bytes.clone(), &SourceOptions::default()).unwrap();
    let back = format::read(source, format).into_described();
    // a type of device is not configured
    let kept = match format {
        Format::Eds | Format::Xdd => device.unconfigured(),
        _ => Cow::Borrowed(device),
    };
    // compact storage is only another form of the same entries
    let is_compact = embed || format == Format::Toml;
    let wanted = if is_compact { kept.clone() } else { Cow::Owned(kept.expanded().into_owned()) };
    unlisted_in(&written, LossKind::LeftOut, &differences(device, &kept))
        .or_else(|| unlisted_in(&written, LossKind::Lost, &differences(&wanted, &back)))
}

/// What differences and losses of a kind do not have alike.
fn unlisted_in(written: &Written, kind: LossKind, differences: &[DatumDifference]) -> Option<String> {
    let is_part =
        |path: &str, of: &str| path == of || path.strip_prefix(of).is_some_and(|rest| rest.starts_with('/'));
    let listed = paths(written, kind);
    // the file states its own name
    let is_gone = |found: &&DatumDifference| found.left.is_some() && found.path != "/file_info/file_name";
    let gone: Vec<&DatumDifference> = differences.iter().filter(is_gone).collect();
    let is_same =
        |found: &DatumDifference, loss: &str| is_part(&found.path, loss) || is_part(loss, &found.path);
    let unsaid = gone.iter().find(|found| !listed.iter().any(|loss| is_same(found, loss)));
    let untrue = listed.iter().find(|loss| !gone.iter().any(|found| is_same(found, loss)));
    unsaid
        .map(|found| format!("{} is gone: {:?}", found.path, found.left))
        .or_else(|| untrue.map(|loss| format!("{loss} is said to be gone")))
}

/// Every fixture in every format, with what is embedded and without; with `OBJDICT_CORPUS_DIR` the files below that folder.
#[test]
fn all_that_is_gone_is_listed_and_nothing_else() {
    let mut files = support::skips::sample(support::devices_of_all_folders());
    files.extend(support::skips::sample(support::files("xdd", &["xdd", "xdc"])));
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        let folder = PathBuf::from(folder);
        files.extend(support::skips::sample(support::files_below(&folder, &["eds", "dcf", "xdd", "xdc"])));
    }
    let mut failures = Vec::new();
    for (position, path) in files.iter().enumerate() {
        let Ok(description) = format::open(path, &SourceOptions::default()) else { continue };
        let device = description.into_device();
        let formats = [Format::Eds, Format::Xdd, Format::Toml, Format::Dcf];
        // two of the formats for each
        for format in [formats[position % 4], formats[(position + 1) % 4]] {
            let failure = unlisted(&device, format, position % 3 == 0);
            let named = |text| format!("{} as {format:?}: {text}", path.display());
            failures.extend(failure.map(|text| (device.objects.len(), named(text))));
        }
    }
    failures.sort();
    let shown: Vec<&String> = failures.iter().take(3).map(|(_, text)| text).collect();
    assert!(failures.is_empty(), "{} conversions, the smallest: {shown:#?}", failures.len());
}

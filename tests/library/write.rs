//! The canonical text of a device reads back as the same device.

use objdict::compare::differences;
use objdict::format::{self, Format, LossKind, WriteOptions, Written, XddVersion};
use objdict::model::{
    Compact, DataType, Device, DeviceKind, Entry, ExtraSection, Field, Object, ObjectLists, ObjectType, Value,
};
use objdict::source::{Encoding, SourceFile, SourceOptions};
use objdict_model::literal::RealSpelling;
use proptest::prelude::*;

use crate::support;
use crate::support::devices::{Texts, device};

fn format_of(device: &Device) -> Format {
    match device.kind {
        DeviceKind::Type => Format::Eds,
        DeviceKind::Node => Format::Dcf,
    }
}

fn options(change: impl FnOnce(&mut WriteOptions)) -> WriteOptions {
    let mut options = WriteOptions::default();
    change(&mut options);
    options
}

fn write(device: &Device, options: &WriteOptions) -> Written {
    format::write(device, format_of(device), options).unwrap()
}

fn read(bytes: &[u8], format: Format) -> Device {
    let source = SourceFile::from_bytes("written", bytes.to_vec(), &SourceOptions::default()).unwrap();
    format::read(source, format).into_device()
}

fn open(path: &std::path::Path) -> Device {
    format::open(path, &SourceOptions::default()).unwrap().into_device()
}

/// The device with a name for each compactly stored entry.
fn with_all_names(device: &Device) -> Device {
    let mut device = device.clone();
    for object in device.objects.values_mut() {
        let names: Vec<(u8, Box<str>)> = object
            .entries()
            .map(|(sub, entry)| (sub, entry.name.clone()))
            .filter(|(sub, _)| *sub != 0)
            .collect();
        let explicit: Vec<u8> = object.subs.iter().map(|(sub, _)| sub).collect();
        let own = object.main.name.clone();
        if let Some(compact) = &mut object.compact {
            let named =
                |sub: u8| compact.names.iter().find(|(named, _)| *named == sub).map(|(_, name)| name.clone());
            let all = names.into_iter().filter(|(sub, _)| *sub <= compact.count).map(|(sub, name)| {
                let hidden = explicit.contains(&sub).then(|| format!("{own}{sub}").into());
                (sub, named(sub).or(hidden).unwrap_or(name))
            });
            compact.names = all.collect();
        }
    }
    device
}

/// The device as any text of it is read: what is unknown has no order of its own.
fn sorted(mut device: Device) -> Device {
    // `[]` without keys says nothing
    device.extra.retain(|section| !section.name().is_empty() || section.entries().next().is_some());
    device.extra.sort_by(|a, b| a.name().cmp(b.name()));
    device
}

/// The device with what the writer adds where it is missing and must be there: counts, and lists where there is none.
fn counted(mut device: Device, written: &Device) -> Device {
    for object in device.objects.values_mut() {
        let is_stated =
            object.sub_number.is_some() || object.main.invalid_values.get(&Field::SubNumber).is_some();
        if object.object_type().has_subs() && !is_stated {
            object.sub_number = object.subs.len().try_into().ok();
        }
    }
    if let Some(modules) = device.modules.as_mut().filter(|modules| modules.invalid_values.is_empty()) {
        modules.declared = modules.declared.or(modules.supported.len().try_into().ok());
    }
    if device.lists == ObjectLists::default() {
        device.lists = written.lists.clone();
    }
    device
}

/// Says only where two devices differ.
fn assert_same(read: &Device, expected: &Device, what: &dyn std::fmt::Display) {
    let (read, expected) = (sorted(read.clone()), sorted(expected.clone()));
    if read != expected {
        let (read, expected) = (format!("{read:#?}"), format!("{expected:#?}"));
        let mut lines = read.lines().zip(expected.lines()).enumerate();
        let first = lines.find(|(_, (read, expected))| read != expected).map_or(0, |(number, _)| number);
        let around =
            |text: &str| text.lines().skip(first.saturating_sub(12)).take(16).collect::<Vec<_>>().join("\n");
        panic!("{what}\nread:\n{}\nexpected:\n{}", around(&read), around(&expected));
    }
}

fn assert_reads_back(device: &Device, options: &WriteOptions, what: &dyn std::fmt::Display) {
    let written = write(device, options);
    let again = read(&written.bytes, format_of(device));
    let expected = if options.eds.compact { with_all_names(device) } else { device.expanded().into_owned() };
    assert_eq!(written.losses, [], "{what}");
    assert_same(&again, &expected, what);
}

fn every_style() -> Vec<WriteOptions> {
    let mut styles = Vec::new();
    for bits in 0..8 {
        styles.push(options(|options| {
            options.eds.compact = bits & 1 != 0;
            options.eds.quote_strings = bits & 2 != 0;
            options.eds.real = if bits & 4 != 0 { RealSpelling::Hex } else { RealSpelling::Decimal };
        }));
    }
    styles
}

#[test]
fn every_good_device_reads_back_equal_in_every_style() {
    for path in support::good_devices() {
        for options in every_style() {
            assert_reads_back(&open(&path), &options, &path.display());
        }
    }
}

#[test]
fn every_good_device_is_written_without_a_finding() {
    for path in support::good_devices() {
        let device = open(&path);
        let name = path.file_name().unwrap().to_str().unwrap();
        for compact in [false, true] {
            let written = write(&device, &options(|options| options.eds.compact = compact));
            let source = SourceFile::from_bytes(name, written.bytes, &SourceOptions::default()).unwrap();
            let findings = objdict::check(&format::read(source, format_of(&device)));
            let findings: Vec<_> = findings
                .iter()
                // the names of one fixture are hostile on purpose
                .filter(|finding| name != "hostile.eds" || !finding.rule.id.starts_with("naming/"))
                .map(|finding| (finding.rule.id, &finding.message))
                .collect();
            assert_eq!(findings, [], "{name}");
        }
    }
}

#[test]
fn every_damaged_device_reads_back_equal() {
    let utf8 = options(|options| options.eds.encoding = Some(Encoding::Utf8));
    for path in support::devices_of_all_folders() {
        let device = open(&path);
        let written = write(&device, &utf8);
        // a control character cannot be read back
        if written.losses.is_empty() {
            let read = read(&written.bytes, format_of(&device));
            assert_same(&read, &counted(device.expanded().into_owned(), &read), &path.display());
        }
    }
}

#[test]
fn what_is_carried_comes_back() {
    let embedding = options(|options| options.embed = true);
    for path in support::devices_of_all_folders() {
        let device = open(&path);
        let written = write(&device, &embedding);
        assert_eq!(differences(&device, &read(&written.bytes, format_of(&device))), [], "{}", path.display());
        assert!(written.losses.iter().all(|loss| loss.kind == LossKind::Embedded), "{}", path.display());
    }
}

#[test]
fn what_was_edited_since_is_not_undone() {
    let embedding = options(|options| options.embed = true);
    let mut device = open(&support::fixtures().join("eds/compact.eds"));
    let object = device.objects.values().find(|object| object.compact.is_some()).unwrap();
    let (name, count) = (object.main.name.clone(), object.compact.as_ref().unwrap().count);
    device.comments = Some(vec!["Übertemperatur".to_owned()]);
    let text = String::from_utf8(write(&device, &embedding).bytes).unwrap();
    let line = format!("ParameterName={name}{count}\r\n");
    assert_eq!(text.matches(&line).count(), 1);
    let edited = text.replace(&line, "ParameterName=Edited\r\n");
    let description = format::read(SourceFile::from_text("edited.eds", edited), Format::Eds);
    let names = description.device().objects.values().flat_map(Object::entries);
    assert!(names.into_iter().any(|(_, entry)| &*entry.name == "Edited"));
    assert_eq!(description.device().comments, device.comments);
    let stale = |finding: &&objdict::diagnostic::Diagnostic| finding.rule.id == "objdict/stale-embedded-data";
    assert_eq!(description.findings().iter().filter(stale).count(), 1);
}

#[test]
fn embedded_lines_are_comments_that_edits_keep() {
    let embedding = options(|options| options.embed = true);
    for path in support::files("xdd", &["xdd", "xdc"]) {
        let device = open(&path);
        let text = String::from_utf8(format::write(&device, Format::Dcf, &embedding).unwrap().bytes).unwrap();
        let is_ours = |line: &&str| line.starts_with("; objdict-embed: /");
        assert!(text.lines().all(|line| line.len() < 255), "{}", path.display());
        assert!(!text.contains("[xml:") && !text.contains("[ObjdictCarried]"), "{}", path.display());
        let description = format::read(SourceFile::from_text("a.dcf", text.as_str()), Format::Dcf);
        let arranged = String::from_utf8(description.arranged().unwrap()).unwrap();
        let edited = String::from_utf8(description.to_type("a.eds").unwrap()).unwrap();
        for edited in [arranged, edited] {
            assert!(edited.lines().filter(is_ours).eq(text.lines().filter(is_ours)), "{}", path.display());
        }
        // as earlier versions wrote them
        let (body, lines) = text.split_at(text.find("; objdict-embed: ").unwrap_or(text.len()));
        let old = format!("{body}[ObjdictCarried]\r\n{}", lines.replace("; objdict-embed: ", ""));
        let before = description.into_device();
        assert_same(&read(old.as_bytes(), Format::Dcf), &before, &path.display());
    }
}

#[test]
fn a_node_becomes_a_type_without_its_values() {
    let device = open(&support::fixtures().join("dcf/io-401-node5.dcf"));
    let again =
        read(&format::write(&device, Format::Eds, &WriteOptions::default()).unwrap().bytes, Format::Eds);
    assert_eq!(again.kind, DeviceKind::Type);
    assert_eq!(again.commissioning, None);
    assert_eq!(again.file_info.unwrap().last_eds, None);
    let configured = |device: &Device| {
        let entries =
            device.objects.values().flat_map(|object| object.entries().map(|(_, entry)| entry.into_owned()));
        entries.filter(|entry| entry.configured.is_some()).count()
    };
    assert!(configured(&device) > 0);
    assert_eq!(
        configured(&read(
            &format::write(&device, Format::Eds, &WriteOptions::default()).unwrap().bytes,
            Format::Eds
        )),
        0
    );
}

/// A device that uses every part of the writer.
fn small_device() -> Device {
    let text = include_str!("../support/small.dcf");
    let source = SourceFile::from_text("small.dcf", text);
    format::read(source, Format::Dcf).into_device()
}

#[test]
fn the_canonical_style() {
    let text = |options: &WriteOptions| {
        let written = write(&small_device(), options);
        assert_eq!(written.losses, []);
        String::from_utf8(written.bytes).unwrap()
    };
    // a key of python-canopen
    let canonical = text(&options(|options| options.eds.meanings = true));
    assert!(
        canonical.lines().count() * 2 == canonical.matches(['\r', '\n']).count(),
        "every line ends with CR LF"
    );
    insta::assert_snapshot!(canonical.replace('\r', ""));
    let dense = options(|options| {
        options.eds.meanings = true;
        options.eds.compact = true;
        options.eds.quote_strings = true;
        options.eds.real = RealSpelling::Hex;
    });
    insta::assert_snapshot!(text(&dense).replace('\r', ""));
}

#[test]
fn a_device_without_lists_and_counts_gets_them() {
    let mut device = Device::default();
    for index in [0x60, 0x1000, 0x1018, 0x1A00, 0x2000, 0x6000] {
        device.objects.insert(index, Object::default());
    }
    let record = device.objects.get_mut(&0x1018).unwrap();
    record.main.object_type = Some(ObjectType::Record);
    record.subs.insert(0, Entry::default());
    record.subs.insert(0xFF, Entry::default());
    let again = read(&write(&device, &WriteOptions::default()).bytes, Format::Eds);
    assert_eq!(again.lists.mandatory, Some(vec![0x1000, 0x1018]));
    assert_eq!(again.lists.optional, Some(vec![0x1A00, 0x6000]));
    assert_eq!(again.lists.manufacturer, Some(vec![0x2000]));
    assert_eq!(again.object(0x1018).unwrap().sub_number, Some(1));
    assert!(again.object(0x60).is_some());
}

#[test]
fn letters_missing_in_the_encoding_are_transliterated() {
    let mut device = Device::default();
    let main = Entry { name: "Übertemperatur in °C, 水".into(), ..Entry::default() };
    device.objects.insert(0x2000, Object { main, ..Object::default() });
    let name = |options: &WriteOptions| {
        let written = write(&device, options);
        let losses: Vec<String> = written.losses.iter().map(ToString::to_string).collect();
        (read(&written.bytes, Format::Eds).object(0x2000).unwrap().main.name.to_string(), losses)
    };
    let loss = |written: &str| {
        format!("lost: 0x2000 / ParameterName: `\"Übertemperatur in °C, 水\"` becomes `\"{written}\"`")
    };
    let ascii = "Uebertemperatur in degC, ?";
    assert_eq!(name(&WriteOptions::default()), (ascii.to_owned(), vec![loss(ascii)]));
    let latin = "Übertemperatur in °C, ?";
    let windows = options(|options| options.eds.encoding = Some(Encoding::Windows1252));
    assert_eq!(name(&windows), (latin.to_owned(), vec![loss(latin)]));
    for encoding in [Encoding::Utf8, Encoding::Utf16Le] {
        let (written, losses) = name(&options(|options| options.eds.encoding = Some(encoding)));
        assert_eq!((written.as_str(), losses.len()), ("Übertemperatur in °C, 水", 0));
    }
}

#[test]
fn no_text_leaves_its_line() {
    let mut device = Device::default();
    let evil = "x\r\n[2001]\r\nParameterName=evil";
    let main = Entry {
        name: evil.into(),
        data_type: Some(DataType::VISIBLE_STRING),
        default: Some(Value::Text(evil.into())),
        ..Entry::default()
    };
    device.objects.insert(0x2000, Object { main, ..Object::default() });
    device.comments = Some(vec![evil.to_owned()]);
    let mut entries = objdict::model::Extra::default();
    entries.push("[2002]\rx", evil);
    device.extra.push(ExtraSection::new("A]\n[2003", &entries));
    let written = write(&device, &WriteOptions::default());
    let again = read(&written.bytes, Format::Eds);
    assert_eq!(again.objects.keys().copied().collect::<Vec<_>>(), [0x2000]);
    assert_eq!(again.extra.len(), 1);
    let lost: Vec<String> = written.losses.iter().map(|loss| loss.place.to_string()).collect();
    assert_eq!(
        lost,
        [
            "Comments / 0",
            "device / extra/0/entries/0/0",
            "device / extra/0/entries/0/1",
            "device / extra/0/name",
            "0x2000 / DefaultValue",
            "0x2000 / ParameterName"
        ]
    );
}

#[test]
fn a_compact_object_in_every_style() {
    let main = Entry {
        name: "Channel".into(),
        object_type: Some(ObjectType::Array),
        data_type: Some(DataType::REAL32),
        default: Some(Value::Real32(f32::NAN)),
        ..Entry::default()
    };
    let compact = Compact { count: 3, names: vec![(2, "Own".into())], ..Compact::default() };
    let mut device = Device::default();
    device.objects.insert(0x2000, Object { main, compact: Some(Box::new(compact)), ..Object::default() });
    device.lists.manufacturer = Some(vec![0x2000]);
    for options in every_style() {
        assert_reads_back(&device, &options, &"compact");
    }
}

#[test]
fn a_blank_value_is_no_value() {
    let main = Entry { low_limit: Some(Value::Raw(" ".into())), ..Entry::default() };
    let mut device = Device::default();
    device.objects.insert(0x2000, Object { main, ..Object::default() });
    let written = write(&device, &WriteOptions::default());
    assert!(!String::from_utf8_lossy(&written.bytes).contains("LowLimit"));
    assert_eq!(written.losses.len(), 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn every_device_reads_back_equal(device in device(Texts::Ascii), style in 0usize..8) {
        assert_reads_back(&device, &every_style()[style], &"arbitrary");
    }

    /// Whatever a device is, its differences from what is read of its text bring it back, in lines and in elements.
    #[test]
    fn every_device_is_carried(device in device(Texts::Any), style in 0usize..8, xml in any::<bool>(), old in any::<bool>()) {
        let mut options = every_style()[style].clone();
        options.embed = true;
        options.xdd_version = if old { XddVersion::V1_0 } else { XddVersion::V1_1 };
        let format = match (format_of(&device), xml) {
            (Format::Eds, true) => Format::Xdd,
            (_, true) => Format::Xdc,
            (format, false) => format,
        };
        let written = format::write(&device, format, &options).unwrap();
        let is_lost = |kind| matches!(kind, LossKind::Lost | LossKind::LeftOut);
        let lost: Vec<_> = written.losses.iter().filter(|loss| is_lost(loss.kind)).collect();
        prop_assert!(lost.is_empty(), "{lost:?}");
        prop_assert_eq!(differences(&device, &read(&written.bytes, format)), []);
    }

    /// With any texts, the written file has the same parts, and is the same when it is written again.
    #[test]
    fn every_text_stays_in_its_place(device in device(Texts::Any), style in 0usize..8, utf8 in any::<bool>()) {
        let options = WriteOptions::clone(&every_style()[style]);
        let options = self::options(|own| {
            *own = options;
            own.eds.encoding = utf8.then_some(Encoding::Utf8);
        });
        let written = write(&device, &options);
        let again = read(&written.bytes, format_of(&device));
        let parts = |device: &Device| -> Vec<(u16, Vec<u8>)> {
            let subs = |object: &Object| object.entries().map(|(sub, _)| sub).collect();
            device.objects.iter().map(|(&index, object)| (index, subs(object))).collect()
        };
        prop_assert_eq!(parts(&again), parts(&device));
        prop_assert_eq!(again.extra.len(), device.extra.len());
        let twice = write(&again, &options);
        prop_assert_eq!(String::from_utf8_lossy(&twice.bytes), String::from_utf8_lossy(&written.bytes));
    }
}

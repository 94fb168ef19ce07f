//! What CiA 311 says of a device and an EDS has no key for: read from an XDD and kept by every format that can.

use std::collections::BTreeSet;

use objdict::compare::differences;
use objdict::format::{self, Format, LossKind, WriteOptions, XddVersion, json};
use objdict::model::{DataTypeRef, Device, PdoMapping, SrdoAccess, Value};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

/// A press with everything that the device profile can say.
fn press() -> Device {
    let path = support::fixtures().join("xdd/press-402.xdd");
    format::open(&path, &SourceOptions::default()).unwrap().into_described()
}

/// The fields of the model that only XDD fills, and the press says nothing in: they are of modules, of nodes, of the other
/// relatives of ISO 15745, or of a network profile that differs.
const OF_OTHERS: &[&str] = &[
    "actual_value",
    "address",
    "address_max",
    "address_min",
    "child_id",
    "denotation",
    "max_count",
    "network_file",
    "network_identity",
    "own",
    "own_interface",
    "position",
];

/// All names of fields in a JSON value.
fn fields(value: &serde_json::Value, found: &mut BTreeSet<String>) {
    match value {
        serde_json::Value::Object(members) => {
            for (name, value) in members {
                found.insert(name.clone());
                fields(value, found);
            }
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| fields(item, found)),
        _ => {}
    }
}

#[test]
fn everything_has_a_place() {
    let device = press();
    assert_eq!(device.extra, []);
    assert_eq!(device.network_identity, None);
    for (index, object) in &device.objects {
        for entry in [&object.main].into_iter().chain(object.subs.iter().map(|(_, entry)| entry)) {
            assert!(entry.extra.is_empty() && entry.invalid_values.is_empty(), "{index:X}: {entry:?}");
        }
    }
    let names = device.application.iter().flat_map(|process| &process.parameters);
    let names: Vec<_> = names.map(|parameter| &*parameter.unique_id).collect();
    assert_eq!(names, ["UID_PARAM_Cycles"], "the others belong to their entries");
}

#[test]
fn the_press_says_what_can_be_said() {
    let mut said = BTreeSet::new();
    fields(&serde_json::to_value(press()).unwrap(), &mut said);
    let of_model = ["parameter", "application_process", "device_profile", "stack"].map(|file| {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("crates/objdict-model/src/model");
        let path = folder.join(format!("{file}.rs"));
        std::fs::read_to_string(path).unwrap()
    });
    let declared = of_model.iter().flat_map(|text| text.lines()).filter_map(|line| {
        let field = line.trim().strip_prefix("pub ").filter(|_| line.starts_with("        pub "))?;
        field.split_once(": ").map(|(name, _)| name)
    });
    let silent: Vec<_> = declared.filter(|name| !said.contains(*name) && !OF_OTHERS.contains(name)).collect();
    // the identity of the network profile is that of the device profile
    assert_eq!(silent, ["vendor_id", "product_id"]);
}

#[test]
fn parameters_speak_of_their_entries() {
    let device = press();
    let force = device.entry(0x2000, 0).unwrap();
    assert_eq!(force.name.as_ref(), "Press force");
    let parameter = force.parameter.as_ref().unwrap();
    assert_eq!(parameter.labels.name_in("de"), Some("Presskraft"));
    assert_eq!(parameter.unit.as_ref().unwrap().labels.name_in("en"), Some("N"));
    assert_eq!(parameter.properties.len(), 1);
    let stack = force.stack.as_ref().unwrap();
    assert_eq!((stack.detects_change, stack.srdo_access), (Some(true), Some(SrdoAccess::Tx)));
    assert_eq!(device.entry(0x6064, 0).unwrap().pdo_mapping, Some(PdoMapping::Tpdo));

    // the limits of the entry are those of its range, or the outer ones of several
    let depth = device.entry(0x2010, 1).unwrap();
    assert_eq!(
        (&depth.low_limit, &depth.high_limit),
        (&Some(Value::Signed(-120_000)), &Some(Value::Signed(0)))
    );
    let dwell = device.entry(0x2010, 4).unwrap();
    assert_eq!(
        (&dwell.low_limit, &dwell.high_limit),
        (&Some(Value::Unsigned(0)), &Some(Value::Unsigned(60_000)))
    );
    assert_eq!(dwell.parameter.as_ref().unwrap().allowed_values.as_ref().unwrap().ranges.len(), 2);

    let mode = device.entry(0x2001, 0).unwrap();
    let type_id = mode.parameter.as_ref().unwrap().data_type.clone();
    assert_eq!(type_id, Some(DataTypeRef::Defined("UID_ENUM_PressMode".into())));
}

#[test]
fn it_survives_every_format() {
    let device = press();
    assert_eq!(json::read_device(&json::write_device(&device)).as_ref(), Ok(&device));
    for (format, version) in
        [(Format::Xdd, XddVersion::V1_1), (Format::Xdd, XddVersion::V1_0), (Format::Eds, XddVersion::V1_1)]
    {
        let mut options = WriteOptions::default();
        options.xdd_version = version;
        options.embed = true;
        let written = format::write(&device, format, &options).unwrap();
        assert!(written.losses.iter().all(|loss| loss.kind == LossKind::Embedded), "{:?}", written.losses);
        let places: Vec<_> = written.losses.iter().map(|loss| loss.path.as_str()).collect();
        match (format, version) {
            (Format::Xdd, XddVersion::V1_1) => {
                assert_eq!(places, [""; 0], "an XDD has a place for everything");
            }
            (Format::Xdd, _) => insta::assert_snapshot!("lost_in_1_0", places.join("\n")),
            _ => assert!(places.len() > 40, "an EDS has not: {places:?}"),
        }
        let source = SourceFile::from_bytes("written", written.bytes, &SourceOptions::default()).unwrap();
        let read = format::read(source, format).into_described();
        assert_eq!(differences(&device, &read), [], "{format:?} {version:?}");
    }
}

/// Older versions of CANopenEditor said in attributes what the newer ones say in properties. This file has no device profile.
#[test]
fn attributes_of_canopen_editor_are_stack_options() {
    let text = r#"<ISO15745ProfileContainer xmlns="http://www.canopen.org/xml/1.0" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"><ISO15745Profile>
        <ProfileBody xsi:type="ProfileBody_CommunicationNetwork_CANopen"><ApplicationLayers><CANopenObjectList>
            <CANopenObject index="2000" name="A" objectType="7" dataType="0005" accessType="ro"
                edseditor_extenstion_storagelocation="ROM" edseditor_extension_notifyonchange="true" other="1" />
            <CANopenObject index="2001" name="B" objectType="7" edseditor_extension_notifyonchange="maybe" />
        </CANopenObjectList></ApplicationLayers></ProfileBody></ISO15745Profile></ISO15745ProfileContainer>"#;
    let read = |text: &str| format::read(SourceFile::from_text("old.xdd", text), Format::Xdd).into_device();
    let device = read(text);
    let stack = device.objects[&0x2000].main.stack.as_ref().unwrap();
    assert_eq!((stack.storage_group.as_deref(), stack.detects_change), (Some("ROM"), Some(true)));
    assert_eq!(device.objects[&0x2000].main.extra.iter().collect::<Vec<_>>(), [("other", "1")]);
    let odd = &device.objects[&0x2001].main;
    assert_eq!(odd.stack, None);
    assert_eq!(odd.extra.get("edseditor_extension_notifyonchange"), Some("maybe"));

    let mut options = WriteOptions::default();
    options.embed = true;
    let written = String::from_utf8(format::write(&device, Format::Xdd, &options).unwrap().bytes).unwrap();
    assert!(written.contains(r#"<q1:property name="CO_storageGroup" value="ROM" />"#), "{written}");
    assert_eq!(read(&written).objects, device.objects);
}

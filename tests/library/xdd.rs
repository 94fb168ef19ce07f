//! XDD and XDC: what is written reads back, places are found, edits leave the rest of the text alone.

use std::path::{Path, PathBuf};

use objdict::compare::differences;
use objdict::format::{self, Description, Format, WriteOptions, XddVersion};
use objdict::model::{
    Access, Commissioning, DataType, Device, DeviceKind, Entry, ExtraSection, Field, Object, ObjectType,
    Part, PdoMapping, Place, Reason, Value,
};
use objdict::source::{SourceFile, SourceOptions};
use proptest::prelude::*;

use crate::support;
use crate::support::devices::{Texts, device};

fn open(path: &Path) -> Description {
    format::open(path, &SourceOptions::default()).unwrap()
}

fn fixture(name: &str) -> Description {
    open(&support::fixtures().join(name))
}

fn format_of(device: &Device) -> Format {
    match device.kind {
        DeviceKind::Type => Format::Xdd,
        DeviceKind::Node => Format::Xdc,
    }
}

pub(crate) fn read(text: &str, format: Format) -> Description {
    format::read(SourceFile::from_text("written", text), format)
}

pub(crate) fn write(device: &Device, version: XddVersion) -> String {
    let mut options = WriteOptions::default();
    options.xdd_version = version;
    String::from_utf8(format::write(device, format_of(device), &options).unwrap().bytes).unwrap()
}

/// The paths where two devices differ.
fn paths(left: &Device, right: &Device) -> Vec<String> {
    differences(left, right).into_iter().map(|difference| difference.path).collect()
}

fn xml_files() -> Vec<PathBuf> {
    [support::files("xdd", &["xdd"]), support::files("xdc", &["xdc"]), support::files("nxdd", &["nxdd"])]
        .concat()
}

/// CiA 311 knows no default of a DOMAIN.
fn without_defaults_of_domains(device: &Device) -> Device {
    let mut device = device.clone();
    for object in device.objects.values_mut() {
        let entries = object.subs.iter_mut().map(|(_, entry)| entry).chain([&mut object.main]);
        for entry in entries.filter(|entry| entry.implied_type() == Some(DataType::DOMAIN)) {
            entry.default = None;
            entry.invalid_values.retain(|invalid| invalid.field != Field::DefaultValue);
        }
    }
    device
}

#[test]
fn what_was_read_is_written_and_read_again() {
    for path in xml_files() {
        let first = open(&path);
        for version in XddVersion::ALL {
            let text = write(first.described(), version);
            let again = read(&text, first.format());
            assert!(again.tree().unwrap().is_complete(), "{}", path.display());
            // 1.0 has no place for what 1.1 added
            let added = ["/module_objects", "/manager/", "/application/"];
            let lost = paths(&without_defaults_of_domains(first.described()), again.described());
            let lost = lost.iter().filter(|path| {
                version == XddVersion::V1_1 || !added.iter().any(|added| path.starts_with(added))
            });
            assert_eq!(lost.collect::<Vec<_>>(), Vec::<&String>::new(), "{} {version:?}", path.display());
            assert_eq!(write(again.described(), version), text, "{}", path.display());
        }
    }
}

/// What CiA 311 has no place for, as the beginnings and ends of paths.
const NO_PLACE: [&str; 9] = [
    "/comments",
    "/modules",
    "/tools",
    "/device_info/revision_number",
    "/device_info/compact_pdo",
    "/file_info/eds_version",
    "/file_info/last_eds",
    "/commissioning/lss_serial_number",
    "/dummy_usage/types/",
];

const NO_FIELD: [&str; 6] = [
    "/links",
    "/upload_file",
    "/download_file",
    "/reference_designator",
    "_reference_designator",
    "/configured",
];

#[test]
fn an_eds_loses_nothing_that_cia_311_has_a_place_for() {
    for path in support::good_devices() {
        let device = without_defaults_of_domains(&open(&path).into_device().expanded());
        let again = read(&write(&device, XddVersion::V1_1), format_of(&device));
        for path_of in paths(&device, again.device()) {
            let is_known = NO_PLACE.iter().any(|start| path_of.starts_with(start))
                || NO_FIELD.iter().any(|end| path_of.ends_with(end));
            assert!(is_known, "{}: {path_of}", path.display());
        }
    }
}

#[test]
fn objects_of_every_data_type_keep_their_types_and_values() {
    let eds = fixture("eds/all-types.eds");
    let xdd = fixture("xdd/all-types.xdd");
    for (index, object) in &eds.device().objects {
        assert_eq!(xdd.device().object(*index), Some(object), "{index:04X}h");
    }
    let types: Vec<DataType> =
        xdd.device().objects.values().filter_map(|object| object.main.data_type).collect();
    for data_type in DataType::STATIC {
        assert!(types.contains(data_type), "{data_type}");
    }
}

#[test]
fn every_description_of_a_project_is_read() {
    let first = fixture("nxdd/line.nxdd");
    let names: Vec<_> = (0..first.device_count())
        .map(|number| fixture("nxdd/line.nxdd").select(number).unwrap())
        .map(|description| description.into_device().file_info.unwrap().file_name.unwrap())
        .collect();
    assert_eq!(names, ["minimal.xdd", "encoder-406.xdd"]);
}

#[test]
fn parameters_give_what_the_object_list_does_not_say() {
    let description = fixture("xdd/io-401.xdd");
    let device = description.device();
    let outputs = device.entry(0x6200, 1).unwrap();
    assert_eq!((outputs.data_type, outputs.access), (Some(DataType::UNSIGNED8), Some(Access::Rww)));
    let cob_id = device.entry(0x1400, 1).unwrap();
    assert_eq!(cob_id.default, Some(Value::NodeId(0x200)));
    let stack = cob_id.stack.as_ref().or(device.objects[&0x1400].main.stack.as_ref()).unwrap();
    assert_eq!(stack.count_label.as_deref(), Some("RPDO"));
    // what the entry says is not said again
    assert_eq!(outputs.parameter, None);
    assert!(device.application.is_empty(), "{:?}", device.application);
    // a text for readers stays
    let labels = &device.objects[&0x6000].main.parameter.as_ref().unwrap().labels;
    assert_eq!(labels.description_in("en"), Some("One byte for eight inputs; channel 0 is bit 0."));
}

#[test]
fn names_in_several_languages_scaling_and_groups_stay_in_the_model() {
    let device = fixture("xdd/drive-402.xdd").into_device();
    let position = device.objects[&0x6064].main.parameter.as_ref().unwrap();
    assert_eq!(position.labels.name_in("de"), Some("Istposition"));
    assert_eq!(position.unit.as_ref().unwrap().labels.name_in("de"), Some("µm"));
    let temperature = device.objects[&0x2011].main.parameter.as_ref().unwrap();
    assert_eq!(temperature.multiplier.as_deref(), Some("0.1"));
    assert_eq!(&*temperature.conditional_support[0], "UID_PARAM_BRAKE");
    let modes = device.objects[&0x6060].main.parameter.as_ref().unwrap();
    let modes = &modes.allowed_values.as_ref().unwrap().values;
    assert_eq!(modes[2].labels.name_in("de"), Some("Drehzahlbetrieb"));
    assert_eq!(&*device.application[0].groups[0].groups[0].parameters[0], "UID_PARAM_POSITION");
    let position = &device.objects[&0x6064].main;
    assert_eq!((position.access, position.data_type), (Some(Access::Ro), Some(DataType::INTEGER32)));
}

pub(crate) fn only_entry(device: &Device, index: u16) -> &Entry {
    &device.object(index).unwrap_or_else(|| panic!("{index:04X}h")).main
}

#[test]
fn odd_spellings_are_understood_or_kept() {
    let description = fixture("broken/odd-spellings.xdd");
    let device = description.device();
    let prefixed = only_entry(device, 0x2000);
    assert_eq!(prefixed.object_type, Some(ObjectType::Var));
    assert_eq!((prefixed.data_type, prefixed.access), (Some(DataType::UNSIGNED8), Some(Access::Rw)));
    assert_eq!(
        (prefixed.pdo_mapping, &prefixed.default),
        (Some(PdoMapping::Optional), &Some(Value::Unsigned(16)))
    );
    let lower = only_entry(device, 0x20A1);
    assert_eq!((lower.object_type, lower.access), (Some(ObjectType::Var), Some(Access::Rwr)));
    let tenth = device.entry(0x20A2, 10).unwrap();
    assert_eq!((tenth.flags.unwrap().0, &tenth.default), (1, &Some(Value::Unsigned(7))));
    let fields: Vec<(Field, Reason)> = only_entry(device, 0x20A3)
        .invalid_values
        .iter()
        .map(|invalid| (invalid.field.clone(), invalid.reason.clone()))
        .collect();
    let expected = [
        (Field::ObjectType, Reason::UnknownWord),
        (Field::DataType, Reason::NotANumber),
        (Field::AccessType, Reason::UnknownWord),
        (Field::PdoMapping, Reason::UnknownWord),
        (Field::ObjFlags, Reason::NotANumber),
        (Field::SubNumber, Reason::NotANumber),
    ];
    assert_eq!(fields, expected);
    let info = device.device_info.as_ref().unwrap();
    assert_eq!(info.baud_rates.supported().collect::<Vec<_>>(), [125, 250, 1000]);
    assert_eq!(
        (info.granularity, info.simple_boot_up_slave, info.vendor_number),
        (Some(8), Some(true), Some(1017))
    );
    let invalid_values: Vec<&str> = info.invalid_values.iter().map(|invalid| &*invalid.text).collect();
    assert_eq!(invalid_values, ["fast", "33 Kbps", "none", "no"]);
    let dummies = device.dummy_usage.as_ref().unwrap();
    assert_eq!(dummies.types.values().collect::<Vec<_>>(), [&true, &false]);
    assert_eq!(dummies.invalid_values.iter().next().map(|invalid| &*invalid.text), Some("yes"));
    assert_eq!(dummies.extra.get("Dummy8"), Some(""));
    assert_eq!(device.file_info.as_ref().unwrap().creation_date.unwrap().to_iso(), "2024-03-04");
}

#[test]
fn a_node_is_read_however_its_number_is_spelled() {
    let device = fixture("broken/odd-nodeid.xdc").into_device();
    let node = device.commissioning.as_ref().unwrap();
    assert_eq!((node.node_id, node.baud_rate, node.manager), (Some(5), Some(125), Some(false)));
    assert_eq!((node.net_number, node.invalid_values.get(&Field::NetNumber).is_some()), (None, true));
    let configured = only_entry(&device, 0x2000).configured.as_deref().unwrap();
    assert_eq!(
        (&configured.value, configured.denotation.as_deref()),
        (&Some(Value::Unsigned(2)), Some("Left door"))
    );
    // on the sub-object, not on its parent
    let object = &device.objects[&0x2001];
    assert_eq!(object.main.configured, None);
    let member = object.subs.get(1).unwrap();
    assert_eq!(member.configured.as_ref().unwrap().denotation.as_deref(), Some("Right door"));
    assert_eq!(member.invalid_values.get(&Field::ParameterValue).map(|invalid| &*invalid.text), Some("300"));
}

#[test]
fn references_are_followed_as_far_as_they_lead() {
    let device = fixture("broken/references.xdd").into_device();
    let facts = |index| {
        let entry = only_entry(&device, index);
        (entry.data_type, entry.access, entry.default.clone())
    };
    for shared in [0x2000, 0x2001] {
        assert_eq!(facts(shared), (Some(DataType::UNSIGNED8), Some(Access::Rww), Some(Value::Unsigned(3))));
        assert_eq!(only_entry(&device, shared).extra.get("uniqueIDRef"), Some("P_SHARED"));
    }
    assert_eq!(facts(0x2002), (Some(DataType::INTEGER16), Some(Access::Rw), Some(Value::Signed(-5))));
    assert_eq!(facts(0x2003), (None, Some(Access::Rw), Some(Value::Raw("1".into()))));
    assert_eq!(facts(0x2004), (Some(DataType::UNSIGNED32), Some(Access::Rw), Some(Value::Unsigned(77))));
    assert_eq!(facts(0x2005), (Some(DataType::UNSIGNED8), Some(Access::Ro), None));
    assert_eq!(facts(0x2006), (Some(DataType::UNSIGNED16), Some(Access::Ro), None));
    assert_eq!(only_entry(&device, 0x2007).extra.get("uniqueIDRef"), Some("P_MISSING"));
    let left: Vec<&str> =
        device.application[0].parameters.iter().map(|parameter| &*parameter.unique_id).collect();
    assert_eq!(left, ["P_SHARED", "P_TWICE", "P_ALONE"]);
}

#[test]
fn the_first_of_two_counts_and_the_second_is_kept() {
    let device = fixture("broken/duplicates.xdd").into_device();
    assert_eq!(only_entry(&device, 0x2000).data_type, Some(DataType::UNSIGNED8));
    assert_eq!(&*device.entry(0x2001, 1).unwrap().name, "First");
    let names: Vec<&str> = device.extra.iter().map(ExtraSection::name).collect();
    let expected = [
        "xml:ApplicationLayers/CANopenObjectList/CANopenObject[5]",
        "xml:ApplicationLayers/CANopenObjectList/CANopenObject[6]/CANopenSubObject[3]",
        "xml:ApplicationLayers/CANopenObjectList/CANopenObject[7]",
    ];
    for name in expected {
        assert!(names.contains(&name), "{name} of {names:?}");
    }
}

#[test]
fn what_nobody_reads_is_kept() {
    let device = fixture("broken/unknown-parts.xdd").into_device();
    let sections: Vec<(&str, Vec<(&str, &str)>)> =
        device.extra.iter().map(|section| (section.name(), section.entries().collect())).collect();
    let expected = [
        ("xml:DeviceManual", vec![("pages", "200"), ("#text", "Read it")]),
        ("xml:DeviceManual/chapter", vec![("#text", "1")]),
        ("xml:ApplicationLayers/CANopenObjectList/CANopenObject[4]/paint", vec![("#text", "glossy")]),
        ("xml:ApplicationLayers/weather", vec![("today", "fine")]),
    ];
    assert_eq!(sections, expected);
    assert_eq!(only_entry(&device, 0x2000).extra.get("colour"), Some("red"));
}

#[test]
fn damaged_files_give_what_is_whole() {
    let unfinished = fixture("broken/unfinished.xdd");
    assert!(!unfinished.tree().unwrap().is_complete());
    assert!(unfinished.findings().has_errors());
    assert_eq!(only_entry(unfinished.device(), 0x2000).default, Some(Value::Unsigned(9)));
    assert_eq!(&*only_entry(unfinished.device(), 0x2001).name, "The last one");
    let alone = fixture("broken/network-only.xdd").into_device();
    assert_eq!((alone.objects.len(), alone.node_id()), (3, None));
    assert_eq!(alone.file_info.unwrap().file_version, Some(1));
}

#[test]
fn a_description_without_namespaces() {
    let device = fixture("broken/no-namespace.xdd").into_device();
    insta::assert_json_snapshot!("minimal_device", serde_json::to_value(&device).unwrap());
}

/// The text of a place.
pub(crate) fn at(description: &Description, part: Part, field: &str) -> String {
    let place = Place::of(part).field(Field::from_name(field));
    let span = description.locate(&place).unwrap_or_else(|| panic!("{place}"));
    span.of(description.source().text()).to_owned()
}

#[test]
fn places_are_found_at_the_object_and_in_its_parameter() {
    let io = fixture("xdd/io-401.xdd");
    let (object, sub) = (Part::Object(0x1017), Part::Entry(0x1400, 1));
    assert_eq!(at(&io, object.clone(), "ParameterName"), "Producer heartbeat time");
    assert_eq!(at(&io, object.clone(), "DataType"), "<UINT />");
    assert_eq!(at(&io, object.clone(), "AccessType"), "readWrite");
    assert_eq!(at(&io, sub.clone(), "DefaultValue"), "$NODEID+0x200");
    assert_eq!(at(&io, sub.clone(), "ObjectType"), "7");
    assert!(at(&io, sub, "HighLimit").starts_with("<CANopenSubObject subIndex=\"01\""));
    assert!(at(&io, object, "ParameterValue").starts_with("<CANopenObject index=\"1017\""));
    let span = io.locate(&Place::entry(0x1400, 99)).unwrap();
    assert!(span.of(io.source().text()).starts_with("<CANopenObject index=\"1400\""));
    assert_eq!(io.locate(&Place::object(0x7777)), None);
    let drive = fixture("xdd/drive-402.xdd");
    let part = || Part::Object(0x2013);
    let limits = (at(&drive, part(), "LowLimit"), at(&drive, part(), "HighLimit"));
    let entry = only_entry(drive.device(), 0x2013);
    let printed = |value: &Option<Value>| value.as_ref().unwrap().to_string();
    assert_eq!(limits, (printed(&entry.low_limit), printed(&entry.high_limit)));
}

#[test]
fn places_of_the_file_the_device_and_the_node_are_found() {
    let node = fixture("xdc/io-401-node5.xdc");
    let text = |part: &Part, field: &str| at(&node, part.clone(), field);
    assert_eq!(text(&Part::FileInfo, "FileName"), "io-401-node5.xdc");
    assert_eq!(text(&Part::FileInfo, "CreatedBy"), "objdict fixtures");
    let info = node.device().device_info.as_ref().unwrap();
    assert_eq!(text(&Part::DeviceInfo, "ProductName"), info.product_name.clone().unwrap());
    assert_eq!(text(&Part::DeviceInfo, "VendorNumber"), "0x000003F9");
    assert_eq!(text(&Part::DeviceInfo, "BaudRate_250"), "250 Kbps");
    assert_eq!(text(&Part::DeviceInfo, "NrOfRXPDO"), info.rpdo_count.unwrap().to_string());
    assert!(text(&Part::DeviceInfo, "RevisionNumber").starts_with("<q1:DeviceIdentity"));
    assert_eq!(text(&Part::Commissioning, "NodeID"), "5");
    assert!(text(&Part::Commissioning, "LSS_SerialNumber").starts_with("<deviceCommissioning"));
    assert_eq!(text(&Part::DummyUsage, "Dummy0005"), "Dummy0005=1");
    let odd = fixture("broken/odd-nodeid.xdc");
    assert_eq!(at(&odd, Part::Commissioning, "NodeID"), "5");
    let wrong = fixture("broken/odd-spellings.xdd");
    assert_eq!(at(&wrong, Part::DeviceInfo, "supportedBaudRate"), "33 Kbps");
    assert_eq!(at(&wrong, Part::DeviceInfo, "defaultBaudRate"), "fast");
    let unknown = fixture("broken/unknown-parts.xdd");
    assert_eq!(at(&unknown, Part::Section("xml:DeviceManual".into()), "pages"), "200");
    assert_eq!(at(&unknown, Part::Section("xml:DeviceManual/chapter".into()), "#text"), "1");
}

/// The lines that differ between two texts.
fn changed_lines<'a>(before: &'a str, after: &'a str) -> (Vec<&'a str>, Vec<&'a str>) {
    let gone = before.lines().filter(|line| !after.lines().any(|other| other == *line));
    let new = after.lines().filter(|line| !before.lines().any(|other| other == *line));
    (gone.collect(), new.collect())
}

#[test]
fn a_node_is_put_into_the_text_and_taken_out_again() {
    let node = Commissioning {
        node_id: Some(12),
        node_name: Some("door & gate".into()),
        baud_rate: Some(500),
        manager: Some(true),
        ..Commissioning::default()
    };
    for name in ["xdd/io-401.xdd", "xdd/drive-402.xdd", "broken/no-namespace.xdd"] {
        let before = fixture(name);
        let configured = String::from_utf8(before.to_node("gate.xdc", &node).unwrap()).unwrap();
        let (gone, new) = changed_lines(before.source().text(), &configured);
        // the two bodies, and the node
        assert_eq!((gone.len(), new.len()), (2, 3), "{name}: {new:#?}");
        let xdc = read(&configured, Format::Xdc);
        let read_node = xdc.device().commissioning.clone().unwrap();
        assert_eq!(read_node, node, "{name}");
        assert_eq!(xdc.device().file_info.as_ref().unwrap().file_name.as_deref(), Some("gate.xdc"));
        let file_name = before.device().file_info.as_ref().unwrap().file_name.clone().unwrap();
        let back = xdc.to_type(&file_name).unwrap();
        assert_eq!(String::from_utf8(back).unwrap(), before.source().text(), "{name}");
    }
}

#[test]
fn a_node_replaces_the_one_that_was_there() {
    let before = fixture("broken/odd-nodeid.xdc");
    let node = Commissioning { node_id: Some(7), node_name: Some("gate".into()), ..Commissioning::default() };
    let text = String::from_utf8(before.to_node("gate.xdc", &node).unwrap()).unwrap();
    assert!(text.contains("NodeID=\"7\" nodeName=\"gate\"") && !text.contains("nodeID="), "{text}");
    let back = read(&text, Format::Xdc).to_type("gate.xdd").unwrap();
    let back = String::from_utf8(back).unwrap();
    for configured in ["deviceCommissioning", "actualValue", "denotation"] {
        assert!(!back.contains(configured), "{configured}");
    }
    assert_eq!(read(&back, Format::Xdd).device().kind, DeviceKind::Type);
}

#[test]
fn a_place_for_the_node_is_made() {
    let before = fixture("xdd/io-401.xdd");
    let text = before.source().text();
    let start = text.find("      <NetworkManagement>").unwrap();
    let end = text.find("</NetworkManagement>\n").unwrap() + "</NetworkManagement>\n".len();
    let without = format!("{}{}", &text[..start], &text[end..]);
    let node = Commissioning { node_id: Some(12), ..Commissioning::default() };
    let written = read(&without, Format::Xdd).to_node("gate.xdc", &node).unwrap();
    let written = read(&String::from_utf8(written).unwrap(), Format::Xdc);
    assert_eq!(written.device().node_id(), Some(12));
    let findings: Vec<_> =
        written.text_findings().iter().map(|finding| finding.message.to_string()).collect();
    assert_eq!(findings, Vec::<String>::new());
}

#[test]
fn an_xdd_of_a_node_leaves_out_what_was_configured() {
    let device = fixture("xdc/io-401-node5.xdc").into_device();
    let text =
        String::from_utf8(format::write(&device, Format::Xdd, &WriteOptions::default()).unwrap().bytes)
            .unwrap();
    for configured in ["deviceCommissioning", "actualValue", "denotation"] {
        assert!(!text.contains(configured), "{configured}");
    }
}

#[test]
fn ids_are_given_once() {
    let mut device = fixture("xdd/io-401.xdd").into_device();
    let object = device.objects.get_mut(&0x1000).unwrap();
    object.main.parameter_mut().unique_id = "UID_OBJ_1001".into();
    let text = write(&device, XddVersion::V1_1);
    let document = roxmltree::Document::parse(&text).unwrap();
    let mut ids: Vec<&str> = document.descendants().filter_map(|node| node.attribute("uniqueID")).collect();
    let all = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), all);
    let again = read(&text, Format::Xdd);
    assert_eq!(again.device().objects[&0x1001].main.access, device.objects[&0x1001].main.access);
    assert!(ids.contains(&"UID_OBJ_1001_2"));
}

/// A device with an object of each form.
pub(crate) fn with_objects(objects: Vec<(u16, Object)>) -> Device {
    Device { objects: objects.into_iter().collect(), ..Device::default() }
}

#[test]
fn what_is_not_stated_is_not_stated_afterwards() {
    let entry = Entry { name: "Unstated".into(), ..Entry::default() };
    let mut orphan = Object { orphan: true, ..Object::default() };
    orphan.subs.insert(3, entry.clone());
    let device = with_objects(vec![(0x2000, Object { main: entry, ..Object::default() }), (0x2001, orphan)]);
    let again = read(&write(&device, XddVersion::V1_1), Format::Xdd).into_device();
    assert_eq!(again.objects, device.objects);
    assert_eq!((again.file_info, again.functions.len()), (None, 0));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn any_device_is_written_well_formed_and_comes_to_rest(device in device(Texts::Any)) {
        for version in XddVersion::ALL {
            let text = write(&device, version);
            prop_assert!(roxmltree::Document::parse(&text).is_ok(), "{text}");
            let once = read(&text, format_of(&device));
            prop_assert!(once.tree().unwrap().is_complete(), "{text}");
            let once = once.into_device();
            let twice = read(&write(&once, version), format_of(&once)).into_device();
            prop_assert_eq!(paths(&once, &twice), Vec::<String>::new());
        }
    }

    #[test]
    fn objects_of_any_device_come_back(device in device(Texts::Ascii)) {
        let device = without_defaults_of_domains(&device.expanded());
        let again = read(&write(&device, XddVersion::V1_1), format_of(&device)).into_device();
        for (index, object) in &device.objects {
            let back = again.object(*index).unwrap();
            for (sub, entry) in object.described() {
                let read = sub.map_or(&back.main, |sub| back.subs.get(sub).unwrap());
                prop_assert_eq!(&read.default, &entry.default, "{:04X}h {:?}", index, sub);
                let domain = entry.object_type.filter(|object_type| *object_type == ObjectType::Domain);
                prop_assert_eq!(read.data_type, entry.data_type.or(domain.map(|_| DataType::DOMAIN)));
                prop_assert_eq!(&*read.name, entry.name.trim());
                prop_assert_eq!(read.configured_value(), entry.configured_value());
                prop_assert_eq!(&read.low_limit, &entry.low_limit);
            }
        }
    }
}

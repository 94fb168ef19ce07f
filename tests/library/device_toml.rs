//! `device.toml`: every description becomes one and comes back whole; short ones written by hand are what they say; findings
//! point into them, and edits keep the rest.

use std::fs;
use std::path::PathBuf;

use objdict::diagnostic::{Diagnostic, Severity};
use objdict::format::{self, Description, Format, WriteOptions};
use objdict::model::{Device, DeviceKind, Place, Value};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn read(text: &str) -> Description {
    format::read(SourceFile::from_text("device.toml", text), Format::Toml)
}

fn written(device: &Device) -> String {
    let written = format::write(device, Format::Toml, &WriteOptions::default()).unwrap();
    assert_eq!(written.losses, [], "everything has a place");
    String::from_utf8(written.bytes).unwrap()
}

fn fixture(name: &str) -> PathBuf {
    support::fixtures().join("toml").join(name)
}

fn open(name: &str) -> Description {
    format::open(&fixture(name), &SourceOptions::default()).unwrap()
}

/// A sample of all fixtures; every healthy one comes back in `every_healthy_device_comes_back_whole`.
#[test]
fn every_fixture_comes_back_whole() {
    comes_back(&support::skips::sample(support::files("", &["eds", "dcf", "xdd", "xdc", "od"])));
}

#[test]
fn every_healthy_device_comes_back_whole() {
    comes_back(&support::good_devices());
}

fn comes_back(files: &[PathBuf]) {
    for file in files {
        let Ok(description) = format::open(file, &SourceOptions::default()) else { continue };
        let text = written(description.device());
        let again = read(&text);
        assert!(again.device() == description.device(), "{}:\n{text}", file.display());
        // what is as wrong in the file that it comes from
        let is_inherited = |finding: &&Diagnostic| {
            let message = finding.message.to_string();
            finding.severity == Severity::Warning && message.starts_with("`factor` is")
        };
        let own = again.findings().iter().filter(|finding| !is_inherited(finding)).count();
        assert_eq!(own, 0, "{}: {:?}\n{text}", file.display(), again.findings());
    }
}

#[test]
fn the_short_form_is_short() {
    for (name, most) in [("io-401.eds", 100), ("drive-402.eds", 200), ("manager-302.eds", 120)] {
        let path = support::fixtures().join("eds").join(name);
        let description = format::open(&path, &SourceOptions::default()).unwrap();
        let lines = written(description.device()).lines().count();
        assert!(lines < most, "{name} has {lines} lines");
    }
}

#[test]
fn what_is_written_by_hand_has_no_findings_and_becomes_an_eds() {
    for name in ["io.toml", "drive.toml"] {
        let description = open(name);
        let findings = objdict::check(&description);
        let shown: Vec<String> =
            findings.iter().map(|found| format!("{}: {}", found.rule.id, found.message)).collect();
        assert!(shown.is_empty(), "{name}: {shown:#?}");
        let eds = format::write(description.device(), Format::Eds, &WriteOptions::default()).unwrap();
        insta::assert_snapshot!(format!("toml_{name}"), String::from_utf8(eds.bytes).unwrap());
    }
}

#[test]
fn a_pdo_is_what_its_table_says() {
    let description = open("drive.toml");
    let pdos: Vec<_> =
        description.device().pdos().filter(|pdo| pdo.kind == objdict::model::PdoKind::Tpdo).collect();
    let mapped: Vec<Vec<(u16, u8)>> =
        pdos.iter().map(|pdo| pdo.mapped().map(|mapped| (mapped.index, mapped.bits)).collect()).collect();
    assert_eq!(mapped, [vec![(0x6041, 16), (0x6064, 32)], vec![(0x2002, 16), (0x2003, 16)]]);
    assert_eq!((pdos[0].event_timer, pdos[0].inhibit_time), (Some(100), Some(50)));
    assert_eq!(pdos[1].transmission_type, Some(1));
    assert!(pdos.iter().all(|pdo| pdo.is_valid() == Some(true)));
}

/// Inhibit times are multiples of 100 µs; those of whole milliseconds are written as such.
#[test]
fn inhibit_times_keep_their_unit() {
    let path = support::fixtures().join("eds/cs5525-404.eds");
    let mut device = format::open(&path, &SourceOptions::default()).unwrap().device().clone();
    for (tenths, time) in [(50, "5ms"), (15, "1500us"), (1, "100us")] {
        let communication = device.objects.get_mut(&0x1801).unwrap();
        communication.subs.get_mut(3).unwrap().default = Some(Value::Unsigned(tenths));
        let text = written(&device);
        assert!(text.contains(&format!("inhibit = \"{time}\"")), "{time}:\n{text}");
        assert!(read(&text).device() == &device, "{time}:\n{text}");
    }
}

#[test]
fn mistakes_are_found_in_their_places() {
    const HEAD: &str = "format = \"objdict-device/1\"\n";
    for (text, marked, rule) in [
        ("[object.2000]\nname = 'A'\ntype = 'u17'\n", "'u17'", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = 'u8'\ndefault = 300\n", "300", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = 'u8'\nacess = 'ro'\n", "acess", "unknown-key"),
        ("[object.0x2000]\nname = 'A'\n", "0x2000", "unknown-key"),
        ("[object.2000.sub.100]\nname = 'A'\n", "100", "unknown-key"),
        ("[object.2000.sub]\n9 = {}\n10 = {}\n", "10", "out-of-range"),
        ("[object.2000.sub]\n1-2 = { type = 'u8', default = [1] }\n", "[1]", "wrong-type"),
        ("[object]\n1a00 = {}\n1A00 = {}\n", "1A00", "key-defined-twice"),
        ("[object.2000]\nname = 'A'\ntype = 'u16'\ndefault = [1, 2]\n", "[1, 2]", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = '[u16; 4]'\ndefault = [1, 2]\n", "[1, 2]", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = '[u8; 2]'\nmax = [1, 300]\n", "300", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = '[u8; 3]'\nnames = { 9 = 'x' }\n", "9", "out-of-range"),
        ("[object.2000]\nname = 'A'\ntype = '[u8; 3]'\nnames = ['x']\n", "['x']", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = 'u8'\nfactor = 'abc'\n", "'abc'", "wrong-type"),
        ("[object.2000]\nname = 'A'\ntype = 'u8'\nenum = { 255 = 'a', 256 = 'b' }\n", "256", "out-of-range"),
        ("profile = '402'\n", "'402'", "unknown-profile"),
        ("profile = '999@1'\n", "'999@1'", "unknown-profile"),
        ("profile = '401@1'\nremove = ['2000']\n", "'2000'", "wrong-type"),
        ("[tpdo.1]\nmap = ['2000']\n", "'2000'", "wrong-type"),
        ("[tpdo.1]\ntransmission = 'always'\n", "'always'", "wrong-type"),
        ("[raw]\n'/objects/0x2000/color' = 1\n", "'/objects/0x2000/color'", "wrong-type"),
        ("[file]\ncreation-date = 'May'\n", "'May'", "wrong-type"),
    ] {
        let description = read(&format!("{HEAD}{text}"));
        let found: Vec<_> = description
            .findings()
            .iter()
            .map(|found| {
                (description.span_of(&found.labels[0].at).of(description.source().text()), found.rule.name())
            })
            .collect();
        assert_eq!(found, [(marked, rule)], "{text}");
    }
}

#[test]
fn an_array_takes_a_list_of_what_its_elements_have() {
    let text = "format = 'objdict-device/1'\n[object]\n\
                2001 = { name = 'Gains', type = '[u16; 3]', default = [1, 2, 3], min = [0, 1, 1], max = 9, names = ['P', 'I', 'D'] }\n\
                2002 = { name = 'Offsets', type = '[i8; 2]', value = [-1, 2], names = ['X', 'Y'] }\n";
    let description = read(text);
    assert_eq!(description.findings().len(), 0, "{:?}", description.findings());
    let device = description.device();
    let gains = device.object(0x2001).unwrap();
    let entries = gains
        .subs
        .iter()
        .map(|(sub, entry)| (sub, &*entry.name, &entry.default, &entry.low_limit, &entry.high_limit));
    let number = |number| Some(Value::Unsigned(number));
    let rows: Vec<_> = entries
        .skip(1)
        .map(|(sub, name, default, low, high)| {
            (sub, name.to_owned(), default.clone(), low.clone(), high.clone())
        })
        .collect();
    assert_eq!(
        rows,
        [
            (1, "P".to_owned(), number(1), number(0), number(9)),
            (2, "I".to_owned(), number(2), number(1), number(9)),
            (3, "D".to_owned(), number(3), number(1), number(9)),
        ]
    );
    assert_eq!(
        (gains.highest_sub(), &gains.compact, gains.subs.get(0).unwrap().default.clone()),
        (Some(3), &None, number(3))
    );
    let offsets = device.object(0x2002).unwrap().compact.as_ref().unwrap();
    assert_eq!(offsets.values, [(1, Value::Signed(-1)), (2, Value::Signed(2))]);
    assert_eq!(offsets.names, [(1, "X".into()), (2, "Y".into())]);
    assert!(read(&written(device)).device() == device);
}

#[test]
fn places_of_the_model_are_places_in_the_text() {
    let description = open("drive.toml");
    let text = description.source().text();
    use objdict::model::{Field, Part};
    for (place, marked) in [
        (Place::object(0x2001).field(Field::HighLimit), "8400"),
        (Place::entry(0x2010, 2).field(Field::DefaultValue), "20"),
        (Place::of(Part::DeviceInfo).field(Field::VendorNumber), "0x3F9"),
        (Place::object(0x2003).field(Field::DataType), "\"i16\""),
        // of the profile
        (Place::object(0x6041).field(Field::AccessType), "\"402@1\""),
        // of a PDO
        (Place::entry(0x1800, 3), "\"5ms\""),
        (Place::entry(0x1A01, 2).field(Field::DefaultValue), "[\"2002\", \"2003\"]"),
    ] {
        assert_eq!(description.locate(&place).map(|span| span.of(text)), Some(marked), "{place}");
    }
}

#[test]
fn a_node_keeps_the_comments_of_its_type() {
    let description = open("io.toml");
    let node = objdict::model::Commissioning { node_id: Some(7), ..Default::default() };
    let bytes = description.to_node("node.toml", &node).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    assert!(
        text.contains("# beside the PDOs of the profile\n") && text.contains("[node]\nnode-id = 7\n"),
        "{text}"
    );
    let again = read(&text);
    assert_eq!((again.device().kind, again.device().node_id()), (DeviceKind::Node, Some(7)));
    let mut back = read(&String::from_utf8(again.to_type("io.toml").unwrap()).unwrap()).into_device();
    assert_eq!(back.file_info.as_mut().and_then(|info| info.file_name.take()).as_deref(), Some("io.toml"));
    assert_eq!(&back, description.device());
}

#[test]
fn configured_values_are_edits() {
    use objdict::configure::{Setting, configure};
    use objdict::format::NodeSettings;
    for (setting, added) in [
        ("2000=5", "2000 = { name = \"A\", type = \"u16\", value = 5 } # kept"),
        ("2001:1=6", "2001.sub.1 = { name = \"C\", type = \"u8\", value = 6 }"),
        ("1017=250", "1017.value = 250"),
    ] {
        let text = "format = \"objdict-device/1\"\nprofile = \"301@1\"\n\n[object]\n\
            2000 = { name = \"A\", type = \"u16\" } # kept\n2001.name = \"B\"\n\
            2001.sub.1 = { name = \"C\", type = \"u8\" }\n";
        let description = read(text);
        assert_eq!(description.findings().iter().count(), 0, "{:?}", description.findings());
        let wanted = [Setting::value(setting).unwrap()];
        let assignments = configure(description.device(), 5, &wanted).unwrap();
        let node = &objdict::model::Commissioning { node_id: Some(5), ..Default::default() };
        let settings = NodeSettings { node, plugged: None, assignments: &assignments, downloads: &[] };
        let configured = description.configured("node.toml", &settings).unwrap();
        let text = String::from_utf8(configured.bytes).unwrap();
        assert!(configured.is_edited && text.lines().any(|line| line == added), "{setting}: {text}");
        assert_eq!(read(&text).device(), &configured.device, "{setting}: {text}");
    }
}

#[test]
fn order_and_comments_survive_fmt() {
    let text =
        "format = \"objdict-device/1\"   \n\n\n# why\n[device]\n  vendor-name = \"\"\"a  \n\n\n b\"\"\"\n\n";
    let arranged = String::from_utf8(read(text).arranged().unwrap()).unwrap();
    assert_eq!(
        arranged,
        "format = \"objdict-device/1\"\n\n# why\n[device]\n  vendor-name = \"\"\"a  \n\n\n b\"\"\"\n"
    );
}

#[test]
fn raw_values_replace_what_keys_say() {
    let text = "format = \"objdict-device/1\"\nraw-remove = ['/objects/0x2000/access']\n\n[object]\n\
        2000 = { name = 'A', type = 'u8' }\n\n[raw]\n'/objects/0x2000/default' = { unsigned = 7 }\n";
    let device = read(text).into_device();
    let main = &device.objects[&0x2000].main;
    assert_eq!((main.access, &main.default), (None, &Some(Value::Unsigned(7))));
}

/// A file without this first key is what it was before.
#[test]
fn other_toml_is_no_device() {
    use objdict::format::identify::{ContentKind, identify};
    let kind = |text: &str| identify("a.toml", text.as_bytes()).kind;
    assert_eq!(kind("# a drive\n\nformat = \"objdict-device/1\"\n[object]\n"), ContentKind::DeviceToml);
    assert_eq!(kind("[bus]\nname = 'a'\n"), ContentKind::Network);
    assert_eq!(kind("format = \"objdict-patch/1\"\n"), ContentKind::Patch);
    assert_eq!(kind("[package]\nformat = \"objdict-device/1\"\n"), ContentKind::Unknown);
    let bytes = fs::read(fixture("io.toml")).unwrap();
    assert_eq!(identify("io", &bytes).kind, ContentKind::DeviceToml);
}

/// Every key of the JSON Schema is on the page, with its meaning.
#[test]
fn the_reference_has_every_key() {
    fn keys(schema: &serde_json::Value, found: &mut Vec<(String, String)>) {
        if let Some(properties) = schema.get("properties").and_then(serde_json::Value::as_object) {
            let meaning =
                |value: &serde_json::Value| value["description"].as_str().unwrap_or_default().to_owned();
            let present = properties.iter().filter(|(_, value)| value["deprecated"] != true);
            found.extend(present.map(|(key, value)| (key.clone(), meaning(value))));
        }
        match schema {
            serde_json::Value::Object(fields) => fields.values().for_each(|value| keys(value, found)),
            serde_json::Value::Array(items) => items.iter().for_each(|value| keys(value, found)),
            _ => {}
        }
    }
    let page = include_str!("../../docs/reference/device.md");
    let mut found = Vec::new();
    keys(&format::device_schema(), &mut found);
    assert!(found.len() > 100, "{found:?}");
    for (key, meaning) in found {
        let row = page.lines().filter(|line| line.starts_with(&format!("| `{key}` |")));
        let meaning = meaning.trim_end_matches('.').to_lowercase();
        assert!(
            row.clone().any(|line| line.to_lowercase().contains(&meaning))
                || meaning == UNSTATED
                || meaning == EXTRA,
            "`{key}` is not on docs/reference/device.md as `{meaning}`"
        );
    }
    let drive = fs::read_to_string(fixture("drive.toml")).unwrap();
    assert!(page.contains(&drive), "the example of docs/reference/device.md is fixtures/toml/drive.toml");
}

/// Meanings of keys that several tables have are on the page once.
const UNSTATED: &str = "which facts the description leaves out that would follow from missing keys";
const EXTRA: &str = "keys of a description that cia's documents do not have, in their order";

//! Projects of objdictgen.

use std::fmt::Write as _;

use objdict::format::input::{FileKind, Input, Reading};
use objdict::format::{Description, Format, WriteOptions};
use objdict::model::{DataType, Device, ObjectType, PdoMapping, Value};

use crate::support::fixtures;

fn open(name: &str, bytes: Vec<u8>) -> Description {
    let (kind, input) = Reading::default().read(name, bytes.clone()).unwrap();
    let Input::Description(description) = input else { panic!("no description") };
    assert_eq!((kind, description.is_project(), description.print()), (FileKind::Objdictgen, true, bytes));
    *description
}

fn pump() -> Description {
    open("pump.od", std::fs::read(fixtures().join("objdictgen/pump.od")).unwrap())
}

fn default(device: &Device, index: u16, sub: u8) -> Option<Value> {
    device.entry(index, sub).unwrap().default.clone()
}

#[test]
fn a_project_is_read() {
    let description = pump();
    let device = description.device();
    assert_eq!((device.node_id(), description.findings().len()), (Some(5), 0));
    assert_eq!(device.commissioning.as_ref().unwrap().node_name.as_deref(), Some("Pump"));
    assert_eq!(device.file_info.as_ref().unwrap().description.as_deref(), Some("A pump with two valves"));
    assert!(
        device.objects.keys().all(|&index| index >= 0x1000 && index != 0x6100),
        "types and unused objects"
    );
    // expressions
    assert_eq!(default(device, 0x1014, 0), Some(Value::NodeId(0x80)));
    assert_eq!(default(device, 0x1401, 1), Some(Value::NodeId(0x300)));
    assert_eq!(default(device, 0x1804, 1), Some(Value::Unsigned(0x8000_0000)));
    assert_eq!(device.objects[&0x1601].name(), "Receive PDO 2 Mapping");
    assert_eq!(&*device.entry(0x6002, 3).unwrap().name, "Force 3 to 4");
    // structure
    let object_type = |index: u16| device.objects[&index].object_type();
    assert_eq!(
        [0x2000, 0x2001, 0x2002].map(object_type),
        [ObjectType::Var, ObjectType::Array, ObjectType::Record]
    );
    assert_eq!([0x1003, 0x2004].map(object_type), [ObjectType::Array, ObjectType::Domain]);
    assert_eq!(
        (default(device, 0x1003, 0), default(device, 0x2001, 0)),
        (Some(Value::Unsigned(0)), Some(Value::Unsigned(3)))
    );
    // types of the device
    let setpoint = device.entry(0x2000, 0).unwrap();
    assert_eq!(
        (setpoint.data_type, setpoint.pdo_mapping),
        (Some(DataType::INTEGER16), Some(PdoMapping::Optional))
    );
    assert_eq!(
        (&setpoint.low_limit, &setpoint.high_limit),
        (&Some(Value::Signed(-100)), &Some(Value::Signed(100)))
    );
    let size = |index, sub| device.entry(index, sub).unwrap().stack.as_ref().unwrap().min_string_length;
    assert_eq!([size(0x2002, 3), size(0x2003, 0), size(0x2007, 1)], [Some(20), Some(24), Some(12)]);
    assert_eq!(default(device, 0x2004, 0), Some(Value::Bytes([0, 1, 0xFE].into())));
    // what is stored, and who is called
    let stack = |index, sub| device.entry(index, sub).unwrap().stack.clone().unwrap_or_default();
    assert_eq!(
        (stack(0x2000, 0).storage_group.as_deref(), stack(0x2000, 0).io_extension),
        (Some("saved"), Some(true))
    );
    assert_eq!(
        (stack(0x2001, 1).storage_group, stack(0x2001, 2).storage_group.as_deref()),
        (None, Some("saved"))
    );
}

#[test]
fn an_eds_keeps_what_is_generated() {
    let device = pump().into_device();
    let mut options = WriteOptions::default();
    options.embed = true;
    let written = objdict::format::write(&device, Format::Eds, &options).unwrap();
    let (_, input) = Reading::default().read("pump.eds", written.bytes).unwrap();
    let Input::Description(again) = input else { panic!("no description") };
    let files = |device: &Device| {
        let mut options = objdict::generate::Options::default();
        (options.node_id, options.file_stem) = (Some(5), "pump".to_owned());
        let made =
            objdict::generate::generate(device, objdict::generate::Target::CANFESTIVAL, &options).unwrap();
        made.files
            .into_iter()
            .map(|file| (file.path, String::from_utf8(file.contents).unwrap()))
            .collect::<Vec<_>>()
    };
    assert_eq!(files(&device), files(again.device()));
}

#[test]
fn findings_have_places() {
    let description = pump();
    let findings = objdict::check(&description);
    let found: Vec<String> =
        findings.iter().map(|found| format!("{} {}", found.rule.id, found.message)).collect();
    assert!(findings.iter().all(|found| found.severity < objdict::diagnostic::Severity::Error), "{found:#?}");
    let place = objdict::model::Place::entry(0x2001, 2);
    let span = description.locate(&place).unwrap();
    assert_eq!(span.of(description.source().text()), "<item type=\"numeric\" value=\"2\" />");
}

#[test]
fn broken_projects_are_read_as_far_as_possible() {
    let text = std::fs::read_to_string(fixtures().join("objdictgen/pump.od")).unwrap();
    for end in (200..text.len()).step_by(61) {
        let mut options = Reading::default();
        options.from = Some(FileKind::Objdictgen);
        let _ = options.read("pump.od", text.as_bytes()[..end].to_vec());
    }
    // a list that is its own item, and one that many objects refer to
    let mut entries = String::new();
    for index in 0x2000..0x4000 {
        let _ = write!(
            entries,
            "<entry><key type=\"numeric\" value=\"{index}\"/><val type=\"list\" refid=\"7\"/></entry>"
        );
    }
    let items = "<item type=\"list\" refid=\"7\"/>".repeat(250);
    let mapping = "<entry><key type=\"numeric\" value=\"8192\"/><val type=\"dict\"><entry><key type=\"string\" value=\"struct\"/>\
                   <val type=\"numeric\" value=\"15\"/></entry><entry><key type=\"string\" value=\"nbmax\"/><val type=\"numeric\" \
                   value=\"9999999999\"/></entry></val></entry>";
    let text = format!(
        "<PyObject><attr name=\"X\" type=\"list\" id=\"7\">{items}</attr><attr name=\"Dictionary\" type=\"dict\">{entries}</attr>\
         <attr name=\"UserMapping\" type=\"dict\">{mapping}</attr></PyObject>"
    );
    let device = open("x.od", text.into_bytes()).into_device();
    let entries: usize = device.objects.values().map(|object| object.subs.len()).sum();
    assert!((1..50_000).contains(&entries), "{entries}");
}

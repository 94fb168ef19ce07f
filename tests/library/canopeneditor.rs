//! Projects of CANopenEditor as JSON.

use std::collections::BTreeSet;

use objdict::compare::each_difference;
use objdict::format::canopeneditor;
use objdict::format::identify::{ContentKind, identify};
use objdict::format::input::{FileKind, Input, Reading};
use objdict::format::{self, Format, LossKind, WriteOptions};
use objdict::model::{
    Access, DataType, Device, Object, ObjectType, ParameterAccess, PdoMapping, SrdoAccess, Value,
};
use objdict::source::{SourceFile, SourceOptions};

use crate::support::{files_below, fixtures, good_devices};

fn project() -> String {
    std::fs::read_to_string(fixtures().join("canopeneditor/valve.json")).unwrap()
}

fn open(text: &str) -> Device {
    let reading = Reading { keep_disabled: true, ..Reading::default() };
    let (kind, input) = reading.read("valve.json", text.as_bytes().to_vec()).unwrap();
    let Input::Device(device) = input else { panic!("no device") };
    assert_eq!(kind, FileKind::CanopenEditorJson);
    *device
}

#[test]
fn a_project_is_read() {
    assert_eq!(identify("x", project().as_bytes()).kind, ContentKind::CanopenEditorJson);
    let device = open(&project());
    let (file, info) = (device.file_info.as_ref().unwrap(), device.device_info.as_ref().unwrap());
    assert_eq!((file.file_version, file.description.as_deref()), (Some(2), Some("A valve")));
    assert_eq!(file.creation_date.unwrap().to_iso(), "2024-03-04");
    assert_eq!(file.creation_time.unwrap().to_iso(false), "14:40:00Z");
    assert_eq!(file.modification_date, None, "the start of the calendar is no date");
    assert_eq!(info.baud_rates.supported().collect::<Vec<_>>(), [125]);
    assert_eq!((info.lss_supported, info.product_name.as_deref()), (Some(true), Some("Valve")));
    let node = device.commissioning.as_ref().unwrap();
    assert_eq!(
        (node.node_id, node.node_name.as_deref(), node.baud_rate),
        (Some(5), Some("Inlet"), Some(125))
    );

    let stack = |object: &Object| object.main.stack.clone().unwrap_or_default();
    let tpdo = &device.objects[&0x1800];
    assert_eq!((tpdo.object_type(), tpdo.subs.len()), (ObjectType::Record, 3));
    assert_eq!(
        (stack(tpdo).count_label.as_deref(), stack(tpdo).storage_group.as_deref()),
        (Some("TPDO"), Some("PERSIST_COMM"))
    );
    assert_eq!(device.entry(0x1800, 1).unwrap().default, Some(Value::NodeId(0x180)));

    let position = &device.objects[&0x2000].main;
    assert_eq!((&*position.name, position.data_type), ("Position", Some(DataType::INTEGER16)));
    assert_eq!((position.access, position.pdo_mapping), (Some(Access::Rwr), Some(PdoMapping::Tpdo)));
    let values = [&position.default, &position.low_limit, &position.high_limit].map(Option::clone);
    assert_eq!(values, [-1, -100, 100].map(|number| Some(Value::Signed(number))));
    let configured = position.configured.as_ref().unwrap();
    assert_eq!(
        (configured.denotation.as_deref(), configured.value.as_ref()),
        (Some("Inlet position"), Some(&Value::Signed(7)))
    );
    let settings = position.stack.as_ref().unwrap();
    assert_eq!(
        (settings.detects_change, settings.srdo_access, settings.storage_group.as_deref()),
        (Some(true), Some(SrdoAccess::Trx), Some("RAM"))
    );
    let described = position.parameter.as_ref().unwrap().labels.description_in("en");
    assert_eq!(described, Some("The position that the valve has"));

    let names = &device.objects[&0x2001];
    let name = names.subs.get(1).unwrap();
    assert!(names.is_disabled());
    assert_eq!(name.stack.as_ref().unwrap().min_string_length, Some(40));
    assert_eq!((name.access, name.pdo_mapping), (None, Some(PdoMapping::Rpdo)));
    assert_eq!(name.parameter.as_ref().unwrap().access, Some(ParameterAccess::NoAccess));
    assert_eq!(device.objects[&0x2002].object_type(), ObjectType::Domain);
}

#[test]
fn a_project_comes_back_as_json_and_from_an_xdd() {
    let device = open(&project());
    let written = canopeneditor::write(&device, 1000).unwrap();
    assert_eq!(written.losses, []);
    assert_eq!(open(std::str::from_utf8(&written.bytes).unwrap()), device);

    let options = WriteOptions { embed: true, ..WriteOptions::default() };
    let xdd = format::write(&device, Format::Xdc, &options).unwrap();
    let lost: Vec<_> = xdd.losses.iter().filter(|loss| loss.kind == LossKind::Lost).collect();
    assert!(lost.is_empty(), "{lost:?}");
    let source = SourceFile::from_bytes("valve.xdc", xdd.bytes, &SourceOptions::default()).unwrap();
    let back = canopeneditor::write(format::read(source, Format::Xdc).described(), 1000).unwrap();
    let (text, expected) =
        (String::from_utf8(back.bytes).unwrap(), String::from_utf8(written.bytes).unwrap());
    similar_asserts(&text, &expected);
}

fn similar_asserts(text: &str, expected: &str) {
    for (line, expected) in text.lines().zip(expected.lines()) {
        assert_eq!(line, expected);
    }
    assert_eq!(text.len(), expected.len());
}

#[test]
fn faults_are_named_with_their_places() {
    for (from, to, message) in [
        ("\"lssSlave\"", "\"lssSlaves\"", "line 13, column 15: unknown field `lssSlaves`"),
        (
            "\"UNSIGNED32\"",
            "\"UINT32\"",
            "line 22, column 50: `UINT32` is not a number up to 65535 or one of UNSPECIFIED BOOLEAN",
        ),
        ("\"ACCESS_SDO_RO\"", "4", "`4` is not a number up to 3 or one of ACCESS_SDO_NO"),
        ("\"0x1800\"", "\"1000\"", "line 24, column 10: the key `1000` is defined twice"),
        ("\"0x1800\"", "\"18000\"", "line 24, column 11: `18000` is not 4 hexadecimal digits"),
        ("\"0x02\"", "\"2h\"", "line 32, column 12: `2h` is not 2 hexadecimal digits"),
        ("\"5\"", "\"five\"", "`five` is not a number up to 255"),
    ] {
        let text = project().replacen(from, to, 1);
        let error = Reading::default().read("valve.json", text.into_bytes()).unwrap_err().to_string();
        assert!(error.contains(message), "{error}\ninstead of {message}");
    }
}

/// The ends of the paths of data that a project has no place for, or only another form of, as of `const`.
const NO_PLACE: &str = "access application comments communication_entities compact_pdo configuration_manager configured \
    conformance_class creation_time data_type default default_baud_rate detects_change device_class download_file dummy_usage \
    dynamic_channels dynamic_channels_supported eds_version extra file_name file_revision flags flying_master functions granularity \
    group_messaging headers identity io_extension labels languages last_eds links lss_master lss_serial_number manager \
    modification_time module_objects modules net_number net_reference_designator network_name node_reference_designator object_type \
    order_code parameter pdo_mapping product_number reference_designator revision_number rpdo_count sdo_manager sdo_requesting \
    self_starting simple_boot_up_master simple_boot_up_slave stack tools tpdo_count unique_id vendor_number";

#[test]
fn everything_else_comes_back() {
    let mut lost = BTreeSet::new();
    let of_xml =
        ["xdd", "xdc", "cnxml"].map(|folder| files_below(&fixtures().join(folder), &["xdd", "xdc", "xml"]));
    for path in good_devices().into_iter().chain(of_xml.concat()) {
        let description = format::open(&path, &SourceOptions::default()).unwrap();
        let device = description.described().expanded().into_owned();
        let written = canopeneditor::write(&device, 100_000).unwrap();
        let mut back = open(std::str::from_utf8(&written.bytes).unwrap());
        back.kind = device.kind;
        let listed: BTreeSet<&str> = written.losses.iter().map(|loss| loss.path.as_str()).collect();
        each_difference(&device, &back, usize::MAX, &mut |difference| {
            let path = difference.path;
            if difference.left.is_some() {
                let is_listed = listed.iter().any(|listed| listed.starts_with(&path));
                assert!(is_listed, "{path} is lost and not listed");
                lost.insert(path.rsplit('/').next().unwrap_or_default().to_owned());
            }
        })
        .unwrap();
    }
    assert_eq!(lost.into_iter().collect::<Vec<_>>().join(" "), NO_PLACE);
}

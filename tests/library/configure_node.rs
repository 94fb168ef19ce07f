//! Nodes configured: the exercises of CANopen's textbook, what is refused, and couplers with their modules.

use std::path::Path;

use objdict::configure::{
    Configuration, NoSetting, Rebased, Setting, SettingProblem, configuration, configure, rebase,
};
use objdict::coupler::{ModuleProblem, flatten};
use objdict::diagnostic::{Applicability, Diagnostic};
use objdict::download::{ConciseDcf, PlanOptions};
use objdict::format::{self, Description, Format, NodeSettings, WriteOptions};
use objdict::lint::{self, Options};
use objdict::model::{Access, Assignment, Commissioning, DataType, Device, Entry, Moment, Object, Value};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn open(path: &str) -> Description {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(path);
    format::open(&path, &SourceOptions::default()).unwrap()
}

fn node(node_id: u8) -> Commissioning {
    Commissioning { node_id: Some(node_id), baud_rate: Some(250), ..Commissioning::default() }
}

/// The DCF of an EDS with these settings, read back.
fn configured(eds: &Description, node_id: u8, settings: &[Setting]) -> Description {
    let assignments = configure(eds.device(), node_id, settings).unwrap();
    let settings =
        NodeSettings { node: &node(node_id), plugged: None, assignments: &assignments, downloads: &[] };
    let configured = eds.configured("node.dcf", &settings).unwrap();
    assert!(configured.is_edited);
    let dcf = format::read(
        SourceFile::from_bytes("node.dcf", configured.bytes, &SourceOptions::default()).unwrap(),
        Format::Dcf,
    );
    assert_eq!(dcf.device().objects, configured.device.objects);
    dcf
}

/// The concise DCF of a node, in hex.
fn stream(dcf: &Description) -> String {
    let plan = ConciseDcf::plan(dcf.device(), &PlanOptions::default()).unwrap();
    let stream = plan.into_concise(|file| Err(file.name.clone())).unwrap();
    assert!(stream.verify(dcf.device(), None).objections.is_empty());
    stream.write().unwrap().iter().map(|byte| format!("{byte:02X}")).collect()
}

/// Exercise 2.7.1: node 5 sends its heartbeat every 250 ms and watches the nodes 7 and 9.
#[test]
fn heartbeat_producer_and_consumer() {
    let settings = [
        Setting::value("1017=250").unwrap(),
        Setting::heartbeat_consumer("7=750ms").unwrap(),
        Setting::heartbeat_consumer("9=1.5s").unwrap(),
    ];
    let dcf = configured(&open("eds/io-401.eds"), 5, &settings);
    assert_eq!(stream(&dcf), "0300000017100002000000FA0016100104000000EE02070016100204000000DC050900");
}

/// An INTEGER32 with these limits in 2000h of the smallest device.
fn with_limits(low: &str, high: &str) -> Description {
    let text = std::fs::read_to_string(support::fixtures().join("bases/small.eds")).unwrap();
    let limits = format!("DataType=0x0004\nLowLimit={low}\nHighLimit={high}\nDefaultValue=0\n");
    let (general, object) = text.split_once("[2000]").unwrap();
    let text = format!("{general}[2000]{}", object.replacen("DataType=0x0006\n", &limits, 1));
    format::read(SourceFile::from_text("limits.eds", text), Format::Eds)
}

/// Hex digits above a signed type limit nothing, in no format and to no fix.
#[test]
fn a_high_limit_above_its_type_is_the_largest_number() {
    let eds = with_limits("0", "0xFFFFFFFF");
    let limit = |device: &Device| device.object(0x2000).unwrap().main.high_limit.clone();
    assert_eq!(limit(eds.device()), Some(Value::Signed(i32::MAX.into())));
    configured(&eds, 5, &[Setting::value("2000=5").unwrap()]);
    for ending in [Format::Eds, Format::Xdd] {
        let written = format::write(eds.device(), ending, &WriteOptions::default()).unwrap();
        let text = String::from_utf8(written.bytes).unwrap();
        assert!(text.contains("2147483647") && !text.contains("\"-1\""), "{text}");
        let attributes = text.replace("\"2147483647\"", "\"0xFFFFFFFF\"");
        let again = format::read(SourceFile::from_text("again", attributes), ending);
        assert_eq!(limit(again.device()), limit(eds.device()));
        let of_limit = |finding: &Diagnostic| finding.rule.id == "cia306/limit-above-type";
        assert_eq!(again.findings().iter().any(of_limit), ending == Format::Xdd);
    }
    let before = eds.source().text().to_owned();
    let fixed = objdict::fix(eds, Applicability::Safe, objdict::check);
    assert!(
        before.contains("HighLimit=0xFFFFFFFF")
            && fixed.description.source().text().contains("HighLimit=0xFFFFFFFF")
    );
}

/// The limits are what is wrong, and `check` says so.
#[test]
fn limits_that_no_value_keeps_refuse_none() {
    let eds = with_limits("10", "2");
    assert!(objdict::check(&eds).iter().any(|finding| finding.rule.id == "cia306/low-limit-above-high"));
    let dcf = configured(&eds, 5, &[Setting::value("2000=5").unwrap()]);
    assert_eq!(stream(&dcf), "010000000020000400000005000000");
}

/// Exercise 2.7.2: RPDO 1 of node 5 listens to TPDO 1 of node 6.
#[test]
fn pdo_linking() {
    let dcf = configured(&open("eds/io-401.eds"), 5, &[Setting::cob_id("rpdo1=0x186").unwrap()]);
    assert_eq!(stream(&dcf), "0200000000140104000000050200800014010400000086010000");
}

/// The I/O module with eight analogue outputs, four in RPDO 2 and four in RPDO 3, as CiA 401 maps them by default.
fn outputs() -> Description {
    let mut device = open("eds/io-401.eds").into_device();
    let output = device.objects[&0x6411].subs.get(1).unwrap().clone();
    for sub in 1..=8 {
        device.objects.get_mut(&0x6411).unwrap().subs.insert(sub, output.clone());
    }
    for (communication, offset, first) in [(0x1401, 0x300, 1), (0x1402, 0x400, 5)] {
        let mut record = device.objects[&0x1401].clone();
        record.subs.get_mut(1).unwrap().default = Some(Value::NodeId(offset));
        device.objects.insert(communication, record);
        let mut mapping = device.objects[&0x1601].clone();
        mapping.subs.get_mut(0).unwrap().default = Some(Value::Unsigned(4));
        for slot in 0..4 {
            let mapped = 0x6411_0010 | u64::from(first + slot) << 8;
            mapping.subs.get_mut(slot + 1).unwrap().default = Some(Value::Unsigned(mapped));
        }
        device.objects.insert(communication + 0x200, mapping);
    }
    let bytes = format::write(&device, Format::Eds, &WriteOptions::default()).unwrap().bytes;
    format::read(
        SourceFile::from_bytes("outputs.eds", bytes, &SourceOptions::default()).unwrap(),
        Format::Eds,
    )
}

/// Exercise 2.7.3: RPDO 2 and 3 of node 31 get other CAN-IDs and two outputs each.
#[test]
fn pdo_linking_and_mapping() {
    let eds = outputs();
    let settings = [
        Setting::map("rpdo2=6411:1,6411:2").unwrap(),
        Setting::map("rpdo3=6411:3,6411:4").unwrap(),
        Setting::cob_id("rpdo2=0x2AA").unwrap(),
        Setting::cob_id("rpdo3=0x3AD").unwrap(),
    ];
    let expected = "0C000000011401040000001F030080011600010000000001160104000000100111640116020400000010021164\
        011600010000000201140104000000AA020000021401040000001F04008002160001000000000216010400000010031164\
        0216020400000010041164021600010000000202140104000000AD030000";
    assert_eq!(stream(&configured(&eds, 0x1F, &settings)), expected);
}

#[test]
fn all_problems_are_told_at_once() {
    let device = open("eds/io-401.eds").into_device();
    let value = |text: &str| Setting::value(text).unwrap();
    let map = |text: &str| Setting::map(text).unwrap();
    let id = |text: &str| Setting::cob_id(text).unwrap();
    let settings = [
        value("1071=250"),
        value("7777=1"),
        value("1017=70000"),
        value("1017=010"),
        value("1017="),
        value("1018:1=5"),
        value("1010:1=1"),
        value("1016=1"),
        value("1016:9=1"),
        value("1016:1=0x00FF0000"),
        map("tpdo1=6200:1"),
        map("tpdo1=6002:1"),
        map("tpdo1=0005"),
        map("rpdo1=0007,0007,6200:1"),
        map("tpdo1=6000:1,6000:1,6000:1,6000:1,6000:1"),
        map("tpdo9=6000:1"),
        id("rpdo1=0x601"),
        id("rpdo1=0x185"),
        id("tpdo9=0x190"),
        Setting::heartbeat_consumer("5=100").unwrap(),
        value("1005=0x80"),
        value("100C=100"),
        value("1800:3=50us"),
        value("6002:1=5ms"),
        id("tpdo1=0x85"),
        Setting::sync_start("tpdo1=3").unwrap(),
        Setting::time("consumer").unwrap(),
    ];
    let problems = configure(&device, 5, &settings).unwrap_err();
    let told = |problem: &SettingProblem| match &problem.help {
        Some(help) => format!("{problem}\n    {help}"),
        None => problem.to_string(),
    };
    insta::assert_snapshot!(problems.iter().map(told).collect::<Vec<_>>().join("\n"));
}

/// The I/O module with SYNC, TIME and guarding, and with SYNC start values.
fn with_services() -> Device {
    let mut device = open("eds/io-401.eds").into_device();
    let entry = |data_type, default| Entry {
        data_type: Some(data_type),
        access: Some(Access::Rw),
        default: Some(Value::Unsigned(default)),
        ..Entry::default()
    };
    for (index, data_type, default) in [
        (0x1005, DataType::UNSIGNED32, 0x80),
        (0x1006, DataType::UNSIGNED32, 0),
        (0x100C, DataType::UNSIGNED16, 0),
        (0x100D, DataType::UNSIGNED8, 0),
        (0x1012, DataType::UNSIGNED32, 0x100),
        (0x2000, DataType::UNSIGNED16, 7),
    ] {
        device.objects.insert(index, Object { main: entry(data_type, default), ..Object::default() });
    }
    device.objects.get_mut(&0x1800).unwrap().subs.insert(6, entry(DataType::UNSIGNED8, 0));
    device
}

/// What settings change: `1017:00=1000`.
fn values(device: &Device, settings: &[Result<Setting, NoSetting>]) -> Vec<String> {
    let settings: Vec<Setting> = settings.iter().cloned().collect::<Result<_, _>>().unwrap();
    let assignments = configure(device, 5, &settings).unwrap();
    let written = |Assignment { index, sub, value }: Assignment| match value.as_integer() {
        Some(number) if number > 0xFFFF => format!("{index:04X}:{sub:02X}={number:#X}"),
        _ => format!("{index:04X}:{sub:02X}={value}"),
    };
    assignments.into_iter().map(written).collect()
}

#[test]
fn times_have_the_unit_of_their_entry() {
    let device = with_services();
    let settings = [
        Setting::value("1006=33.5ms"),
        Setting::value("1017=1.5s"),
        Setting::value("1800:3=5ms"),
        Setting::value("1801:5=default"),
        Setting::inhibit("tpdo2=300us"),
    ];
    let expected = ["1006:00=33500", "1017:00=1500", "1800:03=50", "1801:03=3", "1801:05=1000"];
    assert_eq!(values(&device, &settings), expected);
}

#[test]
fn services_and_parameters_of_pdos() {
    let device = with_services();
    let settings = [
        Setting::transmission("tpdo1=sync/4"),
        Setting::transmission("rpdo1=event-vendor"),
        Setting::event_timer("tpdo2=0.1s"),
        Setting::sync_start("tpdo1=3"),
        Setting::sync("producer,33ms"),
        Setting::time("0x101,consumer").and(Setting::time("consumer")),
        Setting::emcy("0xA0"),
        Setting::guard("100msx3"),
    ];
    let expected = [
        "1005:00=0x40000080",
        "1006:00=33000",
        "100C:00=100",
        "100D:00=3",
        "1012:00=0x80000100",
        "1014:00=160",
        "1400:02=254",
        "1800:02=4",
        "1800:06=3",
        "1801:05=100",
    ];
    assert_eq!(values(&device, &settings), expected);
    let off = [Setting::time("off"), Setting::emcy("off"), Setting::sync("0x90,consumer")];
    assert_eq!(values(&device, &off), ["1005:00=144", "1012:00=256", "1014:00=$NODEID+0x80000080"]);
}

/// A PDO gets its predefined CAN-ID, or a free one when another service has that.
#[test]
fn free_can_ids_are_found() {
    let device = with_services();
    let auto = |pdo: &str| Setting::cob_id(&format!("{pdo}=auto"));
    let settings = [Setting::cob_id("tpdo1=0x285"), auto("tpdo2"), auto("rpdo2")];
    let before = [Setting::cob_id("tpdo2=off"), Setting::cob_id("rpdo1=0x680")];
    let found = values(&device, &before.into_iter().chain(settings).collect::<Vec<_>>());
    let expected = ["1400:01=1664", "1401:01=$NODEID+0x300", "1800:01=645", "1801:01=1665"];
    assert_eq!(found, expected);
}

/// A node that gets another node-ID: CAN-IDs of the former one follow, a link to another node stays.
#[test]
fn can_ids_follow_the_node_id() {
    let mut device = open("eds/io-401.eds").into_device();
    let fixed = [
        (0x1014, 0, 0x83),
        (0x1200, 1, 0x603),
        (0x1400, 1, 0x8000_0203),
        (0x1401, 1, 0x185),
        (0x1800, 1, 0x4000_0283),
        (0x1801, 1, 0x683),
    ];
    device.assign(&fixed.map(|(index, sub, number)| Assignment {
        index,
        sub,
        value: Value::Unsigned(number),
    }));
    let Rebased { assignments, kept } = rebase(&device, 3);
    let followers: Vec<String> = assignments
        .iter()
        .map(|Assignment { index, sub, value }| format!("{index:04X}:{sub}={value}"))
        .collect();
    let expected = [
        "1014:0=$NODEID+0x80",
        "1200:1=$NODEID+0x600",
        "1400:1=$NODEID+0x80000200",
        "1800:1=$NODEID+0x40000280",
    ];
    assert_eq!(followers, expected);
    let kept: Vec<(u16, u32)> = kept.iter().map(|(at, id)| (at.index, id.number())).collect();
    assert_eq!(kept, [(0x1401, 0x185), (0x1801, 0x683)]);
    assert_eq!(rebase(&open("eds/io-401.eds").into_device(), 3), Rebased::default());
}

/// Downloads beside the values stay in the file: in comment lines of a DCF, in a characteristic of an XDC.
#[test]
fn explicit_downloads_stay_in_the_file() {
    let configured = |description: &Description, settings: &[Setting]| {
        let Configuration { values, downloads } = configuration(description.device(), 5, settings).unwrap();
        let settings =
            NodeSettings { node: &node(5), plugged: None, assignments: &values, downloads: &downloads };
        let configured = description.configured("node", &settings).unwrap();
        let format = if description.format().name().starts_with('X') { Format::Xdc } else { Format::Dcf };
        let source = SourceFile::from_bytes("node", configured.bytes, &SourceOptions::default()).unwrap();
        (format::read(source, format), configured.is_edited)
    };
    let sdo = |when, text| Setting::downloads(when, text).unwrap();
    for (file, edits) in [("eds/drive-402.eds", true), ("xdd/drive-402.xdd", false)] {
        let first = [sdo(Moment::After, "6040=6,7,15"), sdo(Moment::Before, "6060=1")];
        let (node, is_edited) = configured(&open(file), &first);
        assert_eq!(is_edited, edits, "{file}");
        let expected =
            "04000000606000010000000140600002000000060040600002000000070040600002000000".to_owned() + "0F00";
        assert_eq!(stream(&node), expected, "{file}");
        let (same, _) = configured(&node, &[Setting::value("1017=1s").unwrap()]);
        assert_eq!(same.device().downloads, node.device().downloads, "{file}");
        let (other, _) = configured(&node, &[sdo(Moment::After, "6040=128")]);
        assert_eq!(other.device().downloads.len(), 1, "{file}");
        let text = other.source().text();
        assert_eq!(text.matches("/downloads").count(), 1, "{file}");
    }
}

#[test]
fn numbers_of_the_node_keep_their_spelling_but_for_those_of_other_tools() {
    let text = "[DeviceComissioning]\nNodeID=0x03\nNodeName=07\nNetNumber=0x1\nCANopenManager=0\nLSS_SerialNumber=0x00001234\n";
    let source =
        SourceFile::from_bytes("n.dcf", text.as_bytes().to_vec(), &SourceOptions::default()).unwrap();
    let description = format::read(source, Format::Dcf);
    let mut node = description.device().commissioning.clone().unwrap();
    node.node_name = Some("7".to_owned());
    let settings = NodeSettings { node: &node, plugged: None, assignments: &[], downloads: &[] };
    let bytes = description.configured("n.dcf", &settings).unwrap().bytes;
    let changed = String::from_utf8(bytes).unwrap();
    assert!(changed.contains("NodeID=3\nNodeName=7\nNetNumber=0x1\n"), "{changed}");
    assert!(changed.contains("LSS_SerialNumber=0x00001234\n"), "{changed}");
}

#[test]
fn settings_name_objects() {
    let device = open("eds/drive-402.eds").into_device();
    let made = |set: &str, map: &str| {
        configure(&device, 5, &[Setting::value(set).unwrap(), Setting::map(map).unwrap()])
    };
    let by_address = made("1017=250", "tpdo1=6041,6064").unwrap();
    assert_eq!(made("producer heartbeat time=250", "tpdo1=Statusword,Position actual value"), Ok(by_address));
    let problems = made("actual value=1", "tpdo1=statuswird").unwrap_err();
    assert_eq!(problems[0].to_string(), "`actual value=1`: `actual value` is ambiguous");
    let candidates = problems[0].help.as_deref().unwrap();
    assert!(candidates.contains("`6064` Position actual value"), "{candidates}");
    assert_eq!(problems[1].help.as_deref(), Some("did you mean `Statusword`?"));
}

/// Settings of compactly stored entries go into the section with their values, which may have to be made.
#[test]
fn compact_entries_are_configured() {
    let eds = open("eds/compact.eds");
    let of_device = eds.device().objects.iter().find(|(_, object)| {
        let is_writable = object.main.access.is_some_and(objdict::model::Access::is_writable);
        object.compact.is_some()
            && is_writable
            && object.main.data_type.is_some_and(objdict::model::DataType::is_integer)
    });
    let (index, _) = of_device.unwrap();
    let settings = [
        Setting::value(&format!("{index:04X}:1=1")).unwrap(),
        Setting::value(&format!("{index:04X}:2=0")).unwrap(),
    ];
    let dcf = configured(&eds, 5, &settings);
    let text = dcf.source().text();
    assert!(text.to_ascii_lowercase().contains(&format!("[{index:04x}value]")), "{text}");
    // and once more, in the section that is there now
    let again = configured(&dcf, 5, &[Setting::value(&format!("{index:04X}:1=0")).unwrap()]);
    assert_eq!(again.source().text().matches("Value]").count(), text.matches("Value]").count());
}

/// The coupler of the fixtures with its modules is the node of the fixtures, but for what that one configures.
#[test]
fn a_coupler_with_its_modules() {
    let coupler = open("eds/coupler-modular.eds");
    let expected = open("dcf/coupler-modular-node10.dcf");
    let plugged = flatten(coupler.device(), &[1, 1, 2, 3]).unwrap();
    for index in [0x2400, 0x2401, 0x6000, 0x6020, 0x6200, 0x6401] {
        let entries = |device: &Device| {
            let entries = device.object(index).unwrap().entries();
            let facts = |(sub, entry): (u8, std::borrow::Cow<'_, objdict::model::Entry>)| {
                let kept = objdict::model::Entry { configured: None, ..entry.into_owned() };
                (sub, kept.data_type, kept.access, kept.is_mappable(), kept.default)
            };
            entries.map(facts).collect::<Vec<_>>()
        };
        assert_eq!(entries(&plugged), entries(expected.device()), "{index:04X}");
    }
    assert_eq!(plugged.modules.as_ref().unwrap().connected.as_deref(), Some(&[1, 1, 2, 3][..]));
}

/// Ten racks: each becomes a DCF by edits, is clean, and says of itself what was plugged in.
#[test]
fn modular_configurations_are_clean() {
    let coupler = open("eds/coupler-modular.eds");
    let racks: [&[u16]; 10] =
        [&[1], &[2], &[3], &[4], &[4, 4], &[1, 1, 2, 3], &[3, 5], &[4, 1, 4], &[1, 2, 3, 4, 5], &[1; 17]];
    for rack in racks {
        let plugged = flatten(coupler.device(), rack).unwrap();
        let settings =
            NodeSettings { node: &node(10), plugged: Some(&plugged), assignments: &[], downloads: &[] };
        let configured = coupler.configured("rack.dcf", &settings).unwrap();
        assert!(configured.is_edited, "{rack:?}");
        let source = SourceFile::from_bytes("rack.dcf", configured.bytes, &SourceOptions::default()).unwrap();
        let dcf = format::read(source, Format::Dcf);
        assert_eq!(dcf.device().objects, plugged.objects, "{rack:?}");
        let findings = objdict::check(&dcf);
        let told: Vec<String> =
            findings.iter().map(|finding| format!("{}: {}", finding.rule.id, finding.message)).collect();
        assert_eq!(told, Vec::<String>::new(), "{rack:?}");
        assert_eq!(dcf.device().modules.as_ref().unwrap().connected.as_deref(), Some(rack));
    }
}

/// CiA 306-1 chapter 6: PDOs end before what no module brought, and do not exist where that is the first.
#[test]
fn default_mappings_end_before_what_is_missing() {
    let mut text = String::from(
        "[SupportedModules]\nNrOfEntries=1\n[M1ModuleInfo]\nProductName=16 DI\n[M1SubExtends]\nNrOfEntries=1\n1=0x6000\n[M1SubExt6000]\nParameterName=Inputs\nDataType=0x0005\nAccessType=ro\nPDOMapping=1\nCount=2\n",
    );
    for (pdo, first) in [(0, 1), (2, 9)] {
        text.push_str(&format!("[18{pdo:02X}]\nObjectType=9\n[18{pdo:02X}sub1]\nDataType=7\nAccessType=rw\nDefaultValue=$NODEID+0x180\n[1A{pdo:02X}]\nObjectType=9\n[1A{pdo:02X}sub0]\nDataType=5\nAccessType=rw\nDefaultValue=8\n"));
        for slot in 0..8 {
            text.push_str(&format!(
                "[1A{pdo:02X}sub{}]\nDataType=7\nAccessType=rw\nDefaultValue=0x6000{:02X}08\n",
                slot + 1,
                first + slot
            ));
        }
    }
    let coupler = format::read(SourceFile::from_text("coupler.eds", text), Format::Eds);
    let plugged = flatten(coupler.device(), &[1, 1]).unwrap();
    let pdo = |number| plugged.pdo(objdict::model::PdoKind::Tpdo, number).unwrap();
    assert_eq!((pdo(1).mapped_count, pdo(1).is_valid()), (Some(4), Some(true)));
    assert_eq!((pdo(3).mapped_count, pdo(3).is_valid()), (Some(0), Some(false)));
}

#[test]
fn modules_that_cannot_be_plugged_in() {
    let coupler = open("eds/coupler-modular.eds");
    let unknown = flatten(coupler.device(), &[1, 6, 7]).unwrap_err();
    let known = vec![1, 2, 3, 4, 5];
    let expected = [6, 7].map(|number| ModuleProblem::Unknown { number, known: known.clone() });
    assert_eq!(unknown, expected);
    let simple = open("eds/io-401.eds");
    assert_eq!(flatten(simple.device(), &[1]), Err(vec![ModuleProblem::NotModular]));
}

#[test]
fn elements_go_on_in_the_next_object() {
    let coupler = open("eds/coupler-modular.eds");
    // eight bits of each module, 128 in an object
    let many = flatten(coupler.device(), &[1; 60]).unwrap();
    let elements = |index| many.object(index).map(|object| object.subs.len() - 1);
    let expected = [Some(128), Some(128), Some(128), Some(96), None];
    assert_eq!([0x6020, 0x6021, 0x6022, 0x6023, 0x6024].map(elements), expected);
    // and no further than to what is another object
    let mut taken = coupler.device().clone();
    let inputs = taken.objects[&0x6000].clone();
    taken.objects.insert(0x6021, inputs);
    let no_room = ModuleProblem::NoRoom { number: 1, index: 0x6020, next: 0x6021 };
    assert_eq!(flatten(&taken, &[1; 17]), Err(vec![no_room]));
}

/// Each element of 1027h is the number of its module, so modules that bring one differ in its default.
#[test]
fn modules_name_themselves_in_the_module_list() {
    let mut text = String::from(
        "[SupportedModules]\nNrOfEntries=2\n[1027]\nObjectType=8\nSubNumber=1\n\
         [1027sub0]\nDataType=5\nAccessType=const\nDefaultValue=0\n",
    );
    for (number, product) in [(1, 0x0A10), (2, 0x0B20)] {
        text.push_str(&format!(
            "[M{number}ModuleInfo]\nProductName=DI\n[M{number}SubExtends]\nNrOfEntries=1\n1=0x1027\n\
             [M{number}SubExt1027]\nParameterName=Module\nDataType=6\nAccessType=ro\nDefaultValue={product}\nCount=1\n"
        ));
    }
    let coupler = format::read(SourceFile::from_text("coupler.eds", text), Format::Eds);
    assert!(objdict::check(&coupler).iter().all(|finding| finding.rule.id != "cia306/module-conflict"));
    let plugged = flatten(coupler.device(), &[2, 1, 2]).unwrap();
    let list = plugged.object(0x1027).unwrap();
    let numbers: Vec<_> = (0..=3).map(|sub| list.value(sub).and_then(|value| value.as_integer())).collect();
    assert_eq!(numbers, [Some(3), Some(0x0B20), Some(0x0A10), Some(0x0B20)]);
}

/// Each line of a text spelled in another way: section names, and keys with their values.
fn respelled(text: &str, name: impl Fn(&str) -> String, item: impl Fn(&str, &str) -> String) -> String {
    let line = |line: &str| match (line.strip_prefix('[').and_then(|line| line.strip_suffix(']')), line) {
        (Some(section), _) => format!("[{}]\n", name(section)),
        (None, line) => match line.split_once('=') {
            Some((key, value)) => format!("{}\n", item(key, value)),
            None => format!("{line}\n"),
        },
    };
    text.lines().map(line).collect()
}

/// Numbers that give the size of a module, in another notation; all other values as they are.
fn counted(key: &str, value: &str, number: impl Fn(u32) -> String) -> String {
    let is_list = key.bytes().all(|byte| byte.is_ascii_digit());
    let is_count =
        matches!(key, "Count" | "ObjExtend" | "NrOfEntries" | "SubNumber" | "ObjectType" | "DataType");
    let spelled = |text: &str| match text.strip_prefix("0x") {
        Some(digits) => u32::from_str_radix(digits, 16).map(&number).unwrap(),
        None => text.parse().map(&number).unwrap(),
    };
    match is_list || is_count {
        true => format!("{key}={}", value.split(';').map(spelled).collect::<Vec<_>>().join(";")),
        false => format!("{key}={value}"),
    }
}

/// Whether a section with this name is one of a module.
fn is_module(name: &str) -> bool {
    name.strip_prefix('M').is_some_and(|rest| rest.starts_with(|first: char| first.is_ascii_digit()))
}

/// The sections of modules behind all others, the last one first.
fn reversed(text: &str) -> String {
    let sections: Vec<String> = text.split("\n[").skip(1).map(|section| format!("[{section}\n")).collect();
    let (modules, mut others): (Vec<String>, Vec<String>) =
        sections.into_iter().partition(|section| is_module(&section[1..]));
    others.extend(modules.into_iter().rev());
    others.concat()
}

/// Section names, keys and numbers are spelled in many ways; the dictionary is the same.
#[test]
fn modules_are_the_same_however_they_are_spelled() {
    let coupler = open("eds/coupler-modular.eds");
    let text = coupler.source().text();
    let plain = |key: &str, value: &str| format!("{key}={value}");
    let hex = |value: &str| if value.starts_with("0x") { value.to_lowercase() } else { value.to_owned() };
    let spellings = [
        respelled(text, str::to_uppercase, |key, value| format!("{}={value}", key.to_uppercase())),
        respelled(text, str::to_lowercase, |key, value| format!("{}={}", key.to_lowercase(), hex(value))),
        respelled(text, str::to_owned, |key, value| counted(key, value, |number| format!("0x{number:02x}"))),
        respelled(text, str::to_owned, |key, value| counted(key, value, |number| number.to_string())),
        respelled(text, str::to_owned, |key, value| counted(key, value, |number| format!("0{number:o}"))),
        respelled(text, str::to_owned, |key, value| format!("  {key} = {value}  ")),
        respelled(text, |name| name.replace("sub", "Sub0"), plain),
        respelled(
            text,
            |name| if is_module(name) { format!(" M00{} ", &name[1..]) } else { name.into() },
            plain,
        ),
        respelled(text, |name| name.replace("SubExt6", "SubExt0x6").replace("Fixed2", "Fixed0x2"), plain),
        text.replace("\n", "\r\n"),
        reversed(text),
    ];
    let racks: [&[u16]; 5] = [&[1], &[4, 4, 4], &[1, 1, 2, 3], &[5, 4, 3, 2, 1], &[1; 17]];
    for spelling in spellings {
        assert_ne!(spelling, text);
        let other = format::read(SourceFile::from_text("coupler.eds", spelling.clone()), Format::Eds);
        for rack in racks {
            let expected = flatten(coupler.device(), rack).unwrap();
            let plugged = flatten(other.device(), rack).unwrap();
            for (index, object) in &expected.objects {
                assert_eq!(plugged.object(*index), Some(object), "{rack:?} of\n{}", &spelling[..120]);
            }
            assert_eq!((plugged.objects.len(), &plugged.lists), (expected.objects.len(), &expected.lists));
        }
    }
}

/// Whatever is configured of a healthy device, the linter finds no new error in.
#[test]
fn settings_bring_no_errors() {
    let eds = open("eds/io-401.eds");
    let settings = [Setting::map("tpdo1=6000:1,6401:1").unwrap(), Setting::cob_id("tpdo2=off").unwrap()];
    let dcf = configured(&eds, 5, &settings);
    let findings = lint::check(dcf.device(), &{
        let mut options = Options::default();
        options.node_id = Some(5);
        options
    });
    assert!(!findings.has_errors(), "{findings:?}");
}

//! DBC files of fixtures.

use objdict::document::dbc::{self, BusNode, DbcOptions};
use objdict::format::{self, Format};
use objdict::model::{
    ApplicationProcess, DataTypeRef, Device, Labels, Objects, Parameter, SimpleType, TypeDefinition,
    TypeShape, Unit, Value, VarDeclaration,
};
use objdict::network::DcfgenMode;
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn device(file: &str) -> Device {
    format::open(&support::fixtures().join(file), &SourceOptions::default()).unwrap().device().clone()
}

fn node(device: &Device, node_id: u8) -> BusNode<'_> {
    BusNode { device, node_id, name: None, is_counterpart: false }
}

/// A DBC, and what it does not have.
fn shown(nodes: &[BusNode<'_>], options: DbcOptions) -> String {
    let written = dbc::write(nodes, options);
    let text: String = written.bytes.iter().map(|&byte| char::from(byte)).collect();
    let omissions = written.omissions.iter().map(|omission| {
        let fate = if omission.is_lost { "lost" } else { "left out" };
        format!("node {}: {fate}: {}: {}\n", omission.node, omission.place, omission.reason)
    });
    format!("{}\n{}", text.replace("\r\n", "\n"), omissions.collect::<String>())
}

#[test]
fn a_network() {
    let [io, drive] = ["dcf/io-401-node5.dcf", "dcf/drive-402-node8.dcf"].map(device);
    let nodes = [(&io, 5), (&drive, 8)].map(|(device, node_id)| node(device, node_id));
    insta::assert_snapshot!(shown(&nodes, DbcOptions::default()));
}

/// The effective nodes of a network, and a manager without a description, which has the other side of their PDOs.
#[test]
fn a_network_file() {
    let nodes =
        super::network::open("line.toml").build(DcfgenMode::Corrected).unwrap().configured_nodes().unwrap();
    let bus = nodes.iter().map(|node| BusNode {
        device: &node.device,
        node_id: node.node_id,
        name: Some(&node.name),
        is_counterpart: node.is_made,
    });
    let text = shown(&bus.collect::<Vec<_>>(), DbcOptions::default());
    let is_shown = |line: &&str| {
        let of_services =
            ["_EMCY", "_heartbeat", "CM_", "VAL_", "BA_DEF", "SG_ Error", "SG_ State", "node 3: "];
        !line.trim().is_empty() && !of_services.iter().any(|part| line.contains(part))
    };
    insta::assert_snapshot!(text.lines().filter(is_shown).collect::<Vec<_>>().join("\n"));
}

#[test]
fn bits_and_scales_of_an_xdd() {
    let mut press = device("xdd/press-402.xdd");
    // a PDO for what it measures: 2000h is scaled
    let mapping = press.objects.get_mut(&0x1A01).unwrap();
    mapping.subs.get_mut(2).unwrap().default = Some(Value::Unsigned(0x2000_0020));
    let node = BusNode { name: Some("press"), ..node(&press, 3) };
    insta::assert_snapshot!(shown(&[node], DbcOptions { bits: true, sdo: false }));
}

/// Entries refer to a parameter that others refer to too, or to a member of a struct; a bit field is a member itself.
#[test]
fn units_and_scales_of_shared_parameters_and_members() {
    let unit = |name: &str| Some(Unit { labels: Labels::name("en", name), ..Unit::default() });
    let member = |id: &str, bits: &str, name: &str| VarDeclaration {
        name: id.into(),
        unique_id: id.into(),
        size: Some(bits.into()),
        data_type: Some(DataTypeRef::Simple(SimpleType::Bitstring)),
        multiplier: Some("0.25".into()),
        offset: Some("-8".into()),
        unit: unit(name),
        ..VarDeclaration::default()
    };
    let members = vec![member("Low", "12", "bar"), member("High", "4", "mm")];
    let word = TypeDefinition {
        unique_id: "word".into(),
        shape: TypeShape::Struct { members },
        ..TypeDefinition::default()
    };
    let parameter = |id: &str, data_type: DataTypeRef, name: &str| Parameter {
        unique_id: id.into(),
        data_type: Some(data_type),
        multiplier: Some("0.5".into()),
        unit: unit(name),
        ..Parameter::default()
    };
    let process = ApplicationProcess {
        data_types: vec![word],
        parameters: vec![
            parameter("shared", DataTypeRef::Simple(SimpleType::Uint), "K"),
            parameter("split", DataTypeRef::Defined("word".into()), "%"),
        ],
        ..ApplicationProcess::default()
    };
    for (id, bits, expected) in [
        ("shared", false, vec!["(0.5,0) [0|0] \"K\""]),
        ("Low", false, vec!["(0.25,-2) [0|0] \"bar\""]),
        ("split", true, vec!["(0.25,-2) [0|0] \"bar\"", "(0.25,-2) [0|0] \"mm\""]),
    ] {
        let mut device = device("eds/minimal.eds");
        device.objects.extend(device_of_one_tpdo());
        device.application = vec![process.clone()];
        device.objects.get_mut(&0x2000).unwrap().main.extra.push("uniqueIDRef", id);
        let node = BusNode { name: Some("n"), ..node(&device, 3) };
        let text = shown(&[node], DbcOptions { bits, sdo: false });
        let found: Vec<&str> =
            text.lines().filter(|line| line.contains(" SG_ Pressure")).filter_map(scale_and_unit).collect();
        assert_eq!(found, expected, "{id}: {text}");
    }
}

/// `(0.5,0) [0|0] "K"` of a line.
fn scale_and_unit(line: &str) -> Option<&str> {
    Some(&line[line.find('(')?..=line.rfind('"')?])
}

/// TPDO 1 with 2000h, a word.
fn device_of_one_tpdo() -> Objects {
    let text = "[1800]\nObjectType=9\n[1800sub0]\nDataType=5\nDefaultValue=2\n[1800sub1]\nDataType=7\nDefaultValue=$NODEID+0x180\n\
        [1800sub2]\nDataType=5\nDefaultValue=255\n[1A00]\nObjectType=9\n[1A00sub0]\nDataType=5\nDefaultValue=1\n\
        [1A00sub1]\nDataType=7\nDefaultValue=0x20000010\n[2000]\nParameterName=Pressure\nDataType=6\n";
    format::read(SourceFile::from_text("pdo.eds", text), Format::Eds).into_device().objects
}

/// The event timer of a PDO that is sent on request is no cycle.
#[test]
fn pdos_on_request_have_no_cycle() {
    let mut device = device("eds/io-401.eds");
    for (transmission, has_cycle) in [(252_u8, false), (253, false), (254, true)] {
        let communication = device.objects.get_mut(&0x1801).unwrap();
        for (sub, value) in [(2, transmission.into()), (5, 1000)] {
            communication.subs.get_mut(sub).unwrap().default = Some(Value::Unsigned(value));
        }
        let text = shown(&[node(&device, 5)], DbcOptions::default());
        assert_eq!(text.contains("BA_ \"GenMsgCycleTime\" BO_ 645 1000;"), has_cycle, "{text}");
    }
}

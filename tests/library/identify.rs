//! Files are known by their content, independent of their name, encoding or corruption.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use objdict::download::{ConciseDcf, Download};
use objdict::format::identify::{ContentKind, Identification, identify, identify_source, is_node_list};
use objdict::format::input::Reading;
use objdict::format::{self, Format, ReadError, json};
use objdict::source::{SourceFile, SourceOptions};
use proptest::prelude::*;

/// What the files of fixtures/foreign are, and the technology that they belong to.
const FOREIGN: [(&str, ContentKind, Option<&str>); 20] = [
    ("bus.yml", ContentKind::BusConfiguration, Some("CANopen")),
    ("canopen-fd.xdd", ContentKind::CanopenFdXdd, Some("CANopen FD")),
    ("canopennode-project.xml", ContentKind::CanopenNodeProject, Some("CANopen")),
    ("devicenet.eds", ContentKind::CipEds, Some("DeviceNet")),
    ("empty.txt", ContentKind::Unknown, None),
    ("ethercat.xml", ContentKind::EthercatEsi, Some("EtherCAT")),
    ("ethernet-ip.eds", ContentKind::CipEds, Some("EtherNet/IP")),
    ("fpga-all-comments.xdc", ContentKind::FpgaConstraints, Some("Vivado")),
    ("fpga.xdc", ContentKind::FpgaConstraints, Some("Vivado")),
    ("io-link.xml", ContentKind::Iodd, Some("IO-Link")),
    ("j1939.dbc", ContentKind::Dbc, None),
    ("network.nxdd", ContentKind::NetworkXdd, Some("CANopen")),
    ("other-profile.xml", ContentKind::OtherProfile, Some("Modbus TCP")),
    ("page.html", ContentKind::OtherXml, None),
    ("powerlink.cdc", ContentKind::PowerlinkConcise, Some("Ethernet POWERLINK")),
    ("powerlink.xdc", ContentKind::PowerlinkXdc, Some("Ethernet POWERLINK")),
    ("powerlink.xdd", ContentKind::PowerlinkXdd, Some("Ethernet POWERLINK")),
    ("profibus.gsd", ContentKind::Gsd, Some("PROFIBUS")),
    ("profinet.xml", ContentKind::Gsdml, Some("PROFINET")),
    ("README.md", ContentKind::Unknown, None),
];

fn files(folder: &str) -> BTreeMap<String, PathBuf> {
    let entries = fs::read_dir(Path::new("fixtures").join(folder)).unwrap();
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    entries.map(|entry| entry.unwrap().path()).map(|path| (name(&path), path)).collect()
}

fn fixture(path: &str) -> Vec<u8> {
    fs::read(Path::new("fixtures").join(path)).unwrap()
}

fn kind(name: &str, text: &str) -> ContentKind {
    identify(name, text.as_bytes()).kind
}

/// The bytes of a text in UTF-16 with its mark.
fn utf16(text: &str, to_bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    std::iter::once(0xFEFF).chain(text.encode_utf16()).flat_map(to_bytes).collect()
}

#[test]
fn foreign_files_are_known_whatever_they_are_called() {
    let files = files("foreign");
    assert_eq!(files.len(), FOREIGN.len(), "every file is in the table");
    for (name, kind, technology) in FOREIGN {
        let bytes = fs::read(&files[name]).unwrap();
        let found = identify(name, &bytes);
        assert_eq!((found.kind, found.technology.as_deref()), (kind, technology), "{name}: {found}");
        // the name decides first between XDC and XDD
        let other = identify("drive.eds", &bytes);
        let is_powerlink = matches!(kind, ContentKind::PowerlinkXdd | ContentKind::PowerlinkXdc);
        assert!(other.kind == kind || is_powerlink, "{name} called .eds: {other}");
    }
}

#[test]
fn a_network_of_one_node_is_known_in_every_style() {
    let block = "master:\n  node_id: 1\na:\n  node_id: 5\n  dcf: servo.eds\n";
    for text in [block, "master: {node_id: 1}\na: {node_id: 5, dcf: servo.eds}\n"] {
        for name in ["bus.yml", "x"] {
            assert_eq!(kind(name, text), ContentKind::BusConfiguration, "{name}: {text}");
        }
    }
}

#[test]
fn devices_are_known_without_a_name() {
    for (name, path) in files("eds") {
        let found = identify("", &fs::read(path).unwrap());
        assert_eq!(found.kind, ContentKind::Eds, "{name}: {found}");
    }
    let mut nodes = Vec::new();
    for (name, path) in files("dcf") {
        let found = identify("", &fs::read(path).unwrap());
        // the data of a DOMAIN
        let expected = if name.ends_with(".bin") { ContentKind::Unknown } else { ContentKind::Dcf };
        assert_eq!(found.kind, expected, "{name}: {found}");
        nodes.extend(found.node_id);
    }
    assert_eq!(nodes, [10, 8, 3, 5, 1]);
    assert_eq!(identify("", &fixture("nodelist/line.cpj")).kind, ContentKind::NodeList);
}

#[test]
fn details_of_an_eds() {
    let found = identify("x.eds", b"[FileInfo]\nEDSVersion=4.0\n[DeviceInfo]\n[MandatoryObjects]\n[1000]\n");
    assert_eq!(
        found.to_string(),
        "EDS 4.0 (CANopen) – it has the sections `[FileInfo]`, `[DeviceInfo]` and `[MandatoryObjects]`"
    );
    // what each node of POWERLINK has may be as far behind; one of both may be an oddity
    let objects = |both: &str| format!("[DeviceInfo]\n[1000]\n{}[1F93]\r\n{both}", "; \n".repeat(100_000));
    let found = identify("x.eds", objects("[1F98]\r\n").as_bytes());
    assert_eq!(found.kind, ContentKind::PowerlinkEds);
    assert_eq!(
        found.to_string(),
        "EDS (Ethernet POWERLINK) – only Ethernet POWERLINK has objects in `[1F93]` and `[1F98]`"
    );
    assert_eq!(kind("x.eds", &objects("; [1F98]\r\n")), ContentKind::Eds);
    // the section of the node may be the last one, far behind what is looked at line by line
    let long = format!("[DeviceInfo]\n[2000]\n{}[DeviceComissioning]\nNodeID=0x7F\n", "; \n".repeat(100_000));
    let found = identify("", long.as_bytes());
    assert_eq!((found.kind, found.node_id), (ContentKind::Dcf, Some(127)));
    assert_eq!(kind("", "[DeviceInfo]\n[2000]\n; see [DeviceComissioning]\n"), ContentKind::Eds);
}

#[test]
fn our_json_is_known() {
    let description = format::open(Path::new("fixtures/eds/minimal.eds"), &SourceOptions::default()).unwrap();
    let device = json::write_device(description.device());
    assert_eq!(kind("", &device), ContentKind::JsonDevice);
    let configuration = ConciseDcf(vec![Download::new(0x1017, 0, [0xFA, 0])]);
    assert_eq!(kind("", &json::write_configuration(&configuration)), ContentKind::JsonConciseDcf);
    assert_eq!(identify("", &configuration.write().unwrap()).kind, ContentKind::ConciseDcf);
    assert_eq!(kind("", "{\"kind\": \"device\"}"), ContentKind::Unknown);
}

#[test]
fn between_an_eds_and_a_dcf_the_name_decides() {
    let (eds, dcf) = ("[DeviceInfo]\n[1000]\n", "[DeviceInfo]\n[DeviceCommissioning]\nNodeID=5\n[1000]\n");
    for (name, text, expected) in [
        ("a.eds", eds, ContentKind::Eds),
        ("a.dcf", eds, ContentKind::Dcf),
        ("a.DCF.in", eds, ContentKind::Dcf),
        ("a.txt", eds, ContentKind::Eds),
        ("a.eds", dcf, ContentKind::Eds),
        ("a.dcf", dcf, ContentKind::Dcf),
        ("a.xdd", dcf, ContentKind::Dcf),
        ("folder.eds/a", dcf, ContentKind::Dcf),
        ("<stdin>", dcf, ContentKind::Dcf),
    ] {
        let found = identify(name, text.as_bytes());
        assert_eq!(found.kind, expected, "{name}: {found}");
        let named =
            name.ends_with("eds") && text == dcf || name.to_lowercase().contains("dcf") && text == eds;
        assert_eq!(found.reason.contains("but the name suggests"), named, "{name}: {found}");
    }
}

const XDD: &str = r#"<ISO15745ProfileContainer xmlns="http://www.canopen.org/xml/1.1"><ISO15745Profile>
<ProfileBody xmlns:q1="http://www.canopen.org/xml/1.1" xsi:type="q1:ProfileBody_Device_CANopen"/></ISO15745Profile>"#;

#[test]
fn xml_of_canopen() {
    let details = |name: &str, text: &str| {
        let found = identify(name, text.as_bytes());
        (found.kind, found.version, found.node_id)
    };
    let version = |text: &str| Some(text.to_owned());
    assert_eq!(details("a.xml", XDD), (ContentKind::Xdd, version("1.1"), None));
    assert_eq!(details("a.xpd", XDD), (ContentKind::Xpd, version("1.1"), None));
    assert_eq!(details("a.xdc", XDD), (ContentKind::Xdc, version("1.1"), None));
    let old = XDD.replace("1.1", "1.0");
    assert_eq!(details("a.eds", &old), (ContentKind::Xdd, version("1.0"), None));
    let node = format!("{XDD}<q1:deviceCommissioning nodeName=\"a\" nodeID = '12'/>");
    assert_eq!(details("a.xml", &node), (ContentKind::Xdc, version("1.1"), Some(12)));
    assert_eq!(details("a.xdd", &node), (ContentKind::Xdd, version("1.1"), None));
    let value = format!("{XDD}<CANopenObject index=\"1000\" actualValue=\"1\"/>");
    assert_eq!(details("a", &value), (ContentKind::Xdc, version("1.1"), None));
    let profile = XDD.replace("xsi:type", "fileName=\"a.xpd\" xsi:type");
    assert_eq!(details("a.xml", &profile).0, ContentKind::Xpd);
    assert_eq!(details("a.xdd", &profile).0, ContentKind::Xdd);
}

#[test]
fn xml_is_known_behind_what_stands_before_it() {
    let prolog = "<?xml version=\"1.0\"?><!-- <EtherCATInfo> --><?style sheet?>\
                  <!DOCTYPE a [<!ENTITY b \"<EtherCATInfo>\">]>\n";
    assert_eq!(kind("", &format!("{prolog}{XDD}")), ContentKind::Xdd);
    assert_eq!(kind("", &format!("\n \u{FEFF}\n{XDD}")), ContentKind::Xdd);
    assert_eq!(kind("", &format!("Exported by a tool\n<?xml version=\"1.0\"?>{XDD}")), ContentKind::Xdd);
    let prefixed = XDD.replace("xmlns=", "xmlns:c=").replace("<ISO", "<c:ISO");
    let found = identify("", prefixed.as_bytes());
    assert_eq!(
        (found.kind, found.namespace.as_deref()),
        (ContentKind::Xdd, Some("http://www.canopen.org/xml/1.1"))
    );
    let damaged = XDD.replace("<ISO15745Profile>", "<ISO15745Profile a=1 a=\"2\"></x>&nothing; & <");
    assert_eq!(kind("", &damaged), ContentKind::Xdd);
    // without namespace, type and technology, the objects show it
    let bare = "<ISO15745ProfileContainer><CANopenObjectList/>";
    assert_eq!(kind("", bare), ContentKind::Xdd);
    assert_eq!(kind("", "<ISO15745ProfileContainer/>"), ContentKind::OtherXml);
}

#[test]
fn networks_count_their_devices() {
    let bytes = fixture("foreign/network.nxdd");
    let found = identify("a.nxdd", &bytes);
    assert_eq!((found.devices, found.version.as_deref()), (Some(2), Some("1.1")));
    assert_eq!(found.namespace.as_deref(), Some("http://www.canopen.org/xml/1.1"));
    assert_eq!(identify("a.nxdc", &bytes).kind, ContentKind::NetworkXdc);
    assert_eq!(identify("a.cpj", &bytes).kind, ContentKind::NetworkXdd);
}

#[test]
fn every_encoding_is_taken() {
    let mut texts: Vec<(String, Vec<u8>)> = Vec::new();
    for folder in ["foreign", "eds", "dcf", "nodelist"] {
        texts.extend(files(folder).into_iter().map(|(name, path)| (name, fs::read(path).unwrap())));
    }
    let mut count = 0;
    for (name, bytes) in texts {
        let Ok(text) = String::from_utf8(bytes.clone()) else { continue };
        if text.contains('\0') {
            continue;
        }
        count += 1;
        let expected = identify(&name, &bytes);
        let with_mark = [b"\xEF\xBB\xBF", bytes.as_slice()].concat();
        let encoded = [with_mark, utf16(&text, u16::to_le_bytes), utf16(&text, u16::to_be_bytes)];
        for (number, bytes) in encoded.into_iter().enumerate() {
            assert_eq!(identify(&name, &bytes), expected, "{name}, encoding {number}");
            let source = SourceFile::from_bytes(&name, bytes, &SourceOptions::default()).unwrap();
            assert_eq!(identify_source(&source), expected, "{name}, encoding {number}, opened");
        }
    }
    assert!(count > 30, "{count} texts");
    let unmarked: Vec<u8> = utf16(XDD, u16::to_le_bytes).split_off(2);
    assert_eq!(identify("", &unmarked).kind, ContentKind::Xdd);
}

/// A malformed file is read as the format of its name if it has the syntax of it, because it must be checked and not
/// rejected; what has not even that is refused.
#[test]
fn damaged_files_are_not_refused() {
    for folder in ["broken", "torture"] {
        for (name, path) in files(folder) {
            let Some(format) = Format::from_name(&name) else { continue };
            let description = format::open(&path, &SourceOptions::default()).unwrap();
            assert_eq!(description.format(), format, "{name}");
        }
    }
    let read_as = |name: &str, text: &str| {
        let (kind, _) = Reading::default().recognised(name, text.into()).ok()?;
        kind.format()
    };
    assert_eq!(read_as("a.dcf", "[A]\nx=1\n"), Some(Format::Dcf));
    for (name, text) in [
        ("a.eds", ""),
        ("a.eds", "nothing but words"),
        ("a.eds", "two words = prose\n"),
        ("a.eds", "\u{89}PNG\r\n\x1A\n\0\0[IHDR]\n"),
        ("a.eds", "<<<<<<< HEAD\n"),
        ("a.txt", "[A]\nx=1\n"),
        ("a.xdd", ""),
        ("a.xdc", "\0\0"),
    ] {
        assert_eq!(read_as(name, text), None, "{name}: {text:?}");
    }
    assert_eq!(read_as("a.eds", "<<<<<<< HEAD\n[FileInfo]\n=======\n"), Some(Format::Eds));
    assert_eq!(read_as("a.eds", "<a@example.com> wrote:\n[DeviceInfo]\n"), Some(Format::Eds));
    for text in ["<?xml version=\"1.0\"?>\n", "<ISO15745ProfileContainer>\n", "<ISO15745ProfileContainer"] {
        assert_eq!(read_as("a.xdd", text), Some(Format::Xdd), "{text}");
        assert_eq!(read_as("a.xdc", text), Some(Format::Xdc), "{text}");
    }
    assert_eq!(read_as("a.eds", "<?xml version=\"1.0\"?>\n"), None);
    assert_eq!(read_as("a.xdd", "<html>\n"), None);
    assert_eq!(read_as("a.eds", XDD), Some(Format::Xdd));
    assert_eq!(read_as("a.xdd", "[DeviceInfo]\n"), Some(Format::Eds));
}

#[test]
fn what_is_foreign_is_refused_in_one_sentence() {
    let folder = tempfile::tempdir().unwrap();
    for (name, kind, _) in FOREIGN {
        if kind == ContentKind::Unknown || kind.format().is_some() {
            continue;
        }
        let path = folder.path().join("drive.eds");
        fs::write(&path, fixture(&format!("foreign/{name}"))).unwrap();
        let error = format::open(&path, &SourceOptions::default()).unwrap_err();
        let message = error.to_string();
        assert!(message.starts_with(&format!("`{}` ", path.display())), "{message}");
        assert!(!message.contains('\n') && !message.ends_with('.'), "{message}");
        assert!(error.help().is_some(), "{message}");
        assert!(matches!(error, ReadError::Foreign { .. }), "{message}");
    }
}

#[test]
fn words_alone_are_no_sign() {
    for text in [
        "port: 8080\nmaster: yes\ndriver: none\n",
        "[Device]\nName=x\n[File]\nName=y\n",
        "set_property is a command of Tcl\n",
        "BO_ but no version\n",
        "; #Profibus_DP\nVERSION \"\"\n",
        "\u{1}\u{0}\u{0}\u{0}text\u{0}",
    ] {
        let found = identify("a", text.as_bytes());
        assert_eq!(found.kind, ContentKind::Unknown, "{text:?}: {found}");
    }
}

/// A cut file is known or not, and nothing happens.
#[test]
fn every_cut_of_every_file() {
    for folder in ["foreign", "dcf", "nodelist"] {
        for (name, path) in files(folder) {
            let bytes = fs::read(path).unwrap();
            // all lengths of the small ones
            let step = bytes.len() / 1000;
            let step = if step < 2 { 1 } else { step * 10 };
            for length in (0..bytes.len()).step_by(step) {
                check_clauses(&identify(&name, &bytes[..length]));
                check_clauses(&identify("", &bytes[length..]));
            }
        }
    }
}

/// What is said fits on a line and does not steer a terminal.
fn check_clauses(found: &Identification) {
    for text in [found.to_string(), found.verdict().into_owned()] {
        assert!(!text.chars().any(char::is_control) && text.len() < 1000, "{text:?}");
    }
}

proptest! {
    #[test]
    fn any_bytes_are_something(name in "[a-z.]{0,8}", bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        check_clauses(&identify(&name, &bytes));
    }

    /// Pieces of real files in any order, so that every scanner is reached.
    #[test]
    fn any_pieces_are_something(
        name in prop::sample::select(vec!["a.eds", "a.xdc", "a.yml", "a.nxdd", "a"]),
        pieces in prop::collection::vec(prop::sample::select(PIECES.to_vec()), 0..12),
    ) {
        check_clauses(&identify(name, pieces.concat().as_bytes()));
        let source = SourceFile::from_text(name, pieces.concat());
        prop_assert_eq!(is_node_list(&source), identify_source(&source).kind == ContentKind::NodeList);
    }
}

const PIECES: [&str; 34] = [
    "<",
    ">",
    "/>",
    "\"",
    "'",
    "=",
    ":",
    "\n",
    "[",
    "]",
    "\0",
    "\u{1F}é",
    "<?xml ",
    "?>",
    "<!--",
    "-->",
    "<!DOCTYPE a [",
    "<ISO15745ProfileContainer",
    " xmlns=\"a\"",
    " xsi:type=\"p:CANopen\"",
    "<ProfileTechnology>",
    "Powerlink",
    "<q:deviceCommissioning nodeID=\"",
    "CANopenObject",
    "[DeviceInfo]\n",
    "[Topology]\n",
    " [topology2",
    "[DeviceComissioning]\nNodeID=",
    "[1000]\n",
    "{\"version\":1,\"kind\":\"device",
    "set_property get_ports",
    "dcf: a\nnode_id: 1\nrpdo:",
    "VERSION \"\"\nBO_ 1",
    "#Profibus_DP",
];

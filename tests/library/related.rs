//! Findings about networks point at what the descriptions of their nodes say.

use std::fs;
use std::path::Path;

use objdict::diagnostic::{At, Diagnostic};
use objdict::format::json;
use objdict::format::network::NetworkFile;
use objdict::report::{Location, Subject, fingerprints};

use crate::network::new_folder;
use crate::{rules, support};

const NETWORK: &str = "[bus]\nbit-rate = 125\nmanager = \"plc\"\n[node.plc]\nfile = \"plc.eds\"\nid = 1\n\
    [node.drive]\nfile = \"drive.eds\"\nid = 5\n";

/// A description from `fixtures/network` with these values, `1800sub1=0x6E0` and so on; a section that it does not have is
/// added.
fn described(name: &str, values: &str) -> String {
    let mut text =
        fs::read_to_string(support::fixtures().join("network").join(name)).unwrap().replace("\r\n", "\n");
    for value in values.split_whitespace() {
        let (section, value) = value.split_once('=').unwrap();
        let header = format!("[{section}]\n");
        match section {
            "NodeID" | "Baudrate" => text.push_str(&format!("[DeviceComissioning]\n{section}={value}\n")),
            _ if text.contains(&header) => {
                text = text.replacen(&header, &format!("{header}ParameterValue={value}\n"), 1);
            }
            _ => text.push_str(&format!(
                "{header}ParameterName=Added\nObjectType=8\nDataType=7\nAccessType=rw\nCompactSubObj=127\n\
                [{section}Value]\nNrOfEntries=1\n5={value}\n"
            )),
        }
    }
    text
}

/// A controller and a drive, whose descriptions have values of their own, in a folder.
fn open(folder: &Path, drive: &str, plc: &str, network: &str) -> NetworkFile {
    fs::write(folder.join("drive.eds"), described("counter.eds", drive)).unwrap();
    fs::write(folder.join("plc.eds"), described("plc.eds", plc)).unwrap();
    let path = folder.join("network.toml");
    fs::write(&path, network).unwrap();
    NetworkFile::open(&path, &Default::default()).unwrap()
}

/// The related places of a finding in descriptions, a line each.
fn places(file: &NetworkFile, finding: &Diagnostic) -> Vec<String> {
    let labels = finding.labels.iter().filter(|label| matches!(label.at, At::Node(..)));
    let line = |location: Location<'_>| {
        let file = rules::name(location.source.name().as_ref());
        let text = location.span.of(location.source.text());
        format!("{file} {} `{text}`: {}", location.place.unwrap(), location.text)
    };
    labels.map(|label| line(Location::new(Subject::Network(file), label))).collect()
}

/// What the descriptions say, what the network adds to the drive, and the places that a finding has.
type Row = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

const ROWS: &[Row] = &[
    (
        "1017=100 100C=50 100D=2",
        "",
        "",
        "heartbeat-and-guarding",
        &[
            "drive.eds 0x1017 / ParameterValue `100`: the heartbeat time",
            "drive.eds 0x100C / ParameterValue `50`: the guard time",
            "drive.eds 0x100D / ParameterValue `2`: the life time factor",
        ],
    ),
    // what the network file states is no matter of the description
    (
        "1017=100 100C=50 100D=2",
        "",
        "heartbeat = \"200ms\"",
        "heartbeat-and-guarding",
        &[
            "drive.eds 0x100C / ParameterValue `50`: the guard time",
            "drive.eds 0x100D / ParameterValue `2`: the life time factor",
        ],
    ),
    (
        "1016sub1=0x00090064",
        "",
        "",
        "silent-node",
        &["drive.eds 0x1016sub1 / ParameterValue `0x00090064`: the consumer heartbeat time"],
    ),
    (
        "1016sub1=0x00050064",
        "",
        "",
        "silent-node",
        &["drive.eds 0x1016sub1 / ParameterValue `0x00050064`: the consumer heartbeat time"],
    ),
    (
        "1016sub1=0x00060064 1017=90",
        "",
        "[node.copy]\nfile = \"drive.eds\"\nid = 6",
        "short-heartbeat-time",
        &[
            "drive.eds 0x1016sub1 / ParameterValue `0x00060064`: the consumer heartbeat time",
            "drive.eds 0x1017 / ParameterValue `90`: the producer heartbeat time",
        ],
    ),
    (
        "1017=30000",
        "",
        "",
        "no-heartbeat-consumer",
        &["drive.eds 0x1017 / ParameterValue `30000`: the heartbeat time"],
    ),
    (
        "1016sub1=0x00090064 1016sub2=0x000A0064",
        "",
        "watches = { plc = \"500ms\" }",
        "no-heartbeat-consumer",
        &["drive.eds 0x1016 `1016`: the object"],
    ),
    (
        "1800sub1=0x6E0",
        "",
        "",
        "restricted-can-id",
        &["drive.eds 0x1800sub1 / ParameterValue `0x6E0`: the CAN-ID"],
    ),
    ("", "", "", "rpdo-without-sender", &["drive.eds 0x1400sub1 / DefaultValue `$NODEID+0x200`: the CAN-ID"]),
    (
        "1014=0x81",
        "",
        "",
        "duplicate-can-id",
        &[
            "plc.eds 0x1014 / DefaultValue `$NODEID+0x80`: the CAN-ID of EMCY",
            "drive.eds 0x1014 / ParameterValue `0x81`: the CAN-ID of EMCY",
        ],
    ),
    (
        "1800sub2=1",
        "",
        "",
        "no-sync-sender",
        &["drive.eds 0x1800sub2 / ParameterValue `1`: the transmission type"],
    ),
    (
        "1800sub3=1000 1800sub5=50",
        "",
        "",
        "pdo-times",
        &[
            "drive.eds 0x1800sub5 / ParameterValue `50`: the event timer",
            "drive.eds 0x1800sub3 / ParameterValue `1000`: the inhibit time",
        ],
    ),
    // the sender has no 1019h
    (
        "1019=10 1800sub2=1",
        "1005=0x40000080 1006=10000",
        "",
        "sync-counter",
        &["drive.eds 0x1019 / ParameterValue `10`: the overflow value"],
    ),
    (
        "1800sub2=1",
        "1005=0x40000080 1006=100",
        "",
        "sync-window",
        &["plc.eds 0x1006 / ParameterValue `100`: the communication cycle period"],
    ),
    (
        "1005=0x40000080 1006=1000",
        "1005=0x40000080 1006=1000",
        "",
        "duplicate-sync-sender",
        &[
            "plc.eds 0x1005 / ParameterValue `0x40000080`: the CAN-ID of SYNC",
            "drive.eds 0x1005 / ParameterValue `0x40000080`: the CAN-ID of SYNC",
        ],
    ),
    (
        "Baudrate=500",
        "",
        "",
        "unsupported-bit-rate",
        &["drive.eds DeviceComissioning / Baudrate `500`: the configured bit rate"],
    ),
];

#[test]
fn findings_point_into_descriptions() {
    let folder = new_folder("related");
    for (drive, plc, added, rule, expected) in ROWS {
        let file = open(&folder, drive, plc, &format!("{NETWORK}{added}\n"));
        let findings = file.check();
        let mut found = findings.iter().filter(|finding| finding.rule.name() == *rule);
        let finding = found.next().unwrap_or_else(|| panic!("no {rule}"));
        assert_eq!(places(&file, finding), *expected, "{rule}");
    }
}

/// In a network of descriptions the manager expects what its own says.
#[test]
fn a_configured_manager_is_compared_with_the_nodes() {
    let folder = new_folder("related-manager");
    let node = |text: String, node_id, is_manager| {
        format!("{text}[DeviceComissioning]\nNodeID={node_id}\nCANopenManager={is_manager}\n")
    };
    fs::write(folder.join("drive.dcf"), node(described("counter.eds", ""), 5, 0)).unwrap();
    fs::write(folder.join("plc.dcf"), node(described("plc.eds", "1F85=0x1234"), 1, 1)).unwrap();
    let file = NetworkFile::of_descriptions(
        &["drive.dcf", "plc.dcf"].map(|name| folder.join(name)),
        &Default::default(),
    )
    .unwrap();
    let findings = file.check();
    let finding = findings.iter().find(|finding| finding.rule.name() == "wrong-identity").unwrap();
    let expected = [
        "plc.dcf 0x1F85Value / 5 `0x1234`: the expected number",
        "drive.dcf 0x1018sub1 / DefaultValue `0x360`: the described number",
    ];
    assert_eq!(places(&file, finding), expected);
}

/// Without node-IDs in the network file those of the descriptions are in conflict.
#[test]
fn node_ids_of_descriptions_are_shown_there() {
    let network = NETWORK.replace("id = 1\n", "").replace("id = 5\n", "");
    let file = open(&new_folder("related-ids"), "NodeID=5", "NodeID=5", &network);
    let findings = file.check();
    let finding = findings.iter().find(|finding| finding.rule.name() == "duplicate-node-id").unwrap();
    let expected = [
        "drive.eds DeviceComissioning / NodeID `5`: the node-ID",
        "plc.eds DeviceComissioning / NodeID `5`: the node-ID",
    ];
    assert_eq!(places(&file, finding), expected);
}

/// Nodes with one description have one label at a place.
#[test]
fn a_place_that_two_nodes_share_is_shown_once() {
    let network = format!("{NETWORK}[node.copy]\nfile = \"drive.eds\"\nid = 6\n");
    let file = open(&new_folder("related-shared"), "1800sub1=0x185", "", &network);
    let findings = file.check();
    let finding = findings.iter().find(|finding| finding.rule.name() == "duplicate-can-id").unwrap();
    let expected = ["drive.eds 0x1800sub1 / ParameterValue `0x185`: the CAN-ID of TPDO 1"];
    assert_eq!(places(&file, finding), expected);
}

/// A device as JSON has no lines that a report could show.
#[test]
fn a_device_as_json_has_no_places() {
    let folder = new_folder("related-json");
    let values = "1800sub1=0x6E0 1017=100 100C=50 100D=2";
    let of_eds = open(&folder, values, "", NETWORK);
    let device = of_eds.description(1).unwrap().device();
    fs::write(folder.join("drive.json"), json::write_device(device)).unwrap();
    let of_json = open(&folder, "", "", &NETWORK.replace("drive.eds", "drive.json"));
    assert!(of_json.description(1).is_none());
    let messages = |file: &NetworkFile| -> Vec<String> {
        file.check().iter().map(|finding| finding.message.to_string()).collect()
    };
    assert_eq!(messages(&of_json), messages(&of_eds));
    let drive_places = |file: &NetworkFile| {
        let findings = file.check();
        let labels = findings.iter().flat_map(|finding| &finding.labels);
        labels.filter(|label| matches!(label.at, At::Node(1, _))).count()
    };
    assert_eq!(drive_places(&of_json), 0);
    assert!(drive_places(&of_eds) > 3);
}

/// Baselines know a finding by the text of the network alone.
#[test]
fn descriptions_do_not_change_fingerprints() {
    let file = open(&new_folder("related-prints"), "1800sub1=0x6E0 1017=100 100C=50 100D=2", "", NETWORK);
    let findings = file.check();
    assert!(findings.iter().any(|finding| !places(&file, finding).is_empty()));
    assert_eq!(fingerprints(&file, &findings), fingerprints(&file.source, &findings));
}

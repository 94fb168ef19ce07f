//! The network of the book's chapter 4, and networks of many nodes.

use std::fmt::Write;
use std::fs;

use objdict::diagnostic::Severity;
use objdict::format::network::NetworkFile;
use objdict::network::{DcfgenMode, Messages, Party, compile};
use objdict::source::SourceFile;

use crate::support;

/// A network whose files are those of `fixtures/network`.
pub(crate) fn open(name: &str, text: &str) -> NetworkFile {
    let source = SourceFile::from_text(format!("{name}.toml"), text);
    NetworkFile::read(source, &support::fixtures().join("network"), &Default::default())
}

fn chapter_4() -> String {
    fs::read_to_string(support::fixtures().join("network/chapter4.toml")).unwrap()
}

/// The PDOs of a network, a line each: CAN-ID, sender and receivers.
fn pdos(file: &NetworkFile) -> Vec<String> {
    let network = file.network().unwrap();
    let named = |party: &Party| format!("{} {}", network.nodes[party.node].name.value, party.service);
    let is_pdo = |party: &&Party| party.service.to_string().contains("PDO");
    let messages = Messages::new(network, file.compiled().unwrap()).0;
    let lines = messages.iter().filter_map(|(can_id, message)| {
        let sender = message.senders.iter().find(is_pdo)?;
        let receivers: Vec<String> = message.receivers.iter().filter(is_pdo).map(named).collect();
        Some(format!("{can_id} {}: {}", named(sender), receivers.join(", ")))
    });
    lines.collect()
}

#[test]
fn the_network_of_chapter_4_comes_out_as_printed() {
    let file = open("chapter4", &chapter_4());
    let found: Vec<String> = file.check().iter().map(|finding| finding.message.to_string()).collect();
    assert_eq!(found, [""; 0]);
    assert_eq!(
        pdos(&file),
        [
            "18Bh left TPDO 1: plc RPDO 1",
            "18Dh middle TPDO 1: plc RPDO 5",
            "20Bh plc TPDO 1: left RPDO 1",
            "28Bh left TPDO 2: plc RPDO 2",
            "30Bh plc TPDO 2: left RPDO 2",
            "381h plc TPDO 3: right RPDO 1",
            "401h right TPDO 1: plc RPDO 3",
            "481h plc TPDO 4: right RPDO 2",
            "501h right TPDO 2: plc RPDO 4",
        ]
    );
    let compiled = file.compiled().unwrap();
    let left = &compiled.slaves[0];
    let stream = left.arranged().unwrap();
    assert_eq!((stream.0.len(), stream.write().unwrap().len()), (33, 325));
    let plc = compiled.manager.as_ref().unwrap();
    let services = plc.device.services();
    assert_eq!(services.communication_cycle_period, Some(33_000));
    assert!(services.sync.unwrap().bit_30(), "the controller sends SYNC");
    let received = plc.device.pdo(objdict::model::PdoKind::Rpdo, 1).unwrap();
    let mapped: Vec<String> = received.mapped().map(|object| object.to_string()).collect();
    assert_eq!(
        mapped.join("; "),
        (1..=5).map(|sub| format!("5200h:{sub:02X}, 8 bits")).collect::<Vec<_>>().join("; ")
    );
}

#[test]
fn the_printed_error_of_chapter_4_is_found() {
    let text = chapter_4() + "can-id = 0x20B\n";
    let found = open("middle", &text).check();
    let found: Vec<_> = found.iter().map(|finding| (finding.rule.id, finding.message.to_string())).collect();
    assert!(
        found.iter().any(|(rule, message)| *rule == "network/duplicate-can-id" && message.contains("20Bh")),
        "{found:?}"
    );
}

/// `count` islands with four links each to one controller and to each other.
pub(crate) fn many(count: usize) -> String {
    let mut text = String::from("[node.n0]\nfile = \"island.eds\"\nid = 1\n");
    for node in 1..count {
        writeln!(text, "[node.n{node}]\nfile = \"island.eds\"\nid = {}", node + 1).unwrap();
        for sub in 1..=4 {
            let next = (node + 1) % count;
            writeln!(text, "[[link]]\nfrom = \"n{node}.6000:{sub}\"\nto = \"n{next}.6200:{sub}\"").unwrap();
        }
    }
    text
}

#[test]
fn a_ring_of_127_nodes_has_a_pdo_for_each_node() {
    let file = open("ring", &many(127));
    let network = file.network().unwrap();
    assert_eq!((network.nodes.len(), network.links.len()), (127, 504));
    let lines = pdos(&file);
    for node in 1..127 {
        let line = format!("{:03X}h n{node} TPDO 1: n{} RPDO 1", 0x181 + node, (node + 1) % 127);
        assert!(lines.contains(&line), "{line}");
    }
}

#[test]
fn a_node_watches_others_beside_the_manager() {
    let text = "[manager]\nid = 127\nheartbeat = \"100ms\"\n[node.left]\nfile = \"island.eds\"\nid = 11\nwatches-manager = true\nwatches = { right = \"1.5x\", nowhere = \"500ms\" }\n[node.right]\nfile = \"island.eds\"\nid = 12\nheartbeat = \"200ms\"\n";
    let file = open("watches", text);
    let found: Vec<_> = file.check().iter().map(|finding| finding.message.to_string()).collect();
    assert!(found.contains(&"unknown node `nowhere`, which `left` watches".to_owned()), "{found:?}");
    let compiled = file.compiled().unwrap();
    let consumers = compiled.slaves[0].device.services().heartbeat_consumers;
    let consumers: Vec<_> =
        consumers.iter().map(|consumer| (consumer.sub, consumer.node_id, consumer.time)).collect();
    assert_eq!(consumers, [(1, 127, 300), (2, 12, 300)]);
}

/// Every key of the JSON Schema is on the page.
#[test]
fn the_reference_has_every_key() {
    fn keys(schema: &serde_json::Value, found: &mut Vec<String>) {
        if let Some(properties) = schema.get("properties").and_then(serde_json::Value::as_object) {
            found.extend(properties.keys().cloned());
        }
        match schema {
            serde_json::Value::Object(fields) => fields.values().for_each(|value| keys(value, found)),
            serde_json::Value::Array(items) => items.iter().for_each(|value| keys(value, found)),
            _ => {}
        }
    }
    let page = include_str!("../../docs/reference/network.md");
    let mut found = Vec::new();
    keys(&objdict::format::network::schema::network_toml(), &mut found);
    assert!(found.len() > 50, "{found:?}");
    for key in found {
        let spellings = [
            format!("`{key}`"),
            format!("`{key} ="),
            format!("`{key}."),
            format!("[[{key}]]"),
            format!("[{key}"),
            format!(".{key}]"),
        ];
        assert!(
            spellings.iter().any(|spelling| page.contains(spelling)),
            "`{key}` is not in docs/reference/network.md"
        );
    }
}

/// A factor is of the heartbeat time that the network file states, else of that of the description.
#[test]
fn a_watched_node_may_have_its_heartbeat_time_in_its_description() {
    let text = "[node.plc]\nfile = \"plc.eds\"\nid = 1\nwatches = { bare = \"1.5x\" }\n\
                [node.bare]\nfile = \"bare.dcf\"\n";
    let file = open("watched", text);
    assert!(file.check().is_empty(), "{:?}", file.check());
    let compiled = file.compiled().unwrap();
    let consumers = compiled.slaves[0].device.services().heartbeat_consumers;
    let watched: Vec<_> = consumers.iter().map(|consumer| (consumer.node_id, consumer.time)).collect();
    assert_eq!(watched, [(5, 1500)]);
}

/// A PDO that cannot be switched off can have other times. dcfgen tries to switch it off.
#[test]
fn a_pdo_with_a_constant_cob_id_stays_on() {
    let folder = crate::network::new_folder("constant-cob-id");
    let description = fs::read_to_string(support::fixtures().join("network/constant.eds")).unwrap();
    let (before, entry) = description.split_once("[1800sub1]").unwrap();
    let entry = entry.replacen("AccessType=rw", "AccessType=const", 1).replacen("0x80000180", "0x180", 1);
    fs::write(folder.join("constant.eds"), format!("{before}[1800sub1]{entry}")).unwrap();
    let text = "[node.inputs]\nfile = \"constant.eds\"\nid = 5\ntpdo.1 = { event-timer = \"20ms\" }\n";
    fs::write(folder.join("network.toml"), text).unwrap();
    let file = NetworkFile::open(&folder.join("network.toml"), &Default::default()).unwrap();
    assert!(!file.check().has_errors(), "{:?}", file.check());
    let downloads = |mode| {
        let compiled = compile(file.network().unwrap(), mode);
        let downloads = &compiled.slaves[0].downloads.0;
        downloads
            .iter()
            .map(|download| format!("{:04X}:{}", download.index, download.sub))
            .collect::<Vec<_>>()
    };
    assert_eq!(downloads(DcfgenMode::Corrected), ["1800:5"]);
    assert_eq!(downloads(DcfgenMode::Exact), ["1800:1", "1800:5", "1800:1"]);
}

/// `--strict-dcfgen` builds what dcfgen builds, so errors of a `bus.yml` that it does not report leave no doubt about what is built.
#[test]
fn what_dcfgen_passes_over_is_built_as_dcfgen_does() {
    let text = format!(
        "master: {{node_id: 1, sync_period: 10000, sync_overflow: 255, sync_window: 20000, baudrate: 100, boot_tiem: 3}}\n\
        drive:\n  dcf: {}\n  node_id: 5\n  tpdo:\n    2: {{cob_id: auto, transmission: 245, mapping: [{{index: 0x6064}}]}}\n  \
        sdo:\n    - {{index: 0x1005, value: 0x81}}\n    - {{index: 0x1016, sub_index: 1, value: 0x000503E8}}\n    \
        - {{index: 0x1016, sub_index: 2, value: 0x000903E8}}\n    - {{index: 0x1800, sub_index: 2, value: 1}}\n",
        support::fixtures().join("network/servo.eds").display()
    );
    let findings = open("passed-over", &text).check();
    let errors = || findings.iter().filter(|finding| finding.severity == Severity::Error);
    let mut rules: Vec<&str> = errors().map(|finding| finding.rule.name()).collect();
    rules.sort_unstable();
    let expected = [
        "invalid-value",
        "invalid-value",
        "no-sync-sender",
        "silent-node",
        "silent-node",
        "sync-window",
        "unknown-key",
        "unsupported-bit-rate",
    ];
    assert_eq!(rules, expected);
    assert!(errors().all(|finding| finding.is_understood));
}

/// A node whose description cannot be read is not an unknown one.
#[test]
fn an_unreadable_manager_is_one_finding() {
    let text =
        "[bus]\nmanager = \"plc\"\n[manager]\nheartbeat = \"100ms\"\n[node.plc]\nfile = \"nowhere.eds\"\n";
    let findings = open("unreadable", text).check();
    let rules: Vec<&str> = findings.iter().map(|finding| finding.rule.name()).collect();
    assert_eq!(rules, ["unreadable-node"]);
}

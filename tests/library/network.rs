//! Networks: what is built of them.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use objdict::download::{ConciseDcf, effective};
use objdict::format::network::{Build, BuiltFile, ConfigurationTime, NetworkFile, init, schema};
use objdict::format::{self, Description, Format, WriteOptions};
use objdict::model::{Device, Value};
use objdict::network::{DcfgenMode, End, LelyOptions, MessageRow, Overview};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

pub(crate) fn open(name: &str) -> NetworkFile {
    NetworkFile::open(&path(name), &Default::default()).unwrap()
}

pub(crate) fn path(name: &str) -> PathBuf {
    support::fixtures().join("network").join(name)
}

/// The files of Lely's master.
pub(crate) fn lely(name: &str, options: &LelyOptions) -> Vec<BuiltFile> {
    let file = open(name);
    let build = file.build(options.mode).unwrap();
    verified(&build, build.lely(options).unwrap())
}

/// What is against built files.
pub(crate) fn objections(build: &Build<'_>, files: &[BuiltFile]) -> Vec<String> {
    build.verify(files).unwrap().iter().map(ToString::to_string).collect()
}

/// Built files, replayed: nothing is against them.
pub(crate) fn verified(build: &Build<'_>, files: Vec<BuiltFile>) -> Vec<BuiltFile> {
    assert_eq!(objections(build, &files), Vec::<String>::new());
    files
}

/// An empty folder.
pub(crate) fn new_folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::remove_dir_all(&folder).ok();
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

fn file<'a>(files: &'a [BuiltFile], name: &str) -> &'a [u8] {
    &files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("{name} is not built")).bytes
}

/// The worked example of the documentation of dcfgen's records: each of the 33 downloads, byte by byte.
#[test]
fn the_records_of_a_node_are_those_of_dcfgen() {
    let options = LelyOptions { mode: DcfgenMode::Exact, remote_pdos: true };
    let files = lely("worked.yml", &options);
    let drive = objdict::download::ConciseDcf::parse(file(&files, "drive.bin")).unwrap();
    let text: Vec<String> = drive.0.iter().map(|download| format!("{download:?}")).collect();
    insta::assert_snapshot!(text.join("\n"));
    assert_eq!(file(&files, "drive.bin").len(), 328);
    let master = objdict::download::ConciseDcf::parse(file(&files, "master.bin")).unwrap();
    let text: Vec<String> = master.0.iter().map(|download| format!("{download:?}")).collect();
    assert_eq!(text, ["1018:04 34120000", "1F87:05 02000100", "1F88:05 4D000000"]);
}

/// What dcfgen does wrong is right by default, and nothing else differs.
#[test]
fn the_errors_of_dcfgen_are_not_copied() {
    let text = |mode| {
        String::from_utf8(
            file(&lely("cell.yml", &LelyOptions { mode, remote_pdos: false }), "master.dcf").to_vec(),
        )
        .unwrap()
    };
    let (strict, repaired) = (text(DcfgenMode::Exact), text(DcfgenMode::Corrected));
    let differences: Vec<String> = different_lines(&strict, &repaired);
    assert_eq!(
        differences,
        [
            "DataType=0x0005 -> DataType=0x0007",
            "CompactSubObj=127 -> CompactSubObj=128",
            "CompactSubObj=127 -> CompactSubObj=128"
        ]
    );
}

/// The lines that differ between two texts of as many lines.
fn different_lines(a: &str, b: &str) -> Vec<String> {
    assert_eq!(a.lines().count(), b.lines().count());
    let pairs = a.lines().zip(b.lines()).filter(|(a, b)| a != b);
    pairs.map(|(a, b)| format!("{a} -> {b}")).collect()
}

#[test]
fn every_stream_is_accepted_by_its_node() {
    for name in ["worked.yml", "cell.yml", "chapter4.toml", "line.toml"] {
        let network = open(name);
        assert!(!network.check().has_errors(), "{name}");
        let build = network.build(DcfgenMode::Corrected).unwrap();
        for BuiltFile { name, bytes } in verified(&build, build.concise().unwrap()) {
            let node = network
                .network()
                .unwrap()
                .nodes
                .iter()
                .find(|node| name == format!("{}.cdcf", node.name.value));
            let node = node.unwrap();
            let stream = objdict::download::ConciseDcf::parse(&bytes).unwrap();
            let verification = stream.verify(&node.device, node.node_id.map(|node_id| node_id.value));
            assert!(
                verification.is_accepted() && verification.unknown.is_empty(),
                "{name}: {verification:?}"
            );
        }
    }
}

/// A network of the same drive in each format that is no EDS.
pub(crate) fn of_formats() -> NetworkFile {
    let folder = new_folder("formats");
    let servo = format::open(&path("servo.eds"), &SourceOptions::default()).unwrap();
    let mut text = "[bus]\nbit-rate = 250\nmanager = \"plc\"\n[manager]\nid = 1\n".to_owned();
    let written = |format| format::write(servo.device(), format, &WriteOptions::default()).unwrap().bytes;
    let json = format::json::write_device(servo.device()).into_bytes();
    let files = [("xdd", written(Format::Xdd)), ("toml", written(Format::Toml)), ("json", json)];
    for (id, (name, bytes)) in (5..).zip(files) {
        std::fs::write(folder.join(format!("{name}.{name}")), bytes).unwrap();
        text += &format!("[node.{name}]\nfile = \"{name}.{name}\"\nid = {id}\nheartbeat = \"200ms\"\n");
    }
    std::fs::write(folder.join("network.toml"), text).unwrap();
    NetworkFile::open(&folder.join("network.toml"), &Default::default()).unwrap()
}

/// A node has a DCF, and dcfgen an EDS, whatever the format of its description is.
#[test]
fn every_description_becomes_a_dcf() {
    let file = of_formats();
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let read = |file: &BuiltFile| read_dcf(file.bytes.clone()).device().clone();
    for (slave, built) in file.compiled().unwrap().nodes().zip(&build.dcfs().unwrap()) {
        let device = read(built);
        assert!(built.name.ends_with(".dcf") && device.node_id() == Some(slave.node_id), "{}", built.name);
        assert_eq!(device.value(0x1017, 0), slave.device.value(0x1017, 0), "{}", built.name);
    }
    let bus = build.bus_yml().unwrap();
    let names: Vec<&str> = bus.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["bus.yml", "xdd.eds", "toml.eds", "json.eds"]);
    for built in &bus[1..] {
        let is_named = String::from_utf8_lossy(&bus[0].bytes).contains(&format!("dcf: \"{}\"", built.name));
        assert!(is_named && read(built).object(0x6041).is_some(), "{}", built.name);
    }
}

/// A `bus.yml` that is written says what was read.
#[test]
fn a_written_bus_yml_builds_the_same() {
    for name in ["worked.yml", "cell.yml"] {
        let folder = new_folder(&format!("bus-yml-{name}"));
        for BuiltFile { name, bytes } in open(name).build(DcfgenMode::Corrected).unwrap().bus_yml().unwrap() {
            std::fs::write(folder.join(name), bytes).unwrap();
        }
        let again = NetworkFile::open(&folder.join("bus.yml"), &Default::default()).unwrap();
        let options = LelyOptions::default();
        let again = again.build(DcfgenMode::Corrected).unwrap().lely(&options).unwrap();
        assert_eq!(again, lely(name, &options), "{name}");
    }
}

/// The values of all entries of a device, as numbers of its node or as text.
fn values(device: &Device, node_id: u8) -> BTreeMap<(u16, u8), String> {
    let entries = device.objects.iter().flat_map(|(&index, object)| {
        object.entries().map(move |(sub, entry)| ((index, sub), entry)).collect::<Vec<_>>()
    });
    let shown = |value: &Value| match value.integer_for(node_id) {
        Some(number) => number.to_string(),
        None => format!("{value:?}"),
    };
    entries.filter_map(|(at, entry)| Some((at, shown(entry.value()?)))).collect()
}

/// What differs, a line each.
fn differences(one: &BTreeMap<(u16, u8), String>, other: &BTreeMap<(u16, u8), String>) -> Vec<String> {
    let keys: BTreeSet<_> = one.keys().chain(other.keys()).collect();
    let differing = keys.into_iter().filter(|key| one.get(key) != other.get(key));
    differing
        .map(|key| format!("{:04X}:{:02X}: {:?}, {:?}", key.0, key.1, one.get(key), other.get(key)))
        .collect()
}

/// The description in the bytes of a DCF.
fn read_dcf(bytes: Vec<u8>) -> Description {
    let source = SourceFile::from_bytes("node.dcf", bytes, &SourceOptions::default()).unwrap();
    format::read(source, Format::Dcf)
}

/// The device as it is after the downloads of a written stream.
fn downloaded(device: &Device, stream: &[u8]) -> Device {
    let mut device = effective(device).into_owned();
    for download in &ConciseDcf::parse(stream).unwrap().0 {
        device.assign(download.assignment(&device).as_slice());
    }
    device
}

/// Each target writes the effective dictionary: it is what is read from the bytes again.
#[test]
fn what_is_written_has_the_effective_values() {
    for name in ["worked.yml", "cell.yml", "chapter4.toml", "line.toml"] {
        let network = open(name);
        let nodes = &network.network().unwrap().nodes;
        let compiled = network.compiled().unwrap();
        let build = network.build(DcfgenMode::Corrected).unwrap();
        let dcfs = verified(&build, build.dcfs().unwrap());
        let [concise, lely] = [
            verified(&build, build.concise().unwrap()),
            verified(&build, build.lely(&LelyOptions::default()).unwrap()),
        ];
        let of = |name: &str, files: &[BuiltFile]| {
            files.iter().find(|file| file.name == name).map(|file| file.bytes.clone())
        };
        for slave in compiled.nodes() {
            let node = &nodes[slave.node].name.value;
            let mut wanted = values(&slave.device, slave.node_id);
            let written = read_dcf(of(&format!("{node}.dcf"), &dcfs).unwrap());
            let mut read = values(&effective(written.device()), slave.node_id);
            // the configurations of the nodes are compared below
            wanted.retain(|(index, _), _| *index != 0x1F22);
            read.retain(|(index, _), _| *index != 0x1F22);
            assert_eq!(differences(&read, &wanted), [""; 0], "{name}: {node}.dcf");
            let streams = [of(&format!("{node}.cdcf"), &concise), of(&format!("{node}.bin"), &lely)];
            for stream in streams.into_iter().flatten() {
                let device = downloaded(&nodes[slave.node].device, &stream);
                let mut read = values(&device, slave.node_id);
                read.retain(|(index, _), _| *index != 0x1F22);
                assert_eq!(differences(&read, &wanted), [""; 0], "{name}: {node}");
            }
        }
        let manager = read_dcf(build.manager().unwrap().bytes);
        for slave in &compiled.slaves {
            let stream = of(&format!("{}.cdcf", nodes[slave.node].name.value), &concise).unwrap();
            let held = manager.device().object(0x1F22).unwrap().value(slave.node_id).unwrap().into_owned();
            assert_eq!(held, Value::Bytes(stream.into()), "{name}: 1F22h:{:02X}", slave.node_id);
        }
    }
}

/// The manager's DCF holds what is built for each node.
#[test]
fn the_manager_has_the_configuration_of_each_node() {
    let network = open("cell.yml");
    let build = network.build(DcfgenMode::Corrected).unwrap();
    let device = build.manager_device().unwrap();
    let value = |index: u16, sub: u8| {
        device.object(index).and_then(|object| object.value(sub)).map(|value| value.to_string())
    };
    let concise = verified(&build, build.concise().unwrap());
    for (node_id, stream) in [(11, &concise[0]), (12, &concise[1])] {
        let held = device.object(0x1F22).unwrap().value(node_id).unwrap().into_owned();
        assert_eq!(held, objdict::model::Value::Bytes(stream.bytes.clone().into()), "{node_id}");
    }
    assert_eq!(value(0x1F81, 11).as_deref(), Some((0x030D).to_string()).as_deref());
    assert_eq!(value(0x1F81, 3).as_deref(), Some((0x0064_0215).to_string()).as_deref());
    assert_eq!(value(0x1F80, 0).as_deref(), Some("9"));
    assert_eq!(value(0x1016, 1).as_deref(), Some((11 << 16 | 500).to_string()).as_deref());
    assert_eq!(value(0x1028, 12).as_deref(), Some("140"));
}

#[test]
fn the_schema_names_every_key() {
    let schema = schema::bus_yml();
    let node = &schema["$defs"]["node"]["properties"];
    for key in ["dcf", "node_id", "rpdo", "sdo", "scale_pos_to_dev"] {
        assert!(node[key].is_object(), "{key}");
    }
    let patterns = node["rpdo"]["patternProperties"].as_object().unwrap();
    let (pattern, pdo) = patterns.iter().next().unwrap();
    assert_eq!(pattern, "^([1-9][0-9]{0}|[1-9][0-9]{1}|[1-4][0-9]{2}|5[0-0][0-9]{1}|51[0-1][0-9]{0}|512)$");
    assert_eq!(pdo["properties"]["cob_id"]["anyOf"][1]["const"], "auto");
    let schema = schema::network_toml();
    let of = |key: &str| &schema["properties"][key]["additionalProperties"]["properties"];
    assert_eq!(of("type"), of("node"));
    assert!(of("node")["use"].is_object());
    for owner in [of("node"), &schema["properties"]["bus"]["properties"]] {
        assert_eq!(owner["unused-pdos"]["enum"], serde_json::json!(["keep", "off"]));
    }
}

/// A network from its text; descriptions are those of the fixtures.
fn read(text: &str) -> NetworkFile {
    let source = objdict::source::SourceFile::from_text("network.toml", text.to_owned());
    NetworkFile::read(source, &path(""), &Default::default())
}

/// Keys of a node count more than those of its type, and these more than those of the type that it uses; tables are joined.
#[test]
fn a_node_has_the_keys_of_its_type() {
    let of_type = "
        [type.any]
        heartbeat = \"500ms\"
        watch = \"2x\"
        sdo = [{ entry = \"1017\", value = 100 }, { entry = \"1017\", value = 200 }]
        [type.island]
        use = \"any\"
        file = \"island.eds\"
        heartbeat = \"300ms\"
        set = { \"1800:5\" = \"20ms\", \"1801:5\" = \"40ms\" }
        tpdo.1 = { transmission = \"event\", inhibit = \"5ms\", map = [\"6000:1-2\"] }
        [node.left]
        use = \"island\"
        id = 11
        heartbeat = \"200ms\"
        set = { \"1801:5\" = \"60ms\", \"1801:3\" = \"10ms\" }
        tpdo.1 = { inhibit = \"2ms\", map = [\"6000:3\"] }
        tpdo.2 = { enabled = false }
        sdo = [{ entry = \"1017\", value = 150 }]
        [node.right]
        use = \"island\"
        id = 12
        watch = \"3x\"";
    let plain = "
        [node.left]
        file = \"island.eds\"
        id = 11
        heartbeat = \"200ms\"
        watch = \"2x\"
        set = { \"1800:5\" = \"20ms\", \"1801:5\" = \"60ms\", \"1801:3\" = \"10ms\" }
        tpdo.1 = { transmission = \"event\", inhibit = \"2ms\", map = [\"6000:3\"] }
        tpdo.2 = { enabled = false }
        sdo = [{ entry = \"1017\", value = 150 }]
        [node.right]
        file = \"island.eds\"
        id = 12
        heartbeat = \"300ms\"
        watch = \"3x\"
        set = { \"1800:5\" = \"20ms\", \"1801:5\" = \"40ms\" }
        tpdo.1 = { transmission = \"event\", inhibit = \"5ms\", map = [\"6000:1-2\"] }
        sdo = [{ entry = \"1017\", value = 100 }, { entry = \"1017\", value = 200 }]";
    let [one, other] = [of_type, plain].map(read);
    assert!(!one.check().has_errors(), "{:?}", one.check());
    let files = |file: &NetworkFile| file.build(DcfgenMode::Corrected).unwrap().dcfs().unwrap();
    assert_eq!(files(&one), files(&other));
    let factors = |file: &NetworkFile| -> Vec<f64> {
        file.network().unwrap().nodes.iter().map(|node| node.heartbeat.factor).collect()
    };
    assert_eq!((factors(&one), factors(&other)), (vec![2.0, 3.0], vec![2.0, 3.0]));
}

/// What the load counts has a period, and everything else is named.
#[test]
fn the_load_says_what_it_leaves_out() {
    let uncounted = |keys: &str| {
        let text = format!(
            "[bus]\nbit-rate = 250\nunused-pdos = \"off\"\n[manager]\nid = 1\n[node.left]\nfile = \"island.eds\"\nid = 11\n\
             tpdo.1 = {{ {keys} }}\nrpdo.1 = {{ event-timer = \"1s\" }}\n"
        );
        let file = read(&text);
        let overview = file.build(DcfgenMode::Corrected).unwrap().overview("en");
        let pdo = overview.messages.iter().find(|message| message.can_id.to_string() == "18Bh").unwrap();
        assert_eq!(pdo.period.is_none(), !overview.uncounted.pdos.is_empty(), "{keys}");
        (overview.uncounted.words(overview.language, |id| id.to_string()), overview.load)
    };
    let all = "NMT, EMCY, SDO, 1 PDO without inhibit time and event timer (18Bh)";
    // one RPDO of 8 bytes each second
    assert_eq!(uncounted("transmission = \"event\""), (all.to_owned(), Some(0)));
    assert_eq!(uncounted("transmission = \"rtr\""), (all.to_owned(), Some(0)));
    for keys in
        ["transmission = \"event\", inhibit = \"5ms\"", "transmission = \"event\", event-timer = \"5ms\""]
    {
        assert_eq!(uncounted(keys), ("NMT, EMCY, SDO".to_owned(), Some(108)), "{keys}");
    }
}

/// The manager of chapter 4: what it expects of both islands.
#[test]
fn the_manager_of_chapter_4_boots_two_islands() {
    let network = open("chapter4.toml");
    let device = network.build(DcfgenMode::Corrected).unwrap().manager_device().unwrap();
    let value = |index: u16, sub: u8| {
        let value = device.object(index).and_then(|object| Some(object.value(sub)?.into_owned()));
        value.and_then(|value| value.integer_for(1)).map(|number| format!("{number:08X}"))
    };
    for (index, sub, expected) in [
        (0x1006, 0, "000080E8"),
        (0x1016, 1, "000B0384"),
        (0x1016, 2, "000C0384"),
        (0x1028, 11, "0000008B"),
        (0x1028, 12, "0000008C"),
        (0x1F80, 0, "00000001"),
        (0x1F81, 11, "00000005"),
        (0x1F81, 12, "00000005"),
        (0x1F85, 11, "000003F9"),
    ] {
        assert_eq!(value(index, sub).as_deref(), Some(expected), "{index:04X}:{sub:X}");
    }
}

/// Nodes and manager have the same date and time: 2026-11-22 is 15666 days after 1984-01-01, 11:30 41 400 000 ms.
#[test]
fn nodes_keep_the_time_of_their_configuration() {
    assert_eq!(objdict::model::Date::from_iso("2026-11-22").unwrap().days_after_1984(), Some(15666));
    assert_eq!(objdict::model::Date::from_iso("1984-01-24").unwrap().days_after_1984(), Some(23));
    let time = ConfigurationTime { days: 15666, milliseconds: 41_400_000 };
    let network = open("chapter4.toml");
    let build = network.build(DcfgenMode::Corrected).unwrap().configured_at(time);
    let device = build.manager_device().unwrap();
    let value = |index: u16| device.object(index).unwrap().value(11).map(|value| value.to_string());
    assert_eq!([value(0x1F26), value(0x1F27)].map(Option::unwrap), ["15666", "41400000"]);
    let stream =
        objdict::download::ConciseDcf::parse(file(&verified(&build, build.concise().unwrap()), "left.cdcf"))
            .unwrap();
    let last: Vec<String> = stream.0.iter().rev().take(2).map(|download| format!("{download:?}")).collect();
    assert_eq!(last, ["1020:02 C0B67702", "1020:01 323D0000"]);
}

/// The messages of a network in words, and its findings that depend on values.
fn said(file: &NetworkFile) -> (Vec<String>, BTreeSet<String>) {
    let network = file.network().unwrap();
    let mut overview = Overview::new(network, file.compiled().unwrap());
    overview.messages.iter_mut().for_each(|message| message.receivers.sort_by_key(End::to_string));
    let ends = |ends: &[End]| ends.iter().map(End::to_string).collect::<Vec<_>>().join(", ");
    let shown = |message: &MessageRow| {
        let (senders, receivers) = (ends(&message.senders), ends(&message.receivers));
        format!("{} {senders} to {receivers}: {}", message.can_id, message.trigger)
    };
    let findings = file.check();
    // these are about what the network file says twice or in vain
    let of_file = ["contradictory-values", "idle-pdo"];
    let findings = findings.iter().filter(|finding| !of_file.contains(&finding.rule.name()));
    let findings = findings.map(|finding| format!("{}: {}", finding.rule.name(), finding.message));
    (overview.messages.iter().map(shown).collect(), findings.collect())
}

/// The same network as its DCFs describe it.
fn written(network: &NetworkFile, folder: &str) -> NetworkFile {
    let folder = new_folder(folder);
    let mut paths = Vec::new();
    for BuiltFile { name, bytes } in network.build(DcfgenMode::Corrected).unwrap().dcfs().unwrap() {
        std::fs::write(folder.join(&name), bytes).unwrap();
        paths.push(folder.join(name));
    }
    NetworkFile::of_descriptions(&paths, &Default::default()).unwrap()
}

/// The DCFs of a network are the same network, with the same messages.
#[test]
fn configured_nodes_are_a_network() {
    let network = open("chapter4.toml");
    let again = written(&network, "configured-nodes");
    assert!(!again.check().has_errors(), "{:?}", again.check());
    assert_eq!(said(&again).0, said(&network).0);
    assert_eq!(again.network().unwrap().nodes.len(), 5);
}

/// Whatever writes an entry, the network is checked and shown with its value, and the same is in the DCFs.
#[test]
fn every_value_counts_wherever_it_is_said() {
    let rows: &[(&str, i64, &str, &str)] = &[
        ("1800:1", 0x185, "duplicate-can-id", "185h TPDO 1 of servo, TPDO 1 of other"),
        ("1014", 0x85, "duplicate-can-id", "085h EMCY of servo, EMCY of other"),
        ("1400:1", 0x185, "", "185h TPDO 1 of other to RPDO 1 of servo"),
        ("1800:2", 1, "no-sync-sender", "186h TPDO 1 of servo to RPDO 1 of other: sync/1"),
        (
            "1800:5",
            20,
            "pdo-times",
            "186h TPDO 1 of servo to RPDO 1 of other: event, inhibit 50 ms, timer 20 ms",
        ),
        ("1800:1", 0x8000_0186, "rpdo-without-sender", "186h  to RPDO 1 of other"),
        ("1A00:0", 0, "rpdo-without-sender", "186h  to RPDO 1 of other"),
        ("1017", 0, "silent-node", "706h heartbeat of servo to heartbeat of other"),
    ];
    for (row, (entry, value, rule, message)) in rows.iter().enumerate() {
        for (part, text) in [
            ("set", format!("set = {{ \"{entry}\" = {value} }}")),
            ("sdo", format!("sdo = [{{ entry = \"{entry}\", value = {value} }}]")),
        ] {
            let file = path("servo.eds").display().to_string();
            let text = format!(
                "[node.servo]\nfile = {file:?}\nid = 6\n{text}\n[node.other]\nfile = {file:?}\nid = 5\n\
                 rpdo.1 = {{ cob-id = 0x186 }}\n\
                 tpdo.1 = {{ cob-id = 0x185 }}\nset = {{ \"1016:1\" = {} }}\n",
                6 << 16 | 300
            );
            let text =
                text.replace("id = 6\n", "id = 6\ntpdo.1 = { inhibit = \"50ms\" }\nheartbeat = \"100ms\"\n");
            let source = objdict::source::SourceFile::from_text("network.toml", text);
            let network = NetworkFile::read(source, std::path::Path::new(""), &Default::default());
            let (messages, findings) = said(&network);
            assert!(messages.iter().any(|line| line.starts_with(message)), "{entry} {part}: {messages:#?}");
            assert!(
                rule.is_empty() || findings.iter().any(|line| line.starts_with(rule)),
                "{entry} {part}: {findings:#?}"
            );
            let again = written(&network, &format!("values-{row}-{part}"));
            let (again, findings_again) = said(&again);
            // what a node refuses while it runs, its DCF may have
            let is_refusal = |line: &String| line.starts_with("refused-download");
            let findings: BTreeSet<String> = findings.into_iter().filter(|line| !is_refusal(line)).collect();
            assert_eq!(again, messages, "{entry} {part}");
            assert_eq!(findings_again, findings, "{entry} {part}");
        }
    }
}

/// What the manager sends counts more than the DCF of a node: a stale 1F22h with the CAN-ID of another node is found.
#[test]
fn the_configurations_of_the_manager_are_sent() {
    let network = open("chapter4.toml");
    let folder = new_folder("stale-manager");
    let mut paths = Vec::new();
    for BuiltFile { name, bytes } in network.build(DcfgenMode::Corrected).unwrap().dcfs().unwrap() {
        // TPDO 1 of node 11 gets the CAN-ID of node 12
        let mut text = String::from_utf8(bytes).unwrap();
        if name == "plc.dcf" {
            let stale = text.replacen("001801040000008B010000", "0018010400000001040000", 1);
            assert_ne!(stale, text);
            text = stale;
        }
        std::fs::write(folder.join(&name), text).unwrap();
        paths.push(folder.join(name));
    }
    let findings = NetworkFile::of_descriptions(&paths, &Default::default()).unwrap().check();
    let found: Vec<String> =
        findings.iter().map(|finding| format!("{}: {}", finding.rule.name(), finding.message)).collect();
    for expected in [
        "other-configuration: 1F22h:0B of `plc` sets 1800h:01 of `left` to 401h, but its own description has 18Bh",
        "duplicate-can-id: TPDO 1 of `left` and TPDO 1 of `right` both send 401h",
    ] {
        assert!(found.iter().any(|line| line == expected), "{found:#?}");
    }
}

/// Each device of a file with several is a node; the path has its number.
#[test]
fn a_file_with_several_devices_is_a_network() {
    let folder = new_folder("several-devices");
    let containers = ["valve.xdd", "io-401.xdd"].map(|name| {
        let text = std::fs::read_to_string(support::fixtures().join("xdd").join(name)).unwrap();
        text.split_once("?>").unwrap().1.to_owned()
    });
    let path = folder.join("plant.nxdd");
    let text =
        format!("<?xml version=\"1.0\"?><CanOpenProject_1_1>{}</CanOpenProject_1_1>", containers.concat());
    std::fs::write(&path, text).unwrap();
    let started = init(std::slice::from_ref(&path), &Default::default()).unwrap();
    for number in [1, 2] {
        let quoted = format!("file = \"{}#{number}\"\nid = {number}  #", path.display());
        assert!(started.contains(&quoted), "{started}");
    }
    let network = NetworkFile::of_descriptions(std::slice::from_ref(&path), &Default::default()).unwrap();
    let nodes = &network.network().unwrap().nodes;
    let counts: Vec<_> = nodes.iter().map(|node| node.device.objects.len()).collect();
    assert!(matches!(counts[..], [first, second] if first != second), "{counts:?}");
    assert_eq!(network.build(DcfgenMode::Corrected).unwrap().dcfs().unwrap().len(), 2);
    let one = format!("[node.a]\nid = 1\nfile = \"{}\"\n", path.display());
    std::fs::write(folder.join("network.toml"), one).unwrap();
    let findings = NetworkFile::open(&folder.join("network.toml"), &Default::default()).unwrap().check();
    let message = findings.iter().next().unwrap().message.to_string();
    assert!(
        message.ends_with(
            "describes 2 devices; choose one by number, as in `{path}#1`"
                .replace("{path}", &path.display().to_string())
                .as_str()
        ),
        "{message}"
    );
}

/// The list of CanFestival's editor names files in the folder of its descriptions.
#[test]
fn the_folder_of_descriptions_is_searched() {
    let folder = new_folder("eds-folder");
    std::fs::create_dir(folder.join("eds")).unwrap();
    std::fs::copy(path("servo.eds"), folder.join("eds/servo.eds")).unwrap();
    let list = "[TOPOLOGY]\nNetName=None\nNodes=0x01\nNode5Present=0x01\nNode5Name=Servo 5\n\
                Node5DCFName=servo.eds\nEDSBaseName=eds\n[TOPOLOGY2]\nNodes=0\n";
    std::fs::write(folder.join("nodelist.cpj"), list).unwrap();
    let file = NetworkFile::open(&folder.join("nodelist.cpj"), &Default::default()).unwrap();
    assert_eq!(file.network().unwrap().nodes.len(), 1);
    let findings = file.check();
    let others = findings.iter().find(|finding| finding.rule.name() == "invalid-node-list").unwrap();
    assert_eq!(others.message.to_string(), "the file has 2 networks; only the first is read");
    let started = init(&[folder.join("nodelist.cpj")], &Default::default()).unwrap();
    assert!(started.contains("[node.servo_5]\n") && started.contains("\nid = 5\n"), "{started}");
}

/// `options` has the retry factor of the nodes that state none.
#[test]
fn a_node_overrides_the_options() {
    let text = "options:\n  retry_factor: 9\nmaster:\n  node_id: 1\n\
        counter:\n  dcf: counter.eds\n  node_id: 3\n  retry_factor: 2\n\
        other:\n  dcf: counter.eds\n  node_id: 4\n";
    let source = SourceFile::from_text("bus.yml", text);
    let file = NetworkFile::read(source, path("bus.yml").parent().unwrap(), &Default::default());
    let factors: Vec<u8> =
        file.network().unwrap().slaves().map(|(_, node)| node.boot.retry_factor.value).collect();
    assert_eq!(factors, [2, 9]);
}

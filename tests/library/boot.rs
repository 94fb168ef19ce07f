//! Built networks boot, and files that were changed since do not.

use std::collections::BTreeSet;

use objdict::bus::{BootFailure, Conditions, Cut, Milestone, NodeRun, Run, boot};
use objdict::diagnostic::{Findings, Severity};
use objdict::download::{ConciseDcf, Download};
use objdict::format::network::{BootFiles, BuiltFile, InstallError, Installation, NetworkFile, install};
use objdict::model::{Access, Device, PdoKind};
use objdict::network::{DcfgenMode, LelyOptions};
use objdict::source::SourceFile;

use crate::network::{objections, open, path, verified};
use crate::support;

/// The networks of the fixtures.
const NETWORKS: [&str; 4] = ["chapter4.toml", "cell.yml", "worked.yml", "wider.yml"];

fn run(installation: &Installation) -> Run {
    boot(&installation.plant, &Conditions::default())
}

/// The DCFs of chapter 4.
fn dcfs() -> Vec<BuiltFile> {
    let file = open("chapter4.toml");
    let build = file.build(DcfgenMode::Corrected).unwrap();
    verified(&build, build.dcfs().unwrap())
}

/// Replaces a text in a file; it must be there.
fn replace(files: &mut [BuiltFile], name: &str, from: &str, to: &str) {
    let file = files.iter_mut().find(|file| file.name == name).unwrap();
    let text = String::from_utf8(file.bytes.clone()).unwrap();
    assert!(text.contains(from), "{name} has no `{from}`");
    file.bytes = text.replacen(from, to, 1).into_bytes();
}

fn node<'r>(run: &'r Run, name: &str) -> &'r NodeRun {
    run.nodes.iter().find(|node| node.name == name).unwrap()
}

fn failure<'r>(run: &'r Run, name: &str) -> &'r BootFailure {
    match &node(run, name).milestone {
        Some(Milestone::Failed(failure)) => failure,
        milestone => panic!("{name}: {milestone:?}"),
    }
}

/// The entries that RPDOs write while the network runs.
fn received(device: &Device) -> BTreeSet<(u16, u8)> {
    let rpdos = device.pdos().filter(|pdo| pdo.kind == PdoKind::Rpdo);
    rpdos.flat_map(|pdo| pdo.mapped().map(|object| (object.index, object.sub)).collect::<Vec<_>>()).collect()
}

/// Where a node differs from the dictionary that everything else is computed from.
fn differences(node: &NodeRun, effective: &Device) -> Vec<String> {
    let device = node.device.as_ref().unwrap();
    let received = received(effective);
    let mut differences = Vec::new();
    for (&index, object) in &effective.objects {
        for (sub, entry) in object.entries() {
            let (Some(wanted), true) = (entry.value(), entry.access.is_some_and(Access::is_writable)) else {
                continue;
            };
            let number = |value: &objdict::model::Value| value.integer_for(node.node_id);
            let found = device.entry(index, sub).and_then(|entry| entry.value().and_then(number));
            if number(wanted).is_some() && found != number(wanted) && !received.contains(&(index, sub)) {
                differences
                    .push(format!("{}: {index:04X}:{sub:02X} is {found:?} in place of {wanted}", node.name));
            }
        }
    }
    differences
}

#[test]
fn the_fixtures_boot_and_have_their_effective_values() {
    for name in NETWORKS {
        let file = open(name);
        let (network, compiled) = (file.network().unwrap(), file.compiled().unwrap());
        for files in [BootFiles::Dcf, BootFiles::Lely] {
            let installation = file.install(files).unwrap();
            assert!(installation.notes.is_empty(), "{name}: {:?}", installation.notes);
            let run = run(&installation);
            assert!(run.is_booted(), "{name}, {files:?}");
            for slave in compiled.slaves.iter().filter(|slave| network.nodes[slave.node].boot.boot) {
                let node = run.nodes.iter().find(|node| node.node_id == slave.node_id).unwrap();
                assert_eq!(differences(node, &slave.device), Vec::<String>::new(), "{name}, {files:?}");
            }
        }
    }
}

#[test]
fn a_folder_boots_without_the_network_file() {
    let installation = install(&dcfs(), None).unwrap();
    let run = run(&installation);
    assert!(run.is_booted());
    let names: Vec<&str> = run.nodes.iter().map(|node| node.name.as_str()).collect();
    assert_eq!(names, ["plc", "left", "right", "middle", "tool"]);
    assert!(run.nodes[..4].iter().all(|node| node.operational.is_some()));
    assert!(!node(&run, "tool").must_boot);
}

#[test]
fn a_missing_node_is_named() {
    let mut files = dcfs();
    files.retain(|file| file.name != "right.dcf");
    let run = run(&install(&files, None).unwrap());
    let missing = node(&run, "node 12");
    assert!(!run.is_booted() && missing.state.is_none() && missing.must_boot);
    assert!(node(&run, "left").operational.is_some());
}

#[test]
fn another_device_is_not_configured() {
    let mut files = dcfs();
    replace(
        &mut files,
        "left.dcf",
        "ParameterName=Product code\r\nObjectType=0x7\r\nDataType=0x0007\r\nAccessType=ro\r\nDefaultValue=0x0000000B",
        "ParameterName=Product code\r\nObjectType=0x7\r\nDataType=0x0007\r\nAccessType=ro\r\nDefaultValue=0x0000000C",
    );
    let run = run(&install(&files, None).unwrap());
    assert_eq!(failure(&run, "left").status(), 'M');
    assert_eq!(node(&run, "left").downloads, 0);
}

#[test]
fn a_refused_write_is_named() {
    let mut files = dcfs();
    let entry = "ParameterName=Producer heartbeat time\r\nObjectType=0x7\r\nDataType=0x0006\r\nAccessType=";
    replace(&mut files, "right.dcf", &format!("{entry}rw"), &format!("{entry}ro"));
    let run = run(&install(&files, None).unwrap());
    let words = "refuses download 1, 1017:00: SDO abort 06010002h: attempt to write a read-only entry";
    assert_eq!(failure(&run, "right").to_string(), words);
}

#[test]
fn a_node_with_another_bit_rate_is_not_on_the_bus() {
    let mut files = dcfs();
    replace(&mut files, "middle.dcf", "Baudrate=125", "Baudrate=250");
    let installation = install(&files, None).unwrap();
    assert_eq!(installation.notes, ["`middle` is set to 250 kbit/s, but the bus to 125, so it is omitted"]);
    assert!(!run(&installation).is_booted());
}

#[test]
fn a_manager_without_boot_data_boots_nothing() {
    let mut files = dcfs();
    let file = files.iter_mut().find(|file| file.name == "plc.dcf").unwrap();
    file.bytes = String::from_utf8(file.bytes.clone()).unwrap().replace("1F81", "1FFF").into_bytes();
    let run = run(&install(&files, None).unwrap());
    assert!(!run.is_booted() && node(&run, "left").assignment.is_none());
}

#[test]
fn files_without_a_manager_or_with_two_do_not_boot() {
    let mut files = dcfs();
    replace(&mut files, "left.dcf", "CANopenManager=0", "CANopenManager=1");
    assert!(matches!(install(&files, None), Err(InstallError::Managers(..))));
    files.retain(|file| file.name == "right.dcf");
    let error = install(&files, None).unwrap_err();
    assert!(matches!(error, InstallError::NoManager) && error.help().is_some());
    let mut twice = dcfs();
    replace(&mut twice, "right.dcf", "NodeID=12", "NodeID=11");
    assert!(matches!(install(&twice, None), Err(InstallError::NodeIds(_, _, 11))));
}

#[test]
fn the_files_of_lely_boot_with_the_nodes_of_the_network() {
    let file = open("worked.yml");
    let mut files = file.build(DcfgenMode::Corrected).unwrap().lely(&LelyOptions::default()).unwrap();
    assert!(run(&install(&files, Some(&file)).unwrap()).is_booted());
    files.retain(|file| file.name != "drive.bin");
    let run = run(&install(&files, Some(&file)).unwrap());
    let words = "has no valid configuration: `drive.bin` (1F22h) is missing";
    assert_eq!(failure(&run, "drive").to_string(), words);
}

/// What `network check` reports, the bus shows: the file is built despite its errors.
#[test]
fn two_senders_of_a_can_id_are_found() {
    let text = "[bus]\nbit-rate = 125\nsync = \"33ms\"\n[manager]\nid = 1\n\
        [node.left]\nfile = \"island.eds\"\nid = 11\nset = { \"1800:2\" = 1 }\n\
        [node.right]\nfile = \"island.eds\"\nid = 12\nset = { \"1800:1\" = 0x18B, \"1800:2\" = 1 }\n";
    let source = SourceFile::from_text("network.toml", text);
    let folder = path("chapter4.toml").parent().unwrap().to_owned();
    let file = NetworkFile::read(source, &folder, &Default::default());
    let run = run(&file.install(BootFiles::Dcf).unwrap());
    assert!(!run.is_booted() && run.operational.is_some());
}

#[test]
fn corrupted_files_boot_or_say_why_not() {
    let files = dcfs();
    for (number, text) in ["0x", "=", "1F22", "\n", "[", "9"].iter().enumerate() {
        for name in ["plc.dcf", "left.dcf"] {
            let mut files = files.clone();
            let file = files.iter_mut().find(|file| file.name == name).unwrap();
            let corrupted =
                String::from_utf8(file.bytes.clone()).unwrap().replace(text, ["", "FF", "]"][number % 3]);
            file.bytes = corrupted.into_bytes();
            match install(&files, None) {
                Ok(installation) => assert!(run(&installation).end > 0),
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
}

/// The files of every target, replayed: nothing is against them.
#[test]
fn nothing_is_against_what_is_built() {
    for name in NETWORKS {
        let file = open(name);
        let build = file.build(DcfgenMode::Corrected).unwrap();
        verified(&build, build.dcfs().unwrap());
        verified(&build, build.concise().unwrap());
        verified(&build, vec![build.manager().unwrap()]);
        verified(&build, build.node_list().unwrap());
        verified(&build, build.lely(&LelyOptions::default()).unwrap());
    }
}

#[test]
fn what_a_node_refuses_is_against_its_file() {
    let file = open("chapter4.toml");
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let mut files = build.concise().unwrap();
    let mut middle = ConciseDcf::parse(&files[2].bytes).unwrap();
    middle.0.push(Download::new(0x1000, 0, [0; 4]));
    files[2].bytes = middle.write().unwrap();
    let words = "`middle` rejects download 4, 1000:00: its access type does not allow a write";
    assert_eq!(objections(&build, &files), [words]);
    files[2].bytes.truncate(9);
    assert!(objections(&build, &files)[0].starts_with("`middle` has no valid configuration: "));
}

/// A node that has another CAN-ID in the end than the network file says: only what is built shows it.
#[test]
fn the_rules_are_against_what_comes_of_the_files() {
    let file = open("chapter4.toml");
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let mut files = build.concise().unwrap();
    let mut middle = ConciseDcf::parse(&files[2].bytes).unwrap();
    middle.0.push(Download::new(0x1800, 1, 0x18B_u32.to_le_bytes()));
    files[2].bytes = middle.write().unwrap();
    let found = objections(&build, &files).join("\n");
    assert!(found.contains("18Bh"), "{found}");
    let mut files = dcfs();
    let left = files.iter().position(|file| file.name == "left.dcf").unwrap();
    let text = String::from_utf8(files[left].bytes.clone()).unwrap().replace("NodeID=11", "NodeID=12");
    files[left].bytes = text.into_bytes();
    assert!(!objections(&build, &files).is_empty());
}

#[test]
fn a_configuration_that_the_manager_does_not_find_is_missing() {
    let file = open("worked.yml");
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let mut files = build.lely(&LelyOptions::default()).unwrap();
    files.retain(|file| file.name != "drive.bin");
    let found = objections(&build, &files);
    assert_eq!(found[0], "`drive` has no valid configuration: `drive.bin` (1F22h) is missing");
}

/// Without a bit rate, a bus that not even the fastest one can carry is an error, because its nodes do not boot.
#[test]
fn a_bus_that_is_overloaded_at_any_bit_rate_is_an_error() {
    let text = "[bus]\nsync = \"40us\"\n[manager]\nid = 1\n\
        [node.left]\nfile = \"island.eds\"\nid = 11\nset = { \"1800:2\" = 1, \"1801:2\" = 1 }\n";
    let folder = path("chapter4.toml").parent().unwrap().to_owned();
    let read = |text: &str| {
        let source = SourceFile::from_text("network.toml", text);
        NetworkFile::read(source, &folder, &Default::default())
    };
    let rules = |findings: &Findings| findings.iter().map(|finding| finding.rule.id).collect::<Vec<_>>();
    let fast = read(text);
    let findings = fast.check();
    assert!(
        findings.has_errors() && rules(&findings).contains(&"network/bus-load"),
        "{:?}",
        rules(&findings)
    );
    assert!(!run(&fast.install(BootFiles::Dcf).unwrap()).is_booted());
    let flood = run(&read(&text.replace("40us", "1us")).install(BootFiles::Dcf).unwrap());
    assert_eq!((flood.cut, flood.is_overloaded(), flood.is_booted()), (Some(Cut::Overload), true, false));
    let slow = read(&text.replace("40us", "2ms"));
    assert!(!rules(&slow.check()).contains(&"network/bus-load"));
    assert!(run(&slow.install(BootFiles::Dcf).unwrap()).is_booted());
}

/// What the check says of nodes that must not be reset or cannot restore is what the bus shows.
#[test]
fn what_the_manager_cannot_boot_is_an_error() {
    let folder = support::fixtures().join("rules/network");
    for rule in ["kept-alive-without-state", "nothing-to-restore"] {
        for name in ["bad.toml", "good.toml"] {
            let path = folder.join(rule).join(name);
            let file = NetworkFile::open(&path, &Default::default()).unwrap();
            let run = run(&file.install(BootFiles::Dcf).unwrap());
            assert_eq!(run.is_booted(), name == "good.toml", "{}", path.display());
        }
    }
}

/// Descriptions of eight kinds of devices.
const KINDS: [&str; 8] = [
    "network/island.eds",
    "network/servo.eds",
    "eds/io-401.eds",
    "eds/drive-402.eds",
    "eds/encoder-406.eds",
    "eds/coupler-modular.eds",
    "eds/dspic-sensors.eds",
    "eds/microcanopen.eds",
];

/// A plant of eight kinds of devices is built for each target, replayed, and boots.
#[test]
fn a_plant_of_eight_kinds_of_devices_boots() {
    let mut text =
        "[bus]\nbit-rate = 500\nsync = \"20ms\"\n[manager]\nid = 127\nheartbeat = \"500ms\"\n".to_owned();
    for (node_id, file) in (1..).zip(KINDS) {
        text += &format!(
            "[node.n{node_id}]\nfile = \"{file}\"\nid = {node_id}\nheartbeat = \"200ms\"\nmandatory = true\n"
        );
    }
    let source = SourceFile::from_text("network.toml", text);
    let file = NetworkFile::read(source, &support::fixtures(), &Default::default());
    let errors: Vec<String> = file
        .check()
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .map(|finding| finding.message.shown().into_owned())
        .collect();
    assert_eq!(errors, Vec::<String>::new());
    let build = file.build(DcfgenMode::Corrected).unwrap();
    for files in [build.dcfs().unwrap(), build.lely(&LelyOptions::default()).unwrap()] {
        let files = verified(&build, files);
        let run = run(&install(&files, Some(&file)).unwrap());
        let states: Vec<_> = run.nodes.iter().map(|node| (&node.name, &node.milestone)).collect();
        assert!(run.is_booted(), "{states:?}");
        assert!(run.nodes.iter().filter(|node| !node.is_manager).all(|node| node.operational.is_some()));
    }
}

/// What ObjFlags forbid to tools, a network file may ask for, and a node takes it.
#[test]
fn what_only_tools_must_not_write_is_not_against_a_file() {
    let text = "[bus]\nbit-rate = 500\n[manager]\nid = 1\n[node.io]\nfile = \"eds/io-401.eds\"\nid = 5\n";
    let source = SourceFile::from_text("network.toml", text);
    let file = NetworkFile::read(source, &support::fixtures(), &Default::default());
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let save = Download::new(0x1010, 1, *b"save");
    let stream = ConciseDcf(vec![save]);
    let device = &file.network().unwrap().nodes[0].device;
    assert!(!stream.verify(device, Some(5)).is_accepted());
    let files = [BuiltFile { name: "io.cdcf".to_owned(), bytes: stream.write().unwrap() }];
    assert_eq!(objections(&build, &files), Vec::<String>::new());
}

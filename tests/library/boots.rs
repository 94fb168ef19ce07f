//! A network without an error boots, and what a boot refuses is an error.
//!
//! Exceptions, which docs/guides/network-boot.md states: a network without a manager is a part of one, and `network boot` ends a run
//! at its time limit.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use objdict::bus::{Conditions, Cut, boot};
use objdict::diagnostic::{Findings, Severity};
use objdict::format::network::{Build, NetworkFile};
use objdict::format::{self, Format};
use objdict::network::DcfgenMode;
use objdict::source::{SourceFile, SourceOptions};

use crate::network::new_folder;
use crate::planted::{mistakes, table};
use crate::support::skips::{sample, skip};
use crate::support::{files_below, fixtures};

/// The most frames of a run.
const FRAMES: usize = 20_000;

/// Edits of each network of the fixtures.
const EDITS: u32 = 12;

/// Numbers that mean something in a network.
const NUMBERS: [&str; 22] = [
    "0",
    "1",
    "2",
    "5",
    "11",
    "12",
    "50",
    "127",
    "200",
    "240",
    "241",
    "252",
    "253",
    "254",
    "1000",
    "0x80",
    "0x185",
    "0x205",
    "0x605",
    "0x40000185",
    "0x80000185",
    "0x20012345",
];

/// Keys of a node in `network.toml`.
const TOML_KEYS: [&str; 12] = [
    "heartbeat = \"20ms\"",
    "heartbeat = \"2s\"",
    "boot = false",
    "mandatory = true",
    "reset-communication = false",
    "serial-number = 0x20",
    "revision-number = 0x20002",
    "software-version = 1",
    "restore = 1",
    "unused-pdos = \"off\"",
    "watches-manager = true",
    "identity = \"none\"",
];

/// Keys of a node in `bus.yml`.
const YML_KEYS: [&str; 10] = [
    "heartbeat_producer: 20",
    "heartbeat_multiplier: 0.5",
    "heartbeat_consumer: true",
    "boot: false",
    "mandatory: true",
    "reset_communication: false",
    "serial_number: 0x20",
    "software_version: 1",
    "guard_time: 100",
    "tpdo: {1: {enabled: true, cob_id: 0x205, transmission: 1}}",
];

fn read(text: &str, path: &Path) -> NetworkFile {
    let name = path.file_name().unwrap().to_string_lossy();
    NetworkFile::read(
        SourceFile::from_text(name.into_owned(), text),
        path.parent().unwrap(),
        &Default::default(),
    )
}

fn errors(findings: &Findings) -> BTreeSet<String> {
    let errors = findings.iter().filter(|finding| finding.severity == Severity::Error);
    errors.map(|finding| format!("{}: {}", finding.rule.id, finding.message)).collect()
}

/// The rules with an error in a device.
fn rules(findings: &Findings) -> BTreeSet<&'static str> {
    let errors = findings.iter().filter(|finding| finding.severity == Severity::Error);
    errors.map(|finding| finding.rule.id).collect()
}

/// Errors of built DCFs that the descriptions of their nodes do not have.
fn errors_of_dcfs(file: &NetworkFile, build: &Build<'_>) -> Option<String> {
    for (node, built) in build.each_dcf() {
        let built = match built {
            Ok(built) if built.name.ends_with(".dcf") => built,
            Ok(_) => continue,
            Err(error) => return Some(error.to_string()),
        };
        let source = SourceFile::from_bytes(&built.name, built.bytes, &SourceOptions::default()).unwrap();
        let found = objdict::check(&format::read(source, Format::Dcf));
        let own = file.description(node).map(objdict::check).unwrap_or_default();
        if !rules(&found).is_subset(&rules(&own)) {
            return Some(format!("{}: {:?}", built.name, errors(&found)));
        }
    }
    None
}

/// What is against a network without errors; `None` for one that keeps the law.
fn broken(file: &NetworkFile) -> Option<String> {
    let network = file.network()?;
    if file.check().has_errors() || network.manager.as_ref()?.node_id.is_none() {
        return None;
    }
    let installation = match file.install(file.boot_files()) {
        Ok(installation) => installation,
        Err(error) => return Some(format!("not installed: {error}")),
    };
    let run = boot(&installation.plant, &Conditions { frames: FRAMES, ..Conditions::default() });
    let is_cut = matches!(run.cut, Some(Cut::Time | Cut::Frames));
    if !run.is_booted() && !is_cut {
        let nodes = run.nodes.iter();
        let nodes = nodes.map(|node| (&node.name, node.state, &node.milestone, node.errors));
        return Some(format!("not booted: {:?}", nodes.collect::<Vec<_>>()));
    }
    errors_of_dcfs(file, &file.build(DcfgenMode::Corrected).ok()?)
}

/// A text without the lines that it does not need to break the law in the same way.
fn smallest(text: &str, path: &Path, why: &str) -> String {
    let kind = |why: &str| why.split(':').next().unwrap().to_owned();
    let mut lines: Vec<&str> = text.lines().collect();
    let mut at = 0;
    while at < lines.len() {
        let mut fewer = lines.clone();
        fewer.remove(at);
        match broken(&read(&fewer.join("\n"), path)) {
            Some(other) if kind(&other) == kind(why) => lines = fewer,
            _ => at += 1,
        }
    }
    lines.join("\n")
}

fn assert_kept(texts: impl IntoIterator<Item = (PathBuf, String)>) -> usize {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (path, text) in texts {
        count += 1;
        if let Some(why) = broken(&read(&text, &path)) {
            let text = smallest(&text, &path, &why);
            let left = broken(&read(&text, &path)).unwrap();
            wrong.push(format!("{}: {left}\n{text}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "{} of {count}:\n{}", wrong.len(), wrong.join("\n\n"));
    count
}

/// The networks below a folder with their texts.
fn networks(folder: &Path) -> Vec<(PathBuf, String)> {
    let paths = files_below(folder, &["toml", "yml", "cpj"]).into_iter();
    paths.filter_map(|path| Some((path.clone(), fs::read_to_string(&path).ok()?))).collect()
}

/// Numbers from a seed.
struct Random(u32);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as usize % count
    }

    fn of<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }
}

/// Where the numbers of a text are.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let is_word = |byte: u8| byte.is_ascii_alphanumeric() || byte == b'_';
    let bytes = text.as_bytes();
    let starts =
        (0..bytes.len()).filter(|&at| bytes[at].is_ascii_digit() && (at == 0 || !is_word(bytes[at - 1])));
    starts.map(|at| at..at + bytes[at..].iter().take_while(|byte| is_word(**byte)).count()).collect()
}

/// A text with a number replaced, a line removed, or a key of a node added.
fn edited(text: &str, is_toml: bool, random: &mut Random) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    match random.below(4) {
        0 => drop(lines.remove(random.below(lines.len()))),
        1 => {
            let is_node = |line: &str| {
                if is_toml { line.starts_with("[node.") } else { line.trim().starts_with("node_id:") }
            };
            let nodes: Vec<usize> = (0..lines.len()).filter(|at| is_node(&lines[*at])).collect();
            if nodes.is_empty() {
                return text.to_owned();
            }
            let at = random.of(&nodes);
            let indent = lines[at].len() - lines[at].trim_start().len();
            let key = if is_toml { random.of(&TOML_KEYS) } else { random.of(&YML_KEYS) };
            lines.insert(at + 1, format!("{}{key}", " ".repeat(indent)));
        }
        _ => {
            let found = numbers(text);
            if found.is_empty() {
                return text.to_owned();
            }
            let range = found[random.below(found.len())].clone();
            return format!("{}{}{}", &text[..range.start], random.of(&NUMBERS), &text[range.end..]);
        }
    }
    lines.join("\n")
}

/// A drive as node 5 of a network with SYNC, and these keys.
fn drive(keys: &str) -> NetworkFile {
    node("eds/drive-402.eds", keys)
}

fn node(file: &str, keys: &str) -> NetworkFile {
    let head = "[bus]\nbit-rate = 250\nmanager = \"m\"\nsync = \"20ms\"\n[manager]\nid = 1\n";
    let text = format!("{head}[node.a]\nfile = \"{file}\"\nid = 5\n{keys}\n");
    read(&text, &fixtures().join("network.toml"))
}

/// The findings of a severity: rule and message.
fn found(file: &NetworkFile, severity: Severity) -> Vec<String> {
    let findings = file.check();
    let findings = findings.iter().filter(|finding| finding.severity == severity);
    findings.map(|finding| format!("{}: {}", finding.rule.name(), finding.message)).collect()
}

/// What a description cannot satisfy, and what the rules of CiA 301 say of the effective dictionary.
#[test]
fn each_kind_is_found_where_it_is_set() {
    let errors = [
        (
            "software-version = 1",
            "missing-entry: `a` has no 1F56h:01, so the manager cannot check its software",
        ),
        ("revision-number = 0x20002", "wrong-identity: the revision number of `a` is 20002h"),
        (
            "set = { \"1400:1\" = 0x185 }",
            "can-id-in-both-directions: `a`: TPDO 1 transmits and RPDO 1 receives",
        ),
        ("set = { \"1801:1\" = 0x185 }", "duplicate-can-id: TPDO 1 of `a` and TPDO 2 of `a` both send 185h"),
        (
            "heartbeat = \"1s\"\nwatch = \"1.0x\"",
            "short-heartbeat-time: `m` considers `a` lost after 1000 ms",
        ),
    ];
    for (keys, expected) in errors {
        let found = found(&drive(keys), Severity::Error);
        assert!(matches!(found.as_slice(), [one] if one.starts_with(expected)), "{keys}: {found:?}");
    }
    let reserved = node("network/servo.eds", "set = { \"1016:1\" = 0xC8000500 }");
    let found_there = found(&reserved, Severity::Error);
    let expected = "invalid-consumer-heartbeat: `a`: `0xC8000500` in 1016h sub-index 1 has bits";
    assert!(matches!(found_there.as_slice(), [one] if one.starts_with(expected)), "{found_there:?}");
    let warnings = [
        ("set = { \"1800:6\" = 3 }", "invalid-sync-start-value: `a`: the SYNC start value `3` of TPDO 1"),
        (
            "set = { \"1800:1\" = 0x40000185, \"1800:2\" = 253 }",
            "rtr-pdo-without-rtr: `a`: TPDO 1 is sent only",
        ),
        (
            "heartbeat = \"1s\"\nwatch = \"1.2x\"",
            "short-heartbeat-time: `m` considers `a` lost after 1200 ms",
        ),
    ];
    let healthy = found(&drive(""), Severity::Warning);
    for (keys, expected) in warnings {
        let file = drive(keys);
        let found = found(&file, Severity::Warning);
        let new: Vec<_> = found.iter().filter(|found| !healthy.contains(found)).collect();
        assert!(matches!(new.as_slice(), [one] if one.starts_with(expected)), "{keys}: {new:?}");
        assert_eq!(broken(&file), None, "{keys}");
    }
}

/// A serial number that the DCF states for LSS is what the node answers.
#[test]
fn numbers_of_a_dcf_are_those_of_its_node() {
    let head = "[bus]\nmanager = \"m\"\nunused-pdos = \"off\"\n[manager]\nid = 1\n";
    let node = |file: &str, keys: &str| {
        let text = format!("{head}[node.a]\nfile = \"{file}\"\n{keys}\n");
        read(&text, &fixtures().join("network.toml"))
    };
    let other = node("dcf/drive-402-node8.dcf", "id = 5");
    let expected = "other-node-id: `a` is node 5, but its DCF was created for node 8";
    assert!(found(&other, Severity::Warning).contains(&expected.to_owned()));
    assert_eq!(found(&other, Severity::Error), Vec::<String>::new());
    let folder = new_folder("boots-other-node");
    let dcf = fs::read_to_string(fixtures().join("dcf/drive-402-node8.dcf")).unwrap();
    let numbers = [("$NODEID+0x600", "0x608"), ("$NODEID+0x580", "0x588")];
    let literal = numbers.iter().fold(dcf, |dcf, (formula, number)| dcf.replace(formula, number));
    fs::write(folder.join("drive.dcf"), literal).unwrap();
    let text = format!("{head}[node.a]\nfile = \"drive.dcf\"\nid = 5\n");
    let errors = found(&read(&text, &folder.join("network.toml")), Severity::Error);
    let is_of_sdo = |error: &String| error.starts_with("default-sdo-cob-id: `a`: ");
    assert!(errors.len() == 2 && errors.iter().all(is_of_sdo), "{errors:?}");
    let serial = node("dcf/drive-402-node8.dcf", "serial-number = 0x20");
    let found = found(&serial, Severity::Error);
    assert!(
        matches!(found.as_slice(), [one] if one.starts_with("wrong-identity: the serial number of `a` is 20h"))
    );
}

#[test]
fn two_pdos_of_an_undescribed_manager_need_two_can_ids() {
    let rpdo = "rpdo: {1: {cob_id: 0x205, mapping: [{index: 0x6040, sub_index: 0}]}}";
    let node = |name: &str, id: u8| format!("{name}:\n  node_id: {id}\n  dcf: servo.eds\n  {rpdo}\n");
    let text = format!("master:\n  node_id: 1\n{}{}", node("a", 5), node("b", 6));
    let file = read(&text, &fixtures().join("network/bus.yml"));
    let expected = "duplicate-can-id: TPDO 1 of `master` and TPDO 2 of `master` both send 205h";
    assert_eq!(found(&file, Severity::Error), [expected]);
}

/// An RPDO without entries is switched off, one that maps fewer bytes takes the first ones, and one that maps more takes none.
#[test]
fn an_rpdo_takes_the_bytes_that_it_maps() {
    let cases = [
        ("[]", None, true),
        ("[\"6040\"]", Some((Severity::Warning, "maps 16 bits of the 48")), true),
        ("[\"6040\", \"607A\"]", None, true),
        ("[\"607A\", \"6040\", \"6040\"]", Some((Severity::Error, "maps 64 bits of the 48")), false),
    ];
    let head = "[bus]\nbit-rate = 250\nmanager = \"m\"\nunused-pdos = \"off\"\n[manager]\nid = 1\n";
    let drive = |name: &str, id: u8| format!("[node.{name}]\nfile = \"network/servo.eds\"\nid = {id}\n");
    let sent =
        "tpdo.1 = { cob-id = 0x185, transmission = 255, map = [\"6041\", \"6064\"], event-timer = 10 }\n";
    for (map, finding, is_booted) in cases {
        let received = format!("rpdo.1 = {{ cob-id = 0x185, transmission = 255, map = {map} }}\n");
        let text = format!("{head}{}{sent}{}{received}", drive("a", 5), drive("b", 6));
        let file = read(&text, &fixtures().join("network.toml"));
        let findings = file.check();
        let found: Vec<_> = findings.iter().filter(|found| found.rule.name() == "pdo-length").collect();
        let is_expected = match (found.as_slice(), finding) {
            ([], None) => true,
            ([found], Some((severity, text))) => {
                found.severity == severity && found.message.to_string().contains(text)
            }
            _ => false,
        };
        assert!(
            is_expected,
            "{map}: {:?}",
            findings.iter().map(|f| f.message.to_string()).collect::<Vec<_>>()
        );
        let plant = file.install(file.boot_files()).unwrap().plant;
        assert_eq!(boot(&plant, &Conditions::default()).is_booted(), is_booted, "{map}");
        assert_ne!(is_booted, findings.has_errors(), "{map}: {:?}", errors(&findings));
    }
}

/// A node that monitors the manager by two keys has one time, or an error.
#[test]
fn two_keys_about_the_manager_have_one_meaning() {
    let head =
        "[bus]\nbit-rate = 250\nmanager = \"m\"\nunused-pdos = \"off\"\n[manager]\nid = 1\nheartbeat = 100\n";
    for (time, is_contradicted) in [("500ms", true), ("300ms", false), ("3x", false), ("2.5x", true)] {
        let node = "[node.a]\nfile = \"network/servo.eds\"\nid = 5\nwatches-manager = true\n";
        let text = format!("{head}{node}watches = {{ m = \"{time}\" }}\n");
        let file = read(&text, &fixtures().join("network.toml"));
        let found = found(&file, Severity::Error);
        let expected = "contradictory-values: 1016h:01 of `a` is set to ";
        match is_contradicted {
            true => {
                assert!(matches!(found.as_slice(), [one] if one.starts_with(expected)), "{time}: {found:?}");
            }
            false => assert_eq!(found, [""; 0], "{time}"),
        }
        let device = &file.compiled().unwrap().slaves[0].device;
        let consumers: Vec<_> = device.services().heartbeat_consumers.iter().map(|of| of.node_id).collect();
        assert_eq!(consumers, [1], "{time}");
    }
}

/// A fault is told once, at its cause: a manager or a node that is not read, a value that is refused, and its download.
#[test]
fn a_fault_is_one_finding() {
    let head = "[bus]\nbit-rate = 250\nmanager = \"m\"\nsync = \"20ms\"\nunused-pdos = \"off\"\n";
    let manager = "[manager]\nid = 1\n";
    let node = |name: &str, id: u8, keys: &str| {
        format!("[node.{name}]\nfile = \"network/servo.eds\"\nid = {id}\n{keys}")
    };
    let linked = "[[link]]\nfrom = \"a.6041\"\nto = [\"m\", \"b.6040\"]\n";
    let both =
        node("a", 5, "watches = { b = \"500ms\" }\n") + &node("b", 6, "heartbeat = \"100ms\"\n") + linked;
    let sdo = "[[node.a.sdo]]\nentry = \"6060\"\nvalue = [99, 5]\n";
    let texts = [
        (format!("{head}[manager]\nid = 200\n{both}"), "out-of-range"),
        (format!("{head}[manager]\nheartbeat = 100\n{both}"), "unknown-node"),
        (format!("{head}{both}"), "unknown-node"),
        (format!("{head}{manager}{both}").replace("id = 6", "id = 200"), "out-of-range"),
        (
            format!("{head}{manager}{}", both.replace("servo.eds\"\nid = 6", "no.eds\"\nid = 6")),
            "unreadable-node",
        ),
        (format!("{head}{manager}{}{sdo}", node("a", 5, "")), "invalid-value"),
    ];
    let found = |text: &str| {
        let findings = read(text, &fixtures().join("network.toml")).check();
        findings.iter().map(|found| format!("{}: {}", found.rule.name(), found.message)).collect::<Vec<_>>()
    };
    assert_eq!(found(&format!("{head}{manager}{both}")), [""; 0]);
    for (text, rule) in texts {
        let found = found(&text);
        assert!(matches!(found.as_slice(), [one] if one.starts_with(rule)), "{text}\n{found:?}");
    }
}

/// A network of `drive.eds`, which is `servo.eds` with another text.
fn of_servo(folder: &str, (old, new): (&str, &str)) -> NetworkFile {
    let folder = new_folder(folder);
    let servo = fs::read_to_string(fixtures().join("network/servo.eds")).unwrap().replace("\r\n", "\n");
    let changed = servo.replacen(old, new, 1);
    assert_ne!(servo, changed, "{old}");
    fs::write(folder.join("drive.eds"), changed).unwrap();
    let text =
        "[bus]\nbit-rate = 250\nmanager = \"m\"\n[manager]\nid = 1\n[node.a]\nfile = \"drive.eds\"\nid = 5\n";
    read(text, &folder.join("network.toml"))
}

/// What a DCF of an XDD states itself is not there a second time, as the vendor wrote it.
#[test]
fn a_version_that_is_no_number_is_not_in_the_dcf() {
    let folder = new_folder("version");
    let device = fs::read_to_string(fixtures().join("bases/device.xdd")).unwrap();
    assert!(device.contains("fileVersion=\"1\""));
    fs::write(folder.join("a.xdd"), device.replace("fileVersion=\"1\"", "fileVersion=\"-\"")).unwrap();
    let text = "[bus]\n[manager]\nid = 1\n[node.a]\nfile = \"a.xdd\"\nid = 5\n";
    let file = read(text, &folder.join("network.toml"));
    let build = file.build(DcfgenMode::Corrected).unwrap();
    assert_eq!(errors_of_dcfs(&file, &build), None);
    let dcf =
        build.each_dcf().find_map(|(_, built)| built.ok().filter(|built| built.name == "a.dcf")).unwrap();
    let dcf = String::from_utf8(dcf.bytes).unwrap();
    assert_eq!(
        dcf.lines().filter(|line| line.starts_with("FileVersion")).collect::<Vec<_>>(),
        ["FileVersion=1"]
    );
}

/// What a description gives a service is checked like what the network gives it.
#[test]
fn a_description_has_no_restricted_can_id() {
    for (old, new, service) in [
        ("DefaultValue=$NODEID+0x80\n", "DefaultValue=0x000\n", "EMCY of `a` has the CAN-ID 000h"),
        ("DefaultValue=$NODEID+0x80\n", "DefaultValue=0x101\n", "EMCY of `a` has the CAN-ID 101h"),
        ("DefaultValue=0x100\n", "DefaultValue=0x400006E0\n", "TIME of `a` has the CAN-ID 6E0h"),
        ("DefaultValue=0x100\n", "DefaultValue=0x80000701\n", "TIME of `a` has the CAN-ID 701h"),
        (
            "DefaultValue=$NODEID+0x40000180\n",
            "DefaultValue=0x40000601\n",
            "TPDO 1 of `a` has the CAN-ID 601h",
        ),
    ] {
        let found = found(&of_servo("restricted", (old, new)), Severity::Error);
        let expected = format!("restricted-can-id: {service}, which is restricted");
        assert!(found.iter().any(|found| found.starts_with(&expected)), "{new}: {found:?}");
    }
}

/// The manager's entries for those of a node have the length that the node maps, and a type, though the node has them not.
#[test]
fn a_made_manager_is_right_about_a_node_that_is_not() {
    for (old, new) in [
        ("DefaultValue=0x60410010\n", "DefaultValue=0x60410020\n"),
        (
            "[6041]\nParameterName=Statusword\nObjectType=0x7\nDataType=0x0006\n",
            "[6041]\nParameterName=Statusword\n",
        ),
    ] {
        let file = of_servo("mapped", (old, new));
        let built = file.build(DcfgenMode::Corrected).unwrap().manager().unwrap();
        let text = String::from_utf8(built.bytes).unwrap();
        let found = objdict::check(&format::read(SourceFile::from_text("m.dcf", text), Format::Dcf));
        assert_eq!(errors(&found), BTreeSet::new(), "{new}");
    }
}

/// The built DCFs have no warnings that the descriptions do not have, but for values that DCFs have in one line, a vendor-ID that
/// no file states, and the retry factor that dcfgen writes. Nothing of the DCF of a manager that is made is left for comments.
#[test]
fn built_dcfs_have_no_warnings_of_their_own() {
    const KNOWN: [&str; 3] = ["cia301/vendor-id-zero", "cia302/incomplete-guarding", "cia306/line-too-long"];
    let warned = |findings: &Findings| -> BTreeSet<&'static str> {
        let found = findings.iter().filter(|finding| finding.severity == Severity::Warning);
        found.map(|finding| finding.rule.id).collect()
    };
    let mut count = 0;
    for (path, text) in networks(&fixtures().join("network")) {
        let file = read(&text, &path);
        let Ok(build) = file.build(DcfgenMode::Corrected) else { continue };
        for (node, built) in build.each_dcf().filter_map(|(node, built)| Some((node, built.ok()?))) {
            let is_made = file.network().unwrap().is_made(node);
            let text = String::from_utf8_lossy(&built.bytes).into_owned();
            assert!(!is_made || !text.contains("objdict-embed"), "{}: {}", path.display(), built.name);
            let format = if built.name.ends_with(".xdc") { Format::Xdc } else { Format::Dcf };
            let found =
                warned(&objdict::check(&format::read(SourceFile::from_text(&built.name, text), format)));
            let own = file.description(node).map(|own| warned(&objdict::check(own))).unwrap_or_default();
            let new: Vec<_> = found.difference(&own).filter(|rule| !KNOWN.contains(rule)).collect();
            assert!(new.is_empty(), "{}: {}: {new:?}", path.display(), built.name);
            count += 1;
        }
    }
    assert!(count > 10, "{count}");
}

/// Of a CAN-ID of 29 bits, which is not simulated, there is one note.
#[test]
fn a_service_that_is_not_simulated_has_one_note() {
    let file = node("network/servo.eds", "tpdo.1 = { cob-id = 0x20012345, transmission = 255 }");
    let run = boot(&file.install(file.boot_files()).unwrap().plant, &Conditions::default());
    let expected =
        "RPDO 1 of `m` and TPDO 1 of `a` have the CAN-ID 00012345h of 29 bits, which is not simulated";
    assert_eq!((run.not_simulated(), run.is_booted()), (vec![expected.to_owned()], true));
}

/// dcfgen takes a configured value of an EDS for what the node has, and so does the boot.
#[test]
fn configured_values_of_an_eds_are_there_at_power_on() {
    let folder = new_folder("boots-configured");
    let path = fixtures().join("network/servo.eds");
    let eds = fs::read_to_string(path).unwrap().replace("\r\n", "\n");
    let at = eds.find("[1017]\n").unwrap() + "[1017]\n".len();
    fs::write(folder.join("servo.eds"), format!("{}ParameterValue=100\n{}", &eds[..at], &eds[at..])).unwrap();
    let text = "master:\n  node_id: 1\na:\n  node_id: 5\n  dcf: servo.eds\n";
    let file = read(text, &folder.join("bus.yml"));
    let run = boot(&file.install(file.boot_files()).unwrap().plant, &Conditions::default());
    assert!(run.is_booted() && run.nodes[1].downloads == 0);
}

/// The DCF of a manager, alone and in a network: a concise DCF with a wrong number of downloads.
#[test]
fn a_malformed_configuration_is_found_in_its_file() {
    let file = drive("heartbeat = \"1s\"");
    let manager = file.build(DcfgenMode::Corrected).unwrap().manager().unwrap();
    let text = String::from_utf8(manager.bytes).unwrap();
    let at = text.find("ParameterValue=01000000").unwrap() + "ParameterValue=".len();
    let check = |text: String| {
        let source = SourceFile::from_text("m.dcf", text);
        errors(&objdict::check(&format::read(source, Format::Dcf)))
    };
    assert_eq!(check(text.clone()), BTreeSet::new());
    let found = check(format!("{}09{}", &text[..at], &text[at + 2..]));
    let expected = "network/invalid-configuration: the configuration in 1F22h:05 is not valid: ";
    assert!(found.len() == 1 && found.iter().all(|found| found.starts_with(expected)), "{found:?}");
}

#[test]
fn the_fixtures_keep_the_law() {
    let folders = ["network", "rules/network"].map(|folder| fixtures().join(folder));
    assert!(assert_kept(sample(folders.iter().flat_map(|folder| networks(folder)))) > 25);
}

#[test]
fn edited_networks_keep_the_law() {
    let bases = networks(&fixtures().join("network")).into_iter();
    let edits =
        bases.flat_map(|(path, text)| (0..EDITS * 4).map(move |seed| (path.clone(), text.clone(), seed)));
    let texts = sample(edits).into_iter().map(|(path, text, seed)| {
        let is_toml = path.extension().is_some_and(|ending| ending == "toml");
        let mut random = Random(seed);
        let times = 1 + random.below(2);
        (path, (0..times).fold(text, |text, _| edited(&text, is_toml, &mut random)))
    });
    assert_kept(texts);
}

#[test]
fn planted_mistakes_keep_the_law() {
    let table = table();
    let is_network = |name: &str| [".toml", ".yml"].iter().any(|ending| name.ends_with(ending));
    let planted = mistakes(&table).into_iter().filter(|mistake| is_network(mistake.file)).map(|mistake| {
        let path = fixtures().join(mistake.file);
        let text = fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
        (path, mistake.plant(&text))
    });
    assert!(assert_kept(planted) > 10);
}

/// Each device of a corpus as a node of networks with a few keys, beside the networks that are there.
#[test]
fn the_networks_of_the_corpus_keep_the_law() {
    let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") else {
        return skip("no `OBJDICT_CORPUS_DIR`");
    };
    let folder = Path::new(&folder);
    let devices = files_below(folder, &["eds", "dcf", "xdd", "xdc"]).into_iter().enumerate();
    let texts = devices.map(|(number, path)| {
        let head = "[bus]\nbit-rate = 250\nmanager = \"m\"\nsync = \"20ms\"\nunused-pdos = \"off\"\n[manager]\nid = 1\n";
        let keys = [TOML_KEYS[number % TOML_KEYS.len()], "heartbeat = \"1s\""][number % 2];
        let file = path.file_name().unwrap().to_string_lossy();
        let text = format!("{head}[node.a]\nfile = {file:?}\nid = 5\n{keys}\n");
        (path.with_file_name("network.toml"), text)
    });
    let count = assert_kept(networks(folder).into_iter().chain(texts));
    assert!(count > 100, "{count} networks");
}

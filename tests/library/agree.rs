//! What is checked, shown, built and booted of a network is the same.

use std::path::Path;

use objdict::bus::{Conditions, Milestone, Run, boot};
use objdict::download::ConciseDcf;
use objdict::format::network::{BootFiles, BuiltFile, NetworkFile};
use objdict::network::{DcfgenMode, LelyOptions, Overview};
use objdict::source::SourceFile;

use crate::network::{new_folder, objections, path, verified};

/// A manager without a description, at 125 kbit/s.
const HEAD: &str = "[bus]\nbit-rate = 125\nmanager = \"m\"\n[manager]\nid = 1\n";

/// A changed copy of a fixture: its name, the fixture, and what is replaced in it.
type Copied<'a> = (&'a str, &'a str, &'a [(&'a str, &'a str)]);

/// A network whose descriptions are changed copies of fixtures.
fn network(name: &str, text: &str, copies: &[Copied<'_>]) -> NetworkFile {
    let folder = new_folder(&format!("agree-{name}"));
    for (copy, fixture, changes) in copies {
        let mut description = std::fs::read_to_string(path(fixture)).unwrap().replace("\r\n", "\n");
        for (from, to) in *changes {
            assert!(description.contains(from), "{fixture} has no `{from}`");
            description = description.replacen(from, to, 1);
        }
        std::fs::write(folder.join(copy), description).unwrap();
    }
    NetworkFile::read(SourceFile::from_text("network.toml", text), &folder, &Default::default())
}

fn found(file: &NetworkFile) -> Vec<String> {
    let findings = file.check();
    findings.iter().map(|finding| format!("{}: {}", finding.rule.name(), finding.message)).collect()
}

/// What is found, after the built files for Lely and the DCFs were verified.
fn agreed(file: &NetworkFile) -> Vec<String> {
    let build = file.build(DcfgenMode::Corrected).unwrap();
    verified(&build, build.lely(&LelyOptions::default()).unwrap());
    verified(&build, build.dcfs().unwrap());
    assert!(booted(file).is_booted());
    found(file)
}

fn booted(file: &NetworkFile) -> Run {
    boot(&file.install(BootFiles::Dcf).unwrap().plant, &Conditions::default())
}

/// What the manager checks of the first node, in words.
fn checked(file: &NetworkFile) -> String {
    let overview = overview(file);
    let steps = &overview.boot.unwrap().nodes[0].steps;
    steps.iter().find(|step| step.starts_with("checks")).cloned().unwrap_or_default()
}

fn overview(file: &NetworkFile) -> Overview {
    Overview::new(file.network().unwrap(), file.compiled().unwrap())
}

fn master(file: &NetworkFile, mode: DcfgenMode) -> String {
    let build = file.build(mode).unwrap();
    let files = build.lely(&LelyOptions { mode, ..LelyOptions::default() }).unwrap();
    String::from_utf8(files[0].bytes.clone()).unwrap()
}

#[test]
fn the_boot_plan_has_the_numbers_that_the_manager_compares() {
    let file = crate::network::open("chapter4.toml");
    assert_eq!(
        checked(&file),
        "checks vendor-ID 000003F9h, product code 0000000Bh, revision number 00010000h"
    );
    let text = format!("{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\nidentity = \"vendor\"\n");
    assert_eq!(
        checked(&network("plan", &text, &[("a.eds", "middle.eds", &[])])),
        "checks vendor-ID 000003F9h"
    );
}

/// Lely's RPDOs do not take what comes with the types 252 and 253, which dcfgen copies.
#[test]
fn the_manager_receives_requested_pdos() {
    for (word, number) in [("rtr", 253), ("rtr-sync", 252)] {
        let text =
            format!("{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\ntpdo.1 = {{ transmission = \"{word}\" }}\n");
        let text = if number == 252 { text.replace("125\n", "125\nsync = \"10ms\"\n") } else { text };
        let file = network(word, &text, &[("a.eds", "middle.eds", &[])]);
        let build = file.build(DcfgenMode::Corrected).unwrap();
        verified(&build, build.lely(&LelyOptions::default()).unwrap());
        verified(&build, build.dcfs().unwrap());
        assert_eq!(found(&file), [""; 0], "{word}");
        let type_of = |mode| {
            let master = master(&file, mode);
            let (_, entry) = master.split_once("[1400sub2]").unwrap();
            entry.lines().find_map(|line| line.strip_prefix("DefaultValue=")).map(str::to_owned)
        };
        assert_eq!(type_of(DcfgenMode::Corrected).as_deref(), Some("0xFF"), "{word}");
        assert_eq!(type_of(DcfgenMode::Exact), Some(format!("{number:#X}").replace("0X", "0x")), "{word}");
    }
}

#[test]
fn a_bit_rate_is_that_of_the_dcfs_or_none() {
    let head = HEAD.replace("bit-rate = 125\n", "");
    let nodes = "[node.a]\nfile = \"a.dcf\"\n[node.b]\nfile = \"b.dcf\"\nid = 6\n";
    let rated = |name: &str, rate: &str| {
        let other = format!("Baudrate={rate}");
        let copies: [Copied<'_>; 2] =
            [("a.dcf", "bare.dcf", &[]), ("b.dcf", "bare.dcf", &[("Baudrate=250", &other)])];
        network(name, &format!("{head}{nodes}"), &copies)
    };
    let same = rated("rates", "250");
    assert!(!found(&same).iter().any(|line| line.contains("kbit/s")), "{:?}", found(&same));
    assert!(master(&same, DcfgenMode::Corrected).contains("\nBaudrate=250\n"));
    assert_eq!(overview(&same).bit_rate, Some(250));
    let other = rated("other-rates", "125");
    assert!(found(&other).iter().any(|line| line.starts_with("unsupported-bit-rate")), "{:?}", found(&other));
    let text = format!("{head}[node.a]\nfile = \"a.eds\"\nid = 5\n");
    let none = network("no-rate", &text, &[("a.eds", "middle.eds", &[])]);
    assert_eq!(agreed(&none), [""; 0]);
    assert!(master(&none, DcfgenMode::Corrected).contains("\nBaudrate=\n"));
    let text = "master:\n  node_id: 1\na:\n  dcf: a.eds\n  node_id: 5\n";
    let dcfgen = network("dcfgen-rate", text, &[("a.eds", "middle.eds", &[])]);
    assert!(master(&dcfgen, DcfgenMode::Corrected).contains("\nBaudrate=1000\n"));
    assert_eq!(overview(&dcfgen).bit_rate, Some(1000));
}

/// FFFFFFFFh, and numbers that the node does not have, are not compared.
#[test]
fn the_manager_expects_what_the_node_answers() {
    let node = |more: &str| format!("{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\n{more}");
    let whole = "checks vendor-ID 000003F9h, product code 0000000Dh, revision number 00010000h";
    let keys = node("revision-number = 0xFFFFFFFF\nserial-number = 0xFFFFFFFF\n");
    let file = network("placeholder-keys", &keys, &[("a.eds", "middle.eds", &[])]);
    assert_eq!((agreed(&file), checked(&file)), (Vec::new(), whole.to_owned()));
    let unknown: &[(&str, &str)] = &[("DefaultValue=0x00010000", "DefaultValue=0xFFFFFFFF")];
    let file = network("placeholder", &node(""), &[("a.eds", "middle.eds", unknown)]);
    let short = whole.replace(", revision number 00010000h", "");
    assert_eq!((agreed(&file), checked(&file)), (Vec::new(), short.clone()));
    let absent: &[(&str, &str)] = &[("[1018sub3]", "[Unused]")];
    let file = network("absent-number", &node(""), &[("a.eds", "middle.eds", absent)]);
    assert_eq!((agreed(&file), checked(&file)), (Vec::new(), short.clone()));
    let file = network("absent-key", &node("revision-number = 7\n"), &[("a.eds", "middle.eds", absent)]);
    let message = "missing-entry: `a` has no 1018h:03, so the manager does not check its revision number";
    assert_eq!((agreed(&file), checked(&file)), (vec![message.to_owned()], short));
    // `DeviceInfo` says something else than the node answers
    let other: &[(&str, &str)] = &[("DefaultValue=0x00010000", "DefaultValue=0x00020000")];
    let file = network("other-number", &node(""), &[("a.eds", "middle.eds", other)]);
    assert!(checked(&file).ends_with("revision number 00020000h"));
    assert!(
        agreed(&file)[0].starts_with("ambiguous-identity: the manager expects the revision number 20000h")
    );
}

#[test]
fn a_node_without_a_device_type_is_not_booted() {
    let text = format!("{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\n");
    let file = network("no-1000h", &text, &[("a.eds", "middle.eds", &[("[1000]", "[Unused]")])]);
    assert_eq!(found(&file), ["missing-entry: `a` has no 1000h, so the manager does not boot it"]);
    let run = booted(&file);
    let Some(Milestone::Failed(failure)) = &run.nodes[1].milestone else { panic!("{:?}", run.nodes[1]) };
    assert!(failure.status() == 'B' && failure.to_string().starts_with("aborts the upload of 1000:00"));
    assert!(run.end < 2_000_000_000, "{}", run.end);
}

/// Without the node it would be another network, which boots.
#[test]
fn a_network_with_a_node_that_cannot_be_read_is_not_booted() {
    let refused = |name, key: &str| {
        let text = format!("{HEAD}[node.a]\nfile = \"{key}\n");
        let file = network(name, &text, &[("a.eds", "middle.eds", &[])]);
        let error = file.install(BootFiles::Dcf).unwrap_err();
        (error.to_string(), error.help().unwrap_or_default())
    };
    let (message, help) = refused("unread", "b.eds\"\nid = 5");
    assert!(message.starts_with("the description of `a`: cannot read `b.eds`: "), "{message}");
    assert!(help.starts_with("correct the path"), "{help}");
    assert_eq!(refused("without-id", "a.eds\"").0, "`a` has no node-ID");
}

/// A literal COB-ID of EMCY that a single download changes: check, build and boot refuse it alike; `set` changes it.
#[test]
fn an_identifier_in_use_is_not_changed() {
    let literal: &[(&str, &str)] = &[("=$NODEID+0x80\n", "=0x86\n")];
    let copies: [Copied<'_>; 1] = [("a.eds", "middle.eds", literal)];
    let node = |more: &str| format!("{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\n{more}");
    let file = network("emcy", &node("sdo = [{ entry = \"1014\", value = 0x85 }]\n"), &copies);
    let reason = "the identifier changes while `0x86` is in use";
    assert_eq!(found(&file), [format!("refused-download: `a` rejects the download to 1014h:00: {reason}")]);
    let build = file.build(DcfgenMode::Corrected).unwrap();
    for files in [build.dcfs(), build.concise(), build.lely(&LelyOptions::default())] {
        let refused = format!("`a` rejects download 1, 1014:00: {reason}");
        assert_eq!(objections(&build, &files.unwrap()), [refused]);
    }
    assert!(!booted(&file).is_booted());
    assert_eq!(agreed(&network("emcy-set", &node("set = { \"1014\" = 0x85 }\n"), &copies)), [""; 0]);
}

#[test]
fn another_sync_counter_is_found_before_the_build() {
    let text = format!(
        "{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\nset = {{ \"1019\" = 16, \"1006\" = 10000, \"1005\" = 0x40000080 }}\n\
         tpdo.1 = {{ transmission = \"sync/1\" }}\n"
    );
    let file = network("counter", &text, &[("a.eds", "counter.eds", &[])]);
    let message = "`manager` expects SYNC with the counter overflow 0, but it is 16";
    let message = message.replace("manager", "m");
    assert!(found(&file).contains(&format!("sync-counter: {message}")), "{:?}", found(&file));
    let build = file.build(DcfgenMode::Corrected).unwrap();
    assert!(objections(&build, &build.dcfs().unwrap()).contains(&message));
    let same = text.replace("125\n", "125\nsync-overflow = 16\n");
    let same = network("same-counter", &same, &[("a.eds", "counter.eds", &[])]);
    assert!(!found(&same).iter().any(|line| line.starts_with("sync-counter")), "{:?}", found(&same));
}

#[test]
fn both_senders_of_a_can_id_show_their_lengths() {
    let node = |name: &str, id| {
        format!("[node.{name}]\nfile = \"{name}.eds\"\nid = {id}\ntpdo.1 = {{ cob-id = 0x185 }}\n")
    };
    let text = format!("{HEAD}{}{}", node("a", 5), node("b", 6));
    let file = network("lengths", &text, &[("a.eds", "island.eds", &[]), ("b.eds", "middle.eds", &[])]);
    let overview = overview(&file);
    let row = overview.messages.iter().find(|row| row.can_id.number == 0x185).unwrap();
    assert_eq!((row.length(), row.bytes), ("8, 2".to_owned(), Some(8)));
}

#[test]
fn only_near_indexes_are_meant() {
    let help = |entry: &str| {
        let text = format!("{HEAD}[node.a]\nfile = \"a.eds\"\nid = 5\nset = {{ \"{entry}\" = 1 }}\n");
        let file = network("near", &text, &[("a.eds", "island.eds", &[])]);
        let findings = file.check();
        let finding = findings.iter().find(|finding| finding.rule.name() == "invalid-setting").unwrap();
        finding.help.as_ref().unwrap().to_string()
    };
    assert_eq!(help("6423"), "`objdict show` lists the objects");
    assert_eq!(help("6402"), "did you mean `6401`?");
    assert_eq!(help("6104"), "did you mean `6401`?");
}

/// Eight devices of vendors, with links, boot: `OBJDICT_CORPUS_DIR` names the folder of their files.
#[test]
fn a_plant_of_eight_vendor_devices_boots() {
    let Some(corpus) = std::env::var_os("OBJDICT_CORPUS_DIR") else { return };
    let Ok(folder) = std::fs::read_dir(Path::new(&corpus).join("eds")) else { return };
    let mut paths: Vec<_> = folder.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let mut text = HEAD.to_owned();
    let mut count = 0;
    for path in paths {
        let node = format!("[node.n{count}]\nfile = {path:?}\nid = {}\nunused-pdos = \"off\"\n", count + 2);
        let alone = NetworkFile::read(
            SourceFile::from_text("network.toml", format!("{HEAD}{node}")),
            Path::new(&corpus),
            &Default::default(),
        );
        if !alone.check().has_errors() {
            text += &node;
            count += 1;
        }
        if count == 8 {
            break;
        }
    }
    let source = SourceFile::from_text("network.toml", text);
    let file = NetworkFile::read(source, Path::new(&corpus), &Default::default());
    assert!(!file.check().has_errors(), "{:?}", found(&file));
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let files: Vec<BuiltFile> = verified(&build, build.concise().unwrap());
    assert!(files.iter().all(|file| ConciseDcf::parse(&file.bytes).is_ok()));
    assert!(count < 8 || booted(&file).is_booted());
}

//! A lock keeps CAN-IDs, PDOs and the objects of the manager, whatever is added before them.

use std::collections::BTreeMap;

use objdict::diagnostic::{Findings, Severity};
use objdict::format::network::{NetworkFile, PathOptions, read_lock, write_lock};
use objdict::model::PdoKind;
use objdict::network::{DcfgenMode, LelyOptions, NetworkLock};
use objdict::source::SourceFile;

use crate::support::fixtures;

const NODES: [&str; 4] = ["left", "right", "island 3", "é"];

/// Numbers from a seed.
struct Random(u32);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as usize % count
    }
}

/// A link: from an input of one node to an output of another one, or to the manager.
type TestLink = (usize, usize, Option<(usize, usize)>);

fn link(random: &mut Random) -> TestLink {
    let from = random.below(NODES.len());
    let to = (from + 1 + random.below(NODES.len() - 1)) % NODES.len();
    (from, 1 + random.below(5), Some((to, 1 + random.below(5))).filter(|_| random.below(2) == 0))
}

fn text(nodes: &[usize], links: &[TestLink]) -> String {
    let mut text =
        "[bus]\nbit-rate = 250\nmanager = \"plc\"\nunused-pdos = \"off\"\n[manager]\nid = 1\n".to_owned();
    for &node in nodes {
        text += &format!("[node.{:?}]\nfile = \"island.eds\"\nid = {}\n", NODES[node], 5 + node);
    }
    for (from, sub, to) in links.iter().filter(|(from, ..)| nodes.contains(from)) {
        let to = match to {
            Some((to, _)) if !nodes.contains(to) => continue,
            Some((to, sub)) => format!("{}.6200:{sub}", NODES[*to]),
            None => "plc".to_owned(),
        };
        text += &format!("[[link]]\nfrom = \"{}.6000:{sub}\"\nto = {to:?}\n", NODES[*from]);
    }
    text
}

fn built(text: &str, lock: &NetworkLock) -> (NetworkLock, String, Vec<String>) {
    let options = PathOptions { lock: lock.clone(), ..PathOptions::default() };
    let source = SourceFile::from_text("network.toml", text);
    let file = NetworkFile::read(source, &fixtures().join("network"), &options);
    let build = file.build(DcfgenMode::Corrected).unwrap();
    let master = build.lely(&LelyOptions::default()).unwrap().remove(0);
    let errors = file
        .check()
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .cloned()
        .collect::<Vec<_>>();
    let errors = errors.iter().map(|error| format!("{}: {}", error.rule.id, error.message)).collect();
    (build.lock(), String::from_utf8(master.bytes).unwrap(), errors)
}

/// Where an entry is: PDO, CAN-ID, position, and the number of the PDO in the manager.
type EntryPlace = (u16, u32, usize, Option<u16>);

/// Where each entry is that a node sends.
fn places(lock: &NetworkLock) -> BTreeMap<(String, u16, u8), EntryPlace> {
    let sent = lock.0.iter().filter(|((_, pdo), _)| pdo.kind == PdoKind::Tpdo);
    let entries = sent.flat_map(|((node, pdo), locked)| {
        let place = |at| (pdo.number, locked.can_id, at, locked.manager);
        let mapped = locked.mapping.iter().enumerate();
        mapped.map(move |(at, object)| ((node.clone(), object.index, object.sub), place(at)))
    });
    entries.collect()
}

#[test]
fn what_is_added_before_moves_nothing() {
    let mut kept = 0;
    for seed in 0..200 {
        let mut random = Random(seed);
        let count = 1 + random.below(5);
        let mut links: Vec<TestLink> = (0..count).map(|_| link(&mut random)).collect();
        let (first, _, errors) = built(&text(&[1, 2, 3], &links), &NetworkLock::default());
        if !errors.is_empty() || first.0.is_empty() {
            continue;
        }
        let mut findings = Findings::new();
        let lock = read_lock(&write_lock(&first), &mut findings);
        assert!(findings.is_empty() && lock == first, "{}", write_lock(&first));
        // more nodes, and links of other entries before those that stay
        for _ in 0..1 + random.below(4) {
            let new = link(&mut random);
            if links.iter().all(|link| (link.0, link.1) != (new.0, new.1)) {
                links.insert(random.below(links.len()), new);
            }
        }
        let later_text = text(&[1, 0, 2, 3], &links);
        let (later, master, errors) = built(&later_text, &lock);
        if !errors.is_empty() {
            assert!(errors.iter().all(|error| !error.contains("can-id")), "{seed}: {errors:?}\n{later_text}");
            continue;
        }
        let (before, after) = (places(&lock), places(&later));
        for (entry, place) in &before {
            let (pdo, can_id, at, manager) = after[entry];
            let is_mirrored = place.3.is_some();
            assert_eq!((pdo, can_id, at), (place.0, place.1, place.2), "{seed}: {entry:?}\n{later_text}");
            assert!(!is_mirrored || manager == place.3, "{seed}: {entry:?}\n{later_text}");
            if let Some(number) = manager {
                let section = format!("[{:04X}sub1]", 0x1400 - 1 + number);
                let behind = &master[master.find(&section).unwrap()..];
                assert!(behind[..400].contains(&format!("DefaultValue=0x{can_id:08X}")), "{seed}: {section}");
            }
            kept += 1;
        }
        // the same network again changes nothing
        assert_eq!(later.changes(&built(&later_text, &later).0), Vec::<String>::new());
    }
    assert!(kept > 100, "{kept}");
}

/// A CAN-ID that no PDO may have comes from an editor, not from a build.
#[test]
fn a_restricted_can_id_is_not_kept() {
    let text = text(&[1, 2], &[(1, 1, None)]);
    let (mut lock, ..) = built(&text, &NetworkLock::default());
    let expected = lock.clone();
    lock.0.values_mut().for_each(|locked| locked.can_id = 0x601);
    assert_eq!(built(&text, &lock).0, expected);
}

#[test]
fn a_lock_with_errors_has_findings() {
    for text in [
        "[[pdo]]\nnode = \"a\"\nkind = \"pdo\"\nnumber = 1\ncan-id = 1\nmap = []\n",
        "[[pdo]]\nnode = \"a\"\nkind = \"tpdo\"\nnumber = 513\ncan-id = 1\nmap = []\n",
        "[[pdo]]\nnode = \"a\"\nkind = \"tpdo\"\nnumber = 1\ncan-id = 1\nmap = [\"6000:1\"]\n",
        "[[pdo]]\nnode = \"a\"\nkind = \"tpdo\"\ncan-id = 1\nmap = []\n",
        "[pdo]\n",
        "pdo =",
    ] {
        let mut findings = Findings::new();
        let lock = read_lock(text, &mut findings);
        assert!(lock.0.is_empty() && !findings.is_empty(), "{text}");
    }
}

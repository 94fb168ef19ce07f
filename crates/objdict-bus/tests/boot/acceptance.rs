//! Whether a node accepts a download has one answer: `ConciseDcf::verify` and the simulated node give it alike.

use std::collections::BTreeMap;
use std::path::Path;

use objdict_bus::{Abort, Dictionary, LiveDictionary, PowerOn};
use objdict_device::{Node, Pdos};
use objdict_eds::{eds, ini};
use objdict_model::model::{Access, Device, DeviceKind, Object};
use objdict_model::source::SourceFile;
use objdict_node::download::{ConciseDcf, Download};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use crate::plant::{Row, device};

const NODE_ID: u8 = 5;

/// A device with every communication object, each writable, and entries to map.
fn complete() -> Device {
    use Access::{Const, Ro, Rw, Rww, Wo};
    let mut rows: Vec<Row> = vec![
        (0x1003, 0, 8, Rw, 0),
        (0x1003, 1, 32, Ro, 0),
        (0x1005, 0, 32, Rw, 0x80),
        (0x1006, 0, 32, Rw, 0),
        (0x1007, 0, 32, Rw, 0),
        (0x100C, 0, 16, Rw, 0),
        (0x100D, 0, 8, Rw, 0),
        (0x1010, 0, 8, Const, 1),
        (0x1010, 1, 32, Rw, 1),
        (0x1011, 0, 8, Const, 1),
        (0x1011, 1, 32, Rw, 1),
        (0x1012, 0, 32, Rw, 0x100),
        (0x1014, 0, 32, Rw, 0x85),
        (0x1015, 0, 16, Rw, 0),
        (0x1017, 0, 16, Rw, 0),
        (0x1019, 0, 8, Rw, 0),
        (0x1020, 0, 8, Const, 2),
        (0x1020, 1, 32, Rw, 0),
        (0x1020, 2, 32, Rw, 0),
        (0x6000, 1, 8, Ro, 0),
        (0x6000, 2, 16, Ro, 0),
        (0x6200, 1, 8, Rww, 0),
        (0x6200, 2, 32, Rw, 0),
        (0x6200, 3, 32, Wo, 0),
    ];
    for (index, first) in [(0x1016, 0), (0x1028, 0x8000_0000)] {
        rows.push((index, 0, 8, Const, 3));
        rows.extend((1..=3).map(|sub| (index, sub, 32, Rw, first)));
    }
    for (index, value) in [(0x1200, 0x580), (0x1201, 0x8000_0000), (0x1280, 0x8000_0000), (0x1281, 0x610)] {
        rows.push((index, 0, 8, Const, 2));
        rows.extend([1, 2].map(|sub| (index, sub, 32, Rw, value + 0x20 * (u32::from(sub) % 2))));
    }
    for (index, cob_id) in
        [(0x1400, 0x205), (0x1401, 0x8000_0305), (0x1800, 0x4000_0185), (0x1801, 0x8000_0285)]
    {
        rows.push((index, 0, 8, Const, 6));
        rows.push((index, 1, 32, Rw, cob_id));
        rows.extend(
            [(2, 8, 255), (3, 16, 0), (5, 16, 0), (6, 8, 0)]
                .map(|(sub, bits, value)| (index, sub, bits, Rw, value)),
        );
        rows.push((index + 0x200, 0, 8, Rw, 0));
        rows.extend((1..=4).map(|sub| (index + 0x200, sub, 32, Rw, 0)));
    }
    device(&rows)
}

/// The devices of the fixtures, without what only tools must not write.
fn devices() -> Vec<(String, Device)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/eds");
    let mut paths: Vec<_> =
        folder.read_dir().expect("fixtures").map(|file| file.expect("a file").path()).collect();
    paths.sort();
    let read = paths.into_iter().map(|path| {
        let text = String::from_utf8_lossy(&std::fs::read(&path).expect("a file")).into_owned();
        let document = ini::Document::new(SourceFile::from_text("fixture.eds", text));
        let (mut device, _) = eds::read(&document, DeviceKind::Type);
        for Object { main, subs, .. } in device.objects.values_mut() {
            subs.iter_mut().map(|(_, entry)| entry).chain([main]).for_each(|entry| entry.flags = None);
        }
        (path.display().to_string(), device)
    });
    std::iter::once(("complete".to_owned(), complete())).chain(read).collect()
}

/// A write: an object of the device and one of its entries, what is written to it, and how many bytes more or less than it has.
type Write = ([Index; 2], u64, i8);

/// Values that mean something to a service.
fn value() -> impl Strategy<Value = u64> {
    let can_id = select(vec![
        0, 0x7F, 0x80, 0x81, 0x85, 0x100, 0x180, 0x185, 0x205, 0x285, 0x305, 0x581, 0x5A0, 0x601, 0x610,
        0x630, 0x680, 0x6E0, 0x701, 0x7FF, 0x800, 0x1_2345,
    ]);
    let cob_id =
        (select(vec![0, 0, 1, 2, 4, 6]), can_id).prop_map(|(flags, id): (u64, u64)| flags << 29 | id);
    let mapped = (select(vec![0x6000, 0x6200, 0x6401, 0x1001, 0x1017, 5, 6, 7, 9]), 0..4_u64).prop_flat_map(
        |(index, sub)| {
            select(vec![1, 8, 12, 16, 32, 64, 72]).prop_map(move |bits| index << 16 | sub << 8 | bits)
        },
    );
    let signature =
        select(vec![u32::from_le_bytes(*b"save"), u32::from_le_bytes(*b"load")]).prop_map(u64::from);
    prop_oneof![
        4 => cob_id,
        4 => mapped,
        1 => signature,
        3 => 0..10_u64,
        3 => 238..=256_u64,
        1 => any::<u64>(),
    ]
}

fn writes() -> impl Strategy<Value = Vec<Write>> {
    let length = prop_oneof![20 => Just(0_i8), 1 => Just(-1), 1 => Just(1)];
    prop::collection::vec((any::<[Index; 2]>(), value(), length), 1..60)
}

/// The communication objects with their writable entries; an object without one has all.
fn objects(device: &Device, dictionary: &LiveDictionary) -> Vec<(u16, Vec<u8>)> {
    let objects = device.objects.iter().filter(|(index, _)| (0x1000..0x2000).contains(*index));
    let objects = objects.map(|(&index, object)| {
        let subs: Vec<u8> = object.entries().map(|(sub, _)| sub).collect();
        let is_writable = |sub: &u8| dictionary.attributes(index, *sub).is_ok_and(|entry| entry.writable);
        let writable: Vec<u8> = subs.iter().copied().filter(is_writable).collect();
        (index, if writable.is_empty() { subs } else { writable })
    });
    objects.filter(|(_, subs)| !subs.is_empty()).collect()
}

/// The downloads. Half of the writes to a PDO are what changes it: not valid, no entries, entries, their number.
fn downloads(objects: &[(u16, Vec<u8>)], dictionary: &LiveDictionary, writes: &[Write]) -> Vec<Download> {
    let mut downloads = Vec::new();
    for &([object, sub], value, more) in writes {
        let (index, subs) = object.get(objects);
        let (index, sub) = (*index, *sub.get(subs));
        // consumers of nodes 0 to 3 with and without a time
        let (node_id, time) = (value.count_ones() % 4, value % 3);
        let value = if index == 0x1016 { u64::from(node_id) << 16 | time } else { value };
        let mut push = |index, sub, value: u64, more: i8| {
            let size = dictionary.attributes(index, sub).map_or(4, |entry| entry.size.min(8));
            let size = size.saturating_add_signed(more.into());
            let bytes = value.to_le_bytes().into_iter().chain([0]).take(size);
            downloads.push(Download::new(index, sub, bytes.collect::<Vec<u8>>()));
        };
        if matches!(index, 0x1400..=0x1BFF) && value % 2 == 0 {
            push(index & !0x200, 1, 0x8000_0000 | 0x185, 0);
            if index & 0x200 != 0 {
                push(index, 0, 0, 0);
            }
        }
        push(index, sub, value, more);
        if matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) && value % 4 == 0 {
            push(index, 0, sub.into(), 0);
        }
    }
    downloads
}

#[test]
fn verify_and_the_simulated_node_agree() {
    let mut runner = TestRunner::deterministic();
    let mut counts = BTreeMap::new();
    for (name, device) in devices() {
        for _ in 0..if name == "complete" { 400 } else { 40 } {
            let writes = writes().new_tree(&mut runner).unwrap().current();
            let dictionary = LiveDictionary::new(&device, NODE_ID, PowerOn::Defaults);
            let objects = objects(&device, &dictionary);
            let downloads = ConciseDcf(downloads(&objects, &dictionary, &writes));
            let verification = downloads.verify(&device, Some(NODE_ID));
            let mut node =
                Node::<_, 64, 1, 16, 16, 127>::new(NODE_ID, dictionary, Pdos::new([0; 16], [0; 16]));
            node.boot(0);
            for (number, Download { index, sub, data }) in (1..).zip(&downloads.0) {
                let expected = node.guard().write(*index, *sub, data).err().map(Abort::code);
                let objection = verification.aborts().find(|objection| objection.number == number);
                let found = objection.and_then(|objection| Some(objection.kind.abort()?.0));
                let kind = objection.map(|objection| objection.kind.to_string());
                let hex =
                    |code: Option<u32>| code.map_or("accepted".to_owned(), |code| format!("{code:08X}h"));
                assert_eq!(
                    hex(found),
                    hex(expected),
                    "{name}, download {number}, {index:04X}h:{sub:02X} {data:02X?}: {kind:?}"
                );
                *counts.entry(expected).or_insert(0) += 1;
            }
        }
    }
    // no answer of the rules is rare
    for abort in [None, Some(Abort::InvalidValue), Some(Abort::CannotStore), Some(Abort::Incompatible)]
        .into_iter()
        .chain(
            [Abort::DeviceState, Abort::UnsupportedAccess, Abort::NotMappable, Abort::PdoTooLong].map(Some),
        )
    {
        assert!(
            counts.get(&abort.map(Abort::code)).is_some_and(|count| *count > 20),
            "{abort:?}: {counts:?}"
        );
    }
}

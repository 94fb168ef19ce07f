//! Streams played against a real device: what a node refuses, what is doubtful, and what the planner makes is neither.

use std::path::Path;

use objdict::download::{ConciseDcf, PlanOptions, Scope, Verification};
use objdict::format::{self, concise};
use objdict::model::Device;
use objdict::source::SourceOptions;

fn device(path: &str) -> Device {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(path);
    format::open(&path, &SourceOptions::default()).unwrap().into_device()
}

/// A stream as its text, played against the I/O module of CiA 401 as node 5.
fn verify(text: &str) -> Verification {
    let stream = concise::parse(text, Some(5)).unwrap();
    stream.verify(&device("eds/io-401.eds"), Some(5))
}

/// What is said against the downloads, each with its number, the abort code, and whether it is only a doubt.
fn objections(text: &str) -> Vec<String> {
    objections_of(&device("eds/io-401.eds"), text)
}

fn objections_of(device: &Device, text: &str) -> Vec<String> {
    let verification = concise::parse(text, Some(5)).unwrap().verify(device, Some(5));
    let objections = verification.objections.iter().map(|objection| {
        let abort = objection.kind.abort().map_or(String::new(), |abort| format!(" ({abort})"));
        let doubt = if objection.kind.is_refusal() { "" } else { "doubt: " };
        format!("{}: {doubt}{}{abort}", objection.number, objection.kind)
    });
    objections.collect()
}

#[test]
fn entries_must_be_there_and_take_the_value() {
    let found = objections(
        "1234:00 UNSIGNED8 1\n1016:05 UNSIGNED32 0\n1008:00 VISIBLE_STRING \"x\"\n1017:00 UNSIGNED8 1\n\
         1017:00 UNSIGNED32 1\n1016:01 UNSIGNED32 0x00FF0000\n1018:01 UNSIGNED32 1\n1003:00 UNSIGNED8 1\n1003:00 UNSIGNED8 0\n",
    );
    insta::assert_snapshot!(found.join("\n"));
}

#[test]
fn a_pdo_is_switched_off_before_it_is_changed() {
    let found = objections(
        "1800:03 UNSIGNED16 10\n1A00:00 UNSIGNED8 0\n1800:01 UNSIGNED32 0x190\n1800:01 UNSIGNED32 0x80000190\n\
         1800:03 UNSIGNED16 10\n1A00:01 UNSIGNED32 0x60000108\n1A00:00 UNSIGNED8 0\n1A00:01 UNSIGNED32 0x62000108\n\
         1A00:01 UNSIGNED32 0x60000110\n1A00:01 UNSIGNED32 0x60000108\n1A00:02 UNSIGNED32 0\n1A00:00 UNSIGNED8 2\n\
         1A00:00 UNSIGNED8 1\n1800:02 UNSIGNED8 0xF5\n1800:01 UNSIGNED32 0x601\n1800:01 UNSIGNED32 0x190\n",
    );
    insta::assert_snapshot!(found.join("\n"));
}

#[test]
fn a_frame_has_64_bits() {
    let map = |entries: &[u32]| {
        let lines =
            entries.iter().zip(1..).map(|(entry, sub)| format!("1601:{sub:02X} UNSIGNED32 0x{entry:08X}\n"));
        let lines: String = lines.collect();
        let count = entries.len();
        objections(&format!(
            "1401:01 UNSIGNED32 $NODEID+0x80000300\n1601:00 UNSIGNED8 0\n{lines}1601:00 UNSIGNED8 {count}\n"
        ))
    };
    // dummies fill an RPDO
    assert_eq!(map(&[0x0007_0020, 0x6411_0110, 0x6411_0210]), Vec::<String>::new());
    assert_eq!(
        map(&[0x0007_0020, 0x0007_0020, 0x6200_0108]),
        ["6: 72 bits are mapped, but a PDO has 64 (0604 0042h)"]
    );
    assert_eq!(
        map(&[0x0007_0010]),
        [
            "3: `0007h:00, 16 bits` is mapped, but it has 32 (0604 0041h)",
            "4: sub-index 1h maps nothing (0604 0041h)"
        ][..1]
    );
}

#[test]
fn services_are_switched_off_before_they_are_renamed() {
    let found = objections(
        "1014:00 UNSIGNED32 0x90\n1014:00 UNSIGNED32 $NODEID+0x80000080\n1014:00 UNSIGNED32 0x90\n\
         1016:01 UNSIGNED32 0x000702EE\n1016:02 UNSIGNED32 0x000702EE\n1016:01 UNSIGNED32 0\n1016:02 UNSIGNED32 0x000702EE\n",
    );
    insta::assert_snapshot!(found.join("\n"));
}

/// Exercise 2.7.1 with the words as the textbook prints them: the node-IDs are forgotten, and sub-index 0 is const.
#[test]
fn a_consumer_without_node_id_is_not_in_use() {
    let found = objections(
        "1017:00 UNSIGNED16 250\n1016:01 UNSIGNED32 750\n1016:00 UNSIGNED8 1\n1016:02 UNSIGNED32 1500\n1016:00 UNSIGNED8 2\n",
    );
    let expected = [
        "2: doubt: the entry has a time of 750 ms but no node-ID, so it is not in use",
        "3: its access type does not allow a write (0601 0002h)",
        "4: doubt: the entry has a time of 1500 ms but no node-ID, so it is not in use",
        "5: its access type does not allow a write (0601 0002h)",
    ];
    assert_eq!(found, expected);

    // an entry that is not in use is fine, whether a node-ID is left in it or not
    assert_eq!(objections("1016:01 UNSIGNED32 0\n1016:02 UNSIGNED32 0x00070000\n"), Vec::<String>::new());

    let mut device = device("eds/io-401.eds");
    device.objects.get_mut(&0x1016).unwrap().subs.get_mut(1).unwrap().high_limit = None;
    let found = objections_of(&device, "1016:01 UNSIGNED32 0x008001F4\n");
    assert_eq!(
        found,
        ["1: doubt: the entry has a time of 500 ms, but `128` is not a node-ID, so it is not in use"]
    );
}

#[test]
fn what_is_written_behind_save_is_not_stored() {
    let mut device = device("eds/io-401.eds");
    for index in [0x1010, 0x1011] {
        let object = device.objects.get_mut(&index).unwrap();
        object.main.flags = None;
        object.subs.iter_mut().for_each(|(_, entry)| entry.flags = None);
    }
    let found = objections_of(
        &device,
        "1010:01 UNSIGNED32 1\n1010:01 UNSIGNED32 0x65766173\n1011:01 UNSIGNED32 0x64616F6C\n1017:00 UNSIGNED16 250\n",
    );
    insta::assert_snapshot!(found.join("\n"));
}

#[test]
fn offsets_are_those_of_the_stream() {
    let verification = verify("1017:00 UNSIGNED16 1\n1234:00 UNSIGNED8 1\n1235:00 UNSIGNED8 1\n");
    let offsets: Vec<usize> = verification.objections.iter().map(|objection| objection.offset).collect();
    assert_eq!(offsets, [4 + 9, 4 + 9 + 8]);
}

#[test]
fn without_the_node_id_formulas_are_unknown() {
    let stream = concise::parse("1400:01 UNSIGNED32 0x186\n1017:00 UNSIGNED16 5\n", None).unwrap();
    let verification = stream.verify(&device("eds/io-401.eds"), None);
    let unknown: Vec<String> = verification.unknown.iter().map(ToString::to_string).collect();
    assert!(verification.is_accepted() && unknown == ["0x1400sub1"], "{verification:?}");
}

/// Whatever is planned is taken, of every fixture that can be planned.
#[test]
fn what_is_planned_is_accepted() {
    let mut planned = 0;
    for path in [
        "dcf/drive-402-node8.dcf",
        "dcf/encoder-406-node3.dcf",
        "dcf/io-401-node5.dcf",
        "dcf/coupler-modular-node10.dcf",
        "dcf/manager-302-node1.dcf",
        "eds/io-401.eds",
        "eds/drive-402.eds",
        "eds/all-types.eds",
        "eds/compact.eds",
    ] {
        let device = device(path);
        for scope in [Scope::Changed, Scope::All] {
            let options =
                PlanOptions { node_id: device.node_id().or(Some(5)), scope, ..PlanOptions::default() };
            let Ok(plan) = ConciseDcf::plan(&device, &options) else { continue };
            let stream = plan.into_concise(|_| Ok::<_, ()>(vec![1, 2, 3])).unwrap();
            let verification = stream.verify(&device, options.node_id);
            assert!(verification.objections.is_empty(), "{path}, {scope:?}: {verification:#?}");
            planned += stream.0.len();
        }
    }
    assert!(planned > 100, "{planned}");
}

//! The services of a node together.

use objdict_device::{Frame, NmtCommand, NmtState, Node, Pdos, Received, Reception, Scope};
use proptest::prelude::*;

use crate::client::request;
use crate::dictionary::{Map, UNSIGNED8, UNSIGNED16, UNSIGNED32};
use crate::frame;

type Small = Node<Map, 16, 1, 1, 1, 2>;

fn node() -> Small {
    let map = Map::default().number(0x1017, 0, UNSIGNED16, 100).number(0x2000, 0, UNSIGNED16, 0x1234);
    let map = [(0x1400, 0x205), (0x1800, 0x185)].into_iter().fold(map, |map, (index, cob_id)| {
        let map = map.number(index, 1, UNSIGNED32, cob_id).number(index, 2, UNSIGNED8, 255);
        map.number(index + 0x200, 0, UNSIGNED8, 1).number(index + 0x200, 1, UNSIGNED32, 0x2000_0010)
    });
    Node::new(5, map, Pdos::new([0x1400], [0x1800]))
}

/// Each service works in the states that have it.
#[test]
fn services_follow_the_state() {
    let mut node = node();
    let (upload, rpdo) = (frame(0x605, &request(0x40, 0x2000, 0, [0; 4])), frame(0x205, &[7, 7]));
    let works = |node: &mut Small| {
        let sdo = matches!(node.receive(&upload, 0), Received::Answer(answer) if answer.id() == 0x585);
        (sdo, node.receive(&rpdo, 0) == Received::Pdo(Reception::Written(0x1400)))
    };
    assert_eq!(works(&mut node), (false, false));
    assert_eq!(node.poll(0), None);
    assert_eq!(node.boot(0), frame(0x705, &[0]));
    assert_eq!(works(&mut node), (true, false));
    assert_eq!(node.receive(&frame(0, &[1, 5]), 0), Received::Nmt(NmtCommand::Start));
    assert_eq!(works(&mut node), (true, true));
    assert_eq!(node.poll(0), Some(frame(0x705, &[5])));
    assert_eq!(node.poll(0), Some(frame(0x185, &[7, 7])));
    assert_eq!(node.poll(0), None);
    node.receive(&frame(0, &[2, 5]), 0);
    assert_eq!(works(&mut node), (false, false));
    assert_eq!(node.receive(&frame(0, &[130, 5]), 0), Received::Nmt(NmtCommand::ResetCommunication));
    assert_eq!(node.state(), NmtState::Initialising);
    assert_eq!(node.dictionary.restarts, [Scope::Communication]);
    assert_eq!(node.boot(0), frame(0x705, &[0]));
    assert_eq!(works(&mut node), (true, false));
}

#[test]
fn an_sdo_changes_a_pdo() {
    let mut node = node();
    node.boot(0);
    node.receive(&frame(0, &[1, 5]), 0);
    while node.poll(0).is_some() {}
    let mut write = |command, index, sub, data: u32| {
        let answer = node.receive(&frame(0x605, &request(command, index, sub, data.to_le_bytes())), 0);
        let Received::Answer(answer) = answer else { panic!("{answer:?}") };
        (answer.data()[0] == 0x60, u32::from_le_bytes(answer.data()[4..].try_into().unwrap()))
    };
    assert_eq!(write(0x23, 0x1800, 1, 0x186), (false, 0x0609_0030));
    assert_eq!(write(0x2F, 0x1A00, 0, 0), (false, 0x0601_0000));
    assert_eq!(write(0x23, 0x1800, 1, 0x8000_0185), (true, 0));
    assert_eq!(write(0x23, 0x1800, 1, 0x186), (true, 0));
    assert_eq!(node.poll(0), Some(frame(0x186, &[0x34, 0x12])));
}

/// Bit 2 of 1F80h: the node becomes operational by itself, unless it is the NMT master.
#[test]
fn a_node_starts_by_itself() {
    for (startup, state) in [
        (0, NmtState::Operational),
        (2, NmtState::Operational),
        (4, NmtState::PreOperational),
        (1, NmtState::PreOperational),
    ] {
        let mut node = node();
        node.dictionary = std::mem::take(&mut node.dictionary).number(0x1F80, 0, UNSIGNED32, startup);
        assert_eq!(node.boot(0), frame(0x705, &[0]));
        assert_eq!(node.state(), state, "1F80h is {startup}");
    }
}

/// A device that gets its node-ID by LSS has no other before.
#[test]
fn a_node_gets_its_node_id_later() {
    let mut node = Small::new(0, node().dictionary, Pdos::new([0x1400], [0x1800]));
    assert_eq!(node.receive(&frame(0x600, &request(0x40, 0x2000, 0, [0; 4])), 0), Received::Ignored);
    assert_eq!((node.poll(1_000_000), node.next(1_000_000)), (None, None));
    node.set_node_id(7);
    assert_eq!(node.dictionary.restarts, [Scope::All]);
    assert_eq!(node.boot(0), frame(0x707, &[0]));
    let answer = node.receive(&frame(0x607, &request(0x40, 0x2000, 0, [0; 4])), 0);
    assert!(matches!(answer, Received::Answer(answer) if answer.id() == 0x587));
}

type Full = Node<Map, 24, 2, 2, 2, 2>;

fn full() -> Full {
    let words = [
        (0x1005, 0, 0x80),
        (0x1006, 0, 0),
        (0x1014, 0, 0x85),
        (0x1016, 1, 0x0007_0005),
        (0x1016, 2, 0),
        (0x1201, 1, 0x8000_0640),
        (0x1201, 2, 0x8000_05C0),
    ];
    let map = words
        .into_iter()
        .fold(node().dictionary, |map, (index, sub, value)| map.number(index, sub, UNSIGNED32, value));
    let map = (1..=2)
        .fold(map.number(0x1001, 0, UNSIGNED8, 0).number(0x1003, 0, UNSIGNED8, 0), |map, sub| {
            map.number(0x1003, sub, UNSIGNED32, 0)
        });
    let map = [0x1401, 0x1801].into_iter().fold(map, |map, index| {
        let map = map
            .number(index, 1, UNSIGNED32, 0x205)
            .number(index, 2, UNSIGNED8, 1)
            .number(index, 5, UNSIGNED16, 3);
        map.number(index + 0x200, 0, UNSIGNED8, 1).number(index + 0x200, 1, UNSIGNED32, 0x2000_0010)
    });
    let map =
        map.number(0x1015, 0, UNSIGNED16, 7).number(0x1019, 0, UNSIGNED8, 0).domain(0x2001, 20, b"text");
    Full::new(5, map, Pdos::new([0x1400, 0x1401], [0x1800, 0x1801]))
}

/// Frames that are more likely to reach a service than random ones, and random ones.
fn frames() -> impl Strategy<Value = (u16, Vec<u8>)> {
    let indexes = prop::sample::select(vec![
        0x1001_u16, 0x1003, 0x1005, 0x1006, 0x1014, 0x1015, 0x1016, 0x1017, 0x1019, 0x1201, 0x1400, 0x1401,
        0x1600, 0x1601, 0x1800, 0x1801, 0x1A00, 0x1A01, 0x2000, 0x2001,
    ]);
    let sdo = (any::<u8>(), indexes, 0..7_u8, any::<[u8; 4]>())
        .prop_map(|(command, index, sub, data)| (0x605, request(command, index, sub, data).to_vec()));
    let nmt = (prop::sample::select(vec![1_u8, 2, 128, 129, 130, 7]), 0..7_u8)
        .prop_map(|(command, node_id)| (0, vec![command, node_id]));
    let others = prop::sample::select(vec![0x80_u16, 0x205, 0x640, 0x707]);
    let bytes = || prop::collection::vec(any::<u8>(), 0..=8);
    prop_oneof![8 => sdo, 1 => nmt, 3 => (others, bytes()), 1 => (0..=0x7FF_u16, bytes())]
}

proptest! {
    /// For any frames at any times, the node never panics, is silent after all due frames, and is due at the
    /// time that it reports.
    #[test]
    fn any_frames_and_times_are_survived(
        steps in prop::collection::vec((frames(), prop_oneof![Just(0), 0..3000_u64, 0..1_u64 << 40]), 0..200),
    ) {
        let mut node = full();
        node.boot(0);
        let mut now = 0_u64;
        for ((id, bytes), waited) in steps {
            now = now.saturating_add(waited);
            if let Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) =
                node.receive(&frame(id, &bytes), now)
            {
                node.boot(now);
            }
            node.pdos.request_changed(&mut node.dictionary);
            let sent: Vec<Frame> = std::iter::from_fn(|| node.poll(now)).take(1000).collect();
            prop_assert!(sent.len() < 1000);
            if let Some(next) = node.next(now) {
                prop_assert!(next > now, "due at {next} after all was sent at {now}");
                prop_assert_eq!(node.clone().poll(next - 1), None, "before it is due");
            }
        }
    }
}

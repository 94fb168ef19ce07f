//! The services of a node together.

use objdict_device::{NmtCommand, NmtState, Node, Pdos, Received, Reception};

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

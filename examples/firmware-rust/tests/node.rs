//! The node as a client sees it.

use climate_sensor::{Node, od};

fn node() -> Node {
    Node::new(od::NODE_ID)
}

/// What the server answers to a read: the data, or the abort code.
fn read(node: &mut Node, index: u16, sub: u8) -> Result<Vec<u8>, u32> {
    let [low, high] = index.to_le_bytes();
    let answer = node.answer([0x40, low, high, sub, 0, 0, 0, 0]).expect("an answer");
    assert_eq!(answer[1..4], [low, high, sub]);
    let data = [answer[4], answer[5], answer[6], answer[7]];
    match answer[0] {
        0x80 => Err(u32::from_le_bytes(data)),
        command => Ok(data[..4 - usize::from(command >> 2 & 3)].to_vec()),
    }
}

#[test]
fn what_is_written_is_read() {
    let mut node = node();
    assert_eq!(
        read(&mut node, od::identity::INDEX, od::identity::VENDOR_ID.sub()),
        Ok(vec![0xF9, 0x03, 0, 0])
    );
    assert_eq!(node.answer([0x2B, 0x17, 0x10, 0, 0xF4, 0x01, 0, 0]), Some([0x60, 0x17, 0x10, 0, 0, 0, 0, 0]));
    assert_eq!(read(&mut node, od::PRODUCER_HEARTBEAT_TIME.index(), 0), Ok(vec![0xF4, 0x01]));
    // the frame does not say how many bytes it has
    assert_eq!(node.answer([0x22, 0x17, 0x10, 0, 0x64, 0, 0, 0]), Some([0x60, 0x17, 0x10, 0, 0, 0, 0, 0]));
    assert_eq!(node.data.get(od::PRODUCER_HEARTBEAT_TIME), 100);
}

#[test]
fn what_cannot_be_done_is_aborted() {
    let mut node = node();
    assert_eq!(read(&mut node, 0x3000, 0), Err(0x0602_0000));
    assert_eq!(read(&mut node, od::climate::INDEX, 3), Err(0x0609_0011));
    assert_eq!(read(&mut node, od::PASSWORD.index(), 0), Err(0x0601_0001));
    // the device name has seven bytes, which need segments
    assert_eq!(read(&mut node, od::DEVICE_NAME.index(), 0), Err(0x0504_0005));
    for (request, code) in [
        ([0x2B, 0x00, 0x20, 1, 0, 0, 0, 0], 0x0601_0002_u32),
        ([0x2B, 0x10, 0x20, 2, 0x53, 0x03, 0, 0], 0x0609_0031),
        ([0x2B, 0x10, 0x20, 1, 0x00, 0x80, 0, 0], 0x0609_0032),
        ([0x2F, 0x10, 0x20, 2, 0x14, 0, 0, 0], 0x0607_0013),
        ([0x23, 0x10, 0x20, 2, 0x14, 0, 0, 0], 0x0607_0012),
        ([0x21, 0x10, 0x20, 2, 2, 0, 0, 0], 0x0504_0001),
        ([0x60, 0, 0, 0, 0, 0, 0, 0], 0x0504_0001),
    ] {
        let answer = node.answer(request).expect("an answer");
        assert_eq!((answer[0], answer[4..].to_vec()), (0x80, code.to_le_bytes().to_vec()), "{request:02X?}");
    }
    assert_eq!(node.answer([0x80, 0, 0, 0, 0, 0, 0, 0]), None);
    assert_eq!(node.data.get(od::alarm_limits::HIGHEST_TEMPERATURE), 600);
}

/// The TPDO carries what its mapping says, bit by bit: read back through the dictionary's own mapping entries.
#[test]
fn the_tpdo_follows_its_mapping() {
    let mut node = node();
    node.measure(-250, 990);
    let frame = node.tpdo1().expect("the PDO exists");
    assert_eq!(frame.id, 0x185);
    let mut bits = frame.data.iter().rev().fold(0_u64, |bits, &byte| bits << 8 | u64::from(byte));
    let count = read(&mut node, od::tpdo_1_mapping::INDEX, 0).expect("the number of objects")[0];
    for sub in 1..=count {
        let mapped = read(&mut node, od::tpdo_1_mapping::INDEX, sub).expect("a mapped object");
        let [length, sub, low, high] = mapped[..] else { panic!("{mapped:?} is no mapping") };
        let bytes = read(&mut node, u16::from_le_bytes([low, high]), sub).expect("its value");
        let value = bytes.iter().rev().fold(0_u64, |value, &byte| value << 8 | u64::from(byte));
        assert_eq!(bits & ((1 << length) - 1), value, "{mapped:02X?}");
        bits >>= length;
    }
    assert_eq!(bits, 0, "what is left of the last byte is zero");
    // bit 31 of its COB-ID switches it off
    let off = [0x23, 0x00, 0x18, 1, 0x85, 0x01, 0x00, 0xC0];
    assert_eq!(node.answer(off).map(|answer| answer[0]), Some(0x60));
    assert_eq!(node.tpdo1(), None);
}

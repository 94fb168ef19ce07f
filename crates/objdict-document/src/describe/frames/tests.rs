use super::*;
use crate::model::{Device, Entry, Object, ObjectType};

fn entry(name: &str, data_type: DataType, number: u64) -> Entry {
    Entry {
        name: name.into(),
        data_type: Some(data_type),
        default: Some(Value::Unsigned(number)),
        ..Entry::default()
    }
}

/// A drive with TPDO 1 (6041h, 6061h) and RPDO 1 (6040h).
fn drive() -> Device {
    let mut device = Device::default();
    let mut record = |index, values: &[(u8, DataType, u64)]| {
        let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
        let subs =
            values.iter().map(|&(sub, data_type, number)| (sub, entry("", data_type, number))).collect();
        device.objects.insert(index, Object { main, subs, ..Object::default() });
    };
    let (byte, word) = (DataType::UNSIGNED8, DataType::UNSIGNED32);
    record(0x1400, &[(1, word, 0x205), (2, byte, 255)]);
    record(0x1600, &[(0, byte, 1), (1, word, 0x6040_0010)]);
    record(0x1800, &[(1, word, 0x185), (2, byte, 1)]);
    record(0x1A00, &[(0, byte, 2), (1, word, 0x6041_0010), (2, word, 0x6061_0008)]);
    let mut var = |index, name: &str, data_type| {
        device.objects.insert(index, Object { main: entry(name, data_type, 0), ..Object::default() });
    };
    var(0x1000, "Device type", DataType::UNSIGNED32);
    var(0x1008, "Device name", DataType::VISIBLE_STRING);
    var(0x1017, "Producer heartbeat time", DataType::UNSIGNED16);
    var(0x6040, "Controlword", DataType::UNSIGNED16);
    var(0x6041, "Statusword", DataType::UNSIGNED16);
    var(0x6061, "Modes of operation display", DataType::INTEGER8);
    device
}

fn read(frames: &[(u16, &[u8])]) -> Vec<String> {
    let device = drive();
    let mut reader = FrameReader::new(vec![Talker { name: "drive", node_id: 5, device: &device }]);
    frames.iter().map(|(can_id, data)| reader.read(*can_id, data, false).text).collect()
}

#[test]
fn network_management() {
    let words = read(&[
        (0, &[0x82, 0]),
        (0, &[1, 5]),
        (0, &[0x80, 6]),
        (0x705, &[0]),
        (0x705, &[0x85]),
        (0x706, &[0x7F]),
        (0x080, &[]),
        (0x080, &[7]),
    ]);
    let expected = [
        "reset the communication of all nodes",
        "start drive",
        "node 6: enter pre-operational",
        "drive: boot-up",
        "drive: operational, toggle bit",
        "node 6: pre-operational",
        "SYNC",
        "SYNC 7",
    ];
    assert_eq!(words, expected);
}

#[test]
fn values_are_written_and_read() {
    let words = read(&[
        (0x605, &[0x2B, 0x17, 0x10, 0, 0x2C, 0x01, 0, 0]),
        (0x585, &[0x60, 0x17, 0x10, 0, 0, 0, 0, 0]),
        (0x605, &[0x2B, 0x00, 0x10, 0, 1, 0, 0, 0]),
        (0x585, &[0x80, 0x00, 0x10, 0, 2, 0, 1, 6]),
        (0x605, &[0x40, 0x00, 0x10, 0, 0, 0, 0, 0]),
        (0x585, &[0x43, 0x00, 0x10, 0, 0x92, 0x01, 0x02, 0]),
    ]);
    let expected = [
        "drive: write 1017:00 Producer heartbeat time = 300 (300 ms)",
        "drive: 1017:00 is written",
        "drive: write 1000:00 Device type = 01 00",
        "drive: 1000:00 Device type: SDO abort 06010002h: attempt to write a read-only entry",
        "drive: read 1000:00 Device type",
        "drive: 1000:00 Device type = 0x20192 (device profile CiA 402 (drives), additional information 0x0002)",
    ];
    assert_eq!(words, expected);
}

#[test]
fn segments_are_put_together() {
    let words = read(&[
        (0x605, &[0x21, 0x08, 0x10, 0, 9, 0, 0, 0]),
        (0x585, &[0x60, 0x08, 0x10, 0, 0, 0, 0, 0]),
        (0x605, &[0x00, b'a', b' ', b'd', b'r', b'i', b'v', b'e']),
        (0x585, &[0x20, 0, 0, 0, 0, 0, 0, 0]),
        (0x605, &[0x1B, b' ', b'5', 0, 0, 0, 0, 0]),
        (0x585, &[0x30, 0, 0, 0, 0, 0, 0, 0]),
    ]);
    let expected = [
        "drive: write 1008:00 Device name, 9 bytes",
        "drive: 1008:00 is expected",
        "drive: segment of 7 bytes",
        "drive: segment is accepted",
        "drive: last segment, 1008:00 Device name = a drive 5",
        "drive: 1008:00 is written",
    ];
    assert_eq!(words, expected);
}

#[test]
fn pdos_and_emergencies() {
    let words = read(&[
        (0x185, &[0x27, 0x00, 0xFF]),
        (0x185, &[0x27, 0x00]),
        (0x205, &[0x0F, 0x00]),
        (0x085, &[0x30, 0x81, 0x11, 0, 0, 0, 0, 0]),
        (0x085, &[0x10, 0x82, 0x11, 1, 0, 0, 0, 0]),
        (0x333, &[1]),
    ]);
    let expected = [
        "drive TPDO 1: 6041:00 = 39, 6061:00 = -1",
        "drive TPDO 1: 6041:00 = 39, 6061:00 is missing",
        "to drive RPDO 1: 6040:00 = 15",
        "drive EMCY 8130h (heartbeat or guarding lost), error register 11h (generic error, communication)",
        "drive EMCY 8210h (PDO too short, not processed), error register 11h (generic error, communication), 01 00 00 00 00",
        "not a service of a known node",
    ];
    assert_eq!(words, expected);
}

#[test]
fn frames_of_any_content_are_read() {
    let device = drive();
    for length in 0..=8 {
        for first in 0..=0xFF_u8 {
            let mut reader = FrameReader::new(vec![Talker { name: "drive", node_id: 5, device: &device }]);
            let data = [first, 0x08, 0x10, 0, 0xFF, 0xFF, 0xFF, 0xFF];
            for can_id in [0, 0x085, 0x100, 0x185, 0x205, 0x585, 0x605, 0x705] {
                reader.read(can_id, &data[..length], first & 1 == 0);
            }
        }
    }
}

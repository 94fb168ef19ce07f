use super::*;
use crate::model::{Compact, DataType, Device, DeviceKind, Entry, Object, ObjectType};

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
    let mut reader =
        FrameReader::new(vec![Talker { name: "drive", node_id: 5, device: &device, is_counterpart: false }]);
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
        "drive: write 1000:00 Device type = 01h 00h (2 bytes, expected 4)",
        "drive: 1000:00 Device type: SDO abort 06010002h: attempt to write a read-only entry",
        "drive: read 1000:00 Device type",
        "drive: 1000:00 Device type = 0x20192 (device profile CiA 402 (drives), additional information 0x0002 (servo drive))",
    ];
    assert_eq!(words, expected);
}

/// As with manual use of `cansend`: nodes respond to them.
#[test]
fn requests_without_the_bytes_at_the_end() {
    let said = read(&[
        (0x605, &[0x40, 0x17, 0x10, 0]),
        (0x605, &[0x2B, 0x17, 0x10, 0, 0x2C, 0x01]),
        (0x605, &[0x2B, 0x17, 0x10, 0, 0x2C]),
        (0x585, &[0x60, 0x17, 0x10, 0]),
    ]);
    assert_eq!(
        said,
        [
            "drive: read 1017:00 Producer heartbeat time (in 4 bytes)",
            "drive: write 1017:00 Producer heartbeat time = 300 (300 ms) (in 6 bytes)",
            "SDO of 5 bytes to drive",
            "SDO of 4 bytes from drive",
        ]
    );
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
        "drive TPDO 1: 6041:00 Statusword = 39, 6061:00 Modes of operation display = -1",
        "drive TPDO 1 (2 bytes, expected 3): 6041:00 Statusword = 39, 6061:00 Modes of operation display is missing",
        "to drive RPDO 1: 6040:00 Controlword = 15",
        "drive EMCY 8130h (heartbeat or guarding lost), error register 11h (generic error, communication)",
        "drive EMCY 8210h (PDO too short, not processed), error register 11h (generic error, communication), 01h 00h 00h 00h 00h",
        "not a service of a known node",
    ];
    assert_eq!(words, expected);
}

#[test]
fn frames_of_any_content_are_read() {
    let device = drive();
    for length in 0..=8 {
        for first in 0..=0xFF_u8 {
            let mut reader = FrameReader::new(vec![Talker {
                name: "drive",
                node_id: 5,
                device: &device,
                is_counterpart: false,
            }]);
            let data = [first, 0x08, 0x10, 0, 0xFF, 0xFF, 0xFF, 0xFF];
            for can_id in [0, 0x085, 0x100, 0x185, 0x205, 0x585, 0x605, 0x705, 0x7E4, 0x7E5] {
                reader.read(can_id, &data[..length], first & 1 == 0);
            }
        }
    }
}

/// The text for frames on a bus on which only the drive is described.
fn read_bus(frames: &[(u16, &[u8])]) -> Vec<String> {
    let device = drive();
    let mut reader = FrameReader::of_bus(vec![Talker {
        name: "drive",
        node_id: 5,
        device: &device,
        is_counterpart: false,
    }]);
    frames.iter().map(|(can_id, data)| reader.read(*can_id, data, false).text).collect()
}

#[test]
fn a_mapping_that_is_written_counts() {
    let write = |command, index: u16, sub, value: u32| {
        let ([low, high], [a, b, c, d]) = (index.to_le_bytes(), value.to_le_bytes());
        [command, low, high, sub, a, b, c, d]
    };
    let frames = [
        write(0x23, 0x1800, 1, 0x8000_0185),
        write(0x2F, 0x1A00, 0, 0),
        write(0x23, 0x1A00, 1, 0x6061_0008),
        write(0x2F, 0x1A00, 0, 1),
        write(0x23, 0x1800, 1, 0x0000_0190),
    ];
    let device = drive();
    let mut reader =
        FrameReader::new(vec![Talker { name: "drive", node_id: 5, device: &device, is_counterpart: false }]);
    for frame in &frames[..4] {
        reader.read(0x605, frame, false);
        let [_, low, high, sub, ..] = *frame;
        reader.read(0x585, &[0x60, low, high, sub, 0, 0, 0, 0], false);
    }
    assert_eq!(reader.read(0x185, &[8, 7], false).text, "not a service of a known node");
    reader.read(0x605, &frames[4], false);
    assert_eq!(reader.read(0x190, &[8], false).text, "not a service of a known node", "not yet accepted");
    reader.read(0x585, &[0x60, 0, 0x18, 1, 0, 0, 0, 0], false);
    let text = "drive TPDO 1: 6061:00 Modes of operation display = 8";
    assert_eq!(reader.read(0x190, &[8], false).text, text);
    // a reset restores the values of the description
    reader.read(0x705, &[0], false);
    let text = "drive TPDO 1: 6041:00 Statusword = 7, 6061:00 Modes of operation display = 8";
    assert_eq!(reader.read(0x185, &[7, 0, 8], false).text, text);
}

#[test]
fn values_in_blocks() {
    let words = read(&[
        (0x605, &[0xC2, 0x08, 0x10, 0, 16, 0, 0, 0]),
        (0x585, &[0xA0, 0x08, 0x10, 0, 2, 0, 0, 0]),
        (0x605, &[1, b'a', b' ', b'l', b'o', b'n', b'g', b' ']),
        (0x605, &[2, b'?', b'?', b'?', b'?', b'?', b'?', b'?']),
        // the second one is lost and sent again
        (0x585, &[0xA2, 1, 2, 0, 0, 0, 0, 0]),
        (0x605, &[1, b'd', b'r', b'i', b'v', b'e', b' ', b'n']),
        (0x605, &[0x82, b'a', b'm', 0, 0, 0, 0, 0]),
        (0x585, &[0xA2, 2, 2, 0, 0, 0, 0, 0]),
        (0x605, &[0xD5, 0, 0, 0, 0, 0, 0, 0]),
        (0x585, &[0xA1, 0, 0, 0, 0, 0, 0, 0]),
        (0x605, &[0xA0, 0x08, 0x10, 0, 127, 0, 0, 0]),
        (0x585, &[0xC2, 0x08, 0x10, 0, 3, 0, 0, 0]),
        (0x605, &[0xA3, 0, 0, 0, 0, 0, 0, 0]),
        (0x585, &[0x81, b'a', b'b', b'c', 0, 0, 0, 0]),
        (0x605, &[0xA2, 1, 127, 0, 0, 0, 0, 0]),
        (0x585, &[0xD1, 0, 0, 0, 0, 0, 0, 0]),
        (0x605, &[0xA1, 0, 0, 0, 0, 0, 0, 0]),
        (0x605, &[0x80, 0x08, 0x10, 0, 0, 0, 4, 5]),
    ]);
    let expected = [
        "drive: write 1008:00 Device name, 16 bytes",
        "drive: 1008:00 is expected",
        "drive: segment 1 of a block",
        "drive: segment 2 of a block",
        "drive: segments up to 1 are accepted",
        "drive: segment 1 of a block",
        "drive: segment 2 of a block, the last one",
        "drive: segments up to 2 are accepted",
        "drive: end of the blocks, 1008:00 Device name = a long drive nam",
        "drive: 1008:00 is written",
        "drive: read 1008:00 Device name",
        "drive: 1008:00 Device name, 3 bytes",
        "drive: start of the blocks",
        "drive: segment 1 of a block, the last one",
        "drive: segments up to 1 are accepted",
        "drive: end of the blocks, 1008:00 Device name = abc",
        "drive: end of the blocks is confirmed",
        "drive: 1008:00 Device name: SDO abort 05040000h: the transfer timed out",
    ];
    assert_eq!(words, expected);
}

#[test]
fn nodes_without_a_description() {
    let words = read_bus(&[
        (0x187, &[1, 2]),
        (0x307, &[3]),
        (0x607, &[0x40, 0x17, 0x10, 0, 0, 0, 0, 0]),
        (0x587, &[0x4B, 0x17, 0x10, 0, 0x2C, 1, 0, 0]),
        (0x587, &[0x43, 0x00, 0x10, 0, 0x92, 1, 2, 0]),
        (0x607, &[0x2B, 0x40, 0x60, 0, 0x0F, 0, 0, 0]),
        (0x087, &[0x11, 0x86, 0x20, 0, 0, 0, 0, 0]),
        (0x100, &[0xA0, 0xC9, 0x5E, 0, 0x32, 0x3D]),
        (0x6E0, &[]),
        (0x7E5, &[0x11, 5, 0, 0, 0, 0, 0, 0]),
        (0x7E4, &[0x11, 0, 0, 0, 0, 0, 0, 0]),
        (0x185, &[0x27, 0]),
        (0x1C5, &[]),
    ]);
    let expected = [
        "node 7 TPDO 1: 01h 02h",
        "to node 7 RPDO 2: 03h",
        "node 7: read 1017:00 Producer heartbeat time",
        "node 7: 1017:00 Producer heartbeat time = 300 (300 ms)",
        "node 7: 1000:00 Device type = 0x20192 (device profile CiA 402 (drives), additional information 0x0002 (servo drive))",
        "node 7: write 6040:00 Controlword = 15 (command: enable operation, switch on, enable voltage, quick stop off, enable operation)",
        "node 7 EMCY 8611h (following error), error register 20h (device-profile-specific)",
        "TIME 2026-11-22 01:43:32.000",
        "request of a dynamic SDO connection",
        "LSS master: configure node-ID 5",
        "LSS node: node-ID is accepted",
        "drive TPDO 1 (2 bytes, expected 3): 6041:00 Statusword = 39, 6061:00 Modes of operation display is missing",
        "node 69 TPDO 1: ",
    ];
    assert_eq!(words, expected);
}

#[test]
fn guarding_is_a_question_and_an_answer() {
    let device = drive();
    let mut reader =
        FrameReader::new(vec![Talker { name: "drive", node_id: 5, device: &device, is_counterpart: false }]);
    let mut kind = |is_remote, data: &[u8]| {
        reader.decode(&RawFrame { can_id: 0x705, is_extended: false, is_remote, data }).kind
    };
    assert_eq!(kind(false, &[5]), FrameKind::Heartbeat);
    assert_eq!(kind(true, &[]), FrameKind::Guarding);
    assert_eq!(kind(false, &[5]), FrameKind::Guarding);
    assert_eq!(kind(false, &[0x85]), FrameKind::Guarding);
    assert_eq!(kind(false, &[5]), FrameKind::Heartbeat);
    assert_eq!(kind(false, &[0]), FrameKind::BootUp);
}

#[test]
fn a_multiplexed_pdo_names_its_entry() {
    let mut device = drive();
    device.objects.get_mut(&0x1A00).unwrap().subs.get_mut(0).unwrap().default = Some(Value::Unsigned(0xFF));
    device.objects.get_mut(&0x1600).unwrap().subs.get_mut(0).unwrap().default = Some(Value::Unsigned(0xFE));
    let talker = |name, node_id| Talker { name, node_id, device: &device, is_counterpart: false };
    let mut reader = FrameReader::new(vec![talker("drive", 5), talker("other", 6)]);
    let mut words = |can_id, data: &[u8]| reader.read(can_id, data, false).text;
    let to_other = [0x86, 0x61, 0x60, 0, 0xFF, 9, 9, 9];
    assert_eq!(words(0x185, &to_other), "drive TPDO 1: to other: 6061:00 Modes of operation display = -1");
    let to_all = [0x80, 0x17, 0x10, 0, 0xE8, 3, 0, 0];
    assert_eq!(
        words(0x185, &to_all),
        "drive TPDO 1: to all nodes: 1017:00 Producer heartbeat time = 1000 (1000 ms)"
    );
    let of_other = [6, 0, 0x21, 1, 1, 2, 3, 4];
    assert_eq!(
        words(0x205, &of_other),
        "to drive RPDO 1: of other: 2100:01 (not in the description) = 4030201h"
    );
    assert_eq!(words(0x205, &[6, 0, 0x21]), "to drive RPDO 1 (3 bytes, expected 8): MPDO 06h 00h 21h");
    let frame = RawFrame { can_id: 0x185, is_extended: false, is_remote: false, data: &to_other };
    let decoded = reader.decode(&frame);
    assert_eq!(reader.values(&decoded, &frame), [(6, (0x6061, 0), Value::Signed(-1))]);
}

#[test]
fn restored_defaults_count_from_the_next_reset() {
    let mut device = drive();
    device.kind = DeviceKind::Node;
    let mapped = device.objects.get_mut(&0x1A00).unwrap().subs.get_mut(0).unwrap();
    mapped.configured_mut().value = Some(Value::Unsigned(1));
    let mut reader =
        FrameReader::new(vec![Talker { name: "drive", node_id: 5, device: &device, is_counterpart: false }]);
    let mut words = |can_id, data: &[u8]| reader.read(can_id, data, false).text;
    let configured = "drive TPDO 1 (3 bytes, expected 2): 6041:00 Statusword = 7";
    assert_eq!(words(0x185, &[7, 0, 8]), configured);
    words(0x605, &[0x23, 0x11, 0x10, 1, b'l', b'o', b'a', b'd']);
    words(0x585, &[0x60, 0x11, 0x10, 1, 0, 0, 0, 0]);
    assert_eq!(words(0x185, &[7, 0, 8]), configured);
    words(0, &[0x81, 5]);
    let defaults = "drive TPDO 1: 6041:00 Statusword = 7, 6061:00 Modes of operation display = 8";
    assert_eq!(words(0x185, &[7, 0, 8]), defaults);
}

/// Entries of each form have the values of the description after a reset, again and again. The device type, and what no description
/// has, are kept.
#[test]
fn a_reset_returns_to_the_description() {
    let mut device = drive();
    let compact = Compact { count: 3, values: vec![(1, Value::Unsigned(1))], ..Compact::default() };
    let main = Entry { object_type: Some(ObjectType::Array), ..entry("", DataType::UNSIGNED32, 7) };
    device.objects.insert(0x1016, Object { main, compact: Some(Box::new(compact)), ..Object::default() });
    let talker = Talker { name: "drive", node_id: 5, device: &device, is_counterpart: false };
    let mut reader = FrameReader::of_bus(vec![talker]);
    let entries: [(u8, u16, u8); 6] = [
        (0x23, 0x1000, 0),
        (0x23, 0x1016, 1),
        (0x23, 0x1016, 2),
        (0x2B, 0x1017, 0),
        (0x2F, 0x1800, 2),
        (0x2F, 0x1019, 0),
    ];
    for _ in 0..3 {
        for (command, index, sub) in entries {
            let [low, high] = index.to_le_bytes();
            reader.read(0x605, &[command, low, high, sub, 9, 0, 0, 0], false);
            reader.read(0x585, &[0x60, low, high, sub, 0, 0, 0, 0], false);
        }
        let value = |reader: &FrameReader<'_>, (_, index, sub)| {
            reader.device(5)?.value(index, sub).and_then(|value| value.as_integer())
        };
        assert_eq!(entries.map(|entry| value(&reader, entry)), [Some(9); 6]);
        reader.read(0, &[0x81, 5], false);
        let after = [Some(9), Some(1), Some(7), Some(0), Some(1), Some(9)];
        assert_eq!(entries.map(|entry| value(&reader, entry)), after);
    }
}

#[test]
fn a_transfer_that_does_not_state_its_size_has_that_of_the_entry() {
    let words = read(&[
        (0x605, &[0x22, 0x17, 0x10, 0, 0xE8, 3, 0, 0]),
        (0x585, &[0x60, 0x17, 0x10, 0, 0, 0, 0, 0]),
        (0x605, &[0x40, 0x17, 0x10, 0, 0, 0, 0, 0]),
        (0x585, &[0x42, 0x17, 0x10, 0, 0xE8, 3, 0, 0]),
    ]);
    assert_eq!(words[0], "drive: write 1017:00 Producer heartbeat time = 1000 (1000 ms)");
    assert_eq!(words[3], "drive: 1017:00 Producer heartbeat time = 1000 (1000 ms)");
}

/// A frame that is not an answer to anything that the log has.
#[test]
fn transfers_that_are_not_whole() {
    let words = read_bus(&[
        (0x585, &[1, 0x53, 0x65, 0x72, 0x76, 0x65, 0x72, 0]),
        (0x605, &[0xA2, 2, 2, 0, 0, 0, 0, 0]),
        (0x605, &[0x40, 8, 0x10, 0, 0, 0, 0, 0]),
        (0x585, &[0x41, 8, 0x10, 0, 9, 0, 0, 0]),
        (0x605, &[0x80, 0, 0, 0, 0, 0, 4, 5]),
        (0x585, &[0x1B, 0x33, 0x34, 0, 0, 0, 0, 0]),
        (0x605, &[0x60, 0, 0, 0, 0, 0, 0, 0]),
    ]);
    let expected = [
        "drive: segment or end of segments, in a transfer that began before the log",
        "drive: segments up to 2 are accepted, in a transfer that began before the log",
        "drive: read 1008:00 Device name",
        "drive: 1008:00 Device name, 9 bytes",
        "drive: 1008:00 Device name: SDO abort 05040000h: the transfer timed out",
        "drive: segment without a transfer",
        "drive: segment without a transfer",
    ];
    assert_eq!(words, expected);
    let words = read(&[(0x7E5, &[4, 2, 0, 0, 0, 0, 0, 0]), (0x7E5, &[4, 1, 0, 0, 0, 0, 0, 0])]);
    assert_eq!(
        words,
        ["LSS master: all nodes to 02h, which is no mode", "LSS master: all nodes to configuration"]
    );
}

/// The frames of a node without a description, and whether its profile is assumed.
fn read_unknown(profile: Option<u16>, frames: &[(u16, &[u8])]) -> Vec<String> {
    let mut reader = FrameReader::of_bus(Vec::new());
    profile.into_iter().for_each(|number| reader.assume_profile(number));
    frames.iter().map(|(can_id, data)| reader.read(*can_id, data, false).text).collect()
}

/// A mapping counts that a log has without answers, which is said; so are two TPDOs with one CAN-ID.
#[test]
fn mappings_without_answers_and_shared_can_ids() {
    let mapping: [(u16, &[u8]); 4] = [
        (0x602, &[0x2F, 0, 0x1A, 0, 0, 0, 0, 0]),
        (0x602, &[0x23, 0, 0x1A, 1, 0x10, 0, 0x41, 0x60]),
        (0x602, &[0x2F, 0, 0x1A, 0, 1, 0, 0, 0]),
        (0x182, &[0x37, 2]),
    ];
    let words = read_unknown(None, &mapping);
    assert_eq!(words[3], "node 2 TPDO 1 (its mapping was written, without an answer): 6041:00 = 237h");
    // a node that refuses it keeps its own
    let refusal: (u16, &[u8]) = (0x582, &[0x80, 0, 0x1A, 0, 0x22, 0, 0, 8]);
    let refused = [mapping[0], refusal, mapping[1], refusal, mapping[2], refusal, mapping[3]];
    assert_eq!(read_unknown(None, &refused)[6], "node 2 TPDO 1: 37h 02h");
    let shared = read_unknown(
        None,
        &[
            (0x602, &[0x23, 0, 0x18, 1, 0x85, 1, 0, 0]),
            (0x582, &[0x60, 0, 0x18, 1, 0, 0, 0, 0]),
            (0x602, &[0x23, 1, 0x18, 1, 0x85, 1, 0, 0]),
            (0x582, &[0x60, 1, 0x18, 1, 0, 0, 0, 0]),
            (0x185, &[1]),
        ],
    );
    assert_eq!(shared[4], "node 2 TPDO 1 (or node 2 TPDO 2, with the same CAN-ID): 01h, nothing is mapped");
}

/// A node that never states its profile is a drive if it is said so, or if it uses the words and the modes of one.
#[test]
fn a_drive_that_was_never_asked_for_its_type() {
    let status: (u16, &[u8]) = (0x582, &[0x4B, 0x41, 0x60, 0, 0x37, 2, 0, 0]);
    let word: [(u16, &[u8]); 2] = [(0x602, &[0x40, 0x41, 0x60, 0, 0, 0, 0, 0]), status];
    let mode: [(u16, &[u8]); 2] =
        [(0x602, &[0x40, 0x61, 0x60, 0, 0, 0, 0, 0]), (0x582, &[0x4F, 0x61, 0x60, 0, 1, 0, 0, 0])];
    let named = "node 2: 6041:00 Statusword = 567 (state: operation enabled, voltage enabled, remote)";
    assert_eq!(read_unknown(None, &word)[1], "node 2: 6041:00 = 37h 02h");
    assert_eq!(read_unknown(Some(402), &word)[1], named);
    assert_eq!(read_unknown(None, &[word, mode, word].concat())[5], named);
    // what the node says counts more: a device of CiA 401
    let kind: [(u16, &[u8]); 2] =
        [(0x602, &[0x40, 0, 0x10, 0, 0, 0, 0, 0]), (0x582, &[0x43, 0, 0x10, 0, 0x91, 1, 0xF, 0])];
    assert_eq!(read_unknown(Some(402), &[kind, word].concat())[3], "node 2: 6041:00 = 37h 02h");
}

//! The LSS slave, with the frames of CiA 305.

use objdict_device::{Frame, LssReceived, LssSlave, LssStoreError};

use crate::frame;

const IDENTITY: [u32; 4] = [0x0000_0319, 0x1234_5678, 0x0001_0002, 0xFFFF_FFFE];
const BIT_RATES: &[u16] = &[1000, 500, 250, 125, 0];

fn slave(node_id: Option<u8>) -> LssSlave {
    LssSlave::new(IDENTITY, node_id).with_bit_rates(BIT_RATES).with_storage()
}

fn configuring(node_id: Option<u8>) -> LssSlave {
    let mut slave = slave(node_id);
    assert_eq!(send(&mut slave, &[0x04, 1]), LssReceived::Ignored);
    assert!(slave.is_in_configuration());
    slave
}

fn full(id: u16, bytes: &[u8]) -> Frame {
    let mut data = [0; 8];
    data[..bytes.len()].copy_from_slice(bytes);
    frame(id, &data)
}

/// Sends the first bytes of a request.
fn send(slave: &mut LssSlave, bytes: &[u8]) -> LssReceived {
    slave.receive(&full(0x7E5, bytes), 0)
}

fn send_number(slave: &mut LssSlave, command: u8, number: u32) -> LssReceived {
    let [a, b, c, d] = number.to_le_bytes();
    send(slave, &[command, a, b, c, d])
}

fn answer(bytes: &[u8]) -> LssReceived {
    LssReceived::Answer(full(0x7E4, bytes))
}

/// Sends numbers with consecutive commands; returns the result of the last.
fn send_numbers(slave: &mut LssSlave, first: u8, numbers: &[u32]) -> LssReceived {
    let mut last = LssReceived::Ignored;
    for (command, &number) in (first..).zip(numbers) {
        assert_eq!(last, LssReceived::Ignored, "only the last number has an answer");
        last = send_number(slave, command, number);
    }
    last
}

#[test]
fn a_node_is_selected_by_its_identity() {
    for part in 0..4 {
        let mut other = IDENTITY;
        other[part] ^= 1 << (8 * part);
        let mut slave = slave(Some(5));
        assert_eq!(send_numbers(&mut slave, 0x40, &other), LssReceived::Ignored);
        assert!(!slave.is_in_configuration());
        assert_eq!(send_numbers(&mut slave, 0x40, &IDENTITY), answer(&[0x44]));
        assert!(slave.is_in_configuration());
        assert_eq!(send(&mut slave, &[0x04, 0]), LssReceived::Ignored);
        assert!(!slave.is_in_configuration());
        // the last number on its own is not a selection
        assert_eq!(send_number(&mut slave, 0x43, IDENTITY[3]), LssReceived::Ignored);
    }
}

#[test]
fn the_state_is_switched_globally() {
    let mut slave = configuring(Some(5));
    assert_eq!(send(&mut slave, &[0x04, 2]), LssReceived::Ignored);
    assert!(slave.is_in_configuration());
    assert_eq!(send(&mut slave, &[0x04, 0]), LssReceived::Ignored);
    for command in (0x11..=0x17).chain(0x5A..=0x5E) {
        assert_eq!(send(&mut slave, &[command, 5]), LssReceived::Ignored, "{command:02X}h while waiting");
    }
    assert_eq!(slave.reset(), Some(5));
}

#[test]
fn a_node_is_identified_by_ranges_in_both_states() {
    let [vendor, product, revision, serial] = IDENTITY;
    let within = [vendor, product, revision, revision, serial, serial];
    let cases = [
        (within, true),
        ([vendor, product, 0, u32::MAX, 0, u32::MAX], true),
        ([vendor + 1, product, 0, u32::MAX, 0, u32::MAX], false),
        ([vendor, product - 1, 0, u32::MAX, 0, u32::MAX], false),
        ([vendor, product, revision + 1, u32::MAX, 0, u32::MAX], false),
        ([vendor, product, 0, revision - 1, 0, u32::MAX], false),
        ([vendor, product, 0, u32::MAX, serial + 1, u32::MAX], false),
        ([vendor, product, 0, u32::MAX, 0, serial - 1], false),
    ];
    for mut slave in [slave(Some(5)), slave(None), configuring(Some(5))] {
        for (numbers, is_found) in cases {
            let expected = if is_found { answer(&[0x4F]) } else { LssReceived::Ignored };
            assert_eq!(send_numbers(&mut slave, 0x46, &numbers), expected, "{numbers:X?}");
        }
    }
}

#[test]
fn a_node_without_node_id_gets_one() {
    let mut slave = slave(None);
    assert_eq!((slave.node_id(), send(&mut slave, &[0x4C])), (None, answer(&[0x50])));
    send(&mut slave, &[0x04, 1]);
    assert_eq!(send(&mut slave, &[0x5E]), answer(&[0x5E, 0xFF]));
    assert_eq!(send(&mut slave, &[0x11, 42]), answer(&[0x11, 0]));
    assert_eq!(send(&mut slave, &[0x5E]), answer(&[0x5E, 42]));
    assert_eq!(slave.node_id(), None, "not before the node is waiting");
    assert_eq!(send(&mut slave, &[0x04, 0]), LssReceived::NodeId(42));
    assert_eq!(slave.node_id(), Some(42));
    assert_eq!(send(&mut slave, &[0x4C]), LssReceived::Ignored);
    assert_eq!(send(&mut slave, &[0x04, 0]), LssReceived::Ignored);
}

#[test]
fn another_node_id_is_that_after_the_next_reset() {
    let mut slave = configuring(Some(5));
    for node_id in [0, 128, 200, 254] {
        assert_eq!(send(&mut slave, &[0x11, node_id]), answer(&[0x11, 1]), "{node_id}");
    }
    for (node_id, after) in [(1, Some(1)), (127, Some(127)), (0xFF, None)] {
        assert_eq!(send(&mut slave, &[0x11, node_id]), answer(&[0x11, 0]));
        let before = slave.node_id();
        assert_eq!(send(&mut slave, &[0x5E]), answer(&[0x5E, before.unwrap()]));
        assert_eq!(send(&mut slave, &[0x04, 0]), LssReceived::Ignored);
        assert_eq!((slave.node_id(), slave.reset()), (before, after));
        send(&mut slave, &[0x04, 1]);
    }
    assert_eq!(LssSlave::new(IDENTITY, Some(128)).node_id(), None);
}

#[test]
fn the_identity_is_inquired() {
    let mut slave = configuring(Some(5));
    for (command, number) in (0x5A..).zip(IDENTITY) {
        let [a, b, c, d] = number.to_le_bytes();
        assert_eq!(send(&mut slave, &[command]), answer(&[command, a, b, c, d]));
    }
    assert_eq!(send(&mut slave, &[0x5E]), answer(&[0x5E, 5]));
}

#[test]
fn bit_rates_are_those_of_the_driver() {
    let mut slave = configuring(Some(5));
    for row in 0..=255 {
        let error = u8::from(![0, 2, 3, 4, 9].contains(&row));
        assert_eq!(send(&mut slave, &[0x13, 0, row]), answer(&[0x13, error]), "row {row}");
        assert_eq!(send(&mut slave, &[0x13, 1, row]), answer(&[0x13, 1]), "another table");
    }
    let mut slave = LssSlave::new(IDENTITY, Some(5));
    send(&mut slave, &[0x04, 1]);
    assert_eq!(send(&mut slave, &[0x13, 0, 2]), answer(&[0x13, 1]));
}

/// The node is silent for the delay, changes the bit rate, and is silent for the delay again.
#[test]
fn the_bit_rate_changes_between_two_delays() {
    let mut slave = configuring(Some(5));
    let activate = full(0x7E5, &[0x15, 0x2C, 0x01]);
    assert_eq!(slave.receive(&activate, 1000), LssReceived::Ignored);
    assert!(!slave.is_silent(), "no bit rate is configured");
    send(&mut slave, &[0x13, 0, 3]);
    slave.receive(&activate, 1000);
    assert_eq!((slave.is_silent(), slave.next()), (true, Some(301_000)));
    assert_eq!(slave.poll(300_999), None);
    assert_eq!(slave.poll(301_100), Some(250));
    assert_eq!((slave.is_silent(), slave.next()), (true, Some(601_000)));
    assert_eq!(send(&mut slave, &[0x5E]), LssReceived::Ignored);
    assert_eq!((slave.poll(600_999), slave.is_silent()), (None, true));
    assert_eq!((slave.poll(601_000), slave.is_silent()), (None, false));
    assert_eq!((slave.poll(700_000), slave.next()), (None, None));
    assert_eq!(send(&mut slave, &[0x5E]), answer(&[0x5E, 5]));
}

#[test]
fn the_application_stores() {
    let mut slave = configuring(Some(5));
    assert_eq!(send(&mut slave, &[0x17]), LssReceived::Store { node_id: Some(5), bit_rate: None });
    send(&mut slave, &[0x11, 0xFF]);
    send(&mut slave, &[0x13, 0, 9]);
    assert_eq!(send(&mut slave, &[0x17]), LssReceived::Store { node_id: None, bit_rate: Some(0) });
    let cases = [
        (Ok(()), [0x17, 0, 0]),
        (Err(LssStoreError::NoAccess), [0x17, 2, 0]),
        (Err(LssStoreError::Vendor(7)), [0x17, 0xFF, 7]),
    ];
    for (result, bytes) in cases {
        assert_eq!(LssReceived::Answer(LssSlave::answer_store(result)), answer(&bytes));
    }
    let mut slave = LssSlave::new(IDENTITY, Some(5));
    send(&mut slave, &[0x04, 1]);
    assert_eq!(send(&mut slave, &[0x17]), answer(&[0x17, 1]));
}

#[test]
fn other_frames_are_ignored() {
    let mut slave = slave(None);
    for frame in [frame(0x7E5, &[0x4C]), full(0x7E4, &[0x4C]), full(0x7E5, &[0x50]), full(0x605, &[0x4C])] {
        assert_eq!(slave.receive(&frame, 0), LssReceived::Ignored);
    }
}

/// Whether any slave responds; if so, it must be the identification.
fn ask(slaves: &mut [LssSlave], number: u32, rest: [u8; 3]) -> bool {
    let ([a, b, c, d], [bit, part, next]) = (number.to_le_bytes(), rest);
    let answers: Vec<_> = slaves
        .iter_mut()
        .map(|slave| send(slave, &[0x51, a, b, c, d, bit, part, next]))
        .filter(|received| *received != LssReceived::Ignored)
        .collect();
    assert!(answers.iter().all(|received| *received == answer(&[0x4F])));
    !answers.is_empty()
}

/// The search of a master: bit by bit from the highest, part by part.
fn fastscan(slaves: &mut [LssSlave]) -> Option<[u32; 4]> {
    if !ask(slaves, 0, [0x80, 0, 0]) {
        return None;
    }
    let mut found = [0; 4];
    for part in 0..4_u8 {
        let number = &mut found[usize::from(part)];
        for bit in (0..32).rev() {
            if !ask(slaves, *number, [bit, part, part]) {
                *number |= 1 << bit;
            }
        }
        assert!(ask(slaves, *number, [0, part, (part + 1) & 3]), "{number:X}h is there");
    }
    Some(found)
}

#[test]
fn fastscan_finds_each_slave_without_node_id() {
    let identities = [
        IDENTITY,
        [0x319, 0x1234_5678, 0x0001_0002, 0],
        [0x319, 0x1234_5678, 0x0001_0003, 7],
        [0x318, u32::MAX, 0, 0],
        [u32::MAX; 4],
        [0; 4],
    ];
    let mut slaves = identities.map(|identity| LssSlave::new(identity, None)).to_vec();
    slaves.push(LssSlave::new([1; 4], Some(9)));
    let mut expected = identities.to_vec();
    for node_id in 1.. {
        let Some(found) = fastscan(&mut slaves) else { break };
        let at = expected.iter().position(|identity| *identity == found).expect("one that is left");
        expected.remove(at);
        let selected = slaves.iter_mut().find(|slave| slave.is_in_configuration()).unwrap();
        assert_eq!(send_number(selected, 0x5D, 0), answer(&[&[0x5D][..], &found[3].to_le_bytes()].concat()));
        assert_eq!(send(selected, &[0x11, node_id]), answer(&[0x11, 0]));
        assert_eq!(send(selected, &[0x04, 0]), LssReceived::NodeId(node_id));
        assert!(slaves.iter().all(|slave| !slave.is_in_configuration()));
    }
    assert_eq!(expected, [[0; 4]; 0]);
}

#[test]
fn fastscan_ignores_what_makes_no_sense() {
    let mut slave = [slave(None)];
    for rest in [[32, 0, 0], [0x7F, 0, 0], [0x81, 0, 0], [0, 4, 0], [0, 0, 4], [0, 255, 0], [31, 1, 1]] {
        assert!(!ask(&mut slave, IDENTITY[0], rest), "{rest:?}");
    }
    assert!(ask(&mut slave, IDENTITY[0], [0, 0, 1]));
    assert!(!ask(&mut slave, IDENTITY[0], [0, 0, 1]), "the next part is due");
    assert!(ask(&mut slave, 0, [0x80, 0, 0]) && ask(&mut slave, IDENTITY[0], [0, 0, 1]));
    // neither a node with node-ID, nor one that is about to have one, nor one in the configuration state
    let mut soon = configuring(None);
    send(&mut soon, &[0x11, 5]);
    for mut slave in [[self::slave(Some(5))], [soon], [configuring(None)]] {
        assert!(!ask(&mut slave, 0, [0x80, 0, 0]));
    }
}

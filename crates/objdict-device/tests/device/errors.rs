//! Errors: the register, the history, emergency messages, and the behaviour of the node.

use objdict_device::table::{Data, Entry, READ, Table};
use objdict_device::{
    Abort, Dictionary, Frame, Heartbeat, NmtState, Node, Pdos, Received, Reception, error_code,
};

use crate::dictionary::{Map, UNSIGNED8, UNSIGNED16, UNSIGNED32};
use crate::frame;

type Device = Node<Map, 16, 1, 2, 0, 1>;

fn map() -> Map {
    let map = Map::default().number(0x1001, 0, UNSIGNED8, 0).number(0x1003, 0, UNSIGNED8, 0);
    let map = (1..=2).fold(map, |map, sub| map.number(0x1003, sub, UNSIGNED32, 0));
    let map = map.number(0x1014, 0, UNSIGNED32, 0x85).number(0x1016, 1, UNSIGNED32, 0x0007_0064);
    let map = [0x1400, 0x1401].into_iter().fold(map, |map, index| {
        let map = map.number(index, 1, UNSIGNED32, 0x205).number(index, 2, UNSIGNED8, 255);
        map.number(index, 5, UNSIGNED16, 50).number(index + 0x200, 0, UNSIGNED8, 1)
    });
    let map = map.number(0x1600, 1, UNSIGNED32, 0x2000_0010).number(0x1601, 1, UNSIGNED32, 0x2001_0008);
    map.number(0x2000, 0, UNSIGNED16, 0).number(0x2001, 0, UNSIGNED8, 0)
}

fn operational(map: Map) -> Device {
    let mut device = Device::new(5, map, Pdos::new([0x1400, 0x1401], []));
    device.boot(0);
    device.receive(&frame(0, &[1, 5]), 0);
    device
}

fn sent(device: &mut Device, now: u64) -> Vec<Frame> {
    std::iter::from_fn(|| device.poll(now)).collect()
}

fn emergency(code: u16, register: u8, name: u8) -> Frame {
    let [low, high] = code.to_le_bytes();
    frame(0x85, &[low, high, register, name, 0, 0, 0, 0])
}

#[test]
fn an_error_is_reported_once_until_it_is_gone() {
    let mut device = operational(map());
    device.report(0x2310, [9, 0, 1, 2, 3]);
    device.report(0x2310, [9, 0, 1, 2, 3]);
    assert_eq!(sent(&mut device, 0), [frame(0x85, &[0x10, 0x23, 0x03, 9, 0, 1, 2, 3])]);
    device.report(0x4210, [0; 5]);
    assert_eq!(sent(&mut device, 0), [emergency(0x4210, 0x0B, 0)]);
    assert_eq!(device.dictionary.value(0x1001, 0), [0x0B]);
    assert_eq!(device.guard().number(0x1003, 0), Ok(2));
    assert_eq!(device.guard().number(0x1003, 1), Ok(0x4210));
    assert_eq!(device.guard().number(0x1003, 2), Ok(0x0009_2310));
    device.report(0x8110, [0; 5]);
    assert_eq!(device.guard().number(0x1003, 2), Ok(0x4210), "the oldest one is dropped");
    assert_eq!(sent(&mut device, 0).len(), 1);
    device.resolve(0x2310, [9, 0]);
    device.resolve(0x2310, [9, 0]);
    assert_eq!(sent(&mut device, 0), [emergency(0, 0x19, 9)]);
    // writing 0 clears the history, but not the register
    assert_eq!(device.guard().write(0x1003, 0, &[0]), Ok(()));
    assert_eq!(device.guard().number(0x1003, 1), Err(Abort::NoData));
    assert_eq!(device.dictionary.value(0x1001, 0), [0x19]);
    device.receive(&frame(0, &[130, 5]), 0);
    device.boot(0);
    assert_eq!(device.dictionary.value(0x1001, 0), [0]);
}

/// Descriptions with a 32-bit number of errors exist.
#[test]
fn a_history_has_the_width_of_its_description() {
    let mut device = operational(map().number(0x1003, 0, UNSIGNED32, 2));
    assert_eq!(device.dictionary.value(0x1003, 0), [0; 4]);
    device.report(0x2310, [0; 5]);
    assert_eq!(device.dictionary.value(0x1003, 0), [1, 0, 0, 0]);
}

#[test]
fn messages_wait_for_the_inhibit_time() {
    let mut device = operational(map().number(0x1015, 0, UNSIGNED16, 20));
    for name in 0..6 {
        device.report(0xFF00, [name, 0, 0, 0, 0]);
    }
    assert_eq!(sent(&mut device, 10), [emergency(0xFF00, 0x81, 0)]);
    assert_eq!(device.next(10), Some(2010));
    assert_eq!(sent(&mut device, 2009), []);
    assert_eq!(sent(&mut device, 2010), [emergency(0xFF00, 0x81, 1)]);
    // four wait at most
    let rest: Vec<Frame> = (2..10).flat_map(|at| sent(&mut device, 2010 * at)).collect();
    assert_eq!(rest, [emergency(0xFF00, 0x81, 2), emergency(0xFF00, 0x81, 3)]);
    assert_eq!(device.next(100_000), None);
    // nothing is sent while bit 31 of 1014h is set
    device.guard().write(0x1014, 0, &0x8000_0085_u32.to_le_bytes()).unwrap();
    device.report(0xFF01, [0; 5]);
    assert_eq!(sent(&mut device, 100_000), []);
}

#[test]
fn a_lost_heartbeat_leads_to_pre_operational() {
    for (behaviour, state) in
        [(None, NmtState::PreOperational), (Some(1), NmtState::Operational), (Some(2), NmtState::Stopped)]
    {
        let map =
            behaviour.into_iter().fold(map(), |map, behaviour| map.number(0x1029, 1, UNSIGNED8, behaviour));
        let mut device = operational(map);
        let heartbeat = |device: &mut Device, now| device.receive(&frame(0x707, &[5]), now);
        let first = Heartbeat::State(7, NmtState::Operational);
        assert_eq!(heartbeat(&mut device, 0), Received::Heartbeat(first));
        assert_eq!(device.next(0), Some(100_001));
        assert_eq!(sent(&mut device, 100_000), []);
        let messages = sent(&mut device, 100_001);
        assert_eq!(device.state(), state);
        if state == NmtState::Stopped {
            continue;
        }
        assert_eq!(messages, [emergency(error_code::HEARTBEAT, 0x11, 7)]);
        heartbeat(&mut device, 200_000);
        assert_eq!(sent(&mut device, 200_000), [emergency(0, 0, 7)]);
    }
}

/// Two RPDOs have the same CAN-ID; only one of them is too short, or too long.
#[test]
fn rpdos_of_another_length_are_reported() {
    let mut device = operational(map());
    assert_eq!(device.receive(&frame(0x205, &[1]), 0), Received::Pdo(Reception::Written(0x1401)));
    assert_eq!(sent(&mut device, 0), [emergency(error_code::PDO_TOO_SHORT, 0x11, 1)]);
    assert_eq!(
        (device.dictionary.value(0x2000, 0), device.dictionary.value(0x2001, 0)),
        (&[0, 0][..], &[1][..])
    );
    device.receive(&frame(0x205, &[2, 3]), 10_000);
    assert_eq!(sent(&mut device, 10_000), [emergency(0, 0, 1), emergency(error_code::PDO_TOO_LONG, 0x11, 2)]);
    assert_eq!(
        (device.dictionary.value(0x2000, 0), device.dictionary.value(0x2001, 0)),
        (&[2, 3][..], &[2][..])
    );
    // both are missing after their event timers
    assert_eq!(device.next(10_000), Some(60_000));
    let missing = [1, 2].map(|number| emergency(error_code::RPDO_TIMEOUT, 0x11, number));
    assert_eq!(sent(&mut device, 60_000), missing);
    assert_eq!(device.state(), NmtState::Operational);
}

#[test]
fn a_sync_of_another_length_is_reported() {
    let mut device = operational(map());
    assert_eq!(device.receive(&frame(0x80, &[7]), 0), Received::Pdo(Reception::Sync));
    assert_eq!(sent(&mut device, 0), [emergency(error_code::SYNC_LENGTH, 0x11, 0)]);
    device.receive(&frame(0x80, &[]), 0);
    assert_eq!(sent(&mut device, 0), [emergency(0, 0, 0)]);
}

/// A device without 1003h and 1014h.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plain;

impl Table for Plain {
    const ENTRIES: &'static [Entry<Self>] =
        &[Entry::new(0x1000, 0, UNSIGNED32, READ, 0, 0), Entry::new(0x1001, 0, UNSIGNED8, READ, 1, 0)];
    const ROM: &'static [u8] = &[0; 4];
}

#[test]
fn without_1014h_there_is_the_register_alone() {
    let mut device = Node::<_, 8, 1, 0, 0, 0>::new(5, Data::<Plain, 2>::new(5), Pdos::new([], []));
    device.boot(0);
    device.report(0x2310, [0; 5]);
    assert_eq!((device.poll(0), device.next(0)), (None, None));
    assert_eq!(device.dictionary.number(0x1001, 0), Ok(3));
}

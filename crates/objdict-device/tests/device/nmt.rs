//! NMT, heartbeat and emergency.

use objdict_device::{Heartbeat, HeartbeatConsumer, Nmt, NmtCommand, NmtState, emergency};

use crate::dictionary::{Map, UNSIGNED32};
use crate::frame;

#[test]
fn a_node_follows_its_master() {
    let mut nmt = Nmt::new(5);
    assert_eq!(nmt.receive(&frame(0, &[1, 5])), None, "before boot-up");
    assert_eq!(nmt.boot(0), frame(0x705, &[0]));
    for (command, node_id, expected, state) in [
        (1, 6, None, NmtState::PreOperational),
        (1, 5, Some(NmtCommand::Start), NmtState::Operational),
        (2, 0, Some(NmtCommand::Stop), NmtState::Stopped),
        (128, 5, Some(NmtCommand::EnterPreOperational), NmtState::PreOperational),
        (3, 5, None, NmtState::PreOperational),
        (130, 5, Some(NmtCommand::ResetCommunication), NmtState::Initialising),
        (1, 5, None, NmtState::Initialising),
    ] {
        assert_eq!(nmt.receive(&frame(0, &[command, node_id])), expected, "{command}");
        assert_eq!(nmt.state(), state);
    }
    assert_eq!(nmt.poll(100, 1_000_000), None, "no heartbeat before boot-up");
    nmt.boot(2_000_000);
    assert_eq!(nmt.receive(&frame(0, &[129, 0])), Some(NmtCommand::ResetNode));
    assert_eq!(nmt.receive(&frame(0, &[1])), None, "too short");
}

#[test]
fn heartbeats_come_after_the_period_and_with_a_new_state() {
    let mut nmt = Nmt::new(5);
    nmt.boot(0);
    assert_eq!(nmt.poll(0, 1_000_000), None, "1017h is 0");
    assert_eq!(nmt.poll(100, 99_999), None);
    assert_eq!(nmt.poll(100, 100_000), Some(frame(0x705, &[0x7F])));
    assert_eq!(nmt.poll(100, 199_999), None);
    nmt.receive(&frame(0, &[1, 5]));
    assert_eq!(nmt.poll(100, 199_999), Some(frame(0x705, &[5])));
    assert_eq!(nmt.poll(100, 200_000), None);
}

#[test]
fn a_lost_heartbeat_is_reported_once() {
    // 16 ms from node 7, none from node 8, no node-ID of 7 bits
    let map = [0x0007_0010, 0x0008_0000, 0x0087_0010].into_iter().zip(1..);
    let mut map = map.fold(Map::default(), |map, (value, sub)| map.number(0x1016, sub, UNSIGNED32, value));
    let mut consumer = HeartbeatConsumer::<4>::default();
    consumer.load(&mut map);
    assert_eq!(consumer.poll(1_000_000), None, "before its first heartbeat");
    assert_eq!(consumer.receive(&frame(0x707, &[0]), 0), Some(Heartbeat::State(7, NmtState::Initialising)));
    assert_eq!(
        consumer.receive(&frame(0x707, &[5]), 16_000),
        Some(Heartbeat::State(7, NmtState::Operational))
    );
    assert_eq!(consumer.receive(&frame(0x707, &[5]), 32_000), None);
    assert_eq!(consumer.receive(&frame(0x708, &[5]), 32_000), None);
    assert_eq!(consumer.poll(48_000), None);
    assert_eq!(consumer.poll(48_001), Some(Heartbeat::Lost(7)));
    assert_eq!(consumer.poll(96_000), None);
    assert_eq!(consumer.receive(&frame(0x707, &[4]), 96_000), Some(Heartbeat::State(7, NmtState::Stopped)));
}

#[test]
fn an_emergency_has_the_cob_id_of_1014h() {
    let mut map = Map::default();
    let sent = frame(0x85, &[0x30, 0x81, 0x11, 1, 2, 3, 4, 5]);
    assert_eq!(emergency(&mut map, 5, 0x8130, 0x11, [1, 2, 3, 4, 5]), Some(sent));
    let mut map = map.number(0x1014, 0, UNSIGNED32, 0x8000_0085);
    assert_eq!(emergency(&mut map, 5, 0x8130, 0x11, [0; 5]), None);
    map.set(0x1014, 0, &0xC3_u32.to_le_bytes());
    assert_eq!(emergency(&mut map, 5, 0, 0, [0; 5]), Some(frame(0xC3, &[0; 8])));
}

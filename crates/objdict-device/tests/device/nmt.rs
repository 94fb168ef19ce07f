//! NMT and heartbeat.

use objdict_device::{Heartbeat, HeartbeatConsumer, Nmt, NmtCommand, NmtState};

use crate::dictionary::{Map, UNSIGNED16, UNSIGNED32};
use crate::frame;

#[test]
fn a_node_follows_its_master() {
    let mut nmt = Nmt::new(5);
    assert_eq!(nmt.receive(&frame(0, &[1, 5])), None, "before boot-up");
    assert_eq!(nmt.boot(&mut Map::default(), 0), frame(0x705, &[0]));
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
    assert_eq!(nmt.poll(1_000_000), None, "no heartbeat before boot-up");
    nmt.boot(&mut Map::default(), 2_000_000);
    assert_eq!(nmt.receive(&frame(0, &[129, 0])), Some(NmtCommand::ResetNode));
    assert_eq!(nmt.receive(&frame(0, &[1])), None, "too short");
}

#[test]
fn heartbeats_keep_their_phase_and_skip_missed_periods() {
    let mut map = Map::default().number(0x1017, 0, UNSIGNED16, 100);
    let mut nmt = Nmt::new(5);
    nmt.boot(&mut map, 0);
    assert_eq!(nmt.next(0), Some(100_000), "the boot-up message counts as a heartbeat");
    assert_eq!(nmt.poll(99_999), None);
    assert_eq!(nmt.poll(130_000), Some(frame(0x705, &[0x7F])), "30 ms late");
    assert_eq!(nmt.poll(130_000), None);
    assert_eq!(nmt.next(130_000), Some(200_000));
    assert_eq!(nmt.poll(750_000), Some(frame(0x705, &[0x7F])), "six periods were missed");
    assert_eq!(nmt.poll(750_000), None);
    assert_eq!(nmt.next(750_000), Some(800_000));
    // a new state is sent at once
    nmt.receive(&frame(0, &[1, 5]));
    assert_eq!(nmt.next(760_000), Some(760_000));
    assert_eq!(nmt.poll(760_000), Some(frame(0x705, &[5])));
    assert_eq!(nmt.next(760_000), Some(800_000));
    // a new period begins at once
    map.set(0x1017, 0, &[10, 0]);
    nmt.load(&mut map);
    assert_eq!(nmt.poll(765_000), Some(frame(0x705, &[5])));
    assert_eq!(nmt.next(765_000), Some(775_000));
    map.set(0x1017, 0, &[0, 0]);
    nmt.load(&mut map);
    assert_eq!((nmt.next(765_000), nmt.poll(9_000_000)), (None, None));
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
    assert_eq!(consumer.next(), None);
    let returned = consumer.receive(&frame(0x707, &[4]), 96_000);
    assert_eq!(returned, Some(Heartbeat::Returned(7, NmtState::Stopped)));
    assert_eq!(consumer.next(), Some(112_001));
}

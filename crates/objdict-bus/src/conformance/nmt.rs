//! NMT: states, commands, boot-up (CiA 301 §7.2.8.3, §7.3.2).

use objdict_device::Frame;

use super::bench::{
    Bench, ENTER_PRE_OPERATIONAL, OPERATIONAL, PRE_OPERATIONAL, RESET_COMMUNICATION, RESET_NODE, START, STOP,
    STOPPED,
};
use super::described::DescribedEntry;
use super::{CheckStep, checks, ensure};

checks! { "NMT":
    "7.2.8.3.3" "boot-up message after power-on" @Commands boot_up;
    "7.3.2.2.1" "state after power-on" @Commands |bench| { let watch = bench.watch()?; let state = state_after_boot(bench); bench.expect_state(watch, state) };
    "7.2.8.3.1" "start in pre-operational" @Commands |bench| command(bench, ENTER_PRE_OPERATIONAL, START, OPERATIONAL);
    "7.2.8.3.1" "start in operational" @Commands |bench| command(bench, START, START, OPERATIONAL);
    "7.2.8.3.1" "start in stopped" @Commands |bench| command(bench, STOP, START, OPERATIONAL);
    "7.2.8.3.1" "stop in pre-operational" @Commands |bench| command(bench, ENTER_PRE_OPERATIONAL, STOP, STOPPED);
    "7.2.8.3.1" "stop in operational" @Commands |bench| command(bench, START, STOP, STOPPED);
    "7.2.8.3.1" "stop in stopped" @Commands |bench| command(bench, STOP, STOP, STOPPED);
    "7.2.8.3.1" "enter pre-operational in pre-operational" @Commands |bench| command(bench, ENTER_PRE_OPERATIONAL, ENTER_PRE_OPERATIONAL, PRE_OPERATIONAL);
    "7.2.8.3.1" "enter pre-operational in operational" @Commands |bench| command(bench, START, ENTER_PRE_OPERATIONAL, PRE_OPERATIONAL);
    "7.2.8.3.1" "enter pre-operational in stopped" @Commands |bench| command(bench, STOP, ENTER_PRE_OPERATIONAL, PRE_OPERATIONAL);
    "7.2.8.3.1" "reset node in pre-operational" @Commands |bench| reset(bench, ENTER_PRE_OPERATIONAL, RESET_NODE);
    "7.2.8.3.1" "reset node in operational" @Commands |bench| reset(bench, START, RESET_NODE);
    "7.2.8.3.1" "reset node in stopped" @Commands |bench| reset(bench, STOP, RESET_NODE);
    "7.2.8.3.1" "reset communication in pre-operational" @Commands |bench| reset(bench, ENTER_PRE_OPERATIONAL, RESET_COMMUNICATION);
    "7.2.8.3.1" "reset communication in operational" @Commands |bench| reset(bench, START, RESET_COMMUNICATION);
    "7.2.8.3.1" "reset communication in stopped" @Commands |bench| reset(bench, STOP, RESET_COMMUNICATION);
    "7.2.8.3.1" "a command to all nodes is obeyed" |bench| frame(bench, &[STOP, 0], true);
    "7.2.8.3.1" "a command to a different node is ignored" |bench| { let other = bench.neighbour(); frame(bench, &[STOP, other], false) };
    "7.2.8.3.1" "an unknown command is ignored" @Commands |bench| { let node_id = bench.node_id() as u8; frame(bench, &[3, node_id], false) };
    "7.2.8.3.1" "a command of one byte is ignored" @Commands |bench| frame(bench, &[STOP], false);
    "7.3.2.2" "no SDO response in stopped" @Commands |bench| { bench.command(STOP); let answers = bench.answers(); ensure(!answers, || "an SDO is answered".into()) };
}

fn boot_up(bench: &mut Bench<'_>) -> CheckStep {
    let expected = Frame::new(0x700 + bench.node_id(), &[0]);
    ensure(Some(bench.boot_up) == expected, || {
        "the boot-up message is not 700h + node-ID with the byte 0".into()
    })
}

/// A node without 1F80h, or with bit 2 of it, waits for the master (CiA 302-2).
fn state_after_boot(bench: &Bench<'_>) -> u8 {
    let starts = bench.described.find(0x1F80, 0).is_some_and(DescribedEntry::is_readable);
    if starts && bench.described.number(0x1F80, 0) & 5 == 0 { OPERATIONAL } else { PRE_OPERATIONAL }
}

fn command(bench: &mut Bench<'_>, before: u8, command: u8, expected: u8) -> CheckStep {
    let watch = bench.watch()?;
    bench.command(before);
    bench.command(command);
    bench.expect_state(watch, expected)
}

fn reset(bench: &mut Bench<'_>, before: u8, command: u8) -> CheckStep {
    bench.command(before);
    let boot_up = Frame::new(0x700 + bench.node_id(), &[0]);
    let sent = bench.command(command);
    ensure(sent.iter().any(|frame| Some(*frame) == boot_up), || "no boot-up message".into())?;
    let (watch, state) = (bench.watch()?, state_after_boot(bench));
    bench.expect_state(watch, state)
}

/// Whether a frame stops a pre-operational node.
fn frame(bench: &mut Bench<'_>, data: &[u8], stops: bool) -> CheckStep {
    let watch = bench.watch()?;
    bench.command(ENTER_PRE_OPERATIONAL);
    bench.send(0, data);
    bench.expect_state(watch, if stops { STOPPED } else { PRE_OPERATIONAL })
}

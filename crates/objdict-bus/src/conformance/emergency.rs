//! Emergency messages, the error register and the history (CiA 301 §7.2.7, §7.5.2.2, §7.5.2.4, §7.5.2.17, §7.5.2.18). The error
//! is a SYNC of a wrong length, because a master can cause it on every node.

use objdict_device::{Abort, Frame};

use super::bench::{Bench, MS, RESET_COMMUNICATION, STOP, SentFrame};
use super::described::hex;
use super::sync_frame::{send_sync, send_wrong_sync, sync_id};
use super::{CheckStep, checks, ensure, impossible};

checks! { "emergency":
    "7.2.7" "an error is reported once, and that it is gone" once;
    "7.5.2.2" "the bits of 1001h are set and cleared" register;
    "7.5.2.4" "1003h begins with the last error" history;
    "7.5.2.4" "1003h sub 1 without an error" |bench| { bench.described.needs(0x1003, 1)?; let read = bench.upload(0x1003, 1); ensure(read == Err(Abort::NoData), || super::described::answer(&read)) };
    "7.5.2.4" "0 to 1003h clears the history" clear;
    "7.5.2.4" "a number other than 0 to 1003h is rejected" |bench| bench.refuse(0x1003, 0, 1, Abort::InvalidValue);
    "7.5.2.17" "1014h: bit 31 ends the messages" disabled;
    "7.5.2.17" "1014h: a new CAN-ID" moved;
    "7.5.2.17" "1014h: a new CAN-ID while it is valid is rejected" |bench| { let id = can_id(bench)?; bench.refuse(0x1014, 0, u64::from(id ^ 1), Abort::InvalidValue) };
    "7.3.5" "1014h: a restricted CAN-ID is rejected" |bench| { disable(bench)?; bench.refuse(0x1014, 0, 0x601, Abort::InvalidValue) };
    "7.5.2.17" "1014h: a CAN-ID of 29 bits is rejected" |bench| { disable(bench)?; bench.refuse(0x1014, 0, 0x2000_0081, Abort::InvalidValue) };
    "7.5.2.18" "the inhibit time of 1015h" inhibited;
    "7.2.7" "no message in stopped" stopped;
    "7.2.7" "a reset ends the errors" reset;
}

/// The CAN-ID of the messages.
pub(super) fn can_id(bench: &Bench<'_>) -> CheckStep<u16> {
    let standard = 0x80 + u64::from(bench.described.node_id);
    let entry = bench.described.needs(0x1014, 0)?;
    let cob_id = if entry.is_readable() { bench.described.number(0x1014, 0) } else { standard };
    match cob_id >> 29 {
        0 => Ok((cob_id & 0x7FF) as u16),
        _ => impossible("1014h is not valid or has 29 bits by default"),
    }
}

/// The default of 1015h in microseconds.
pub(super) fn inhibit_time(bench: &Bench<'_>) -> u64 {
    bench.described.number(0x1015, 0).min(0xFFFF) * 100
}

/// Checks that there is one message, with this error and these bits of the register.
pub(super) fn expect_message(sent: &[SentFrame], code: u16, register: u8) -> CheckStep {
    let [(_, frame)] = sent else {
        return super::failed(format!("{} emergency messages, not one", sent.len()));
    };
    let [low, high] = code.to_le_bytes();
    let data = frame.data();
    let is_expected = data.len() == 8 && data[..2] == [low, high] && data[2] & register == register;
    ensure(is_expected, || format!("the message is {}, not {low:02X} {high:02X}", hex(data)))
}

/// A history whose number the node can count.
fn needs_history(bench: &Bench<'_>) -> CheckStep {
    bench.described.needs(0x1003, 1)?;
    match bench.described.needs(0x1003, 0)?.size() {
        Some(1) => Ok(()),
        _ => impossible("1003h does not have one byte"),
    }
}

/// Checks that an error is the last one in the history, where there is one.
pub(super) fn expect_history(bench: &mut Bench<'_>, code: u16) -> CheckStep {
    if needs_history(bench).is_err() {
        return Ok(());
    }
    let last = bench.number(0x1003, 1)?;
    ensure(last & 0xFFFF == u64::from(code), || format!("1003h sub 1 is {last:08X}h"))
}

/// Messages among frames.
fn messages(bench: &mut Bench<'_>, frames: Vec<Frame>, id: u16) -> Vec<SentFrame> {
    let now = bench.now;
    let mut sent: Vec<SentFrame> = frames.into_iter().map(|frame| (now, frame)).collect();
    sent.extend(bench.run(MS));
    sent.retain(|(_, frame)| frame.id() == id);
    sent
}

/// Causes an error; the messages that follow at once.
fn cause(bench: &mut Bench<'_>, id: u16) -> CheckStep<Vec<SentFrame>> {
    if sync_id(bench)? == id {
        return impossible("emergency messages have the CAN-ID of SYNC");
    }
    bench.start();
    let frames = send_wrong_sync(bench)?;
    Ok(messages(bench, frames, id))
}

/// Ends the error by a SYNC of the right length.
fn end(bench: &mut Bench<'_>, id: u16) -> CheckStep<Vec<SentFrame>> {
    let frames = send_sync(bench, 1)?;
    Ok(messages(bench, frames, id))
}

fn once(bench: &mut Bench<'_>) -> CheckStep {
    let id = can_id(bench)?;
    let first = cause(bench, id)?;
    expect_message(&first, 0x8240, 0x11)?;
    let again = cause(bench, id)?;
    ensure(again.is_empty(), || "the error is reported twice".into())?;
    bench.run(inhibit_time(bench));
    let gone = end(bench, id)?;
    expect_message(&gone, 0, 0)
}

fn register(bench: &mut Bench<'_>) -> CheckStep {
    if bench.described.needs(0x1001, 0)?.size() != Some(1) {
        return impossible("1001h does not have one byte");
    }
    // without both the application has the register
    bench.described.needs(0x1014, 0).or_else(|_| bench.described.needs(0x1003, 0))?;
    cause(bench, 0x7FF)?;
    bench.expect(0x1001, 0, &[0x11])?;
    end(bench, 0)?;
    bench.expect(0x1001, 0, &[0])
}

fn history(bench: &mut Bench<'_>) -> CheckStep {
    needs_history(bench)?;
    cause(bench, 0x7FF)?;
    bench.expect(0x1003, 0, &[1])?;
    expect_history(bench, 0x8240)?;
    end(bench, 0)?;
    cause(bench, 0x7FF)?;
    let room = bench.described.find(0x1003, 2).is_some();
    bench.expect(0x1003, 0, &[1 + u8::from(room)])
}

fn clear(bench: &mut Bench<'_>) -> CheckStep {
    needs_history(bench)?;
    bench.described.needs_writable(0x1003, 0)?;
    cause(bench, 0x7FF)?;
    bench.write(0x1003, 0, 0)?;
    bench.expect(0x1003, 0, &[0])
}

fn disable(bench: &mut Bench<'_>) -> CheckStep {
    let id = can_id(bench)?;
    bench.write(0x1014, 0, 0x8000_0000 | u64::from(id))
}

fn disabled(bench: &mut Bench<'_>) -> CheckStep {
    let id = can_id(bench)?;
    disable(bench)?;
    let sent = cause(bench, id)?;
    ensure(sent.is_empty(), || "an emergency message".into())
}

fn moved(bench: &mut Bench<'_>) -> CheckStep {
    const OTHER: u16 = 0x6D0;
    disable(bench)?;
    bench.write(0x1014, 0, u64::from(OTHER))?;
    let sent = cause(bench, OTHER)?;
    expect_message(&sent, 0x8240, 0x11)
}

fn inhibited(bench: &mut Bench<'_>) -> CheckStep {
    const TIME: u64 = 500;
    let id = can_id(bench)?;
    bench.write(0x1015, 0, TIME)?;
    let first = cause(bench, id)?;
    expect_message(&first, 0x8240, 0x11)?;
    let early = end(bench, id)?;
    ensure(early.is_empty(), || "the second message is within the inhibit time".into())?;
    let late = bench.listen(id, TIME * 100);
    expect_message(&late, 0, 0)?;
    let passed = late[0].0 - first[0].0;
    ensure(passed == TIME * 100, || format!("the second message comes after {passed} µs"))
}

fn stopped(bench: &mut Bench<'_>) -> CheckStep {
    let id = can_id(bench)?;
    bench.start();
    bench.command(STOP);
    let frames = send_wrong_sync(bench)?;
    let sent = messages(bench, frames, id);
    ensure(sent.is_empty(), || "an emergency message".into())
}

fn reset(bench: &mut Bench<'_>) -> CheckStep {
    let id = can_id(bench)?;
    cause(bench, id)?;
    bench.command(RESET_COMMUNICATION);
    if bench.described.find(0x1001, 0).is_some_and(|entry| entry.size() == Some(1)) {
        bench.expect(0x1001, 0, &[0])?;
    }
    let again = cause(bench, id)?;
    expect_message(&again, 0x8240, 0x11)
}

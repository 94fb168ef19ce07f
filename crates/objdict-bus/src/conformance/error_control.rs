//! Heartbeats, of the node and of others (CiA 301 §7.2.8.3.2, §7.5.2.19, §7.5.2.20, §7.5.2.32).

use objdict_device::Abort;

use super::bench::{Bench, MS, OPERATIONAL, PRE_OPERATIONAL, STOP, STOPPED};
use super::emergency::{expect_history, expect_message};
use super::{CheckStep, checks, ensure, impossible};

checks! { "heartbeat":
    "7.2.8.3.2" "the period of 1017h" period;
    "7.2.8.3.2" "a late heartbeat does not delay the next one" phase;
    "7.2.8.3.2" "heartbeats in stopped" |bench| { let watch = bench.start_heartbeat()?; bench.command(STOP); bench.expect_state(Some(watch), STOPPED) };
    "7.5.2.20" "1017h of 0 ends the heartbeat" off;
    "7.5.2.19" "a node is monitored from its first heartbeat on" waits;
    "7.5.2.19" "a missing heartbeat: emergency 8130h" lost;
    "7.5.2.19" "a recovered heartbeat: emergency 0000h" back;
    "7.5.2.19" "a node that is monitored twice is rejected" |bench| { monitor(bench)?; bench.refuse(0x1016, 2, MONITORED, Abort::Incompatible) };
    "7.5.2.19" "a time of 0 ends the monitoring" |bench| { lose_after(bench, |bench| bench.write(0x1016, 1, 0))?; silent(bench) };
    "7.5.2.32" "1029h sub 1 of 0: pre-operational after an error" |bench| behaviour(bench, Some(0), PRE_OPERATIONAL);
    "7.5.2.32" "1029h sub 1 of 1: no change of the state" |bench| behaviour(bench, Some(1), OPERATIONAL);
    "7.5.2.32" "1029h sub 1 of 2: stopped after an error" |bench| behaviour(bench, Some(2), STOPPED);
    "7.5.2.32" "1029h sub 1 of 2: the emergency leaves before" last_words;
    "7.5.2.32" "1029h sub 1: a reserved value is rejected" |bench| bench.refuse(0x1029, 1, 5, Abort::InvalidValue);
    "7.5.2.19" "1016h: the node itself is rejected" |bench| { let own = u64::from(bench.described.node_id) << 16 | TIME; bench.refuse(0x1016, 1, own, Abort::InvalidValue) };
}

/// The node that is monitored: another one than that of the bench.
const fn other(bench: &Bench<'_>) -> u8 {
    if bench.described.node_id == OTHER { OTHER + 1 } else { OTHER }
}
const OTHER: u8 = 0x64;

/// Another node with 200 ms, for a node with another node-ID than this one.
const MONITORED: u64 = (OTHER as u64) << 16 | TIME;
const TIME: u64 = 200;

fn period(bench: &mut Bench<'_>) -> CheckStep {
    let period = bench.start_heartbeat()?;
    bench.run(period);
    let heartbeats = bench.listen(0x700 + bench.node_id(), 5 * period);
    let times: Vec<u64> = heartbeats.iter().map(|(time, _)| *time).collect();
    let is_regular = times.windows(2).all(|pair| pair[1] - pair[0] == period);
    ensure(times.len() == 5 && is_regular, || format!("{} heartbeats within five periods", times.len()))
}

fn phase(bench: &mut Bench<'_>) -> CheckStep {
    let period = bench.start_heartbeat()?;
    let id = 0x700 + bench.node_id();
    let first = bench.listen(id, 2 * period).last().map_or(0, |(time, _)| *time);
    let wait = (first + period * 13 / 10).saturating_sub(bench.now);
    bench.sleep(wait);
    let times: Vec<u64> =
        bench.listen(id, period).iter().map(|(time, _)| (time - first) * 10 / period).collect();
    ensure(times == [13, 20], || {
        format!("heartbeats come after {times:?} tenths of the period, not after 13 and 20")
    })
}

fn off(bench: &mut Bench<'_>) -> CheckStep {
    let period = bench.start_heartbeat()?;
    bench.write(0x1017, 0, 0)?;
    let heartbeats = bench.listen(0x700 + bench.node_id(), 3 * period);
    ensure(heartbeats.is_empty(), || format!("{} heartbeats", heartbeats.len()))
}

fn monitor(bench: &mut Bench<'_>) -> CheckStep {
    if bench.described.node_id == OTHER {
        return impossible("the node has the node-ID of the one that it would monitor");
    }
    let others = bench.described.object(0x1016).filter(|entry| entry.sub > 1).map(|entry| entry.sub);
    for sub in others.collect::<Vec<u8>>() {
        if bench.described.number(0x1016, sub) >> 16 & 0x7F == u64::from(OTHER) {
            return impossible("1016h monitors this node by default");
        }
    }
    bench.write(0x1016, 1, MONITORED)
}

fn beat(bench: &mut Bench<'_>) {
    bench.send(0x700 + u16::from(other(bench)), &[OPERATIONAL]);
}

/// Monitors a node, lets it come, does something, and lets it be lost.
fn lose_after(bench: &mut Bench<'_>, then: impl FnOnce(&mut Bench<'_>) -> CheckStep) -> CheckStep {
    monitor(bench)?;
    beat(bench);
    then(bench)
}

fn silent(bench: &mut Bench<'_>) -> CheckStep {
    let id = super::emergency::can_id(bench)?;
    let messages = bench.listen(id, 3 * TIME * MS);
    ensure(messages.is_empty(), || "an emergency message".into())
}

fn waits(bench: &mut Bench<'_>) -> CheckStep {
    monitor(bench)?;
    silent(bench)
}

fn lost(bench: &mut Bench<'_>) -> CheckStep {
    lose_after(bench, |bench| {
        // in time
        bench.run((TIME - 1) * MS);
        beat(bench);
        Ok(())
    })?;
    let id = super::emergency::can_id(bench)?;
    let early = bench.listen(id, (TIME - 1) * MS);
    ensure(early.is_empty(), || "the emergency message is too early".into())?;
    let late = bench.listen(id, 2 * MS);
    expect_message(&late, 0x8130, 0x10)?;
    expect_history(bench, 0x8130)
}

fn back(bench: &mut Bench<'_>) -> CheckStep {
    lose_after(bench, |_| Ok(()))?;
    bench.run(2 * TIME * MS);
    bench.run(super::emergency::inhibit_time(bench));
    let id = super::emergency::can_id(bench)?;
    let node = 0x700 + u16::from(other(bench));
    let mut sent: Vec<_> = bench.send(node, &[OPERATIONAL]).into_iter().map(|frame| (0, frame)).collect();
    sent.retain(|(_, frame)| frame.id() == id);
    expect_message(&sent, 0, 0)
}

fn last_words(bench: &mut Bench<'_>) -> CheckStep {
    bench.write(0x1029, 1, 2)?;
    let id = super::emergency::can_id(bench)?;
    lose_after(bench, |_| Ok(()))?;
    let messages = bench.listen(id, 2 * TIME * MS);
    expect_message(&messages, 0x8130, 0x10)
}

fn behaviour(bench: &mut Bench<'_>, value: Option<u64>, expected: u8) -> CheckStep {
    if let Some(value) = value {
        bench.write(0x1029, 1, value)?;
    }
    let watch = bench.watch()?;
    lose_after(bench, |bench| {
        bench.start();
        Ok(())
    })?;
    bench.run(2 * TIME * MS);
    if watch.is_none() && expected != STOPPED {
        return impossible("without a heartbeat the state is not seen");
    }
    bench.expect_state(watch, expected)
}

//! SYNC, of the node and of others (CiA 301 §7.2.5, §7.5.2.5 to §7.5.2.7, §7.5.2.22).

use objdict_device::Abort;

use super::bench::{Bench, ENTER_PRE_OPERATIONAL, MS, STOP};
use super::emergency::{can_id, expect_history, expect_message};
use super::pdo::tpdo;
use super::sync_frame::{counts, send_wrong_sync, sync_id};
use super::{CheckStep, checks, ensure, impossible};

checks! { "SYNC":
    "7.2.5" "bit 30 of 1005h: the period of 1006h" period;
    "7.2.5" "the counter of 1019h" counter;
    "7.2.5" "no SYNC in stopped, and the counter restarts" restart;
    "7.5.2.5" "1005h: a new CAN-ID while the node sends SYNC is rejected" |bench| { produce(bench)?; bench.refuse(0x1005, 0, 0x4000_0090, Abort::InvalidValue) };
    "7.5.2.5" "1005h: bit 30 without 1006h is rejected" without_period;
    "7.3.5" "1005h: a restricted CAN-ID is rejected" |bench| bench.refuse(0x1005, 0, 0x601, Abort::InvalidValue);
    "7.5.2.5" "1005h: a CAN-ID of 29 bits is rejected" |bench| bench.refuse(0x1005, 0, 0x2000_0080, Abort::InvalidValue);
    "7.3.5" "1005h: the CAN-ID of a PDO is rejected" |bench| { let pdo = tpdo(bench, &[])?; bench.refuse(0x1005, 0, pdo.id.into(), Abort::InvalidValue) };
    "7.3.5" "a PDO: the CAN-ID of SYNC is rejected" |bench| { let id = sync_id(bench)?; let pdo = tpdo(bench, &[])?; pdo.disable(bench)?; pdo.refuse_cob_id(bench, id.into()) };
    "7.5.2.5" "1005h: a new CAN-ID" |bench| { bench.write(0x1005, 0, 0x90)?; bench.expect(0x1005, 0, &[0x90, 0, 0, 0]) };
    "7.5.2.22" "1019h of 1 is rejected" |bench| { idle(bench)?; bench.refuse(0x1019, 0, 1, Abort::InvalidValue) };
    "7.5.2.22" "1019h above 240 is rejected" |bench| { idle(bench)?; bench.refuse(0x1019, 0, 241, Abort::InvalidValue) };
    "7.5.2.22" "1019h while 1006h is not 0 is rejected" |bench| { bench.write(0x1006, 0, PERIOD)?; let other = if bench.described.number(0x1019, 0) == 10 { 11 } else { 10 }; bench.refuse(0x1019, 0, other, Abort::DeviceState) };
    "7.2.7" "a SYNC of a wrong length: emergency 8240h" wrong_length;
}

const PERIOD: u64 = 10_000;

/// Sets the period to 0, so that others may change.
fn idle(bench: &mut Bench<'_>) -> CheckStep {
    bench.described.needs(0x1019, 0)?;
    if bench.described.number(0x1006, 0) == 0 { Ok(()) } else { bench.write(0x1006, 0, 0) }
}

fn produce(bench: &mut Bench<'_>) -> CheckStep {
    bench.command(ENTER_PRE_OPERATIONAL);
    bench.write(0x1006, 0, PERIOD)?;
    let id = u64::from(sync_id(bench)?);
    bench.write(0x1005, 0, 0x4000_0000 | id)
}

fn without_period(bench: &mut Bench<'_>) -> CheckStep {
    bench.described.needs_writable(0x1005, 0)?;
    if bench.described.has_object(0x1006) {
        return impossible("there is 1006h");
    }
    let id = u64::from(sync_id(bench)?);
    bench.refuse(0x1005, 0, 0x4000_0000 | id, Abort::InvalidValue)
}

fn lengths(bench: &mut Bench<'_>, length: usize) -> CheckStep<Vec<Vec<u8>>> {
    let id = sync_id(bench)?;
    let syncs = bench.listen(id, 6 * PERIOD);
    let is_regular = syncs.windows(2).all(|pair| pair[1].0 - pair[0].0 == PERIOD);
    ensure((6..=7).contains(&syncs.len()) && is_regular, || {
        format!("{} SYNCs within six periods", syncs.len())
    })?;
    let data: Vec<Vec<u8>> = syncs.iter().map(|(_, frame)| frame.data().to_vec()).collect();
    ensure(data.iter().all(|data| data.len() == length), || {
        format!("a SYNC has another length than {length}")
    })?;
    Ok(data)
}

fn period(bench: &mut Bench<'_>) -> CheckStep {
    produce(bench)?;
    let length = usize::from(counts(bench));
    lengths(bench, length).map(drop)
}

/// Lets the node send SYNC with a counter up to 3.
fn produce_counted(bench: &mut Bench<'_>) -> CheckStep {
    idle(bench)?;
    bench.write(0x1019, 0, 3)?;
    produce(bench)
}

fn is_counted(data: &[Vec<u8>]) -> bool {
    data.windows(2).all(|pair| matches!(pair, [a, b] if a.len() == 1 && *b == [a[0] % 3 + 1]))
}

fn counter(bench: &mut Bench<'_>) -> CheckStep {
    produce_counted(bench)?;
    let data = lengths(bench, 1)?;
    ensure(is_counted(&data), || format!("the counters are {data:?}"))
}

fn restart(bench: &mut Bench<'_>) -> CheckStep {
    produce_counted(bench)?;
    bench.run(PERIOD * 3 / 2);
    bench.command(STOP);
    let id = sync_id(bench)?;
    let stopped = bench.listen(id, 5 * PERIOD);
    ensure(stopped.is_empty(), || "a stopped node sends SYNC".into())?;
    // the first one may be due at once
    let mut data: Vec<Vec<u8>> = bench
        .command(ENTER_PRE_OPERATIONAL)
        .iter()
        .filter(|frame| frame.id() == id)
        .map(|frame| frame.data().to_vec())
        .collect();
    data.extend(lengths(bench, 1)?);
    ensure(data[0] == [1] && is_counted(&data), || format!("the counters are {data:?}"))
}

fn wrong_length(bench: &mut Bench<'_>) -> CheckStep {
    bench.start();
    let id = can_id(bench)?;
    if id == sync_id(bench)? {
        return impossible("emergency messages have the CAN-ID of SYNC");
    }
    let mut sent: Vec<_> = send_wrong_sync(bench)?.into_iter().map(|frame| (0, frame)).collect();
    sent.extend(bench.run(MS));
    sent.retain(|(_, frame)| frame.id() == id);
    expect_message(&sent, 0x8240, 0x10)?;
    expect_history(bench, 0x8240)
}

//! Every entry of the description: read by each protocol, written and read back, its limits, its length, its access.

use objdict_device::Abort;

use super::bench::Bench;
use super::described::{DescribedEntries, DescribedEntry, abort_code, answer, has_rules, hex, place};
use super::{CheckStep, ConformanceCheck, ensure, failed, program, verdict};
use crate::model::TypeKind;

/// A check for each object. All are read before one is written.
pub(super) fn checks(described: &DescribedEntries, bench: &mut Bench<'_>) -> Vec<ConformanceCheck> {
    let readings = described
        .indexes()
        .into_iter()
        .map(|index| (index, described.object(index).try_for_each(|entry| check_reading(bench, entry))));
    let readings: Vec<(u16, CheckStep)> = readings.collect();
    let check = |(index, reading): (u16, CheckStep)| {
        let written = |_| described.object(index).try_for_each(|entry| check_download(bench, entry));
        ConformanceCheck {
            service: service_of(index),
            name: format!("{index:04X}h"),
            section: "7.4",
            verdict: verdict(reading.and_then(written)),
        }
    };
    readings.into_iter().map(check).collect()
}

pub(super) const fn service_of(index: u16) -> &'static str {
    match index {
        0..0x1000 => "objects below 1000h",
        0x1000..0x2000 => "objects 1000h to 1FFFh",
        0x2000..0x6000 => "objects 2000h to 5FFFh",
        _ => "objects from 6000h",
    }
}

fn check_download(bench: &mut Bench<'_>, entry: &DescribedEntry) -> CheckStep {
    if !entry.is_writable() {
        let bytes = vec![0; entry.size().unwrap_or(1)];
        return bench.refuse_bytes(entry.index, entry.sub, &bytes, Abort::ReadOnly);
    }
    check_length(bench, entry)?;
    if has_rules(entry.index) || matches!(entry.index, 0x1F00..=0x1FFF) {
        Ok(())
    } else {
        check_writing(bench, entry)
    }
}

/// The value at power-on.
fn expected(entry: &DescribedEntry) -> Vec<u8> {
    match (entry.index, entry.sub) {
        // those begin without errors
        (0x1001, _) | (0x1003, 0) => vec![0; entry.default.len()],
        _ => entry.default.clone(),
    }
}

fn check_reading(bench: &mut Bench<'_>, entry: &DescribedEntry) -> CheckStep {
    let (index, sub) = (entry.index, entry.sub);
    let values = [("", bench.upload(index, sub)), (" by blocks", bench.upload_block(index, sub))];
    let initial = of_program(bench, entry);
    let allowed = match (index, sub) {
        _ if !entry.is_readable() => Err(Abort::WriteOnly),
        (0x1003, 1..) => Err(Abort::NoData),
        _ if is_empty_domain(entry, &values[0].1) => Err(Abort::NoData),
        _ => initial.unwrap_or_else(|| Ok(expected(entry))),
    };
    for (how, value) in values {
        ensure(value == allowed, || {
            let words = |value: &Result<Vec<u8>, Abort>| {
                value.as_ref().map_or_else(|abort| abort_code(*abort), |value| hex(value))
            };
            format!("{}{how} is {}, not {}", place(index, sub), words(&value), words(&allowed))
        })?;
    }
    Ok(())
}

/// What an entry of a program has, for which there is a memory and which is not there.
fn of_program(bench: &Bench<'_>, entry: &DescribedEntry) -> Option<Result<Vec<u8>, Abort>> {
    let initial = program::initial(entry.index, entry.sub)?;
    program::is_described(bench.described).then(|| {
        initial.map(|first| {
            let mut bytes = vec![0; entry.default.len()];
            bytes[..1].copy_from_slice(&[first]);
            bytes
        })
    })
}

/// Whether a DOMAIN has no data, which the application would give.
fn is_empty_domain(entry: &DescribedEntry, value: &Result<Vec<u8>, Abort>) -> bool {
    entry.data_type.kind() == TypeKind::Domain && entry.default.is_empty() && *value == Err(Abort::NoData)
}

fn check_length(bench: &mut Bench<'_>, entry: &DescribedEntry) -> CheckStep {
    let Some(size) = entry.size() else { return Ok(()) };
    let (index, sub) = (entry.index, entry.sub);
    bench.refuse_bytes(index, sub, &vec![0; size + 1], Abort::TooLong)?;
    if size > 1 {
        bench.refuse_bytes(index, sub, &vec![0; size - 1], Abort::TooShort)?;
    }
    let result = bench.download_block(index, sub, &vec![0; size + 1]);
    ensure(result == Err(Abort::TooLong), || {
        format!("{} by blocks and too long: {}", place(index, sub), answer(&result))
    })
}

fn check_writing(bench: &mut Bench<'_>, entry: &DescribedEntry) -> CheckStep {
    let before = expected(entry);
    check_limits(bench, entry)?;
    for value in values(entry, &before) {
        let written = bench.download(entry.index, entry.sub, &value);
        if written.is_err() {
            return failed(format!(
                "writing {} to {}: {}",
                hex(&value),
                place(entry.index, entry.sub),
                answer(&written)
            ));
        }
        if entry.is_readable() {
            bench.expect(entry.index, entry.sub, &value)?;
        }
    }
    Ok(())
}

/// Values that the entry takes: its limits, another one by another protocol, and at last the one that it had.
fn values(entry: &DescribedEntry, before: &[u8]) -> Vec<Vec<u8>> {
    let limits = entry.low.into_iter().chain(entry.high).filter(|number| entry.allows(*number));
    let limits = limits.filter_map(|number| entry.bytes_of(number));
    let last = entry.allows_default().then(|| before.to_vec());
    limits.chain(entry.other_than(before)).chain(last).collect()
}

fn check_limits(bench: &mut Bench<'_>, entry: &DescribedEntry) -> CheckStep {
    let below = entry.low.and_then(|low| entry.bytes_of(low - 1));
    let above = entry.high.and_then(|high| entry.bytes_of(high + 1));
    if let Some(bytes) = below {
        bench.refuse_bytes(entry.index, entry.sub, &bytes, Abort::TooLow)?;
    }
    if let Some(bytes) = above {
        bench.refuse_bytes(entry.index, entry.sub, &bytes, Abort::TooHigh)?;
    }
    Ok(())
}

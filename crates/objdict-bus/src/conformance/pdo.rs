//! TPDOs, and the parameters of all PDOs (CiA 301 §7.2.2, §7.5.2.35, §7.5.2.37).

use objdict_device::{Abort, Frame};

use super::bench::{Bench, ENTER_PRE_OPERATIONAL, MS, STOP};
use super::described::{DescribedEntry, hex, place};
use super::sync_frame::{send_sync, sync_id};
use super::{CheckStep, absent, checks, ensure, impossible};

checks! { "TPDO":
    "7.2.2" "each event-driven TPDO once when operational, with its values" all_with_values;
    "7.2.2.2" "type 0: not at SYNC without an event" |bench| at_syncs(bench, 0, 6, 0);
    "7.2.2.2" "type 1: at each SYNC" |bench| at_syncs(bench, 1, 6, 6);
    "7.2.2.2" "type 3: at each third SYNC" |bench| at_syncs(bench, 3, 9, 3);
    "7.2.2.2" "type 240: at each 240th SYNC" |bench| at_syncs(bench, 240, 480, 2);
    "7.2.2.2" "type 254: once when operational, not at SYNC" |bench| event_driven(bench, 254);
    "7.2.2.2" "type 255: once when operational, not at SYNC" |bench| event_driven(bench, 255);
    "7.2.2" "the event timer" event_timer;
    "7.2.2" "the inhibit time" inhibit_time;
    "7.5.2.37" "the SYNC start value" sync_start;
    "7.3.2.2" "no TPDO in pre-operational" |bench| silent_in(bench, ENTER_PRE_OPERATIONAL);
    "7.3.2.2" "no TPDO in stopped" |bench| silent_in(bench, STOP);
    "7.5.2.37" "bit 31 of the COB-ID: not sent" not_valid;
    "7.5.2.37" "reserved transmission types are rejected" |bench| reserved_types(bench, TPDO);
    "7.5.2.37" "a new CAN-ID while it is valid is rejected" |bench| { let pdo = tpdo(bench, &[])?; pdo.refuse_cob_id(bench, u64::from(pdo.id) ^ 1) };
    "7.3.5" "a restricted CAN-ID is rejected" |bench| { let pdo = tpdo(bench, &[])?; pdo.disable(bench)?; pdo.refuse_cob_id(bench, 0x601) };
    "7.5.2.37" "a CAN-ID of 29 bits is rejected" |bench| { let pdo = tpdo(bench, &[])?; pdo.disable(bench)?; pdo.refuse_cob_id(bench, 0x2000_0181) };
    "7.5.2.37" "an inhibit time while it is valid is rejected" |bench| { let pdo = tpdo(bench, &[(3, 10)])?; bench.refuse(pdo.communication, 3, 11, Abort::InvalidValue) };
    "7.5.2.37" "a SYNC start value while it is valid is rejected" |bench| { let pdo = tpdo(bench, &[(6, 1)])?; bench.refuse(pdo.communication, 6, 2, Abort::InvalidValue) };
}

/// A kind of PDOs.
#[derive(Clone, Copy)]
pub(super) struct PdoDirection {
    name: &'static str,
    /// The index of the first communication parameters.
    first: u16,
    /// The CAN-ID that the checks give a PDO.
    id: u16,
    /// Its place in [`DescribedEntry::fits`].
    direction: usize,
}

pub(super) const RPDO: PdoDirection = PdoDirection { name: "RPDO", first: 0x1400, id: 0x6C2, direction: 0 };
pub(super) const TPDO: PdoDirection = PdoDirection { name: "TPDO", first: 0x1800, id: 0x6C1, direction: 1 };

/// Index, sub-index and length in bits of a mapped entry.
pub(super) type MappedTarget = (u16, u8, u8);

/// A PDO that the checks have set up and made valid.
pub(super) struct CheckedPdo {
    pub(super) communication: u16,
    pub(super) id: u16,
    pub(super) mapped: Vec<MappedTarget>,
}

/// The bits of a COB-ID.
const NOT_VALID: u64 = 1 << 31;
const NO_REMOTE: u64 = 1 << 30;
const EXTENDED: u64 = 1 << 29;

impl CheckedPdo {
    pub(super) fn mapping(&self) -> u16 {
        self.communication | 0x200
    }

    /// The part of the COB-ID that is no CAN-ID.
    fn bit_30(&self, bench: &Bench<'_>) -> u64 {
        bench.described.number(self.communication, 1) & NO_REMOTE
    }

    pub(super) fn disable(&self, bench: &mut Bench<'_>) -> CheckStep {
        let bits = self.bit_30(bench);
        bench.write(self.communication, 1, NOT_VALID | bits | u64::from(self.id))
    }

    pub(super) fn enable(&self, bench: &mut Bench<'_>) -> CheckStep {
        let bits = self.bit_30(bench);
        bench.write(self.communication, 1, bits | u64::from(self.id))
    }

    pub(super) fn refuse_cob_id(&self, bench: &mut Bench<'_>, cob_id: u64) -> CheckStep {
        bench.refuse(self.communication, 1, self.bit_30(bench) | cob_id, Abort::InvalidValue)
    }

    /// The frame that the present values make.
    pub(super) fn packed(&self, bench: &mut Bench<'_>) -> CheckStep<Vec<u8>> {
        let (mut frame, mut length) = (0_u64, 0_u32);
        for &(index, sub, bits) in &self.mapped {
            let value = if index < 8 { 0 } else { bench.number(index, sub)? };
            let mask = u64::MAX >> (64 - u32::from(bits));
            frame |= (value & mask) << length;
            length += u32::from(bits);
        }
        Ok(frame.to_le_bytes()[..length.div_ceil(8) as usize].to_vec())
    }

    fn among(&self, frames: &[Frame]) -> usize {
        frames.iter().filter(|frame| frame.id() == self.id).count()
    }
}

/// The communication parameters of all PDOs of a kind.
pub(super) fn all(bench: &Bench<'_>, kind: PdoDirection) -> Vec<u16> {
    let range = kind.first..=kind.first + 0x1FF;
    let entries =
        bench.described.entries.iter().filter(|entry| entry.sub == 1 && range.contains(&entry.index));
    entries.map(|entry| entry.index).collect()
}

/// The mapping that the description has.
pub(super) fn default_mapping(bench: &Bench<'_>, communication: u16) -> Vec<MappedTarget> {
    let mapping = communication | 0x200;
    let count = bench.described.number(mapping, 0).min(64) as u8;
    let entries = (1..=count).map(|sub| bench.described.number(mapping, sub));
    entries.map(|entry| ((entry >> 16) as u16, (entry >> 8) as u8, entry as u8)).collect()
}

/// Whether a mapping is one that the node can have, and that the checks can follow.
fn is_usable(bench: &Bench<'_>, mapped: &[MappedTarget], kind: PdoDirection) -> bool {
    let bits: u32 = mapped.iter().map(|mapped| u32::from(mapped.2)).sum();
    let is_known = |&(index, sub, bits): &MappedTarget| {
        let is_dummy = kind.direction == 0 && (1..8).contains(&index) && bits > 0;
        is_dummy || bench.described.find(index, sub).is_some_and(|entry| fits(entry, bits, kind))
    };
    let is_seen = |&(index, sub, _): &MappedTarget| kind.direction == 1 || is_observable(bench, index, sub);
    (1..=64).contains(&bits) && mapped.iter().all(is_known) && mapped.iter().any(is_seen)
}

/// Whether an entry has this length and the access that the direction needs.
fn fits(entry: &DescribedEntry, bits: u8, kind: PdoDirection) -> bool {
    let has_length = entry.size().is_some_and(|size| usize::from(bits) == 8 * size)
        || (entry.size() == Some(1) && bits == 1 && !entry.is_integer());
    has_length && if kind.direction == 1 { entry.is_readable() } else { entry.is_writable() }
}

/// Whether a master sees that an entry was written.
pub(super) fn is_observable(bench: &Bench<'_>, index: u16, sub: u8) -> bool {
    bench.described.find(index, sub).is_some_and(|entry| {
        entry.is_readable()
            && entry.is_writable()
            && entry.is_integer()
            && entry.other_than(&entry.default).is_some()
    })
}

/// An entry that can be mapped.
pub(super) fn mappable(bench: &Bench<'_>, kind: PdoDirection) -> CheckStep<MappedTarget> {
    let bits = |entry: &DescribedEntry| entry.size().map_or(0, |size| (8 * size).min(255) as u8);
    let is_meant = |entry: &&DescribedEntry| {
        let is_seen = kind.direction == 1 || is_observable(bench, entry.index, entry.sub);
        entry.is_integer() && entry.fits[kind.direction] && fits(entry, bits(entry), kind) && is_seen
    };
    match bench.described.entries.iter().find(is_meant) {
        Some(entry) => Ok((entry.index, entry.sub, bits(entry))),
        None => absent(format!("a mappable entry for {}s", kind.name)),
    }
}

/// The first TPDO with these parameters, valid and in pre-operational.
pub(super) fn tpdo(bench: &mut Bench<'_>, settings: &[(u8, u64)]) -> CheckStep<CheckedPdo> {
    set_up(bench, TPDO, settings)
}

/// The first PDO that the description lets have these parameters (sub-index, value), valid and in pre-operational.
pub(super) fn set_up(
    bench: &mut Bench<'_>,
    kind: PdoDirection,
    settings: &[(u8, u64)],
) -> CheckStep<CheckedPdo> {
    bench.command(ENTER_PRE_OPERATIONAL);
    let mut reason = None;
    for communication in all(bench, kind) {
        match plan(bench, kind, communication, settings) {
            Ok((pdo, mapping)) => return make(bench, pdo, settings, mapping),
            Err(why) => reason = reason.or(Some(why)),
        }
    }
    Err(reason.unwrap_or_else(|| super::Verdict::Absent(kind.name.to_owned())))
}

/// The PDO, and the entry to map if the mapping of the description is none that can be followed.
fn plan(
    bench: &Bench<'_>,
    kind: PdoDirection,
    communication: u16,
    settings: &[(u8, u64)],
) -> CheckStep<(CheckedPdo, Option<MappedTarget>)> {
    let described = bench.described;
    let cob_id = described.number(communication, 1);
    if described.needs(communication, 1)?.size() != Some(4) {
        return impossible(format!("{} is no COB-ID of four bytes", place(communication, 1)));
    }
    let can_change = described.needs_writable(communication, 1).map(drop);
    if cob_id & EXTENDED != 0 {
        return impossible(format!("{} has a CAN-ID of 29 bits", place(communication, 1)));
    }
    for &(sub, value) in settings {
        described.needs(communication, sub)?;
        if described.number(communication, sub) != value {
            described.needs_writable(communication, sub)?;
            if matches!(sub, 3 | 6) {
                can_change.clone()?;
            }
        }
    }
    if cob_id & NOT_VALID != 0 {
        can_change.clone()?;
    }
    let id = if can_change.is_ok() { kind.id } else { (cob_id & 0x7FF) as u16 };
    let mapped = default_mapping(bench, communication);
    if is_usable(bench, &mapped, kind) {
        return Ok((CheckedPdo { communication, id, mapped }, None));
    }
    for sub in 0..=1 {
        described.needs_writable(communication | 0x200, sub)?;
    }
    can_change?;
    let entry = mappable(bench, kind)?;
    Ok((CheckedPdo { communication, id, mapped: vec![entry] }, Some(entry)))
}

fn make(
    bench: &mut Bench<'_>,
    pdo: CheckedPdo,
    settings: &[(u8, u64)],
    mapping: Option<MappedTarget>,
) -> CheckStep<CheckedPdo> {
    let communication = pdo.communication;
    let can_change = bench.described.needs_writable(communication, 1).is_ok();
    if can_change {
        let cob_id = bench.described.number(communication, 1);
        bench.write(communication, 1, cob_id | NOT_VALID)?;
    }
    for &(sub, value) in settings {
        if bench.described.number(communication, sub) != value {
            bench.write(communication, sub, value)?;
        }
    }
    if let Some(entry) = mapping {
        map(bench, pdo.mapping(), &[entry])?;
    }
    if can_change {
        pdo.enable(bench)?;
    }
    Ok(pdo)
}

/// The number of a mapping entry.
pub(super) fn mapping_of((index, sub, bits): MappedTarget) -> u64 {
    u64::from(index) << 16 | u64::from(sub) << 8 | u64::from(bits)
}

/// Maps entries to a PDO that is not valid.
pub(super) fn map(bench: &mut Bench<'_>, mapping: u16, mapped: &[MappedTarget]) -> CheckStep {
    bench.write(mapping, 0, 0)?;
    for (sub, entry) in (1..).zip(mapped) {
        bench.write(mapping, sub, mapping_of(*entry))?;
    }
    bench.write(mapping, 0, mapped.len() as u64)
}

fn all_with_values(bench: &mut Bench<'_>) -> CheckStep {
    let mut count = 0;
    bench.command(ENTER_PRE_OPERATIONAL);
    let mut expected = Vec::new();
    for communication in all(bench, TPDO) {
        let cob_id = bench.described.number(communication, 1);
        let mapped = default_mapping(bench, communication);
        // without a transmission type it is 255
        let is_event_driven = match bench.described.find(communication, 2) {
            Some(_) => bench.described.number(communication, 2) >= 254,
            None => true,
        };
        if cob_id & (NOT_VALID | EXTENDED) == 0 && is_event_driven && is_usable(bench, &mapped, TPDO) {
            let pdo = CheckedPdo { communication, id: (cob_id & 0x7FF) as u16, mapped };
            let data = pdo.packed(bench)?;
            expected.push((pdo, data));
        }
    }
    let mut sent = bench.start();
    sent.extend(bench.run(MS).into_iter().map(|(_, frame)| frame));
    for (pdo, data) in &expected {
        let is_sent = sent.iter().any(|frame| frame.id() == pdo.id && frame.data() == data);
        ensure(is_sent, || format!("{:04X}h does not send {}", pdo.communication, hex(data)))?;
        count += 1;
    }
    if count == 0 { absent("an event-driven TPDO that is valid by default") } else { Ok(()) }
}

/// Sends SYNCs to an operational node, and counts the frames.
fn at_syncs(bench: &mut Bench<'_>, transmission_type: u64, syncs: u64, expected: usize) -> CheckStep {
    let pdo = tpdo(bench, &[(2, transmission_type)])?;
    let sent = bench.start();
    ensure(pdo.among(&sent) == 0, || "it is sent without a SYNC".into())?;
    let mut count = 0;
    for sync in 0..syncs {
        let frames = send_sync(bench, (sync % 240 + 1) as u8)?;
        count += pdo.among(&frames);
        let is_due = transmission_type != 0 && (sync + 1) % transmission_type == 0;
        ensure((pdo.among(&frames) == 1) == is_due, || {
            format!("after SYNC {}: {} frames", sync + 1, pdo.among(&frames))
        })?;
    }
    ensure(count == expected, || format!("{count} frames after {syncs} SYNCs, not {expected}"))
}

fn event_driven(bench: &mut Bench<'_>, transmission_type: u64) -> CheckStep {
    let pdo = tpdo(bench, &[(2, transmission_type)])?;
    let timer = bench.described.number(pdo.communication, 5);
    let data = pdo.packed(bench)?;
    let mut sent = bench.start();
    for _ in 0..3 {
        sent.extend(send_sync(bench, 1)?);
    }
    let of_pdo: Vec<&Frame> = sent.iter().filter(|frame| frame.id() == pdo.id).collect();
    ensure(of_pdo.len() == 1 || (timer > 0 && !of_pdo.is_empty()), || format!("{} frames", of_pdo.len()))?;
    ensure(of_pdo[0].data() == data, || format!("it has {}, not {}", hex(of_pdo[0].data()), hex(&data)))
}

/// The times between the frames of an operational node.
fn spaces(bench: &mut Bench<'_>, pdo: &CheckedPdo, time: u64) -> Vec<u64> {
    let begun = bench.start().iter().any(|frame| frame.id() == pdo.id).then_some(bench.now);
    let sent = bench.listen(pdo.id, time);
    let times: Vec<u64> = begun.into_iter().chain(sent.iter().map(|(time, _)| *time)).collect();
    times.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

fn event_timer(bench: &mut Bench<'_>) -> CheckStep {
    let pdo = tpdo(bench, &[(2, 255), (5, 20)]).or_else(|_| tpdo(bench, &[(2, 254), (5, 20)]))?;
    let inhibited = bench.described.number(pdo.communication, 3).min(0xFFFF) * 100;
    let space = inhibited.max(20 * MS);
    let spaces = spaces(bench, &pdo, 5 * space);
    ensure(spaces == [space; 5], || format!("frames come after {spaces:?} µs"))
}

fn inhibit_time(bench: &mut Bench<'_>) -> CheckStep {
    let pdo = tpdo(bench, &[(2, 255), (5, 10), (3, 500)])
        .or_else(|_| tpdo(bench, &[(2, 254), (5, 10), (3, 500)]))?;
    let spaces = spaces(bench, &pdo, 250 * MS);
    ensure(spaces == [50 * MS; 5], || format!("frames come after {spaces:?} µs"))
}

fn sync_start(bench: &mut Bench<'_>) -> CheckStep {
    let pdo = tpdo(bench, &[(2, 2), (6, 3)])?;
    bench.described.needs(0x1019, 0)?;
    if bench.described.number(0x1019, 0) == 0 {
        if bench.described.number(0x1006, 0) != 0 {
            bench.write(0x1006, 0, 0)?;
        }
        bench.write(0x1019, 0, 10)?;
    }
    bench.start();
    let id = sync_id(bench)?;
    let counts: Vec<usize> = (1..=8).map(|counter| pdo.among(&bench.send(id, &[counter]))).collect();
    ensure(counts == [0, 0, 0, 1, 0, 1, 0, 1], || format!("frames at SYNC 1 to 8: {counts:?}"))
}

/// The frames at four SYNCs.
fn count_at_syncs(bench: &mut Bench<'_>, pdo: &CheckedPdo) -> CheckStep<usize> {
    (1..=4).try_fold(0, |count, counter| Ok(count + pdo.among(&send_sync(bench, counter)?)))
}

fn silent_in(bench: &mut Bench<'_>, command: u8) -> CheckStep {
    let pdo = tpdo(bench, &[(2, 1)])?;
    bench.start();
    bench.command(command);
    let count = count_at_syncs(bench, &pdo)?;
    ensure(count == 0, || format!("{count} frames"))
}

fn not_valid(bench: &mut Bench<'_>) -> CheckStep {
    let pdo = tpdo(bench, &[(2, 1)])?;
    bench.start();
    pdo.disable(bench)?;
    let count = count_at_syncs(bench, &pdo)?;
    ensure(count == 0, || format!("{count} frames"))
}

/// 241 to 251 are reserved; 252 and 253 are for remote frames.
pub(super) fn reserved_types(bench: &mut Bench<'_>, kind: PdoDirection) -> CheckStep {
    let pdo = set_up(bench, kind, &[])?;
    for transmission_type in 241..=253 {
        bench.refuse(pdo.communication, 2, transmission_type, Abort::InvalidValue)?;
    }
    Ok(())
}

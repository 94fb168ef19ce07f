//! Services that the node does not have: those of objects that the generator notes, and others.

use std::ops::RangeInclusive;

use objdict_device::Abort;
use objdict_generate::{UNSERVED, Unserved};

use super::bench::Bench;
use super::described::{DescribedEntries, DescribedEntry};
use super::{CheckStep, ConformanceCheck, Verdict, absent, checks, impossible, verdict};
use crate::model::CobId;

const SERVICE: &str = "not served";

checks! { SERVICE:
    "7.2.3" "MPDO" mpdo;
    "7.2.2" "PDO requests by remote frames" remote;
    "7.3.3" "CAN-IDs of 29 bits" extended;
    "CiA 302-3" "programs after the first one" further_programs;
    "7.5.2.7" "1007h: a window is rejected" |bench| refused(bench, 0x1007, 0, 1000);
    "7.5.2.11" "100Ch: a guard time is rejected" |bench| refused(bench, 0x100C, 0, 100);
    "7.5.2.12" "100Dh: a life time factor is rejected" |bench| refused(bench, 0x100D, 0, 3);
    "7.5.2.31" "1028h: an emergency consumer is rejected" |bench| refused(bench, 0x1028, 1, 0x83);
    "7.5.2.34" "1280h: an SDO client is rejected" |bench| refused(bench, 0x1280, 1, 0x603);
    "CiA 302-2" "1F80h: an NMT master is rejected" |bench| refused(bench, 0x1F80, 0, 1);
    "7.5.2.37" "1800h sub 1: remote frames are rejected" remote_frames;
}

/// A value that would switch a service on is refused, unless the description has it.
pub(super) fn refused(bench: &mut Bench<'_>, index: u16, sub: u8, number: u64) -> CheckStep {
    if bench.described.number(index, sub) == number {
        return impossible(format!("{index:04X}h is {number:X}h already"));
    }
    bench.refuse(index, sub, number, Abort::InvalidValue)
}

fn remote_frames(bench: &mut Bench<'_>) -> CheckStep {
    let cob_id = bench.described.number(0x1800, 1);
    refused(bench, 0x1800, 1, cob_id & !u64::from(CobId::BIT_30))
}

fn not_served_if(has: bool, what: &str) -> CheckStep {
    if has { Err(Verdict::NotServed) } else { absent(what) }
}

/// A check for each service whose objects the node does not serve.
pub(super) fn of_objects(described: &DescribedEntries) -> impl Iterator<Item = ConformanceCheck> {
    UNSERVED.iter().filter_map(|Unserved { indexes, service, .. }| {
        let (name, section) = (*service)?;
        let has = described.entries.iter().any(|entry| indexes.contains(&entry.index));
        let verdict = verdict(not_served_if(has, &format!("{:04X}h", indexes.start())));
        Some(ConformanceCheck { service: SERVICE, name: name.to_owned(), section, verdict })
    })
}

/// Defaults of the entries with this sub-index in a range of objects.
fn defaults(bench: &Bench<'_>, indexes: RangeInclusive<u16>, sub: u8) -> impl Iterator<Item = u64> {
    let described = bench.described;
    let is_meant = move |entry: &&DescribedEntry| entry.sub == sub && indexes.contains(&entry.index);
    let entries = described.entries.iter().filter(is_meant);
    entries.map(|entry| described.number(entry.index, entry.sub))
}

fn mpdo(bench: &mut Bench<'_>) -> CheckStep {
    let has = [0x1600..=0x17FF, 0x1A00..=0x1BFF]
        .into_iter()
        .any(|mappings| defaults(bench, mappings, 0).any(|count| count >= 254));
    not_served_if(has, "an MPDO")
}

fn further_programs(bench: &mut Bench<'_>) -> CheckStep {
    let has = bench.described.object(0x1F50).any(|entry| entry.sub > 1);
    not_served_if(has, "a second program")
}

fn remote(bench: &mut Bench<'_>) -> CheckStep {
    let has = defaults(bench, 0x1800..=0x19FF, 2).any(|kind| matches!(kind, 252 | 253));
    not_served_if(has, "a PDO with transmission type 252 or 253")
}

fn extended(bench: &mut Bench<'_>) -> CheckStep {
    let cob_ids = [(0x1005..=0x1005, 0), (0x1014..=0x1014, 0), (0x1400..=0x15FF, 1), (0x1800..=0x19FF, 1)];
    let has = cob_ids
        .into_iter()
        .any(|(indexes, sub)| defaults(bench, indexes, sub).any(|cob_id| cob_id >> 29 & 1 == 1));
    not_served_if(has, "a CAN-ID of 29 bits")
}

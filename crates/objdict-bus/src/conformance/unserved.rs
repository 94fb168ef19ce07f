//! Services that the node does not have: docs/runtime.md lists them.

use super::bench::Bench;
use super::{Step, Verdict, absent, checks};

checks! { "not served":
    "7.2.8.3.2" "node guarding" |bench| object(bench, 0x100C..=0x100D);
    "7.2.6" "TIME" |bench| object(bench, 0x1012..=0x1013);
    "7.5.2.7" "SYNC window" |bench| object(bench, 0x1007..=0x1007);
    "7.5.2.31" "emergency consumer" |bench| object(bench, 0x1028..=0x1028);
    "7.5.2.34" "SDO client" |bench| object(bench, 0x1280..=0x12FF);
    "7.2.3" "MPDO" mpdo;
    "7.2.2" "PDO requests by remote frames" remote;
    "7.3.3" "CAN-IDs of 29 bits" extended;
    "7.5.2.23" "date and time of the configuration" |bench| object(bench, 0x1020..=0x1020);
    "CiA 302-3" "programs" |bench| object(bench, 0x1F50..=0x1F57);
    "CiA 302-2" "NMT master" |bench| object(bench, 0x1F81..=0x1F8F);
}

fn not_served_if(has: bool, what: &str) -> Step {
    if has { Err(Verdict::NotServed) } else { absent(what) }
}

fn object(bench: &mut Bench<'_>, indexes: std::ops::RangeInclusive<u16>) -> Step {
    let has = bench.described.entries.iter().any(|entry| indexes.contains(&entry.index));
    not_served_if(has, &format!("{:04X}h", indexes.start()))
}

/// Defaults of the entries with this sub-index in a range of objects.
fn defaults(
    bench: &Bench<'_>,
    indexes: [std::ops::RangeInclusive<u16>; 2],
    sub: u8,
) -> impl Iterator<Item = u64> {
    let described = bench.described;
    let entries = described
        .entries
        .iter()
        .filter(move |entry| entry.sub == sub && indexes.iter().any(|range| range.contains(&entry.index)));
    entries.map(|entry| described.number(entry.index, entry.sub))
}

fn mpdo(bench: &mut Bench<'_>) -> Step {
    let has = defaults(bench, [0x1600..=0x17FF, 0x1A00..=0x1BFF], 0).any(|count| count >= 254);
    not_served_if(has, "an MPDO")
}

fn remote(bench: &mut Bench<'_>) -> Step {
    let has = defaults(bench, [0x1800..=0x19FF, 0x1800..=0x19FF], 2).any(|kind| matches!(kind, 252 | 253));
    not_served_if(has, "a PDO with transmission type 252 or 253")
}

fn extended(bench: &mut Bench<'_>) -> Step {
    let mut all = defaults(bench, [0x1400..=0x15FF, 0x1800..=0x19FF], 1).chain(defaults(
        bench,
        [0x1005..=0x1005, 0x1014..=0x1014],
        0,
    ));
    let has = all.any(|cob_id| cob_id >> 29 & 1 == 1);
    not_served_if(has, "a CAN-ID of 29 bits")
}

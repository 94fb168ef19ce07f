//! Values that resets give back and that 1010h and 1011h store and restore (CiA 301 §7.3.2.2.1, §7.5.2.13, §7.5.2.14).

use objdict_device::Abort;

use super::bench::{Bench, RESET_COMMUNICATION, RESET_NODE};
use super::described::{DescribedEntry, hex, place};
use super::{CheckRun, CheckStep, ServiceCheck, absent, checks, ensure, impossible};

checks! { "storage":
    "7.3.2.2.1" "reset node restores the values of 2000h to 9FFFh" |bench| reset(bench, RESET_NODE, true, true);
    "7.3.2.2.1" "reset node restores the values of 1000h to 1FFFh" |bench| reset(bench, RESET_NODE, false, true);
    "7.3.2.2.1" "reset communication restores the values of 1000h to 1FFFh" |bench| reset(bench, RESET_COMMUNICATION, false, true);
    "7.3.2.2.1" "reset communication keeps the values of 2000h to 9FFFh" |bench| reset(bench, RESET_COMMUNICATION, true, false);
    "7.5.2.13" "1010h: a wrong signature is rejected" |bench| bench.refuse(0x1010, 1, u64::from(u32::from_le_bytes(*b"load")), Abort::CannotStore);
    "7.5.2.14" "1011h: a wrong signature is rejected" |bench| bench.refuse(0x1011, 1, u64::from(u32::from_le_bytes(*b"save")), Abort::CannotStore);
    "7.5.2.13" "1010h: stored values survive a reset" |bench| store(bench, true);
    "7.5.2.14" "1011h: the defaults apply after a reset" restore;
    "7.5.2.23" "1020h: cleared when a different value changes" |bench| configure(bench, true);
    "7.5.2.23" "1020h: kept when a value is written again" |bench| configure(bench, false);
}

/// Of a build with storage groups.
pub(super) const OF_GROUPS: &[ServiceCheck] = &[ServiceCheck {
    service: "storage",
    name: "1010h: values outside the groups are not stored",
    section: "7.5.2.13",
    remote: &[],
    run: CheckRun::Function(|bench| store(bench, false)),
}];

/// The signatures as numbers.
const SAVE: u64 = u32::from_le_bytes(*b"save") as u64;
const LOAD: u64 = u32::from_le_bytes(*b"load") as u64;

/// Index and sub-index of an entry, its default, and another value that it takes.
type Changeable = (u16, u8, Vec<u8>, Vec<u8>);

/// The first entry of the application, or of CiA 301, that takes another value than its default.
fn changeable(bench: &Bench<'_>, is_application: bool) -> CheckStep<Changeable> {
    changeable_that(bench, is_application, |_| true)
}

/// The same of those that are stored, or are not; of the application if there is one.
fn storable(bench: &Bench<'_>, is_kept: bool) -> CheckStep<Changeable> {
    let of = |is_application| changeable_that(bench, is_application, |entry| entry.is_kept == is_kept);
    of(true).or_else(|_| of(false))
}

fn changeable_that(
    bench: &Bench<'_>,
    is_application: bool,
    is_wanted: impl Fn(&DescribedEntry) -> bool,
) -> CheckStep<Changeable> {
    let is_meant = |entry: &&DescribedEntry| {
        let is_in_range = (entry.index >= 0x2000) == is_application && entry.index < 0xA000;
        let is_value = entry.is_readable() && entry.is_writable() && entry.is_integer();
        is_in_range
            && is_value
            && !super::described::has_rules(entry.index)
            && !is_beyond(entry)
            && entry.allows_default()
            && is_wanted(entry)
    };
    let mut found = bench.described.entries.iter().filter(is_meant).filter_map(|entry| {
        let other = entry.other_than(&entry.default)?;
        Some((entry.index, entry.sub, entry.default.clone(), other))
    });
    found.next().map_or_else(|| absent("an entry that can be changed"), Ok)
}

/// Whether the objects of CiA 302, which other rules are about.
const fn is_beyond(entry: &DescribedEntry) -> bool {
    matches!(entry.index, 0x1F00..=0x1FFF)
}

fn write(bench: &mut Bench<'_>, index: u16, sub: u8, value: &[u8]) -> CheckStep {
    let written = bench.download(index, sub, value);
    ensure(written.is_ok(), || {
        format!("writing {} to {}: {}", hex(value), place(index, sub), super::described::answer(&written))
    })
}

fn reset(bench: &mut Bench<'_>, command: u8, is_application: bool, gives_back: bool) -> CheckStep {
    let (index, sub, default, other) = changeable(bench, is_application)?;
    write(bench, index, sub, &other)?;
    bench.command(command);
    bench.expect(index, sub, if gives_back { &default } else { &other })
}

/// Whether 1010h or 1011h can do something on command.
fn needs_storage(bench: &mut Bench<'_>, index: u16) -> CheckStep {
    bench.described.needs_writable(index, 1)?;
    let ability = bench.number(index, 1)?;
    let is_meant = index == 0x1011 || ability & 1 == 1;
    if is_meant {
        Ok(())
    } else {
        impossible(format!("{} is {ability}: the device does not store on command", place(index, 1)))
    }
}

fn store(bench: &mut Bench<'_>, is_kept: bool) -> CheckStep {
    needs_storage(bench, 0x1010)?;
    let (index, sub, default, other) = storable(bench, is_kept)?;
    write(bench, index, sub, &other)?;
    bench.write(0x1010, 1, SAVE)?;
    write(bench, index, sub, &default)?;
    bench.command(RESET_NODE);
    bench.expect(index, sub, if is_kept { &other } else { &default })
}

fn restore(bench: &mut Bench<'_>) -> CheckStep {
    needs_storage(bench, 0x1011)?;
    needs_storage(bench, 0x1010)?;
    let (index, sub, default, other) = storable(bench, true)?;
    write(bench, index, sub, &other)?;
    bench.write(0x1010, 1, SAVE)?;
    bench.write(0x1011, 1, LOAD)?;
    bench.expect(index, sub, &other)?;
    bench.command(RESET_NODE);
    bench.expect(index, sub, &default)
}

fn configure(bench: &mut Bench<'_>, changes: bool) -> CheckStep {
    let (index, sub, default, other) = changeable(bench, true).or_else(|_| changeable(bench, false))?;
    for sub in 1..=2 {
        bench.write(0x1020, sub, 0x4321)?;
    }
    write(bench, index, sub, if changes { &other } else { &default })?;
    let kept = if changes { [0; 4] } else { [0x21, 0x43, 0, 0] };
    (1..=2).try_for_each(|sub| bench.expect(0x1020, sub, &kept))
}

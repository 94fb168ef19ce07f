//! The order in which a node accepts its configuration.
//!
//! A service with an identifier is disabled using its present identifier, changed, and enabled again.
//! Application objects precede the PDOs that map them. The verify configuration follows all writes that clear
//! it, and storing is last.

pub(super) mod dcfgen;
mod pdo;

use std::collections::BTreeSet;

use super::settings::{EntryKey, WritableEntries};
use super::{Download, Step};

/// Stages of a configuration, in order of transmission.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Stage {
    /// Disable services that must not run while they are changed.
    SwitchOff,
    /// Communication parameters (1000h-1FFFh).
    Communication,
    /// Application objects, from 2000h on.
    Application,
    Pdo,
    /// Start SYNC after the PDOs that use it are configured.
    StartSync,
    /// Requested commands.
    Command,
    /// Verify configuration (1020h): any later write would clear it.
    Verify,
    /// Store (1010h) and restore (1011h).
    Store,
}

/// `1005h`: the device generates SYNC.
const PRODUCES_SYNC: u32 = 1 << 30;

/// `1012h`: the device consumes and produces TIME.
const USES_TIME: u32 = 0b11 << 30;

/// Bit 31 of the COB-ID of a PDO, an SDO or EMCY: not valid.
const INVALID: u32 = 1 << 31;

/// The identifier bits, which may change only while the object is disabled.
const IDENTIFIER: u32 = 0x3FFF_FFFF;

/// Returns the steps that write every wanted entry.
pub(super) fn arrange(settings: &mut WritableEntries<'_>) -> Vec<Step> {
    let mut wanted = settings.wanted();
    wanted.sort_by_key(|key| group(key.0));
    let groups = wanted.iter().map(|key| group(key.0));
    let mut pdos: Vec<u16> =
        groups.filter(|(stage, _)| *stage == Stage::Pdo).map(|(_, communication)| communication).collect();
    pdos.dedup();
    let mut arranger = Arranger { settings, steps: Vec::new() };
    let start_sync = if pdos.is_empty() { Stage::Communication } else { Stage::StartSync };
    for keys in wanted.chunk_by(|a, b| group(a.0) == group(b.0)) {
        let (stage, first) = group(keys[0].0);
        match first {
            0x1005 => arranger.sync(start_sync),
            0x100C => arranger.error_control(),
            0x1012 => arranger.identifiers(keys, |id| id & !USES_TIME),
            0x1014 | 0x1028 => arranger.identifiers(keys, |id| id | INVALID),
            0x1016 => arranger.heartbeat_consumers(keys),
            0x1200..=0x12FF => arranger.sdo(keys),
            0x1301 => arranger.srdos(keys),
            _ if stage == Stage::Pdo => {}
            _ => keys.iter().for_each(|&key| arranger.write(stage, key)),
        }
    }
    arranger.pdos(&pdos);
    let mut steps = arranger.steps;
    steps.sort_by_key(|(stage, _)| *stage);
    steps.into_iter().map(|(_, step)| step).collect()
}

/// Groups objects that must be changed together: their stage and the first index of the group.
const fn group(index: u16) -> (Stage, u16) {
    match index {
        0x1005 | 0x1006 | 0x1019 => (Stage::Communication, 0x1005),
        0x100C | 0x100D | 0x1017 => (Stage::Communication, 0x100C),
        0x1010 | 0x1011 => (Stage::Store, index),
        0x1020 => (Stage::Verify, index),
        0x1301..=0x13FF => (Stage::Communication, 0x1301),
        0x1400..=0x1BFF => (Stage::Pdo, index & !0x0200),
        0x1023..=0x1026 | 0x1F25 | 0x1F50 | 0x1F51 | 0x1F82 | 0x1F83 => (Stage::Command, index),
        0x0000..=0x1FFF => (Stage::Communication, index),
        0x2000..=0xFFFF => (Stage::Application, index),
    }
}

struct Arranger<'s, 'a> {
    settings: &'s mut WritableEntries<'a>,
    steps: Vec<(Stage, Step)>,
}

impl Arranger<'_, '_> {
    /// Writes these bytes.
    fn put(&mut self, stage: Stage, (index, sub): EntryKey, data: impl Into<Vec<u8>>) {
        self.steps.push((stage, Step::Write(Download::new(index, sub, data))));
    }

    /// Writes a 32-bit number.
    fn put_number(&mut self, stage: Stage, key: EntryKey, number: u32) {
        self.put(stage, key, number.to_le_bytes());
    }

    /// Writes the target value of the entry, if it has one.
    fn write(&mut self, stage: Stage, key: EntryKey) {
        self.steps.extend(self.settings.step(key).map(|step| (stage, step)));
    }

    /// 1005h, 1006h, 1019h: the identifier may change only while the node does not generate SYNC, the counter
    /// overflow only while the period is 0.
    fn sync(&mut self, start: Stage) {
        const COB_ID: EntryKey = (0x1005, 0);
        const PERIOD: EntryKey = (0x1006, 0);
        const OVERFLOW: EntryKey = (0x1019, 0);
        let overflow = self.settings.wants(OVERFLOW);
        if overflow && self.settings.can_write(PERIOD) {
            self.put_number(Stage::SwitchOff, PERIOD, 0);
        }
        let cob_id = if self.settings.wants(COB_ID) { self.settings.target_number(COB_ID) } else { None };
        if let Some(new) = cob_id {
            let old = self.settings.default_number(COB_ID).unwrap_or(new);
            let idle = old & !PRODUCES_SYNC;
            let renamed = (old ^ new) & IDENTIFIER != 0;
            let off = renamed || self.settings.writes_all();
            if off {
                self.put_number(Stage::Communication, COB_ID, idle);
            }
            let new_idle = new & !PRODUCES_SYNC;
            if new_idle != idle || !off && new == new_idle {
                self.put_number(Stage::Communication, COB_ID, new_idle);
            }
        }
        if overflow {
            self.write(Stage::Communication, OVERFLOW);
        }
        let stopped = overflow && self.settings.target_number(PERIOD).is_some_and(|period| period != 0);
        if self.settings.wants(PERIOD) || stopped {
            self.write(start, PERIOD);
        }
        if let Some(new) = cob_id.filter(|new| new & PRODUCES_SYNC != 0) {
            self.put_number(start, COB_ID, new);
        }
    }

    /// 100Ch, 100Dh, 1017h: guarding and heartbeat must not run simultaneously, so the one that ends is
    /// disabled first.
    fn error_control(&mut self) {
        let mut keys: Vec<EntryKey> = [(0x100C, 0), (0x100D, 0), (0x1017, 0)].into();
        keys.retain(|&key| self.settings.wants(key));
        keys.sort_by_key(|&key| {
            self.settings.target(key).is_some_and(|data| data.iter().any(|&byte| byte != 0))
        });
        keys.into_iter().for_each(|key| self.write(Stage::Communication, key));
    }

    /// 1016h: two entries must not monitor the same node, so a node that moves to a different entry is
    /// removed from the old one first.
    fn heartbeat_consumers(&mut self, keys: &[EntryKey]) {
        let mut done = BTreeSet::new();
        for &key in keys {
            let watched = self.settings.target_number(key).and_then(watched_node);
            for &other in keys.iter().filter(|&&other| other != key && !done.contains(&other)) {
                let leaves = self.settings.default_number(other).and_then(watched_node);
                if watched.is_some() && leaves == watched {
                    self.put_number(Stage::Communication, other, 0);
                }
            }
            self.write(Stage::Communication, key);
            done.insert(key);
        }
    }

    /// COB-IDs with bits 0 to 29 changeable only after `off` is applied: 1012h, 1014h, 1028h.
    fn identifiers(&mut self, keys: &[EntryKey], off: impl Fn(u32) -> u32) {
        for &key in keys {
            if let Some(new) = self.settings.target_number(key) {
                let old = self.settings.default_number(key).unwrap_or(new);
                let renamed = (old ^ new) & IDENTIFIER != 0;
                if (renamed || self.settings.writes_all()) && off(old) != new {
                    self.put_number(Stage::Communication, key, off(old));
                }
            }
            self.write(Stage::Communication, key);
        }
    }

    /// An SDO of 1200h to 12FFh: disable it, write its parameters, enable it.
    fn sdo(&mut self, keys: &[EntryKey]) {
        let (identifiers, others): (Vec<EntryKey>, Vec<EntryKey>) =
            keys.iter().partition(|(_, sub)| matches!(sub, 1 | 2));
        let mut on = Vec::new();
        for key in identifiers {
            let Some(new) = self.settings.target_number(key) else {
                self.write(Stage::Communication, key);
                continue;
            };
            let off = self.settings.default_number(key).unwrap_or(new) | INVALID;
            self.put_number(Stage::Communication, key, off);
            if new != off {
                on.push((key, new));
            }
        }
        others.into_iter().for_each(|key| self.write(Stage::Communication, key));
        on.into_iter().for_each(|(key, new)| self.put_number(Stage::Communication, key, new));
    }
}

/// The node-ID in an entry of 1016h.
fn watched_node(consumer: u32) -> Option<u8> {
    let [time_low, time_high, node, _] = consumer.to_le_bytes();
    ((time_low | time_high) != 0 && node != 0).then_some(node)
}

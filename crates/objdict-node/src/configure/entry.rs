//! Sets the value of one entry and heartbeat consumers (1016h), and explains settings for objects that the
//! device does not have.

use std::borrow::Cow;

use super::time::in_unit_of;
use super::{Configurator, PdoName, Wrong};
use crate::diagnostic::{listing, misspelled, series, sub_index};
use crate::download::{Beyond, beyond, bytes_of, transferred_type};
use crate::model::{
    Access, Address, DataType, Entry, ExplicitDownload, Field, Moment, Object, ObjectType, PdoKind, Value,
};
use crate::resolve::{ObjectName, candidates, meant};
use crate::{literal, profile};
use objdict_model::literal::nanoseconds;

/// Maximum number of candidates listed for an ambiguous name.
const MAX_CANDIDATES: usize = 8;

impl<'a> Configurator<'a> {
    /// Resolves a name to exactly one object or entry.
    pub(super) fn address(&self, name: &ObjectName) -> Result<Address, Wrong> {
        let text = match name {
            ObjectName::Address(address) => return Ok(*address),
            ObjectName::Text(text) => text,
        };
        match candidates(self.device, text)[..] {
            [address] => Ok(address),
            [] => {
                let wrong = Wrong::new(format!("unknown object or entry `{text}`"));
                Err(match meant(self.device, text) {
                    Some(meant) => wrong.help(format!("did you mean `{meant}`?")),
                    None => wrong.help("`objdict show` lists the objects"),
                })
            }
            ref found => {
                let shown = found.iter().take(MAX_CANDIDATES).map(|&at| self.described(at));
                let more =
                    (found.len() > MAX_CANDIDATES).then(|| format!("{} more", found.len() - MAX_CANDIDATES));
                let candidates = series(shown.chain(more));
                Err(Wrong::new(format!("`{text}` is ambiguous")).help(format!("it could be {candidates}")))
            }
        }
    }

    /// "`6064` Position actual value", "`1800:2` in TPDO 1 communication parameter".
    fn described(&self, at: Address) -> String {
        let name = self.device.object(at.index).map_or("", Object::name);
        let of = if at.sub.is_some() { "in " } else { "" };
        format!("`{}` {of}{name}", ObjectName::Address(at))
    }

    /// Parses a text and sets an entry to its value.
    pub(super) fn set(&mut self, at: Address, text: &str) -> Result<(), Wrong> {
        let (sub, entry) = self.writable(at)?;
        let value = self.read(at.index, sub, &entry, text)?;
        self.put(at.index, sub, &entry, value)
    }

    /// Adds downloads of an entry.
    pub(super) fn download(&mut self, when: Moment, at: Address, texts: &[String]) -> Result<(), Wrong> {
        let (sub, entry) = self.writable(at)?;
        for text in texts {
            let value = self.read(at.index, sub, &entry, text)?;
            self.check(at.index, sub, &entry, &value)?;
            self.downloads.push(ExplicitDownload { when, index: at.index, sub, value });
        }
        Ok(())
    }

    /// Sets an entry of an object that a setting does not mention, so problems must name it.
    pub(super) fn set_implied(&mut self, at: Address, text: &str) -> Result<(), Wrong> {
        self.set(at, text).map_err(|wrong| wrong.about(at))
    }

    /// Sets an entry after checking data type and limits.
    pub(super) fn put(&mut self, index: u16, sub: u8, entry: &Entry, value: Value) -> Result<(), Wrong> {
        self.check(index, sub, entry, &value)?;
        self.values.insert((index, sub), value);
        Ok(())
    }

    /// Checks data type and limits.
    fn check(&self, index: u16, sub: u8, entry: &Entry, value: &Value) -> Result<(), Wrong> {
        let place = |field| self.device.entry_place(index, sub).field(field);
        let bytes = bytes_of(self.device, index, sub, value, Some(self.node_id));
        bytes.map_err(|problem| Wrong::new(problem.to_string()).at(place(Field::DataType)))?;
        let (side, limit, field) = match beyond(entry, value, Some(self.node_id)) {
            Some(Beyond::Low(limit)) => ("below the low", limit, Field::LowLimit),
            Some(Beyond::High(limit)) => ("above the high", limit, Field::HighLimit),
            None => return Ok(()),
        };
        Err(Wrong::new(format!("`{value}` is {side} limit `{limit}`")).at(place(field)))
    }

    /// Parses a text as a value of the entry's data type.
    fn read(&self, index: u16, sub: u8, entry: &Entry, text: &str) -> Result<Value, Wrong> {
        let place = || self.device.entry_place(index, sub).field(Field::DataType);
        let Some(data_type) = transferred_type(self.device, index, sub) else {
            let wrong = Wrong::new("the description does not state the data type of the entry");
            return Err(wrong.at(place()));
        };
        if text.is_empty() {
            return Err(Wrong::new("the value is missing").help(format!("write a value of {data_type}")));
        }
        let is_text = matches!(data_type, DataType::VISIBLE_STRING | DataType::UNICODE_STRING);
        if text.eq_ignore_ascii_case("default") && !is_text {
            let missing = || Wrong::new("the description states no default of the entry");
            return entry.default.clone().ok_or_else(missing);
        }
        if let Some(time) = nanoseconds(text).filter(|_| data_type.is_integer()) {
            return in_unit_of(self.device, (index, sub), text, time).map(Value::Unsigned);
        }
        literal::written(text, data_type).map_err(|wrong| {
            Wrong { help: wrong.help.map(str::to_owned), ..Wrong::new(wrong.message) }.at(place())
        })
    }

    /// Finds the entry and checks that a configuration may write it.
    pub(super) fn writable(&self, at: Address) -> Result<(u8, Cow<'a, Entry>), Wrong> {
        let (object, sub, entry) = self.entry(at)?;
        let is_domain = entry.object_type == Some(ObjectType::Domain);
        let place = |field| self.device.entry_place(at.index, sub).field(field);
        match entry.access.or(is_domain.then_some(Access::Rw)) {
            Some(access) if !access.is_writable() => {
                let wrong = Wrong::new(format!("the entry is `{access}`, so it cannot be configured"));
                return Err(wrong.at(place(Field::AccessType)));
            }
            _ if at.index < 0x1000 => return Err(Wrong::new("a data type has no value to configure")),
            _ => {}
        }
        if entry.flags().refuses_write() || object.main.flags().refuses_write() {
            let wrong = Wrong::new("ObjFlags bit 0 forbids the download").at(place(Field::ObjFlags));
            return Err(wrong.help("write it by SDO while the node is running"));
        }
        Ok((sub, entry))
    }

    /// Finds the entry.
    pub(super) fn entry(&self, at: Address) -> Result<(&'a Object, u8, Cow<'a, Entry>), Wrong> {
        let device = self.device;
        let Some(object) = device.object(at.index) else {
            return Err(self.no_object(at.index));
        };
        let has_subs = object.object_type().has_subs() || object.compact.is_some();
        let sub = match at.sub {
            Some(sub) => sub,
            None if !has_subs => 0,
            None => {
                let subs = subs(object);
                let wrong = Wrong::new("the object has sub-indexes, but the setting names none");
                let example = ObjectName::Address(Address { sub: Some(1), ..at });
                return Err(wrong.help(format!("name one of {subs}, as in `{example}`")));
            }
        };
        match object.entry(sub) {
            Some(entry) => Ok((object, sub, entry)),
            None => {
                let wrong = Wrong::new(format!("the object has no sub-index {}", sub_index(sub)));
                Err(wrong.help(format!("it has {}", subs(object))))
            }
        }
    }
}

/// Lists the sub-indexes of an object; consecutive ones as a range.
fn subs(object: &Object) -> String {
    let mut ranges: Vec<(u8, u8)> = Vec::new();
    for (sub, _) in object.entries() {
        match ranges.last_mut() {
            Some((_, last)) if last.checked_add(1) == Some(sub) => *last = sub,
            _ => ranges.push((sub, sub)),
        }
    }
    let range = |&(first, last): &(u8, u8)| match first == last {
        true => format!("{first:X}"),
        false => format!("{first:X} to {last:X}"),
    };
    listing(ranges.iter().map(range)).to_string()
}

const CONSUMERS: u16 = 0x1016;

impl Configurator<'_> {
    /// Monitors a node: reuses the entry that already monitors it, or takes the first free one.
    pub(super) fn watch(&mut self, node_id: u8, milliseconds: u16) -> Result<(), Wrong> {
        if node_id == self.node_id {
            return Err(Wrong::new("a node cannot monitor its own heartbeat"));
        }
        let Some(object) = self.device.object(CONSUMERS) else {
            return Err(self.no_object(CONSUMERS));
        };
        let subs: Vec<u8> =
            object.entries().map(|(sub, _)| sub).filter(|sub| (1..=0x7F).contains(sub)).collect();
        let watched = |sub: &u8| {
            let consumer = self.number(CONSUMERS, *sub).unwrap_or_default();
            let (time, node) = (consumer & 0xFFFF, consumer >> 16 & 0xFF);
            if time == 0 || node == 0 { 0 } else { node }
        };
        let own = subs.iter().copied().find(|sub| watched(sub) == u64::from(node_id));
        let free = subs.iter().copied().find(|sub| watched(sub) == 0);
        let Some(sub) = own.or(free) else {
            let wrong = Wrong::new(format!("all {} entries of 1016h monitor other nodes", subs.len()));
            return Err(wrong.help("free one of them first with `--set 1016:1=0`"));
        };
        let (sub, entry) = self.writable(Address { index: CONSUMERS, sub: Some(sub) })?;
        let consumer = u64::from(node_id) << 16 | u64::from(milliseconds);
        self.put(CONSUMERS, sub, &entry, Value::Unsigned(consumer))
    }
}

impl Configurator<'_> {
    /// The problem of an object that the device does not have.
    pub(super) fn no_object(&self, index: u16) -> Wrong {
        let pdo = PdoKind::of_communication(index).or_else(|| PdoKind::of_mapping(index));
        if let Some((kind, number)) = pdo {
            return self.no_pdo(PdoName { kind, number });
        }
        let wanted = format!("{index:04X}");
        let known =
            profile::of_object(self.device, index).map(|(_, facts)| facts.name).find(|name| !name.is_empty());
        let Some(name) = known else {
            let wrong = Wrong::new(format!("the device has no object `{wanted}`"));
            let mut indexes: Vec<String> =
                self.device.objects.keys().map(|index| format!("{index:04X}")).collect();
            // the part of the dictionary is rarely wrong
            indexes.sort_by_key(|known| known.as_bytes().first() != wanted.as_bytes().first());
            let meant = same_digits(&wanted, &indexes);
            return match meant.or_else(|| misspelled(&wanted, indexes.iter().map(String::as_str))) {
                Some(meant) => wrong.help(format!("did you mean `{meant}`?")),
                None => wrong.help("`objdict show` lists the objects"),
            };
        };
        // an existing index is intended as written
        let wrong = Wrong::new(format!("the device has no object `{wanted}` ({name})"));
        match self.consequence(index) {
            Some(help) => wrong.help(help),
            None => wrong,
        }
    }

    /// The consequence of a missing communication object, and its replacement in the device.
    fn consequence(&self, index: u16) -> Option<&'static str> {
        let has = |index| self.device.object(index).is_some();
        Some(match index {
            0x1005 => "the device does not use SYNC",
            0x1006 | 0x1007 if has(0x1005) => "the device consumes SYNC (1005h), but does not produce it",
            0x1006 | 0x1007 | 0x1019 if !has(0x1005) => "the device does not use SYNC",
            0x1019 => "the device uses SYNC (1005h) without a counter",
            0x100C | 0x100D if has(0x1017) => "the device has no guarding; its heartbeat is 1017h",
            0x1017 if has(0x100C) => "the device has no heartbeat producer; guarding is 100Ch and 100Dh",
            0x100C | 0x100D | 0x1017 => {
                "the device has neither guarding (100Ch, 100Dh) nor a heartbeat producer (1017h)"
            }
            0x1010 => "the device does not store parameters by command",
            0x1011 => "the device does not restore its defaults by command",
            0x1012 => "the device does not use TIME",
            0x1014 | 0x1015 => "the CAN-ID of EMCY and its inhibit time cannot be configured",
            0x1016 => "the device does not monitor heartbeats",
            0x1020 => "the device does not store its configuration date",
            0x1028 => "the device does not consume EMCY",
            0x1029 => "the device's reaction to errors cannot be configured",
            _ => return None,
        })
    }
}

/// Finds an index with two digits swapped, the most common typing error.
fn same_digits<'a>(wanted: &str, indexes: &'a [String]) -> Option<&'a str> {
    let sorted = |text: &str| {
        let mut digits = text.as_bytes().to_vec();
        digits.sort_unstable();
        digits
    };
    let differing = |index: &str| index.bytes().zip(wanted.bytes()).filter(|(a, b)| a != b).count();
    let mut indexes = indexes.iter().map(String::as_str);
    indexes.find(|index| differing(index) == 2 && sorted(index) == sorted(wanted))
}

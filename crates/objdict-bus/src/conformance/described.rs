//! What a description says of the node: what the checks expect.

use objdict_device::{Abort, Dictionary};
use objdict_node::download::AbortCode;
use objdict_node::parameter::no_parameter;

use super::{CheckStep, absent, impossible};
use crate::dictionary::{LiveDictionary, number};
use crate::model::{Access, DataType, Device, Entry, PdoKind, TypeKind};

/// The entries of a description on a node, in ascending order.
pub(super) struct DescribedEntries {
    pub(super) node_id: u8,
    pub(super) entries: Vec<DescribedEntry>,
    /// Whether the device has an LSS slave.
    pub(super) has_lss: bool,
    /// In kbit/s; 0 for a bit rate that the device finds out itself.
    pub(super) bit_rates: Vec<u16>,
}

/// An entry as the description has it.
pub(super) struct DescribedEntry {
    pub(super) index: u16,
    pub(super) sub: u8,
    pub(super) data_type: DataType,
    pub(super) access: Access,
    /// As an SDO transfers it; what the node has, if the description says none.
    pub(super) default: Vec<u8>,
    /// The limits of an integer.
    pub(super) low: Option<i128>,
    pub(super) high: Option<i128>,
    /// Whether there are limits of another kind, which are not checked.
    pub(super) has_other_limits: bool,
    /// Whether RPDOs, TPDOs may map it.
    pub(super) fits: [bool; 2],
    /// Whether a machine obeys it, so that only its own checks use it.
    is_spared: bool,
    /// Whether 1010h stores it.
    pub(super) is_kept: bool,
    /// The length of a value in bytes; `None` for texts, octets and DOMAINs.
    length: Option<usize>,
    /// The most bytes of a value.
    room: usize,
}

impl DescribedEntry {
    fn new(index: u16, sub: u8, entry: &Entry, node_id: u8, live: &[u8]) -> Option<Self> {
        let (data_type, access) = (entry.implied_type()?, entry.implied_access()?);
        let value = entry.value().and_then(|value| value.resolve(data_type, node_id));
        let limit =
            |limit: &Option<crate::model::Value>| limit.as_ref().and_then(|value| value.integer_for(node_id));
        let (low, high) = (limit(&entry.low_limit), limit(&entry.high_limit));
        // a table has no limits that contradict each other
        let is_contradiction = low.zip(high).is_some_and(|(low, high)| low > high);
        let (low, high) = if is_contradiction { (None, None) } else { (low, high) };
        let has_limits = entry.low_limit.is_some() || entry.high_limit.is_some();
        let fits = |kind| entry.is_mappable() && entry.fits_pdo(kind);
        Some(Self {
            index,
            sub,
            data_type,
            access,
            default: value.and_then(|value| value.to_bytes(data_type)).unwrap_or_else(|| live.to_vec()),
            low,
            high,
            has_other_limits: has_limits && low.is_none() && high.is_none(),
            fits: [fits(PdoKind::Rpdo), fits(PdoKind::Tpdo)],
            is_spared: false,
            is_kept: true,
            length: data_type.byte_length().map(usize::from),
            room: live.len(),
        })
    }

    /// The entry with the length that the node has, if that is the one of its type.
    fn with_length(mut self, length: usize) -> Option<Self> {
        self.room = length;
        if self.is_opaque() {
            self.length = Some(length);
        }
        self.length.is_none_or(|own| own == length).then_some(self)
    }

    pub(super) fn is_readable(&self) -> bool {
        self.access.is_readable()
    }

    pub(super) fn is_writable(&self) -> bool {
        self.access.is_writable()
    }

    pub(super) const fn size(&self) -> Option<usize> {
        self.length
    }

    /// Whether it has a type of the device, whose length the device has and whose values a description does not say.
    pub(super) fn is_opaque(&self) -> bool {
        matches!(self.data_type.kind(), TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved)
    }

    pub(super) fn is_integer(&self) -> bool {
        matches!(self.data_type.kind(), TypeKind::Signed(_) | TypeKind::Unsigned(_))
    }

    /// Whether a value is within the limits.
    pub(super) fn allows(&self, number: i128) -> bool {
        self.low.is_none_or(|low| low <= number) && self.high.is_none_or(|high| number <= high)
    }

    /// Whether the default is within the limits, so that it can be written too.
    pub(super) fn allows_default(&self) -> bool {
        !self.has_other_limits && self.number_of(&self.default).is_none_or(|number| self.allows(number))
    }

    /// The bytes of a number, if it is one of the data type.
    pub(super) fn bytes_of(&self, number: i128) -> Option<Vec<u8>> {
        let value = crate::model::Value::from_integer(number, self.data_type)?;
        value.to_bytes(self.data_type)
    }

    /// The number in the bytes of a value.
    pub(super) fn number_of(&self, bytes: &[u8]) -> Option<i128> {
        crate::model::Value::from_bytes(bytes, self.data_type)?.as_integer()
    }

    /// Another valid value than this one.
    pub(super) fn other_than(&self, bytes: &[u8]) -> Option<Vec<u8>> {
        if self.has_other_limits {
            return None;
        }
        if let Some(present) = self.data_type.integer_range().and(self.number_of(bytes)) {
            let near = [present ^ 1, present ^ 2, present + 1, present - 1];
            let mut numbers = near.into_iter().chain(self.low).chain(self.high);
            let number = numbers
                .find(|&number| number != present && self.allows(number) && self.bytes_of(number).is_some());
            return self.bytes_of(number?);
        }
        let other = match self.data_type.kind() {
            TypeKind::Real32 => 1.5f32.to_le_bytes().to_vec(),
            TypeKind::Real64 => 1.5f64.to_le_bytes().to_vec(),
            TypeKind::TimeOfDay | TypeKind::TimeDifference => vec![1, 2, 3, 0, 5, 6],
            TypeKind::UnicodeString => b"v\0a\0l\0u\0e\0 \0".repeat(3),
            _ if self.is_opaque() => vec![0x5A; self.length.unwrap_or(0)],
            _ => b"a value of many segments".to_vec(),
        };
        let room = if self.data_type.kind() == TypeKind::UnicodeString { self.room & !1 } else { self.room };
        let other = &other[..other.len().min(room)];
        Some(if other == bytes { vec![0; other.len()] } else { other.to_vec() })
    }
}

impl DescribedEntries {
    pub(super) fn new(device: &Device, node_id: u8, live: &LiveDictionary) -> Self {
        let mut entries = Vec::new();
        for (&index, object) in device.objects.iter() {
            for (sub, entry) in object.entries() {
                // what a table cannot have is reported by the generator
                let (Ok(attributes), Some(value)) = (live.attributes(index, sub), live.bytes(index, sub))
                else {
                    continue;
                };
                let entry = DescribedEntry::new(index, sub, &entry, node_id, value);
                let entry = entry.and_then(|entry| entry.with_length(attributes.size));
                // compact storage cannot describe the number of errors, which each table has as in CiA 301
                let is_count = (index, sub) == (0x1003, 0) && object.compact.is_some();
                let access = |own| if is_count && attributes.writable { Access::Rw } else { own };
                let is_kept = live.keeps(index, sub);
                entries.extend(entry.map(|entry| DescribedEntry {
                    access: access(entry.access),
                    is_kept,
                    ..entry
                }));
            }
        }
        let info = device.device_info.as_ref();
        let has_lss = info.is_some_and(|info| info.lss_supported == Some(true));
        let bit_rates = info.map(|info| info.baud_rates.supported().collect()).unwrap_or_default();
        Self { node_id, entries, has_lss, bit_rates }
    }

    /// Expects these values instead of the defaults: a device is configured. One of another length stays what is described.
    pub(super) fn assume(&mut self, values: Vec<Option<Vec<u8>>>) {
        for (entry, value) in self.entries.iter_mut().zip(values) {
            if let Some(value) = value.filter(|value| entry.length.is_none_or(|length| length == value.len()))
            {
                entry.default = value;
            }
        }
    }

    /// Keeps process data, commands and domains out of the entries that checks choose: on a real machine they may move something.
    pub(super) fn spare(&mut self, device: &Device) {
        for entry in &mut self.entries {
            entry.is_spared = no_parameter(device, entry.index, entry.sub).is_some();
        }
    }

    pub(super) fn find(&self, index: u16, sub: u8) -> Option<&DescribedEntry> {
        let at = self.entries.binary_search_by_key(&(index, sub), |entry| (entry.index, entry.sub));
        at.ok().map(|at| &self.entries[at])
    }

    /// The indexes of the objects.
    pub(super) fn indexes(&self) -> Vec<u16> {
        let mut indexes: Vec<u16> = self.entries.iter().map(|entry| entry.index).collect();
        indexes.dedup();
        indexes
    }

    pub(super) fn has_object(&self, index: u16) -> bool {
        self.object(index).next().is_some()
    }

    /// The entries of an object.
    pub(super) fn object(&self, index: u16) -> impl Iterator<Item = &DescribedEntry> {
        let start = self.entries.partition_point(|entry| entry.index < index);
        self.entries[start..].iter().take_while(move |entry| entry.index == index)
    }

    /// An entry that a check is about.
    pub(super) fn needs(&self, index: u16, sub: u8) -> CheckStep<&DescribedEntry> {
        match self.find(index, sub) {
            Some(entry) => Ok(entry),
            None if sub == 0 => absent(format!("{index:04X}h")),
            None => absent(format!("{index:04X}h sub {sub}")),
        }
    }

    /// An entry that a check writes.
    pub(super) fn needs_writable(&self, index: u16, sub: u8) -> CheckStep<&DescribedEntry> {
        let entry = self.needs(index, sub)?;
        if entry.is_writable() {
            Ok(entry)
        } else {
            impossible(format!("{} is {}", place(index, sub), entry.access.name()))
        }
    }

    /// The default of a number; 0 without an entry.
    pub(super) fn number(&self, index: u16, sub: u8) -> u64 {
        self.find(index, sub).map_or(0, |entry| number(&entry.default))
    }

    /// An index without an object.
    pub(super) fn unused(&self) -> u16 {
        (0x2000..=u16::MAX).rev().find(|&index| !self.has_object(index)).unwrap_or(0)
    }

    /// The first entry of a kind: in the parts of the manufacturer and the profile, else in that of CiA 301, but for objects with
    /// rules of their own.
    pub(super) fn first(
        &self,
        what: &str,
        is_meant: impl Fn(&DescribedEntry) -> bool,
    ) -> CheckStep<&DescribedEntry> {
        let is_plain =
            |entry: &&DescribedEntry| is_meant(entry) && !has_rules(entry.index) && !entry.is_spared;
        let own = self.entries.iter().filter(|entry| entry.index >= 0x2000).find(is_plain);
        match own.or_else(|| self.entries.iter().find(is_plain)) {
            Some(entry) => Ok(entry),
            None => absent(what),
        }
    }
}

/// Whether the values of an object are no mere values: commands, and parameters of services.
pub(super) const fn has_rules(index: u16) -> bool {
    matches!(index, 0x1001 | 0x1003 | 0x1005 | 0x1007 | 0x100C | 0x100D | 0x1010..=0x1016 | 0x1019 | 0x1020 | 0x1028 | 0x1029 | 0x1200..=0x1BFF | 0x1F50..=0x1F5F)
}

/// How messages call an entry.
pub(super) fn place(index: u16, sub: u8) -> String {
    if sub == 0 { format!("{index:04X}h") } else { format!("{index:04X}h sub {sub}") }
}

/// How messages call the answer to an SDO.
pub(super) fn answer<T>(answer: &Result<T, Abort>) -> String {
    match answer {
        Ok(_) => "accepted".to_owned(),
        Err(abort) => abort_code(*abort),
    }
}

pub(super) fn abort_code(abort: Abort) -> String {
    AbortCode(abort.code()).to_string()
}

/// How messages call bytes.
pub(super) fn hex(bytes: &[u8]) -> String {
    const MOST: usize = 16;
    let mut text: String =
        bytes.iter().take(MOST).map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ");
    if bytes.len() > MOST {
        text += &format!(" … ({} bytes)", bytes.len());
    }
    if bytes.is_empty() { "no byte".to_owned() } else { text }
}

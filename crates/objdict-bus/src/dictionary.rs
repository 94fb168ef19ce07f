//! The dictionary of a description at run time.
//!
//! Its rows are those of the generated tables (`live_entries`), so a simulated node rejects the same writes as a
//! generated one.

use std::cmp::Ordering;
use std::sync::Arc;

use objdict_device::{Abort, Attributes, Dictionary, ObjectSet, Scope};
use objdict_generate::{LiveEntry, Options, StorageGroup, live_entries};

use crate::model::{Access, Assignment, DataType, Device, Object, TypeKind, Value};

/// Room for texts and DOMAINs, in bytes.
const ROOM: u16 = 0xFFFF;

/// The values that a node has when it is switched on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PowerOn {
    /// The defaults. What cannot be written, such as the identity, has its configured value.
    #[default]
    Defaults,
    /// The configured values of its DCF, which the node has stored.
    Configured,
}

impl PowerOn {
    /// A device without the configured values that its node has only after a download.
    pub(crate) fn values_of(self, device: &Device) -> Device {
        let mut device = device.with_implicit_pdos().into_owned();
        if self == Self::Configured {
            return device;
        }
        for object in device.objects.values_mut() {
            let Object { main, subs, compact, .. } = object;
            let is_writable = |access: Option<Access>| access.is_some_and(Access::is_writable);
            if let Some(compact) = compact.as_mut().filter(|_| is_writable(main.access)) {
                compact.values.clear();
            }
            for entry in subs.iter_mut().map(|(_, entry)| entry).chain([main]) {
                if is_writable(entry.implied_access())
                    && let Some(configured) = &mut entry.configured
                {
                    configured.value = None;
                }
            }
        }
        device
    }
}

/// The values of a node, with the access, the limits and the types of its description: what the generated table of this description
/// answers. Beyond that, 1010h stores and 1011h restores.
#[derive(Clone, Debug)]
pub struct LiveDictionary {
    /// In ascending order.
    entries: Arc<[LiveEntry]>,
    objects: ObjectSet,
    values: Vec<Vec<u8>>,
    /// What the node restarts with.
    stored: Vec<Vec<u8>>,
    /// Storage that 1011h marked to be dropped at the next reset, by sub-index.
    dropped: Vec<u8>,
    node_id: u8,
    /// Whether 1010h stores only the values of storage groups; otherwise there is a memory for all.
    by_group: bool,
    /// Whether it represents any device with the description, and not only one with the services of `objdict-device`.
    is_any: bool,
}

impl LiveDictionary {
    /// The values of a device on a node, which has just been switched on.
    pub fn new(device: &Device, node_id: u8, power_on: PowerOn) -> Self {
        Self { is_any: true, ..Self::with_options(device, node_id, power_on, &roomy()) }
    }

    /// What a generated table with room for all values and these storage groups answers.
    pub(crate) fn of_table(device: &Device, node_id: u8, groups: &[StorageGroup]) -> Self {
        let options = Options { groups: groups.to_vec(), ..roomy() };
        Self::with_options(device, node_id, PowerOn::Defaults, &options)
    }

    /// What a generated table with these options answers.
    pub fn with_options(device: &Device, node_id: u8, power_on: PowerOn, options: &Options) -> Self {
        let entries: Arc<[LiveEntry]> = live_entries(&power_on.values_of(device), node_id, options).into();
        let values: Vec<Vec<u8>> = entries.iter().map(|entry| entry.value.clone()).collect();
        let (stored, by_group) = (values.clone(), !options.groups.is_empty());
        let with_object =
            |objects: ObjectSet, entry: &LiveEntry| objects.with(entry.index, entry.is_writable);
        let objects = entries.iter().fold(ObjectSet::NONE, with_object);
        Self { entries, objects, stored, values, dropped: Vec::new(), node_id, by_group, is_any: false }
    }

    /// The objects of the communication parameters of PDOs, of RPDOs and of TPDOs.
    pub(crate) fn pdos(&self) -> [Vec<u16>; 2] {
        let of = |range: std::ops::RangeInclusive<u16>| {
            let first = |entry: &&LiveEntry| entry.sub <= 1 && range.contains(&entry.index);
            let mut indexes: Vec<u16> = self.entries.iter().filter(first).map(|entry| entry.index).collect();
            indexes.dedup();
            indexes
        };
        [of(0x1400..=0x15FF), of(0x1800..=0x19FF)]
    }

    /// The bytes of the longest value.
    pub(crate) fn longest(&self) -> usize {
        self.entries.iter().map(|entry| entry.size.max(entry.value.len())).max().unwrap_or_default()
    }

    /// Whether there is an entry.
    pub(crate) fn has(&self, index: u16, sub: u8) -> bool {
        self.find(index, sub).is_ok()
    }

    /// Whether 1010h stores the value of an entry.
    pub(crate) fn keeps(&self, index: u16, sub: u8) -> bool {
        self.find(index, sub).is_ok_and(|at| !self.by_group || self.entries[at].is_grouped)
    }

    /// The bytes of an entry, without a look at its access.
    pub fn bytes(&self, index: u16, sub: u8) -> Option<&[u8]> {
        self.find(index, sub).ok().map(|at| self.values[at].as_slice())
    }

    /// The value of an entry of at most four bytes, without a look at its access; 0 if there is none.
    pub(crate) fn word(&self, index: u16, sub: u8) -> u32 {
        number(self.bytes(index, sub).unwrap_or_default()) as u32
    }

    /// A device with the present values as configured ones.
    pub fn present(&self, device: &Device) -> Device {
        let mut device = device.with_implicit_pdos().into_owned();
        let values = self.entries.iter().zip(&self.values).filter(|(entry, _)| entry.is_writable);
        let assignments = values.filter_map(|(entry, bytes)| {
            let value = Value::from_bytes(bytes, entry.data_type?)?;
            Some(Assignment { index: entry.index, sub: entry.sub, value })
        });
        let assignments: Vec<Assignment> = assignments.collect();
        device.assign(&assignments);
        device
    }

    fn find(&self, index: u16, sub: u8) -> Result<usize, Abort> {
        let found = self.entries.binary_search_by_key(&(index, sub), |entry| (entry.index, entry.sub));
        found.map_err(|at| {
            let neighbours = [at.checked_sub(1), Some(at)].into_iter().flatten();
            let is_object = |at: usize| self.entries.get(at).is_some_and(|entry| entry.index == index);
            if neighbours.into_iter().any(is_object) { Abort::NoSubIndex } else { Abort::NoObject }
        })
    }
}

/// The number in the first eight bytes of a value.
pub(crate) fn number(bytes: &[u8]) -> u64 {
    bytes.iter().take(8).rev().fold(0, |number, &byte| number << 8 | u64::from(byte))
}

/// Options for a table with room for all values.
fn roomy() -> Options {
    let mut options = Options::default();
    (options.string_capacity, options.domain_capacity) = (ROOM, ROOM);
    options
}

/// Whether a sub-index of 1010h and 1011h is about an object.
fn is_stored(sub: u8, index: u16) -> bool {
    let is_command = matches!(index, 0x1010 | 0x1011);
    !is_command
        && match sub {
            1 => true,
            2 => (0x1000..0x2000).contains(&index),
            3 => (0x6000..0xA000).contains(&index),
            _ => (0x2000..0x6000).contains(&index),
        }
}

/// Whether values have lengths of their own.
fn has_length(entry: &LiveEntry) -> bool {
    entry.data_type.is_some_and(|data_type| data_type.byte_length().is_none())
}

/// Whether a value has the length of an entry.
fn check_length(entry: &LiveEntry, bytes: &[u8]) -> Result<(), Abort> {
    if bytes.len() > entry.size {
        return Err(Abort::TooLong);
    }
    if bytes.len() < entry.size && !has_length(entry) { Err(Abort::TooShort) } else { Ok(()) }
}

/// Whether a value of this length may be written, as in a generated table.
fn check(entry: &LiveEntry, bytes: &[u8]) -> Result<(), Abort> {
    match entry.data_type.map(DataType::kind) {
        Some(TypeKind::UnicodeString) if bytes.len() % 2 == 1 => return Err(Abort::LengthMismatch),
        Some(TypeKind::Boolean) if bytes != [0] && bytes != [1] => return Err(Abort::InvalidValue),
        _ => {}
    }
    let against = |limit: Option<u64>| match (limit, entry.data_type) {
        (Some(limit), Some(data_type)) => order(data_type, bytes, limit).map(Some).ok_or(Abort::InvalidValue),
        _ => Ok(None),
    };
    if against(entry.low)? == Some(Ordering::Less) {
        return Err(Abort::TooLow);
    }
    if against(entry.high)? == Some(Ordering::Greater) { Err(Abort::TooHigh) } else { Ok(()) }
}

/// The order of a value and a limit; `None` for a value that is not a number.
fn order(data_type: DataType, bytes: &[u8], limit: u64) -> Option<Ordering> {
    let value = Value::from_bytes(bytes, data_type)?;
    match (data_type.kind(), &value) {
        (TypeKind::Real32, _) => value.as_real()?.partial_cmp(&f64::from(f32::from_bits(limit as u32))),
        (TypeKind::Real64, _) => value.as_real()?.partial_cmp(&f64::from_bits(limit)),
        (TypeKind::Signed(_), Value::Signed(value)) => Some(value.cmp(&limit.cast_signed())),
        _ => Some(value.as_integer()?.cmp(&i128::from(limit))),
    }
}

impl Dictionary for LiveDictionary {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        let entry = &self.entries[self.find(index, sub)?];
        Ok(Attributes {
            size: entry.size,
            data_type: entry.data_type.and_then(|data_type| u8::try_from(data_type.0).ok()).unwrap_or(0),
            readable: entry.is_readable,
            writable: entry.is_writable,
            fits_tpdo: entry.fits_tpdo,
            fits_rpdo: entry.fits_rpdo,
        })
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        let at = self.find(index, sub)?;
        if !self.entries[at].is_readable {
            return Err(Abort::WriteOnly);
        }
        let (entry, value) = (&self.entries[at], &self.values[at]);
        if entry.size == 0 && entry.data_type == Some(DataType::DOMAIN) {
            return Err(Abort::NoData);
        }
        buffer.get_mut(..value.len()).ok_or(Abort::OutOfMemory)?.copy_from_slice(value);
        Ok(value.len())
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let at = self.find(index, sub)?;
        let entry = &self.entries[at];
        if !entry.is_writable {
            return Err(Abort::ReadOnly);
        }
        if entry.size == 0 && entry.data_type == Some(DataType::DOMAIN) {
            return Err(Abort::CannotStore);
        }
        check_length(entry, bytes)?;
        check(entry, bytes)?;
        let mut value = bytes.to_vec();
        if matches!(entry.data_type, Some(DataType::TIME_OF_DAY | DataType::TIME_DIFFERENCE)) {
            value[3] &= 0x0F; // void bits
        }
        self.values[at] = value;
        Ok(())
    }

    fn objects(&self) -> ObjectSet {
        self.objects
    }

    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let at = self.find(index, sub)?;
        if bytes.len() != self.entries[at].size && !has_length(&self.entries[at]) {
            return Err(Abort::LengthMismatch);
        }
        self.values[at] = bytes.to_vec();
        Ok(())
    }

    fn restart(&mut self, scope: Scope, _: u8) {
        for sub in std::mem::take(&mut self.dropped) {
            for (at, entry) in
                self.entries.iter().enumerate().filter(|(_, entry)| is_stored(sub, entry.index))
            {
                self.stored[at].clone_from(&entry.value);
            }
        }
        for (at, entry) in self.entries.iter().enumerate() {
            if scope.contains(entry.index) {
                self.values[at].clone_from(&self.stored[at]);
            }
        }
    }

    fn serves_more(&self) -> bool {
        self.is_any
    }

    fn own_node_id(&self) -> Option<u8> {
        Some(self.node_id)
    }

    fn can_store(&self, _: u8) -> bool {
        true
    }

    fn store(&mut self, sub: u8) -> Result<(), Abort> {
        for (at, entry) in self.entries.iter().enumerate() {
            let is_kept = !self.by_group || entry.is_grouped;
            if entry.is_writable && is_kept && is_stored(sub, entry.index) {
                self.stored[at].clone_from(&self.values[at]);
            }
        }
        Ok(())
    }

    /// The stored values are dropped at the next reset.
    fn restore(&mut self, sub: u8) -> Result<(), Abort> {
        self.dropped.push(sub);
        Ok(())
    }
}

//! A simulated node: its dictionary, its present values, and the checks of every write.

use std::collections::{BTreeMap, BTreeSet};

use super::super::settings::Key;
use super::super::transfer::{Beyond, EntryType, beyond};
use super::super::{Download, ProblemKind};
use super::objection::ObjectionKind;
use crate::model::{Access, DataType, Device, Entry, Object, ObjectType, Place, TypeKind, Value};

/// The result of a write: accepted, accepted with an objection, or rejected.
pub(super) type Judgement = Result<Option<ObjectionKind>, ObjectionKind>;

/// A node.
pub(super) struct Node<'a> {
    pub(super) device: &'a Device,
    node_id: Option<u8>,
    /// The written entries; all others have their defaults.
    written: BTreeMap<Key, Vec<u8>>,
    /// Entries whose default was needed but depends on the missing node-ID.
    unknown: BTreeSet<Key>,
    /// Whether 1010h was written.
    is_stored: bool,
    /// Whether 1020h was written and no later write cleared it.
    is_verified: bool,
}

impl<'a> Node<'a> {
    pub(super) fn new(device: &'a Device, node_id: Option<u8>) -> Self {
        let (written, unknown) = (BTreeMap::new(), BTreeSet::new());
        Self { device, node_id, written, unknown, is_stored: false, is_verified: false }
    }

    /// The entries whose present value was needed but is unknown.
    pub(super) fn into_unknown(self) -> Vec<Place> {
        self.unknown.iter().map(|&(index, sub)| node_place(self.device, index, sub)).collect()
    }

    /// Applies a download, or rejects it without changing the state.
    pub(super) fn take(&mut self, download: &Download) -> Judgement {
        self.judge_entry(download)?;
        let of_service = self.judge_service(download)?;
        let late = self.judge_order(download.index);
        self.written.insert((download.index, download.sub), download.data.clone());
        Ok(of_service.or(late))
    }

    /// Checks of every entry: existence, access, size and limits.
    fn judge_entry(&self, download: &Download) -> Result<(), ObjectionKind> {
        let object = self.device.object(download.index).ok_or(ObjectionKind::NoObject)?;
        let entry = object.entry(download.sub).ok_or(ObjectionKind::NoSubIndex)?;
        if !can_be_written(download.index, object, &entry) {
            return Err(ObjectionKind::NotWritable);
        }
        if entry.flags().refuses_write() || object.main.flags().refuses_write() {
            return Err(ObjectionKind::RefusesDownload);
        }
        let entry_type = EntryType::of(self.device, object, (download.index, download.sub), &entry);
        let Some(data_type) = entry_type.transferred else { return Ok(()) };
        let value = value_of(data_type, &download.data)?;
        match value.as_ref().and_then(|value| Some((value, beyond(&entry, value, self.node_id)?))) {
            Some((value, Beyond::Low(limit))) => {
                Err(ObjectionKind::BelowLimit { value: value.clone(), limit })
            }
            Some((value, Beyond::High(limit))) => {
                Err(ObjectionKind::AboveLimit { value: value.clone(), limit })
            }
            None => Ok(()),
        }
    }

    /// Checks for writes after storing (1010h) or after the verify configuration (1020h).
    fn judge_order(&mut self, index: u16) -> Option<ObjectionKind> {
        match index {
            0x1010 | 0x1011 => {
                self.is_stored |= index == 0x1010;
                return None;
            }
            0x1020 => self.is_verified = true,
            _ if self.is_verified => {
                self.is_verified = false;
                return Some(ObjectionKind::ClearsVerification);
            }
            _ => {}
        }
        // reported once
        std::mem::take(&mut self.is_stored).then_some(ObjectionKind::NotStored)
    }

    /// The present value of an entry as a number; `None` if the entry does not exist or the value is unknown.
    pub(super) fn number(&mut self, key: Key) -> Option<u64> {
        let bytes = match self.written.get(&key) {
            Some(written) => written.clone(),
            None => self.default(key)?,
        };
        number(&bytes)
    }

    /// The same for 32-bit entries.
    pub(super) fn word(&mut self, key: Key) -> Option<u32> {
        u32::try_from(self.number(key)?).ok()
    }

    fn default(&mut self, (index, sub): Key) -> Option<Vec<u8>> {
        let object = self.device.object(index)?;
        let entry = object.entry(sub)?;
        let bytes = EntryType::of(self.device, object, (index, sub), &entry)
            .bytes(entry.default.as_ref()?, self.node_id);
        if matches!(bytes, Err(ProblemKind::NeedsNodeId(_))) {
            self.unknown.insert((index, sub));
        }
        bytes.ok()
    }
}

fn can_be_written(index: u16, object: &Object, entry: &Entry) -> bool {
    let object_type = object.object_type();
    let is_definition = matches!(object_type, ObjectType::Null | ObjectType::DefType | ObjectType::DefStruct);
    // without an access type the entry may be writable
    index >= 0x1000 && !is_definition && entry.access.is_none_or(Access::is_writable)
}

/// Decodes bytes; `None` for types without limits.
fn value_of(data_type: DataType, data: &[u8]) -> Result<Option<Value>, ObjectionKind> {
    let found = data.len();
    if let Some(expected) = data_type.byte_length().map(usize::from).filter(|&expected| expected != found) {
        return Err(ObjectionKind::Length { data_type, expected, found });
    }
    let is_value = match data_type.kind() {
        TypeKind::Boolean => data.iter().all(|&byte| byte <= 1),
        TypeKind::UnicodeString => found.is_multiple_of(2),
        _ => true,
    };
    if !is_value {
        return Err(ObjectionKind::NoValue(data_type));
    }
    Ok(Value::from_bytes(data, data_type))
}

/// The place of an entry as used in reports: the value of a VAR has no sub-index.
pub(super) fn node_place(device: &Device, index: u16, sub: u8) -> Place {
    match device.object(index) {
        Some(object) if sub == 0 && !object.object_type().has_subs() => Place::object(index),
        _ => Place::entry(index, sub),
    }
}

/// Up to eight bytes as a number.
pub(super) fn number(bytes: &[u8]) -> Option<u64> {
    let mut word = [0; 8];
    word.get_mut(..bytes.len())?.copy_from_slice(bytes);
    Some(u64::from_le_bytes(word))
}

//! A simulated node: its dictionary, its present values, and the checks of every write.

use std::collections::{BTreeMap, BTreeSet};

use objdict_device::{Abort, Attributes, Dictionary, Scope, check_write};

use super::super::settings::EntryKey;
use super::super::transfer::{Beyond, EntryType, beyond};
use super::super::{Download, ProblemKind};
use super::objection::ObjectionKind;
use crate::model::{
    Access, DataType, Device, Entry, Field, InvalidValue, Object, ObjectType, PdoKind, Place, TypeKind, Value,
};

/// The result of a write: accepted, accepted with an objection, or rejected.
pub(super) type WriteJudgement = Result<Option<ObjectionKind>, ObjectionKind>;

/// A node.
pub(super) struct AcceptingNode<'a> {
    pub(super) device: &'a Device,
    node_id: Option<u8>,
    /// The written entries; all others have their defaults.
    written: BTreeMap<EntryKey, Vec<u8>>,
    /// Entries whose default was needed but depends on the missing node-ID.
    unknown: BTreeSet<EntryKey>,
    /// Whether 1010h was written.
    is_stored: bool,
    /// Whether 1020h was written and no later write cleared it.
    is_verified: bool,
}

impl<'a> AcceptingNode<'a> {
    pub(super) fn new(device: &'a Device, node_id: Option<u8>) -> Self {
        let (written, unknown) = (BTreeMap::new(), BTreeSet::new());
        Self { device, node_id, written, unknown, is_stored: false, is_verified: false }
    }

    /// The entries whose present value was needed but is unknown.
    pub(super) fn into_unknown(self) -> Vec<Place> {
        self.unknown.iter().map(|&(index, sub)| node_place(self.device, index, sub)).collect()
    }

    /// Applies a download, or rejects it without changing the state. The checks are in the order of a node.
    pub(super) fn take(&mut self, download: &Download) -> WriteJudgement {
        let key @ (index, sub) = download.entry();
        let object = self.device.object(index).ok_or(ObjectionKind::NoObject)?;
        let entry = object.entry(sub).ok_or(ObjectionKind::NoSubIndex)?;
        if !self.can_be_written(key, object, &entry) {
            return Err(ObjectionKind::NotWritable);
        }
        if entry.flags().refuses_write() || object.main.flags().refuses_write() {
            return Err(ObjectionKind::RefusesDownload);
        }
        let mut doubt = None;
        if let Some(data_type) = EntryType::of(self.device, object, key, &entry).transferred {
            let (length, found) = (data_type.byte_length().map(usize::from), download.data.len());
            if let Some(expected) = length.filter(|&expected| expected != found) {
                return Err(ObjectionKind::Length { data_type, expected, found });
            }
            if let Some(number) = number(&download.data).filter(|_| length.is_some()) {
                check_write(self, index, sub, number)
                    .map_err(|refusal| self.explain(refusal, key, number))?;
                doubt = self.doubt(key, number);
            }
            self.check_value(&entry, data_type, &download.data)?;
        }
        let late = self.judge_order(index);
        self.written.insert(key, download.data.clone());
        Ok(doubt.or(late))
    }

    /// Checks the bytes against a type, and the limits.
    fn check_value(&self, entry: &Entry, data_type: DataType, data: &[u8]) -> Result<(), ObjectionKind> {
        let is_value = match data_type.kind() {
            TypeKind::Boolean => data.iter().all(|&byte| byte <= 1),
            TypeKind::UnicodeString => data.len().is_multiple_of(2),
            _ => true,
        };
        if !is_value {
            return Err(ObjectionKind::NoValue(data_type));
        }
        let value = Value::from_bytes(data, data_type);
        match value.and_then(|value| Some((beyond(entry, &value, self.node_id)?, value))) {
            Some((Beyond::Low(limit), value)) => Err(ObjectionKind::BelowLimit { value, limit }),
            Some((Beyond::High(limit), value)) => Err(ObjectionKind::AboveLimit { value, limit }),
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

    /// The current value of a 32-bit entry; `None` if the node does not have it, or the value is unknown.
    pub(super) fn word(&mut self, (index, sub): EntryKey) -> Option<u32> {
        u32::try_from(Dictionary::number(self, index, sub).ok()?).ok()
    }

    /// The value at power-on: the default, or the stated value of an entry that is never written. Without one
    /// it is 0.
    fn default(&mut self, key @ (index, sub): EntryKey) -> Option<Vec<u8>> {
        let object = self.device.object(index)?;
        let entry = object.entry(sub)?;
        let entry_type = EntryType::of(self.device, object, key, &entry);
        let is_written = self.can_be_written(key, object, &entry);
        let Some(value) = (if is_written { entry.default.as_ref() } else { entry.value() }) else {
            return Some(vec![0; usize::from(entry_type.transferred?.byte_length()?)]);
        };
        let bytes = entry_type.bytes(value, self.node_id);
        if matches!(bytes, Err(ProblemKind::NeedsNodeId(_))) {
            self.unknown.insert(key);
        }
        bytes.ok()
    }

    /// The access type; if missing, that of CiA 301, otherwise that of a generated table.
    fn access(&self, (index, sub): EntryKey, object: &Object, entry: &Entry) -> Access {
        let sub = object.object_type().has_subs().then_some(sub);
        let intended =
            || entry.invalid_values.get(&Field::AccessType).and_then(InvalidValue::intended_access);
        let defined = || objdict_profile::access(self.device, index, sub);
        entry.implied_access().or_else(intended).or_else(defined).unwrap_or(Access::Ro)
    }

    fn can_be_written(&self, key: EntryKey, object: &Object, entry: &Entry) -> bool {
        let object_type = object.object_type();
        let is_definition =
            matches!(object_type, ObjectType::Null | ObjectType::DefType | ObjectType::DefStruct);
        key.0 >= 0x1000 && !is_definition && self.access(key, object, entry).is_writable()
    }
}

/// The dictionary on which the rules of a node operate.
impl Dictionary for AcceptingNode<'_> {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        let object = self.device.object(index).ok_or(Abort::NoObject)?;
        let entry = object.entry(sub).ok_or(Abort::NoSubIndex)?;
        let data_type = EntryType::of(self.device, object, (index, sub), &entry).transferred;
        // values of an unknown type may have any length, like strings
        let fixed = data_type.and_then(|data_type| Some((data_type, usize::from(data_type.byte_length()?))));
        let (data_type, size) = fixed.unwrap_or((DataType::DOMAIN, usize::from(u16::MAX)));
        let access = self.access((index, sub), object, &entry);
        let is_mapped = |kind| entry.is_mappable() && entry.fits_pdo(kind);
        Ok(Attributes {
            size,
            data_type: u8::try_from(data_type.0).unwrap_or(0),
            readable: access.is_readable(),
            writable: self.can_be_written((index, sub), object, &entry),
            fits_tpdo: is_mapped(PdoKind::Tpdo),
            fits_rpdo: is_mapped(PdoKind::Rpdo),
        })
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        if !self.attributes(index, sub)?.readable {
            return Err(Abort::WriteOnly);
        }
        let bytes = match self.written.get(&(index, sub)) {
            Some(written) => written.clone(),
            None => self.default((index, sub)).ok_or(Abort::NoData)?,
        };
        buffer.get_mut(..bytes.len()).ok_or(Abort::OutOfMemory)?.copy_from_slice(&bytes);
        Ok(bytes.len())
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.replace(index, sub, bytes)
    }

    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.written.insert((index, sub), bytes.to_vec());
        Ok(())
    }

    fn restart(&mut self, scope: Scope, _: u8) {
        self.written.retain(|&(index, _), _| !scope.contains(index));
    }

    fn own_node_id(&self) -> Option<u8> {
        self.node_id
    }

    /// The description does not state the services of the device.
    fn serves_more(&self) -> bool {
        true
    }
}

/// The place of an entry as used in reports: the value of a VAR has no sub-index.
pub(super) fn node_place(device: &Device, index: u16, sub: u8) -> Place {
    match device.object(index) {
        Some(object) if sub == 0 && !object.object_type().has_subs() => Place::object(index),
        _ => Place::entry(index, sub),
    }
}

/// Up to eight bytes as a number.
fn number(bytes: &[u8]) -> Option<u64> {
    let mut word = [0; 8];
    word.get_mut(..bytes.len())?.copy_from_slice(bytes);
    Some(u64::from_le_bytes(word))
}

//! A dictionary in a map.

use std::collections::BTreeMap;

use objdict_device::{Abort, Attributes, Dictionary, Scope};

pub(crate) const BOOLEAN: u8 = 1;
pub(crate) const INTEGER16: u8 = 3;
pub(crate) const UNSIGNED8: u8 = 5;
pub(crate) const UNSIGNED16: u8 = 6;
pub(crate) const UNSIGNED32: u8 = 7;
pub(crate) const DOMAIN: u8 = 0x0F;

#[derive(Clone, Default)]
pub(crate) struct Map {
    entries: BTreeMap<(u16, u8), (Attributes, Vec<u8>)>,
    /// The scopes of its restarts.
    pub(crate) restarts: Vec<Scope>,
}

impl Map {
    /// An entry with a number that is readable, writable and mappable.
    pub(crate) fn number(mut self, index: u16, sub: u8, data_type: u8, value: u32) -> Self {
        let size = match data_type {
            UNSIGNED32 => 4,
            INTEGER16 | UNSIGNED16 => 2,
            _ => 1,
        };
        let attributes =
            Attributes { size, data_type, readable: true, writable: true, fits_tpdo: true, fits_rpdo: true };
        self.entries.insert((index, sub), (attributes, value.to_le_bytes()[..size].to_vec()));
        self
    }

    /// A DOMAIN with a capacity of this many bytes.
    pub(crate) fn domain(mut self, index: u16, size: usize, value: &[u8]) -> Self {
        self = self.number(index, 0, DOMAIN, 0);
        let (attributes, bytes) = self.entries.get_mut(&(index, 0)).unwrap();
        attributes.size = size;
        *bytes = value.to_vec();
        self
    }

    /// Changes the attributes of an entry.
    pub(crate) fn with(mut self, index: u16, sub: u8, change: impl FnOnce(&mut Attributes)) -> Self {
        change(&mut self.entries.get_mut(&(index, sub)).unwrap().0);
        self
    }

    pub(crate) fn value(&self, index: u16, sub: u8) -> &[u8] {
        &self.entries[&(index, sub)].1
    }

    /// Sets a value as the application.
    pub(crate) fn set(&mut self, index: u16, sub: u8, value: &[u8]) {
        self.entries.get_mut(&(index, sub)).unwrap().1 = value.to_vec();
    }
}

impl Dictionary for Map {
    fn attributes(&self, index: u16, sub: u8) -> Result<Attributes, Abort> {
        match self.entries.get(&(index, sub)) {
            Some((attributes, _)) => Ok(*attributes),
            None if self.entries.keys().any(|&(other, _)| other == index) => Err(Abort::NoSubIndex),
            None => Err(Abort::NoObject),
        }
    }

    fn read(&mut self, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {
        if !self.attributes(index, sub)?.readable {
            return Err(Abort::WriteOnly);
        }
        let value = self.value(index, sub);
        buffer.get_mut(..value.len()).ok_or(Abort::OutOfMemory)?.copy_from_slice(value);
        Ok(value.len())
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        let attributes = self.attributes(index, sub)?;
        if !attributes.writable {
            Err(Abort::ReadOnly)
        } else if bytes.len() > attributes.size {
            Err(Abort::TooLong)
        } else if bytes.len() < attributes.size && attributes.data_type != DOMAIN {
            Err(Abort::TooShort)
        } else {
            self.set(index, sub, bytes);
            Ok(())
        }
    }

    fn replace(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.attributes(index, sub)?;
        self.set(index, sub, bytes);
        Ok(())
    }

    fn restart(&mut self, scope: Scope, _: u8) {
        self.restarts.push(scope);
    }
}

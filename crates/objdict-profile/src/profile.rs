//! The requirements of one document.

use std::borrow::Cow;

use super::block::{BLOCK, FIRST_INDEX};
use super::facts::ObjectFacts;
use super::tables::Tables;

/// The requirements of a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// The group of the rules that check a device against it: `cia401`; `custom` for a loaded profile.
    pub group: &'static str,
    /// The common name of the document: `CiA 401`.
    pub document: Cow<'static, str>,
    /// Its subject.
    pub title: Cow<'static, str>,
    /// The edition.
    pub version: Option<Cow<'static, str>>,
    /// The device profile number: the low word of 1000h. Without it, the document applies to devices of any
    /// profile.
    pub number: Option<u16>,
    /// Whether a module may contain several of its logical devices, 800h indexes apart (CiA 301 §7.4.1).
    pub repeats: bool,
    /// Its object definitions.
    #[doc(hidden)]
    pub tables: Tables,
}

impl Profile {
    /// The objects, in ascending order of their indexes.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = ObjectFacts<'_>> {
        self.tables.objects.iter().map(|row| ObjectFacts::of(row, &self.tables))
    }

    /// The definition of an object of the first logical device; `None` if it is not defined.
    pub fn object(&self, index: u16) -> Option<ObjectFacts<'_>> {
        let at = self.tables.objects.partition_point(|row| row.last < index);
        let row = self.tables.objects.get(at).filter(|row| row.first <= index);
        row.map(|row| ObjectFacts::of(row, &self.tables))
    }

    /// The definition of the object at `index` for a logical device, numbered from 0. Communication
    /// objects belong to the first logical device.
    pub fn object_in(&self, block: u8, index: u16) -> Option<ObjectFacts<'_>> {
        match block {
            0 => self.object(index),
            _ if index < FIRST_INDEX => None,
            _ => index
                .checked_sub(BLOCK * u16::from(block))
                .filter(|&index| index >= FIRST_INDEX)
                .and_then(|index| self.object(index)),
        }
    }
}

//! Requirements of CiA documents as data: one TOML file per document (`data/`), from which `cargo xtask
//! profiles` generates constants (`constants/`), and custom profiles in the same format. Rules, generators
//! and the command query these tables and contain none of their own.
//!
//! `docs/profiles.md` describes the format.

mod condition;
mod constants;
mod decode;
pub mod default_mapping;
mod facts;
#[cfg(feature = "toml")]
mod load;
mod machine;
mod mask;
#[cfg(feature = "toml")]
mod open;
pub mod standard;
#[doc(hidden)]
pub mod tables;

use std::borrow::Cow;

pub use condition::{Condition, ConditionError};
pub use decode::{bits, meaning, of_object};
pub use facts::{BitField, Confidence, EntryFacts, Mapping, Need, ObjectFacts};
#[cfg(feature = "toml")]
pub use load::ProfileError;
pub use machine::{StateMachine, Transition};
pub use mask::Values;
#[cfg(feature = "toml")]
pub use open::{OpenError, open};
pub use standard::{access, data_type, named, obsolete, standard};
pub use standard::{for_all, of_device, of_number};

use objdict_model::model;
#[cfg(feature = "toml")]
use objdict_model::{diagnostic, source};

use self::tables::Tables;
use crate::model::Device;

/// The first index of profile objects; further logical devices of a module follow at fixed offsets.
const FIRST_INDEX: u16 = 0x6000;
/// Number of indexes of a logical device (CiA 301 §7.4.1).
const BLOCK: u16 = 0x800;
/// Maximum number of logical devices in a module.
pub const MAX_BLOCKS: u8 = 8;

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

    /// The definition of the object at `index` for a logical device, counted from 0. Communication objects
    /// belong to the first logical device.
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

/// Converts an index of the first logical device to another one, counted from 0.
pub const fn index_in(block: u8, index: u16) -> u16 {
    if index < FIRST_INDEX { index } else { index.saturating_add(BLOCK.saturating_mul(block as u16)) }
}

/// The index of a logical device's device type: 1000h or, if it indicates several logical devices (FFFFh in
/// its low word), 67FFh plus multiples of 800h (CiA 301 §7.5.2.1).
pub fn device_type_index(device: &Device, block: u8) -> u16 {
    match device.profile() {
        Some(0xFFFF) => index_in(block, 0x67FF),
        _ => 0x1000,
    }
}

/// The device profile number of a logical device.
pub fn number_of(device: &Device, block: u8) -> Option<u16> {
    let value = device.object(device_type_index(device, block))?.value(0)?.as_integer()?;
    u16::try_from(value & 0xFFFF).ok()
}

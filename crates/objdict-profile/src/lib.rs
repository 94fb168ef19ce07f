//! What documents demand of objects, as data: one TOML file a document (`data/`), of which `cargo xtask profiles` makes
//! constants (`constants/`), and custom profiles, which are read in the same form. Rules, generators and the command
//! ask here and know no table themselves.
//!
//! `docs/profiles.md` describes the form.

mod condition;
mod constants;
mod decode;
pub mod default_mapping;
mod facts;
#[cfg(feature = "toml")]
mod load;
#[cfg(feature = "toml")]
mod open;
pub mod standard;
#[doc(hidden)]
pub mod tables;

use std::borrow::Cow;

pub use condition::{Condition, ConditionError};
pub use decode::{bits, meaning, of_object};
pub use facts::{BitField, EntryFacts, Mapping, Need, ObjectFacts};
#[cfg(feature = "toml")]
pub use load::ProfileError;
#[cfg(feature = "toml")]
pub use open::{OpenError, open};
pub use standard::{for_all, of_number};
pub use standard::{named, obsolete, standard};

use objdict_model::model;
#[cfg(feature = "toml")]
use objdict_model::{diagnostic, source};

use self::tables::Tables;
use crate::model::Device;

/// The index at which the objects of a profile begin; each further logical device of a module lies behind the others.
const FIRST_INDEX: u16 = 0x6000;
/// Indexes that a logical device has (CiA 301 §7.4.1).
const BLOCK: u16 = 0x800;
/// So many logical devices a module may have.
pub const MAX_BLOCKS: u8 = 8;

/// What a document demands of a device.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// The group of the rules that hold a device against it: `cia401`; `custom` for a profile that was loaded.
    pub group: &'static str,
    /// The document as people call it: `CiA 401`.
    pub document: Cow<'static, str>,
    /// What it is about.
    pub title: Cow<'static, str>,
    /// The edition.
    pub version: Option<Cow<'static, str>>,
    /// The device profile number: the low word of 1000h of a device that follows it. Without it, the document is for
    /// devices of any profile.
    pub number: Option<u16>,
    /// Whether a module may have several logical devices of it, 800h indexes apart (CiA 301 §7.4.1).
    pub repeats: bool,
    /// What it says of objects.
    #[doc(hidden)]
    pub tables: Tables,
}

impl Profile {
    /// The objects, in ascending order of their indexes.
    pub fn objects(&self) -> impl ExactSizeIterator<Item = ObjectFacts<'_>> {
        self.tables.objects.iter().map(|row| ObjectFacts::of(row, &self.tables))
    }

    /// What it says of an object of the first logical device; `None` for one that it does not define.
    pub fn object(&self, index: u16) -> Option<ObjectFacts<'_>> {
        let at = self.tables.objects.partition_point(|row| row.last < index);
        let row = self.tables.objects.get(at).filter(|row| row.first <= index);
        row.map(|row| ObjectFacts::of(row, &self.tables))
    }

    /// What it says of an object that a logical device has at `index`, counted from 0. Communication objects belong to
    /// the first.
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

/// The index that an object of the first logical device has in another one, counted from 0.
pub const fn index_in(block: u8, index: u16) -> u16 {
    if index < FIRST_INDEX { index } else { index.saturating_add(BLOCK.saturating_mul(block as u16)) }
}

/// Where the device type of a logical device stands: 1000h or, when that says that there are several (FFFFh in its low
/// word), 67FFh and each 800h behind it (CiA 301 §7.5.2.1).
pub fn device_type_index(device: &Device, block: u8) -> u16 {
    match device.profile() {
        Some(0xFFFF) => index_in(block, 0x67FF),
        _ => 0x1000,
    }
}

/// The device profile number that a logical device states.
pub fn number_of(device: &Device, block: u8) -> Option<u16> {
    let value = device.object(device_type_index(device, block))?.value(0)?.as_integer()?;
    u16::try_from(value & 0xFFFF).ok()
}

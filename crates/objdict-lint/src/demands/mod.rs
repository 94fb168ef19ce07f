//! Compares descriptions with documents: one walk for the rules of all documents. A rule compares the
//! device with the document of its own group (`cia401/…` with CiA 401, `custom/…` with custom profiles), so
//! the groups contain only the pages of the rules, and the checks are here.
//!
//! Custom profiles are therefore checked by the same code as documents of CiA.

#[cfg(feature = "catalogue")]
mod bits;
mod entries;
#[cfg(feature = "catalogue")]
mod mapped;
mod objects;
#[cfg(feature = "catalogue")]
mod presence;
#[cfg(feature = "catalogue")]
mod values;

use std::sync::Arc;

use super::Options;
use crate::diagnostic::{Argument, Sayable, Severity, say};
use crate::model::{Device, Entry, Object, Place};
use crate::profile::{self, Confidence, EntryFacts, MAX_BLOCKS, ObjectFacts, Profile};

pub(crate) use entries::{wrong_access, wrong_data_type, wrong_mapping};
pub(crate) use objects::{sub_0_out_of_range, undefined_sub_index, wrong_object_type};
#[cfg(feature = "catalogue")]
pub(crate) use {
    bits::{reserved_bits, undefined_field_value},
    mapped::mapped_in_wrong_direction,
    presence::{different_channel_count, is_there, misplaced_object, missing_entry, missing_object},
    values::{wrong_default, wrong_value},
};

/// A document that applies to a logical device.
#[derive(Clone, Copy)]
pub(crate) struct Applied<'a> {
    pub profile: &'a Profile,
    /// The logical device, counted from 0.
    pub block: u8,
}

/// An object of the device and its definition in a document.
#[derive(Clone, Copy)]
pub(crate) struct Against<'a> {
    pub device: &'a Device,
    pub applied: Applied<'a>,
    pub index: u16,
    pub object: &'a Object,
    pub facts: ObjectFacts<'a>,
}

/// A described entry and its definition in a document.
#[derive(Clone, Copy)]
pub(crate) struct Expected<'a> {
    pub against: Against<'a>,
    /// The sub-index; `None` for the section of the object.
    pub sub: Option<u8>,
    pub entry: &'a Entry,
    pub facts: EntryFacts<'a>,
}

/// The documents that apply to a device: those for all devices, the one of its device type, and those of
/// the options.
pub(crate) fn applied<'a>(device: &'a Device, options: &'a Options) -> Vec<Applied<'a>> {
    let mut applied = Vec::new();
    let number = profile::number_of(device, 0);
    let of_number = |block: u8, number: Option<u16>| {
        let profile = number.filter(|&number| number != 0).and_then(profile::of_number);
        profile.map(|profile| Applied { profile, block })
    };
    applied.extend(profile::for_all(device).map(|profile| Applied { profile, block: 0 }));
    applied.extend(of_number(0, number));
    for profile in options.profiles.iter().map(Arc::as_ref) {
        if !applied.iter().any(|one| one.profile == profile) {
            applied.push(Applied { profile, block: 0 });
        }
    }
    let is_multiple = device.profile() == Some(0xFFFF);
    for block in 1..MAX_BLOCKS {
        if is_multiple {
            applied.extend(of_number(block, profile::number_of(device, block)));
            continue;
        }
        // several axes with one profile, even if the device type does not state them
        let repeated = applied.iter().filter(|one| one.block == 0 && one.profile.repeats);
        let repeated = repeated.filter(|one| has_block(device, one.profile, block)).copied();
        let repeated: Vec<_> = repeated.map(|one| Applied { block, ..one }).collect();
        applied.extend(repeated);
    }
    applied
}

/// Whether the device has an object that the document defines for a different logical device.
fn has_block(device: &Device, profile: &Profile, block: u8) -> bool {
    let (first, last) = (profile::index_in(block, 0x6000), profile::index_in(block, 0x67FE));
    device.objects.range(first..=last).any(|(&index, _)| profile.object_in(block, index).is_some())
}

/// The maximum severity of a requirement: a source of medium confidence never leads to an error.
pub(crate) fn highest_severity(confidence: Confidence) -> Severity {
    match confidence {
        Confidence::High => Severity::Error,
        Confidence::Medium => Severity::Warning,
    }
}

/// The objects of the device that a document defines.
pub(crate) fn against<'a>(device: &'a Device, applied: &Applied<'a>) -> impl Iterator<Item = Against<'a>> {
    let applied = *applied;
    device.objects.iter().filter_map(move |(&index, object)| {
        let facts = applied.profile.object_in(applied.block, index)?;
        Some(Against { device, applied, index, object, facts })
    })
}

impl Applied<'_> {
    /// The name in messages.
    pub(crate) fn document(&self) -> &str {
        &self.profile.document
    }
}

impl<'a> Against<'a> {
    /// The objects that have as many elements as it, by the document.
    pub(crate) fn counterparts(&self) -> impl Iterator<Item = u16> + use<'a> {
        let (block, facts) = (self.applied.block, self.facts);
        let offset = self.index - profile::index_in(block, facts.first);
        facts.as_many_as.iter().map(move |&index| profile::index_in(block, index) + offset)
    }

    /// The described entries that the document defines; the shared attributes of a compactly stored object
    /// are treated as one entry. There are none if the structure of the object differs from the document.
    pub(crate) fn entries(self) -> impl Iterator<Item = Expected<'a>> {
        let object = self.object;
        let has_header = object.object_type().has_subs() && object.compact.is_none();
        let shared = u8::from(object.compact.is_some());
        let entries = self.has_its_shape().then(|| object.described()).into_iter().flatten();
        entries.filter(move |(sub, _)| sub.is_some() || !has_header).filter_map(move |(sub, entry)| {
            let facts = self.facts.entry(sub.unwrap_or(shared))?;
            Some(Expected { against: self, sub, entry, facts })
        })
    }

    /// Whether the object matches the structure of its definition: sub-indexes or a single value. Rules
    /// about object types report the difference.
    pub(crate) fn has_its_shape(&self) -> bool {
        let (object, facts) = (self.object, self.facts);
        let is_alike =
            !facts.states_type() || object.object_type().has_subs() == facts.object_type().has_subs();
        !object.orphan && is_alike
    }
}

/// `1017h (Producer heartbeat time)`.
impl Sayable for Against<'_> {
    fn argument(&self) -> Argument {
        say!("{:04X}h ({})", self.index, self.facts.name).argument()
    }
}

impl Expected<'_> {
    pub(crate) fn place(&self) -> Place {
        Place::at(self.against.index, self.sub)
    }

    /// The name of the document in messages.
    pub(crate) fn document(&self) -> &str {
        self.against.applied.document()
    }

    /// The field that contains the value of the entry.
    #[cfg(feature = "catalogue")]
    pub(crate) fn value_field(&self) -> crate::model::Field {
        match self.entry.configured_value() {
            Some(_) => crate::model::Field::ParameterValue,
            None => crate::model::Field::DefaultValue,
        }
    }

    /// Whether the entry is sub-index 0 of an object with sub-indexes: their number, for which there
    /// are separate rules.
    pub(crate) fn counts(&self) -> bool {
        self.sub == Some(0) && self.against.object.object_type().has_subs()
    }
}

/// `1018h sub-index 1`.
impl Sayable for Expected<'_> {
    fn argument(&self) -> Argument {
        match self.sub {
            Some(sub) => say!("{:04X}h sub-index {}", self.against.index, sub).argument(),
            None => say!("{:04X}h", self.against.index).argument(),
        }
    }
}

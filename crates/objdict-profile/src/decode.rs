//! Meanings of bits as text, and masks for several values of a bit field with the same meaning.

use std::collections::BTreeMap;
use std::ops::{Range, RangeInclusive};

use super::standard::{OF_MANAGERS, below_profiles, has_object_of_managers};
use super::{BitFieldFacts, EntryFacts, ObjectFacts, Profile, of_number};
use crate::model::{DataType, Device, Value};

impl EntryFacts<'_> {
    /// The meaning of a number as defined by the document: bit fields with their meaning, and the names of
    /// single bits that are set. Negative numbers use two's complement. `None` if nothing is defined.
    pub fn meaning(&self, number: i128) -> Option<String> {
        // there are no fields beyond 64 bits
        let value = (number & i128::from(u64::MAX)) as u64;
        // a bit that decides the meaning of a wider field is said by it
        let decides = |bit: BitFieldFacts<'_>, field: BitFieldFacts<'_>| {
            let (own, other) = (field.meaning(value), value ^ 1 << bit.first);
            let is_within = field.first <= bit.first && bit.last <= field.last;
            field.first < field.last && is_within && own.is_some() && own != field.meaning(other)
        };
        let is_said =
            |bit: BitFieldFacts<'_>| bit.first == bit.last && self.bits().any(|field| decides(bit, field));
        let parts = self.bits().filter_map(|field| part(field, value).filter(|_| !is_said(field)));
        let parts: Vec<String> = parts.collect();
        match parts.is_empty() {
            true if self.bits().len() == 0 => None,
            true => Some("no bit is set".to_owned()),
            false => Some(parts.join(", ")),
        }
    }
}

/// The meaning of a bit field; `None` if it is 0 and has no meaning for 0.
fn part(field: BitFieldFacts<'_>, value: u64) -> Option<String> {
    let number = field.of(value);
    match (field.meaning(value), number) {
        (Some(meaning), _) => Some(format!("{}: {meaning}", field.name)),
        (None, 0) => None,
        (None, _) if field.first == field.last => Some(field.name.to_owned()),
        (None, _) => Some(format!("{}: {number}", field.name)),
    }
}

/// The manufacturer-specific area of the dictionary (CiA 301 §7.4.1).
const MANUFACTURER: Range<u16> = 0x2000..0x6000;

/// The definitions of an object in the documents that apply to a device: its device profile, then those for
/// all devices. Each is the definition for the logical device of `index`.
pub fn of_object(
    device: &Device,
    index: u16,
) -> impl Iterator<Item = (&'static Profile, ObjectFacts<'static>)> {
    // CiA documents do not define manufacturer-specific objects
    let blocks = if MANUFACTURER.contains(&index) { 0..0 } else { 0..super::MAX_BLOCKS };
    let is_composed = device.profile() == Some(0xFFFF);
    let of_block = |block| super::number_of(device, block).and_then(of_number);
    let only = if is_composed || blocks.is_empty() { None } else { of_block(0) };
    let own = blocks.clone().filter_map(move |block| {
        let profile = if is_composed { of_block(block) } else { only };
        let profile = profile.filter(|profile| block == 0 || profile.repeats)?;
        Some((profile, profile.object_in(block, index)?))
    });
    // an object of the managers also belongs to CiA 302 in a device that has no other of them
    let is_manager = OF_MANAGERS.iter().any(|range| range.contains(&index)) || has_object_of_managers(device);
    let for_it = below_profiles(is_manager).filter(move |_| !blocks.is_empty());
    own.chain(for_it.filter_map(move |profile| Some((profile, profile.object(index)?))))
}

/// The name and the data type in the first document that defines this entry.
pub fn entry(device: &Device, index: u16, sub: u8) -> Option<(&'static str, Option<DataType>)> {
    let (object, facts) =
        of_object(device, index).find_map(|(_, object)| Some((object, object.entry(sub)?)))?;
    let name = if facts.name.is_empty() { object.name } else { facts.name };
    Some((name, facts.data_types.first().copied()))
}

/// The bit fields of an entry in several documents, the lowest first: all of the first document, and from the
/// others only those for undefined bits.
pub fn bits<'a>(documents: impl IntoIterator<Item = ObjectFacts<'a>>, sub: u8) -> Vec<BitFieldFacts<'a>> {
    let mut fields: Vec<BitFieldFacts<'a>> = Vec::new();
    for entry in documents.into_iter().filter_map(|facts| facts.entry(sub)) {
        let is_new = |field: &BitFieldFacts<'_>| {
            fields.iter().all(|known| field.last < known.first || known.last < field.first)
        };
        let new: Vec<_> = entry.bits().filter(is_new).collect();
        fields.extend(new);
    }
    fields.sort_by_key(|field| field.first);
    fields
}

/// The meaning of an entry's bits in the documents that apply to the device. For CiA 301, `Decoder` of
/// `objdict-document` provides it in sentences.
pub fn meaning(device: &Device, index: u16, sub: u8, value: &Value) -> Option<String> {
    let number = value.as_integer()?;
    let documents = of_object(device, index).filter(|(profile, _)| profile.group != "cia301");
    documents.filter_map(|(_, facts)| facts.entry(sub)?.meaning(number)).next()
}

/// The values of a bit field with one meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Values {
    /// One value, or one range.
    Range(RangeInclusive<u64>),
    /// Its bits, the highest first: `x01x 0111`. An `x` may be 0 or 1.
    Mask(String),
}

impl<'a> BitFieldFacts<'a> {
    /// The meanings in ascending order; single values with the same meaning become a mask if it matches
    /// exactly these.
    pub fn masked(&self) -> Vec<(Values, &'a str)> {
        let is_single = |range: &RangeInclusive<u64>| range.start() == range.end();
        let mut singles: BTreeMap<&str, Vec<u64>> = BTreeMap::new();
        for (range, name) in self.meanings().filter(|(range, _)| is_single(range)) {
            singles.entry(name).or_default().push(*range.start());
        }
        let masks: BTreeMap<&str, (u64, String)> = singles
            .into_iter()
            .filter_map(|(name, values)| Some((name, (*values.first()?, self.mask(&values)?))))
            .collect();
        let shown = self.meanings().filter_map(|(range, name)| match masks.get(name) {
            Some((first, mask)) if is_single(&range) => {
                (range.start() == first).then(|| (Values::Mask(mask.clone()), name))
            }
            _ => Some((Values::Range(range), name)),
        });
        shown.collect()
    }

    /// The mask that matches exactly these values; `None` for a single value, or if there is none.
    fn mask(&self, values: &[u64]) -> Option<String> {
        let all = values.iter().fold(u64::MAX, |bits, value| bits & value);
        let free = values.iter().fold(0, |bits, value| bits | value) & !all;
        if values.len() < 2 || u32::try_from(values.len()) != Ok(1 << free.count_ones().min(31)) {
            return None;
        }
        let bits = u32::from(self.last - self.first) + 1;
        // documents write a word from its lowest bit in groups of four
        let shown = if self.first == 0 { bits.next_multiple_of(4) } else { bits };
        let mut mask = String::new();
        for bit in (0..shown).rev() {
            mask.push(match () {
                () if bit >= bits || free >> bit & 1 == 1 => 'x',
                () if all >> bit & 1 == 1 => '1',
                () => '0',
            });
            mask.push_str(if bit > 0 && bit % 4 == 0 { " " } else { "" });
        }
        Some(mask)
    }
}

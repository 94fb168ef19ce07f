//! The order of sections in a description and of keys in a section, as in the canonical text.
//!
//! The writer, the formatter and fixes that add sections use the same order.

use std::sync::LazyLock;

use super::keys::FieldKey;
use crate::model::{Field, ModulePart, ObjectList, Part};

/// The position of a section. Unknown sections come last, in their original order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Rank {
    /// The subject: the file, the device, the modules, the objects of a list.
    group: u16,
    /// The index of the object; 0 for sections before all objects of the group.
    index: u16,
    /// The kind of section of the object.
    kind: u8,
    /// The sub-index.
    sub: u8,
}

const MODULES: u16 = 10;
/// The definitions of data types, which need no list.
const TYPES: u16 = u16::MAX - 5;
const MANDATORY: u16 = u16::MAX - 4;
const OPTIONAL: u16 = u16::MAX - 3;
const MANUFACTURER: u16 = u16::MAX - 2;
const OTHERS: u16 = u16::MAX;

impl Rank {
    /// The rank of the section of a part.
    pub(super) fn of(part: &Part) -> Self {
        let general = |group| Self { group, index: 0, kind: 0, sub: 0 };
        match *part {
            Part::FileInfo => general(1),
            Part::DeviceInfo => general(2),
            Part::DummyUsage => general(3),
            Part::Comments => general(4),
            Part::Commissioning => general(5),
            Part::DynamicChannels => general(6),
            Part::Tools => general(7),
            // tools are numbered by their order
            Part::Tool(_) => general(8),
            Part::SupportedModules => general(9),
            Part::Module(number, part) => module(number, part),
            Part::ConnectedModules => general(TYPES - 1),
            Part::List(list) => general(group_of_list(list)),
            Part::Object(index) => object(index, 1, 0),
            Part::Entry(index, sub) => object(index, 2, sub),
            Part::CompactNames(index) => object(index, 3, 0),
            Part::CompactValues(index) => object(index, 4, 0),
            Part::CompactDenotations(index) => object(index, 5, 0),
            Part::Links(index) => object(index, 6, 0),
            _ => general(OTHERS),
        }
    }

    /// Whether the standard defines the section.
    pub(super) fn is_known(self) -> bool {
        self.group != OTHERS
    }
}

const fn group_of_list(list: ObjectList) -> u16 {
    match list {
        ObjectList::Mandatory => MANDATORY,
        ObjectList::Optional => OPTIONAL,
        ObjectList::Manufacturer => MANUFACTURER,
    }
}

fn object(index: u16, kind: u8, sub: u8) -> Rank {
    Rank { group: ObjectList::of(index).map_or(TYPES, group_of_list), index, kind, sub }
}

/// Modules in the order of their numbers, each followed by its parts.
fn module(number: u16, part: ModulePart) -> Rank {
    let group = MODULES.saturating_add(number).min(TYPES - 2);
    let rank = |kind, index, sub| Rank { group, index, kind, sub };
    match part {
        ModulePart::Info => rank(0, 0, 0),
        ModulePart::Comments => rank(1, 0, 0),
        ModulePart::FixedObjects => rank(2, 0, 0),
        ModulePart::Fixed(index) => rank(3, index, 0),
        ModulePart::FixedEntry(index, sub) => rank(4, index, sub),
        // after all fixed objects
        ModulePart::SubExtends => rank(5, u16::MAX, 0),
        ModulePart::SubExt(index) => rank(6, u16::MAX, (index >> 8) as u8),
    }
}

/// The keys of objects in canonical order; other sections use the order of [`Field::NAMED`].
const OBJECT_KEYS: [Field; 20] = [
    Field::ParameterName,
    Field::ObjectType,
    Field::SubNumber,
    Field::DataType,
    Field::AccessType,
    Field::DefaultValue,
    Field::PdoMapping,
    Field::LowLimit,
    Field::HighLimit,
    Field::ObjFlags,
    Field::CompactSubObj,
    Field::Count,
    Field::ObjExtend,
    Field::SrdoMapping,
    Field::InvertedSrad,
    Field::ParameterValue,
    Field::Denotation,
    Field::UploadFile,
    Field::DownloadFile,
    Field::ParamRefd,
];

/// The keys that contain the number of the items after them.
pub(super) const COUNTERS: [Field; 6] = [
    Field::SupportedObjects,
    Field::NrOfEntries,
    Field::ObjectLinks,
    Field::Lines,
    Field::NrOfSeg,
    Field::Items,
];

/// The key with the number of items in a section.
pub(super) fn counter_of(part: &Part) -> Option<Field> {
    match part {
        Part::List(_) => Some(Field::SupportedObjects),
        Part::Links(_) => Some(Field::ObjectLinks),
        Part::ConnectedModules
        | Part::CompactNames(_)
        | Part::CompactValues(_)
        | Part::CompactDenotations(_)
        | Part::Module(_, ModulePart::FixedObjects | ModulePart::SubExtends) => Some(Field::NrOfEntries),
        _ => None,
    }
}

/// The ranks of the defined keys by number.
static RANKS: LazyLock<Vec<u32>> = LazyLock::new(|| {
    let rank = |(number, (_, field)): (usize, &(&str, Field))| match COUNTERS.contains(field) {
        true => 0,
        false => {
            let of_object = OBJECT_KEYS.iter().position(|other| other == field);
            u32::try_from(of_object.unwrap_or(number) + 1).unwrap_or(u32::MAX)
        }
    };
    Field::NAMED.iter().enumerate().map(rank).collect()
});

/// The rank of a defined key in its section.
pub(super) fn field_rank(key: FieldKey) -> u32 {
    RANKS[key.number()]
}

/// The rank of a key in its section; `None` for a key without a defined position.
pub(super) fn key_rank(name: &str) -> Option<u32> {
    if let Some(key) = FieldKey::find(name) {
        return Some(field_rank(key));
    }
    let digits = name.len() - name.bytes().rev().take_while(u8::is_ascii_digit).count();
    let is_numbered = matches!(&name[..digits], "") || name[..digits].eq_ignore_ascii_case("Line");
    let number: Option<u32> = name.get(digits..).and_then(|number| number.parse().ok());
    number.filter(|_| is_numbered).map(|number| number.saturating_add(1000))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sections_have_the_order_of_the_canonical_text() {
        let parts = [
            Part::FileInfo,
            Part::DeviceInfo,
            Part::Comments,
            Part::SupportedModules,
            Part::Module(1, ModulePart::Info),
            Part::Module(1, ModulePart::FixedEntry(0x2000, 1)),
            Part::Module(1, ModulePart::SubExtends),
            Part::Module(2, ModulePart::Info),
            Part::ConnectedModules,
            Part::Object(0x60),
            Part::List(ObjectList::Mandatory),
            Part::Object(0x1018),
            Part::List(ObjectList::Optional),
            Part::Object(0x1003),
            Part::Entry(0x1003, 0),
            Part::Entry(0x1003, 10),
            Part::CompactValues(0x1003),
            Part::Object(0x6000),
            Part::List(ObjectList::Manufacturer),
            Part::Object(0x2000),
            Part::Section("tooldata".into()),
        ];
        assert!(parts.windows(2).all(|pair| Rank::of(&pair[0]) < Rank::of(&pair[1])));
    }

    #[test]
    fn keys_have_the_order_of_the_canonical_text() {
        let keys = ["SupportedObjects", "1", "2", "10"];
        let object = ["ParameterName", "ObjectType", "subnumber", "DataType", "PDOMapping", "Denotation"];
        for keys in [&keys[..], &object, &["FileName", "EDSVersion", "LastEDS"]] {
            assert!(keys.windows(2).all(|pair| key_rank(pair[0]) < key_rank(pair[1])), "{keys:?}");
        }
        assert_eq!(key_rank("ToolKey"), None);
    }
}

//! What CiA 311 and an EDS call the same, where the schema names no field for it.

use crate::model::{Access, Field, ObjectList, ParameterAccess};
use crate::xml::{Name, n};

/// The attribute that counts the objects of a list.
pub(crate) const fn count_attribute(list: ObjectList) -> Name {
    match list {
        ObjectList::Mandatory => n::mandatoryObjects,
        ObjectList::Optional => n::optionalObjects,
        ObjectList::Manufacturer => n::manufacturerObjects,
    }
}

/// The keys of an EDS for attributes of a channel, without its number.
const CHANNEL_KEYS: [(Name, &str); 4] =
    [(n::dataType, "Type"), (n::accessType, "Dir"), (n::startIndex, "Range"), (n::addressOffset, "PPOffset")];

/// The attribute of a channel for a key without its number.
pub(crate) fn channel_attribute(word: &str) -> Name {
    CHANNEL_KEYS.iter().find(|(_, key)| *key == word).map_or_else(|| Name::of(word), |(name, _)| *name)
}

/// The field of an attribute of a channel. An EDS has one field for both ends of the range.
pub(crate) fn channel_field(name: Name, number: usize) -> Field {
    let key = CHANNEL_KEYS.iter().find(|(known, _)| *known == name && name != n::startIndex);
    Field::Named(format!("{}{number}", key.map_or(name.text(), |(_, key)| key)).into())
}

/// `accessType` of a channel, and `DirN` of an EDS.
pub(crate) const DIRECTIONS: [(&str, &str); 3] =
    [("readOnly", "ro"), ("writeOnly", "wo"), ("readWriteOutput", "rww")];

/// The number of indexes in a range, which is the default for the number of objects of a channel.
pub(crate) fn range_length(range: Option<(u16, u16)>) -> Option<u32> {
    range.map(|(first, last)| u32::from(last.saturating_sub(first)) + 1)
}

/// The field of a bit rate that does not exist.
pub(crate) fn supported_field() -> Field {
    Field::Named("supportedBaudRate".into())
}

/// The field of the bit rate of a new device.
pub(crate) fn default_rate_field() -> Field {
    Field::Named("defaultBaudRate".into())
}

/// The number of the given indexes that `CANopenObjectList` counts in a list. Definitions of data types
/// count as optional objects, because they have no count of their own.
pub(crate) fn count<'a>(indexes: impl Iterator<Item = &'a u16>, list: ObjectList) -> usize {
    indexes.filter(|&&index| ObjectList::of(index).unwrap_or(ObjectList::Optional) == list).count()
}

/// The access type as a parameter spells it.
pub(crate) const fn written_access(access: Access) -> ParameterAccess {
    match access {
        Access::Const => ParameterAccess::Const,
        Access::Ro => ParameterAccess::Read,
        Access::Wo => ParameterAccess::Write,
        Access::Rw => ParameterAccess::ReadWrite,
        Access::Rwr => ParameterAccess::ReadWriteInput,
        Access::Rww => ParameterAccess::ReadWriteOutput,
    }
}

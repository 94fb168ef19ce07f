//! Placeholders for content that the standard requires and the model lacks. The reader recognises and
//! drops them.

use crate::model::{
    Access, Characteristic, CharacteristicsList, DeviceFunction, Field, Label, Labels, ObjectList,
    ParameterAccess, ProfileHeader,
};
use crate::xml::{Name, n};

/// How a reader treats placeholders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Placeholders {
    /// Ignores them.
    Dropped,
    /// They are values, as for a tool that does not know them.
    Kept,
}

impl Placeholders {
    /// Whether placeholders are ignored.
    pub(crate) const fn are_dropped(self) -> bool {
        matches!(self, Self::Dropped)
    }
}

/// A missing string: the author of the file, the vendor, the product.
pub(crate) const NOT_STATED: &str = "not stated";

/// The name of a file without a name.
pub(crate) const FILE_NAME: &str = "unnamed.xdd";

/// The creation date of a file without one.
pub(crate) const DATE: &str = "1970-01-01";

/// The bit rate of a device that supports none: the standard's default. It is written twice.
pub(crate) const BIT_RATE: &str = "250 Kbps";

/// The index of the only object of a device without objects: CiA 301 does not use it.
pub(crate) const INDEX: &str = "0000";

/// The property of a parameter whose type is a placeholder, with [`NOT_STATED`] as its value.
pub(crate) const TYPE_PROPERTY: &str = "objdict:type";

/// The vendor-ID and product code, which version 1.0 always has.
pub(crate) const ID: &str = "0x000";

/// The object code of an entry without one: VAR. Placeholder numbers have a leading zero, which other tools
/// ignore.
pub(crate) const OBJECT_TYPE: &str = "07";

/// The object code of an object that is described only by its sub-indexes: RECORD.
pub(crate) const ORPHAN: &str = "09";

/// A missing number: the granularity, the node-ID, the network number.
pub(crate) const NUMBER: &str = "00";

/// A missing Boolean: false, with a leading space that other tools ignore.
pub(crate) const FLAG: &str = " false";

/// The missing name of a node or network.
pub(crate) const NAME: &str = " ";

/// The language of names without one.
pub(crate) const LANGUAGE: &str = "en";

/// The header of a profile without one, as CANopenEditor writes it.
pub(crate) fn header(identification: &str) -> ProfileHeader {
    ProfileHeader {
        identification: identification.into(),
        revision: "1.1".into(),
        ..ProfileHeader::default()
    }
}

/// The description of a product without one, which version 1.0 always has.
pub(crate) fn product_text() -> Labels {
    Labels(vec![Label::Description { lang: LANGUAGE.into(), text: NOT_STATED.into(), uri: None }])
}

/// The function of a device without one.
pub(crate) fn function() -> DeviceFunction {
    let label = |text: &str| Labels::name(LANGUAGE, text);
    let characteristic = Characteristic { name: label("Communication"), contents: vec![label("CANopen")] };
    let list =
        CharacteristicsList { characteristics: vec![characteristic], ..CharacteristicsList::default() };
    DeviceFunction { characteristics: vec![list], ..DeviceFunction::default() }
}

/// Whether the functions contain only placeholders.
pub(crate) fn is_function_invented(functions: &[DeviceFunction]) -> bool {
    let empty = DeviceFunction::default();
    functions.iter().all(|function| *function == empty) || functions == [function()]
}

/// The attribute with the number of objects in a list.
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

/// The field of an attribute of a channel. An EDS has one field for both range limits.
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

/// The number of the given indexes in `CANopenObjectList` that belong to a list. Definitions of data
/// types are counted as optional objects, because they have no separate count.
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

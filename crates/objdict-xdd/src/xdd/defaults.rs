//! Placeholders for what the standard requires and the model does not have. The reader recognises them and
//! drops them.

use crate::model::{Characteristic, CharacteristicsList, DeviceFunction, Label, Labels, ProfileHeader};

/// What a reader makes of placeholders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Placeholders {
    /// They say nothing.
    Dropped,
    /// They are values, as for a tool that does not know them.
    Kept,
}

impl Placeholders {
    /// Whether a text that is a placeholder says nothing.
    pub(crate) const fn are_dropped(self) -> bool {
        matches!(self, Self::Dropped)
    }
}

/// A missing text: the author of the file, the vendor, the product.
pub(crate) const NOT_STATED: &str = "not stated";

/// The name of a file without a name.
pub(crate) const FILE_NAME: &str = "unnamed.xdd";

/// The creation date of a file without one.
pub(crate) const DATE: &str = "1970-01-01";

/// The bit rate of a device that supports none: the default of the standard. It is written twice.
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

/// A missing Boolean: false, with a leading blank that other tools ignore.
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

/// The text about a product without one, which version 1.0 always has.
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

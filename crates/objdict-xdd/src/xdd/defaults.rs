//! What the writer says where the standard demands something and the model has nothing. The reader knows these texts and takes
//! them for nothing.

use super::layout::ProfileClass;
use crate::model::{Characteristic, CharacteristicsList, DeviceFunction, Labels, ProfileHeader};

/// A text that nobody stated: who made the file, the vendor, the product.
pub(crate) const NOT_STATED: &str = "not stated";

/// The name of a file that has none.
pub(crate) const FILE_NAME: &str = "unnamed.xdd";

/// The day on which a file was made that does not say when.
pub(crate) const DATE: &str = "1970-01-01";

/// The bit rate in kbit/s of a device that supports none: the one that the standard takes for the default.
pub(crate) const BIT_RATE: u16 = 250;

/// The object code of an entry that does not state it: VAR. Numbers that nobody stated have a leading zero, which means
/// nothing to others.
pub(crate) const OBJECT_TYPE: &str = "07";

/// The object code of an object that is only described by its sub-indexes: RECORD.
pub(crate) const ORPHAN: &str = "09";

/// A number that nobody stated: the granularity, the node-ID, the number of the network.
pub(crate) const NUMBER: &str = "00";

/// A truth value that nobody stated: no, with a blank that means nothing to others.
pub(crate) const FLAG: &str = " false";

/// The name of a node or network that nobody stated.
pub(crate) const NAME: &str = " ";

/// The language of names that are not said to be of one.
pub(crate) const LANGUAGE: &str = "en";

/// The header of a profile that has none, as CANopenEditor writes it.
pub(crate) fn header(class: ProfileClass) -> ProfileHeader {
    let identification = match class {
        ProfileClass::Device => "CANopen device profile",
        ProfileClass::Network => "CANopen communication network profile",
    };
    ProfileHeader {
        identification: identification.into(),
        revision: "1.1".into(),
        ..ProfileHeader::default()
    }
}

/// What a device does that does not say it.
pub(crate) fn function() -> DeviceFunction {
    let label = |text: &str| Labels::name(LANGUAGE, text);
    let characteristic = Characteristic { name: label("Communication"), contents: vec![label("CANopen")] };
    let list =
        CharacteristicsList { characteristics: vec![characteristic], ..CharacteristicsList::default() };
    DeviceFunction { characteristics: vec![list], ..DeviceFunction::default() }
}

/// Whether functions say nothing that a description has to say.
pub(crate) fn is_function_invented(functions: &[DeviceFunction]) -> bool {
    let empty = DeviceFunction::default();
    functions.iter().all(|function| *function == empty) || functions == [function()]
}

//! What description files say to the generators of CANopenNode.

use super::part::{part, words};

part! {
    /// How a device stack shall store and treat an object or entry: `CO_` properties of an XDD, or comments such as
    /// `;StorageLocation=RAM` of an EDS, as CANopenEditor writes them.
    pub struct StackOptions {
        /// `CO_storageGroup`, `StorageLocation`: the group of variables that are stored together, such as `RAM` or
        /// `PERSIST_COMM`.
        pub storage_group: Option<Box<str>>,
        /// `CO_countLabel`: the macro that counts objects of this kind, such as `TPDO`.
        pub count_label: Option<Box<str>>,
        /// `CO_disabled`: the object is described and not generated.
        pub disabled: Option<bool>,
        /// `CO_accessSRDO`: which SRDOs may carry the entry.
        pub srdo_access: Option<SrdoAccess>,
        /// `CO_stringLengthMin`: the room of a string in characters, where the default is shorter.
        pub min_string_length: Option<u32>,
        /// `CO_flagsPDO`: whether a change of the value triggers its TPDO.
        pub detects_change: Option<bool>,
        /// `CO_extensionIO`: whether the application handles reading and writing.
        pub io_extension: Option<bool>,
    }
}

words! {
    /// Which SRDOs may carry an entry.
    pub enum SrdoAccess {
        /// None.
        No = "no",
        /// Those that the device sends.
        Tx = "tx",
        /// Those that it receives.
        Rx = "rx",
        /// Both.
        Trx = "trx",
    }
}

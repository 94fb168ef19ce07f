//! The requirements of a document for an object or entry, and their certainty.

use super::condition::Condition;

/// Whether an object or entry is mandatory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need<'a> {
    /// Optional.
    Optional,
    /// Mandatory.
    Mandatory,
    /// Mandatory under a condition.
    When(&'a Condition),
}

objdict_model::named! {
    /// The PDOs that may map an entry.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Mapping {
        /// None.
        No = "no",
        /// TPDOs.
        Tpdo = "tpdo",
        /// RPDOs.
        Rpdo = "rpdo",
        /// Both.
        Any = "any",
    }
}

/// The reliability of a source.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Confidence {
    /// The document itself, or two sources that agree.
    #[default]
    High,
    /// One secondary source, or dependent on the edition.
    Medium,
}

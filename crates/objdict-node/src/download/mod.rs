//! The SDO downloads that configure a node, in an order that devices accept, and the concise DCF stream that
//! contains them (CiA 302-3, object 1F22h).
//!
//! [`ConciseDcf::plan`] derives them from a device description and reports entries that are left out. This
//! module does not read files: a DOMAIN with data in a file stays a [`Step::File`] until
//! [`Plan::into_concise`] reads it.

mod difference;
mod effective;
mod order;
mod plan;
mod planning;
mod problem;
mod rebase;
mod settings;
mod stream;
mod transfer;
mod verify;

use std::fmt;

use crate::model::hex;
#[cfg(feature = "serde")]
use crate::model::{hex_number, hex_text};

pub use difference::{Difference, Differences};
pub use effective::effective;
pub use plan::{NeededFile, Order, Plan, PlanOptions, Scope, Step};
pub use problem::{PlanError, Problem, ProblemKind, SkipReason, Skipped};
pub use stream::{DecodeError, DecodeErrorKind, EncodeError};
pub use transfer::{Beyond, beyond, bytes_of, transferred_type};
pub use verify::{AbortCode, Objection, ObjectionKind, Verification};

/// One SDO download: an entry and the transferred bytes.
#[derive(Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Download {
    /// Index of the object.
    #[cfg_attr(feature = "serde", serde(with = "hex_number"))]
    #[cfg_attr(feature = "schema", schemars(with = "crate::model::HexText<u16>"))]
    pub index: u16,
    /// Sub-index of the entry.
    #[cfg_attr(feature = "serde", serde(with = "hex_number"))]
    #[cfg_attr(feature = "schema", schemars(with = "crate::model::HexText<u8>"))]
    pub sub: u8,
    /// The value: little-endian, text without terminator.
    #[cfg_attr(feature = "serde", serde(with = "hex_text"))]
    #[cfg_attr(feature = "schema", schemars(with = "crate::model::HexBytes"))]
    pub data: Vec<u8>,
}

/// Downloads in the order of transmission. An entry may be written more than once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct ConciseDcf(pub Vec<Download>);

impl Download {
    /// Creates a download.
    pub fn new(index: u16, sub: u8, data: impl Into<Vec<u8>>) -> Self {
        Self { index, sub, data: data.into() }
    }
}

/// Format: `1017:00 FA00`.
impl fmt::Debug for Download {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}:{:02X} {}", self.index, self.sub, hex::print(&self.data))
    }
}

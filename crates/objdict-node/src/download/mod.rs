//! What must be written into a node to configure it: the SDO downloads in an order that a device accepts, and the
//! concise DCF stream that carries them (CiA 302-3, object 1F22h).
//!
//! [`ConciseDcf::plan`] looks at a device description and says what to write, and why something is left out. It knows no files: a
//! DOMAIN whose data come from a file stays a [`Step::File`] until [`Plan::into_concise`] reads it.

mod difference;
mod order;
mod plan;
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
pub use plan::{NeededFile, Plan, PlanOptions, Scope, Step};
pub use problem::{PlanError, Problem, ProblemKind, SkipReason, Skipped};
pub use stream::{DecodeError, DecodeErrorKind, EncodeError};
pub(crate) use transfer::{Beyond, beyond};
pub use transfer::{bytes_of, transferred_type};
pub use verify::{AbortCode, Objection, ObjectionKind, Verification};

/// One SDO download: bytes for an entry, as the transfer carries them.
#[derive(Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Download {
    /// Index of the object.
    #[cfg_attr(feature = "serde", serde(with = "hex_number"))]
    pub index: u16,
    /// Sub-index of the entry.
    #[cfg_attr(feature = "serde", serde(with = "hex_number"))]
    pub sub: u8,
    /// The value: little-endian, text without terminator.
    #[cfg_attr(feature = "serde", serde(with = "hex_text"))]
    pub data: Vec<u8>,
}

/// Downloads in the order in which a node gets them. The same entry may be written more than once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(transparent))]
pub struct ConciseDcf(pub Vec<Download>);

impl Download {
    /// A download of these bytes.
    pub fn new(index: u16, sub: u8, data: impl Into<Vec<u8>>) -> Self {
        Self { index, sub, data: data.into() }
    }
}

/// As in `1017:00 FA00`.
impl fmt::Debug for Download {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}:{:02X} {}", self.index, self.sub, hex::print(&self.data))
    }
}

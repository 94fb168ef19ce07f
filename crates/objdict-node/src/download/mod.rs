//! The SDO downloads that configure a node, in an order that devices accept, and the concise DCF stream that
//! contains them (CiA 302-3, object 1F22h).
//!
//! [`ConciseDcf::plan`] derives them from a device description and reports skipped entries. This module
//! does not read files: a DOMAIN with data in a file remains a [`Step::File`] until [`Plan::into_concise`]
//! reads it.

mod difference;
mod order;
mod plan;
mod planning;
mod problem;
mod rebase;
mod settings;
mod stream;
mod transfer;
mod verify;

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;

use self::settings::is_command;
use crate::model::{Assignment, Device, ExplicitDownload, Moment, Value, hex};
#[cfg(feature = "serde")]
use crate::model::{hex_number, hex_text};
pub use difference::{Difference, Differences};
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
    /// The value: little-endian, strings without terminator.
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

    /// Index and sub-index.
    pub const fn entry(&self) -> (u16, u8) {
        (self.index, self.sub)
    }
}

/// Format: `1017:00 FA00`.
impl fmt::Debug for Download {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}:{:02X} {}", self.index, self.sub, hex::print(&self.data))
    }
}

/// Which of several downloads are the last ones of their entries, so that their values remain.
pub fn remaining(downloads: &[Download]) -> Vec<bool> {
    let mut entries = BTreeSet::new();
    let mut remaining: Vec<bool> =
        downloads.iter().rev().map(|download| entries.insert(download.entry())).collect();
    remaining.reverse();
    remaining
}

/// The effective dictionary of a described node: its configured values, overridden by its
/// [downloads](Device::downloads) in their order. A download before the values is effective only if the description
/// does not configure the entry.
pub fn effective(device: &Device) -> Cow<'_, Device> {
    if device.downloads.is_empty() {
        return Cow::Borrowed(device);
    }
    let is_configured = |index, sub| {
        device.entry(index, sub).is_some_and(|entry: Cow<'_, _>| entry.configured_value().is_some())
    };
    let last = |download: &&ExplicitDownload| {
        let is_covered = download.when == Moment::Before && is_configured(download.index, download.sub);
        !is_command(download.index) && !is_covered
    };
    let assignment = |ExplicitDownload { index, sub, value, .. }: &ExplicitDownload| Assignment {
        index: *index,
        sub: *sub,
        value: value.clone(),
    };
    let of = |when| device.downloads.iter().filter(move |download| download.when == when);
    let values: Vec<Assignment> =
        of(Moment::Before).chain(of(Moment::After)).filter(last).map(assignment).collect();
    let mut device = device.clone();
    device.assign(&values);
    Cow::Owned(device)
}

impl Download {
    /// The bytes as a value of the entry; `None` if they are not valid for its data type.
    pub fn value(&self, device: &Device) -> Option<Value> {
        Value::from_bytes(&self.data, transferred_type(device, self.index, self.sub)?)
    }

    /// The value of the entry after the download; `None` if the bytes are not valid for its data type, or only start an
    /// action, such as 1010h (store).
    pub fn assignment(&self, device: &Device) -> Option<Assignment> {
        let value = self.value(device).filter(|_| !is_command(self.index))?;
        Some(Assignment { index: self.index, sub: self.sub, value })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_download_of_an_entry_remains() {
        let [first, other, last] = [(0x1800, 1), (0x1800, 2), (0x1800, 1)].map(|(index, sub)| Download {
            index,
            sub,
            data: vec![sub],
        });
        assert_eq!(remaining(&[first, other, last]), [false, true, true]);
        assert!(remaining(&[]).is_empty());
    }
}

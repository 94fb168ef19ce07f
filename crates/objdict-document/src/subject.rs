//! What is documented.

use std::collections::BTreeMap;

use super::finding::Finding;
use crate::model::Device;

/// The documented device with its context.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// The device.
    pub device: &'a Device,
    /// The file name shown to readers.
    pub file: &'a str,
    /// The format of the file: `EDS`, `DCF`, `XDD`, `XDC`, `JSON`.
    pub format: &'a str,
    /// The findings of `check`; `None` if it did not run.
    pub findings: Option<&'a [Finding]>,
    /// Identifiers in generated code; empty if unknown.
    pub identifiers: &'a Identifiers,
}

/// Identifiers of objects (no sub-index) and entries in generated code.
pub type Identifiers = BTreeMap<(u16, Option<u8>), CodeName>;

/// The identifiers of an object or an entry in generated code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CodeName {
    /// The constant in Rust: `od::identity_object::VENDOR_ID`.
    pub rust: String,
    /// The macro in C: `OD_IDENTITY_OBJECT_VENDOR_ID`.
    pub c: String,
}

//! The keys of a patch.

use crate::patch::words::FIELDS;
use objdict_keyed::notation::{ADDRESS, PART, SHA256};
use objdict_keyed::section::{Key, Shape, bits, key};

/// The value that identifies a file as a patch.
pub(super) const FORMAT: &str = "objdict-patch/1";

const REASON: &str = "Why: for readers, and for the vendor.";
const SOURCE: &str = "The evidence: a manual with its page, or a measurement.";

pub(super) const PATCH: &[Key] = &[
    key("format", Shape::Word(&[FORMAT]), "What the file is; the first key.").required(),
    key("title", Shape::Text, "What the patch is for."),
    key("vendor-id", bits(32), "The vendor-ID (1018h:01, else `VendorNumber`) of the files that it is for."),
    key("product-code", bits(32), "Their product code (1018h:02, else `ProductNumber`)."),
    key(
        "revision",
        Shape::IntegerOr(0, u32::MAX as i128, "any"),
        "Their revision number (1018h:03, else `RevisionNumber`), or `any` (default).",
    ),
    key("sha256", Shape::Spelled(SHA256), "The hash of the patched file; any other file is an error."),
    key("change", Shape::List(CHANGE), "The changes, made one after the other."),
    key("raw", Shape::List(RAW), "Changes for which there are no words, made after the others."),
];

pub(super) const CHANGE: &[Key] = &[
    key(
        "at",
        Shape::Spelled(PART),
        "An object (`2001`), an entry (`2001:3`), `file`, `device` or `commissioning`.",
    )
    .required(),
    key(
        "expect",
        Shape::Map(FIELDS),
        "The current content of the file. Any other content is an error: the vendor changed it.",
    ),
    key("absent", Shape::Texts, "Fields that the file does not state now."),
    key("set", Shape::Map(FIELDS), "What the fields become."),
    key("unset", Shape::Texts, "Fields that are removed."),
    key("add", Shape::Map(FIELDS), "An object or entry that is missing, with its fields."),
    key("remove", Shape::Flag, "`true` removes the object or entry."),
    key("rename", Shape::Spelled(ADDRESS), "The true index, or index and sub-index, of the object or entry."),
    key("reason", Shape::Text, REASON),
    key("source", Shape::Text, SOURCE),
];

pub(super) const RAW: &[Key] = &[
    key("path", Shape::Text, "A JSON pointer into the JSON of the device (docs/reference/json.md).")
        .required(),
    key("expect", Shape::Text, "The current value as JSON; without it, the file has no value there."),
    key("set", Shape::Text, "The new value as JSON; without it, the current value is removed."),
    key("reason", Shape::Text, REASON),
    key("source", Shape::Text, SOURCE),
];

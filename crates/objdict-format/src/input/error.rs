//! The reason why a file is not read.

use std::error::Error;
use std::num::NonZeroUsize;

use super::{FileKind, MAX_DEVICES};
use crate::identify::Identification;
use objdict_model::diagnostic::{counted, series};
use objdict_model::source::{FolderError, SourceError};

/// The reason why a file is not read.
#[derive(Debug)]
#[non_exhaustive]
pub enum ReadError {
    /// It cannot be opened, or is too large.
    Source(SourceError),
    /// Another file refers to it, and it may not be read.
    Named(FolderError),
    /// It belongs to a different technology, or is a CANopen file that objdict cannot read.
    Foreign {
        /// The file.
        name: String,
        /// The detected format.
        found: Box<Identification>,
    },
    /// Its objects in compact storage have more entries than allowed.
    TooManyEntries {
        /// The file.
        name: String,
        /// How many.
        count: usize,
        /// The limit.
        limit: usize,
    },
    /// It has more sections, elements, objects or values than allowed.
    TooManyParts {
        /// The file.
        name: String,
        /// `sections`, `elements`, `objects` or `values`.
        what: &'static str,
        /// How many.
        count: usize,
        /// The limit.
        limit: usize,
    },
    /// Its content is malformed, and the format cannot skip that: JSON, concise DCF, a node list.
    Content {
        /// The file.
        name: String,
        /// The problem.
        error: Box<dyn Error + Send + Sync>,
    },
    /// It describes several devices, and none is selected.
    SeveralDevices {
        /// The file.
        name: String,
        /// How many.
        count: usize,
    },
    /// It has fewer devices than the requested number.
    NoSuchDevice {
        /// The file.
        name: String,
        /// The number, counted from 1.
        number: NonZeroUsize,
        /// How many it describes.
        count: usize,
    },
    /// It describes, alone or with other files, more devices than a network can have.
    TooManyDevices {
        /// The file, or the last of several.
        name: String,
        /// How many.
        count: usize,
    },
    /// It has no variant of this name.
    NoSuchVariant {
        /// The file.
        name: String,
        /// The missing variant.
        variant: String,
        /// The existing variants.
        known: Vec<String>,
    },
    /// It is a file of CANopen that describes no device.
    NoDevice {
        /// The file.
        name: String,
        /// The format as which it was read.
        kind: FileKind,
    },
    /// A patch is for it and cannot be made.
    NotPatched {
        /// The file.
        name: String,
        /// The problems: the patch with line and column, the rule and the message, a line each.
        problems: String,
    },
    /// It is an objdict source, and its text has errors.
    Faulty {
        /// The file.
        name: String,
        /// The errors: the file with line and column, the rule and the message, a line each.
        problems: String,
    },
    /// It is of a kind that this build of the library does not read.
    NotBuilt {
        /// The file.
        name: String,
        /// The format of the file.
        kind: FileKind,
    },
}

objdict_model::error_messages! { ReadError:
    from SourceError as Source
    from FolderError as Named
{
    Self::Source(error) => "{error}";
    Self::Named(error) => "{error}";
    Self::Foreign { name, found } => "`{name}` {}", found.verdict();
    Self::TooManyEntries { name, count, limit } =>
        "`{name}` has {count} entries in compact storage, more than the limit of {limit}";
    Self::TooManyParts { name, what, count, limit } =>
        "`{name}` has {count} {what}, more than the limit of {limit}";
    Self::Content { name, error } => "cannot read `{name}`: {error}";
    Self::SeveralDevices { name, count } => "`{name}` describes {count} devices";
    Self::NoSuchDevice { name, number, count } =>
        "`{name}` has no device {number}; it describes {}", counted(*count, "device", "devices");
    Self::TooManyDevices { name, count } =>
        "`{name}`: {count} devices, but a network has at most {MAX_DEVICES}";
    Self::NoSuchVariant { name, variant, .. } => "`{name}` has no variant `{variant}`";
    Self::NoDevice { name, kind } => "`{name}` is read as {} and does not describe a device", kind.name();
    Self::NotPatched { name, problems } => "cannot apply the patches to `{name}`\n{problems}";
    Self::Faulty { name, problems } => "`{name}` has errors, so no output is created\n{problems}";
    Self::NotBuilt { name, kind } =>
        "`{name}` is read as {}, which this build of objdict cannot read", kind.name();
} }

impl ReadError {
    /// How to fix the error, if known.
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Source(SourceError::Directory { path }) => {
                Some(format!("name files, such as `{path}/*.eds`"))
            }
            Self::Named(error) => error.help().map(str::to_owned),
            Self::Foreign { found, .. } => found.advice().map(str::to_owned),
            Self::SeveralDevices { .. } => Some("choose one by its number, counted from 1".to_owned()),
            Self::NoSuchVariant { known, .. } if known.is_empty() => {
                Some("only a `device.toml` with `[variant.…]` has variants".to_owned())
            }
            Self::NoSuchVariant { known, .. } => {
                Some(format!("it has {}", series(known.iter().map(|name| format!("`{name}`")))))
            }
            Self::NoDevice { .. } => Some("name an EDS or DCF".to_owned()),
            Self::NotPatched { .. } => Some("`objdict patch check` compares patches with files".to_owned()),
            Self::Faulty { name, .. } => Some(format!("`objdict check {name}` shows them in the text")),
            Self::NotBuilt { kind, .. } => {
                let feature = kind.feature()?;
                Some(format!("enable the feature `{feature}` of the crate `objdict`"))
            }
            Self::Source(_)
            | Self::TooManyEntries { .. }
            | Self::TooManyParts { .. }
            | Self::TooManyDevices { .. }
            | Self::Content { .. }
            | Self::NoSuchDevice { .. } => None,
        }
    }
}

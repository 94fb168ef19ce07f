//! Description files: what a file is, and from its bytes to the model.

pub(crate) mod carried;
mod configured;
mod description;
pub mod identify;
pub mod input;
pub mod json;
pub mod nodelist;
mod write;

use std::path::Path;

pub use self::configured::{Configured, NodeSettings};
pub use self::description::Description;
use self::identify::Identification;
use self::identify::identify_source;
pub use self::write::{Fate, Loss, WriteOptions, Written};
use crate::diagnostic::{Findings, RuleInfo};
use crate::model::Device;
pub use crate::source::EditError;
use crate::source::{Encoding, SourceError, SourceFile, SourceOptions};
pub(crate) use objdict_eds::eds;
pub use objdict_eds::eds::Style;
pub use objdict_eds::ini;
pub use objdict_model::{Format, Syntax, literal};
pub use objdict_node::concise;
pub(crate) use objdict_xdd::xdd;
pub use objdict_xdd::xdd::XddVersion;
pub use objdict_xdd::xml;

/// Why a file is no description.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// It could not be opened.
    #[error(transparent)]
    Source(#[from] SourceError),
    /// It is something else: a look-alike of another technology, or a file of CANopen that describes no device.
    #[error("`{name}` {}", .found.verdict())]
    Foreign {
        /// The file.
        name: String,
        /// What it is.
        found: Box<Identification>,
    },
}

impl ReadError {
    /// What to do about it, where that is known.
    pub fn help(&self) -> Option<&'static str> {
        match self {
            Self::Source(_) => None,
            Self::Foreign { found, .. } => found.advice(),
        }
    }
}

/// Reads the file at `path` as what its content shows it to be ([`identify()`](identify::identify)). Where that is not
/// known, as in a damaged file, the name decides, and an unknown name is taken for an EDS.
///
/// # Errors
/// When the file cannot be opened, or is something else for certain. What is wrong in a description is among the findings.
pub fn open(path: &Path, options: &SourceOptions) -> Result<Description, ReadError> {
    let source = SourceFile::open(path, options)?;
    let found = identify_source(&source);
    match found.format(source.name()) {
        Some(format) => Ok(read(source, format)),
        None => Err(ReadError::Foreign { name: source.name().to_owned(), found: Box::new(found) }),
    }
}

/// Reads a source in a format.
pub fn read(source: SourceFile, format: Format) -> Description {
    Description::read(source, format)
}

/// The canonical text of a device that has no source: as an EDS without what was configured for a node, as a DCF with it.
/// With it comes what the text does not give back: the differences of the device and what is read of the text.
pub fn write(device: &Device, format: Format, options: &WriteOptions) -> Written {
    write::write(device, format, options)
}

/// What a text of a format, in an encoding, does not give back of the device that it was made of.
pub fn losses(device: &Device, bytes: &[u8], format: Format, encoding: Encoding) -> Vec<Loss> {
    write::losses(device, bytes, format, encoding)
}

/// What is wrong with the structure of an XML document, held against CiA 311: all rules of the group `cia311`. A document
/// without a container of CiA 311 has none to be held against.
pub fn check_structure(tree: &xml::Tree) -> Findings {
    let mut findings = Findings::new();
    xdd::findings::check(tree, &mut findings);
    findings
}

/// The rules that the readers raise themselves.
pub(crate) fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    ini::findings::RULES
        .iter()
        .chain(literal::RULES)
        .chain(xml::findings::RULES)
        .chain(eds::findings::RULES)
        .chain(eds::portability::RULES)
        .chain(carried::RULES)
        .copied()
        .chain(xdd::findings::rules())
}

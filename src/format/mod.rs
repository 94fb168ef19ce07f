//! Description files: what a file is, and from its bytes to the model.

pub(crate) mod carried;
pub mod concise;
pub(crate) mod eds;
pub mod identify;
pub mod ini;
pub mod json;
pub mod literal;
pub mod nodelist;
mod write;
pub mod xml;

use std::path::Path;
use std::sync::OnceLock;

use self::eds::Locator;
use self::identify::Identification;
use self::identify::identify_source;
use self::ini::{Document, EditError};
pub use self::write::{Fate, Loss, WriteOptions, Written};
use crate::diagnostic::{At, Findings, RuleInfo};
use crate::model::{Commissioning, Device, DeviceKind, Place};
use crate::source::{SourceError, SourceFile, SourceOptions, Span};

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Electronic data sheet: a type of device (CiA 306-1).
    Eds,
    /// Device configuration file: a node (CiA 306-1).
    Dcf,
}

impl Format {
    /// The format of a file name: what its last known ending says, so `drive.eds.txt` is an EDS.
    pub fn from_name(name: &str) -> Option<Self> {
        name.rsplit('.').find_map(|ending| match ending.to_ascii_lowercase().as_str() {
            "eds" => Some(Self::Eds),
            "dcf" => Some(Self::Dcf),
            _ => None,
        })
    }

    /// What a file of this format describes.
    pub const fn kind(self) -> DeviceKind {
        match self {
            Self::Eds => DeviceKind::Type,
            Self::Dcf => DeviceKind::Node,
        }
    }

    /// What the format is called.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eds => "EDS",
            Self::Dcf => "DCF",
        }
    }
}

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

/// A description that was read: the device, the text that it came from, and what the reader found.
#[derive(Debug)]
pub struct Description {
    format: Format,
    document: Document,
    device: Device,
    findings: Findings,
    locator: OnceLock<Locator>,
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
    let document = Document::new(source);
    let (mut device, mut findings) = eds::read(&document, format.kind());
    carried::restore(&mut device, &mut findings);
    eds::file_name::check(&device, document.source().name(), &mut findings);
    Description { format, document, device, findings, locator: OnceLock::new() }
}

/// The canonical text of a device that has no source: as an EDS without what was configured for a node, as a DCF with it.
/// With it comes what the text does not give back: the differences of the device and what is read of the text.
pub fn write(device: &Device, format: Format, options: &WriteOptions) -> Written {
    write::write(device, format, options)
}

impl Description {
    /// The format that it was read as.
    pub fn format(&self) -> Format {
        self.format
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        self.document.source()
    }

    /// The text as lines.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// The device, without its text.
    pub fn into_device(self) -> Device {
        self.device
    }

    /// Where a place of the model stands in the text; `None` for what has no text.
    pub fn locate(&self, place: &Place) -> Option<Span> {
        self.locator.get_or_init(|| Locator::new(&self.document)).locate(&self.document, place)
    }

    /// Where a label points in the text; the start of the text for what has none.
    pub fn span_of(&self, at: &At) -> Span {
        match at {
            At::Span(span) => *span,
            At::Place(place) => self.locate(place).unwrap_or_default(),
        }
    }

    /// The bytes of this text as a DCF called `file_name`, for `node`: edits of the text, so comments, order, spelling,
    /// line ends and encoding stay. `LastEDS` is the name that the text was read by, unless it is a DCF already.
    ///
    /// # Errors
    /// When an edited text cannot be written in the encoding of the file.
    pub fn to_dcf(&self, file_name: &str, node: &Commissioning) -> Result<Vec<u8>, EditError> {
        let last_eds = self.source().name().rsplit(['/', '\\']).next();
        let last_eds = last_eds.filter(|_| self.device.kind == DeviceKind::Type);
        eds::to_dcf(&self.document, file_name, last_eds, node)
    }

    /// The bytes of this text as an EDS called `file_name`: without the node and the values that were configured for it.
    ///
    /// # Errors
    /// When an edited text cannot be written in the encoding of the file.
    pub fn to_eds(&self, file_name: &str) -> Result<Vec<u8>, EditError> {
        eds::to_eds(&self.document, file_name)
    }

    /// What the reader of the format found: in the spelling and structure of the text.
    pub fn findings(&self) -> &Findings {
        &self.findings
    }

    /// What the lines of the text show, healthy or not; not looked for until it is asked for.
    pub fn line_findings(&self) -> Findings {
        let mut findings = Findings::new();
        ini::findings::check(&self.document, &mut findings);
        findings
    }
}

/// The rules that the readers raise themselves.
pub(crate) fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    ini::findings::RULES.iter().chain(eds::findings::RULES).chain(carried::RULES).copied()
}

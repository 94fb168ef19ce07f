//! Reads any input file of commands and build scripts: detects its format and parses its content.
//!
//! Memory depends on the number of the smallest parts, so sections, elements and JSON values are counted in the
//! text before they are read. The limits grow with the file; real files do not reach them.

#[cfg(feature = "full")]
mod content;
mod error;
mod kind;

use std::borrow::Cow;
use std::num::NonZeroUsize;
use std::path::Path;

pub use self::error::ReadError;
pub use self::kind::FileKind;
use super::identify::{ContentKind, identify_source};
#[cfg(feature = "full")]
use super::patch::Patch;
use super::{Description, Format, Syntax};
use objdict_model::diagnostic::Findings;
#[cfg(feature = "full")]
use objdict_model::diagnostic::{Diagnostic, Severity};
use objdict_model::model::Device;
use objdict_model::source::{self, DEFAULT_MAX_SIZE, Encoding, SourceError, SourceFile, SourceOptions};

/// The content of a file.
#[derive(Debug)]
pub enum Input {
    /// A device as text: EDS, DCF, XDD or XDC.
    Description(Box<Description>),
    /// A device as JSON.
    Device(Box<Device>),
    /// The downloads of a concise DCF, as a stream, text or JSON.
    #[cfg(feature = "full")]
    Concise(objdict_node::download::ConciseDcf),
    /// The nodes of networks.
    #[cfg(feature = "node-list")]
    NodeList(objdict_model::model::NodeList),
}

/// The default limit of entries in compact storage: a conversion needs 1.5 kB for each; real devices have a
/// few thousand.
pub const DEFAULT_MAX_ENTRIES: usize = 25_000;

/// The number of bytes per additional entry in compact storage, section or element, beyond the
/// [allowed](Reading::max_entries) number: those of real descriptions are longer.
const BYTES_PER_PART: usize = 64;
const VALUES_PER_PART: usize = 16;

/// The number of bytes per additional object, which needs a few kilobytes in pages, tables and differences:
/// real devices have hundreds.
const BYTES_PER_OBJECT: usize = 256;
const ENTRIES_PER_OBJECT: usize = 4;

/// The number of values per allowed entry, for the limits of parts that need less memory.
pub(crate) const VALUES_PER_ENTRY: usize = 10;

const NOT_A_NODE: &str = "it describes an EtherCAT device, not a CANopen node; if the device also supports CANopen, ask the vendor for an EDS or XDD";

/// A file with several devices is a network, which has at most 127 node-IDs.
pub const MAX_DEVICES: usize = 127;

/// The findings of each device of a file.
pub type SourceCheck = fn(&Description) -> Vec<Findings>;

/// The findings of the text reader for each device; no rules are run.
pub fn of_text(description: &Description) -> Vec<Findings> {
    description.map_devices(|device| device.findings().clone())
}

/// Options for reading a file.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Its format; `None` detects it.
    pub from: Option<FileKind>,
    /// The device of a network file (`.nxdd`, `.nxdc`), counted from 1.
    pub device: Option<NonZeroUsize>,
    /// The encoding; `None` detects it.
    pub encoding: Option<Encoding>,
    /// The maximum size in bytes, at most 1 GiB.
    pub max_size: u64,
    /// The maximum number of entries in compactly stored objects (`CompactSubObj`), plus one per 64 bytes, because
    /// generated output contains each of them. JSON may have ten times as many values, plus one per 16 bytes; a text
    /// may have a sixteenth of it as sections or elements, plus one per 64 bytes. A device may have a quarter of it as
    /// objects, plus one per 256 bytes.
    pub max_entries: usize,
    /// Whether it must be a CANopen node, which an EtherCAT device is not.
    pub is_node: bool,
    /// Whether a JSON device keeps disabled objects, for writing it again.
    pub keep_disabled: bool,
    /// The node for which formulas in the text of a concise DCF are evaluated.
    pub node_id: Option<u8>,
    /// The variant of a `device.toml`; `None` for the device without variants.
    pub variant: Option<String>,
    /// The check whose errors reject a `device.toml`; `None` reads it despite errors, for example for editing.
    pub judge: Option<SourceCheck>,
    /// Patches, which are applied to the descriptions that they select.
    #[cfg(feature = "full")]
    pub patches: Vec<std::sync::Arc<Patch>>,
}

impl Default for Reading {
    fn default() -> Self {
        let (max_size, max_entries) = (DEFAULT_MAX_SIZE, DEFAULT_MAX_ENTRIES);
        Self {
            from: None,
            device: None,
            encoding: None,
            max_size,
            max_entries,
            node_id: None,
            variant: None,
            is_node: false,
            keep_disabled: false,
            judge: Some(of_text),
            #[cfg(feature = "full")]
            patches: Vec::new(),
        }
    }
}

impl Reading {
    /// Reads a file; returns its format and content.
    ///
    /// # Errors
    /// If it cannot be read at all; see [`ReadError`]. Problems in a description are among its findings.
    pub fn open(&self, path: &Path) -> Result<(FileKind, Input), ReadError> {
        self.read(&source::shown(path), source::read(path, self.max_size)?)
    }

    /// Reads the bytes of a file of this name; returns its format and content.
    ///
    /// # Errors
    /// See [`open`](Self::open).
    pub fn read(&self, name: &str, bytes: Vec<u8>) -> Result<(FileKind, Input), ReadError> {
        let (kind, source) = self.recognised(name, bytes)?;
        let bytes = source.text().len();
        if kind.format().is_some_and(|format| format.syntax() == Syntax::Ini) {
            // examining only the text needs little memory per section
            let count = memchr::memmem::find_iter(source.text().as_bytes(), "\n[").count();
            self.limited_parts(name, "sections", count, bytes)?;
        }
        let input = match kind.format() {
            Some(format) => Input::Description(Box::new(self.described(source, format)?)),
            #[cfg(feature = "full")]
            None => self.content(kind, &source)?,
            #[cfg(not(feature = "full"))]
            None => return Err(ReadError::NotBuilt { name: name.to_owned(), kind }),
        };
        self.limited(name, &input, bytes)?;
        let input = match input {
            Input::Device(device) if !self.keep_disabled => match device.without_disabled() {
                Cow::Owned(enabled) => Input::Device(Box::new(enabled)),
                Cow::Borrowed(_) => Input::Device(device),
            },
            input => input,
        };
        #[cfg(feature = "full")]
        if let Input::Description(description) = &input {
            self.refuse(description)?;
        }
        Ok((kind, input))
    }

    /// The description of a source, or of the requested variant, with the applicable patches.
    ///
    /// # Errors
    /// If there is no such variant.
    pub fn described(&self, source: SourceFile, format: Format) -> Result<Description, ReadError> {
        self.described_after(source, format, None)
    }

    /// Like [`described`](Self::described), based on the description of an earlier text of the file; see
    /// [`read_after`](super::read_after).
    ///
    /// # Errors
    /// If there is no such variant.
    #[doc(hidden)] // for the language server
    pub fn described_after(
        &self,
        source: SourceFile,
        format: Format,
        before: Option<&Description>,
    ) -> Result<Description, ReadError> {
        let description = super::read_after(source, format, before);
        let description = match &self.variant {
            Some(variant) => {
                let (name, variant) = (description.source().name().to_owned(), variant.clone());
                let selected = description.into_variant(&variant);
                selected.map_err(|known| ReadError::NoSuchVariant { name, variant, known })?
            }
            None => description,
        };
        #[cfg(feature = "full")]
        let description = super::patch::apply(description, &self.patches);
        Ok(description)
    }

    /// Rejects a text with too many sections or elements before reading it, because each needs more memory than its
    /// text. A large text may have more.
    fn limited_parts(
        &self,
        name: &str,
        what: &'static str,
        count: usize,
        bytes: usize,
    ) -> Result<(), ReadError> {
        let (name, limit) = (name.to_owned(), self.max_values() / VALUES_PER_PART + bytes / BYTES_PER_PART);
        if count > limit { Err(ReadError::TooManyParts { name, what, count, limit }) } else { Ok(()) }
    }

    const fn max_values(&self) -> usize {
        self.max_entries.saturating_mul(VALUES_PER_ENTRY)
    }

    /// Rejects a device that would need too much memory when expanded, for a text of this many bytes.
    fn limited(&self, name: &str, input: &Input, bytes: usize) -> Result<(), ReadError> {
        let device = match input {
            Input::Description(description) => description.device(),
            Input::Device(device) => &**device,
            #[cfg(feature = "full")]
            _ => return Ok(()),
        };
        let (name, count) = (name.to_owned(), device.compact_entries());
        if self.is_node && device.is_ethercat() {
            return Err(ReadError::Content { name, error: NOT_A_NODE.into() });
        }
        let limit = self.max_entries.saturating_add(bytes / BYTES_PER_PART);
        if count > limit {
            return Err(ReadError::TooManyEntries { name, count, limit });
        }
        let (count, what) = (device.objects.len(), "objects");
        let limit = self.max_entries / ENTRIES_PER_OBJECT + bytes / BYTES_PER_OBJECT;
        if count > limit { Err(ReadError::TooManyParts { name, what, count, limit }) } else { Ok(()) }
    }

    /// Like [`read`](Self::read), but selects the requested one of several devices.
    ///
    /// # Errors
    /// Like [`open`](Self::open), and if there is no such device, or there are several and none was
    /// requested.
    pub fn read_one(&self, name: &str, bytes: Vec<u8>) -> Result<(FileKind, Input), ReadError> {
        let (kind, input) = self.read(name, bytes)?;
        Ok(match input {
            Input::Description(description) => {
                (kind, Input::Description(Box::new(self.select(name, *description)?)))
            }
            input => (kind, input),
        })
    }

    /// The requested device of a file: the only one, or the one with the requested number.
    ///
    /// # Errors
    /// If there is no such device, or there are several and none was requested.
    pub fn select(&self, name: &str, description: Description) -> Result<Description, ReadError> {
        let count = description.device_count();
        let position = self.number(name, count)?;
        let number = NonZeroUsize::MIN.saturating_add(position);
        let selected = description.select(position);
        let selected =
            selected.ok_or_else(|| ReadError::NoSuchDevice { name: name.to_owned(), number, count })?;
        #[cfg(feature = "full")]
        self.refuse(&selected)?;
        Ok(selected)
    }

    /// The position of the requested device, in a file of this many.
    pub fn number(&self, name: &str, count: usize) -> Result<usize, ReadError> {
        let name = name.to_owned();
        match self.device {
            None if count == 1 => Ok(0),
            None => Err(ReadError::SeveralDevices { name, count }),
            Some(number) if number.get() <= count => Ok(number.get() - 1),
            Some(number) => Err(ReadError::NoSuchDevice { name, number, count }),
        }
    }

    /// The source in the bytes of a file.
    ///
    /// # Errors
    /// If there are too many bytes.
    pub fn source(&self, name: &str, bytes: Vec<u8>) -> Result<SourceFile, SourceError> {
        let options = SourceOptions { encoding: self.encoding, max_size: self.max_size };
        SourceFile::from_bytes(name, bytes, &options)
    }

    /// The source in the bytes of a file, and its format: as requested, otherwise from its content, otherwise from its
    /// name.
    ///
    /// # Errors
    /// If objdict cannot read the format: [`ReadError::Foreign`]; if there are too many bytes.
    pub fn recognised(&self, name: &str, bytes: Vec<u8>) -> Result<(FileKind, SourceFile), ReadError> {
        let source = self.source(name, bytes)?;
        let kind = match self.from {
            Some(kind) => kind,
            None => self::kind(&source)?,
        };
        let is_xml = kind.format().is_some_and(|format| format.syntax() == Syntax::Xml);
        if is_xml && !cfg!(feature = "xdd") || kind == FileKind::Esi && !cfg!(feature = "esi") {
            return Err(ReadError::NotBuilt { name: name.to_owned(), kind });
        }
        if kind == FileKind::Toml {
            if !cfg!(feature = "full") {
                return Err(ReadError::NotBuilt { name: name.to_owned(), kind });
            }
            // the tree of a text needs 200 times its memory; the longest one generated from a real
            // description has 450 kB
            let (path, size, limit) = (name.to_owned(), source.text().len() as u64, source::MAX_TOML_SIZE);
            if size > limit {
                return Err(SourceError::TooLarge { path, size, limit }.into());
            }
            // the parser needs a kilobyte for each table, including dotted keys
            let tables = memchr::memchr3_iter(b'{', b'[', b'.', source.text().as_bytes()).count();
            self.limited_parts(name, "tables", tables, source.text().len())?;
        }
        if is_xml {
            self.limited_parts(name, "elements", start_tags(source.text()), source.text().len())?;
            let count = containers(source.text());
            if count > MAX_DEVICES {
                return Err(ReadError::TooManyDevices { name: name.to_owned(), count });
            }
        }
        Ok((kind, source))
    }

    /// Rejects a description that a selected patch does not fit, and a source with errors, whose result would not be as
    /// intended. Vendor descriptions are read unchanged.
    #[cfg(feature = "full")]
    fn refuse(&self, description: &Description) -> Result<(), ReadError> {
        if let Some(patched) = description.patched().filter(|patched| patched.has_errors()) {
            let name = description.source().name().to_owned();
            return Err(ReadError::NotPatched { name, problems: patched.lines().join("\n") });
        }
        let judge = self.judge.filter(|_| description.format() == Format::Toml);
        let Some(judge) = judge else { return Ok(()) };
        // no configuration can accept unreadable content
        refuse_errors(description, of_text(description))?;
        refuse_errors(description, judge(description))
    }
}

/// Rejects a `device.toml` with errors among the findings of its devices.
///
/// # Errors
/// [`ReadError::Faulty`] with the errors.
#[cfg(feature = "full")]
pub fn refuse_errors(description: &Description, findings: Vec<Findings>) -> Result<(), ReadError> {
    let is_error = |finding: &&Diagnostic| finding.severity == Severity::Error;
    let has_errors = findings.iter().any(|findings| findings.iter().any(|finding| is_error(&finding)));
    if description.format() != Format::Toml || !has_errors {
        return Ok(());
    }
    // a variant repeats the errors of the file
    let mut problems: Vec<String> = Vec::new();
    let mut findings = findings.into_iter();
    description.map_devices(|device| {
        let found = findings.next().unwrap_or_default();
        for line in
            found.iter().filter(is_error).map(|error| error.line(device.source(), |at| device.span_of(at)))
        {
            if !problems.contains(&line) {
                problems.push(line);
            }
        }
    });
    if problems.is_empty() {
        return Ok(());
    }
    Err(ReadError::Faulty { name: description.source().name().to_owned(), problems: problems.join("\n") })
}

/// The format of a source.
fn kind(source: &SourceFile) -> Result<FileKind, ReadError> {
    let found = identify_source(source);
    match found.kind.file() {
        Some(kind) => Ok(kind),
        None => {
            let named = FileKind::of(Path::new(source.name())).filter(|_| found.kind == ContentKind::Unknown);
            named
                .filter(|&kind| kind.feature().is_some() && has_syntax(kind, source.text()))
                .ok_or_else(|| ReadError::Foreign { name: source.name().to_owned(), found: Box::new(found) })
        }
    }
}

/// Whether a text without evidence of its format has at least the syntax that its name implies, so that its errors can
/// be reported.
fn has_syntax(kind: FileKind, text: &str) -> bool {
    match kind.format().map(Format::syntax) {
        Some(Syntax::Ini) => {
            let is_binary = |c: char| c.is_control() && !matches!(c, '\t' | '\r' | '\n' | '\x0C' | '\x1A');
            let has_sign = |line: &str| {
                let key = line.split_once('=').map(|(key, _)| key.trim_end());
                let is_key = |key: &str| !key.is_empty() && key.bytes().all(|b| b.is_ascii_alphanumeric());
                line.starts_with(['[', ';']) || key.is_some_and(is_key)
            };
            !text.contains(is_binary) && text.lines().any(|line| has_sign(line.trim_start()))
        }
        Some(Syntax::Xml) => text.trim_start().starts_with('<'),
        // it is identified by its first key, and other TOML is a different format
        Some(Syntax::Toml) => false,
        // their readers report the mistakes
        None => true,
    }
}

/// Reads the description at `path` in the format detected from its content ([`identify()`](super::identify::identify)).
/// If that is unknown, as in a malformed file, the name decides. If the file has several devices, returns the first.
///
/// # Errors
/// If the file cannot be opened, or is not a description. Problems in a description are among the findings.
pub fn open(path: &Path, options: &SourceOptions) -> Result<Description, ReadError> {
    let reading = Reading { encoding: options.encoding, max_size: options.max_size, ..Reading::default() };
    let name = source::shown(path);
    let (kind, source) = reading.recognised(&name, source::read(path, options.max_size)?)?;
    match kind.format() {
        Some(format) => Ok(super::read(source, format)),
        None => Err(ReadError::NoDevice { name, kind }),
    }
}

/// How many tags start an element.
fn start_tags(text: &str) -> usize {
    let bytes = text.as_bytes();
    let starts = |&at: &usize| bytes.get(at + 1).is_some_and(|next| !matches!(next, b'/' | b'!' | b'?'));
    memchr::memchr_iter(b'<', bytes).filter(starts).count()
}

/// How many tags start the description of a device.
fn containers(text: &str) -> usize {
    const NAME: &str = "ISO15745ProfileContainer";
    const MAX_PREFIX: usize = 64;
    let starts = |&at: &usize| {
        let before = &text.as_bytes()[at.saturating_sub(MAX_PREFIX)..at];
        let tag = before.iter().rposition(|byte| matches!(byte, b'<' | b'/' | b'>' | b' ' | b'\n'));
        tag.is_some_and(|tag| before[tag] == b'<')
    };
    memchr::memmem::find_iter(text.as_bytes(), NAME).filter(starts).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_known_ending_counts() {
        let kind = |name| FileKind::of(Path::new(name));
        assert_eq!(kind("a/drive.EDS"), Some(FileKind::Eds));
        assert_eq!(kind("drive.dcf.txt"), Some(FileKind::Dcf));
        assert_eq!(kind("drive.eds.json"), Some(FileKind::Json));
        assert_eq!(kind("json"), Some(FileKind::Json));
        assert_eq!(kind("drive.xml"), None);
    }
}

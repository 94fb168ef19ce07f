//! Detects file formats by content: the formats of CANopen, and other files that are mistaken for them.
//!
//! Its readers return the type of this module, so they import each other.
//!
//! The file name is used only if the content is ambiguous: an EDS and a DCF, or an XDD and an XDC, may have the same
//! text. Detection never fails on malformed content; unrecognised content is [`ContentKind::Unknown`].

#[cfg(feature = "full")]
mod concise;
pub(super) mod ini;
mod kind;
mod text;
#[cfg(feature = "xdd")]
mod xml;

use std::borrow::Cow;
use std::fmt;

pub use self::kind::ContentKind;
use objdict_model::source::{Encoding, SourceFile};

/// The number of bytes examined from the start; single words are searched in all of them.
const HEAD: usize = 1 << 16;

/// The maximum number of characters quoted from a file.
const QUOTED: usize = 100;

/// The signatures of files of other programs.
const SIGNATURES: [(&[u8], &str); 11] = [
    (b"\x89PNG\r\n", "it is a PNG image"),
    (b"\xFF\xD8\xFF", "it is a JPEG image"),
    (b"GIF8", "it is a GIF image"),
    (b"%PDF-", "it is a PDF document"),
    (b"PK\x03\x04", "it is a ZIP archive"),
    (b"\x1F\x8B\x08", "it is a gzip archive"),
    (b"7z\xBC\xAF\x27\x1C", "it is a 7z archive"),
    (b"Rar!\x1A\x07", "it is a RAR archive"),
    (b"\x7FELF", "it is a program (ELF)"),
    (b"MZ", "it is a program of Windows"),
    (b"\xD0\xCF\x11\xE0", "it is a document of Microsoft Office"),
];

/// The format of a file, and the evidence for it.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "full", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Identification {
    /// Its content.
    pub kind: ContentKind,
    /// Its technology, such as `CANopen` or `EtherNet/IP`; `None` if unknown.
    #[cfg_attr(feature = "full", serde(skip_serializing_if = "Option::is_none"))]
    pub technology: Option<String>,
    /// The version of its format, as stated in the file: `4.0` for an EDS, `1.1` for an XDD.
    #[cfg_attr(feature = "full", serde(rename = "format_version", skip_serializing_if = "Option::is_none"))]
    pub version: Option<String>,
    /// The namespace of an XML file.
    #[cfg_attr(feature = "full", serde(skip_serializing_if = "Option::is_none"))]
    pub namespace: Option<String>,
    /// How many devices a network of XDD or XDC describes.
    #[cfg_attr(feature = "full", serde(skip_serializing_if = "Option::is_none"))]
    pub devices: Option<usize>,
    /// The node-ID that a DCF or XDC states.
    #[cfg_attr(feature = "full", serde(skip_serializing_if = "Option::is_none"))]
    pub node_id: Option<u8>,
    /// The evidence, as a clause: "the root element is …".
    pub reason: String,
}

/// Detects the format of a file from its bytes; `name` is its name or path, or any string without an
/// extension if there is none.
///
/// It examines the first 64 KiB, the whole of a concise DCF, and searches the whole of a description for
/// single words.
pub fn identify(name: &str, bytes: &[u8]) -> Identification {
    if let Some(encoding) = utf16(bytes) {
        let text = encoding.decode(bytes.to_vec());
        return of_text(&ExaminedContent::new(name, text.as_bytes()));
    }
    let content = ExaminedContent::new(name, bytes);
    #[cfg(feature = "full")]
    if let Some(found) = content.looks_binary().then(|| concise::of_stream(bytes)).flatten() {
        return found;
    }
    of_text(&content)
}

/// Detects the format of an opened file; see [`identify`].
pub fn identify_source(source: &SourceFile) -> Identification {
    let content = ExaminedContent::new(source.name(), source.text().as_bytes());
    if content.looks_binary() {
        return identify(source.name(), &source.to_bytes());
    }
    of_text(&content)
}

/// Whether an opened file is a node list: the verdict of [`identify_source`], for less of the work.
pub fn is_node_list(source: &SourceFile) -> bool {
    ini::has_topology(source.text()) && identify_source(source).kind == ContentKind::NodeList
}

impl Identification {
    fn new(kind: ContentKind, reason: impl Into<String>) -> Self {
        let technology = kind.is_canopen().then(|| "CANopen".to_owned());
        Self {
            kind,
            technology,
            version: None,
            namespace: None,
            devices: None,
            node_id: None,
            reason: reason.into(),
        }
    }

    /// A description of a file without a readable description, starting with a verb: "describes an IO-Link device
    /// (IODD), not a CANopen one".
    pub fn verdict(&self) -> Cow<'static, str> {
        Cow::Owned(match self.kind {
            ContentKind::NetworkXdd | ContentKind::NetworkXdc => {
                let several = self.devices.filter(|&count| count != 1);
                let count =
                    several.map_or("one XDD or XDC".to_owned(), |count| format!("{count} XDD or XDC"));
                format!("is a network of CANopenEditor with {count} in it")
            }
            ContentKind::CipEds => {
                let technology = self.technology.as_deref().unwrap_or("CIP");
                format!("is the EDS of a device for {technology}, not for CANopen")
            }
            ContentKind::OtherProfile => {
                let technology = self.technology.as_deref().unwrap_or("an unnamed technology");
                format!("is a device profile (ISO 15745) for {technology}, not for CANopen")
            }
            ContentKind::OtherXml => format!("is XML, but not a description: {}", self.reason),
            ContentKind::Unknown => format!("is not a file that objdict knows: {}", self.reason),
            kind => return Cow::Borrowed(kind.verdict()),
        })
    }

    /// Advice for a file without a readable description.
    pub fn advice(&self) -> Option<&'static str> {
        self.kind.advice()
    }
}

/// `XDC 1.1 (CANopen), node-ID 5 – the root element is …`
impl fmt::Display for Identification {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.kind.name())?;
        if let Some(version) = &self.version {
            write!(f, " {version}")?;
        }
        if let Some(technology) = &self.technology {
            write!(f, " ({technology})")?;
        }
        if let Some(id) = self.node_id {
            write!(f, ", node-ID {id}")?;
        }
        match self.devices {
            Some(1) => f.write_str(", 1 device")?,
            Some(count) => write!(f, ", {count} devices")?,
            None => {}
        }
        write!(f, " – {}", self.reason)
    }
}

/// The content to examine.
struct ExaminedContent<'a> {
    /// The name of the file, without its folders.
    name: &'a str,
    /// All bytes, in an encoding that has ASCII as its lower half.
    bytes: &'a [u8],
    /// The start of the file as text.
    head: Cow<'a, str>,
}

impl<'a> ExaminedContent<'a> {
    fn new(name: &'a str, bytes: &'a [u8]) -> Self {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let head = &bytes[..bytes.len().min(HEAD)];
        // finding the first invalid byte takes a tenth of the time of replacing possible ones
        let head = std::str::from_utf8(head).map_or_else(|_| String::from_utf8_lossy(head), Cow::Borrowed);
        Self { name: file_name(name), bytes, head }
    }

    fn looks_binary(&self) -> bool {
        let start = &self.bytes[..self.bytes.len().min(1 << 10)];
        memchr::memchr(0, start).is_some()
    }

    /// Whether the name has one of these extensions, which need not be the last known one.
    fn is_called(&self, endings: &[&str]) -> bool {
        let mut parts = self.name.rsplit('.');
        parts.any(|part| endings.iter().any(|ending| ending.eq_ignore_ascii_case(part)))
    }
}

fn of_text(content: &ExaminedContent<'_>) -> Identification {
    let text = content.head.trim_start_matches(is_blank);
    if text.is_empty() {
        let reason =
            if content.bytes.is_empty() { "the file is empty" } else { "the file contains only white space" };
        return Identification::new(ContentKind::Unknown, reason);
    }
    let xml = xml::identify(content, text);
    if let Some(found) = &xml
        && found.kind != ContentKind::OtherXml
    {
        return found.clone();
    }
    // tables of TOML look like sections
    if let Some(found) = text::toml(text) {
        return found;
    }
    // an EDS may start with merge conflict markers, or with a line of an e-mail
    ini::identify(content)
        .or(xml)
        .or_else(|| text::identify(content, text))
        .or_else(|| xml::behind_junk(content))
        .unwrap_or_else(|| unknown(content))
}

/// XML, which a build without the feature `xdd` does not examine.
#[cfg(not(feature = "xdd"))]
mod xml {
    use super::{ContentKind, ExaminedContent, Identification};

    pub(super) fn identify(_: &ExaminedContent<'_>, text: &str) -> Option<Identification> {
        let reason =
            "it starts with `<`, but this build of objdict cannot read XML: enable its feature `xdd`";
        text.starts_with('<').then(|| Identification::new(ContentKind::OtherXml, reason))
    }

    pub(super) fn behind_junk(_: &ExaminedContent<'_>) -> Option<Identification> {
        None
    }
}

fn unknown(content: &ExaminedContent<'_>) -> Identification {
    let reason = match SIGNATURES.iter().find(|(start, _)| content.bytes.starts_with(start)) {
        Some((_, what)) => what,
        None if content.looks_binary() => "binary data that is not a concise DCF",
        None => "text without features of a known format",
    };
    Identification::new(ContentKind::Unknown, reason)
}

fn is_blank(character: char) -> bool {
    character.is_whitespace() || matches!(character, '\0' | '\u{1A}' | '\u{FEFF}')
}

/// Detects UTF-16 by its byte order mark or by the first character, which is ASCII in every format.
fn utf16(bytes: &[u8]) -> Option<Encoding> {
    match bytes {
        [0xFF, 0xFE, ..] => Some(Encoding::Utf16Le),
        [0xFE, 0xFF, ..] => Some(Encoding::Utf16Be),
        [b'<' | b'[' | b';' | b'{', 0, next, 0, ..] if *next != 0 => Some(Encoding::Utf16Le),
        [0, b'<' | b'[' | b';' | b'{', 0, next, ..] if *next != 0 => Some(Encoding::Utf16Be),
        _ => None,
    }
}

/// The last part of a path.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// A quotation from the file, truncated and without terminal control characters.
fn quoted(text: &str) -> String {
    let clean = |c: char| if c.is_control() { ' ' } else { c };
    let mut quoted: String = text.trim().chars().take(QUOTED).map(clean).collect();
    if text.trim().chars().nth(QUOTED).is_some() {
        quoted.push('…');
    }
    quoted
}

/// `a`, `a and b`, `a, b and c`.
fn list(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

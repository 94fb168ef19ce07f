//! The canonical EDS and DCF of a device that has no source text: the order and spelling that most readers take
//! (CiA 306-1), written by rust-ini.

mod info;
mod modules;
mod objects;
mod sheet;

use std::fmt;

use self::sheet::Sheet;
use crate::format::literal::RealSpelling;
use crate::model::{Device, DeviceKind, Place};
use crate::source::Encoding;

/// How a canonical text is written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// How REAL numbers are spelled.
    pub real: RealSpelling,
    /// Whether strings that are values stand in quotes, as dcfgen and dcf2dev demand.
    pub quote_strings: bool,
    /// Whether what is stored compactly stays so (`CompactSubObj`), with the names of all entries; otherwise every entry
    /// gets a section, for many readers know nothing else.
    pub compact: bool,
    /// The encoding; `None` for ISO 646, as the standard demands. What it lacks is written in other letters.
    pub encoding: Option<Encoding>,
}

/// A written description.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// Texts that could not be written as they are.
    pub losses: Vec<Loss>,
}

/// A text that could not be written as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Loss {
    /// Where it stands.
    pub place: Place,
    /// What happened to it.
    pub kind: LossKind,
    /// The text.
    pub text: String,
}

/// Why a text could not be written as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LossKind {
    /// Control characters became blanks: a line end would end the value.
    ControlCharacter,
    /// Characters that the encoding lacks became others.
    Encoding,
    /// Blanks at the ends were left out: no reader sees them.
    Blanks,
    /// A key or section name that would not be read as one was changed.
    Name,
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, kind, text } = self;
        let what = match kind {
            LossKind::ControlCharacter => "control characters became blanks in",
            LossKind::Encoding => "characters that the encoding lacks were written as others in",
            LossKind::Blanks => "blanks at the ends were left out in",
            LossKind::Name => "the name was changed, for it would not be read as one:",
        };
        write!(f, "`{place}`: {what} `{}`", text.escape_debug())
    }
}

impl WriteOptions {
    /// Whether the encoding has a character.
    fn can_write(&self, c: char) -> bool {
        match self.encoding {
            None => c.is_ascii(),
            Some(_) if c.is_ascii() => true,
            Some(encoding) => encoding.encode(c.encode_utf8(&mut [0; 4])).is_ok(),
        }
    }
}

/// The canonical text of a device as a description of this kind. An EDS of a configured node leaves out what was
/// configured.
pub(crate) fn write(device: &Device, kind: DeviceKind, options: &WriteOptions) -> Written {
    let mut sheet = Sheet::new(options, &device.extra);
    let writer = Writer { device, configured: kind == DeviceKind::Node || device.kind == DeviceKind::Type };
    writer.general(&mut sheet);
    writer.modules(&mut sheet);
    writer.objects(&mut sheet);
    sheet.rest(&device.extra);
    let (text, losses) = sheet.finish();
    let bytes = options.encoding.and_then(|encoding| encoding.encode(&text).ok());
    Written { bytes: bytes.unwrap_or(text.into_bytes()), losses }
}

/// A device being written.
struct Writer<'a> {
    device: &'a Device,
    /// Whether values of a node are written.
    configured: bool,
}

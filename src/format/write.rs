//! Writing a device: the text of a format, what does not come back of it, and where that is kept.

use std::borrow::Cow;
use std::fmt;

use serde::Serialize;
use serde_json::Value;

use super::embedded::{self, Room};
use super::ini::Document;
use super::xml::Tree;
use super::{Dialect, EditError, Format, Style, Syntax, XddVersion, eds, xdd};
use crate::compare::{DatumChange, DatumDifference, each_difference};
use crate::diagnostic::Findings;
use crate::model::{Device, DeviceKind, Place};
use crate::source::{Encoding, SourceFile, SourceOptions};

/// How a text is written that is no edit of another.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// How an EDS or DCF is written.
    pub eds: Style,
    /// Who reads an EDS or DCF: what is stated for the reader, and what it refuses and is left out.
    pub dialect: Dialect,
    /// The version of CiA 311 of an XDD or XDC, which are always written in UTF-8.
    pub xdd_version: XddVersion,
    /// Whether what the format has no place for is kept in comment lines or properties, which other tools pass over and
    /// objdict reads (docs/formats.md).
    pub embed: bool,
}

impl From<Dialect> for WriteOptions {
    fn from(dialect: Dialect) -> Self {
        Self { eds: dialect.style(), dialect, ..Self::default() }
    }
}

/// A written description.
#[derive(Clone, Debug, PartialEq)]
pub struct Written {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// Every datum of the device that a reader of the file does not get, in the order of the model.
    pub losses: Vec<Loss>,
}

/// A datum that a written text does not give back.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Loss {
    /// Its place in the model.
    #[serde(serialize_with = "place_text")]
    pub place: Place,
    /// The same as a JSON pointer into the JSON of the device (docs/json.md).
    pub path: String,
    /// What became of it.
    #[serde(rename = "fate")]
    pub kind: LossKind,
    /// What the device says.
    pub value: Value,
    /// What the text says in its place; `None` for nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub becomes: Option<Value>,
    /// Why, if the format has a place for other data of this kind.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// What became of a datum that the format has no place for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LossKind {
    /// It is gone.
    Lost,
    /// It belongs to a node, and the format describes a type of device; or the format is for other data.
    LeftOut,
    /// objdict reads it from a comment line or property of its own; other tools do not see it.
    #[serde(rename = "carried")]
    Embedded,
}

impl LossKind {
    /// In words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lost => "lost",
            Self::LeftOut => "left out",
            Self::Embedded => "embedded",
        }
    }
}

fn place_text<S: serde::Serializer>(place: &Place, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(place)
}

impl Loss {
    /// The losses of a difference. Data that only the text has are not losses.
    fn of(difference: DatumDifference, kind: LossKind, losses: &mut Vec<Self>) {
        let place = difference.place();
        let DatumDifference { path, left, right } = difference;
        match (left, right) {
            // a part that is gone as a whole: what it said, datum by datum
            (Some(Value::Object(fields)), None) if PARTS.iter().any(|part| path.ends_with(part)) => {
                for (name, value) in fields {
                    let path = format!("{path}/{name}");
                    Self::of(DatumDifference { path, left: Some(value), right: None }, kind, losses);
                }
            }
            (Some(value), becomes) => {
                losses.push(Self { place, path, kind, value, becomes, reason: None });
            }
            (None, _) => {}
        }
    }
}

/// The parts whose fields are listed one by one.
const PARTS: [&str; 8] = [
    "/commissioning",
    "/configured",
    "/compact",
    "/names",
    "/values",
    "/denotations",
    "/safety",
    "/parameter",
];

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, kind, value, becomes, reason, .. } = self;
        if let Some(reason) = reason {
            return write!(f, "{}: {place}: {reason}", kind.name());
        }
        write!(f, "{}: {place}: {}", kind.name(), Shown(value))?;
        match becomes {
            Some(becomes) => write!(f, " becomes {}", Shown(becomes)),
            None => Ok(()),
        }
    }
}

/// A datum in a line: as JSON, but cut where it is long, and values of entries as they are written.
struct Shown<'a>(&'a Value);

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const ROOM: usize = 100;
        let text = match value_of_entry(self.0) {
            Some(value) => value.to_string(),
            None => self.0.to_string(),
        };
        let text = text.replace(char::is_control, " ");
        match text.char_indices().nth(ROOM) {
            Some((end, _)) => write!(f, "`{}…` ({} bytes)", &text[..end], text.len()),
            None => write!(f, "`{text}`"),
        }
    }
}

/// The value of an entry that JSON is, if it is one.
fn value_of_entry(json: &Value) -> Option<crate::model::Value> {
    let is_one = json.as_object().is_some_and(|map| map.len() == 1);
    if is_one { serde_json::from_str(&json.to_string()).ok() } else { None }
}

/// The text of a device in a format, and what it does not give back.
pub(super) fn write(device: &Device, format: Format, options: &WriteOptions) -> Result<Written, EditError> {
    let kept = kept(device, format);
    let mut losses = losses_of(missing(device, &kept), LossKind::LeftOut);
    // of what is stored compactly only the form is lost, and only where that was asked for
    let wanted = match options.eds.compact || options.embed {
        true => kept,
        false => Cow::Owned(kept.expanded().into_owned()),
    };
    let mut bytes = encode(&wanted, format, options);
    let (mut read, mut violation);
    (bytes, read, violation) = decode(bytes, format, options.eds.encoding);
    let mut lost = missing(&wanted, &read);
    if options.embed && !lost.is_empty() {
        let plain = lost;
        drop((bytes, read));
        bytes = encode_with(&wanted, format, options, &plain);
        (bytes, read, violation) = decode(bytes, format, options.eds.encoding);
        (read, _) = embedded::restore(read, Findings::new());
        lost = missing(&wanted, &read);
        let embedded = plain.into_iter().filter(|found| !is_among(found, &lost)).collect();
        losses.append(&mut losses_of(embedded, LossKind::Embedded));
    }
    losses.append(&mut losses_of(lost, LossKind::Lost));
    losses.sort_by_key(|loss| loss.kind);
    match violation {
        Some(violation) => Err(EditError::NotValid(violation)),
        None => Ok(Written { bytes, losses }),
    }
}

/// The text of a device that carries what is lost. To carry something may change how a reader takes what is beside it, so
/// what is embedded is measured again until it is what is lost.
fn encode_with(wanted: &Device, format: Format, options: &WriteOptions, lost: &[Missing]) -> Vec<u8> {
    const ROUNDS: usize = 4;
    let mut needed = changes(lost);
    let mut bytes = Vec::new();
    for _ in 0..ROUNDS {
        drop(bytes);
        let mut carrier = wanted.clone();
        embedded::embed(&mut carrier, &needed, room(format));
        let mut read;
        (bytes, read, _) = decode(encode(&carrier, format, options), format, options.eds.encoding);
        embedded::extract(&mut read);
        let found = changes(&missing(wanted, &read));
        if found == needed {
            break;
        }
        needed = found;
    }
    bytes
}

/// What a text does not give back of the device that it was made of.
pub(super) fn losses(device: &Device, bytes: &[u8], format: Format, encoding: Encoding) -> Vec<Loss> {
    let kept = kept(device, format);
    let (_, read, _) = decode(bytes.to_vec(), format, Some(encoding));
    let (read, _) = embedded::restore(read, Findings::new());
    let mut losses = losses_of(missing(&kept, &read), LossKind::Lost);
    losses.append(&mut losses_of(missing(device, &kept), LossKind::LeftOut));
    losses
}

/// What a format describes of a device: all of it, or its type.
fn kept(device: &Device, format: Format) -> Cow<'_, Device> {
    match format.kind() {
        DeviceKind::Type => device.unconfigured(),
        DeviceKind::Node => Cow::Borrowed(device),
    }
}

/// A difference between a device and what comes back of it. What comes back in excess is only known by its fingerprint: of
/// entries in compact storage it is much more than the device.
struct Missing {
    difference: DatumDifference,
    before: Option<u32>,
}

fn missing(device: &Device, read: &Device) -> Vec<Missing> {
    let mut found = Vec::new();
    each_difference(device, read, &mut |DatumDifference { path, left, right }| {
        let before = right.as_ref().map(DatumChange::fingerprint);
        let right = right.filter(|_| left.is_some());
        found.push(Missing { difference: DatumDifference { path, left, right }, before });
    });
    found
}

fn losses_of(missing: Vec<Missing>, kind: LossKind) -> Vec<Loss> {
    let mut losses = Vec::new();
    missing.into_iter().for_each(|found| Loss::of(found.difference, kind, &mut losses));
    losses
}

/// Whether a difference, or one inside it or around it, is among others.
fn is_among(found: &Missing, others: &[Missing]) -> bool {
    let path = &found.difference.path;
    let within = |inner: &str, outer: &str| {
        inner.strip_prefix(outer).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    };
    others.iter().map(|other| &other.difference.path).any(|other| within(other, path) || within(path, other))
}

/// What brings back what is lost.
fn changes(lost: &[Missing]) -> Vec<DatumChange> {
    let change = |Missing { difference, before }: &Missing| DatumChange {
        path: difference.path.clone(),
        before: *before,
        after: difference.left.clone(),
    };
    lost.iter().map(change).collect()
}

const fn room(format: Format) -> Room {
    match format {
        Format::Eds | Format::Dcf => Room::Lines,
        Format::Xdd | Format::Xdc => Room::Properties,
    }
}

fn encode(device: &Device, format: Format, options: &WriteOptions) -> Vec<u8> {
    match format {
        Format::Eds | Format::Dcf => eds::write(&options.dialect.adapted(device), &options.eds),
        Format::Xdd | Format::Xdc => xdd::write(device, options.xdd_version).into_bytes(),
    }
}

/// The device that a text describes, with what is embedded still where it is kept; and the first violation of CiA 311. The
/// bytes come back.
fn decode(bytes: Vec<u8>, format: Format, encoding: Option<Encoding>) -> (Vec<u8>, Device, Option<String>) {
    let source_options = SourceOptions { encoding, max_size: u64::MAX };
    let source = match SourceFile::from_bytes("", bytes, &source_options) {
        Ok(source) => source,
        Err(error) => return (Vec::new(), Device::default(), Some(error.to_string())),
    };
    match format.syntax() {
        Syntax::Ini => {
            let document = Document::new(source);
            let device = eds::read(&document, format.kind()).0;
            (document.into_source().into_bytes(), device, None)
        }
        Syntax::Xml => {
            let mut findings = Findings::new();
            let tree = Tree::new(source, &mut findings);
            findings.append(xdd::findings::violations(&tree));
            let violation = findings.iter().next().map(|finding| finding.message.to_string());
            let device = xdd::read(&tree, 0, format.kind()).0;
            (tree.into_source().into_bytes(), device, violation)
        }
    }
}

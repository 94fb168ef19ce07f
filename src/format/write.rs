//! Writing a device: the text of a format, what does not come back of it, and where that is kept.

use std::borrow::Cow;
use std::fmt;

use serde::Serialize;
use serde_json::Value;

use super::complete;
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
    /// Every datum of the device that a reader of the file does not get, and every one that only the file states, by kind
    /// and in the order of the model.
    pub losses: Vec<Loss>,
}

/// A datum that a written text does not give back, or that only the text states.
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
    /// What the device says; of what is invented, what the text says.
    pub value: Value,
    /// What the text says in its place; `None` for nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub becomes: Option<Value>,
    /// Why, if the format has a place for other data of this kind.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

/// What became of a datum that only the device or only the text has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LossKind {
    /// It is gone.
    Lost,
    /// It belongs to a node, and the format describes a type of device; or the format is for other data.
    LeftOut,
    /// The text states it although the device does not, because the format demands it.
    Invented,
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
            Self::Invented => "invented",
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

    /// A datum that only the text has, by its path.
    pub fn invented(path: String, value: Value) -> Self {
        let difference = DatumDifference { path, left: None, right: None };
        let (place, path) = (difference.place(), difference.path);
        Self { place, path, kind: LossKind::Invented, value, becomes: None, reason: None }
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
    let bytes = encode(&wanted, format, options);
    let mut text = decode(bytes, format, options.eds.encoding);
    let mut lost = missing(&wanted, &text.device);
    losses.append(&mut invented(&wanted, &text.stated));
    complete::stated_anew(&wanted, &text.device, &mut |path, value| losses.push(Loss::invented(path, value)));
    if options.embed && !lost.is_empty() {
        let plain = lost;
        drop(text);
        let bytes = encode_with(&wanted, format, options, &plain);
        text = decode(bytes, format, options.eds.encoding);
        (text.device, _) = embedded::restore(text.device, Findings::new());
        lost = missing(&wanted, &text.device);
        let embedded = plain.into_iter().filter(|found| !is_among(found, &lost)).collect();
        losses.append(&mut losses_of(embedded, LossKind::Embedded));
    }
    losses.append(&mut losses_of(lost, LossKind::Lost));
    losses.sort_by_key(|loss| loss.kind);
    match text.violation {
        Some(violation) => Err(EditError::NotValid(violation)),
        None => Ok(Written { bytes: text.bytes, losses }),
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
        bytes = encode(&carrier, format, options);
        drop(carrier);
        let mut text = decode(bytes, format, options.eds.encoding);
        embedded::extract(&mut text.device);
        let found = changes(&missing(wanted, &text.device));
        bytes = text.bytes;
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
    let text = decode(bytes.to_vec(), format, Some(encoding));
    let (read, _) = embedded::restore(text.device, Findings::new());
    let mut losses = losses_of(missing(&kept, &read), LossKind::Lost);
    losses.append(&mut losses_of(missing(device, &kept), LossKind::LeftOut));
    losses.append(&mut invented(&kept, &text.stated));
    losses
}

/// What a text states of file, device and node although the device does not.
fn invented(device: &Device, stated: &Device) -> Vec<Loss> {
    let mut losses = Vec::new();
    each_difference(&frame(device), &frame(stated), &mut |DatumDifference { path, left, right }| {
        // a bit rate that the device does not support
        let is_new = left.is_none() || left == Some(Value::Bool(false)) && right == Some(Value::Bool(true));
        if let Some(value) = right.filter(|_| is_new) {
            add_invented(path, value, &mut losses);
        }
    });
    losses
}

/// The parts of a device about file, device and node.
fn frame(device: &Device) -> Device {
    Device {
        file_info: device.file_info.clone(),
        device_info: device.device_info.clone(),
        commissioning: device.commissioning.clone(),
        ..Device::default()
    }
}

fn add_invented(path: String, value: Value, losses: &mut Vec<Loss>) {
    if let Value::Object(fields) = value {
        for (name, value) in fields {
            add_invented(format!("{path}/{name}"), value, losses);
        }
        return;
    }
    // a bit rate that is not supported, and what a missing key of the node means
    let is_zero = value == Value::Bool(false) || value.as_u64() == Some(0);
    let says_nothing =
        is_zero && ["/device_info/baud_rates/", "/commissioning/"].iter().any(|part| path.starts_with(part));
    let is_empty = value.as_str().is_some_and(|text| text.trim().is_empty())
        || value.as_array().is_some_and(Vec::is_empty);
    // the file that a DCF was made of is a fact
    let is_fact = path == "/file_info/last_eds";
    if !(says_nothing || is_empty || is_fact) {
        losses.push(Loss::invented(path, value));
    }
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
        Format::Xdd | Format::Xdc => {
            xdd::write(&complete::with_valid_access(device), options.xdd_version).into_bytes()
        }
    }
}

/// A text and what readers find in it.
struct Decoded {
    bytes: Vec<u8>,
    /// With what is embedded still where it is kept.
    device: Device,
    /// What it says of file, device and node to a tool that does not know the placeholders of objdict.
    stated: Device,
    /// The first violation of CiA 311.
    violation: Option<String>,
}

fn decode(bytes: Vec<u8>, format: Format, encoding: Option<Encoding>) -> Decoded {
    let source_options = SourceOptions { encoding, max_size: u64::MAX };
    let source = match SourceFile::from_bytes("", bytes, &source_options) {
        Ok(source) => source,
        Err(error) => {
            let violation = Some(error.to_string());
            return Decoded {
                bytes: Vec::new(),
                device: Device::default(),
                stated: Device::default(),
                violation,
            };
        }
    };
    match format.syntax() {
        Syntax::Ini => {
            let document = Document::new(source);
            let device = eds::read(&document, format.kind()).0;
            let (bytes, stated) = (document.into_source().into_bytes(), frame(&device));
            Decoded { bytes, device, stated, violation: None }
        }
        Syntax::Xml => {
            let mut findings = Findings::new();
            let tree = Tree::new(source, &mut findings);
            findings.append(xdd::findings::violations(&tree));
            let violation = findings.iter().next().map(|finding| finding.message.to_string());
            let device = xdd::read(&tree, 0, format.kind()).0;
            let stated = xdd::read_literally(&tree, format.kind());
            Decoded { bytes: tree.into_source().into_bytes(), device, stated, violation }
        }
    }
}

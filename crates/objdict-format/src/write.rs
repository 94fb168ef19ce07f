//! Writes a device: the text of a format, the losses, and their storage.
//!
//! Losses are measured: the written text is read back and compared. One mechanism therefore covers all pairs of
//! formats, and no list of unsupported features is needed.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt;

use serde::Serialize;
use serde_json::Value;

use super::embedded::{self, Carrier};
use super::input::{DEFAULT_MAX_ENTRIES, VALUES_PER_ENTRY};
use super::{Dialect, EditError, Format, Style, Syntax, XddVersion, complete, device_toml};
use crate::compare::{Datum, DatumChange, DatumDifference, TooMany, each_difference};
use objdict_eds::eds;
use objdict_eds::ini::Document;
use objdict_model::diagnostic::Findings;
use objdict_model::model::{Device, DeviceKind, Place};
use objdict_model::source::{Encoding, SourceFile, SourceOptions};
use objdict_xdd::xdd;
use objdict_xdd::xml::Tree;

/// Options for a text that is not an edit of another one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WriteOptions {
    /// The style of an EDS or DCF.
    pub eds: Style,
    /// The intended reader of an EDS or DCF, which determines added and omitted content.
    pub dialect: Dialect,
    /// The CiA 311 version of an XDD or XDC, which are always written in UTF-8.
    pub xdd_version: XddVersion,
    /// Whether unsupported content is embedded in comment lines or properties, which other tools ignore and objdict
    /// reads (docs/reference/formats.md).
    pub embed: bool,
    /// The maximum number of JSON values that may differ between the text and the device; beyond it,
    /// [`EditError::TooMuchLost`].
    pub max_losses: usize,
}

/// The maximum number of lost values: each needs up to 1 kB while it is embedded.
const DEFAULT_MAX_LOSSES: usize = WriteOptions::max_losses_of(0, DEFAULT_MAX_ENTRIES);
const VALUES_PER_LOSS: usize = 4;

/// Omitted values are only reported, so this many times more of them are allowed.
const LEFT_OUT: usize = 8;

impl Default for WriteOptions {
    fn default() -> Self {
        Self {
            eds: Style::default(),
            dialect: Dialect::default(),
            xdd_version: XddVersion::default(),
            embed: false,
            max_losses: DEFAULT_MAX_LOSSES,
        }
    }
}

impl WriteOptions {
    /// The limit for the text of a description, which is higher for a large one, with this many
    /// [entries](super::input::Reading::max_entries).
    pub const fn max_losses_of(bytes: usize, max_entries: usize) -> usize {
        max_entries.saturating_mul(VALUES_PER_ENTRY) / VALUES_PER_LOSS + bytes / BYTES_PER_LOSS
    }
}

/// The number of bytes of a text per additional lost value.
const BYTES_PER_LOSS: usize = 64;

impl From<Dialect> for WriteOptions {
    fn from(dialect: Dialect) -> Self {
        Self { eds: dialect.style(), dialect, ..Self::default() }
    }
}

/// A written description.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Written {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// The values of the device that a reader of the file does not get, and values that only the file states, by kind
    /// and in the order of the model.
    pub losses: Vec<Loss>,
}

/// A value that a written text does not preserve, or that only the text states.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Loss {
    /// The place in the model.
    #[serde(serialize_with = "place_text")]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub place: Place,
    /// The place as a JSON pointer into the JSON of the device (docs/reference/json.md).
    pub path: String,
    /// The kind of loss.
    #[serde(rename = "fate")]
    pub kind: LossKind,
    /// The value in the device; for an invented one, in the text.
    pub value: Datum,
    /// The value in the text; `None` if missing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub becomes: Option<Datum>,
    /// The reason, if the format supports other values of this kind.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<String>,
}

objdict_model::named! {
    /// The kind of a value that only the device or only the text has.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Fate"))]
    #[serde(rename_all = "snake_case")]
    #[non_exhaustive]
    pub enum LossKind {
        /// It is gone.
        Lost = "lost",
        /// The value belongs to a node, but the format describes a device type; or the format does not
        /// support such values.
        LeftOut = "left out",
        /// Only the text states the value, because the format requires it.
        Invented = "invented",
        /// objdict reads it from a separate comment line or property, which other tools ignore.
        #[serde(rename = "carried")]
        Embedded = "embedded",
    }
}

fn place_text<S: serde::Serializer>(place: &Place, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(place)
}

impl Loss {
    /// The losses of a difference. Values that only the text has are not losses.
    fn of(difference: DatumDifference, kind: LossKind, losses: &mut Vec<Self>) {
        let place = difference.place();
        let DatumDifference { path, left, right } = difference;
        let is_part = right.is_none() && PARTS.iter().any(|part| path.ends_with(part));
        match (left, right) {
            // a completely missing part is reported value by value
            (Some(part), None) if is_part && part.text().starts_with('{') => {
                let Value::Object(fields) = part.value() else { return };
                for (name, value) in fields {
                    let path = format!("{path}/{name}");
                    Self::of(DatumDifference { path, left: Some(value.into()), right: None }, kind, losses);
                }
            }
            (Some(value), becomes) => {
                losses.push(Self { place, path, kind, value, becomes, reason: None });
            }
            (None, _) => {}
        }
    }

    /// A value that only the text has, by its path.
    pub fn invented(path: String, value: Value) -> Self {
        let difference = DatumDifference { path, left: None, right: None };
        let (place, path, value) = (difference.place(), difference.path, value.into());
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
        write!(f, "{}: {place}: {}", kind.name(), ShownDatum(value))?;
        match becomes {
            Some(becomes) => write!(f, " becomes {}", ShownDatum(becomes)),
            None => Ok(()),
        }
    }
}

/// A value on one line: as JSON, truncated if long, and values of entries as written.
struct ShownDatum<'a>(&'a Datum);

impl fmt::Display for ShownDatum<'_> {
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

/// The value of an entry, if the JSON is one.
fn value_of_entry(json: &Datum) -> Option<objdict_model::model::Value> {
    if json.text().starts_with('{') { serde_json::from_str(json.text()).ok() } else { None }
}

/// Writes the canonical text of a device without source: an EDS without the node's configuration, or a DCF with it.
/// Also returns the losses: the differences between the device and the result of reading the text.
///
/// # Errors
/// If the text violates CiA 311, which is a bug in objdict, or loses more values than allowed.
pub fn write(device: &Device, format: Format, options: &WriteOptions) -> Result<Written, EditError> {
    if format == Format::Toml {
        // it supports all content
        let bytes = device_toml::write(device, options.max_losses)?.into_bytes();
        let losses = losses(device, &bytes, format, options)?;
        return Ok(Written { bytes, losses });
    }
    let limit = options.max_losses;
    let kept = kept(device, format);
    let left_out = missing(device, &kept, limit.saturating_mul(LEFT_OUT))?;
    let mut losses = losses_of(left_out, LossKind::LeftOut);
    // compact storage loses only its notation, and only on request
    let wanted = match options.eds.compact || options.embed {
        true => kept,
        false => Cow::Owned(kept.expanded().into_owned()),
    };
    let Measured { mut text, mut lost, carried } = match options.embed {
        true => write_embedded(&wanted, format, options)?,
        false => measure(&wanted, Cow::Borrowed(&*wanted), &[], format, options)?,
    };
    losses.append(&mut invented(&wanted, &text.stated));
    complete::stated_anew(&wanted, &text.device, &mut |path, value| losses.push(Loss::invented(path, value)));
    if !carried.is_empty() {
        embedded::put_back(&mut text.device, carried);
        let plain = std::mem::replace(&mut lost, missing(&wanted, &text.device, limit)?);
        losses.append(&mut losses_of(without(plain, &lost), LossKind::Embedded));
    }
    losses.append(&mut losses_of(lost, LossKind::Lost));
    losses.sort_by_key(|loss| loss.kind);
    match text.violation {
        Some(violation) => Err(EditError::NotValid(violation)),
        None => Ok(Written { bytes: text.bytes, losses }),
    }
}

/// A text, and its losses compared with its device.
struct Measured {
    /// Its device does not include embedded content.
    text: Decoded,
    lost: Vec<Missing>,
    carried: Vec<DatumChange>,
}

/// Writes a device that contains changes of the `wanted` one, and reads it back.
fn measure(
    wanted: &Device,
    carrier: Cow<'_, Device>,
    changes: &[DatumChange],
    format: Format,
    options: &WriteOptions,
) -> Result<Measured, EditError> {
    let bytes = encode(&carrier, format, options);
    drop(carrier);
    let mut text = decode(bytes, format, options.eds.encoding);
    let carried = if changes.is_empty() { Vec::new() } else { embedded::extract(&mut text.device) };
    let lost = missing(wanted, &text.device, options.max_losses)?;
    Ok(Measured { text, lost, carried })
}

/// The text of a device with its losses embedded. Embedding may change how a reader interprets neighbouring content, so
/// the losses are measured again until they equal the embedded content.
fn write_embedded(wanted: &Device, format: Format, options: &WriteOptions) -> Result<Measured, EditError> {
    const ROUNDS: usize = 5;
    let mut carrier = wanted.clone();
    let mut needed = lost_without_objects(&mut carrier, format, options);
    let mut round = 1;
    loop {
        if !needed.is_empty() {
            embedded::embed(&mut carrier, &needed, room(format));
        }
        let measured = measure(wanted, Cow::Owned(carrier), &needed, format, options)?;
        let changes = measured.lost.iter().map(|found| &found.change);
        if round == ROUNDS || changes.clone().eq(&needed) {
            return Ok(measured);
        }
        needed = changes.cloned().collect();
        drop(measured);
        carrier = wanted.clone();
        round += 1;
    }
}

/// The losses of a device without its objects: usually these are all losses, so that the long text is written and
/// read only once.
fn lost_without_objects(device: &mut Device, format: Format, options: &WriteOptions) -> Vec<DatumChange> {
    let objects = std::mem::take(&mut device.objects);
    let mut read = decode(encode(device, format, options), format, options.eds.encoding).device;
    read.objects = Default::default();
    let lost = missing(device, &read, options.max_losses).unwrap_or_default();
    device.objects = objects;
    // the text contains them with the objects
    let is_apart = |change: &DatumChange| !change.path.starts_with("/lists");
    lost.into_iter().map(|found| found.change).filter(is_apart).collect()
}

/// The losses of a text in a format without embedded data.
pub(super) fn lost(device: &Device, read: &Device, limit: usize) -> Result<Vec<Loss>, EditError> {
    Ok(losses_of(missing(device, read, limit)?, LossKind::Lost))
}

/// The losses of a text in a format. Only the encoding and the limit of the options are used.
///
/// # Errors
/// [`EditError::TooMuchLost`] if the losses exceed the limit.
pub fn losses(
    device: &Device,
    bytes: &[u8],
    format: Format,
    options: &WriteOptions,
) -> Result<Vec<Loss>, EditError> {
    let limit = options.max_losses;
    let kept = kept(device, format);
    let left_out = missing(device, &kept, limit.saturating_mul(LEFT_OUT))?;
    let mut left_out = losses_of(left_out, LossKind::LeftOut);
    let text = decode(bytes.to_vec(), format, options.eds.encoding);
    let (read, _) = embedded::restore(text.device, Findings::new());
    let mut losses = losses_of(missing(&kept, &read, limit)?, LossKind::Lost);
    losses.append(&mut left_out);
    losses.append(&mut invented(&kept, &text.stated));
    Ok(losses)
}

/// Values about file, device and node in a text that the device does not have.
fn invented(device: &Device, stated: &Device) -> Vec<Loss> {
    let mut losses = Vec::new();
    let mut found = |DatumDifference { path, left, right }| {
        // a bit rate that the device does not support
        let is = |json: &Option<Datum>, text| json.as_ref().is_some_and(|json: &Datum| json.text() == text);
        let is_new = left.is_none() || is(&left, "false") && is(&right, "true");
        if let Some(value) = right.filter(|_| is_new) {
            add_invented(path, value.value(), &mut losses);
        }
    };
    // these parts have a fixed number of values, and a list of languages
    let _ = each_difference(&frame(device), &frame(stated), usize::MAX, &mut found);
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
    // an unsupported bit rate, and the implied value of a missing key of the node
    let is_zero = value == Value::Bool(false) || value.as_u64() == Some(0);
    let says_nothing =
        is_zero && ["/device_info/baud_rates/", "/commissioning/"].iter().any(|part| path.starts_with(part));
    let is_empty = value.as_str().is_some_and(|text| text.trim().is_empty())
        || value.as_array().is_some_and(Vec::is_empty);
    // the source file of a DCF is a genuine value
    let is_fact = path == "/file_info/last_eds";
    if !(says_nothing || is_empty || is_fact) {
        losses.push(Loss::invented(path, value));
    }
}

/// The part of a device that a format describes: all of it, or its type.
fn kept(device: &Device, format: Format) -> Cow<'_, Device> {
    match format.kind() {
        DeviceKind::Type if format == Format::Toml => Cow::Borrowed(device),
        DeviceKind::Type => device.unconfigured(),
        DeviceKind::Node => Cow::Borrowed(device),
    }
}

/// A difference between a device and the result of reading it back, with the change that restores it. Additional values
/// are identified only by fingerprint: for compactly stored entries they are much larger than the device.
struct Missing {
    change: DatumChange,
    becomes: Option<Datum>,
}

fn missing(device: &Device, read: &Device, limit: usize) -> Result<Vec<Missing>, EditError> {
    let mut found = Vec::new();
    each_difference(device, read, limit, &mut |DatumDifference { path, left, right }| {
        let before = right.as_ref().map(Datum::fingerprint);
        let becomes = right.filter(|_| left.is_some());
        found.push(Missing { change: DatumChange { path, before, after: left }, becomes });
    })
    .map_err(|TooMany { count, limit }| EditError::TooMuchLost { count, limit })?;
    Ok(found)
}

fn losses_of(missing: Vec<Missing>, kind: LossKind) -> Vec<Loss> {
    let mut losses = Vec::new();
    for Missing { change, becomes } in missing {
        let difference = DatumDifference { path: change.path, left: change.after, right: becomes };
        Loss::of(difference, kind, &mut losses);
    }
    losses
}

/// The differences that are neither among others, nor inside or around one of them.
fn without(missing: Vec<Missing>, others: &[Missing]) -> Vec<Missing> {
    let paths: BTreeSet<&str> = others.iter().map(|other| other.change.path.as_str()).collect();
    let is_apart = |found: &Missing| {
        let path = found.change.path.as_str();
        let around = path.match_indices('/').any(|(at, _)| paths.contains(&path[..at]));
        let within = format!("{path}/");
        let has_inner = paths.range(within.as_str()..).next().is_some_and(|next| next.starts_with(&within));
        !(around || paths.contains(path) || has_inner)
    };
    missing.into_iter().filter(is_apart).collect()
}

const fn room(format: Format) -> Carrier {
    match format.syntax() {
        Syntax::Ini | Syntax::Toml => Carrier::Lines,
        Syntax::Xml => Carrier::Properties,
    }
}

fn encode(device: &Device, format: Format, options: &WriteOptions) -> Vec<u8> {
    match format.syntax() {
        Syntax::Ini => eds::write(&options.dialect.adapted(device), &options.eds),
        Syntax::Xml => xdd::write(&complete::with_valid_access(device), options.xdd_version).into_bytes(),
        Syntax::Toml => device_toml::write(device, options.max_losses).unwrap_or_default().into_bytes(),
        #[cfg(not(feature = "full"))]
        Syntax::Toml => Vec::new(),
    }
}

/// A text and the result of reading it.
struct Decoded {
    bytes: Vec<u8>,
    /// Including the embedded content where it is stored.
    device: Device,
    /// The file, device and node as seen by a tool that does not know the placeholders of objdict.
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
            let stated = frame(&xdd::read_literally(&tree, format.kind()));
            Decoded { bytes: tree.into_source().into_bytes(), device, stated, violation }
        }
        Syntax::Toml => {
            let device = device_toml::read(source.text()).0;
            let stated = frame(&device);
            Decoded { bytes: source.into_bytes(), device, stated, violation: None }
        }
        #[cfg(not(feature = "full"))]
        Syntax::Toml => {
            let (device, stated) = Default::default();
            Decoded { bytes: source.into_bytes(), device, stated, violation: None }
        }
    }
}

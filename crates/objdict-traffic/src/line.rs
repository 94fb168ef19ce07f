//! Frames as JSON, one object a line.

use serde::Serialize;

use super::{Bus, raw};
use crate::log::LoggedFrame;
use objdict_document::describe::frames::{DecodedFrame, FrameKind, PdoSignal, TransferStep};
use objdict_model::json;
use objdict_model::json::Version;
use objdict_model::model::Value;

/// The version of a line, see docs/reference/json.md.
const VERSION: u32 = 1;

/// How a line begins whose time is not yet that of the frame.
const START: &str = "{\"version\":1,\"time\":0.0,";

/// A frame as the JSON document of `objdict decode --format json`: what it is, and what it says.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct FrameDocument<'a> {
    /// The version of the line.
    version: Version<VERSION>,
    /// When it was seen, in seconds with the digits of the log.
    time: f64,
    /// The name of the channel; absent if the log has none.
    #[serde(skip_serializing_if = "str::is_empty")]
    channel: &'a str,
    /// The CAN-ID.
    can_id: u32,
    /// Whether it has 29 bits.
    extended: bool,
    /// What it is: nmt, sync, time, emcy, pdo, sdo, heartbeat, boot-up, guarding, lss or unknown.
    kind: &'static str,
    /// The node that sends it or, of NMT commands, SDO requests and RPDOs, that it is for; absent for frames of no node.
    #[serde(skip_serializing_if = "Option::is_none")]
    node: Option<u8>,
    /// The service as `objdict network boot` has it: `TPDO 1`; absent for a CAN-ID that no node uses.
    #[serde(skip_serializing_if = "Option::is_none")]
    service: Option<String>,
    /// The bytes in hex.
    data: String,
    /// Whether it is a remote frame; absent for others.
    #[serde(skip_serializing_if = "is_false")]
    remote: bool,
    /// Whether it is an error frame; absent for others.
    #[serde(skip_serializing_if = "is_false")]
    error: bool,
    /// The meaning of the frame.
    text: String,
    /// The index of the entry that an SDO transfer is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    index: Option<u16>,
    /// Its sub-index.
    #[serde(skip_serializing_if = "Option::is_none")]
    sub: Option<u8>,
    /// The value of a transfer that is complete with this frame; absent without a type.
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<PlainValue>,
    /// Its bytes in hex.
    #[serde(skip_serializing_if = "Option::is_none")]
    bytes: Option<String>,
    /// The abort code of a transfer that ends with this frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    abort: Option<u32>,
    /// The values in a PDO.
    #[serde(skip_serializing_if = "Option::is_none")]
    signals: Option<Vec<Signal<'a>>>,
}

/// A value in a PDO.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Signal<'a> {
    /// The index of the object.
    index: u16,
    /// The sub-index of the entry.
    sub: u8,
    /// The name of the entry; empty if no description has it.
    name: &'a str,
    /// The value; absent if the frame is too short. Without a type it is the number of its bits.
    #[serde(skip_serializing_if = "Option::is_none")]
    value: Option<PlainValue>,
    /// The number in its unit, where it is another one.
    #[serde(skip_serializing_if = "Option::is_none")]
    scaled: Option<&'a str>,
    /// The unit; absent if there is none.
    #[serde(skip_serializing_if = "str::is_empty")]
    unit: &'a str,
    /// The meaning of the value.
    text: &'a str,
}

/// A number, a text, or the bytes of other values in hex.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
enum PlainValue {
    Unsigned(u64),
    Signed(i64),
    Real(f64),
    Text(String),
}

fn is_false(flag: &bool) -> bool {
    !flag
}

impl PlainValue {
    fn of(value: &Value) -> Self {
        match value.as_integer() {
            Some(number) => u64::try_from(number)
                .map(Self::Unsigned)
                .or_else(|_| i64::try_from(number).map(Self::Signed))
                .unwrap_or_else(|_| Self::Text(number.to_string())),
            // JSON has no infinity
            None => match value.as_real() {
                Some(real) if real.is_finite() => Self::Real(real),
                _ => Self::Text(value.to_string()),
            },
        }
    }
}

impl<'a> Signal<'a> {
    fn of(signal: &'a PdoSignal<'_>) -> Self {
        let value = signal.value.as_ref().map(PlainValue::of);
        Self {
            index: signal.index,
            sub: signal.sub,
            name: &signal.name,
            value: value.or(signal.raw.map(PlainValue::Unsigned)),
            scaled: signal.scaled.as_deref(),
            unit: &signal.unit,
            text: &signal.text,
        }
    }
}

impl Bus<'_> {
    /// What a frame is and says, as a line of `objdict decode --format json` (docs/reference/json.md), without the end of the line.
    pub fn json(&self, decoded: &DecodedFrame, frame: &LoggedFrame) -> String {
        let sdo = decoded.sdo;
        let entry = sdo.and_then(|sdo| sdo.entry);
        let is_complete = sdo.is_some_and(|sdo| sdo.step.has_value());
        let transferred = self.reader.transferred(decoded).filter(|_| is_complete);
        let frame_of_bus = raw(frame);
        let signals = match decoded.kind {
            FrameKind::Pdo if !frame.is_remote => Some(self.reader.signals(decoded, &frame_of_bus)),
            _ => None,
        };
        let document = FrameDocument {
            version: Version,
            time: 0.0,
            channel: &self.channel,
            can_id: frame.can_id,
            extended: frame.is_extended,
            kind: decoded.kind.name(),
            node: decoded.node_id,
            service: decoded.service.map(|service| service.to_string()),
            data: digits(frame.data(), ""),
            remote: frame.is_remote,
            error: frame.is_error,
            text: self.words(decoded, frame),
            index: entry.map(|(index, _)| index),
            sub: entry.map(|(_, sub)| sub),
            value: transferred.as_ref().and_then(|(_, value)| value.as_ref().map(PlainValue::of)),
            bytes: transferred.as_ref().map(|(bytes, _)| digits(bytes, "")),
            abort: sdo.and_then(|sdo| match sdo.step {
                TransferStep::Abort(code) => Some(code),
                _ => None,
            }),
            signals: signals.as_ref().map(|signals| signals.iter().map(Signal::of).collect()),
        };
        let text = json::text(&document).unwrap_or_default();
        let rest = text.strip_prefix(START).unwrap_or_default();
        // a number of JSON has the digits of the log, which a floating-point number would not keep
        format!("{{\"version\":{VERSION},\"time\":{},{rest}", frame.time)
    }
}

/// Bytes in hex.
pub fn digits(bytes: &[u8], between: &str) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(between)
}

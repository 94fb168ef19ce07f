//! Views of the MicroCANopen templates.

use askama::Template;

use super::image::{Image, ImageEntry};
use super::pdos::Call;
use super::replies::Reply;
use crate::Options;
use crate::c_code::little_endian;
use crate::dictionary::Dictionary;
use crate::escape::filters;
use crate::model::PdoKind;
use crate::resolve::Datum;

/// Data common to both files.
pub(super) struct Head {
    lower: String,
    upper: String,
    stem: String,
    made_by: String,
    product: String,
    vendor: String,
    node_id: u8,
    heartbeat: u16,
    size: usize,
}

/// The tables.
#[derive(Template)]
#[template(path = "microcanopen/mco.c", escape = "none")]
pub(super) struct Source<'a> {
    head: &'a Head,
    entries: &'a [ImageEntry],
    replies: &'a [Reply],
    tpdos: Vec<String>,
    rpdos: Vec<String>,
    /// Bytes of the image with a non-zero initial value: offset and value.
    defaults: Vec<(String, String)>,
}

/// The process image.
#[derive(Template)]
#[template(path = "microcanopen/pimg.h", escape = "none")]
pub(super) struct Header<'a> {
    head: &'a Head,
    entries: Vec<&'a ImageEntry>,
}

impl Head {
    pub(super) fn new(
        dictionary: &Dictionary<'_>,
        image: &Image,
        options: &Options,
        (prefix, stem): (&str, &str),
    ) -> Self {
        let device = dictionary.device;
        let info = device.device_info.as_ref();
        let heartbeat = device.entry(0x1017, 0).and_then(|entry| entry.value()?.as_integer());
        Self {
            lower: prefix.to_owned(),
            upper: prefix.to_ascii_uppercase(),
            stem: stem.to_owned(),
            made_by: options.made_by(),
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            node_id: dictionary.node_id.unwrap_or(1),
            heartbeat: heartbeat.and_then(|time| u16::try_from(time).ok()).unwrap_or(0),
            size: image.size,
        }
    }
}

impl ImageEntry {
    fn place(&self) -> usize {
        self.offset.unwrap_or(0) // all are placed before they are shown
    }

    fn flags(&self) -> String {
        let mut flags = self.size.to_string();
        for (flag, set) in [("ODRD", self.read), ("ODWR", self.write)] {
            if set {
                flags = format!("{flags} | {flag}");
            }
        }
        flags
    }

    /// The bytes with a non-zero initial value.
    fn default_bytes(&self, node_id: &str) -> Vec<(String, String)> {
        let offset = |at: usize| match at {
            0 => format!("P_{}_OFF", self.name),
            _ => format!("P_{}_OFF + {at}", self.name),
        };
        match &self.default {
            Datum::Formula(base) => (0..self.size)
                .map(|at| (offset(at), format!("((0x{base:X}L + {node_id}) >> {}) & 0xFF", 8 * at)))
                .collect(),
            Datum::Word(word) => not_zero(&little_endian(*word, self.size), offset),
            Datum::Bytes(bytes) => not_zero(bytes, offset),
        }
    }
}

fn not_zero(bytes: &[u8], offset: impl Fn(usize) -> String) -> Vec<(String, String)> {
    let bytes = bytes.iter().enumerate().filter(|(_, byte)| **byte != 0);
    bytes.map(|(at, byte)| (offset(at), format!("0x{byte:02X}"))).collect()
}

impl<'a> Source<'a> {
    pub(super) fn new(head: &'a Head, image: &'a Image, replies: &'a [Reply], calls: &[Call]) -> Self {
        let node_id = format!("{}_NODE_ID", head.upper);
        let of = |kind: PdoKind| {
            calls.iter().filter(|call| call.kind == kind).map(|call| statement(call, &node_id)).collect()
        };
        Self {
            head,
            entries: &image.entries,
            replies,
            tpdos: of(PdoKind::Tpdo),
            rpdos: of(PdoKind::Rpdo),
            defaults: image.entries.iter().flat_map(|entry| entry.default_bytes(&node_id)).collect(),
        }
    }
}

impl<'a> Header<'a> {
    pub(super) fn new(head: &'a Head, image: &'a Image) -> Self {
        let mut entries: Vec<&ImageEntry> = image.entries.iter().collect();
        entries.sort_by_key(|entry| entry.offset);
        Self { head, entries }
    }
}

/// The call in C syntax.
fn statement(call: &Call, node_id: &str) -> String {
    let Call { number, event, inhibit, length, offset, .. } = call;
    let can_id = match call.can_id {
        None => "0".to_owned(),
        Some((base, true)) => format!("0x{base:03X} + {node_id}"),
        Some((id, false)) => format!("0x{id:03X}"),
    };
    match call.kind {
        PdoKind::Tpdo => format!("MCO_InitTPDO({number}, {can_id}, {event}, {inhibit}, {length}, {offset});"),
        PdoKind::Rpdo => format!("MCO_InitRPDO({number}, {can_id}, {length}, {offset});"),
    }
}

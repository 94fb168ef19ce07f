//! Sentences about communication, built from parts that each refer to an entry.

use super::anchor::Anchor;
use crate::Language;
use crate::describe::Decoder;
use crate::model::{CobId, Device};

/// A part of a sentence, followed by a comma.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Clause {
    pub(crate) text: String,
    /// The source entry, if the description has it.
    pub(crate) anchor: Option<Anchor>,
    /// Whether the configured value differs from the default.
    pub(crate) is_changed: bool,
    /// The default as text, if the configured value differs.
    pub(crate) default: Option<String>,
}

impl Clause {
    /// A part without a source entry.
    pub(super) fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), anchor: None, is_changed: false, default: None }
    }

    /// A part about an entry.
    pub(super) fn of(decoder: &Decoder<'_>, index: u16, sub: u8, text: impl Into<String>) -> Self {
        let entry = decoder.device.entry(index, sub).filter(|entry| entry.is_changed(decoder.node_id));
        let default = entry.as_ref().and_then(|entry| entry.default.as_ref());
        Self {
            text: text.into(),
            anchor: anchor(decoder.device, index, sub),
            is_changed: entry.is_some(),
            default: default.and_then(|default| decoder.of(index, sub, default)),
        }
    }

    /// Restricts the change mark to changes that this part describes.
    pub(super) fn only_if(self, is_changed: bool) -> Self {
        if is_changed { self } else { Self { is_changed: false, default: None, ..self } }
    }
}

/// The anchor of an entry, if the page has it.
pub(super) fn anchor(device: &Device, index: u16, sub: u8) -> Option<Anchor> {
    let object = device.object(index)?;
    if !object.has(sub) {
        return Some(Anchor::object(index));
    }
    Some(Anchor::entry(index, sub))
}

/// Whether the configured value of an entry differs from the default.
pub(super) fn is_changed(decoder: &Decoder<'_>, index: u16, sub: u8) -> bool {
    decoder.device.entry(index, sub).is_some_and(|entry| entry.is_changed(decoder.node_id))
}

/// The parts of a COB-ID that differ from the default.
pub(super) struct ChangedCobId {
    pub(super) can_id: bool,
    pub(super) bit_31: bool,
    pub(super) bit_30: bool,
}

impl ChangedCobId {
    /// Compares the COB-ID in an entry with its default; without a default, all parts are considered changed.
    pub(super) fn of(decoder: &Decoder<'_>, index: u16, sub: u8) -> Self {
        let entry = decoder.device.entry(index, sub).filter(|entry| entry.is_changed(decoder.node_id));
        let Some(entry) = entry else { return Self { can_id: false, bit_31: false, bit_30: false } };
        let ids = entry.default.as_ref().zip(entry.configured_value());
        let ids = ids.and_then(|(old, new)| CobId::from_value(old).zip(CobId::from_value(new)));
        let Some((old, new)) = ids else { return Self { can_id: true, bit_31: true, bit_30: true } };
        Self {
            can_id: !is_same(old, new, decoder.node_id),
            bit_31: old.is_valid() != new.is_valid(),
            bit_30: old.bit_30() != new.bit_30(),
        }
    }
}

/// Whether two CAN-IDs are equal on the node or, if the node-ID is unknown, on every node.
pub(super) fn is_same(one: CobId, other: CobId, node_id: Option<u8>) -> bool {
    let on = |node| one.can_id(node) == other.can_id(node);
    one.is_extended() == other.is_extended() && node_id.map_or(on(1) && on(127), on)
}

/// A COB-ID of the node: `COB-ID 0x185 with node-ID 5`, `COB-ID $NODEID+0x180`.
pub(super) fn cob_id(decoder: &Decoder<'_>, id: CobId) -> String {
    let number = crate::describe::can_id(id, decoder.node_id);
    let mut text = format!("COB-ID {number}");
    if let Some(node) = decoder.node_id.filter(|_| id.depends_on_node_id()) {
        text += &match decoder.language {
            Language::English => format!(" with node-ID {node}"),
            Language::German => format!(" mit Knotennummer {node}"),
        };
    }
    if id.is_extended() {
        text += decoder.language.pick(" (29 bits)", " (29 Bit)");
    }
    text
}

/// The text of the parts, separated by commas.
#[cfg(test)]
pub(super) fn joined(parts: &[Clause]) -> String {
    parts.iter().map(|part| &*part.text).collect::<Vec<_>>().join(", ")
}

//! COB-IDs: the CAN-ID, its length, and the meaning of the upper bits.

use super::decoder::Decoder;
use crate::model::{CobId, PdoKind, Value};

/// A CAN-ID for a node, else as a formula: `0x185`, `$NODEID+0x180`.
pub(crate) fn can_id(id: CobId, node_id: Option<u8>) -> String {
    let formula = match node_id {
        None if id.depends_on_node_id() => CobId::per_node(id.number() & 0x1FFF_FFFF),
        _ => None,
    };
    match formula {
        Some(formula) => formula.to_string(),
        None => spelled(id.can_id(node_id.unwrap_or_default()), id.is_extended()),
    }
}

/// A CAN-ID with the number of digits of its frame format.
pub(crate) fn spelled(can_id: u32, is_extended: bool) -> String {
    if is_extended { format!("0x{can_id:08X}") } else { format!("0x{can_id:03X}") }
}

impl Decoder<'_> {
    pub(super) fn sync_cob_id(&self, value: &Value) -> Option<String> {
        self.cob_id(value, |id| match id.bit_30() {
            true => self.pick("produces SYNC", "sendet SYNC"),
            false => self.pick("consumes SYNC", "empfängt SYNC"),
        })
    }

    pub(super) fn time_cob_id(&self, value: &Value) -> Option<String> {
        self.cob_id(value, |id| self.time_roles(id))
    }

    /// Whether the device consumes or produces TIME.
    pub(crate) fn time_roles(&self, id: CobId) -> &'static str {
        let (english, german) = match (!id.is_valid(), id.bit_30()) {
            (true, true) => ("consumes and produces TIME", "empfängt und sendet TIME"),
            (true, false) => ("consumes TIME", "empfängt TIME"),
            (false, true) => ("produces TIME", "sendet TIME"),
            (false, false) => ("neither consumes nor produces TIME", "weder Empfänger noch Sender von TIME"),
        };
        self.language.pick(english, german)
    }

    /// The COB-ID of a service with a valid bit (bit 31).
    pub(super) fn service_cob_id(&self, value: &Value) -> Option<String> {
        self.cob_id(value, |id| self.validity(id))
    }

    pub(super) fn sdo_cob_id(&self, value: &Value) -> Option<String> {
        self.cob_id(value, |id| match (id.is_valid(), id.bit_30()) {
            (true, true) => self.pick("valid, assigned dynamically", "gültig, dynamisch vergeben"),
            (false, true) => self.pick("not valid, assigned dynamically", "ungültig, dynamisch vergeben"),
            (_, false) => self.validity(id),
        })
    }

    pub(super) fn pdo_cob_id(&self, kind: PdoKind, value: &Value) -> Option<String> {
        self.cob_id(value, |id| match id.is_valid() && id.bit_30() && kind == PdoKind::Tpdo {
            true => self.pick("valid, no remote frames", "gültig, keine Remote-Frames"),
            false => self.validity(id),
        })
    }

    pub(super) fn emergency_consumer(&self, node: u8, value: &Value) -> Option<String> {
        let id = self.service_cob_id(value)?;
        Some(format!("{} {node}: {id}", self.pick("EMCY of node", "EMCY des Knotens")))
    }

    fn cob_id<'t>(&self, value: &Value, flags: impl Fn(CobId) -> &'t str) -> Option<String> {
        let id = CobId::from_value(value)?;
        let length = if id.is_extended() { "29" } else { "11" };
        let bits = self.pick("bits", "Bit");
        Some(format!("CAN-ID {}, {length} {bits}, {}", can_id(id, self.node_id), flags(id)))
    }

    /// Whether bit 31 leaves the service valid.
    pub(crate) fn validity(&self, id: CobId) -> &'static str {
        let (english, german) = if id.is_valid() { ("valid", "gültig") } else { ("not valid", "ungültig") };
        self.language.pick(english, german)
    }
}

//! PDOs, and SRDOs (CiA 304), which have the same structure.

use super::decoder::Decoder;
use super::time;
use crate::model::{CobId, DataType, MappedObject, PdoKind, Value};
use crate::{Language, profile};

impl Decoder<'_> {
    pub(super) fn of_pdo(&self, index: u16, sub: u8, value: &Value) -> Option<String> {
        let number = || u32::try_from(value.as_integer()?).ok();
        if PdoKind::of_mapping(index).is_some() {
            return if sub == 0 { self.mapped_count(number()?) } else { self.mapped(number()?) };
        }
        let (kind, _) = PdoKind::of_communication(index)?;
        match sub {
            1 => self.pdo_cob_id(kind, value),
            2 => number().map(|number| self.transmission_type(kind, number)),
            3 => number().map(|time| self.or_off(time, time::of_tenths)),
            5 => number().map(|time| self.or_off(time, time::of_milliseconds)),
            6 => number().map(|start| self.sync_start(start)),
            _ => None,
        }
    }

    /// When a PDO is sent or its data are applied.
    pub(crate) fn transmission_type(&self, kind: PdoKind, number: u32) -> String {
        let (english, german) = match (kind, number) {
            (PdoKind::Tpdo, 0) => {
                ("synchronous, when the value changed", "synchron, wenn sich der Wert geändert hat")
            }
            (PdoKind::Tpdo, 1) => ("synchronous, on every SYNC", "synchron, mit jedem SYNC"),
            (PdoKind::Tpdo, 2..=240) => {
                return match self.language {
                    Language::English => format!("synchronous, every {number} SYNCs"),
                    Language::German => format!("synchron, mit jedem {number}. SYNC"),
                };
            }
            (PdoKind::Rpdo, 0..=240) => {
                ("synchronous, applied on the next SYNC", "synchron, mit dem nächsten SYNC übernommen")
            }
            (PdoKind::Tpdo, 252) => {
                ("on remote frame, sampled on SYNC", "auf Remote-Frame, mit SYNC erfasst")
            }
            (PdoKind::Tpdo, 253) => ("on remote frame", "auf Remote-Frame"),
            (_, 254) => {
                ("event-driven, events of the manufacturer", "ereignisgesteuert, Ereignisse des Herstellers")
            }
            (_, 255) => (
                "event-driven, events of the device profile",
                "ereignisgesteuert, Ereignisse des Geräteprofils",
            ),
            _ => ("reserved", "reserviert"),
        };
        self.pick(english, german).to_owned()
    }

    fn sync_start(&self, start: u32) -> String {
        match (start, self.language) {
            (0, _) => self.pick("off", "aus").to_owned(),
            (1..=240, Language::English) => format!("counts from SYNC {start} on"),
            (1..=240, Language::German) => format!("zählt ab SYNC {start}"),
            _ => self.pick("reserved", "reserviert").to_owned(),
        }
    }

    fn mapped_count(&self, count: u32) -> Option<String> {
        let (english, german) = match count {
            0 => ("nothing is mapped", "nichts gemappt"),
            0xFE => ("MPDO that names its source", "MPDO, das seine Quelle nennt"),
            0xFF => ("MPDO that names its destination", "MPDO, das sein Ziel nennt"),
            65..=0xFD => ("reserved", "reserviert"),
            _ => return None,
        };
        Some(self.pick(english, german).to_owned())
    }

    fn mapped(&self, number: u32) -> Option<String> {
        let object = MappedObject::from_number(number);
        if object.is_unused() {
            return None;
        }
        let bits = match object.bits {
            1 => self.pick("1 bit", "1 Bit").to_owned(),
            bits => format!("{bits} {}", self.pick("bits", "Bit")),
        };
        if object.is_dummy() {
            let (unused, dummy) = (self.pick("unused", "unbenutzt"), DataType(object.index));
            return Some(format!("{bits} {unused} (dummy {dummy})"));
        }
        let (index, sub) = (object.index, object.sub);
        let mut place = format!("0x{index:04X}sub{sub:X}");
        if let Some(entry) = self.device.entry(index, sub) {
            place += &format!(" {}", entry.name);
        } else if let Some((name, _)) = profile::entry(self.device, index, sub) {
            place += &format!(" {name}");
        }
        if self.description.is_some_and(|description| description.entry(index, sub).is_none()) {
            place += self.pick(", which the description lacks", ", den die Beschreibung nicht hat");
        }
        Some(format!("{place}, {bits}"))
    }

    /// The object in a scanner list (1FA0h).
    pub(super) fn scanned(&self, number: u32) -> Option<String> {
        let [sub, low, high, block] = number.to_le_bytes();
        if number == 0 {
            return None;
        }
        let place = format!("0x{:04X}sub{sub:X}", u16::from_le_bytes([low, high]));
        Some(match (block, self.language) {
            (0 | 1, _) => place,
            (_, Language::English) => format!("{place} and the next {}", block - 1),
            (_, Language::German) => format!("{place} und die {} danach", block - 1),
        })
    }

    /// The objects defined in CiA 304.
    pub(super) fn safety(&self, index: u16, sub: u8, value: &Value) -> Option<String> {
        let number = u32::try_from(value.as_integer().unwrap_or_default()).ok()?;
        let (english, german) = match (index, sub) {
            (0x1300, 0) if number == 0 => ("no global fail-safe command", "kein globaler Fail-Safe-Befehl"),
            (0x1300, 0) => ("global fail-safe command", "globaler Fail-Safe-Befehl"),
            (0x13FE, 0) if number == 0xA5 => ("configuration valid", "Konfiguration gültig"),
            (0x13FE, 0) => ("configuration not valid", "Konfiguration ungültig"),
            (0x1301..=0x1340, 1) => match number {
                0 => ("not valid", "ungültig"),
                1 => ("transmitted", "wird gesendet"),
                2 => ("received", "wird empfangen"),
                _ => ("reserved", "reserviert"),
            },
            (0x1301..=0x1340, 2 | 3) => return Some(time::of_milliseconds(number, self.language)),
            (0x1301..=0x1340, 4) => return Some(self.transmission_type(PdoKind::Tpdo, number)),
            (0x1301..=0x1340, 5 | 6) => return self.service_cob_id(value),
            (0x1381..=0x13C0, 1..) => return self.mapped(number),
            _ => return None,
        };
        Some(self.pick(english, german).to_owned())
    }
}

/// A CAN-ID for a node, otherwise as a formula: `0x185`, `$NODEID+0x180`.
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

//! PDOs and SRDOs: communication parameter and mapping are changed while the object is not valid.

use super::{Arranger, EntryKey, INVALID, Stage};

/// Offset from the communication parameter of a PDO to its mapping.
const PDO_MAPPING: u16 = 0x200;

/// Offset from the communication parameter of an SRDO to its mapping.
const SRDO_MAPPING: u16 = 0x80;

/// 13FEh: configuration valid flag of the SRDOs.
const SRDO_VALID: EntryKey = (0x13FE, 0);

/// A PDO with its present and its new COB-ID.
#[derive(Clone, Copy)]
struct OrderedPdo {
    /// Index of the communication parameter.
    communication: u16,
    /// Current and new COB-ID; `None` if sub-index 1 cannot be written.
    cob_ids: Option<(u32, u32)>,
}

impl OrderedPdo {
    fn cob_id(self) -> EntryKey {
        (self.communication, 1)
    }

    /// Whether `other` receives the CAN-ID that this PDO still uses.
    fn gives_id_to(self, other: Self) -> bool {
        let (Some((old, _)), Some((_, new))) = (self.cob_ids, other.cob_ids) else { return false };
        (old | new) & INVALID == 0 && (old ^ new) & 0x1FFF_FFFF == 0
    }
}

impl Arranger<'_, '_> {
    /// Configures the PDOs with these communication parameters one by one (CiA 301 §7.5.2.36, §7.5.2.38). If
    /// an earlier PDO receives the CAN-ID of a later one, the later one is disabled in the first stage.
    pub(super) fn pdos(&mut self, communication: &[u16]) {
        let pdos: Vec<OrderedPdo> =
            communication.iter().map(|&communication| self.pdo_of(communication)).collect();
        for (position, &pdo) in pdos.iter().enumerate() {
            let gives_way = pdos[..position].iter().any(|&before| pdo.gives_id_to(before));
            let stage = if gives_way { Stage::SwitchOff } else { Stage::Pdo };
            self.pdo(pdo, stage);
        }
    }

    fn pdo_of(&mut self, communication: u16) -> OrderedPdo {
        let key = (communication, 1);
        let new = self.settings.target_number(key);
        let cob_ids = new.map(|new| (self.settings.default_number(key).unwrap_or(new), new));
        OrderedPdo { communication, cob_ids }
    }

    fn pdo(&mut self, pdo: OrderedPdo, switch_off: Stage) {
        let cob_id = pdo.cob_id();
        let mut on = None;
        match pdo.cob_ids {
            Some((old, new)) => {
                let off = old | INVALID;
                self.put_number(switch_off, cob_id, off);
                on = Some(new).filter(|&new| new != off);
            }
            None if self.settings.wants(cob_id) => self.write(Stage::Pdo, cob_id),
            None if self.settings.can_write(cob_id) => self.settings.no_cob_id(cob_id),
            None => {}
        }
        self.parameters(pdo.communication);
        self.mapping(Stage::Pdo, pdo.communication + PDO_MAPPING);
        if let Some(new) = on {
            self.put_number(Stage::Pdo, cob_id, new);
        }
    }

    /// Writes the wanted parameters of a PDO except its COB-ID.
    pub(super) fn parameters(&mut self, communication: u16) {
        for key in self.settings.subs(communication).into_iter().map(|sub| (communication, sub)) {
            if key.1 != 1 && self.settings.wants(key) {
                self.write(Stage::Pdo, key);
            }
        }
    }

    /// Writes a mapping: number 0, the objects, the number of objects. All mapped objects are written,
    /// because some devices clear them when the number becomes 0.
    pub(super) fn mapping(&mut self, stage: Stage, mapping: u16) {
        let subs = self.settings.subs(mapping);
        if !subs.iter().any(|&sub| self.settings.wants((mapping, sub))) {
            return;
        }
        let count = (mapping, 0);
        let can_count = self.settings.can_write(count);
        let mapped = if can_count { self.mapped(mapping, &subs) } else { 0 };
        if can_count {
            self.put(stage, count, [0]);
        }
        for key in subs.into_iter().filter(|&sub| sub != 0).map(|sub| (mapping, sub)) {
            if key.1 <= mapped {
                self.write(stage, key);
            } else if self.settings.wants(key) {
                match self.settings.target_number(key) {
                    Some(0) => self.settings.unused(key),
                    _ => self.write(stage, key),
                }
            }
        }
        if can_count && mapped > 0 {
            self.put(stage, count, [mapped]);
        }
    }

    /// The number of mapped objects: sub-index 0, otherwise the number of entries before the first empty one.
    fn mapped(&mut self, mapping: u16, subs: &[u8]) -> u8 {
        if let Some(&[count]) = self.settings.target((mapping, 0)).as_deref() {
            return count;
        }
        let mut mapped = 0;
        for &sub in subs.iter().filter(|&&sub| sub != 0) {
            let filled = self.settings.target_number((mapping, sub)).is_some_and(|object| object != 0);
            if !filled || sub != mapped + 1 {
                break;
            }
            mapped = sub;
        }
        mapped
    }

    /// Configures the SRDOs (CiA 301 §7.5.2.40 to §7.5.2.43). Their configuration is marked invalid first;
    /// the checksums and the valid flag are written last.
    pub(super) fn srdos(&mut self, keys: &[EntryKey]) {
        let stage = Stage::Communication;
        if self.settings.can_write(SRDO_VALID) {
            self.put(Stage::SwitchOff, SRDO_VALID, [0]);
        }
        for communication in 0x1301..=0x1340 {
            self.srdo(communication);
        }
        for &key in keys.iter().filter(|(index, _)| matches!(index, 0x1341..=0x1380 | 0x13C1..=0x13FF)) {
            if key != SRDO_VALID {
                self.write(stage, key);
            }
        }
        if let Some(valid) = self.settings.target(SRDO_VALID).filter(|data| data != &[0]) {
            self.put(stage, SRDO_VALID, valid);
        }
    }

    /// Configures one SRDO; its direction is 0 (disabled) while it is changed.
    fn srdo(&mut self, communication: u16) {
        let stage = Stage::Communication;
        let direction = (communication, 1);
        let mapping = communication + SRDO_MAPPING;
        let mut keys = Vec::new();
        for index in [communication, mapping] {
            keys.extend(self.settings.subs(index).into_iter().map(|sub| (index, sub)));
        }
        keys.retain(|&key| self.settings.wants(key));
        if keys.is_empty() {
            return;
        }
        if self.settings.can_write(direction) {
            self.put(stage, direction, [0]);
        }
        for &key in keys.iter().filter(|&&key| key.0 == communication && key != direction) {
            self.write(stage, key);
        }
        self.mapping(stage, mapping);
        if let Some(on) = self.settings.target(direction).filter(|data| data != &[0]) {
            self.put(stage, direction, on);
        }
    }
}

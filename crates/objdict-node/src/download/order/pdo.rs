//! PDOs and SRDOs: communication record and mapping are changed while the object is off.

use super::{Arranger, INVALID, Key, Stage};

/// From the communication record of a PDO to its mapping.
const PDO_MAPPING: u16 = 0x200;

/// From the communication record of an SRDO to its mapping.
const SRDO_MAPPING: u16 = 0x80;

/// 13FEh: the configuration of the SRDOs is valid.
const SRDO_VALID: Key = (0x13FE, 0);

/// A PDO to be changed, with the COB-ID that it has and the one that it gets.
#[derive(Clone, Copy)]
struct Pdo {
    /// Index of the communication record.
    communication: u16,
    /// Old and new COB-ID; `None` where sub-index 1 cannot be written.
    cob_ids: Option<(u32, u32)>,
}

impl Pdo {
    fn cob_id(self) -> Key {
        (self.communication, 1)
    }

    /// Whether `other` gets the CAN-ID that this PDO still uses.
    fn gives_id_to(self, other: Self) -> bool {
        let (Some((old, _)), Some((_, new))) = (self.cob_ids, other.cob_ids) else { return false };
        (old | new) & INVALID == 0 && (old ^ new) & 0x1FFF_FFFF == 0
    }
}

impl Arranger<'_, '_> {
    /// The PDOs with these communication records, one after the other (CiA 301 §7.5.2.36, §7.5.2.38). One whose CAN-ID
    /// goes to a PDO before it is switched off first of all.
    pub(super) fn pdos(&mut self, communication: &[u16]) {
        let pdos: Vec<Pdo> = communication.iter().map(|&communication| self.pdo_of(communication)).collect();
        for (position, &pdo) in pdos.iter().enumerate() {
            let gives_way = pdos[..position].iter().any(|&before| pdo.gives_id_to(before));
            let stage = if gives_way { Stage::SwitchOff } else { Stage::Pdo };
            self.pdo(pdo, stage);
        }
    }

    fn pdo_of(&mut self, communication: u16) -> Pdo {
        let key = (communication, 1);
        let new = self.settings.target_number(key);
        let cob_ids = new.map(|new| (self.settings.default_number(key).unwrap_or(new), new));
        Pdo { communication, cob_ids }
    }

    fn pdo(&mut self, pdo: Pdo, switch_off: Stage) {
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
        for sub in self.settings.subs(pdo.communication) {
            let key = (pdo.communication, sub);
            if key != cob_id && self.settings.wants(key) {
                self.write(Stage::Pdo, key);
            }
        }
        self.mapping(Stage::Pdo, pdo.communication + PDO_MAPPING);
        if let Some(new) = on {
            self.put_number(Stage::Pdo, cob_id, new);
        }
    }

    /// A mapping: no objects, the objects, their number. All that are mapped are written, for devices forget them with
    /// the number.
    fn mapping(&mut self, stage: Stage, mapping: u16) {
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

    /// The number of mapped objects: what sub-index 0 says, else the number of entries before the first empty one.
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

    /// The SRDOs (CiA 301 §7.5.2.40 to §7.5.2.43): their configuration is invalid while it is changed; the checksums
    /// and the mark that it is valid come last.
    pub(super) fn srdos(&mut self, keys: &[Key]) {
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

    /// One SRDO; its direction is 0, that is none, while it is changed.
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

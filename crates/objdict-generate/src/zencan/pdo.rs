//! The defaults of the PDOs, and the parameter objects that zencan creates from them.

use super::Maker;
use super::answers::{Answer, Held};
use super::view::{Mapping, Pdo, Pdos};
use crate::model::{Access, CobId, Place};
use crate::resolve::Datum;

/// Number of mapped objects per PDO in zencan (`N_MAPPING_PARAMS`).
const MAPPED: u64 = 8;

/// Number of PDOs per direction: zencan counts them in eight bits.
const MOST: u16 = 255;

/// Start of the parameters of a direction.
#[derive(Clone, Copy)]
struct Direction {
    name: &'static str,
    communication: u16,
    mapping: u16,
}

const RPDO: Direction = Direction { name: "rpdo", communication: 0x1400, mapping: 0x1600 };
const TPDO: Direction = Direction { name: "tpdo", communication: 0x1800, mapping: 0x1A00 };

impl Maker<'_> {
    /// All PDOs of the device.
    pub(super) fn pdos(&mut self) -> Pdos {
        let mut pdos = Vec::new();
        let [num_rpdo, num_tpdo] = [RPDO, TPDO].map(|direction| {
            let count = self.count(direction);
            for number in 0..count {
                let is_described = [direction.communication, direction.mapping]
                    .into_iter()
                    .any(|base| self.dictionary.objects.iter().any(|object| object.index == base + number));
                let pdo = self.pdo(direction, number);
                if is_described {
                    pdos.push(pdo);
                }
            }
            count
        });
        Pdos { num_rpdo, num_tpdo, pdos }
    }

    /// The highest PDO number plus one.
    fn count(&self, direction: Direction) -> u16 {
        let bases = [direction.communication, direction.mapping];
        let number =
            |index: u16| bases.iter().find_map(|base| index.checked_sub(*base).filter(|&n| n < MOST));
        self.dictionary
            .objects
            .iter()
            .filter_map(|object| number(object.index))
            .max()
            .map_or(0, |last| last + 1)
    }

    fn pdo(&mut self, direction: Direction, number: u16) -> Pdo {
        let (communication, mapping) = (direction.communication + number, direction.mapping + number);
        let mappings = self.mappings(mapping);
        let (cob_id, add_node_id) = match self.datum(communication, 1) {
            Some(Datum::Word(word)) => (u32::try_from(*word).unwrap_or(CobId::BIT_31), false),
            Some(Datum::Formula(offset)) => (u32::try_from(*offset).unwrap_or(CobId::BIT_31), true),
            _ => (CobId::BIT_31, false),
        };
        let extended = cob_id & CobId::FRAME != 0;
        let mut can_id = cob_id & 0x1FFF_FFFF;
        if (!extended && can_id + 127 > 0xFFFF) || can_id + 127 > 0x1FFF_FFFF {
            can_id &= 0x7FF; // zencan adds only these bits of a CAN-ID
        }
        let pdo = Pdo {
            direction: direction.name,
            number,
            cob_id: can_id,
            extended,
            add_node_id,
            enabled: cob_id & CobId::BIT_31 == 0 && mappings.is_some(),
            rtr_disabled: cob_id & CobId::BIT_30 != 0,
            transmission_type: self.described(communication, 2, 0xFF),
            mappings: mappings.unwrap_or_default(),
        };
        self.parameters(communication, mapping, &pdo);
        pdo
    }

    /// The SDO answers of a PDO's parameter objects.
    fn parameters(&mut self, communication: u16, mapping: u16, pdo: &Pdo) {
        let flag = |is_set: bool, bit: u32| if is_set { bit } else { 0 };
        let cob_id = pdo.cob_id
            | flag(pdo.extended, CobId::FRAME)
            | flag(pdo.rtr_disabled, CobId::BIT_30)
            | flag(!pdo.enabled, CobId::BIT_31);
        let mut answer = Answer::number(Access::Rw, 4, cob_id.into());
        if pdo.add_node_id {
            answer.held = Held::Formula(cob_id.into());
        }
        self.answers.put(communication, 0, Answer::number(Access::Const, 1, 2));
        self.answers.put(communication, 1, answer);
        self.answers.put(communication, 2, Answer::number(Access::Rw, 1, pdo.transmission_type));
        self.answers.put(mapping, 0, Answer::number(Access::Rw, 1, pdo.mappings.len() as u64));
        for sub in 1..=MAPPED as u8 {
            let mapped = pdo.mappings.get(usize::from(sub) - 1);
            let number = mapped.map_or(0, |mapped| {
                u64::from(mapped.index) << 16 | u64::from(mapped.sub) << 8 | u64::from(mapped.bits)
            });
            self.answers.put(mapping, sub, Answer::number(Access::Rw, 4, number));
        }
    }

    /// The mapping of the PDO; `None`, with a note, if zencan does not support all of it.
    fn mappings(&mut self, index: u16) -> Option<Vec<Mapping>> {
        let count = self.described(index, 0, 0xFF);
        let off = "the PDO is not valid";
        if count > MAPPED {
            let text = format!("zencan maps at most {MAPPED} entries to a PDO, not {count}; {off}");
            self.note(Place::entry(index, 0), text);
            return None;
        }
        let mut mappings = Vec::new();
        for sub in 1..=count as u8 {
            let word = match self.datum(index, sub) {
                Some(Datum::Word(word)) => *word,
                _ => 0,
            };
            let mapped = Mapping { index: (word >> 16) as u16, sub: (word >> 8) as u8, bits: word as u8 };
            let size = self.answers.size(mapped.index, mapped.sub);
            let why = match size {
                None => "zencan does not have the mapped entry",
                Some(_) if !mapped.bits.is_multiple_of(8) => "zencan maps whole bytes only",
                Some(size) if size < usize::from(mapped.bits / 8) => "the entry is shorter",
                Some(_) => {
                    mappings.push(mapped);
                    continue;
                }
            };
            let at = format!("{:04X}h sub-index {:02X}h", mapped.index, mapped.sub);
            let text = format!("cannot map {} bits of {at}: {why}; {off}", mapped.bits);
            self.note(Place::entry(index, sub), text);
            return None;
        }
        Some(mappings)
    }
}

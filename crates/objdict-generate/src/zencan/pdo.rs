//! The defaults of the PDOs, and the parameter objects that zencan creates from them.

use super::ConfigMaker;
use super::answers::{EntryAnswer, Held};
use crate::model::{Access, CobId, MappedObject, PdoKind, Place};
use crate::resolve::Encoded;

/// Number of mapped objects per PDO in zencan (`N_MAPPING_PARAMS`).
const MAPPED: u8 = 8;

/// Number of PDOs per direction: zencan uses an eight-bit counter.
const MOST: u16 = 255;

/// The initial state of a PDO.
pub(super) struct ZencanPdo {
    pub(super) kind: PdoKind,
    /// Counted from 0.
    pub(super) number: u16,
    /// The COB-ID in zencan, without the node-ID.
    cob_id: u32,
    pub(super) add_node_id: bool,
    pub(super) transmission_type: u64,
    pub(super) mappings: Vec<MappedObject>,
}

impl ZencanPdo {
    pub(super) fn can_id(&self) -> u32 {
        self.cob_id & CAN_ID
    }

    /// Whether a flag of the COB-ID is set.
    pub(super) fn has(&self, flag: u32) -> bool {
        self.cob_id & flag != 0
    }
}

/// The CAN-ID in a COB-ID.
const CAN_ID: u32 = 0x1FFF_FFFF;

impl ConfigMaker<'_> {
    /// The numbers of RPDOs and TPDOs, and all PDOs of the device.
    pub(super) fn pdos(&mut self) -> ([u16; 2], Vec<ZencanPdo>) {
        let mut pdos = Vec::new();
        let counts = PdoKind::ALL.map(|kind| {
            let count = self.count(kind);
            for number in 1..=count {
                let parameters = kind.communication_index(number).zip(kind.mapping_index(number));
                let Some((communication, mapping)) = parameters else { continue };
                let pdo = self.pdo(kind, number, communication, mapping);
                if [communication, mapping].iter().any(|index| self.dictionary.object(*index).is_some()) {
                    pdos.push(pdo);
                }
            }
            count
        });
        (counts, pdos)
    }

    /// The highest PDO number.
    fn count(&self, kind: PdoKind) -> u16 {
        let pdo = |index| PdoKind::of_communication(index).or(PdoKind::of_mapping(index));
        let pdos = self.dictionary.objects.iter().filter_map(|object| pdo(object.index));
        let numbers = pdos.filter(|&(of, number)| of == kind && number <= MOST).map(|(_, number)| number);
        numbers.max().unwrap_or(0)
    }

    fn pdo(&mut self, kind: PdoKind, number: u16, communication: u16, mapping: u16) -> ZencanPdo {
        let mappings = self.mappings(mapping);
        let stated = self.datum(communication, 1);
        let number_of = |datum: &Encoded| u32::try_from(datum.word()).unwrap_or(CobId::BIT_31);
        let stated_id = stated.filter(|datum| datum.bytes().is_empty()).map_or(CobId::BIT_31, number_of);
        let mut can_id = stated_id & CAN_ID;
        if (stated_id & CobId::FRAME == 0 && can_id + 127 > 0xFFFF) || can_id + 127 > CAN_ID {
            can_id &= 0x7FF; // zencan adds only these bits of a CAN-ID
        }
        let off = if mappings.is_none() { CobId::BIT_31 } else { 0 };
        let pdo = ZencanPdo {
            kind,
            number: number - 1,
            cob_id: can_id | (stated_id & !CAN_ID) | off,
            add_node_id: stated.is_some_and(Encoded::is_formula),
            transmission_type: self.described(communication, 2, 0xFF),
            mappings: mappings.unwrap_or_default(),
        };
        self.parameters(communication, mapping, &pdo);
        pdo
    }

    /// The SDO answers of a PDO's parameter objects.
    fn parameters(&mut self, communication: u16, mapping: u16, pdo: &ZencanPdo) {
        let mut answer = EntryAnswer::number(Access::Rw, 4, pdo.cob_id.into());
        if pdo.add_node_id {
            answer.held = Held::Formula(pdo.cob_id.into());
        }
        self.answers.put(communication, 0, EntryAnswer::number(Access::Const, 1, 2));
        self.answers.put(communication, 1, answer);
        self.answers.put(communication, 2, EntryAnswer::number(Access::Rw, 1, pdo.transmission_type));
        self.answers.put(mapping, 0, EntryAnswer::number(Access::Rw, 1, pdo.mappings.len() as u64));
        let mapped = pdo.mappings.iter().map(|mapped| mapped.to_number()).chain(std::iter::repeat(0));
        for (sub, number) in (1..=MAPPED).zip(mapped) {
            self.answers.put(mapping, sub, EntryAnswer::number(Access::Rw, 4, number.into()));
        }
    }

    /// The mapping of the PDO; `None`, with a note, if zencan does not support all of it.
    fn mappings(&mut self, index: u16) -> Option<Vec<MappedObject>> {
        let count = self.described(index, 0, 0xFF);
        let off = "the PDO is not valid";
        if count > MAPPED.into() {
            let text = format!("zencan maps at most {MAPPED} entries to a PDO, not {count}; {off}");
            self.note(Place::entry(index, 0), text);
            return None;
        }
        let mut mappings = Vec::new();
        for sub in 1..=count as u8 {
            let number = match self.datum(index, sub) {
                Some(Encoded::Word(word)) => *word as u32, // the mapped object is in the lower half
                _ => 0,
            };
            let mapped = MappedObject::from_number(number);
            let why = match self.answers.size(mapped.index, mapped.sub) {
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

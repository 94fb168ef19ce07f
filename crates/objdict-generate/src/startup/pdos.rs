//! PDOs that a stack does not serve.

use std::collections::BTreeSet;

use super::{PdoCause, Stack, number, words};
use crate::Note;
use crate::dictionary::{ResolvedObject, TableDictionary};
use crate::model::{DataType, Device, MappedObject, Pdo, PdoKind, Place};
use crate::resolve::ValueShape;

/// Bits of a COB-ID: not valid, no RTR, 29 bits.
const NOT_VALID: u64 = 1 << 31;
const NO_RTR: u64 = 1 << 30;
const EXTENDED: u64 = 1 << 29;

/// How a stack reads a mapping.
pub(super) struct StackMapping {
    /// Whether it also reads the slots after the number of mapped objects, up to the eighth.
    pub(super) reads_all: bool,
    /// The minimum number of objects that it maps to a TPDO: the first slot may be read even if their number
    /// is 0.
    pub(super) least: u8,
    /// The maximum number of objects that it maps.
    pub(super) most: u8,
    /// The data types that it maps as dummy entries.
    pub(super) is_dummy: fn(&Device, PdoKind, MappedObject) -> bool,
}

/// A cause, and its effect on the PDO.
pub(super) struct CauseRow {
    pub(super) cause: PdoCause,
    /// `None` for both.
    pub(super) kind: Option<PdoKind>,
    /// The stack's reaction, after the PDOs: "will be disabled by the stack".
    pub(super) effect: &'static str,
}

/// PDOs with one cause and effect.
struct Case {
    row: &'static CauseRow,
    kind: PdoKind,
    numbers: Vec<u16>,
    places: Vec<Place>,
    mapped: BTreeSet<MappedObject>,
}

/// A warning for each cause.
pub(super) fn notes(stack: &Stack, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let mut cases: Vec<Case> = Vec::new();
    for pdo in Served::all(dictionary, &stack.mapping) {
        let is_valid = pdo.is_valid();
        let mut rows = stack.pdos.iter().filter(|row| is_valid || row.cause == PdoCause::Number);
        let Some((row, slot)) = rows.find_map(|row| pdo.matches(row)) else { continue };
        let (place, mapped) = pdo.place(row.cause, slot);
        let known = cases.iter_mut().find(|case| std::ptr::eq(case.row, row) && case.kind == pdo.kind);
        match known {
            Some(case) => {
                case.numbers.push(pdo.number);
                case.places.push(place);
                case.mapped.extend(mapped);
            }
            None => cases.push(Case {
                row,
                kind: pdo.kind,
                numbers: vec![pdo.number],
                places: vec![place],
                mapped: mapped.into_iter().collect(),
            }),
        }
    }
    cases.into_iter().filter_map(Case::note).collect()
}

/// A valid PDO as the table has it.
struct Served<'a> {
    kind: PdoKind,
    number: u16,
    dictionary: &'a TableDictionary<'a>,
    communication: Option<&'a ResolvedObject<'a>>,
    mapping: Option<&'a ResolvedObject<'a>>,
    rules: &'a StackMapping,
}

impl<'a> Served<'a> {
    fn all(dictionary: &'a TableDictionary<'a>, rules: &'a StackMapping) -> impl Iterator<Item = Self> {
        dictionary.device.pdos().filter_map(move |pdo| {
            let (kind, number) = (pdo.kind, pdo.number);
            let communication = dictionary.object(pdo.communication_index())?;
            let mapping = dictionary.object(pdo.mapping_index());
            Some(Self { kind, number, dictionary, communication: Some(communication), mapping, rules })
        })
    }

    fn cob_id(&self) -> Option<u64> {
        number(self.communication, 1, 4)
    }

    fn is_valid(&self) -> bool {
        self.cob_id().is_none_or(|cob_id| cob_id & NOT_VALID == 0)
    }

    /// Whether the CAN-ID is 0: a formula adds a node-ID.
    fn is_zero(&self) -> bool {
        let datum = super::datum(self.communication, 1, 4);
        datum.is_some_and(|datum| !datum.is_formula() && datum.word() & 0x7FF == 0)
    }

    /// The CAN-ID on the node.
    fn can_id(&self) -> u64 {
        let datum = super::datum(self.communication, 1, 4);
        datum.map_or(0, |datum| datum.on_node(self.dictionary.node_id) & 0x7FF)
    }

    fn count(&self) -> u8 {
        number(self.mapping, 0, 1).and_then(|count| u8::try_from(count).ok()).unwrap_or(0)
    }

    /// The slots that the stack reads, with the mapped object; `None` for an undescribed slot.
    fn slots(&self) -> impl Iterator<Item = (u8, Option<MappedObject>)> + '_ {
        let least = if self.kind == PdoKind::Tpdo { self.rules.least } else { 0 };
        let (count, most) = (self.count().max(least), self.rules.most);
        let last = match (self.rules.reads_all, count > most) {
            (true, _) => most,
            (false, true) => 0, // an MPDO, or more than the stack supports
            (false, false) => count,
        };
        let mapped = |sub| number(self.mapping, sub, 4).and_then(|word| u32::try_from(word).ok());
        (1..=last).map(move |sub| (sub, mapped(sub).map(MappedObject::from_number)))
    }

    fn mapped(&self) -> impl Iterator<Item = (u8, MappedObject)> + '_ {
        self.slots().filter_map(|(sub, mapped)| Some((sub, mapped?)))
    }

    /// The bits of the PDO.
    fn bits(&self) -> u32 {
        let count = self.count();
        self.mapped().filter(|(sub, _)| *sub <= count).map(|(_, mapped)| u32::from(mapped.bits)).sum()
    }

    /// Whether the bytes of nine objects, without fractions of a byte, do not exceed the limit.
    fn fits_nine(&self) -> bool {
        let bytes = (1..=9).map(|sub| number(self.mapping, sub, 4).map(|word| (word & 0xFF) / 8));
        bytes.sum::<Option<u64>>().is_some_and(|bytes| bytes <= 8)
    }

    /// Whether the PDO has the cause of the row, and the slot's sub-index.
    fn matches(&self, row: &'static CauseRow) -> Option<(&'static CauseRow, Option<u8>)> {
        if row.kind.is_some_and(|kind| kind != self.kind) {
            return None;
        }
        let cob_id = self.cob_id().unwrap_or(0);
        let type_ = number(self.communication, 2, 1);
        let has = match row.cause {
            PdoCause::Number => self.number > 255,
            PdoCause::NoTransmissionType => type_.is_none(),
            PdoCause::NoCobId => self.cob_id().is_none(),
            PdoCause::RtrAllowed => cob_id & NO_RTR == 0,
            PdoCause::Extended => cob_id & EXTENDED != 0,
            PdoCause::NoCanId => self.is_zero(),
            PdoCause::OnNmt => self.bits() > 0 && self.is_zero(),
            PdoCause::NotDispatched => self.bits() > 0 && !(0x180..=0x57F).contains(&self.can_id()),
            PdoCause::Taken => {
                let is_before = |pdo: &Self| pdo.kind == self.kind && pdo.number < self.number;
                let mut before = Self::all(self.dictionary, self.rules).filter(is_before);
                self.bits() > 0 && before.any(|pdo| pdo.can_id() == self.can_id())
            }
            PdoCause::NoMapping => number(self.mapping, 0, 1).is_none(),
            PdoCause::TooMany => self.count() > 8,
            PdoCause::Overrun => self.count() > 8 && self.fits_nine(),
            PdoCause::TooLong => {
                self.bits() > Pdo::FRAME_BITS
                    || self.mapped().any(|(_, mapped)| u32::from(mapped.bits) > Pdo::FRAME_BITS)
            }
            PdoCause::Empty => self.bits() == 0,
            PdoCause::Reserved => matches!(type_, Some(241..=253)),
            PdoCause::NoTrigger => match type_ {
                Some(252 | 253) => cob_id & NO_RTR != 0,
                type_ => matches!(type_, Some(241..=251)),
            },
            PdoCause::SyncStart => number(self.communication, 6, 1).is_some_and(|value| value > 240),
            PdoCause::NoSlot => {
                let missing = self.slots().find(|(_, mapped)| mapped.is_none());
                return missing.map(|(sub, _)| (row, Some(sub)));
            }
            PdoCause::Dummy
            | PdoCause::Missing
            | PdoCause::Bits
            | PdoCause::Direction
            | PdoCause::NotMappable
            | PdoCause::Short
            | PdoCause::Size
            | PdoCause::Length
            | PdoCause::Constant => {
                let wrong = self.mapped().find(|(_, mapped)| self.has(*mapped, row.cause));
                return wrong.map(|(sub, _)| (row, Some(sub)));
            }
        };
        has.then_some((row, None))
    }

    /// Whether a mapped object has the problem of a cause.
    fn has(&self, mapped: MappedObject, cause: PdoCause) -> bool {
        let is_type = mapped.index < 0x20;
        if is_type && (self.rules.is_dummy)(self.dictionary.device, self.kind, mapped) {
            return false;
        }
        let Some(entry) = self.dictionary.entry(mapped.index, mapped.sub) else {
            return cause == if is_type { PdoCause::Dummy } else { PdoCause::Missing };
        };
        let resolved = &entry.resolved;
        let (fits, fits_other) = match self.kind {
            PdoKind::Rpdo => (resolved.rpdo, resolved.tpdo),
            PdoKind::Tpdo => (resolved.tpdo, resolved.rpdo),
        };
        let bytes = usize::from(mapped.bits.div_ceil(8));
        let is_text = matches!(resolved.shape, ValueShape::Bytes(DataType::VISIBLE_STRING, _));
        match cause {
            PdoCause::Length if self.kind == PdoKind::Tpdo => resolved.shape.size() > bytes,
            PdoCause::Length if is_text => resolved.shape.size() < bytes,
            PdoCause::Length => resolved.shape.size() != bytes,
            PdoCause::Constant => resolved.constant && !is_text,
            PdoCause::Bits => !mapped.bits.is_multiple_of(8),
            PdoCause::Direction => !fits && fits_other,
            PdoCause::NotMappable => !fits && !fits_other,
            PdoCause::Short => resolved.shape.size() < bytes,
            PdoCause::Size => {
                let size = resolved.shape.size();
                !matches!(resolved.shape, ValueShape::Bytes(..)) && size <= 8 && size != bytes
            }
            _ => false,
        }
    }

    /// The place of a cause, and the mapped object in it.
    fn place(&self, cause: PdoCause, slot: Option<u8>) -> (Place, Option<MappedObject>) {
        let communication = self.kind.communication_index(self.number).unwrap_or(0x1400);
        let mapping = communication + 0x200;
        let of_communication =
            |sub| match self.communication.is_some_and(|object| object.entry(sub).is_some()) {
                true => Place::entry(communication, sub),
                false => Place::object(communication),
            };
        let place = match (cause, slot) {
            (PdoCause::NoTransmissionType | PdoCause::Reserved | PdoCause::NoTrigger, _) => {
                of_communication(2)
            }
            (
                PdoCause::NoCobId
                | PdoCause::RtrAllowed
                | PdoCause::Extended
                | PdoCause::NoCanId
                | PdoCause::OnNmt
                | PdoCause::NotDispatched
                | PdoCause::Taken,
                _,
            ) => of_communication(1),
            (PdoCause::SyncStart, _) => of_communication(6),
            (PdoCause::Number | PdoCause::NoMapping, _) => Place::object(communication),
            (PdoCause::NoSlot, _) => Place::object(mapping),
            (_, Some(sub)) => Place::entry(mapping, sub),
            (_, None) => Place::entry(mapping, 0),
        };
        let mapped =
            slot.and_then(|slot| self.mapped().find(|(sub, _)| *sub == slot)).map(|(_, mapped)| mapped);
        (place, mapped)
    }
}

impl Case {
    fn note(self) -> Option<Note> {
        let (why, help) = words::why(self.row.cause, self.kind, &self.mapped);
        let text = format!("{} {} {}: {why}", self.kind, words::listed(&self.numbers), self.row.effect);
        let mut places = self.places.into_iter();
        let mut note = Note::new(places.next()?, text).help(help).warning();
        note.also.extend(places);
        Some(note)
    }
}

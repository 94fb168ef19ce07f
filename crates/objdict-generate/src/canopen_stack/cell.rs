//! The data of table rows.

use super::special::{DataField, Special, fits, object_fits, special};
use crate::c_code::{exact_type, number, typed};
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::model::{DataType, Place, TypeKind};
use crate::notes::added;
use crate::resolve::ValueShape;
use crate::{LONGEST_VALUE, Note};

/// Values up to this limit are stored in the row: they fit into a 16-bit pointer.
const LONGEST_DIRECT: u64 = 0xFFFF;

/// Values up to this size need one SDO frame; for these the stack's own block types do not restart.
const ONE_FRAME: usize = 4;

/// The suffix of the type name for an object.
pub(super) fn hook_name(index: u16) -> String {
    format!("hook{index:04X}")
}

/// Storage of a row's value.
#[derive(Clone)]
pub(super) enum Cell {
    /// In the row.
    Direct(u64),
    /// A number in flash or in RAM.
    Number { flash: bool, c_type: &'static str, value: String },
    /// A block of exactly this many bytes.
    Block { flash: bool, bytes: Vec<u8>, c_type: Option<&'static str>, value: String },
    /// A string in flash, handled by the stack's own type.
    Text(Vec<u8>),
    /// Data in flash, not terminated by NUL.
    Data(Vec<u8>),
    /// Data provided by the application.
    Application,
    /// Data of variable length in RAM, up to `room` bytes.
    Bytes { room: usize, bytes: Vec<u8> },
    /// A heartbeat consumer.
    Consumer { time: u16, node_id: u8 },
    /// A parameter group; the value returned by a read.
    Group(u32),
}

/// A row without its names.
pub(super) struct PlannedRow {
    pub(super) type_: RowType,
    pub(super) cell: Cell,
    /// Whether the stack adds the node-ID.
    pub(super) node_id: bool,
}

/// The type of a row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum RowType {
    /// A type of the stack.
    Stack(&'static str),
    /// The type for blocks that this target defines.
    Block,
    /// The type for data of variable length that this target defines.
    Bytes,
}

/// Plans the rows of a dictionary.
pub(super) struct Planner<'a> {
    pub(super) node_id: Option<u8>,
    pub(super) notes: &'a mut Vec<Note>,
}

impl Planner<'_> {
    /// One row per entry of each object.
    pub(super) fn plan(&mut self, dictionary: &TableDictionary<'_>) -> Vec<Vec<PlannedRow>> {
        dictionary.objects.iter().map(|object| self.object(object)).collect()
    }

    fn object(&mut self, object: &ResolvedObject<'_>) -> Vec<PlannedRow> {
        let whole = object_fits(object);
        if !whole {
            let text = "not all entries have the form that the stack expects; they are plain numbers, which the stack ignores";
            self.notes.push(Note::new(Place::object(object.index), text));
        }
        object.entries.iter().map(|entry| self.entry(object, entry, whole)).collect()
    }

    fn entry(&mut self, object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>, whole: bool) -> PlannedRow {
        let resolved = &entry.resolved;
        let place = Place::entry(object.index, entry.sub);
        let writable = resolved.access.is_writable();
        let special = special(object.index, entry.sub, writable).filter(|_| whole);
        if let Some(special) = special {
            if fits(special, resolved) {
                return self.special(object, entry, special);
            }
            let text = format!("the stack expects {} here and ignores the entry", special.wants);
            self.notes.push(Note::new(place.clone(), text));
        }
        let type_ = match resolved.shape {
            ValueShape::Word(data_type) => stack_type(data_type),
            _ => None,
        };
        match (type_, resolved.shape) {
            (Some(type_), ValueShape::Word(data_type)) => {
                let (cell, node_id) = self.number(&place, entry, data_type, true);
                PlannedRow { type_: RowType::Stack(type_), cell, node_id }
            }
            (None, ValueShape::Bytes(data_type, room)) => self.bytes(&place, entry, data_type, room),
            _ => self.block(&place, entry),
        }
    }

    fn special(
        &mut self,
        object: &ResolvedObject<'_>,
        entry: &ResolvedEntry<'_>,
        special: Special,
    ) -> PlannedRow {
        let place = Place::entry(object.index, entry.sub);
        let type_ = RowType::Stack(special.type_);
        let word = entry.resolved.default.word();
        match special.data {
            DataField::Consumer | DataField::Group => {
                if entry.resolved.default.is_formula() {
                    let text = "the stack does not add the node-ID here; it is omitted";
                    self.notes.push(Note::new(place.clone(), text));
                }
                if special.data == DataField::Group {
                    let value = u32::try_from(word).unwrap_or(u32::MAX); // an UNSIGNED32
                    return PlannedRow { type_, cell: Cell::Group(value), node_id: false };
                }
                let [low, high, node_id, rest, ..] = word.to_le_bytes();
                if rest != 0 {
                    let text = format!("`{word:#010X}`: the stack drops bits 24 to 31");
                    self.notes.push(Note::new(place, text));
                }
                let cell = Cell::Consumer { time: u16::from_le_bytes([low, high]), node_id };
                PlannedRow { type_, cell, node_id: false }
            }
            data => {
                let (mut cell, node_id) = self.number(&place, entry, special.wants, data == DataField::Any);
                if let (Cell::Number { flash, .. }, DataField::Ram) = (&mut cell, data) {
                    *flash = false;
                }
                let no_consumers = object.index == 0x1016 && word == 0; // initialising its type would fail
                let type_ = if no_consumers { RowType::Stack("CO_TUNSIGNED8") } else { type_ };
                PlannedRow { type_, cell, node_id }
            }
        }
    }

    /// The value of a number, and whether the stack adds the node-ID.
    fn number(
        &mut self,
        place: &Place,
        entry: &ResolvedEntry<'_>,
        data_type: DataType,
        may_be_direct: bool,
    ) -> (Cell, bool) {
        let resolved = &entry.resolved;
        let word = resolved.default.word();
        let bits = u32::from(data_type.byte_length().unwrap_or(8)) * 8;
        let pattern = word & (u64::MAX >> (64 - bits.clamp(8, 64)));
        let node_id = resolved.default.is_formula();
        if resolved.constant && may_be_direct && pattern <= LONGEST_DIRECT {
            return (Cell::Direct(pattern), node_id);
        }
        let (c_type, value) = exact_type(data_type).zip(number(word, data_type)).unwrap_or_else(|| {
            let text = "C has no literal for a default that is not finite; the variable contains its bits";
            self.notes.push(Note::new(place.clone(), text));
            ("uint32_t", format!("0x{pattern:08X}u"))
        });
        (Cell::Number { flash: resolved.constant, c_type, value }, node_id)
    }

    /// A string, octet string or DOMAIN.
    fn bytes(
        &mut self,
        place: &Place,
        entry: &ResolvedEntry<'_>,
        data_type: DataType,
        room: u16,
    ) -> PlannedRow {
        let resolved = &entry.resolved;
        let bytes = resolved.default.bytes().to_vec();
        let fixed = !resolved.access.is_writable() && (resolved.constant || !bytes.is_empty());
        if bytes.is_empty() && (fixed || room > 0) {
            let text = "an SDO cannot read it while it is empty: the stack aborts the transfer";
            self.notes.push(Note::new(place.clone(), text));
        }
        let text = data_type.kind() == TypeKind::VisibleString && !bytes.contains(&0);
        let (type_, cell) = match (fixed, bytes.len()) {
            (false, _) if room == 0 => (RowType::Stack("CO_TDOMAIN"), Cell::Application),
            (false, _) => (RowType::Bytes, Cell::Bytes { room: usize::from(room), bytes }),
            (true, 1..=ONE_FRAME) => {
                (RowType::Block, Cell::Block { flash: true, bytes, c_type: None, value: String::new() })
            }
            (true, _) if text => (RowType::Stack("CO_TSTRING"), Cell::Text(bytes)),
            (true, _) => (RowType::Stack("CO_TDOMAIN"), Cell::Data(bytes)),
        };
        PlannedRow { type_, cell, node_id: false }
    }

    /// A number without a type in the stack, or a value of a device-specific type.
    fn block(&mut self, place: &Place, entry: &ResolvedEntry<'_>) -> PlannedRow {
        let resolved = &entry.resolved;
        let size = resolved.shape.size().min(LONGEST_VALUE);
        if resolved.default.is_formula() {
            let added = added(self.node_id);
            let text = format!("the stack adds the node-ID only to values of 8, 16 and 32 bits; {added}");
            self.notes.push(Note::new(place.clone(), text));
        }
        let typed = typed(resolved.shape, resolved.default.on_node(self.node_id));
        let typed = typed.and_then(|(data_type, value)| Some((exact_type(data_type)?, value)));
        let mut bytes = resolved.default.bytes_on(self.node_id, size);
        bytes.resize(size, 0);
        let (c_type, value) = typed.map_or((None, String::new()), |(c_type, value)| (Some(c_type), value));
        let cell = Cell::Block { flash: resolved.constant, bytes, c_type, value };
        PlannedRow { type_: RowType::Block, cell, node_id: false }
    }
}

/// The stack's type for a number.
fn stack_type(data_type: DataType) -> Option<&'static str> {
    Some(match data_type.kind() {
        TypeKind::Boolean | TypeKind::Unsigned(8) => "CO_TUNSIGNED8",
        TypeKind::Unsigned(16) => "CO_TUNSIGNED16",
        TypeKind::Unsigned(32) | TypeKind::Real32 => "CO_TUNSIGNED32",
        TypeKind::Signed(8) => "CO_TSIGNED8",
        TypeKind::Signed(16) => "CO_TSIGNED16",
        TypeKind::Signed(32) => "CO_TSIGNED32",
        _ => return None,
    })
}

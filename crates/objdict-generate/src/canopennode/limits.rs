//! Limits: the stack does not check them, so the tables contain a write function for this.

use super::plan::StackObject;
use crate::Note;
use crate::model::{DataType, Place, TypeKind};
use crate::resolve::{Encoded, EntryPlan, ValueShape};

/// Objects written through functions of the stack: first and last index.
const OF_STACK: [(u16, u16); 10] = [
    (0x1001, 0x1001),
    (0x1003, 0x1003),
    (0x1005, 0x1007),
    (0x1010, 0x1012),
    (0x1014, 0x1017),
    (0x1019, 0x1019),
    (0x1200, 0x12FF),
    (0x1300, 0x13FF),
    (0x1400, 0x1BFF),
    (0x1F80, 0x1F80),
];

/// An entry with a limit.
pub(super) struct Limited {
    pub(super) index: u16,
    /// Its row: limits, index, position of the object in the list, sub-index, size, and macros of the source for the kind of
    /// the value and its limits.
    pub(super) row: String,
    /// Whether it is a REAL.
    pub(super) real: bool,
}

/// The number of objects with limits.
pub(super) fn objects(limits: &[Limited]) -> usize {
    limits.chunk_by(|row, next| row.index == next.index).count()
}

pub(super) fn has_real(limits: &[Limited]) -> bool {
    limits.iter().any(|row| row.real)
}

/// The limits of an object, if they can be enforced; otherwise notes report them.
pub(super) fn limited(
    object: &StackObject<'_>,
    position: usize,
    enforce: bool,
    notes: &mut Vec<Note>,
) -> Vec<Limited> {
    let members = object.members().filter(|member| {
        let resolved = &member.entry.resolved;
        resolved.access.is_writable() && resolved.limit().is_some()
    });
    let of_stack = is_of_stack(object.index);
    if enforce && !of_stack {
        return members
            .filter_map(|member| row((object.index, position), member.entry.sub, &member.entry.resolved))
            .collect();
    }
    notes.extend(members.filter_map(|member| {
        let place = Place::entry(object.index, member.entry.sub).field(member.entry.resolved.limit()?);
        let help = "use `--limits`, or reject the value in the application";
        Some(match of_stack {
            true => Note::new(place, "the stack writes the object itself and does not enforce limits"),
            false => Note::new(place, "the stack does not enforce limits").help(help),
        })
    }));
    Vec::new()
}

/// Whether the stack itself reads and writes an object through an extension.
pub(super) fn is_of_stack(index: u16) -> bool {
    OF_STACK.iter().any(|(first, last)| (*first..=*last).contains(&index))
}

fn row((index, position): (u16, usize), sub: u8, resolved: &EntryPlan) -> Option<Limited> {
    let ValueShape::Word(data_type) = resolved.shape else { return None };
    let number = |limit: &Option<Encoded>| format!("0x{:X}ULL", limit.as_ref().map_or(0, Encoded::word));
    let formula = |limit: &Option<Encoded>| limit.as_ref().is_some_and(Encoded::is_formula);
    let flags = [
        ("LIMIT_LOW", resolved.low.is_some()),
        ("LIMIT_HIGH", resolved.high.is_some()),
        ("LIMIT_LOW_NODE_ID", formula(&resolved.low)),
        ("LIMIT_HIGH_NODE_ID", formula(&resolved.high)),
        ("LIMIT_SIGNED", matches!(data_type.kind(), TypeKind::Signed(_))),
        ("LIMIT_REAL", is_real(data_type)),
        ("LIMIT_BYTES", is_bytes(data_type)),
    ];
    let flags: Vec<&str> = flags.into_iter().filter_map(|(flag, set)| set.then_some(flag)).collect();
    let (low, high, flags) = (number(&resolved.low), number(&resolved.high), flags.join(" | "));
    let length = resolved.shape.size();
    let row = format!("{low}, {high}, 0x{index:04X}, {position}, 0x{sub:02X}, {length}, {flags}");
    Some(Limited { index, row, real: is_real(data_type) })
}

fn is_real(data_type: DataType) -> bool {
    matches!(data_type.kind(), TypeKind::Real32 | TypeKind::Real64)
}

/// Whether a value is stored as little-endian bytes instead of a native number.
fn is_bytes(data_type: DataType) -> bool {
    match data_type.kind() {
        TypeKind::Signed(bits) | TypeKind::Unsigned(bits) => !bits.is_power_of_two(),
        _ => false,
    }
}

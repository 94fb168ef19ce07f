//! The memory layout of a storage group: natural alignment, as in all 32-bit ABIs of microcontrollers.

use super::tables::{ComparedMember, MemberKind};

/// A variable and its location.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Located {
    /// Its name, after the name of its record and a dot.
    pub(super) path: String,
    /// The object at the start of its name, and the number of previous variables of that object.
    pub(super) object: (String, usize),
    /// The type with the numbers of elements.
    pub(super) declaration: String,
    /// The offset in bytes; `None` after a type of unknown size.
    pub(super) offset: Option<u64>,
}

/// All variables of a group in order, and its size; `None` with a type of unknown size.
pub(super) fn located(members: &[ComparedMember]) -> (Vec<Located>, Option<u64>) {
    let mut variables = Vec::new();
    let (end, alignment) = place(members, "", Some(0), &mut variables);
    (variables, end.and_then(|end| aligned(end, alignment)))
}

/// Places members from an offset on; returns the offset after them, and their alignment.
fn place(
    members: &[ComparedMember],
    prefix: &str,
    start: Option<u64>,
    variables: &mut Vec<Located>,
) -> (Option<u64>, u64) {
    let mut offset = start;
    let mut widest = 1;
    for member in members {
        match &member.kind {
            MemberKind::Variable(of, counts) => {
                let size = size_of(of);
                let alignment = size.unwrap_or(1);
                widest = widest.max(alignment);
                offset = offset.and_then(|offset| aligned(offset, alignment));
                let counted: String = counts.iter().map(|count| format!("[{count}]")).collect();
                let (path, declaration) = (format!("{prefix}{}", member.name), format!("{of}{counted}"));
                let object: String = path.chars().take("x1018".len()).collect();
                let before = variables.iter().rev().take_while(|other| other.object.0 == object).count();
                variables.push(Located { path, object: (object, before), declaration, offset });
                let elements = counts.iter().try_fold(1_u64, |all, count| all.checked_mul(*count));
                let bytes = elements.zip(size).and_then(|(elements, size)| elements.checked_mul(size));
                offset = offset.zip(bytes).and_then(|(offset, bytes)| offset.checked_add(bytes));
            }
            MemberKind::Record(inner) => {
                let alignment = alignment_of(inner);
                widest = widest.max(alignment);
                offset = offset.and_then(|offset| aligned(offset, alignment));
                let end = place(inner, &format!("{prefix}{}.", member.name), offset, variables).0;
                offset = end.and_then(|end| aligned(end, alignment));
            }
        }
    }
    (offset, widest)
}

fn alignment_of(members: &[ComparedMember]) -> u64 {
    let alignment = |member: &ComparedMember| match &member.kind {
        MemberKind::Variable(of, _) => size_of(of).unwrap_or(1),
        MemberKind::Record(inner) => alignment_of(inner),
    };
    members.iter().map(alignment).max().unwrap_or(1)
}

fn aligned(offset: u64, alignment: u64) -> Option<u64> {
    offset.checked_next_multiple_of(alignment)
}

/// The size of the types that tables use.
pub(super) fn size_of(name: &str) -> Option<u64> {
    Some(match name {
        "bool_t" | "bool" | "char" | "uint8_t" | "int8_t" | "UNS8" | "INTEGER8" => 1,
        "uint16_t" | "int16_t" | "UNS16" | "INTEGER16" => 2,
        "uint32_t" | "int32_t" | "float32_t" | "float" | "UNS32" | "INTEGER32" | "REAL32" => 4,
        "uint64_t" | "int64_t" | "float64_t" | "double" | "UNS64" | "INTEGER64" | "REAL64" => 8,
        _ => return None,
    })
}

//! Values that depend on the node-ID: those computed by the stack, and all others.

use super::plan::StackObject;
use crate::Note;
use crate::dictionary::ResolvedEntry;
use crate::model::Place;
use crate::resolve::{Encoded, ValueShape};

/// The statements that set the values of an object after the node-ID is known.
pub(super) fn applied(object: &StackObject<'_>, prefix: &str) -> Vec<String> {
    let members = object.members().filter(|member| {
        let default = &member.entry.resolved.default;
        default.is_formula() && !stack_adds(object.index, member.entry.sub, default.word())
    });
    members
        .map(|member| {
            let variable = object.variable(prefix, member);
            let base = member.entry.resolved.default.word();
            let suffix = if base > u64::from(u32::MAX) - 0x7F { "ULL" } else { "U" };
            match member.storage.type_.filter(|_| member.storage.elements.is_none()) {
                Some(type_) => format!("{variable} = ({type_})(0x{base:X}{suffix} + id);"),
                None => {
                    format!("setBytes(&{variable}[0], {}, 0x{base:X}{suffix} + id);", member.storage.length)
                }
            }
        })
        .collect()
}

/// Whether the stack adds the node-ID to a value, because it is the COB-ID of the predefined connection set.
pub(crate) fn stack_adds(index: u16, sub: u8, value: u64) -> bool {
    predefined(index, sub).is_some_and(|base| value & 0x7FF == base)
}

/// The COB-ID of a service without its node-ID.
fn predefined(index: u16, sub: u8) -> Option<u64> {
    match (index, sub) {
        (0x1014, 0) => Some(0x80),
        (0x1200, 1) => Some(0x600),
        (0x1200, 2) => Some(0x580),
        (0x1400..=0x1403, 1) => Some(0x200 + 0x100 * u64::from(index - 0x1400)),
        (0x1800..=0x1803, 1) => Some(0x180 + 0x100 * u64::from(index - 0x1800)),
        _ => None,
    }
}

/// Notes fixed numbers that the stack replaces because it treats them as COB-IDs without node-ID.
pub(super) fn notes(object: &StackObject<'_>, node_id: Option<u8>, notes: &mut Vec<Note>) {
    for member in object.members() {
        if let Some(text) = replaced(object.index, member.entry, node_id) {
            notes.push(Note::new(Place::entry(object.index, member.entry.sub), text));
        }
    }
}

/// The stack's handling of a fixed number that it treats as a COB-ID without node-ID.
pub(crate) fn replaced(index: u16, entry: &ResolvedEntry<'_>, node_id: Option<u8>) -> Option<String> {
    let base = predefined(index, entry.sub)?;
    let (ValueShape::Word(_), Encoded::Word(value)) = (entry.resolved.shape, &entry.resolved.default) else {
        return None;
    };
    if value & 0x7FF == base {
        return Some(format!("the stack adds the node-ID to `0x{value:X}`"));
    }
    let is_of_node = node_id.is_some_and(|node_id| *value == base + u64::from(node_id));
    match index {
        _ if is_of_node => None,
        0x1200 => Some(format!("the stack sets it to `$NODEID+0x{base:X}`")),
        0x1014 if value & 0x8000_0000 == 0 => Some(
            "the stack uses `$NODEID+0x80` unless it is compiled with `CO_CONFIG_EM_PROD_CONFIGURABLE`"
                .to_owned(),
        ),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stack_knows_the_predefined_connections() {
        assert!(stack_adds(0x1014, 0, 0x80));
        assert!(stack_adds(0x1403, 1, 0x8000_0500));
        assert!(stack_adds(0x1800, 1, 0x4000_0180));
        assert!(!stack_adds(0x1404, 1, 0x600));
        assert!(!stack_adds(0x1800, 1, 0x280));
        assert!(!stack_adds(0x1280, 1, 0x600));
    }
}

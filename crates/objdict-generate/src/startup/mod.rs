//! What a stack does with a dictionary when it starts: which PDOs it does not serve, which heartbeat consumers it rejects, which
//! SDO servers it lacks. One table for each stack (`stacks`), applied to the resolved entries of a table, with one warning for each
//! cause.

mod cause;
mod consumers;
mod pdos;
mod sdo;
mod stacks;
mod words;

use crate::Note;
use crate::dictionary::{ResolvedObject, TableDictionary};
use crate::resolve::{Encoded, ValueShape};

pub(crate) use stacks::CANOPENNODE;
#[cfg(feature = "stacks")]
pub(crate) use stacks::{CANFESTIVAL, CANOPEN_STACK, CANOPENNODE_V1, LELY};

/// A stack, as far as a dictionary can be served less than described.
pub(crate) struct Stack {
    /// How it reads the mapping of a PDO.
    mapping: pdos::StackMapping,
    /// Why it does not serve PDOs, in the order in which it looks, and what becomes of them.
    pdos: &'static [pdos::CauseRow],
    /// Which heartbeat consumers it takes; `None` if all.
    consumers: Option<consumers::Consumers>,
    /// What it demands of the parameters of SDO channels.
    sdo: &'static [sdo::DemandRow],
}

/// What the stack will not serve.
pub(crate) fn notes(stack: &Stack, dictionary: &TableDictionary<'_>) -> Vec<Note> {
    let mut notes = pdos::notes(stack, dictionary);
    notes.extend(stack.consumers.iter().flat_map(|rules| consumers::notes(rules, dictionary)));
    notes.extend(stack.sdo.iter().flat_map(|row| sdo::notes(row, dictionary)));
    notes
}

/// The initial number of an entry, without the node-ID; `None` if the entry is missing or no number of this many bytes.
fn number(object: Option<&ResolvedObject<'_>>, sub: u8, bytes: usize) -> Option<u64> {
    datum(object, sub, bytes).map(Encoded::word)
}

fn datum<'a>(object: Option<&'a ResolvedObject<'_>>, sub: u8, bytes: usize) -> Option<&'a Encoded> {
    let resolved = &object?.entry(sub)?.resolved;
    let is_number = matches!(resolved.shape, ValueShape::Word(_)) && resolved.shape.size() == bytes;
    is_number.then_some(&resolved.default)
}

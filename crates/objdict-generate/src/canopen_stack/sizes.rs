//! Size of the files in flash and RAM.

use super::Tables;
use super::cell::Type;
use super::special::{RESTORE, STORE};
use crate::Sizes;
use crate::memory::{Extent, Memory, Tally};

/// What the sizes include.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code, the node specification and stack internals";

/// Key, type and data of a row: `CO_OBJ`.
fn row() -> Extent {
    Extent::structure([Extent::WORD, Extent::POINTER, Extent::POINTER])
}

/// `CO_PARA`.
fn group() -> Extent {
    let (word, pointer, reset) = (Extent::WORD, Extent::POINTER, Extent::BYTE);
    Extent::structure([word, word, pointer, pointer, reset, pointer, word])
}

pub(super) fn report(tables: &Tables<'_>) -> Sizes {
    let Tables { dictionary, layout, parameters, rows, .. } = tables;
    let mut tally = Tally::of_dictionary(dictionary);
    rows.iter().for_each(|object| tally.of(object.index, Memory::Flash, row().size));
    tally.rest(Memory::Flash, row().size); // the end mark
    layout.variables.iter().chain(&layout.definitions).for_each(|variable| variable.count(&mut tally));
    for group in &layout.groups {
        let members: Vec<_> =
            group.members.iter().map(|member| (Some(member.index), member.extent())).collect();
        let is_zero = group.members.iter().all(|member| member.is_zero);
        tally.structure(Memory::of_values(is_zero), &members);
        tally.structure(Memory::Flash, &members); // the defaults
    }
    layout.literals.iter().for_each(|&(index, bytes)| tally.of(index, Memory::Flash, bytes));
    tally.of(STORE, Memory::Flash, parameters.store.len() * group().size);
    tally.of(RESTORE, Memory::Flash, parameters.restore.len() * group().size);
    tally.rest(Memory::Flash, usize::from(parameters.nothing));
    for type_ in [Type::Block, Type::Bytes] {
        let functions = if tables.has(type_) { 5 } else { 0 };
        tally.rest(Memory::Flash, Extent::POINTER.times(functions).size);
    }
    tally.report(COUNTED)
}

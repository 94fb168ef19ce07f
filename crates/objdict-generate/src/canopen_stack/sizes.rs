//! Size of the files in flash and RAM.

use super::CanOpenStackView;
use super::cell::RowType;
use super::special::{RESTORE, STORE};
use crate::Sizes;
use crate::memory::{Memory, SizeTally, TypeExtent};

/// What the sizes include.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code, the node specification and stack internals";

/// Key, type and data of a row: `CO_OBJ`.
fn row() -> TypeExtent {
    TypeExtent::structure([TypeExtent::WORD, TypeExtent::POINTER, TypeExtent::POINTER])
}

/// `CO_PARA`.
fn group() -> TypeExtent {
    let (word, pointer, reset) = (TypeExtent::WORD, TypeExtent::POINTER, TypeExtent::BYTE);
    TypeExtent::structure([word, word, pointer, pointer, reset, pointer, word])
}

pub(super) fn report(tables: &CanOpenStackView<'_>) -> Sizes {
    let CanOpenStackView { dictionary, layout, parameters, rows, .. } = tables;
    let mut tally = SizeTally::of_dictionary(dictionary);
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
    for type_ in [RowType::Block, RowType::Bytes] {
        let functions = if tables.has(type_) { 5 } else { 0 };
        tally.rest(Memory::Flash, TypeExtent::POINTER.times(functions).size);
    }
    tally.report(COUNTED)
}

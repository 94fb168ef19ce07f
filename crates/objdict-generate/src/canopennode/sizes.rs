//! Size of the files in flash and RAM.

use super::plan::ObjectLayout;
use super::view::CanOpenNodeView;
use crate::Sizes;
use crate::dictionary::TableDictionary;
use crate::memory::{Memory, SizeTally, TypeExtent};

/// What the sizes include.
const COUNTED: &str = "`OD.c` on a processor of 32 bits; without code and stack internals";

pub(super) fn report(dictionary: &TableDictionary<'_>, tables: &CanOpenNodeView<'_>) -> Sizes {
    let (byte, half, word, pointer) =
        (TypeExtent::BYTE, TypeExtent::HALF, TypeExtent::WORD, TypeExtent::POINTER);
    // OD_obj_record_t, and OD_obj_var_t, which has the same size
    let entry = TypeExtent::structure([pointer, byte, byte, word]);
    let array = TypeExtent::structure([pointer, pointer, byte, byte, word, word]); // OD_obj_array_t
    let list_entry = TypeExtent::structure([half, byte, byte, pointer, pointer]); // OD_entry_t
    let extension = TypeExtent::structure([pointer, pointer, pointer, byte.times(4)]); // with the flags of 32 sub-indexes
    let bound = TypeExtent::number(8);
    let limit = TypeExtent::structure([bound, bound, half, half, byte, byte, byte]); // Limit_t of the tables
    let mut tally = SizeTally::of_dictionary(dictionary);
    for group in &tables.groups {
        let members: Vec<_> = group.fields.iter().map(|field| (Some(field.index), field.extent)).collect();
        let is_zero = group.fields.iter().all(|field| field.is_zero);
        tally.structure(Memory::of_values(is_zero), &members);
    }
    for object in &tables.objects {
        let described = match &object.layout {
            ObjectLayout::Var(_) => entry,
            ObjectLayout::Array(..) => array,
            ObjectLayout::Record(members) => entry.times(members.len()),
        };
        tally.of(object.index, Memory::Flash, described.size);
        tally.of(object.index, Memory::Initialised, list_entry.size);
    }
    // the end of the list, OD_t, and its pointer
    let head = TypeExtent::structure([half, pointer]);
    tally.rest(Memory::Initialised, list_entry.size + head.size + pointer.size);
    for hook in &tables.hooks {
        tally.of(hook.index, Memory::Initialised, extension.size);
    }
    if let Some(limits) = tables.limits.as_ref().filter(|limits| !limits.is_empty()) {
        for row in limits {
            tally.of(row.index, Memory::Flash, limit.size);
        }
        for rows in limits.chunk_by(|row, next| row.index == next.index) {
            tally.of(rows[0].index, Memory::Zeroed, extension.size);
        }
        tally.rest(Memory::Zeroed, TypeExtent::BYTE.size); // the node-ID
    }
    tally.report(COUNTED)
}

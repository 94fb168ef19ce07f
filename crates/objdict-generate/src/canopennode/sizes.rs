//! Size of the files in flash and RAM.

use super::plan::Layout;
use super::view::Tables;
use crate::Sizes;
use crate::dictionary::Dictionary;
use crate::memory::{Extent, Memory, Tally};

/// What the sizes include.
const COUNTED: &str = "`OD.c` on a processor of 32 bits; without code and stack internals";

pub(super) fn report(dictionary: &Dictionary<'_>, tables: &Tables<'_>) -> Sizes {
    let (byte, half, word, pointer) = (Extent::BYTE, Extent::HALF, Extent::WORD, Extent::POINTER);
    // OD_obj_record_t, and OD_obj_var_t, which has the same size
    let entry = Extent::structure([pointer, byte, byte, word]);
    let array = Extent::structure([pointer, pointer, byte, byte, word, word]); // OD_obj_array_t
    let list_entry = Extent::structure([half, byte, byte, pointer, pointer]); // OD_entry_t
    let extension = Extent::structure([pointer, pointer, pointer, byte.times(4)]); // with the flags of 32 sub-indexes
    let bound = Extent::number(8);
    let limit = Extent::structure([bound, bound, half, half, byte, byte, byte]); // Limit_t of the tables
    let mut tally = Tally::of_dictionary(dictionary);
    for group in &tables.groups {
        let members: Vec<_> = group.fields.iter().map(|field| (Some(field.index), field.extent)).collect();
        let is_zero = group.fields.iter().all(|field| field.is_zero);
        tally.structure(Memory::of_values(is_zero), &members);
    }
    for object in &tables.objects {
        let described = match &object.layout {
            Layout::Var(_) => entry,
            Layout::Array(..) => array,
            Layout::Record(members) => entry.times(members.len()),
        };
        tally.of(object.index, Memory::Flash, described.size);
        tally.of(object.index, Memory::Initialised, list_entry.size);
    }
    // the end of the list, OD_t, and its pointer
    let head = Extent::structure([half, pointer]);
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
        tally.rest(Memory::Zeroed, Extent::BYTE.size); // the node-ID
    }
    tally.report(COUNTED)
}

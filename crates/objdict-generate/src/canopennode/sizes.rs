//! Size of the files in flash and RAM.

use super::plan::Layout;
use super::view::Tables;
use crate::Sizes;
use crate::dictionary::Dictionary;
use crate::memory::{Extent, Memory, Tally};

/// What the sizes include.
const COUNTED: &str = "`OD.c` on a processor of 32 bits; without code and stack internals";

/// Pointer, sub-index, attribute and length of an entry: `OD_obj_record_t`; `OD_obj_var_t` has the same size.
fn entry() -> Extent {
    Extent::structure([Extent::POINTER, Extent::BYTE, Extent::BYTE, Extent::WORD])
}

/// `OD_obj_array_t`.
fn array() -> Extent {
    let members = [Extent::POINTER, Extent::POINTER, Extent::BYTE, Extent::BYTE, Extent::WORD, Extent::WORD];
    Extent::structure(members)
}

/// `OD_entry_t`.
fn list_entry() -> Extent {
    Extent::structure([Extent::HALF, Extent::BYTE, Extent::BYTE, Extent::POINTER, Extent::POINTER])
}

/// `OD_extension_t`, with the flags of 32 sub-indexes.
fn extension() -> Extent {
    Extent::structure([Extent::POINTER, Extent::POINTER, Extent::POINTER, Extent::BYTE.times(4)])
}

/// `Limit_t` of the generated tables.
fn limit() -> Extent {
    let bound = Extent::number(8);
    Extent::structure([bound, bound, Extent::HALF, Extent::HALF, Extent::BYTE, Extent::BYTE, Extent::BYTE])
}

pub(super) fn report(dictionary: &Dictionary<'_>, tables: &Tables<'_>) -> Sizes {
    let mut tally = Tally::of_dictionary(dictionary);
    for group in &tables.groups {
        let members: Vec<_> = group.fields.iter().map(|field| (Some(field.index), field.extent)).collect();
        let is_zero = group.fields.iter().all(|field| field.is_zero);
        tally.structure(Memory::of_values(is_zero), &members);
    }
    for object in &tables.objects {
        let described = match &object.layout {
            Layout::Var(_) => entry(),
            Layout::Array(..) => array(),
            Layout::Record(members) => entry().times(members.len()),
        };
        tally.of(object.index, Memory::Flash, described.size);
        tally.of(object.index, Memory::Initialised, list_entry().size);
    }
    // the end of the list, OD_t, and its pointer
    let head = Extent::structure([Extent::HALF, Extent::POINTER]);
    tally.rest(Memory::Initialised, list_entry().size + head.size + Extent::POINTER.size);
    for hook in &tables.hooks {
        tally.of(hook.index, Memory::Initialised, extension().size);
    }
    if let Some(limits) = tables.limits.as_ref().filter(|limits| !limits.is_empty()) {
        for row in limits {
            tally.of(row.index, Memory::Flash, limit().size);
        }
        for rows in limits.chunk_by(|row, next| row.index == next.index) {
            tally.of(rows[0].index, Memory::Zeroed, extension().size);
        }
        tally.rest(Memory::Zeroed, Extent::BYTE.size); // the node-ID
    }
    tally.report(COUNTED)
}

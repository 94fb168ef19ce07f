//! The target `canopennode`: `OD.h` and `OD.c` of CANopenNode 4.

pub(crate) mod compare;
mod limits;
pub(crate) mod names;
pub(crate) mod node_id;
mod notes;
mod plan;
mod storage;
mod view;

use std::borrow::Cow;

pub(super) use self::compare::compare;
use self::plan::ObjectLayout;
use self::view::CanOpenNodeView;
use super::dictionary::TableDictionary;
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Options, Sizes, StackLayout, render, startup};
use crate::memory::{Memory, SizeTally, TypeExtent};
use crate::model::Device;

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let options = &*with_lengths(options);
    let prefix = options.prefix_or("od")?.to_ascii_uppercase();
    let mut dictionary = TableDictionary::new(device, options)?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let mut own = Vec::new();
    let tables = view::CanOpenNodeView::new(&dictionary, options, prefix, &mut own);
    let files = vec![
        render(format!("{}.h", tables.head.stem), tables.header()),
        render(format!("{}.c", tables.head.stem), tables.source()),
    ];
    for object in &tables.objects {
        notes::of_object(object, &mut own);
        node_id::notes(object, dictionary.node_id, &mut own);
    }
    notes::of_stack(device, &mut own);
    notes.append(&mut once_per_device(in_order(own)));
    notes.append(&mut startup::notes(&startup::CANOPENNODE, &dictionary));
    Ok(BackendOutput { files, notes: in_order(notes), size: sizes(&dictionary, &tables) })
}

/// The options with the capacities of the layout: CANopenEditor adds no room to a default.
fn with_lengths(options: &Options) -> Cow<'_, Options> {
    match options.layout {
        StackLayout::Complete => Cow::Borrowed(options),
        _ => Cow::Owned(Options { string_capacity: 1, ..options.clone() }),
    }
}

/// The content that the sizes include.
const COUNTED: &str = "`OD.c` on a processor of 32 bits; without code and stack internals";

fn sizes(dictionary: &TableDictionary<'_>, tables: &CanOpenNodeView<'_>) -> Sizes {
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

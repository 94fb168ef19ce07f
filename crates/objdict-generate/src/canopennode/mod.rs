//! The target `canopennode`: `OD.h` and `OD.c` of CANopenNode 4.

mod compare;
mod config;
mod groups;
mod hooks;
mod limits;
pub(crate) mod names;
pub(crate) mod node_id;
mod notes;
mod plan;
mod sizes;
mod storage;
mod view;

use std::borrow::Cow;

pub(super) use self::compare::compare;
use super::dictionary::TableDictionary;
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Options, StackLayout, render, startup};
use crate::model::Device;

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let options = &*with_lengths(options);
    let prefix = options.prefix_or("od")?.to_ascii_uppercase();
    let mut dictionary = TableDictionary::new(device, options)?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let mut own = Vec::new();
    let tables = view::CanOpenNodeView::new(&dictionary, options, prefix, &mut own);
    let files = vec![
        render(format!("{}.h", tables.prefix), tables.header()),
        render(format!("{}.c", tables.prefix), tables.source()),
    ];
    for object in &tables.objects {
        notes::of_object(object, &mut own);
        node_id::notes(object, dictionary.node_id, &mut own);
    }
    notes::of_stack(device, &mut own);
    notes.append(&mut once_per_device(in_order(own)));
    notes.append(&mut startup::notes(&startup::CANOPENNODE, &dictionary));
    Ok(BackendOutput { files, notes: in_order(notes), size: sizes::report(&dictionary, &tables) })
}

/// The options with the capacities of the layout: CANopenEditor adds no room to a default.
fn with_lengths(options: &Options) -> Cow<'_, Options> {
    match options.layout {
        StackLayout::Complete => Cow::Borrowed(options),
        _ => Cow::Owned(Options { string_capacity: 1, ..options.clone() }),
    }
}

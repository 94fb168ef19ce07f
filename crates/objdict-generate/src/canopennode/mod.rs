//! The target `canopennode`: `OD.h` and `OD.c` of CANopenNode 4.

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

use super::dictionary::Dictionary;
use super::notes::in_order;
use super::{Backend, Choice, GenerateError, Generated, Options, Sizes, StackLayout, render};
use crate::model::Device;

/// The object dictionary of CANopenNode.
pub(super) struct CanOpenNode;

impl Backend for CanOpenNode {
    fn name(&self) -> &'static str {
        "canopennode"
    }

    fn summary(&self) -> &'static str {
        "`OD.h` and `OD.c` of the stack CANopenNode 4"
    }

    fn uses(&self) -> &'static [Choice] {
        &[
            Choice::Names,
            Choice::Renamed,
            Choice::Prefix,
            Choice::Groups,
            Choice::StringCapacity,
            Choice::Hooks,
            Choice::Limits,
            Choice::Layout,
        ]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let options = &*with_lengths(options);
        let prefix = options.prefix_or("od")?.to_ascii_uppercase();
        let mut dictionary = Dictionary::new(device, options)?;
        let mut own = Vec::new();
        let objects = plan::plan(&dictionary, options, &mut own);
        let tables = view::Tables::new(&dictionary, &objects, options, &prefix, &mut own);
        let header = render(format!("{prefix}.h"), &view::Header { tables: &tables })?;
        let source = render(format!("{prefix}.c"), &view::Source { tables: &tables })?;
        for object in &objects {
            notes::of_object(object, &mut own);
            node_id::notes(object, dictionary.node_id, &mut own);
        }
        notes::of_pdos(device, &mut own);
        notes::of_stack(device, &mut own);
        drop(tables);
        drop(objects);
        dictionary.notes.append(&mut super::notes::once_per_device(in_order(own)));
        Ok(Generated { files: vec![header, source], notes: in_order(dictionary.notes) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Sizes, GenerateError> {
        let options = &*with_lengths(options);
        let prefix = options.prefix_or("od")?.to_ascii_uppercase();
        let dictionary = Dictionary::new(device, options)?;
        let mut notes = Vec::new();
        let objects = plan::plan(&dictionary, options, &mut notes);
        let tables = view::Tables::new(&dictionary, &objects, options, &prefix, &mut notes);
        Ok(Sizes::Known(sizes::report(&dictionary, &objects, &tables)))
    }
}

/// The options with the capacities of the layout: CANopenEditor adds no room to a default.
fn with_lengths(options: &Options) -> Cow<'_, Options> {
    match options.layout {
        StackLayout::Complete => Cow::Borrowed(options),
        _ => Cow::Owned(Options { string_capacity: 1, ..options.clone() }),
    }
}

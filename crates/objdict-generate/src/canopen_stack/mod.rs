//! The target `canopen-stack`: the `CO_OBJ` table of embedded-office's canopen-stack 4.4 and its values.
//!
//! One row per sub-index. Constants of up to 16 bits are stored in the row, longer ones in flash; values that
//! can change are separate variables or members of their storage group. The files define additional types
//! where the types of the stack do not follow the description: writable texts, numbers of 24 and of 40 to 64
//! bits, and blocks of up to 4 bytes, which the stack reads only once.

mod cell;
mod checks;
mod layout;
mod para;
mod sizes;
mod special;
mod view;

use super::c_code::file_name;
use super::dictionary::Dictionary;
use super::notes::{in_order, once_per_object};
use super::{Backend, Choice, GenerateError, Generated, Options, Sizes, render};
use crate::model::Device;

/// Tables for canopen-stack.
pub(super) struct CanopenStack;

impl Backend for CanopenStack {
    fn name(&self) -> &'static str {
        "canopen-stack"
    }

    fn summary(&self) -> &'static str {
        "the `CO_OBJ` table of canopen-stack 4.4 (embedded-office), its values and a node specification"
    }

    fn uses(&self) -> &'static [Choice] {
        &[
            Choice::Names,
            Choice::Renamed,
            Choice::Prefix,
            Choice::Groups,
            Choice::StringCapacity,
            Choice::DomainCapacity,
        ]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let mut dictionary = Dictionary::new(device, options)?;
        let prefix = options.prefix_or("od")?;
        let stem = file_name(options, "od");
        let mut notes = std::mem::take(&mut dictionary.notes);
        let mut planner = cell::Planner { node_id: dictionary.node_id, notes: &mut notes };
        let planned = planner.plan(&dictionary);
        let mut layout = layout::Layout::new(&dictionary, &planned, options, &prefix, &mut notes);
        let parameters = para::Parameters::new(&dictionary, &planned, &mut layout, &prefix, &mut notes);
        let rows = view::rows(&dictionary, &planned, &layout);
        checks::check(&dictionary, rows.len(), &mut notes);
        let head = view::Head::new(&dictionary, &rows, options, &prefix, &stem);
        let files = vec![
            render(format!("{stem}.c"), &view::Source::new(&head, &planned, &layout, &parameters, &rows))?,
            render(format!("{stem}.h"), &view::Header::new(&head, &layout))?,
            render(format!("{stem}_spec.c"), &view::Specification::new(&head, &dictionary))?,
        ];
        Ok(Generated { files, notes: once_per_object(in_order(notes)) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Sizes, GenerateError> {
        let dictionary = Dictionary::new(device, options)?;
        let prefix = options.prefix_or("od")?;
        let mut notes = Vec::new();
        let planned = cell::Planner { node_id: dictionary.node_id, notes: &mut notes }.plan(&dictionary);
        let mut layout = layout::Layout::new(&dictionary, &planned, options, &prefix, &mut notes);
        let parameters = para::Parameters::new(&dictionary, &planned, &mut layout, &prefix, &mut notes);
        let rows = view::rows(&dictionary, &planned, &layout);
        Ok(Sizes::Known(sizes::report(&dictionary, &planned, &layout, &parameters, &rows)))
    }
}

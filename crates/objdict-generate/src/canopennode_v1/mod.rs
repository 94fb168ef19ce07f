//! The target `canopennode-v1`: `CO_OD.h` and `CO_OD.c` of CANopenNode 1.3, for products that exist.
//!
//! Structures and names are those of the editors for it. The variables that the stack refers to are always
//! there, so that its sources compile with any description.

mod cell;
mod notes;
mod plan;
mod sizes;
mod special;
mod view;

use super::dictionary::Dictionary;
use super::notes::{in_order, once_per_device};
use super::{Backend, Choice, GenerateError, Generated, Options, Sizes, render};
use crate::model::Device;

/// The object dictionary of CANopenNode 1.3.
pub(super) struct CanOpenNodeV1;

impl Backend for CanOpenNodeV1 {
    fn name(&self) -> &'static str {
        "canopennode-v1"
    }

    fn summary(&self) -> &'static str {
        "`CO_OD.h` and `CO_OD.c` of the stack CANopenNode 1.3"
    }

    fn uses(&self) -> &'static [Choice] {
        &[Choice::Names, Choice::Renamed, Choice::Groups, Choice::StringCapacity, Choice::DomainCapacity]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let mut dictionary = Dictionary::new(device, options)?;
        let mut notes = std::mem::take(&mut dictionary.notes);
        let plan = plan::Plan::new(&dictionary, options, &mut notes);
        let head = view::Head::new(&dictionary, options);
        let files = vec![
            render("CO_OD.h", &view::Header::new(&head, &plan))?,
            render("CO_OD.c", &view::Source::new(&head, &plan))?,
        ];
        Ok(Generated { files, notes: once_per_device(in_order(notes)) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Sizes, GenerateError> {
        let dictionary = Dictionary::new(device, options)?;
        let plan = plan::Plan::new(&dictionary, options, &mut Vec::new());
        Ok(Sizes::Known(sizes::report(&dictionary, &plan)))
    }
}

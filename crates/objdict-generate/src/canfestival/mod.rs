//! The target `canfestival`: the dictionary of CanFestival 3 as its generator objdictgen lays it out.
//!
//! Variables have the names of objdictgen, so that applications compile with either. What its output misses is
//! here: it compiles for any names, limits are checked, and the PDOs of the stack find their mappings.

mod names;
mod plan;
mod positions;
mod ranges;
mod sizes;
mod special;
mod view;

use super::c_code::file_name;
use super::dictionary::Dictionary;
use super::notes::{in_order, once_per_device};
use super::{Backend, Choice, GenerateError, Generated, Options, Sizes, render};
use crate::model::Device;

/// Dictionaries of CanFestival.
pub(super) struct CanFestival;

impl Backend for CanFestival {
    fn name(&self) -> &'static str {
        "canfestival"
    }

    fn summary(&self) -> &'static str {
        "the dictionary of CanFestival 3, with the layout of objdictgen"
    }

    fn uses(&self) -> &'static [Choice] {
        &[
            Choice::Names,
            Choice::Renamed,
            Choice::Prefix,
            Choice::Groups,
            Choice::Hooks,
            Choice::StringCapacity,
            Choice::DomainCapacity,
        ]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let mut dictionary = Dictionary::new(device, options)?;
        let mut notes = std::mem::take(&mut dictionary.notes);
        let prefix = options.prefix_or("od")?;
        let node = options.prefix.as_ref().unwrap_or(&prefix); // as the user spells it: objdictgen does so, too
        let stem = file_name(options, "od");
        let plan = plan::Plan::new(&dictionary, options, node, &mut notes);
        let slots = positions::slots(&plan.objects);
        let head = view::Head::new(&dictionary, options, node, &stem);
        let files = vec![
            render(format!("{stem}.c"), &view::Source::new(&head, &plan, &slots))?,
            render(format!("{stem}.h"), &view::Header::new(&head, &plan))?,
        ];
        Ok(Generated { files, notes: once_per_device(in_order(notes)) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Sizes, GenerateError> {
        let dictionary = Dictionary::new(device, options)?;
        let plan = plan::Plan::new(&dictionary, options, "od", &mut Vec::new());
        Ok(Sizes::Known(sizes::report(&dictionary, &plan, &positions::slots(&plan.objects))))
    }
}

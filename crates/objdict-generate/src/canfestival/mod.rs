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

use super::c_code::file_name;
use super::dictionary::Dictionary;
use super::escape::filters;
use super::head::{Head, files};
use super::notes::{in_order, once_per_device};
use super::{GenerateError, Made, Options, render};
use crate::model::Device;
use plan::Plan;
use positions::{Slot, Slots};

/// What the files have.
struct Tables<'a> {
    /// Its `lower` is the name of the node.
    head: Head,
    dictionary: &'a Dictionary<'a>,
    plan: Plan,
    slots: Slots,
}

files! {
    #[derive(askama::Template)]
    Tables:
    Source "canfestival/od.c"
    Header "canfestival/od.h"
}

pub(super) fn make(device: &Device, options: &Options) -> Result<Made, GenerateError> {
    let mut dictionary = Dictionary::new(device, options)?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let prefix = options.prefix_or("od")?;
    let node = options.prefix.as_ref().unwrap_or(&prefix); // as the user spells it: objdictgen does so, too
    let head = Head::new(device, options, node, &file_name(options, "od"));
    let plan = Plan::new(&dictionary, options, node, &mut notes);
    let slots = positions::slots(&plan.objects);
    let tables = Tables { head, dictionary: &dictionary, plan, slots };
    let stem = &tables.head.stem;
    let files =
        vec![render(format!("{stem}.c"), &Source(&tables))?, render(format!("{stem}.h"), &Header(&tables))?];
    let size = sizes::report(&dictionary, &tables.plan, &tables.slots);
    Ok(Made { files, notes: once_per_device(in_order(notes)), size })
}

impl Tables<'_> {
    fn is_slave(&self) -> u8 {
        let node = self.dictionary.device.commissioning.as_ref();
        u8::from(node.is_none_or(|node| node.manager != Some(true)))
    }

    /// The position of each object.
    fn positions(&self) -> impl Iterator<Item = (usize, usize)> {
        let list = self.slots.list.iter().enumerate();
        list.filter_map(|(position, slot)| match slot {
            Slot::Object(number) => Some((position, *number)),
            _ => None,
        })
    }

    /// Whether a value of bytes depends on the node-ID.
    fn stores_bytes(&self) -> bool {
        let store = format!("{}_store(", self.head.lower);
        self.plan.formulas.iter().any(|formula| formula.starts_with(&store))
    }
}

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
use super::dictionary::TableDictionary;
use super::head::Head;
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Options, render, startup};
use crate::model::{Device, ExtraSection, OBJDICTGEN_SECTION};
use names::{ReservedNames, words};
use plan::CanFestivalPlan;
use positions::{ListSlot, ListSlots};

/// What the files have.
struct CanFestivalView<'a> {
    /// Its `lower` is the name of the node.
    head: Head,
    dictionary: &'a TableDictionary<'a>,
    plan: CanFestivalPlan,
    slots: ListSlots,
}

include!("../../expanded/canfestival/od.c.rs");
include!("../../expanded/canfestival/od.h.rs");

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let mut dictionary = TableDictionary::new(device, options)?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let is_project = project(device).is_some();
    let (node, stem) = match &options.prefix {
        // as the user spells it: objdictgen does so, too
        Some(prefix) => (options.prefix_or("od").map(|_| prefix.clone())?, file_name(options, "od")),
        None if is_project => (node_of_project(device), stem_of_project(options)),
        None => ("od".to_owned(), file_name(options, "od")),
    };
    let head = Head::new(device, options, &node, &stem);
    let names = ReservedNames::new(&node, is_project);
    let plan = CanFestivalPlan::new(&dictionary, options, names, &mut notes);
    notes.append(&mut startup::notes(&startup::CANFESTIVAL, &dictionary));
    let slots = positions::slots(&plan.objects);
    let tables = CanFestivalView { head, dictionary: &dictionary, plan, slots };
    let stem = &tables.head.stem;
    let files =
        vec![render(format!("{stem}.c"), tables.source()), render(format!("{stem}.h"), tables.header())];
    let size = sizes::report(&dictionary, &tables.plan, &tables.slots);
    Ok(BackendOutput { files, notes: once_per_device(in_order(notes)), size })
}

/// What a project of objdictgen says, where the device is of one.
fn project(device: &Device) -> Option<&ExtraSection> {
    device.extra.iter().find(|section| section.name() == OBJDICTGEN_SECTION)
}

/// The name of the node of a project of objdictgen.
fn node_of_project(device: &Device) -> String {
    let stated = device.commissioning.as_ref().and_then(|node| node.node_name.as_deref());
    let stated = stated.or_else(|| device.device_info.as_ref()?.product_name.as_deref());
    let name = words(stated.unwrap_or_default());
    let is_name = |name: &String| name.starts_with(|c: char| c.is_ascii_alphabetic()) && name.len() <= 32;
    Some(name).filter(is_name).unwrap_or_else(|| "od".to_owned())
}

/// The name of the files that are made of a project of objdictgen: its own.
fn stem_of_project(options: &Options) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    let stem: String = options.file_stem.chars().map(|c| if is_part(c) { c } else { '_' }).collect();
    if stem.is_empty() { "od".to_owned() } else { stem }
}

impl CanFestivalView<'_> {
    fn is_slave(&self) -> u8 {
        let device = self.dictionary.device;
        let is_manager = device.commissioning.as_ref().and_then(|node| node.manager) == Some(true);
        let is_master = |section: &ExtraSection| section.entries().any(|entry| entry == ("Type", "master"));
        u8::from(!is_manager && !project(device).is_some_and(is_master))
    }

    /// A COB-ID of the SDO server, which `setNodeId()` changes.
    fn server_cob_id(&self, base: u16) -> String {
        format!("{:08X}", base + u16::from(self.dictionary.node_id.unwrap_or(0)))
    }

    /// The position of each object.
    fn positions(&self) -> impl Iterator<Item = (usize, usize)> {
        let list = self.slots.list.iter().enumerate();
        list.filter_map(|(position, slot)| match slot {
            ListSlot::Object(number) => Some((position, *number)),
            _ => None,
        })
    }

    /// Whether a value of bytes depends on the node-ID.
    fn stores_bytes(&self) -> bool {
        let store = format!("{}_store(", self.head.lower);
        self.plan.formulas.iter().any(|formula| formula.starts_with(&store))
    }
}

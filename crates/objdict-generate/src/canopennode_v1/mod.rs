//! The target `canopennode-v1`: `CO_OD.h` and `CO_OD.c` of CANopenNode 1.3, for products that exist.
//!
//! Structures and names are as in the editors for it. The variables that the stack refers to always exist,
//! so that its sources compile with any description.

mod cell;
mod notes;
mod plan;
mod special;

use super::dictionary::TableDictionary;
use super::head::Head;
use super::memory::{Memory, SizeTally, TypeExtent};
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Options, Sizes, render, startup};
pub(super) use crate::canopennode::compare::rows::compare_v1 as compare;
use crate::model::{DataType, Device};
use crate::resolve::ValueShape;
use cell::ValueLocation;
use plan::CanOpenNodeV1Plan;

/// The content of the files.
struct CanOpenNodeV1View<'a> {
    head: Head,
    dictionary: &'a TableDictionary<'a>,
    plan: CanOpenNodeV1Plan,
    /// The indexes of objects with a function of the application, in hex.
    hooks: Vec<String>,
}

include!("../../expanded/canopennode-v1/CO_OD.h.rs");
include!("../../expanded/canopennode-v1/CO_OD.c.rs");

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let mut dictionary = TableDictionary::new(device, options)?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let plan = CanOpenNodeV1Plan::new(&dictionary, options, &mut notes);
    let hooks = notes::hooked(&dictionary, options, &mut notes);
    let tables =
        CanOpenNodeV1View { head: Head::new(device, options, "", ""), dictionary: &dictionary, plan, hooks };
    let files = vec![render("CO_OD.h", tables.header()), render("CO_OD.c", tables.source())];
    let mut notes = once_per_device(in_order(notes));
    notes.append(&mut startup::notes(&startup::CANOPENNODE_V1, &dictionary));
    Ok(BackendOutput { files, notes: in_order(notes), size: tables.size() })
}

/// The content that the sizes include.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code and stack internals";

impl CanOpenNodeV1View<'_> {
    /// Whether a value of bytes depends on the node-ID.
    fn stores_bytes(&self) -> bool {
        self.plan.formulas.iter().any(|formula| formula.starts_with("CO_OD_store("))
    }

    fn has(&self, index: u16) -> u8 {
        u8::from(self.dictionary.object(index).is_some())
    }

    /// Whether the stack can be an LSS slave: it needs the whole identity.
    fn has_lss(&self) -> u8 {
        let is_number = |sub| {
            let entry = self.dictionary.entry(0x1018, sub);
            entry.is_some_and(|entry| entry.resolved.shape == ValueShape::Word(DataType::UNSIGNED32))
        };
        let info = self.dictionary.device.device_info.as_ref();
        u8::from((1..=4).all(is_number) && info.is_some_and(|info| info.lss_supported == Some(true)))
    }

    fn is_master(&self) -> u8 {
        let device = self.dictionary.device;
        let is_manager = device.commissioning.as_ref().is_some_and(|node| node.manager == Some(true));
        let startup = self.dictionary.entry(0x1F80, 0).map_or(0, |entry| entry.resolved.default.word());
        u8::from(is_manager || startup & 1 == 1)
    }

    fn has_lss_master(&self) -> u8 {
        let info = self.dictionary.device.device_info.as_ref();
        u8::from(info.is_some_and(|info| info.lss_master == Some(true)))
    }

    fn size(&self) -> Sizes {
        let (byte, half, pointer) = (TypeExtent::BYTE, TypeExtent::HALF, TypeExtent::POINTER);
        let row = TypeExtent::structure([half, byte, half, half, pointer]);
        let of_record = TypeExtent::structure([pointer, half, half]);
        let mut tally = SizeTally::of_dictionary(self.dictionary);
        for object in &self.plan.rows {
            tally.of(object.index, Memory::Flash, row.size + of_record.times(object.record.len()).size);
        }
        for location in ValueLocation::ALL {
            let word = [(None, TypeExtent::WORD)]; // before and after the variables, and not zero
            let variables = self.plan.of(&location).flat_map(|variable| variable.extents.iter().copied());
            let members: Vec<_> = word.into_iter().chain(variables).chain(word).collect();
            tally.structure(Memory::Initialised, &members);
        }
        tally.rest(Memory::Zeroed, 1); // the target of rows without an entry
        tally.report(COUNTED)
    }
}

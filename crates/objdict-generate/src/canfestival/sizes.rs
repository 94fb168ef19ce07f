//! Size of the files in flash and RAM.

use super::plan::CanFestivalPlan;
use super::positions::{ListSlot, ListSlots};
use crate::Sizes;
use crate::dictionary::TableDictionary;
use crate::memory::{Memory, SizeTally, TypeExtent};

/// What the sizes include. The state of the node is as long as the configuration of the stack makes it.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code and the state of the stack (`CO_Data`, timers, PDOs)";

pub(super) fn report(dictionary: &TableDictionary<'_>, plan: &CanFestivalPlan, slots: &ListSlots) -> Sizes {
    let (byte, half, word, pointer) =
        (TypeExtent::BYTE, TypeExtent::HALF, TypeExtent::WORD, TypeExtent::POINTER);
    let row = TypeExtent::structure([byte, byte, word, pointer]).size;
    let place = TypeExtent::structure([pointer, byte, half]).size;
    let mut tally = SizeTally::of_dictionary(dictionary);
    plan.definitions.iter().for_each(|definition| definition.count(&mut tally));
    for object in &plan.objects {
        tally.of(object.index, Memory::Flash, object.rows.len() * row);
        let callbacks = if object.callbacks { object.rows.len() } else { 0 };
        tally.of(object.index, Memory::Zeroed, callbacks * pointer.size);
    }
    for slot in &slots.list {
        match slot {
            ListSlot::Object(number) => tally.of(plan.objects[*number].index, Memory::Flash, place),
            _ => tally.rest(Memory::Flash, place),
        }
    }
    if slots.has(ListSlot::NoPdo) {
        tally.rest(Memory::Flash, 6 * row);
        tally.rest(Memory::Initialised, word.size); // its COB-ID
    }
    if slots.has(ListSlot::NoMapping) {
        tally.rest(Memory::Flash, 2 * row);
    }
    if slots.has(ListSlot::Server) {
        tally.rest(Memory::Flash, 3 * row);
        tally.rest(Memory::Initialised, 2 * word.size); // its COB-IDs
    }
    let ranges = half.times(slots.first.len() + slots.last.len()); // of the families
    tally.rest(Memory::Flash, ranges.size + half.size + byte.size); // with their number, and the role of the node
    tally.rest(Memory::Zeroed, word.size); // what a row without a value refers to
    let node_id = dictionary.node_id.unwrap_or(0);
    tally.rest(Memory::of_values(node_id == 0), byte.size);
    tally.report(COUNTED)
}

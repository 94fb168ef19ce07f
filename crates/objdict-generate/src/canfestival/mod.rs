//! The target `canfestival`: the dictionary of CanFestival 3 as its generator objdictgen lays it out.
//!
//! Variables have the names of objdictgen, so that applications compile with either. Improvements over its
//! output: it compiles for any names, limits are checked, and the PDOs of the stack find their mappings.

mod names;
mod plan;
mod ranges;
mod special;

use self::special::Family;
use super::c_code::file_name;
use super::dictionary::TableDictionary;
use super::head::Head;
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Options, Sizes, render, startup};
pub(super) use crate::canopennode::compare::rows::compare_indexes as compare;
use crate::memory::{Memory, SizeTally, TypeExtent};
use crate::model::{Device, ExtraSection, OBJDICTGEN_SECTION};
use names::{ReservedNames, words};
use plan::{CanFestivalPlan, PlannedObject};

/// The content of the files.
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
    let slots = slots(&plan.objects);
    let tables = CanFestivalView { head, dictionary: &dictionary, plan, slots };
    let stem = &tables.head.stem;
    let files =
        vec![render(format!("{stem}.c"), tables.source()), render(format!("{stem}.h"), tables.header())];
    let size = sizes(&dictionary, &tables.plan, &tables.slots);
    Ok(BackendOutput { files, notes: once_per_device(in_order(notes)), size })
}

/// The section of an objdictgen project, if the device comes from one.
fn project(device: &Device) -> Option<&ExtraSection> {
    device.extra.iter().find(|section| section.name() == OBJDICTGEN_SECTION)
}

/// The node name of an objdictgen project.
fn node_of_project(device: &Device) -> String {
    let stated = device.commissioning.as_ref().and_then(|node| node.node_name.as_deref());
    let stated = stated.or_else(|| device.device_info.as_ref()?.product_name.as_deref());
    let name = words(stated.unwrap_or_default());
    let is_name = |name: &String| name.starts_with(|c: char| c.is_ascii_alphabetic()) && name.len() <= 32;
    Some(name).filter(is_name).unwrap_or_else(|| "od".to_owned())
}

/// The file stem for an objdictgen project: its own name.
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

/// The content that the sizes include. The size of the node state depends on the configuration of the stack.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code and the state of the stack (`CO_Data`, timers, PDOs)";

fn sizes(dictionary: &TableDictionary<'_>, plan: &CanFestivalPlan, slots: &ListSlots) -> Sizes {
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
    tally.rest(Memory::Zeroed, word.size); // the target of rows without a value
    let node_id = dictionary.node_id.unwrap_or(0);
    tally.rest(Memory::of_values(node_id == 0), byte.size);
    tally.report(COUNTED)
}

/// A position in the list of objects.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ListSlot {
    /// An object, by its number.
    Object(usize),
    /// No object: position 0 means that the family is empty.
    Nothing,
    /// The parameters of a PDO that is not valid, for a mapping without parameters.
    NoPdo,
    /// A mapping of no objects, for a PDO without a mapping.
    NoMapping,
    /// The parameters of the SDO server, which a node has even without 1200h.
    Server,
}

/// The list, and the first and last position of each family; 0 if it is empty.
struct ListSlots {
    list: Vec<ListSlot>,
    first: [usize; 6],
    last: [usize; 6],
}

impl ListSlots {
    fn has(&self, slot: ListSlot) -> bool {
        self.list.contains(&slot)
    }

    /// The number of TPDOs; at least 1, because C has no empty arrays.
    fn transmitted(&self) -> usize {
        let tpdo = Family::Tpdo as usize;
        if self.first[tpdo] == 0 { 1 } else { self.last[tpdo] - self.first[tpdo] + 1 }
    }
}

fn slots(objects: &[PlannedObject]) -> ListSlots {
    let family = |object: &PlannedObject| Family::of(object.index).filter(|_| !object.misfit);
    let numbered = |wanted: Option<Family>, below: bool| {
        let objects = objects.iter().enumerate();
        objects.filter(move |(_, object)| family(object) == wanted && (object.index < 0x1200) == below)
    };
    let mut list: Vec<ListSlot> = numbered(None, true).map(|(number, _)| ListSlot::Object(number)).collect();
    if list.is_empty() {
        list.push(ListSlot::Nothing);
    }
    let (mut first, mut last) = ([0; 6], [0; 6]);
    for (at, of) in Family::ALL.into_iter().enumerate() {
        let start = list.len();
        let paired = match of {
            Family::Rpdo | Family::Tpdo => {
                Family::ALL.get(at + 1).map(|mapping| (*mapping, 0x200, ListSlot::NoPdo))
            }
            Family::RpdoMapping | Family::TpdoMapping => {
                at.checked_sub(1).and_then(|at| Some((*Family::ALL.get(at)?, -0x200, ListSlot::NoMapping)))
            }
            _ => None,
        };
        let mut found: Vec<(u16, ListSlot)> = numbered(Some(of), false)
            .map(|(number, object)| (object.index, ListSlot::Object(number)))
            .collect();
        if let Some((other, distance, instead)) = paired {
            for (_, object) in numbered(Some(other), false) {
                let index = object.index.wrapping_add_signed(-distance);
                if !found.iter().any(|(known, _)| *known == index) {
                    found.push((index, instead));
                }
            }
        }
        if of == Family::SdoServer && !found.iter().any(|(index, _)| *index == 0x1200) {
            found.push((0x1200, ListSlot::Server));
        }
        found.sort_by_key(|(index, _)| *index);
        list.extend(found.into_iter().map(|(_, slot)| slot));
        if list.len() > start {
            (first[at], last[at]) = (start, list.len() - 1);
        }
    }
    list.extend(numbered(None, false).map(|(number, _)| ListSlot::Object(number)));
    ListSlots { list, first, last }
}

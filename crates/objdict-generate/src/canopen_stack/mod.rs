//! The target `canopen-stack`: the `CO_OBJ` table of embedded-office's canopen-stack 4.4 and its values.
//!
//! One row per sub-index. Constants of up to 16 bits are stored in the row, longer ones in flash; variable
//! values are separate variables or members of their storage group. The files define additional types where
//! the types of the stack do not follow the description: writable strings, numbers of 24 and of 40 to 64
//! bits, and blocks of up to 4 bytes, which the stack reads only once.

mod cell;
mod layout;
mod para;
mod rows;
mod special;

use self::special::{RESTORE, STORE};
use super::c_code::file_name;
use super::dictionary::{ResolvedEntry, TableDictionary};
use super::head::Head;
use super::notes::{in_order, once_per_device};
use super::{BackendOutput, GenerateError, Note, Options, Sizes, render, startup};
pub(super) use crate::canopennode::compare::rows::compare_keys as compare;
use crate::memory::{Memory, SizeTally, TypeExtent};
use crate::model::{Access, Device, Part, Pdo, PdoKind, Place};
use crate::resolve::Encoded;
use cell::{PlannedRow, Planner, RowType};
use layout::RowLayout;
use para::ParameterArrays;
use rows::{StackRow, TypeHook};

/// The content of the files.
struct CanOpenStackView<'a> {
    head: Head,
    dictionary: &'a TableDictionary<'a>,
    planned: Vec<Vec<PlannedRow>>,
    layout: RowLayout,
    parameters: ParameterArrays,
    rows: Vec<StackRow>,
    hooks: Vec<TypeHook>,
}

include!("../../expanded/canopen-stack/od.c.rs");
include!("../../expanded/canopen-stack/od.h.rs");
include!("../../expanded/canopen-stack/spec.c.rs");

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let mut dictionary = TableDictionary::new(device, options)?;
    let prefix = options.prefix_or("od")?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let planned = Planner { node_id: dictionary.node_id, notes: &mut notes }.plan(&dictionary);
    let mut layout = RowLayout::new(&dictionary, &planned, options, &prefix, &mut notes);
    let parameters = ParameterArrays::new(&dictionary, &planned, &mut layout, &prefix, &mut notes);
    let mut rows = rows::rows(&dictionary, &planned, &layout);
    let hooks = rows::mark(&mut rows, options, &prefix, &mut notes);
    check(&dictionary, rows.len(), &mut notes);
    let head = Head::new(device, options, &prefix, &file_name(options, "od"));
    let tables = CanOpenStackView { head, dictionary: &dictionary, planned, layout, parameters, rows, hooks };
    let stem = &tables.head.stem;
    let files = vec![
        render(format!("{stem}.c"), tables.source()),
        render(format!("{stem}.h"), tables.header()),
        render(format!("{stem}_spec.c"), tables.specification()),
    ];
    Ok(BackendOutput { files, notes: once_per_device(in_order(notes)), size: sizes(&tables) })
}

impl CanOpenStackView<'_> {
    /// Whether a row has a type.
    fn has(&self, type_: RowType) -> bool {
        self.planned.iter().flatten().any(|row| row.type_ == type_)
    }

    /// Whether the application replaces a type of this target, and can then call its functions.
    fn shares(&self, type_: RowType) -> bool {
        self.rows.iter().any(|row| row.hooked && row.type_ == type_)
    }

    /// Minimum counts in the configuration of the stack: the middle part of the macro name, the count, the counted
    /// items, and an additional condition.
    fn counts(&self) -> [(&'static str, u16, &'static str, &'static str); 4] {
        let TableDictionary { device, objects, .. } = self.dictionary;
        let highest = |kind: PdoKind| {
            let pdos = device.pdos().filter(|pdo| pdo.kind == kind && pdo.communication.is_some());
            pdos.map(|pdo| pdo.number).max().unwrap_or(1)
        };
        let up_to = |first: u16, last: u16| {
            let indexes = objects.iter().map(|object| object.index);
            indexes.filter(|index| (first..=last).contains(index)).max().map_or(1, |index| index - first + 1)
        };
        [
            ("SSDO", up_to(0x1200, 0x127F), "SDO servers", ""),
            ("CSDO", up_to(0x1280, 0x12FF), "SDO clients", " && USE_CSDO"),
            ("RPDO", highest(PdoKind::Rpdo), "RPDOs", ""),
            ("TPDO", highest(PdoKind::Tpdo), "TPDOs", ""),
        ]
    }

    /// In bit/s.
    fn baud_rate(&self) -> u32 {
        let device = self.dictionary.device;
        let chosen = device.commissioning.as_ref().and_then(|commissioning| commissioning.baud_rate);
        let fastest = || device.device_info.as_ref()?.baud_rates.supported().max();
        u32::from(chosen.or_else(fastest).unwrap_or(125)) * 1000
    }

    /// Heartbeat, SYNC and LSS; a timer per consumer; an event timer and an inhibit time per TPDO.
    fn timers(&self) -> u16 {
        let consumers = self.dictionary.object(0x1016);
        let consumers = consumers.map_or(0, |object| object.entries.len().saturating_sub(1));
        let pdos = self.dictionary.device.pdo_count(PdoKind::Tpdo);
        u16::try_from(3 + consumers + 2 * pdos).unwrap_or(u16::MAX)
    }

    fn has_emcy(&self) -> bool {
        self.dictionary.device.object(0x1014).is_some()
    }
}

/// The content that the sizes include.
const COUNTED: &str = "the tables and values, on a processor of 32 bits; without code, the node specification and stack internals";

/// Key, type and data of a row: `CO_OBJ`.
fn row() -> TypeExtent {
    TypeExtent::structure([TypeExtent::WORD, TypeExtent::POINTER, TypeExtent::POINTER])
}

/// `CO_PARA`.
fn group() -> TypeExtent {
    let (word, pointer, reset) = (TypeExtent::WORD, TypeExtent::POINTER, TypeExtent::BYTE);
    TypeExtent::structure([word, word, pointer, pointer, reset, pointer, word])
}

fn sizes(tables: &CanOpenStackView<'_>) -> Sizes {
    let CanOpenStackView { dictionary, layout, parameters, rows, .. } = tables;
    let mut tally = SizeTally::of_dictionary(dictionary);
    rows.iter().for_each(|object| tally.of(object.index, Memory::Flash, row().size));
    tally.rest(Memory::Flash, row().size); // the end mark
    layout.variables.iter().chain(&layout.definitions).for_each(|variable| variable.count(&mut tally));
    for group in &layout.groups {
        let members: Vec<_> =
            group.members.iter().map(|member| (Some(member.index), member.extent())).collect();
        let is_zero = group.members.iter().all(|member| member.is_zero);
        tally.structure(Memory::of_values(is_zero), &members);
        tally.structure(Memory::Flash, &members); // the defaults
    }
    layout.literals.iter().for_each(|&(index, bytes)| tally.of(index, Memory::Flash, bytes));
    tally.of(STORE, Memory::Flash, parameters.store.len() * group().size);
    tally.of(RESTORE, Memory::Flash, parameters.restore.len() * group().size);
    tally.rest(Memory::Flash, usize::from(parameters.nothing));
    for type_ in [RowType::Block, RowType::Bytes] {
        let functions = if tables.has(type_) { 5 } else { 0 };
        tally.rest(Memory::Flash, TypeExtent::POINTER.times(functions).size);
    }
    tally.report(COUNTED)
}

/// Maximum number of rows in the stack.
const MOST_ROWS: usize = i16::MAX as usize;

/// Adds notes about entries and PDOs, and about missing objects.
fn check(dictionary: &TableDictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let mut common = Vec::new();
    dictionary.entries().for_each(|(object, entry)| self::entry(object.index, entry, &mut common));
    notes.extend(once_per_device(common));
    notes.extend(dictionary.device.pdos().filter_map(|pdo| transmission(&pdo)));
    notes.append(&mut startup::notes(&startup::CANOPEN_STACK, dictionary));
    demands(dictionary, rows, notes);
}

fn entry(index: u16, entry: &ResolvedEntry<'_>, notes: &mut Vec<Note>) {
    let resolved = &entry.resolved;
    let place = || Place::entry(index, entry.sub);
    if let (Some(field), true) = (resolved.limit(), resolved.access.is_writable()) {
        notes.push(Note::new(place().field(field), "the stack does not enforce limits"));
    }
    if resolved.sdo() == (true, true) && resolved.tpdo != resolved.rpdo {
        let kind = if resolved.tpdo { PdoKind::Rpdo } else { PdoKind::Tpdo };
        let text =
            format!("the stack also allows the entry in {kind}s: its row has one flag for both directions");
        notes.push(Note::new(place(), text));
    }
    if (resolved.tpdo || resolved.rpdo) && !matches!(resolved.shape.size(), 1 | 2 | 4) {
        let text = "PDOs of the stack carry values of 1, 2 and 4 bytes; the application transfers others in `COTpdoReadData` and `CORpdoWriteData`";
        notes.push(Note::new(place(), text));
    }
    if index == 0x1003 && entry.sub > 0 && resolved.default != Encoded::Word(0) {
        notes.push(Note::new(place(), "the error history is empty when the stack starts"));
    }
    if (0x1800..=0x19FF).contains(&index) && entry.sub == 6 {
        notes.push(Note::new(place(), "the stack ignores the SYNC start value"));
    }
    if resolved.access == Access::Wo && index == 0x1003 {
        notes.push(Note::new(place(), "an SDO can read the entry although it is write-only"));
    }
}

/// The meaning of a PDO's transmission types for the stack.
fn transmission(pdo: &Pdo<'_>) -> Option<Note> {
    let place = Place::entry(pdo.communication_index(), 2);
    let is_polled = matches!(pdo.transmission_type, Some(252 | 253));
    is_polled.then(|| Note::new(place, "the stack does not answer RTR frames"))
}

/// Requirements of the stack on the whole dictionary.
fn demands(dictionary: &TableDictionary<'_>, rows: usize, notes: &mut Vec<Note>) {
    let has = |index, sub| dictionary.entry(index, sub).is_some();
    let device = |text: &str| Note::new(Part::Device, text.to_owned());
    if !has(0x1001, 0) {
        notes.push(device("without 1001h the stack reports an error when it starts, and sends no EMCY"));
    }
    if !has(0x1014, 0) {
        notes.push(device("without 1014h the stack sends no EMCY"));
    }
    if !has(0x1200, 1) {
        let note = device("without 1200h the stack has no SDO server; it is added with the default COB-IDs");
        notes.push(note.help("describe 1200h, `ro`, with `$NODEID+0x600` and `$NODEID+0x580`"));
    }
    if rows > MOST_ROWS {
        notes.push(device(&format!("{rows} rows, but the stack supports at most {MOST_ROWS}")));
    }
    // the stack does not initialise the first row, which is harmless for plain values
    let first = dictionary.objects.first().map(|object| object.index);
    let special = |index: &u16| *index >= 0x1003 && special::special(*index, 0, false).is_some();
    if let Some(first) = first.filter(special) {
        let text = "the stack does not initialise the first object of a dictionary; 1000h must precede it";
        notes.push(Note::new(Place::object(first), text));
    }
    if has(0, 0) {
        notes
            .push(Note::new(Place::entry(0, 0), "the stack interprets index 0 as the end of the dictionary"));
    }
}

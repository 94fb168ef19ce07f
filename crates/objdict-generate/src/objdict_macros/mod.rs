//! The target `objdict-macros`: `objdict.c` and `mapping.c` in the style of chapter 6.5 of "Embedded
//! Networking with CAN and CANopen": rows of macros with index, length, address and access, and eight mapping
//! entries per PDO.
//!
//! The book shows the macro for a single object. `SUB_OBJ`, for an entry of an object with several, is
//! modelled on it and defined next to it.

use super::c_code::{bytes, exact_type, typed};
use super::dictionary::{ResolvedEntry, TableDictionary};
use super::head::Head;
use super::memory::{Memory, SizeTally, TypeExtent};
use super::names::NameScope;
use super::notes::{added, in_order, once_per_device};
use super::variables::{CType, Definition, WantedName, claim, variables};
use super::{BackendOutput, GenerateError, Note, Options, Sizes, render};
use crate::model::{Device, Pdo, PdoKind, Place};

/// The content of the files.
struct ObjdictMacrosView<'a> {
    head: Head,
    dictionary: &'a TableDictionary<'a>,
    /// The rows of the dictionary.
    rows: Vec<DictionaryRow<'a>>,
    variables: Vec<Definition>,
    pdos: Vec<MappingRow>,
}

/// A row of the dictionary.
struct DictionaryRow<'a> {
    index: u16,
    /// Whether it is the only entry of its object.
    single: bool,
    entry: &'a ResolvedEntry<'a>,
    address: String,
}

include!("../../expanded/objdict-macros/objdict.h.rs");
include!("../../expanded/objdict-macros/objdict.c.rs");
include!("../../expanded/objdict-macros/mapping.c.rs");

pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let mut dictionary = TableDictionary::new(device, options)?;
    let prefix = options.prefix_or("g")?;
    let mut notes = std::mem::take(&mut dictionary.notes);
    let tables = ObjdictMacrosView::new(&dictionary, Head::new(device, options, &prefix, ""), &mut notes);
    let files = vec![
        render("objdict.h", tables.header()),
        render("objdict.c", tables.source()),
        render("mapping.c", tables.mapping()),
    ];
    Ok(BackendOutput { files, notes: once_per_device(in_order(notes)), size: tables.size() })
}

/// The content that the sizes include.
const COUNTED: &str = "the rows as `objdict.h` declares them, mapping and values, on a processor of 32 bits";

impl<'a> ObjdictMacrosView<'a> {
    fn new(dictionary: &'a TableDictionary<'a>, head: Head, notes: &mut Vec<Note>) -> Self {
        let mut scope = NameScope::of_lower_case("");
        let objects = &dictionary.objects;
        let entry = |object: usize, at: usize| &objects[object].entries[at];
        let mut addresses: Vec<Vec<String>> =
            objects.iter().map(|object| vec!["NULL".to_owned(); object.entries.len()]).collect();
        let names = |wanted: &[WantedName<'_>]| claim(&mut scope, &head.lower, wanted);
        let mut definitions = Vec::new();
        for variable in variables(objects, names, |object, at| type_of(entry(object, at))) {
            let (object, name) = (variable.object, format!("{}_{}", head.lower, variable.name));
            for (at, place) in variable.places(&name) {
                addresses[object][at] = format!("&{place}");
            }
            let initial = |at: usize| initial(entry(object, at), dictionary.node_id);
            definitions.push(variable.define(&objects[object], name, initial));
        }
        let addresses = addresses.into_iter().flatten();
        let rows = dictionary.entries().zip(addresses).map(|((object, entry), address)| {
            check(&Place::entry(object.index, entry.sub), entry, dictionary.node_id, notes);
            DictionaryRow { index: object.index, single: object.is_single(), entry, address }
        });
        let rows = rows.collect();
        let mut tables = Self { head, dictionary, rows, variables: definitions, pdos: Vec::new() };
        tables.pdos = pdos(&tables, notes);
        tables
    }

    /// The address of an entry's value; `None` for a missing entry.
    fn address(&self, index: u16, sub: u8) -> Option<&str> {
        let at = self.rows.binary_search_by_key(&(index, sub), |row| (row.index, row.entry.sub)).ok()?;
        self.rows.get(at).map(|row| row.address.as_str())
    }

    /// The PDOs of a direction.
    fn of(&self, kind: PdoKind) -> Vec<&MappingRow> {
        self.pdos.iter().filter(|pdo| pdo.kind == kind).collect()
    }

    fn size(&self) -> Sizes {
        let (half, byte, pointer) = (TypeExtent::HALF, TypeExtent::BYTE, TypeExtent::POINTER);
        let row = TypeExtent::structure([half, byte, byte, TypeExtent::WORD, pointer]);
        let mapped = TypeExtent::structure([half, byte, byte, pointer]);
        let pdo_map = TypeExtent::structure([byte, mapped.times(SLOTS)]);
        let mut tally = SizeTally::of_dictionary(self.dictionary);
        self.rows.iter().for_each(|object| tally.of(object.index, Memory::Flash, row.size));
        self.variables.iter().for_each(|variable| variable.count(&mut tally));
        for pdo in &self.pdos {
            let index = pdo.kind.mapping_index(pdo.number);
            tally.of(index.unwrap_or(0), Memory::Flash, pdo_map.size); // 0: without an object
        }
        tally.report(COUNTED)
    }
}

impl DictionaryRow<'_> {
    /// Length of a value; a read-only string has the length of its default.
    fn length(&self) -> usize {
        self.entry.resolved.shape.size()
    }

    /// The access type in the notation of the book.
    fn access(&self) -> &'static str {
        let resolved = &self.entry.resolved;
        match resolved.sdo() {
            (true, false) if resolved.tpdo => "ROMAP",
            (true, false) => "RO",
            (false, _) if resolved.rpdo => "WOMAP",
            (false, _) => "WO",
            (true, true) if resolved.rpdo => "RWWMAP",
            (true, true) if resolved.tpdo => "RWRMAP",
            (true, true) => "RW",
        }
    }
}

fn type_of(entry: &ResolvedEntry<'_>) -> Option<CType> {
    let resolved = &entry.resolved;
    let constant = if resolved.constant { "const " } else { "" };
    let size = resolved.shape.size();
    let number =
        typed(resolved.shape, resolved.default.word()).and_then(|(data_type, _)| exact_type(data_type));
    (size > 0).then(|| match number {
        Some(c_type) => CType::number(format!("{constant}{c_type}")),
        None => CType::bytes(format!("{constant}uint8_t"), size),
    })
}

/// The initializer of an entry, and whether it is zero.
fn initial(entry: &ResolvedEntry<'_>, node_id: Option<u8>) -> (String, bool) {
    let resolved = &entry.resolved;
    let word = resolved.default.on_node(node_id);
    let is_added = resolved.default.is_formula() && node_id.is_some();
    let text = typed(resolved.shape, word).map_or_else(
        || bytes(&resolved.default.bytes_on(node_id, resolved.shape.size())),
        |(_, number)| number,
    );
    (text, !is_added && resolved.default.is_zero())
}

/// Notes properties that a row cannot express.
fn check(place: &Place, entry: &ResolvedEntry<'_>, node_id: Option<u8>, notes: &mut Vec<Note>) {
    let resolved = &entry.resolved;
    let mut say = |text: String| notes.push(Note::new(place.clone(), text));
    if resolved.limit().is_some() {
        say("a row does not support limits".to_owned());
    }
    if resolved.default.is_formula() {
        say(format!("a row does not add the node-ID; {}", added(node_id)));
    }
    if resolved.tpdo && resolved.rpdo && resolved.sdo() == (true, true) {
        say("a row is mapped in one direction only; RPDO is used".to_owned());
    }
    resolved.padding().into_iter().for_each(&mut say);
    if resolved.shape.size() == 0 {
        say("a row without data: its length is 0".to_owned());
    }
}

/// Number of mapping entries per PDO.
const SLOTS: usize = 8;

/// A PDO.
struct MappingRow {
    kind: PdoKind,
    number: u16,
    /// The mapped entries.
    entries: Vec<String>,
}

impl MappingRow {
    /// The number of unused mapping entries.
    fn unused(&self) -> usize {
        SLOTS.saturating_sub(self.entries.len())
    }
}

/// All PDOs with a mapping, by number per direction; numbers without one are empty.
fn pdos(tables: &ObjdictMacrosView<'_>, notes: &mut Vec<Note>) -> Vec<MappingRow> {
    let mut rows = Vec::new();
    for kind in PdoKind::ALL {
        let of_kind: Vec<Pdo<'_>> = tables.dictionary.device.pdos().filter(|pdo| pdo.kind == kind).collect();
        let last = of_kind.iter().map(|pdo| pdo.number).max().unwrap_or(0);
        for number in 1..=last {
            let pdo = of_kind.iter().find(|pdo| pdo.number == number);
            let entries = pdo.map(|pdo| entries(pdo, tables, notes)).unwrap_or_default();
            rows.push(MappingRow { kind, number, entries });
        }
    }
    rows
}

fn entries(pdo: &Pdo<'_>, tables: &ObjdictMacrosView<'_>, notes: &mut Vec<Note>) -> Vec<String> {
    let index = pdo.mapping_index();
    let mut entries = Vec::new();
    for (slot, mapped) in pdo.mapped_slots() {
        let place = Place::entry(index, slot);
        if entries.len() == SLOTS {
            notes.push(Note::new(place, format!("a PDO has at most {SLOTS} mapping entries")));
            break;
        }
        let (object, sub, bits) = (mapped.index, mapped.sub, mapped.bits);
        let address = match tables.address(object, sub) {
            Some(address) => address.to_owned(),
            None if mapped.is_dummy() => "NULL".to_owned(),
            None => {
                let text = format!("`{mapped}` is not in the dictionary; its address is NULL");
                notes.push(Note::new(place, text));
                "NULL".to_owned()
            }
        };
        entries.push(format!("MAP_ENTRY(0x{object:04X}, 0x{sub:02X}, {bits}, {address})"));
    }
    if pdo.is_multiplexed() {
        notes.push(Note::new(Place::entry(index, 0), "multiplexed PDOs are not supported"));
    }
    entries
}

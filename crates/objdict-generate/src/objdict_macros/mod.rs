//! The target `objdict-macros`: `objdict.c` and `mapping.c` in the style of chapter 6.5 of "Embedded
//! Networking with CAN and CANopen": rows of macros with index, length, address and access, and eight mapping
//! entries per PDO.
//!
//! The book shows the macro for a single object. `SUB_OBJ`, for an entry of an object with several, is
//! modelled on it and defined next to it.

mod mapping;
mod view;

use super::c_code::{bytes, exact_type, little_endian, number};
use super::dictionary::{Dictionary, ResolvedEntry};
use super::memory::{self, Extent, Memory, Tally};
use super::names::Scope;
use super::notes::{in_order, once_per_device};
use super::resolve::{Datum, Shape};
use super::variables::{Wanted, claim, variables};
use super::{Backend, Choice, GenerateError, Generated, Note, Options, SizeReport, Sizes, render};
use crate::model::{Device, Place};

/// Tables of macros.
pub(super) struct ObjdictMacros;

impl Backend for ObjdictMacros {
    fn name(&self) -> &'static str {
        "objdict-macros"
    }

    fn summary(&self) -> &'static str {
        "`objdict.c` and `mapping.c` with the macros of the book on embedded CANopen (SINGLE_OBJ, MAP_ENTRY)"
    }

    fn uses(&self) -> &'static [Choice] {
        &[Choice::Names, Choice::Renamed, Choice::Prefix, Choice::StringCapacity, Choice::DomainCapacity]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let mut dictionary = Dictionary::new(device, options)?;
        let prefix = options.prefix_or("g")?;
        let mut notes = std::mem::take(&mut dictionary.notes);
        let objects = Objects::new(&dictionary, &prefix, &mut notes);
        let pdos = mapping::pdos(&dictionary, &objects, &mut notes);
        let head = view::Head::new(&dictionary, options);
        let files = vec![
            render("objdict.h", &view::Header::new(&head, &objects, &pdos))?,
            render("objdict.c", &view::Source::new(&head, &objects))?,
            render("mapping.c", &view::Mapping::new(&head, &pdos))?,
        ];
        Ok(Generated { files, notes: once_per_device(in_order(notes)) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Sizes, GenerateError> {
        let dictionary = Dictionary::new(device, options)?;
        let prefix = options.prefix_or("g")?;
        let mut notes = Vec::new();
        let objects = Objects::new(&dictionary, &prefix, &mut notes);
        let pdos = mapping::pdos(&dictionary, &objects, &mut notes);
        Ok(Sizes::Known(size(&dictionary, &objects, &pdos)))
    }
}

/// What the sizes include.
const COUNTED: &str = "the rows as `objdict.h` declares them, mapping and values, on a processor of 32 bits";

fn size(dictionary: &Dictionary<'_>, objects: &Objects, pdos: &[mapping::PdoRow]) -> SizeReport {
    let row = Extent::structure([Extent::HALF, Extent::BYTE, Extent::BYTE, Extent::WORD, Extent::POINTER]);
    let mapped = Extent::structure([Extent::HALF, Extent::BYTE, Extent::BYTE, Extent::POINTER]);
    let pdo_map = Extent::structure([Extent::BYTE, mapped.times(mapping::SLOTS)]);
    let mut tally = Tally::of_dictionary(dictionary);
    for object in &objects.rows {
        tally.of(object.index, Memory::Flash, row.size);
    }
    for variable in &objects.variables {
        tally.of(variable.index, variable.memory, variable.size);
    }
    for pdo in pdos {
        let index = pdo.kind.mapping_index(pdo.number);
        tally.of(index.unwrap_or(0), Memory::Flash, pdo_map.size); // 0: without an object
    }
    tally.report(COUNTED)
}

/// The rows and their variables.
#[derive(Debug)]
struct Objects {
    rows: Vec<ObjectRow>,
    variables: Vec<Definition>,
}

/// A row of the dictionary.
#[derive(Debug)]
struct ObjectRow {
    index: u16,
    sub: u8,
    /// Whether it is the only entry of its object.
    single: bool,
    length: usize,
    address: String,
    access: &'static str,
    described: String,
}

/// A variable.
#[derive(Debug)]
struct Definition {
    /// The index of its object.
    index: u16,
    memory: Memory,
    /// Bytes.
    size: usize,
    declaration: String,
    initializer: String,
    described: String,
}

/// The type of a variable; variables of equal types can be elements of one array.
#[derive(Clone, Debug, PartialEq)]
struct VariableType {
    constant: bool,
    base: &'static str,
    suffix: String,
}

impl Objects {
    fn new(dictionary: &Dictionary<'_>, prefix: &str, notes: &mut Vec<Note>) -> Self {
        let mut scope = Scope::of_lower_case("");
        let entry = |object: usize, entry: usize| &dictionary.objects[object].entries[entry];
        let kind = |object: usize, number: usize| kind(entry(object, number));
        let mut addresses: Vec<Vec<String>> =
            dictionary.objects.iter().map(|object| vec![String::new(); object.entries.len()]).collect();
        let mut definitions = Vec::new();
        let names = |wanted: &[Wanted<'_>]| claim(&mut scope, prefix, wanted);
        for variable in variables(&dictionary.objects, names, kind) {
            let name = format!("{prefix}_{}", variable.name);
            let values: Vec<String> = variable
                .entries
                .clone()
                .map(|at| initializer(entry(variable.object, at), dictionary.node_id))
                .collect();
            for (element, at) in variable.entries.clone().enumerate() {
                let element = if variable.array { format!("[{element}]") } else { String::new() };
                addresses[variable.object][at] = format!("&{name}{element}");
            }
            let array = if variable.array { format!("[{}]", values.len()) } else { String::new() };
            let VariableType { constant, base, suffix } = &variable.kind;
            let constant = if *constant { "const " } else { "" };
            let object = &dictionary.objects[variable.object];
            let first = &object.entries[variable.entries.start].entry.name;
            let entries = variable.entries.clone().map(|at| entry(variable.object, at));
            let size = entries.clone().map(length).sum();
            let begins_with_zeros = entries.clone().all(|entry| is_zero(entry, dictionary.node_id));
            let memory = match (variable.kind.constant, begins_with_zeros) {
                (true, _) => Memory::Flash,
                (false, true) => Memory::Zeroed,
                (false, false) => Memory::Initialised,
            };
            definitions.push(Definition {
                index: object.index,
                memory,
                size,
                declaration: format!("{constant}{base} {name}{array}{suffix}"),
                initializer: if variable.array {
                    format!("{{{}}}", values.join(", "))
                } else {
                    values.concat()
                },
                described: if variable.array { object.object.name() } else { first }.to_owned(),
            });
        }
        let mut rows = Vec::new();
        for (object, addresses) in dictionary.objects.iter().zip(addresses) {
            for (entry, address) in object.entries.iter().zip(addresses) {
                let place = Place::entry(object.index, entry.sub);
                check(&place, entry, dictionary.node_id, notes);
                rows.push(ObjectRow {
                    index: object.index,
                    sub: entry.sub,
                    single: object.is_single(),
                    length: length(entry),
                    address: if address.is_empty() { "NULL".to_owned() } else { address },
                    access: access(entry),
                    described: entry.entry.name.to_string(),
                });
            }
        }
        Self { rows, variables: definitions }
    }

    /// The address of an entry's value; `None` for a missing entry.
    fn address(&self, index: u16, sub: u8) -> Option<&ObjectRow> {
        let at = self.rows.binary_search_by_key(&(index, sub), |row| (row.index, row.sub)).ok()?;
        self.rows.get(at)
    }
}

/// Length of a value; a read-only text has the length of its default.
fn length(entry: &ResolvedEntry<'_>) -> usize {
    entry.resolved.shape.size()
}

fn kind(entry: &ResolvedEntry<'_>) -> Option<VariableType> {
    let resolved = &entry.resolved;
    let constant = resolved.constant;
    let block = || Some(VariableType { constant, base: "uint8_t", suffix: format!("[{}]", length(entry)) });
    match resolved.shape {
        _ if length(entry) == 0 => None,
        Shape::Word(data_type) => match (exact_type(data_type), word(entry)) {
            (Some(base), Some(value)) if number(value, data_type).is_some() => {
                Some(VariableType { constant, base, suffix: String::new() })
            }
            _ => block(),
        },
        _ => block(),
    }
}

/// The number of a value; for a formula, the offset to the node-ID.
fn word(entry: &ResolvedEntry<'_>) -> Option<u64> {
    match entry.resolved.default {
        Datum::Word(word) | Datum::Formula(word) => Some(word),
        Datum::Bytes(_) => None,
    }
}

/// Whether the initial value is all zeros.
fn is_zero(entry: &ResolvedEntry<'_>, node_id: Option<u8>) -> bool {
    match &entry.resolved.default {
        Datum::Formula(_) if node_id.is_some() => false,
        default => memory::is_zero(default),
    }
}

fn initializer(entry: &ResolvedEntry<'_>, node_id: Option<u8>) -> String {
    let resolved = &entry.resolved;
    let word = match resolved.default {
        Datum::Formula(offset) => offset + u64::from(node_id.unwrap_or(0)), // fits for every node-ID
        Datum::Word(word) => word,
        Datum::Bytes(ref value) => return bytes(value),
    };
    let typed = match resolved.shape {
        Shape::Word(data_type) => exact_type(data_type).and_then(|_| number(word, data_type)),
        _ => None,
    };
    typed.unwrap_or_else(|| bytes(&little_endian(word, length(entry))))
}

/// The access type in the notation of the book.
fn access(entry: &ResolvedEntry<'_>) -> &'static str {
    let resolved = &entry.resolved;
    match (resolved.access.is_readable(), resolved.access.is_writable()) {
        (true, false) if resolved.tpdo => "ROMAP",
        (true, false) => "RO",
        (false, _) if resolved.rpdo => "WOMAP",
        (false, _) => "WO",
        (true, true) if resolved.rpdo => "RWWMAP",
        (true, true) if resolved.tpdo => "RWRMAP",
        (true, true) => "RW",
    }
}

/// Notes properties that a row cannot express.
fn check(place: &Place, entry: &ResolvedEntry<'_>, node_id: Option<u8>, notes: &mut Vec<Note>) {
    let resolved = &entry.resolved;
    let mut say = |text: String| notes.push(Note::new(place.clone(), text));
    if resolved.low.is_some() || resolved.high.is_some() {
        say("a row does not support limits".to_owned());
    }
    if let Datum::Formula(_) = resolved.default {
        say(match node_id {
            Some(node_id) => {
                format!("a row does not add the node-ID; the constant node-ID {node_id} is added")
            }
            None => "a row does not add the node-ID; nothing is added".to_owned(),
        });
    }
    if resolved.tpdo && resolved.rpdo && resolved.access.is_readable() && resolved.access.is_writable() {
        say("a row is mapped in one direction only; RPDO is used".to_owned());
    }
    if let (Shape::Bytes(_, room), Datum::Bytes(value)) = (resolved.shape, &resolved.default)
        && value.len() < usize::from(room)
    {
        say(format!("a row has a fixed length; the value always has {room} bytes, padded with 0"));
    }
    if length(entry) == 0 {
        say("a row without data: its length is 0".to_owned());
    }
}

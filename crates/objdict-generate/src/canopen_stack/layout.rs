//! The variables and constants of the rows, and their storage groups.

use std::collections::{BTreeSet, HashSet};

use super::cell::{Cell, PlannedRow, hook_name};
use super::special::STORE;
use crate::c_code::bytes;
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::escape::literal;
use crate::memory::TypeExtent;
use crate::model::Place;
use crate::names::{NameScope, words};
use crate::variables::{CType, Definition, ObjectVariable, WantedName, claim, variables};
use crate::{Note, Options, stored};

/// Values that are stored together.
pub(super) struct ParaGroup {
    /// As in the options or the description.
    pub(super) name: String,
    /// The variable; its type has the suffix `_t`.
    pub(super) variable: String,
    pub(super) members: Vec<Definition>,
    /// The index of its first object.
    pub(super) first: u16,
    /// Whether it contains only objects of the communication profile (1000h to 1FFFh).
    pub(super) communication: bool,
}

/// Everything that the rows refer to.
#[derive(Default)]
pub(super) struct RowLayout {
    pub(super) groups: Vec<ParaGroup>,
    pub(super) variables: Vec<Definition>,
    /// Definitions in flash, and those in RAM required by types of the stack.
    pub(super) definitions: Vec<Definition>,
    /// The sizes of string literals, by the index of the first object that contains them.
    pub(super) literals: Vec<(u16, usize)>,
    /// The data of rows, by object and entry; empty for a parameter group.
    pub(super) data: Vec<Vec<String>>,
    /// Texts written as literals.
    texts: HashSet<Vec<u8>>,
}

/// The storage group of an object; `None` if the stack determines its values.
fn group_of<'a>(object: &'a ResolvedObject<'_>, options: &'a Options) -> Option<&'a str> {
    if matches!(object.index, 0x1001 | 0x1003) { None } else { stored::group_of(object, options) }
}

/// The group of each object; one common group if only sub-index 1 can store them.
fn groups(
    dictionary: &TableDictionary<'_>,
    planned: &[Vec<PlannedRow>],
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<Option<String>> {
    let objects = &dictionary.objects;
    let mut groups: Vec<Option<String>> =
        objects.iter().map(|object| group_of(object, options).map(str::to_owned)).collect();
    let store = objects.iter().position(|object| object.index == STORE);
    let subs = store.map(|store| planned[store].iter().filter(|row| matches!(row.cell, Cell::Group(_))));
    let names: BTreeSet<&String> = groups.iter().flatten().collect();
    if subs.is_some_and(|subs| subs.count() == 1) && names.len() > 1 {
        let names: Vec<String> = names.into_iter().map(|name| format!("`{name}`")).collect();
        let text = format!("only sub-index 1 exists, so the groups {} are stored as one", names.join(", "));
        notes.push(Note::new(Place::object(STORE), text));
        groups.iter_mut().flatten().for_each(|group| *group = "stored".to_owned());
    }
    groups
}

impl RowLayout {
    pub(super) fn new(
        dictionary: &TableDictionary<'_>,
        planned: &[Vec<PlannedRow>],
        options: &Options,
        prefix: &str,
        notes: &mut Vec<Note>,
    ) -> Self {
        let hooks: Vec<String> = options.hooks.iter().map(|at| hook_name(at.index)).collect();
        let mut scope = NameScope::of_lower_case(&format!(
            "objects store restore nothing rest block block_size block_read block_write block_reset
             bytes bytes_size bytes_read bytes_write bytes_reset {}",
            hooks.join(" ")
        ));
        let mut layout = Self {
            data: planned.iter().map(|entries| vec![String::new(); entries.len()]).collect(),
            ..Self::default()
        };
        let groups = groups(dictionary, planned, options, notes);
        for (object, group) in dictionary.objects.iter().zip(&groups) {
            let Some(name) = group else { continue };
            layout.join(name, object.index, &mut scope, prefix);
        }
        let type_of = |object: usize, entry: usize| ram(&planned[object][entry].cell);
        let names = |wanted: &[WantedName<'_>]| claim(&mut scope, prefix, wanted);
        for variable in variables(&dictionary.objects, names, type_of) {
            let object = &dictionary.objects[variable.object];
            let group = groups[variable.object].as_deref();
            layout.place(object, variable, planned, group, (prefix, notes));
        }
        for (number, object) in dictionary.objects.iter().enumerate() {
            for (entry, planned) in planned[number].iter().enumerate() {
                let place = (object.index, object.entries[entry].sub);
                layout.describe(&planned.cell, place, (number, entry), prefix);
            }
        }
        layout.drop_empty_groups(notes);
        layout
    }

    /// Adds an object to a group.
    fn join(&mut self, name: &str, index: u16, scope: &mut NameScope, prefix: &str) {
        let communication = (0x1000..0x2000).contains(&index);
        if let Some(group) = self.groups.iter_mut().find(|group| group.name == name) {
            group.communication &= communication;
            return;
        }
        let word = words(name);
        let suffix = format!("{index:04x}");
        let room = word.len().min(40);
        let variable = format!("{prefix}_{}", scope.claim(&word[..room], format_args!("{suffix}")));
        let name = name.to_owned();
        self.groups.push(ParaGroup { name, variable, members: Vec::new(), first: index, communication });
    }

    /// Adds a variable to its group.
    fn place(
        &mut self,
        object: &ResolvedObject<'_>,
        variable: ObjectVariable,
        planned: &[Vec<PlannedRow>],
        group: Option<&str>,
        (prefix, notes): (&str, &mut Vec<Note>),
    ) {
        let cells = &planned[variable.object];
        let first = &cells[variable.entries.start].cell;
        let is_stored = !matches!(first, Cell::Application | Cell::Consumer { .. });
        if group.is_some() && matches!(first, Cell::Consumer { .. }) {
            let text = "heartbeat consumers are objects of the stack and not part of a storage group";
            notes.push(Note::new(Place::object(object.index), text));
        }
        let stored = group.filter(|_| is_stored);
        let group = stored.and_then(|name| self.groups.iter_mut().find(|group| group.name == name));
        let name = match &group {
            Some(_) => variable.name.clone(),
            None => format!("{prefix}_{}", variable.name),
        };
        let path = group.as_ref().map_or(name.clone(), |group| format!("{}.{name}", group.variable));
        for (at, place) in variable.places(&path) {
            self.data[variable.object][at] = place;
        }
        let initial =
            |at: usize| (initializer(&cells[at].cell), is_zero(&cells[at].cell, &object.entries[at]));
        let definition = variable.define(object, name, initial);
        group.map_or(&mut self.variables, |group| &mut group.members).push(definition);
    }

    /// Defines the descriptor between a row and its value, and replaces the value's name by the
    /// descriptor's.
    fn describe(
        &mut self,
        cell: &Cell,
        (index, sub): (u16, u8),
        (object, entry): (usize, usize),
        prefix: &str,
    ) {
        let named = |letter: char| format!("{prefix}_{letter}{index:04X}_{sub:02X}");
        let (constant, descriptor) = (named('C'), named('D'));
        let path = std::mem::take(&mut self.data[object][entry]);
        let mut define = |type_: CType, name: &str, initializer: String| {
            self.definitions.push(Definition::new(index, type_, name.to_owned(), initializer));
            format!("&{name}")
        };
        let domain = |size: usize, start: &str| {
            format!("{{.Offset = 0u, .Size = {size}u, .Start = (uint8_t *){start}}}")
        };
        let data = match cell {
            Cell::Direct(value) => format!("{value}u"),
            Cell::Number { flash: true, c_type, value } => {
                define(CType::number(format!("const {c_type}")), &constant, value.clone())
            }
            Cell::Number { .. } | Cell::Application | Cell::Consumer { .. } => format!("&{path}"),
            Cell::Text(text) => {
                let size = text.len() + 1;
                let start = literal(text);
                if start.is_none() {
                    define(CType::bytes("const uint8_t", size), &constant, bytes(text));
                } else if self.texts.insert(text.clone()) {
                    self.literals.push((index, size));
                }
                let start = start.unwrap_or(constant);
                let initializer = format!("{{.Offset = 0u, .Start = (uint8_t *){start}}}");
                define(
                    structure("CO_OBJ_STR", &[TypeExtent::WORD, TypeExtent::POINTER]),
                    &descriptor,
                    initializer,
                )
            }
            Cell::Block { flash: true, bytes: value, .. } | Cell::Data(value) => {
                let room = value.len().max(1); // C has no empty arrays
                define(CType::bytes("const uint8_t", room), &constant, bytes(value));
                define(structure("CO_OBJ_DOM", DOMAIN), &descriptor, domain(value.len(), &constant))
            }
            Cell::Block { bytes, .. } => {
                define(structure("CO_OBJ_DOM", DOMAIN), &descriptor, domain(bytes.len(), &format!("&{path}")))
            }
            Cell::Bytes { room, .. } => {
                let members = [TypeExtent::WORD, TypeExtent::WORD, TypeExtent::POINTER, TypeExtent::POINTER];
                let initializer = format!("{{0u, {room}u, &{path}.length, {path}.bytes}}");
                define(structure(&format!("{prefix}_bytes_t"), &members), &descriptor, initializer)
            }
            Cell::Group(_) => String::new(),
        };
        self.data[object][entry] = data;
    }

    fn drop_empty_groups(&mut self, notes: &mut Vec<Note>) {
        for group in self.groups.extract_if(.., |group| group.members.is_empty()) {
            let text = format!("the storage group `{}` has no values that can change", group.name);
            notes.push(Note::new(Place::object(group.first), text));
        }
    }
}

/// Index and sub-indexes of a variable.
pub(super) fn place(variable: &Definition) -> String {
    let (first, last) = variable.subs;
    let last = variable.elements.map(|_| format!(" to {last:02X}h")).unwrap_or_default();
    format!("{:04X}h sub-index {first:02X}h{last}", variable.index)
}

/// The separate structure of a type that is needed outside another structure.
pub(super) fn own_type(variable: &Definition) -> Option<&str> {
    Some(variable.type_.base.as_str()).filter(|base| base.starts_with("struct"))
}

/// The definition of a variable outside a structure.
pub(super) fn definition(variable: &Definition) -> String {
    match own_type(variable) {
        Some(_) => format!("{0}_t {0}{1}", variable.name, variable.suffix()),
        None => variable.declaration(),
    }
}

/// The members of `CO_OBJ_DOM`: offset, size, start.
const DOMAIN: &[TypeExtent] = &[TypeExtent::WORD, TypeExtent::WORD, TypeExtent::POINTER];

/// The members of `CO_HBCONS`: node, next, state, timer, time, node-ID, events.
const CONSUMER: &[TypeExtent] = &[
    TypeExtent::POINTER,
    TypeExtent::POINTER,
    TypeExtent::BYTE,
    TypeExtent::HALF,
    TypeExtent::HALF,
    TypeExtent::BYTE,
    TypeExtent::BYTE,
];

/// A type with these members.
fn structure(base: &str, members: &[TypeExtent]) -> CType {
    let extent = TypeExtent::structure(members.iter().copied());
    CType { base: base.to_owned(), suffix: String::new(), extent }
}

/// The variable for a cell.
fn ram(cell: &Cell) -> Option<CType> {
    Some(match cell {
        Cell::Number { flash: false, c_type, .. }
        | Cell::Block { flash: false, c_type: Some(c_type), .. } => CType::number(*c_type),
        Cell::Block { flash: false, bytes, .. } => CType::bytes("uint8_t", bytes.len()),
        Cell::Bytes { room, .. } => {
            let base = format!("struct {{ uint16_t length; uint8_t bytes[{room}]; }}");
            structure(&base, &[TypeExtent::HALF, TypeExtent::BYTE.times(*room)])
        }
        Cell::Application => structure("CO_OBJ_DOM", DOMAIN),
        Cell::Consumer { .. } => structure("CO_HBCONS", CONSUMER),
        _ => return None,
    })
}

/// Whether the variable of a cell is initialised to zero.
fn is_zero(cell: &Cell, entry: &ResolvedEntry<'_>) -> bool {
    match cell {
        Cell::Block { bytes, .. } => bytes.iter().all(|&byte| byte == 0),
        Cell::Bytes { bytes, .. } => bytes.is_empty(), // preceded by their length
        Cell::Consumer { time, node_id } => (*time, *node_id) == (0, 0),
        Cell::Application => true,
        _ => entry.resolved.default.is_zero(),
    }
}

/// The initializer of the variable of a cell.
fn initializer(cell: &Cell) -> String {
    match cell {
        Cell::Number { value, .. } | Cell::Block { c_type: Some(_), value, .. } => value.clone(),
        Cell::Block { bytes: value, .. } => bytes(value),
        Cell::Bytes { bytes: value, .. } => format!("{{{}u, {}}}", value.len(), bytes(value)),
        Cell::Consumer { time, node_id } => format!("{{.Time = {time}u, .NodeId = {node_id}u}}"),
        _ => "{.Offset = 0u, .Size = 0u, .Start = NULL}".to_owned(),
    }
}

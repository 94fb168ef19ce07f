//! The variables and constants of the rows, and their storage groups.

use std::collections::{BTreeSet, HashSet};

use super::cell::{Cell, Planned};
use super::para::STORE;
use crate::c_code::{bytes, literal};
use crate::dictionary::{Dictionary, ResolvedEntry, ResolvedObject};
use crate::memory::{self, Extent, Memory};
use crate::model::Place;
use crate::names::{Scope, words};
use crate::stored;
use crate::variables::{Variable, Wanted, claim, variables};
use crate::{Note, Options};

/// A variable in RAM.
#[derive(Debug)]
pub(super) struct Member {
    /// Precedes the name: a type or an anonymous structure.
    base: String,
    pub(super) name: String,
    /// Follows the name.
    suffix: String,
    pub(super) initializer: String,
    pub(super) extent: Extent,
    /// Whether it is initialised to zero.
    pub(super) zero: bool,
    pub(super) index: u16,
    pub(super) sub: u8,
    /// The last sub-index of an array.
    pub(super) last: Option<u8>,
    /// The name in the description.
    pub(super) described: String,
}

impl Member {
    /// Index and sub-indexes.
    pub(super) fn place(&self) -> String {
        let last = self.last.map(|last| format!(" to {last:02X}h")).unwrap_or_default();
        format!("{:04X}h sub-index {:02X}h{last}", self.index, self.sub)
    }

    /// Its declaration as a structure member.
    pub(super) fn declaration(&self) -> String {
        format!("{} {}{}", self.base, self.name, self.suffix)
    }

    /// The structure that needs a type outside another structure.
    pub(super) fn structure(&self) -> Option<&str> {
        self.base.starts_with("struct").then_some(self.base.as_str())
    }

    /// Its definition outside a structure.
    pub(super) fn definition(&self) -> String {
        match self.structure() {
            Some(_) => format!("{}_t {}{}", self.name, self.name, self.suffix),
            None => self.declaration(),
        }
    }
}

/// Values that are stored together.
#[derive(Debug)]
pub(super) struct ParaGroup {
    /// As in the options or the description.
    pub(super) name: String,
    /// The variable; its type has the suffix `_t`.
    pub(super) variable: String,
    pub(super) members: Vec<Member>,
    /// The index of its first object.
    pub(super) first: u16,
    /// Whether it contains only objects of the communication profile (1000h to 1FFFh).
    pub(super) communication: bool,
}

/// Everything that rows refer to.
#[derive(Debug, Default)]
pub(super) struct Layout {
    pub(super) groups: Vec<ParaGroup>,
    pub(super) variables: Vec<Member>,
    /// Definitions in flash, and those in RAM required by types of the stack.
    pub(super) definitions: Vec<String>,
    /// The sizes of the definitions by index, including texts in them.
    pub(super) taken: Vec<(u16, Memory, usize)>,
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
    dictionary: &Dictionary<'_>,
    planned: &[Vec<Planned>],
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

impl Layout {
    pub(super) fn new(
        dictionary: &Dictionary<'_>,
        planned: &[Vec<Planned>],
        options: &Options,
        prefix: &str,
        notes: &mut Vec<Note>,
    ) -> Self {
        let mut scope = Scope::of_lower_case(
            "objects store restore nothing rest block block_size block_read block_write block_reset
             bytes bytes_size bytes_read bytes_write bytes_reset",
        );
        let mut layout = Self {
            data: planned.iter().map(|entries| vec![String::new(); entries.len()]).collect(),
            ..Self::default()
        };
        let groups = groups(dictionary, planned, options, notes);
        for (object, group) in dictionary.objects.iter().zip(&groups) {
            let Some(name) = group else { continue };
            layout.join(name, object.index, &mut scope, prefix);
        }
        let kind = |object: usize, entry: usize| ram(&planned[object][entry].cell);
        let names = |wanted: &[Wanted<'_>]| claim(&mut scope, prefix, wanted);
        for variable in variables(&dictionary.objects, names, kind) {
            let object = &dictionary.objects[variable.object];
            let group = groups[variable.object].as_deref();
            layout.place(object, &variable, &planned[variable.object], group, (prefix, notes));
        }
        for (number, object) in dictionary.objects.iter().enumerate() {
            for (entry, planned) in planned[number].iter().enumerate() {
                let place = (object.index, object.entries[entry].sub);
                layout.describe(&planned.cell, place, &mut (number, entry), prefix);
            }
        }
        layout.drop_empty_groups(notes);
        layout
    }

    /// Adds an object to a group.
    fn join(&mut self, name: &str, index: u16, scope: &mut Scope, prefix: &str) {
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

    /// Places a variable in its group.
    fn place(
        &mut self,
        object: &ResolvedObject<'_>,
        variable: &Variable<RamType>,
        planned: &[Planned],
        group: Option<&str>,
        (prefix, notes): (&str, &mut Vec<Note>),
    ) {
        let first = &object.entries[variable.entries.start];
        let last = variable.array.then(|| object.entries[variable.entries.end - 1].sub);
        let stored = group.filter(|_| variable.kind.stored);
        if group.is_some() && !variable.kind.stored && variable.kind.base == "CO_HBCONS" {
            let text = "heartbeat consumers are objects of the stack and not part of a storage group";
            notes.push(Note::new(Place::object(object.index), text));
        }
        let group = stored.and_then(|name| self.groups.iter_mut().find(|group| group.name == name));
        let name = match &group {
            Some(_) => variable.name.clone(),
            None => format!("{prefix}_{}", variable.name),
        };
        let path = group.as_ref().map_or(name.clone(), |group| format!("{}.{name}", group.variable));
        let array = if variable.array { format!("[{}]", variable.entries.len()) } else { String::new() };
        let RamType { base, suffix, .. } = &variable.kind;
        let values: Vec<String> = variable.entries.clone().map(|at| initializer(&planned[at].cell)).collect();
        let member = Member {
            base: base.clone(),
            name,
            suffix: format!("{array}{suffix}"),
            initializer: if variable.array { format!("{{{}}}", values.join(", ")) } else { values.concat() },
            extent: variable.kind.extent.times(values.len()),
            zero: variable.entries.clone().all(|at| is_zero(&planned[at].cell, &object.entries[at])),
            index: object.index,
            sub: first.sub,
            last,
            described: if variable.array { object.object.name() } else { &first.entry.name }.to_owned(),
        };
        for (element, at) in variable.entries.clone().enumerate() {
            let element = if variable.array { format!("[{element}]") } else { String::new() };
            self.data[variable.object][at] = format!("{path}{element}");
        }
        match group {
            Some(group) => group.members.push(member),
            None => self.variables.push(member),
        }
    }

    /// Defines the descriptor between a row and its value, and replaces the name of the value by that of the
    /// descriptor.
    fn describe(
        &mut self,
        cell: &Cell,
        (index, sub): (u16, u8),
        &mut (object, entry): &mut (usize, usize),
        prefix: &str,
    ) {
        let named = |letter: char| format!("{prefix}_{letter}{index:04X}_{sub:02X}");
        let (constant, descriptor) = (named('C'), named('D'));
        let path = std::mem::take(&mut self.data[object][entry]);
        self.take(index, cell);
        let data = match cell {
            Cell::Direct(value) => format!("{value}u"),
            Cell::Number { flash: true, c_type, value } => {
                self.definitions.push(format!("static const {c_type} {constant} = {value};"));
                format!("&{constant}")
            }
            Cell::Number { .. } | Cell::Application | Cell::Consumer { .. } => format!("&{path}"),
            Cell::Text(text) => {
                let start = literal(text).unwrap_or_else(|| {
                    let (value, room) = (bytes(text), text.len() + 1);
                    self.definitions.push(format!("static const uint8_t {constant}[{room}] = {value};"));
                    constant
                });
                self.definitions.push(format!(
                    "static CO_OBJ_STR {descriptor} = {{.Offset = 0u, .Start = (uint8_t *){start}}};"
                ));
                format!("&{descriptor}")
            }
            Cell::Block { flash: true, bytes: value, .. } | Cell::Data(value) => {
                let (value, size) = (bytes(value), value.len());
                let room = size.max(1); // C has no empty arrays
                self.definitions.push(format!("static const uint8_t {constant}[{room}] = {value};"));
                self.definitions.push(format!(
                    "static CO_OBJ_DOM {descriptor} = {{.Offset = 0u, .Size = {size}u, .Start = (uint8_t *){constant}}};"
                ));
                format!("&{descriptor}")
            }
            Cell::Block { bytes, .. } => {
                let size = bytes.len();
                self.definitions.push(format!(
                    "static CO_OBJ_DOM {descriptor} = {{.Offset = 0u, .Size = {size}u, .Start = (uint8_t *)&{path}}};"
                ));
                format!("&{descriptor}")
            }
            Cell::Bytes { room, .. } => {
                self.definitions.push(format!(
                    "static {prefix}_bytes_t {descriptor} = {{0u, {room}u, &{path}.length, {path}.bytes}};"
                ));
                format!("&{descriptor}")
            }
            Cell::Group(_) => String::new(),
        };
        self.data[object][entry] = data;
    }

    /// Counts the definitions of [`Self::describe`].
    fn take(&mut self, index: u16, cell: &Cell) {
        let constant = match cell {
            Cell::Number { flash: true, c_type, .. } => Extent::of_c(c_type).size,
            Cell::Text(text) if literal(text).is_some() && !self.texts.insert(text.clone()) => 0, // shares the literal
            Cell::Text(text) => text.len() + 1,
            Cell::Block { flash: true, bytes, .. } | Cell::Data(bytes) => bytes.len().max(1),
            _ => 0,
        };
        let descriptor = match cell {
            Cell::Text(_) => [Extent::WORD, Extent::POINTER].as_slice(), // CO_OBJ_STR
            Cell::Block { .. } | Cell::Data(_) => &[Extent::WORD, Extent::WORD, Extent::POINTER], // CO_OBJ_DOM
            Cell::Bytes { .. } => &[Extent::WORD, Extent::WORD, Extent::POINTER, Extent::POINTER],
            _ => &[],
        };
        let descriptor = Extent::structure(descriptor.iter().copied());
        self.taken.push((index, Memory::Flash, constant));
        self.taken.push((index, Memory::Initialised, descriptor.size));
    }

    fn drop_empty_groups(&mut self, notes: &mut Vec<Note>) {
        for group in self.groups.extract_if(.., |group| group.members.is_empty()) {
            let text = format!("the storage group `{}` has no values that can change", group.name);
            notes.push(Note::new(Place::object(group.first), text));
        }
    }
}

/// The type of a variable; variables of equal types can be elements of one array.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RamType {
    base: String,
    suffix: String,
    extent: Extent,
    /// Whether it can be a member of a storage group.
    stored: bool,
}

/// The variable for a cell.
fn ram(cell: &Cell) -> Option<RamType> {
    let kind = |base: &str, suffix: String, extent, stored| {
        Some(RamType { base: base.to_owned(), suffix, extent, stored })
    };
    let number = |c_type: &str| kind(c_type, String::new(), Extent::of_c(c_type), true);
    match cell {
        Cell::Number { flash: false, c_type, .. } => number(c_type),
        Cell::Block { flash: false, c_type: Some(c_type), .. } => number(c_type),
        Cell::Block { flash: false, bytes, .. } => {
            kind("uint8_t", format!("[{}]", bytes.len()), Extent::BYTE.times(bytes.len()), true)
        }
        Cell::Bytes { room, .. } => {
            let base = format!("struct {{ uint16_t length; uint8_t bytes[{room}]; }}");
            kind(&base, String::new(), Extent::behind_length(*room), true)
        }
        Cell::Application => {
            let extent = Extent::structure([Extent::WORD, Extent::WORD, Extent::POINTER]);
            kind("CO_OBJ_DOM", String::new(), extent, false)
        }
        Cell::Consumer { .. } => kind("CO_HBCONS", String::new(), consumer(), false),
        _ => None,
    }
}

/// `CO_HBCONS`: node, next, state, timer, time, node-ID, events.
fn consumer() -> Extent {
    let (pointer, half, byte) = (Extent::POINTER, Extent::HALF, Extent::BYTE);
    Extent::structure([pointer, pointer, byte, half, half, byte, byte])
}

/// Whether the variable of a cell is initialised to zero.
fn is_zero(cell: &Cell, entry: &ResolvedEntry<'_>) -> bool {
    match cell {
        Cell::Block { bytes, .. } => bytes.iter().all(|&byte| byte == 0),
        Cell::Bytes { bytes, .. } => bytes.is_empty(), // preceded by their length
        Cell::Consumer { time, node_id } => (*time, *node_id) == (0, 0),
        Cell::Application => true,
        _ => memory::is_zero(&entry.resolved.default),
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

//! The variables and rows of a dictionary.

use super::names::ReservedNames;
use super::ranges::{NUMBERS, TypeRanges};
use super::special::{Family, LISTS, VALUES, misfit};
use crate::c_code::{assignment, bytes, number_type, typed};
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::escape::literal;
use crate::model::{DataType, Place, TypeKind};
use crate::resolve::{Encoded, ValueShape};
use crate::variables::{CType, Definition, ObjectVariable, WantedName, variables};
use crate::{Note, Options, stored};

const ENDS_AT_ZERO: &str = "the stack truncates a string at its first zero byte";

/// The maximum number of rows of an object.
const MOST_ROWS: u8 = u8::MAX;

/// A row of an object.
pub(super) struct RowData {
    pub(super) access: String,
    pub(super) data_type: String,
    pub(super) size: usize,
    /// The name of its variable, with the element.
    pub(super) object: String,
}

/// An object with its rows.
pub(super) struct PlannedObject {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) rows: Vec<RowData>,
    /// Whether an application or the stack can register callbacks for writes.
    pub(super) callbacks: bool,
    /// Whether the stack does not use it because it does not match the stack's expectations.
    pub(super) misfit: bool,
}

/// Everything that the files define.
pub(super) struct CanFestivalPlan {
    pub(super) objects: Vec<PlannedObject>,
    pub(super) definitions: Vec<Definition>,
    pub(super) ranges: TypeRanges,
    /// Assignments of values that depend on the node-ID.
    pub(super) formulas: Vec<String>,
    /// The number of heartbeat consumers; at least 1.
    pub(super) consumers: usize,
}

/// The macro of a data type.
fn type_macro(shape: ValueShape) -> String {
    let name = shape.data_type().and_then(DataType::name).unwrap_or("OCTET_STRING").to_ascii_lowercase();
    name.replace("integer", "int").replace("unsigned", "uint")
}

impl CanFestivalPlan {
    pub(super) fn new(
        dictionary: &TableDictionary<'_>,
        options: &Options,
        names: ReservedNames<'_>,
        notes: &mut Vec<Note>,
    ) -> Self {
        let mut builder = CanFestivalPlanner {
            node: names.node(),
            node_id: dictionary.node_id.unwrap_or(0),
            plan: Self {
                objects: Vec::new(),
                definitions: Vec::new(),
                ranges: TypeRanges::default(),
                formulas: Vec::new(),
                consumers: 1,
            },
            misfits: dictionary.objects.iter().map(misfit).collect(),
            notes,
        };
        let addresses = builder.variables(dictionary, names);
        for (number, object) in dictionary.objects.iter().enumerate() {
            builder.object(object, number, &addresses[number], options);
        }
        builder.missing();
        builder.plan
    }
}

struct CanFestivalPlanner<'a> {
    node: &'a str,
    node_id: u8,
    plan: CanFestivalPlan,
    /// The stack's expectation for each object that it cannot use.
    misfits: Vec<Option<&'static str>>,
    notes: &'a mut Vec<Note>,
}

impl CanFestivalPlanner<'_> {
    /// Defines the variables; returns the name of each entry's one.
    fn variables(
        &mut self,
        dictionary: &TableDictionary<'_>,
        mut names: ReservedNames<'_>,
    ) -> Vec<Vec<String>> {
        let objects = &dictionary.objects;
        let mut addresses: Vec<Vec<String>> =
            objects.iter().map(|object| vec![String::new(); object.entries.len()]).collect();
        let misfits = self.misfits.clone();
        let names = |wanted: &[WantedName<'_>]| {
            let wanted = wanted.iter();
            let claims = wanted.map(|&(object, entry)| {
                names.claim(object, entry.and_then(|entry| object.entries.get(entry)))
            });
            claims.collect()
        };
        let kind = |object: usize, entry: usize| {
            let is_element = LISTS.contains(&objects[object].index) && misfits[object].is_none() && entry > 0;
            (!is_element).then(|| type_of(&objects[object], &objects[object].entries[entry])).flatten()
        };
        for variable in variables(objects, names, kind) {
            // the stack expects a different type for this name
            let hidden = misfits[variable.object].is_some() && variable.name.starts_with(self.node);
            let name = if hidden { format!("{}_own", variable.name) } else { variable.name.clone() };
            self.define(&objects[variable.object], variable, name, &mut addresses);
        }
        for (number, object) in objects.iter().enumerate().filter(|(_, object)| LISTS.contains(&object.index))
        {
            if self.misfits[number].is_none() {
                self.list(object, number, &mut addresses);
            }
        }
        addresses
    }

    fn define(
        &mut self,
        object: &ResolvedObject<'_>,
        variable: ObjectVariable,
        name: String,
        addresses: &mut [Vec<String>],
    ) {
        for (at, address) in variable.places(&name) {
            let store = format!("{}_store", self.node);
            self.plan.formulas.extend(assignment(&object.entries[at].resolved, &address, NUMBERS, &store));
            addresses[variable.object][at] = address;
        }
        let initial = |at: usize| initial(&object.entries[at], self.node_id);
        let mut definition = variable.define(object, name, initial);
        definition.described = match (definition.elements, definition.subs) {
            (Some(2..), (first, last)) => {
                format!("{:04X}h sub-index {first:02X} to {last:02X}h", object.index)
            }
            (_, (sub, _)) => format!("{:04X}h sub-index {sub:02X}h", object.index),
        };
        self.plan.definitions.push(definition);
    }

    /// The variable of a list that the stack reads; its object can be an ARRAY or a RECORD.
    fn list(&mut self, object: &ResolvedObject<'_>, number: usize, addresses: &mut [Vec<String>]) {
        let name = format!("{}_obj{:04X}", self.node, object.index);
        let entries = 1..object.entries.len();
        if object.index == 0x1016 {
            self.plan.consumers = entries.len().max(1);
        }
        let type_ = CType::number("UNS32");
        let variable = ObjectVariable { name: name.clone(), object: number, entries, array: true, type_ };
        self.define(object, variable, name, addresses);
    }

    fn object(
        &mut self,
        object: &ResolvedObject<'_>,
        number: usize,
        addresses: &[String],
        options: &Options,
    ) {
        let index = object.index;
        let misfit = self.misfits[number];
        if let Some(expected) = misfit {
            let text = format!("the stack expects {expected} here and does not use the object");
            self.notes.push(Note::new(Place::object(index), text));
        }
        if index == 0x1F22 {
            let text = "the stack downloads concise DCF only from pointers, and not from here";
            self.notes.push(Note::new(Place::object(index), text));
        }
        let family = Family::of(index).filter(|_| misfit.is_none());
        let saved = stored::group_of(object, options).is_some();
        let selects = object.entries.iter().any(ResolvedEntry::is_stored);
        let mut rows: Vec<RowData> = Vec::new();
        for (entry, address) in object.entries.iter().zip(addresses) {
            let place = Place::entry(index, entry.sub);
            if entry.sub == MOST_ROWS {
                let text = "an object of the stack has at most 255 rows; the entry is omitted";
                self.notes.push(Note::new(place, text));
                continue;
            }
            rows.resize_with(usize::from(entry.sub), || gap(self.node));
            let row = self.row(object, entry, (address, saved && (entry.is_stored() || !selects)));
            rows.push(row);
        }
        self.protect(object, family, &mut rows);
        let hook = options.hooks.iter().any(|hook| hook.index == index);
        let stack = object.object.main.stack.as_ref();
        let asked = hook || stack.is_some_and(|stack| stack.io_extension == Some(true));
        self.plan.objects.push(PlannedObject {
            index,
            name: object.object.name().to_owned(),
            rows,
            callbacks: asked || LISTS.contains(&index) || VALUES.iter().any(|(value, _)| *value == index),
            misfit: misfit.is_some(),
        });
    }

    /// Adds the rows that the stack reads without checking that they exist.
    fn protect(&mut self, object: &ResolvedObject<'_>, family: Option<Family>, rows: &mut Vec<RowData>) {
        let Some(family) = family else { return };
        let count = match object.entries.first().map(|entry| &entry.resolved.default) {
            Some(Encoded::Word(count @ 0..=254))
                if matches!(family, Family::RpdoMapping | Family::TpdoMapping) =>
            {
                usize::try_from(*count).unwrap_or(0) + 1
            }
            _ => 0,
        };
        if rows.len() < family.rows().max(count) {
            rows.resize_with(family.rows().max(count), || gap(self.node));
        }
    }

    fn row(
        &mut self,
        object: &ResolvedObject<'_>,
        entry: &ResolvedEntry<'_>,
        (address, saved): (&str, bool),
    ) -> RowData {
        let resolved = &entry.resolved;
        let place = Place::entry(object.index, entry.sub);
        let access = resolved.sdo_word(["WO", "RO", "WO", "RW"]);
        let writable = resolved.access.is_writable();
        let mut data_type = type_macro(resolved.shape);
        if writable && object.index == 0x1003 && entry.sub == 0 {
            data_type = "valueRange_EMC".to_owned();
        } else if writable {
            match self.plan.ranges.claim(resolved, self.node) {
                Ok(Some(range)) => data_type = range,
                Ok(None) => {}
                Err(()) => {
                    let text = "the stack has numbers for 219 ranges of values; the limits are not enforced";
                    self.notes.push(Note::new(place.clone(), text));
                }
            }
        }
        // texts end at their first zero, other bytes have a fixed length
        let note = match is_text(resolved.shape) {
            true => resolved.default.bytes().contains(&0).then(|| ENDS_AT_ZERO.to_owned()),
            false => resolved.padding(),
        };
        self.notes.extend(note.map(|text| Note::new(place, text)));
        let access = if saved && writable { format!("{access} | TO_BE_SAVE") } else { access.to_owned() };
        let size = resolved.shape.size();
        let object = if address.is_empty() { format!("{}_zero", self.node) } else { address.to_owned() };
        RowData { access, data_type, size, object }
    }

    /// Defines the objects that the stack refers to and the description lacks.
    fn missing(&mut self) {
        let mut define = |index: u16, base: &str, name: &str, elements: Option<usize>, value: u32| {
            let name = format!("{}_{name}obj{index:04X}", self.node);
            if !self.plan.definitions.iter().any(|known| known.name == name) {
                let is_list = elements.is_some();
                let initializer = if is_list { format!("{{{value}u}}") } else { format!("{value}u") };
                let described = "not in the description".to_owned();
                let definition = Definition::new(index, CType::number(base), name, initializer);
                let is_zero = value == 0;
                self.plan.definitions.push(Definition { elements, is_zero, described, ..definition });
            }
        };
        for (index, data_type) in VALUES {
            let base = number_type(data_type, NUMBERS).unwrap_or_default();
            let value = if index == 0x1014 { 0x80 + u32::from(self.node_id) } else { 0 };
            define(index, &base, "", None, value);
        }
        for index in LISTS {
            define(index, "UNS32", "", Some(1), 0);
            define(index, "UNS8", "highestSubIndex_", None, 0);
        }
    }
}

/// A row for a sub-index without an entry: no buffer is large enough for it, and no write has its length.
fn gap(node: &str) -> RowData {
    RowData {
        access: "RO | WO".to_owned(),
        data_type: "uint8".to_owned(),
        size: u32::MAX as usize,
        object: format!("{node}_zero"),
    }
}

/// Whether the stack treats a value as a zero-terminated string.
fn is_text(shape: ValueShape) -> bool {
    matches!(shape, ValueShape::Bytes(data_type, _) if data_type.kind() == TypeKind::VisibleString)
}

/// The initializer of an entry, and whether it is zero.
fn initial(entry: &ResolvedEntry<'_>, node_id: u8) -> (String, bool) {
    let resolved = &entry.resolved;
    let word = resolved.default.on_node(Some(node_id));
    let is_zero = word == 0 && resolved.default.bytes().iter().all(|&byte| byte == 0);
    let text = match typed(resolved.shape, word) {
        Some((_, number)) => Some(number),
        None if is_text(resolved.shape) => literal(resolved.default.bytes()),
        None => None,
    };
    let size = resolved.shape.size();
    (text.unwrap_or_else(|| bytes(&resolved.default.bytes_on(Some(node_id), size))), is_zero)
}

/// The type of an entry's variable; `None` without data.
fn type_of(object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>) -> Option<CType> {
    let resolved = &entry.resolved;
    let size = resolved.shape.size();
    let is_text = is_text(resolved.shape);
    if size == 0 && !is_text {
        return None;
    }
    let of_stack = VALUES.iter().any(|(index, _)| *index == object.index)
        || LISTS.contains(&object.index)
        || Family::of(object.index).is_some();
    // the stack overwrites the end of a string that it reads
    let changes = of_stack || is_text || resolved.default.is_formula();
    let constant = if resolved.constant && !changes { "const " } else { "" };
    let number = typed(resolved.shape, resolved.default.word());
    Some(match number.and_then(|(data_type, _)| number_type(data_type, NUMBERS)) {
        Some(number) => CType::number(format!("{constant}{number}")),
        None => CType::bytes(format!("{constant}UNS8"), size + usize::from(is_text)),
    })
}

//! The variables and rows of a dictionary.

use super::names::Names;
use super::ranges::Ranges;
use super::special::{Family, LISTS, VALUES, misfit};
use crate::c_code::{bytes, exact_type, literal, little_endian, number};
use crate::dictionary::{Dictionary, ResolvedEntry, ResolvedObject};
use crate::memory::{Extent, is_zero};
use crate::model::{DataType, Place, TypeKind};
use crate::resolve::{Datum, Shape};
use crate::stored;
use crate::variables::{Wanted, variables};
use crate::{Note, Options};

/// The most rows of an object.
const MOST_ROWS: u8 = u8::MAX;

/// A variable of the application or of the stack.
#[derive(Debug)]
pub(super) struct Definition {
    /// What is before the name: its type.
    pub(super) base: String,
    pub(super) name: String,
    /// What is behind it: its size.
    pub(super) suffix: String,
    pub(super) initializer: String,
    pub(super) comment: String,
    /// The object that it belongs to, or that the stack expects.
    pub(super) index: u16,
    /// The number of bytes.
    pub(super) size: usize,
    /// Whether its initial value is all zeros.
    pub(super) is_zero: bool,
}

impl Definition {
    pub(super) fn declaration(&self) -> String {
        format!("{} {}{}", self.base, self.name, self.suffix)
    }

    /// Whether it can change.
    pub(super) fn is_variable(&self) -> bool {
        !self.base.starts_with("const ")
    }
}

/// A row of an object.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct RowData {
    pub(super) access: String,
    pub(super) data_type: String,
    pub(super) size: usize,
    /// The name of its variable, with its element.
    pub(super) object: String,
}

/// An object with its rows.
pub(super) struct PlannedObject {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) rows: Vec<RowData>,
    /// Whether an application or the stack can register callbacks for writes.
    pub(super) callbacks: bool,
    /// Whether the stack does not use it, because it has not the form that the stack expects.
    pub(super) misfit: bool,
}

/// Everything that the files define.
pub(super) struct Plan {
    pub(super) objects: Vec<PlannedObject>,
    pub(super) definitions: Vec<Definition>,
    pub(super) ranges: Ranges,
    /// Assignments of values that depend on the node-ID.
    pub(super) formulas: Vec<String>,
    /// Whether one of them is of bytes.
    pub(super) stores_bytes: bool,
    /// The number of heartbeat consumers; at least 1.
    pub(super) consumers: usize,
}

/// The type of a variable; variables of equal types can be elements of one array.
#[derive(Clone, Debug, PartialEq)]
struct VariableType {
    base: String,
    /// The number of bytes; `None` for a number.
    room: Option<usize>,
}

/// The type of the stack for a number in C.
pub(super) fn c_type(data_type: DataType) -> Option<&'static str> {
    Some(match exact_type(data_type)? {
        "uint8_t" => "UNS8",
        "int8_t" => "INTEGER8",
        "uint16_t" => "UNS16",
        "int16_t" => "INTEGER16",
        "uint32_t" => "UNS32",
        "int32_t" => "INTEGER32",
        "uint64_t" => "UNS64",
        "int64_t" => "INTEGER64",
        "float" => "REAL32",
        _ => "REAL64",
    })
}

/// The macro of a data type.
fn type_macro(shape: Shape) -> String {
    let data_type = match shape {
        Shape::Word(data_type) | Shape::Bytes(data_type, _) => data_type,
        Shape::Block(_) => DataType::OCTET_STRING,
    };
    match data_type.kind() {
        TypeKind::Boolean => "boolean".to_owned(),
        TypeKind::Signed(bits) => format!("int{bits}"),
        TypeKind::Unsigned(bits) => format!("uint{bits}"),
        TypeKind::Real32 => "real32".to_owned(),
        TypeKind::Real64 => "real64".to_owned(),
        TypeKind::VisibleString => "visible_string".to_owned(),
        TypeKind::UnicodeString => "unicode_string".to_owned(),
        TypeKind::TimeOfDay => "time_of_day".to_owned(),
        TypeKind::TimeDifference => "time_difference".to_owned(),
        TypeKind::Domain => "domain".to_owned(),
        _ => "octet_string".to_owned(),
    }
}

impl Plan {
    pub(super) fn new(
        dictionary: &Dictionary<'_>,
        options: &Options,
        node: &str,
        notes: &mut Vec<Note>,
    ) -> Self {
        let mut builder = Builder {
            node,
            node_id: dictionary.node_id.unwrap_or(0),
            plan: Self {
                objects: Vec::new(),
                definitions: Vec::new(),
                ranges: Ranges::default(),
                formulas: Vec::new(),
                stores_bytes: false,
                consumers: 1,
            },
            misfits: dictionary.objects.iter().map(misfit).collect(),
            notes,
        };
        let addresses = builder.variables(dictionary);
        for (number, object) in dictionary.objects.iter().enumerate() {
            builder.object(object, number, &addresses[number], options);
        }
        builder.missing();
        builder.plan
    }
}

struct Builder<'a> {
    node: &'a str,
    node_id: u8,
    plan: Plan,
    /// What the stack expects of each object that it cannot use.
    misfits: Vec<Option<&'static str>>,
    notes: &'a mut Vec<Note>,
}

impl Builder<'_> {
    /// Defines the variables; returns the name of each entry's one.
    fn variables(&mut self, dictionary: &Dictionary<'_>) -> Vec<Vec<String>> {
        let objects = &dictionary.objects;
        let mut addresses: Vec<Vec<String>> =
            objects.iter().map(|object| vec![String::new(); object.entries.len()]).collect();
        let mut names = Names::new(self.node);
        let misfits = self.misfits.clone();
        let names = |wanted: &[Wanted<'_>]| {
            let wanted = wanted.iter();
            let claims = wanted.map(|&(object, entry)| {
                names.claim(object, entry.and_then(|entry| object.entries.get(entry)))
            });
            claims.collect()
        };
        let kind = |object: usize, entry: usize| {
            let is_element = LISTS.contains(&objects[object].index) && misfits[object].is_none() && entry > 0;
            (!is_element).then(|| kind(&objects[object], &objects[object].entries[entry])).flatten()
        };
        for variable in variables(objects, names, kind) {
            let object = &objects[variable.object];
            let entries = &object.entries[variable.entries.clone()];
            // what the stack expects under this name has another type
            let hidden = misfits[variable.object].is_some() && variable.name.starts_with(self.node);
            let name = if hidden { format!("{}_own", variable.name) } else { variable.name };
            let numbered = entries.iter().enumerate().zip(variable.entries.clone());
            for ((element, entry), at) in numbered {
                let element = if variable.array { format!("[{element}]") } else { String::new() };
                let address = format!("{name}{element}");
                self.formula(entry, &address);
                addresses[variable.object][at] = address;
            }
            self.define(object, entries, (name, variable.array), &variable.kind);
        }
        for (number, object) in objects.iter().enumerate().filter(|(_, object)| LISTS.contains(&object.index))
        {
            if self.misfits[number].is_none() {
                self.list(object, &mut addresses[number]);
            }
        }
        addresses
    }

    fn define(
        &mut self,
        object: &ResolvedObject<'_>,
        entries: &[ResolvedEntry<'_>],
        (name, array): (String, bool),
        kind: &VariableType,
    ) {
        let values: Vec<String> = entries.iter().map(|entry| self.initializer(entry, kind)).collect();
        let room = kind.room.map(|room| format!("[{room}]")).unwrap_or_default();
        let subs = match entries {
            [first, .., last] if array => format!("{:02X} to {:02X}", first.sub, last.sub),
            [first, ..] => format!("{:02X}", first.sub),
            [] => return,
        };
        self.plan.definitions.push(Definition {
            base: kind.base.clone(),
            name,
            suffix: if array { format!("[{}]{room}", entries.len()) } else { room },
            initializer: if array { format!("{{{}}}", values.join(", ")) } else { values.concat() },
            comment: format!("{:04X}h sub-index {subs}h", object.index),
            index: object.index,
            size: kind.room.unwrap_or(Extent::of_c(&kind.base).size) * entries.len(),
            is_zero: entries.iter().all(|entry| match &entry.resolved.default {
                Datum::Formula(offset) => offset + u64::from(self.node_id) == 0,
                default => is_zero(default),
            }),
        });
    }

    /// The variable of a list that the stack reads; its object can be an ARRAY or a RECORD.
    fn list(&mut self, object: &ResolvedObject<'_>, addresses: &mut [String]) {
        let name = format!("{}_obj{:04X}", self.node, object.index);
        let elements = object.entries.get(1..).unwrap_or_default();
        let kind = VariableType { base: "UNS32".to_owned(), room: None };
        for ((number, entry), address) in elements.iter().enumerate().zip(addresses.iter_mut().skip(1)) {
            *address = format!("{name}[{number}]");
            self.formula(entry, address);
        }
        self.define(object, elements, (name, true), &kind);
        if object.index == 0x1016 {
            self.plan.consumers = elements.len().max(1);
        }
    }

    /// Notes the assignment of a value that depends on the node-ID.
    fn formula(&mut self, entry: &ResolvedEntry<'_>, address: &str) {
        let (Datum::Formula(offset), Shape::Word(data_type)) =
            (&entry.resolved.default, entry.resolved.shape)
        else {
            return;
        };
        self.plan.formulas.push(match (c_type(data_type), number(*offset, data_type)) {
            (Some(c_type), Some(number)) => format!("{address} = ({c_type})({number} + nodeId);"),
            _ => {
                self.plan.stores_bytes = true;
                let size = entry.resolved.shape.size();
                format!("{}_store({address}, UINT64_C(0x{offset:X}) + nodeId, {size}u);", self.node)
            }
        });
    }

    fn initializer(&self, entry: &ResolvedEntry<'_>, kind: &VariableType) -> String {
        let resolved = &entry.resolved;
        let word = match &resolved.default {
            Datum::Bytes(value) if is_text(resolved.shape) => {
                return literal(value).unwrap_or_else(|| bytes(value));
            }
            Datum::Bytes(value) => return bytes(value),
            Datum::Word(word) => *word,
            Datum::Formula(offset) => offset + u64::from(self.node_id), // fits for every node-ID
        };
        let typed = match resolved.shape {
            Shape::Word(data_type) if kind.room.is_none() => number(word, data_type),
            _ => None,
        };
        typed.unwrap_or_else(|| bytes(&little_endian(word, resolved.shape.size())))
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
        let mut rows: Vec<RowData> = Vec::new();
        for (entry, address) in object.entries.iter().zip(addresses) {
            let place = Place::entry(index, entry.sub);
            if entry.sub == MOST_ROWS {
                let text = "an object of the stack has at most 255 rows; the entry is omitted";
                self.notes.push(Note::new(place, text));
                continue;
            }
            rows.resize_with(usize::from(entry.sub), || gap(self.node));
            let row = self.row(object, entry, (address, saved));
            rows.push(row);
        }
        self.protect(object, family, &mut rows);
        let asked = options.hooks.iter().any(|hook| hook.index == index);
        self.plan.objects.push(PlannedObject {
            index,
            name: object.object.name().to_owned(),
            rows,
            callbacks: asked || LISTS.contains(&index) || VALUES.iter().any(|(value, _)| *value == index),
            misfit: misfit.is_some(),
        });
    }

    /// Adds the rows that the stack reads without asking whether they are there.
    fn protect(&mut self, object: &ResolvedObject<'_>, family: Option<Family>, rows: &mut Vec<RowData>) {
        let Some(family) = family else { return };
        let count = match object.entries.first().map(|entry| &entry.resolved.default) {
            Some(Datum::Word(count @ 0..=64))
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
        let access = match (resolved.access.is_readable(), resolved.access.is_writable()) {
            (true, false) => "RO",
            (false, _) => "WO",
            (true, true) => "RW",
        };
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
        if matches!(resolved.shape, Shape::Bytes(..) | Shape::Block(_)) {
            self.note_bytes(&place, entry);
        }
        let access = if saved && writable { format!("{access} | TO_BE_SAVE") } else { access.to_owned() };
        let size = resolved.shape.size();
        let object = if address.is_empty() { format!("{}_zero", self.node) } else { address.to_owned() };
        RowData { access, data_type, size, object }
    }

    /// Texts end at their first zero, other bytes have a fixed length.
    fn note_bytes(&mut self, place: &Place, entry: &ResolvedEntry<'_>) {
        let (Shape::Bytes(_, room), Datum::Bytes(value)) = (entry.resolved.shape, &entry.resolved.default)
        else {
            return;
        };
        if is_text(entry.resolved.shape) {
            if value.contains(&0) {
                let text = "the stack truncates a text at its first zero byte";
                self.notes.push(Note::new(place.clone(), text));
            }
        } else if value.len() < usize::from(room) {
            let text = format!("a row has a fixed length; the value always has {room} bytes, padded with 0");
            self.notes.push(Note::new(place.clone(), text));
        }
    }

    /// Defines what the stack refers to and the description lacks.
    fn missing(&mut self) {
        let mut define = |index: u16, base: &str, name: &str, suffix: &str, value: u32| {
            let name = format!("{}_{name}obj{index:04X}", self.node);
            if !self.plan.definitions.iter().any(|known| known.name == name) {
                let initializer =
                    if suffix.is_empty() { format!("{value}u") } else { format!("{{{value}u}}") };
                self.plan.definitions.push(Definition {
                    base: base.to_owned(),
                    name,
                    suffix: suffix.to_owned(),
                    initializer,
                    comment: "not in the description".to_owned(),
                    index,
                    size: Extent::of_c(base).size,
                    is_zero: value == 0,
                });
            }
        };
        for (index, data_type) in VALUES {
            let base = c_type(data_type).unwrap_or("UNS32");
            let value = if index == 0x1014 { 0x80 + u32::from(self.node_id) } else { 0 };
            define(index, base, "", "", value);
        }
        for index in LISTS {
            define(index, "UNS32", "", "[1]", 0);
            define(index, "UNS8", "highestSubIndex_", "", 0);
        }
    }
}

/// A row for a sub-index without an entry: reads are refused, and no write has its length.
fn gap(node: &str) -> RowData {
    RowData {
        access: "RO | WO".to_owned(),
        data_type: "uint8".to_owned(),
        size: 0,
        object: format!("{node}_zero"),
    }
}

/// Whether the stack takes a value for a text that ends at a zero.
fn is_text(shape: Shape) -> bool {
    matches!(shape, Shape::Bytes(data_type, _) if data_type.kind() == TypeKind::VisibleString)
}

/// The type of an entry's variable; `None` without data.
fn kind(object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>) -> Option<VariableType> {
    let resolved = &entry.resolved;
    let size = resolved.shape.size();
    let is_text = is_text(resolved.shape);
    if size == 0 && !is_text {
        return None;
    }
    let of_stack = VALUES.iter().any(|(index, _)| *index == object.index)
        || LISTS.contains(&object.index)
        || Family::of(object.index).is_some();
    // the stack writes the end of a text that it reads
    let changes = of_stack || is_text || matches!(resolved.default, Datum::Formula(_));
    let constant = if resolved.constant && !changes { "const " } else { "" };
    let number = match (resolved.shape, &resolved.default) {
        (Shape::Word(data_type), Datum::Word(word) | Datum::Formula(word)) => {
            c_type(data_type).filter(|_| number(*word, data_type).is_some())
        }
        _ => None,
    };
    Some(VariableType {
        base: format!("{constant}{}", number.unwrap_or("UNS8")),
        room: number.is_none().then_some(size + usize::from(is_text)),
    })
}

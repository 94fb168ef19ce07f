//! Structures, macros and rows of a dictionary.

use std::collections::{BTreeMap, HashSet};

use super::cell::{NAMES, NUMBERS, StructureCell, ValueLocation};
use super::notes;
use super::special::{self, FAMILIES, IDENTITY, NAMED, StackForm, StructureFamily, named};
use crate::c_code::{assignment, number_type};
use crate::c_words::{distinct, is_reserved};
use crate::canopennode::names::{MemberNames, cname};
use crate::canopennode::node_id::stack_adds;
use crate::dictionary::{ResolvedEntry, ResolvedObject, TableDictionary};
use crate::memory::TypeExtent;
use crate::model::{DataType, ObjectType, Place};
use crate::resolve::{Encoded, ValueShape};
use crate::{Note, Options, StackLayout};

/// A structure type: members with type, name and size.
pub(super) struct StructType {
    pub(super) index: u16,
    pub(super) name: String,
    pub(super) members: Vec<String>,
}

/// A member of a memory structure.
pub(super) struct StructureMember {
    pub(super) index: u16,
    pub(super) location: ValueLocation,
    pub(super) declaration: String,
    pub(super) initializer: String,
    /// Its extent, by object.
    pub(super) extents: Vec<(Option<u16>, TypeExtent)>,
}

/// A row of a record.
pub(super) struct RecordRow {
    pub(super) data: String,
    pub(super) attribute: u16,
    pub(super) length: usize,
}

/// An object: a row of the dictionary, with the rows of its record.
pub(super) struct OdRow {
    pub(super) index: u16,
    pub(super) described: String,
    pub(super) max_sub: u8,
    /// For a value or elements; a record has it in its rows.
    pub(super) row: RecordRow,
    pub(super) record: Vec<RecordRow>,
}

/// Everything that the files define.
#[derive(Default)]
pub(super) struct CanOpenNodeV1Plan {
    pub(super) types: Vec<StructType>,
    pub(super) variables: Vec<StructureMember>,
    /// Macros for variables, lengths and elements, with their values.
    pub(super) aliases: Vec<(String, String)>,
    /// Macros for indexes and sub-indexes.
    pub(super) numbers: Vec<(String, String)>,
    pub(super) rows: Vec<OdRow>,
    /// Statements that add the node-ID.
    pub(super) formulas: Vec<String>,
    /// The number of objects of each family.
    pub(super) counts: [usize; 6],
    /// Whether the hex digits of names are in lower case, as libEDSsharp wrote them before November 2019.
    is_lower: bool,
}

impl CanOpenNodeV1Plan {
    pub(super) fn new(dictionary: &TableDictionary<'_>, options: &Options, notes: &mut Vec<Note>) -> Self {
        let taken = NAMED.iter().map(|named| named.name).chain(FAMILIES.iter().map(|family| family.name));
        let taken = taken.chain(["identity", "FirstWord", "LastWord"]).map(str::to_owned).collect();
        let mut builder = CanOpenNodeV1Planner {
            dictionary,
            options,
            notes,
            names: taken,
            macros: HashSet::new(),
            records: BTreeMap::new(),
            named: Vec::new(),
            plan: Self { is_lower: options.layout == StackLayout::CanOpenEditor2020, ..Self::default() },
        };
        for object in &dictionary.objects {
            builder.object(object);
        }
        builder.records();
        builder.families();
        builder.missing();
        builder.numbers();
        builder.plan.rows.sort_by_key(|row| row.index);
        builder.plan.types.sort_by_key(|record| record.index);
        builder.plan.variables.sort_by_key(|variable| variable.index);
        notes::of_lengths(dictionary, builder.notes);
        builder.plan
    }

    /// An index in the names of macros and records.
    pub(super) fn hex(&self, index: u16) -> String {
        if self.is_lower { format!("{index:04x}") } else { format!("{index:04X}") }
    }

    /// The variables of a memory.
    pub(super) fn of(&self, location: &ValueLocation) -> impl Iterator<Item = &StructureMember> {
        self.variables.iter().filter(move |variable| variable.location == *location)
    }
}

struct CanOpenNodeV1Planner<'a> {
    dictionary: &'a TableDictionary<'a>,
    options: &'a Options,
    notes: &'a mut Vec<Note>,
    /// Names of variables in use.
    names: HashSet<String>,
    macros: HashSet<String>,
    /// The records by name.
    records: BTreeMap<String, Vec<PlannedRecord<'a>>>,
    /// Each object with the name of its variable.
    named: Vec<(&'a ResolvedObject<'a>, String)>,
    plan: CanOpenNodeV1Plan,
}

/// A record and the values of its entries.
struct PlannedRecord<'a> {
    object: &'a ResolvedObject<'a>,
    location: ValueLocation,
    cells: Vec<StructureCell>,
}

impl PlannedRecord<'_> {
    /// Whether one structure fits both.
    fn is_like(&self, other: &Self) -> bool {
        let names = |record: &Self| {
            record.object.entries.iter().map(|entry| (entry.sub, entry.name.clone())).collect::<Vec<_>>()
        };
        let facts = |cell: &StructureCell| (cell.c_type.clone(), cell.room);
        self.location == other.location
            && self.cells.iter().map(facts).eq(other.cells.iter().map(facts))
            && names(self) == names(other)
    }
}

impl<'a> CanOpenNodeV1Planner<'a> {
    fn object(&mut self, object: &'a ResolvedObject<'a>) {
        for entry in &object.entries {
            notes::of_entry(object.index, entry, self.dictionary.node_id, self.notes);
        }
        if StructureFamily::of(object.index).is_some() {
            return; // with the others of its family
        }
        let location = ValueLocation::of(object, self.options);
        let fixed = named(object);
        if let Err(wanted) = &fixed {
            let text = format!("the stack expects a different type here and uses its own `{}`", wanted.name);
            self.notes.push(Note::new(Place::object(object.index), text));
        }
        let fixed = fixed.ok().flatten();
        let cells: Vec<StructureCell> =
            object.entries.iter().map(|entry| self.cell(object, entry, location)).collect();
        let is_value = object.entries.len() == 1 && object.entries.iter().all(|entry| entry.sub == 0);
        let is_list = !is_value && is_array(object, &cells);
        let name = match fixed {
            Some(fixed) => fixed.name.to_owned(),
            None if object.index == 0x1018 => "identity".to_owned(),
            None if !is_value && !is_list => {
                let same = self.records.entry(cname(&object.name, NAMES)).or_default();
                return same.push(PlannedRecord { object, location, cells });
            }
            None => self.claim(object),
        };
        if is_value {
            self.value(object, &name, (location, &cells));
        } else if is_list {
            self.array(object, &name, (location, &cells));
        } else {
            let is_used = matches!(fixed.map(|fixed| fixed.form), Some(StackForm::List(..)));
            let record = if is_used { format!("{name}_{:04X}", object.index) } else { name.clone() };
            self.record(&record, &[PlannedRecord { object, location, cells }]);
            if is_used {
                let text = format!("the stack expects an ARRAY here and uses its own `{name}`");
                self.notes.push(Note::new(Place::object(object.index), text));
            }
            return;
        }
        self.named.push((object, name));
    }

    /// The records with separate names: those with the same name and structure become an array, as in the
    /// editors.
    fn records(&mut self) {
        for mut same in std::mem::take(&mut self.records).into_values() {
            while let Some(first) = same.first() {
                let name = self.claim(first.object);
                let (alike, others): (Vec<_>, Vec<_>) = {
                    let is_alike: Vec<bool> = same.iter().map(|record| record.is_like(first)).collect();
                    let mut is_alike = is_alike.into_iter();
                    same.into_iter().partition(|_| is_alike.next() == Some(true))
                };
                self.record(&name, &alike);
                same = others;
            }
        }
    }

    /// The name of an object's variable: as in the editors, or a similar one that is valid and free.
    fn claim(&mut self, object: &ResolvedObject<'_>) -> String {
        let plain = cname(&object.name, NAMES);
        let is_word = !plain.is_empty() && !is_reserved(&plain) && !plain.ends_with("_t");
        let index = object.index;
        let plain = match (plain.as_str(), is_word) {
            ("", _) => format!("object_{index:04X}"),
            (_, true) => plain,
            _ => format!("{plain}_{index:04X}"),
        };
        distinct(&mut self.names, plain, &format!("{index:04X}"))
    }

    /// The value of an entry, with the node-ID where the stack does not add it.
    fn cell(
        &mut self,
        object: &ResolvedObject<'_>,
        entry: &ResolvedEntry<'_>,
        location: ValueLocation,
    ) -> StructureCell {
        let node_id = u64::from(self.dictionary.node_id.unwrap_or(0));
        let word = match (object.index, entry.sub, &entry.resolved.default) {
            (0x1200, 1, _) => Some(0x600), // of the default SDO server: the stack adds the node-ID
            (0x1200, 2, _) => Some(0x580),
            (0x1014, 0, Encoded::Word(value)) if notes::is_of_node(*value, self.dictionary.node_id) => {
                Some(value - node_id)
            }
            (index, sub, Encoded::Formula(offset)) if !is_added(index, sub, *offset) => {
                Some(offset + node_id)
            }
            _ => None,
        };
        StructureCell::new(entry, location, word)
    }

    /// Notes the statement that adds the node-ID to a variable.
    fn formula(&mut self, object: &ResolvedObject<'_>, entry: &ResolvedEntry<'_>, variable: &str) {
        if !is_added(object.index, entry.sub, entry.resolved.default.word()) {
            self.plan.formulas.extend(assignment(&entry.resolved, variable, NUMBERS, "CO_OD_store"));
        }
    }

    fn alias(&mut self, name: String, value: String) {
        if self.macros.insert(name.clone()) {
            self.plan.aliases.push((name, value));
        }
    }

    /// Defines the variable of an object, and its macro.
    fn define(
        &mut self,
        (index, location): (u16, ValueLocation),
        (c_type, name, suffix): (&str, &str, &str),
        initializer: String,
        extents: Vec<(Option<u16>, TypeExtent)>,
    ) {
        let declaration = format!("{c_type} {name}{suffix}");
        self.plan.variables.push(StructureMember { index, location, declaration, initializer, extents });
        self.alias(format!("OD_{name}"), format!("CO_OD_{}.{name}", location.name()));
    }

    fn value(
        &mut self,
        object: &ResolvedObject<'_>,
        name: &str,
        (location, cells): (ValueLocation, &[StructureCell]),
    ) {
        let (Some(cell), Some(entry)) = (cells.first(), object.entries.first()) else { return };
        let variable = format!("CO_OD_{}.{name}", location.name());
        if cell.is_stored() {
            self.formula(object, entry, &variable);
            let (suffix, extents) = (cell.suffix(), vec![(Some(object.index), cell.extent())]);
            let declared = (cell.c_type.as_str(), name, suffix.as_str());
            self.define((object.index, location), declared, cell.value.clone(), extents);
            if let Some(room) = cell.room {
                self.alias(format!("ODL_{name}_stringLength"), room.to_string());
            }
        }
        self.push(object, 0, row(cell, &variable), Vec::new());
    }

    fn array(
        &mut self,
        object: &ResolvedObject<'_>,
        name: &str,
        (location, cells): (ValueLocation, &[StructureCell]),
    ) {
        let elements = cells.get(1..).unwrap_or_default();
        let Some(first) = elements.first() else { return };
        let variable = format!("CO_OD_{}.{name}", location.name());
        for (number, entry) in object.entries.iter().skip(1).enumerate() {
            self.formula(object, entry, &format!("{variable}[{number}]"));
            let element = cname(&entry.name, NAMES);
            if !element.is_empty() {
                self.alias(format!("ODA_{name}_{element}"), number.to_string());
            }
        }
        let values: Vec<&str> = elements.iter().map(|cell| cell.value.as_str()).collect();
        let suffix = format!("[{}]{}", elements.len(), first.suffix());
        let extents = vec![(Some(object.index), first.extent().times(elements.len()))];
        let initializer = format!("{{{}}}", values.join(", "));
        self.define((object.index, location), (&first.c_type, name, &suffix), initializer, extents);
        self.alias(format!("ODL_{name}_arrayLength"), elements.len().to_string());
        let max_sub = u8::try_from(elements.len()).unwrap_or(u8::MAX);
        self.push(object, max_sub, row(first, &format!("{variable}[0]")), Vec::new());
    }

    fn record(&mut self, name: &str, alike: &[PlannedRecord<'a>]) {
        let Some(PlannedRecord { object: first, location, .. }) = alike.first() else { return };
        let variable = format!("CO_OD_{}.{name}", location.name());
        let (mut members, mut values, mut extents) = (Vec::new(), Vec::new(), Vec::new());
        for (number, record) in alike.iter().enumerate() {
            let place = if alike.len() > 1 { format!("{variable}[{number}]") } else { variable.clone() };
            let (of_type, initial, extent) = self.structure(record, &place);
            members = of_type;
            values.push(initial);
            extents.push((Some(record.object.index), extent));
            self.named.push((record.object, name.to_owned()));
        }
        if members.is_empty() {
            return;
        }
        let type_name = format!("OD_{name}_t");
        let (suffix, initializer) = match values.as_slice() {
            [only] => (String::new(), only.clone()),
            values => (format!("[{}]", values.len()), format!("{{{}}}", values.join(",\n        "))),
        };
        self.define((first.index, *location), (&type_name, name, &suffix), initializer, extents);
        self.plan.types.push(StructType { index: first.index, name: type_name, members });
    }

    /// The rows of a record at an address; the members of its structure, their values and size.
    fn structure(&mut self, record: &PlannedRecord<'_>, place: &str) -> (Vec<String>, String, TypeExtent) {
        let mut names = MemberNames::new(NAMES);
        let (mut members, mut values, mut extents) = (Vec::new(), Vec::new(), Vec::new());
        let mut rows: Vec<RecordRow> = Vec::new();
        let object = record.object;
        for (entry, cell) in object.entries.iter().zip(&record.cells) {
            let member = names.claim(&entry_name(object.index, entry), entry.sub);
            let place = format!("{place}.{member}");
            if cell.is_stored() {
                self.formula(object, entry, &place);
                members.push(format!("{} {member}{}", cell.c_type, cell.suffix()));
                values.push(cell.value.clone());
                extents.push(cell.extent());
            }
            rows.resize_with(usize::from(entry.sub), no_entry);
            rows.push(row(cell, &place));
        }
        self.push_record(object, rows);
        (members, format!("{{{}}}", values.join(", ")), TypeExtent::structure(extents))
    }

    /// A record is read by its rows; a record with only sub-index 0 would be read as a value.
    fn push_record(&mut self, object: &ResolvedObject<'_>, rows: Vec<RecordRow>) {
        match <[RecordRow; 1]>::try_from(rows) {
            Ok([only]) => self.push(object, 0, only, Vec::new()),
            Err(rows) => {
                let max_sub = u8::try_from(rows.len().saturating_sub(1)).unwrap_or(u8::MAX);
                let data = format!("&OD_record{}", self.plan.hex(object.index));
                self.push(object, max_sub, RecordRow { data, attribute: 0, length: 0 }, rows);
            }
        }
    }

    fn push(&mut self, object: &ResolvedObject<'_>, max_sub: u8, row: RecordRow, record: Vec<RecordRow>) {
        let described = object.object.name().to_owned();
        self.plan.rows.push(OdRow { index: object.index, described, max_sub, row, record });
    }

    /// The stack's arrays of structures; missing objects between others are not valid.
    fn families(&mut self) {
        for (at, family) in FAMILIES.iter().enumerate() {
            let highest =
                self.objects(family).last().map_or(0, |object| usize::from(object.index - family.first) + 1);
            self.plan.counts[at] = highest.max(usize::from(family.needed));
        }
        // the stack has as many mappings as PDOs
        for pdo in [2, 4] {
            let count = self.plan.counts[pdo].max(self.plan.counts[pdo + 1]);
            self.plan.counts[pdo] = count;
            self.plan.counts[pdo + 1] = count;
        }
        for (at, family) in FAMILIES.iter().enumerate() {
            self.family(family, self.plan.counts[at]);
        }
    }

    fn objects(&self, family: &StructureFamily) -> impl Iterator<Item = &'a ResolvedObject<'a>> {
        let (first, last) = (family.first, family.last);
        self.dictionary.objects.iter().filter(move |object| (first..=last).contains(&object.index))
    }

    fn family(&mut self, family: &'static StructureFamily, count: usize) {
        let location = self
            .objects(family)
            .next()
            .map_or(ValueLocation::Rom, |object| ValueLocation::of(object, self.options));
        let type_name = format!("OD_{}_t", family.name);
        let member = |field: special::StructureField| {
            format!("{} {}", number_type(field.data_type, NUMBERS).unwrap_or_default(), field.name)
        };
        let members = family.fields().map(member).collect();
        self.plan.types.push(StructType { index: family.first, name: type_name.clone(), members });
        if count == 0 {
            return;
        }
        let mut elements = Vec::new();
        let mut extents = Vec::new();
        for number in 0..count {
            let index = family.first + u16::try_from(number).unwrap_or(0); // at most 512
            let object = self.dictionary.object(index);
            extents.push((object.map(|object| object.index), structure(family)));
            let path = format!("CO_OD_{}.{}[{number}]", location.name(), family.name);
            let values = self.element(family, object, (location, &path));
            elements.push(format!("{{{}}}", values.join(", ")));
        }
        let initializer = format!("{{{}}}", elements.join(",\n        "));
        let suffix = format!("[{count}]");
        self.define((family.first, location), (&type_name, family.name, &suffix), initializer, extents);
    }

    /// The values of one structure; rows of its object, and variables for entries without a member.
    fn element(
        &mut self,
        family: &StructureFamily,
        object: Option<&'a ResolvedObject<'a>>,
        (location, path): (ValueLocation, &str),
    ) -> Vec<String> {
        let missing = |field: special::StructureField| format!("0x{:X}u", family.missing(&field));
        let mut values: Vec<String> = family.fields().map(missing).collect();
        let Some(object) = object else { return values };
        self.named.push((object, family.name.to_owned()));
        let mut rows: Vec<RecordRow> = Vec::new();
        for entry in &object.entries {
            let cell = self.cell(object, entry, location);
            rows.resize_with(usize::from(entry.sub), no_entry);
            let place = match family.field(entry) {
                Some(field) => {
                    if let Some(value) = values.get_mut(usize::from(entry.sub)) {
                        value.clone_from(&cell.value);
                    }
                    format!("{path}.{}", field.name)
                }
                None => {
                    let name = format!("{}_{:04X}_{:02X}", family.name, object.index, entry.sub);
                    if cell.is_stored() {
                        self.plan.variables.push(StructureMember {
                            index: object.index,
                            location,
                            declaration: format!("{} {name}{}", cell.c_type, cell.suffix()),
                            initializer: cell.value.clone(),
                            extents: vec![(Some(object.index), cell.extent())],
                        });
                    }
                    if entry.sub > 0 {
                        let text = "the stack has no member for the entry and ignores it";
                        self.notes.push(Note::new(Place::entry(object.index, entry.sub), text));
                    }
                    format!("CO_OD_{}.{name}", location.name())
                }
            };
            self.formula(object, entry, &place);
            rows.push(row(&cell, &place));
        }
        self.push_record(object, rows);
        values
    }

    /// Macros for the indexes and sub-indexes, if no variable has the name.
    fn numbers(&mut self) {
        self.named.sort_by_key(|(object, _)| object.index);
        for (object, name) in std::mem::take(&mut self.named) {
            let index = self.plan.hex(object.index);
            let mut numbers = vec![(format!("{index}_{name}"), format!("0x{index}"))];
            numbers.push((format!("{name}_idx"), format!("0x{index}")));
            if object.object.object_type() != ObjectType::Var {
                numbers.push((format!("{index}_0_{name}_maxSubIndex"), "0".to_owned()));
            }
            for entry in object.entries.iter().filter(|entry| entry.sub > 0) {
                let sub = cname(&entry_name(object.index, entry), NAMES);
                numbers.push((format!("{index}_{}_{name}_{sub}", entry.sub), entry.sub.to_string()));
            }
            for (name, value) in numbers {
                let name = format!("OD_{name}");
                if self.macros.insert(name.clone()) {
                    self.plan.numbers.push((name, value));
                }
            }
        }
    }

    /// Variables that the stack refers to and the description lacks.
    fn missing(&mut self) {
        let of = |data_type: DataType| number_type(data_type, NUMBERS).unwrap_or_default();
        for named in &NAMED {
            if self.macros.contains(&format!("OD_{}", named.name)) {
                continue;
            }
            let (c_type, count, value, behind) = match named.form {
                StackForm::Value(data_type, value) => (of(data_type), None, format!("0x{value:X}u"), ""),
                StackForm::List(data_type, least) => (of(data_type), Some(least), "{0}".to_owned(), "array"),
                StackForm::Octets(least) => {
                    ("OCTET_STRING".to_owned(), Some(least), "{0}".to_owned(), "string")
                }
            };
            let suffix = count.map(|count| format!("[{count}]")).unwrap_or_default();
            let extents = vec![(None, TypeExtent::of_c(&c_type).times(count.unwrap_or(1)))];
            self.define((named.index, ValueLocation::Ram), (&c_type, named.name, &suffix), value, extents);
            if let Some(count) = count {
                self.alias(format!("ODL_{}_{behind}Length", named.name), count.to_string());
            }
        }
    }
}

/// Whether the stack adds the node-ID to a value: in 1014h to any.
fn is_added(index: u16, sub: u8, value: u64) -> bool {
    index == 0x1014 || stack_adds(index, sub, value)
}

/// The structure of a family.
fn structure(family: &StructureFamily) -> TypeExtent {
    let size = |data_type: DataType| TypeExtent::number(usize::from(data_type.byte_length().unwrap_or(4)));
    TypeExtent::structure(family.fields().map(|field| size(field.data_type)))
}

/// The row of an entry.
fn row(cell: &StructureCell, place: &str) -> RecordRow {
    let element = if cell.room.is_some() { "[0]" } else { "" };
    let data = if cell.is_stored() { format!("&{place}{element}") } else { "0".to_owned() };
    RecordRow { data, attribute: cell.attribute, length: cell.length }
}

/// The row of a sub-index without an entry: it can be neither read nor written.
fn no_entry() -> RecordRow {
    RecordRow { data: "&CO_OD_noEntry".to_owned(), attribute: 0, length: 1 }
}

/// The name of an entry; LSS reads the members of the identity.
fn entry_name(index: u16, entry: &ResolvedEntry<'_>) -> String {
    match (index, entry.sub) {
        (0x1018, sub @ 1..=4) => IDENTITY[usize::from(sub) - 1].to_owned(),
        (_, 0) if entry.name.trim().is_empty() => "maxSubIndex".to_owned(),
        _ => entry.name.to_string(),
    }
}

/// Whether the stack can treat an object as an array: equal elements, with their number in sub-index 0, which
/// is not stored. LSS reads the identity as a record.
fn is_array(object: &ResolvedObject<'_>, cells: &[StructureCell]) -> bool {
    let is_list = object.object.object_type() == ObjectType::Array && object.index != 0x1018
        || object.object.compact.is_some()
        || matches!(object.index, 0x1003 | 0x1016 | 0x1029);
    let [count, elements @ ..] = object.entries.as_slice() else { return false };
    let Some(first) = cells.get(1) else { return false };
    let number = u64::try_from(elements.len()).unwrap_or(u64::MAX);
    let is_count = count.sub == 0
        && count.resolved.shape == ValueShape::Word(DataType::UNSIGNED8)
        && (object.index == 0x1003
            || !count.resolved.access.is_writable() && count.resolved.default == Encoded::Word(number));
    let numbered = elements.iter().zip(1_u16..).all(|(entry, sub)| u16::from(entry.sub) == sub);
    let alike = cells.iter().skip(1).all(|cell| cell.is_like(first) && cell.is_stored());
    is_list && is_count && numbered && alike && elements.len() < usize::from(u8::MAX)
}

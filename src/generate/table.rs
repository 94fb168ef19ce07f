//! The dictionary as a flat table: what the targets `rust` and `c` share.
//!
//! Both languages get the same table and answer alike; what they answer is written down in docs/generate.md. The parts:
//!
//! * **entries**: a row for each index and sub-index, in ascending order, found by binary search. A row has the key, the
//!   code of the data type, flags, and two offsets: `ram`, 0 for an entry that stays in flash, and `rom`.
//! * **rom**: bytes in flash. Of a type with at most eight bytes: the default, then the low limit and the high limit where
//!   the flags say so, each as long as the type. Of any other type: the capacity and the length of the default as two
//!   16-bit numbers, then the default. All numbers are little-endian. A formula keeps what is added to the node-ID.
//! * **fields**: the members of the struct of all values that can change. Entries that never change have none: those of
//!   access type `const`, type definitions, and sub-index 0 of RECORDs and compact objects that is not writable. The
//!   elements of an ARRAY are one field where they are alike.

use super::names::{Scope, words};
use super::resolve::{Datum, Resolved, Resolver, Shape};
use super::rom::Rom;
use super::{GenerateError, Note, Options};
use crate::model::{Access, DataType, Device, Object, ObjectType, Part, Place};

/// A device's dictionary, ready for a template.
#[derive(Debug)]
pub(crate) struct Table {
    /// The product's name; empty where the description has none.
    pub(crate) product: String,
    /// The vendor's name; empty where the description has none.
    pub(crate) vendor: String,
    /// The node-ID that it is generated for.
    pub(crate) node_id: Option<u8>,
    /// All objects that have rows, by index.
    pub(crate) objects: Vec<TableObject>,
    /// All rows, by index and sub-index.
    pub(crate) rows: Vec<Row>,
    /// All fields, in the order of their first rows.
    pub(crate) fields: Vec<TableField>,
    /// The bytes in flash.
    pub(crate) rom: Vec<u8>,
    /// What the table leaves out or assumes.
    pub(crate) notes: Vec<Note>,
}

/// An object.
#[derive(Debug)]
pub(crate) struct TableObject {
    pub(crate) index: u16,
    pub(crate) name: String,
    /// The words of its name: unique among modules, and no keyword.
    pub(crate) module: String,
    /// Whether it is a single value, so that its name says all.
    pub(crate) single: bool,
    /// Which rows are its entries.
    pub(crate) rows: std::ops::Range<usize>,
}

/// An entry.
#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) index: u16,
    pub(crate) sub: u8,
    pub(crate) name: String,
    /// The words of its name: unique in its object.
    pub(crate) constant: String,
    pub(crate) resolved: Resolved,
    /// Where the struct of values keeps it.
    pub(crate) slot: Option<Slot>,
    /// The offset of its bytes in flash.
    pub(crate) rom: usize,
}

/// A place in the struct of values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slot {
    /// Number of the field.
    pub(crate) field: usize,
    /// Number of the element, where the field is an array.
    pub(crate) element: Option<usize>,
}

/// A member of the struct of values.
#[derive(Debug)]
pub(crate) struct TableField {
    /// Unique among fields, and no keyword.
    pub(crate) name: String,
    pub(crate) shape: Shape,
    /// Which rows it holds: one, or the elements of an array.
    pub(crate) rows: std::ops::Range<usize>,
    /// Whether it is an array.
    pub(crate) array: bool,
}

impl Row {
    /// The flags; the bits are those that the templates name.
    pub(crate) fn flags(&self) -> Vec<&'static str> {
        let resolved = &self.resolved;
        let formula = |datum: Option<&Datum>| matches!(datum, Some(Datum::Formula(_)));
        [
            ("READ", resolved.access.is_readable()),
            ("WRITE", resolved.access.is_writable()),
            ("TPDO", resolved.tpdo),
            ("RPDO", resolved.rpdo),
            ("LOW", resolved.low.is_some()),
            ("HIGH", resolved.high.is_some()),
            ("NODE_ID_DEFAULT", formula(Some(&resolved.default))),
            ("LOW_NODE_ID", formula(resolved.low.as_ref())),
            ("HIGH_NODE_ID", formula(resolved.high.as_ref())),
        ]
        .into_iter()
        .filter_map(|(flag, set)| set.then_some(flag))
        .collect()
    }

    /// The access type, as documentation names it.
    pub(crate) fn access(&self) -> Access {
        self.resolved.access
    }
}

impl Table {
    /// The table of a device.
    pub(crate) fn new(device: &Device, options: &Options) -> Result<Self, GenerateError> {
        let node_id = options.node_id_of(device)?;
        let mut builder = Builder {
            resolver: Resolver::new(device, options),
            modules: Scope::of_lower_case("od"), // for the module that all this is in
            fields: Scope::of_lower_case("node_id"),
            rom: Rom::default(),
            table: Self::empty(device, node_id),
        };
        for (&index, object) in &device.objects {
            builder.object(index, object);
        }
        builder.finish(device)
    }

    /// Whether a field holds numbers of this data type.
    pub(crate) fn keeps(&self, data_type: DataType) -> bool {
        self.fields.iter().any(|field| field.shape == Shape::Word(data_type))
    }

    fn empty(device: &Device, node_id: Option<u8>) -> Self {
        let info = device.device_info.as_ref();
        Self {
            product: info.and_then(|info| info.product_name.clone()).unwrap_or_default(),
            vendor: info.and_then(|info| info.vendor_name.clone()).unwrap_or_default(),
            node_id,
            objects: Vec::new(),
            rows: Vec::new(),
            fields: Vec::new(),
            rom: Vec::new(),
            notes: Vec::new(),
        }
    }
}

struct Builder<'a> {
    resolver: Resolver<'a>,
    modules: Scope,
    fields: Scope,
    rom: Rom,
    table: Table,
}

impl Builder<'_> {
    fn object(&mut self, index: u16, object: &Object) {
        if object.main.stack.as_ref().is_some_and(|stack| stack.disabled == Some(true)) {
            let note = Note::new(Place::object(index), "the description disables the object (`CO_disabled`)");
            self.resolver.notes.push(note);
            return;
        }
        if let Some(compact) = &object.compact {
            // compact entries have no texts of their own: what is wrong stands with the object
            let data_type = object.main.data_type.unwrap_or(DataType(0));
            self.resolver.misfits(&Place::object(index), &object.main, data_type);
            for misfit in compact.misfits.iter() {
                let text = format!("`{}` is no value of {data_type}; the default is used", misfit.text);
                let place = Place::of(Part::CompactValues(index)).field(misfit.field.clone());
                self.resolver.notes.push(Note::new(place, text));
            }
        }
        let first = self.table.rows.len();
        let mut constants = Scope::of_constants("index");
        let mut described = 0;
        for (sub, entry) in object.entries() {
            described += 1;
            let Some(resolved) = self.resolver.entry(object, index, sub, &entry) else { continue };
            let constant = constants.claim(&words(&entry.name), &format!("{sub:02x}"));
            let rom = self.rom.place(block(&resolved));
            let row = Row { index, sub, name: entry.name.to_string(), constant, resolved, slot: None, rom };
            self.table.rows.push(row);
        }
        let rows = first..self.table.rows.len();
        if described == 0 {
            let note = Note::new(Place::object(index), "an object without entries is left out");
            self.resolver.notes.push(note);
        }
        if rows.is_empty() {
            return;
        }
        let name = Some(words(object.name())).filter(|name| !name.is_empty());
        let name = name.unwrap_or_else(|| format!("x{index:04x}"));
        self.place_fields(object, &name, rows.clone());
        let module = self.modules.claim(&name, &format!("{index:04x}"));
        let single = !object.object_type().has_subs() && object.compact.is_none() && rows.len() == 1;
        self.table.objects.push(TableObject { index, name: object.name().to_owned(), module, single, rows });
    }

    /// Gives the entries of an object that can change their fields.
    fn place_fields(&mut self, object: &Object, name: &str, rows: std::ops::Range<usize>) {
        let elements = self.elements(object, rows.clone());
        for at in rows.start..elements.start {
            self.place_field(object, name, at..at + 1, false);
        }
        if !elements.is_empty() {
            self.place_field(object, name, elements.clone(), true);
        }
        for at in elements.end..rows.end {
            self.place_field(object, name, at..at + 1, false);
        }
    }

    /// The rows that can be the elements of one array: sub-index 1 and up without a gap, all of one shape, none constant.
    fn elements(&self, object: &Object, rows: std::ops::Range<usize>) -> std::ops::Range<usize> {
        let table = &self.table.rows;
        let start = rows.clone().find(|&at| table[at].sub > 0).unwrap_or(rows.end);
        let none = rows.end..rows.end;
        if object.object_type() != ObjectType::Array && object.compact.is_none() {
            return none;
        }
        let Some(first) = table[..rows.end].get(start).filter(|row| row.sub == 1) else { return none };
        let end = rows.end - usize::from(table[rows.end - 1].sub == 0xFF); // FFh: the structure of the object
        let alike = table[start..end].iter().zip(1_u16..).all(|(row, sub)| {
            u16::from(row.sub) == sub && !row.resolved.constant && row.resolved.shape == first.resolved.shape
        });
        if alike && first.resolved.shape.size() > 0 { start..end } else { none }
    }

    fn place_field(&mut self, object: &Object, name: &str, rows: std::ops::Range<usize>, array: bool) {
        let row = &self.table.rows[rows.start];
        let shape = row.resolved.shape;
        if row.resolved.constant || shape.size() == 0 {
            return; // in flash, or a DOMAIN without room
        }
        let (words, suffix) = if array || !(object.object_type().has_subs() || object.compact.is_some()) {
            (name.to_owned(), format!("{:04x}", row.index))
        } else {
            (format!("{name}_{}", row.constant), format!("{:04x}_{:02x}", row.index, row.sub))
        };
        let field = self.table.fields.len();
        for (element, at) in rows.clone().enumerate() {
            self.table.rows[at].slot = Some(Slot { field, element: array.then_some(element) });
        }
        let name = self.fields.claim(&words, &suffix);
        self.table.fields.push(TableField { name, shape, rows, array });
    }

    fn finish(self, device: &Device) -> Result<Table, GenerateError> {
        let Resolver { mut notes, mut errors, .. } = self.resolver;
        let modular = device.modules.as_ref().is_some_and(|modules| !modules.supported.is_empty());
        if modular && device.node_id().is_none() {
            let text = "objects that modules bring are no part of the table";
            let note = Note::new(Part::SupportedModules, text);
            notes.push(note.help("generate from the DCF of a node, where they stand as ordinary objects"));
        }
        notes.sort_by(|a, b| a.place.cmp(&b.place)); // stable: notes of one place stay in order
        let notes = once_per_object(notes);
        errors.sort_by(|a, b| a.place.cmp(&b.place));
        if !errors.is_empty() {
            return Err(GenerateError::Inexpressible(errors));
        }
        if self.table.rows.is_empty() {
            return Err(GenerateError::NoEntries { notes });
        }
        Ok(Table { rom: self.rom.into_bytes(), notes, ..self.table })
    }
}

/// Notes without those that say the same of further entries of an object: the first one counts them.
fn once_per_object(notes: Vec<Note>) -> Vec<Note> {
    let mut kept: Vec<(Note, u32)> = Vec::new();
    for note in notes {
        let same = |(first, _): &&mut (Note, u32)| {
            index_of(&first.place).is_some_and(|index| index_of(&note.place) == Some(index))
                && first.place.field == note.place.field
                && first.message == note.message
        };
        let recent = kept.iter_mut().rev().take(8); // the kinds of notes that entries of one object have
        match recent.into_iter().find(same) {
            Some((_, more)) => *more += 1,
            None => kept.push((note, 0)),
        }
    }
    let counted = kept.into_iter().map(|(mut note, more)| {
        if more > 0 {
            let entries = if more == 1 { "entry" } else { "entries" };
            note.message = format!("{}; so for {more} more {entries} of the object", note.message);
        }
        note
    });
    counted.collect()
}

/// The index of the object whose entry a place is.
fn index_of(place: &Place) -> Option<u16> {
    match place.part {
        Part::Entry(index, _) => Some(index),
        _ => None,
    }
}

/// The bytes of an entry in flash.
fn block(resolved: &Resolved) -> Vec<u8> {
    let size = resolved.shape.size();
    match &resolved.default {
        Datum::Bytes(bytes) => {
            let numbers = [size, bytes.len()].map(|number| u16::try_from(number).unwrap_or(u16::MAX)); // checked before
            numbers.iter().flat_map(|number| number.to_le_bytes()).chain(bytes.iter().copied()).collect()
        }
        default => [Some(default), resolved.low.as_ref(), resolved.high.as_ref()]
            .into_iter()
            .flatten()
            .flat_map(|datum| match datum {
                Datum::Word(word) | Datum::Formula(word) => word.to_le_bytes().into_iter().take(size),
                Datum::Bytes(_) => [0; 8].into_iter().take(0), // only of other shapes
            })
            .collect(),
    }
}

//! The dictionary as a flat table, shared by the targets `rust` and `c`.
//!
//! Both languages get the same table and behave identically; docs/reference/generate.md describes the behaviour. The
//! parts:
//!
//! * **entries**: one row per index and sub-index, in ascending order for binary search. A row has the key,
//!   the code of the data type, flags, and two offsets: `ram` (0 for an entry in flash) and `rom`.
//! * **rom**: bytes in flash. For a type of at most eight bytes: the default, then the low limit and the high
//!   limit if flagged, each with the size of the type. For any other type: the capacity and the length of the
//!   default as two 16-bit numbers, then the default. All numbers are little-endian. A formula contains the
//!   offset to the node-ID.
//! * **fields**: the members of the struct of all variable values. Constant entries have none: those of
//!   access type `const`, type definitions, and non-writable sub-index 0 of RECORDs and compact objects. The
//!   elements of an ARRAY are one field if they are alike. Fields of a storage group are members of a
//!   separate struct.

use std::fmt;

use super::Note;
use super::head::Head;
use super::memory::TypeExtent;
use super::resolve::{Encoded, EntryPlan, ValueShape};
use crate::model::{Access, DataType};

/// A device's dictionary, ready for a template.
pub(crate) struct DeviceTable {
    pub(crate) head: Head,
    /// The node-ID for the generated code.
    pub(crate) node_id: Option<u8>,
    /// All objects that have rows, by index.
    pub(crate) objects: Vec<TableObject>,
    /// All rows, by index and sub-index.
    pub(crate) rows: Vec<Row>,
    /// All fields, in the order of their first rows.
    pub(crate) fields: Vec<TableField>,
    /// The storage groups with fields.
    pub(crate) groups: Vec<TableGroup>,
    /// The bytes in flash.
    pub(crate) rom: Vec<u8>,
    /// Omissions and assumptions.
    pub(crate) notes: Vec<Note>,
}

/// An object.
pub(crate) struct TableObject {
    pub(crate) index: u16,
    pub(crate) name: String,
    /// The words of its name: unique among modules; not a keyword.
    pub(crate) module: String,
    /// Whether it has a single value, so that its name needs no sub-index.
    pub(crate) single: bool,
    /// Its rows.
    pub(crate) rows: std::ops::Range<usize>,
}

/// An entry.
pub(crate) struct Row {
    pub(crate) index: u16,
    pub(crate) sub: u8,
    pub(crate) name: String,
    /// The words of its name: unique in its object.
    pub(crate) constant: String,
    pub(crate) resolved: EntryPlan,
    /// Its location in the struct of values.
    pub(crate) slot: Option<ValuePlace>,
    /// The offset of its data in flash.
    pub(crate) rom: usize,
    /// The length of its data; rows may share data.
    pub(crate) rom_length: usize,
    /// Whether hooks are called before reads and after writes.
    pub(crate) hooked: bool,
}

/// A group of values stored together.
pub(crate) struct TableGroup {
    /// The name as stated.
    pub(crate) name: String,
    /// Its member in the struct of values: unique there; not a keyword.
    pub(crate) field: String,
    /// Its sub-index of 1010h and 1011h, if CiA 301 defines it.
    pub(crate) sub_index: Option<u8>,
    /// A hash of index, sub-index, data type and length of all entries.
    pub(crate) layout: u32,
    /// Size of an image in bytes.
    pub(crate) image_size: usize,
}

/// A location in the struct of values.
#[derive(Clone, Copy)]
pub(crate) struct ValuePlace {
    /// Field number.
    pub(crate) field: usize,
    /// Element number in an array.
    pub(crate) element: Option<usize>,
}

/// A member of the struct of values.
pub(crate) struct TableField {
    /// Unique among fields; not a keyword.
    pub(crate) name: String,
    /// Whether its name is derived only from the object.
    pub(super) is_object: bool,
    pub(crate) shape: ValueShape,
    /// Its rows: one, or the elements of an array.
    pub(crate) rows: std::ops::Range<usize>,
    /// Whether it is an array.
    pub(crate) array: bool,
    /// Number of its storage group.
    pub(crate) group: Option<usize>,
}

impl TableField {
    /// Its size in C.
    pub(crate) fn extent(&self) -> TypeExtent {
        TypeExtent::of(self.shape).times(if self.array { self.rows.len() } else { 1 })
    }
}

impl Row {
    /// The flags, named as in the templates.
    pub(crate) fn flags(&self) -> impl Iterator<Item = &'static str> {
        let resolved = &self.resolved;
        let formula = |datum: Option<&Encoded>| datum.is_some_and(Encoded::is_formula);
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
            ("HOOK", self.hooked),
        ]
        .into_iter()
        .filter_map(|(flag, set)| set.then_some(flag))
    }

    /// The access type for documentation.
    pub(crate) fn access(&self) -> Access {
        self.resolved.access
    }
}

impl DeviceTable {
    /// The path of a value in the struct of values: `persist_comm.speed[1]`.
    pub(crate) fn place(&self, slot: &ValuePlace) -> FieldPath<'_> {
        FieldPath { table: self, slot: *slot }
    }

    /// The source of identifiers for a row: the words of its object, and of the entry if it has any.
    pub(crate) fn words_of(&self, row: &Row) -> String {
        match self.objects.iter().find(|object| object.index == row.index) {
            Some(object) if object.single => object.module.clone(),
            Some(object) => format!("{}_{}", object.module, row.constant),
            None => row.constant.clone(),
        }
    }

    /// The members of a group's struct, or the members of the struct of values without a group.
    pub(crate) fn members(&self, group: Option<usize>) -> impl Iterator<Item = &TableField> {
        self.fields.iter().filter(move |field| field.group == group)
    }

    /// Whether a field contains numbers of this data type.
    pub(crate) fn keeps(&self, data_type: DataType) -> bool {
        self.fields.iter().any(|field| field.shape == ValueShape::Word(data_type))
    }
}

/// A path in the struct of values, as written in code.
pub(crate) struct FieldPath<'a> {
    table: &'a DeviceTable,
    slot: ValuePlace,
}

impl fmt::Display for FieldPath<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let field = &self.table.fields[self.slot.field];
        if let Some(group) = field.group {
            write!(f, "{}.", self.table.groups[group].field)?;
        }
        f.write_str(&field.name)?;
        self.slot.element.map_or(Ok(()), |element| write!(f, "[{element}]"))
    }
}

//! Size of a target's tables in flash and RAM: rows, defaults, limits and values, without the code that uses
//! them.

use std::collections::BTreeSet;

use super::resolve::Shape;
use super::table::{Row, Table, TableField};
use crate::model::TypeKind;

/// Sizes in bytes for a processor that aligns numbers to their size, at most to eight bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Size {
    /// In flash: rows of the table, defaults and limits.
    pub flash: usize,
    /// In RAM: the writable values.
    pub ram: usize,
}

/// The size of an object.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ObjectSize {
    /// Its index.
    pub index: u16,
    /// Its name in the description.
    pub name: String,
    /// Number of entries.
    pub entries: usize,
    /// Its size. Shared defaults and limits count for the first object.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub size: Size,
}

/// The sizes of a target's tables, by object.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SizeReport {
    /// What the sizes include, and for which processor: a line in lower case.
    pub counted: &'static str,
    /// The objects, by index.
    pub objects: Vec<ObjectSize>,
    /// Bytes without an object: the node-ID, what rows share, end marks, and padding.
    pub rest: Size,
    /// Bytes of code in flash; 0 if it is not counted.
    pub code: usize,
    /// Bytes of the names of entries in flash, if the program uses them; 0 if they are omitted or in the rows.
    pub names: usize,
    /// The sum, with the code and without the names.
    pub total: Size,
}

/// The sizes of a target's tables, if known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sizes {
    /// The sizes.
    Known(SizeReport),
    /// Why they are unknown: a line in lower case.
    Unknown(&'static str),
}

/// The table layout of a target.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    /// Size of a row in bytes.
    pub(crate) row: usize,
    /// Size of an object without its rows, in bytes.
    pub(crate) object: usize,
    /// Size of what rows share beside defaults and limits, in bytes.
    pub(crate) shared: usize,
    /// Size of all values in bytes, with the node-ID.
    pub(crate) ram: usize,
    /// Size of one value in RAM, in bytes.
    pub(crate) value: fn(Shape) -> usize,
    /// Size of the code in flash, 0 if it is not counted.
    pub(crate) code: usize,
    /// Size of a name: of its row, and of its end mark; `None` without names.
    pub(crate) name: Option<(usize, usize)>,
    /// See [`SizeReport::counted`].
    pub(crate) counted: &'static str,
}

impl SizeReport {
    pub(crate) fn new(counted: &'static str, objects: Vec<ObjectSize>, rest: Size) -> Self {
        let total = objects.iter().fold(rest, |sum, object| sum + object.size);
        Self { counted, objects, rest, code: 0, names: 0, total }
    }

    pub(crate) fn of_table(table: &Table, layout: Layout) -> Self {
        let mut taken = vec![false; table.rom.len()];
        let mut rom_of = |row: &Row| {
            let bytes = taken.get_mut(row.rom..row.rom + row.rom_length).unwrap_or_default();
            let new = bytes.iter().filter(|taken| !**taken).count();
            bytes.fill(true);
            new
        };
        let objects: Vec<ObjectSize> = table
            .objects
            .iter()
            .map(|object| {
                let rows = &table.rows[object.rows.clone()];
                let rom: usize = rows.iter().map(&mut rom_of).sum();
                let values = rows.iter().filter(|row| row.slot.is_some());
                let ram = values.map(|row| (layout.value)(row.resolved.shape)).sum();
                ObjectSize {
                    index: object.index,
                    name: object.name.clone(),
                    entries: rows.len(),
                    size: Size { flash: layout.object + rows.len() * layout.row + rom, ram },
                }
            })
            .collect();
        let rows = objects.len() * layout.object + table.rows.len() * layout.row;
        let total = Size { flash: rows + layout.shared + table.rom.len(), ram: layout.ram };
        let of_objects = objects.iter().fold(Size::default(), |sum, object| sum + object.size);
        let rest = Size {
            flash: total.flash.saturating_sub(of_objects.flash),
            ram: total.ram.saturating_sub(of_objects.ram),
        };
        let Layout { code, counted, .. } = layout;
        let names = layout.name.map_or(0, |(row, end)| {
            let texts: BTreeSet<&str> = table.rows.iter().map(|row| row.name.as_ref()).collect(); // equal ones are one
            table.rows.len() * row + texts.iter().map(|text| text.len() + end).sum::<usize>()
        });
        Self { counted, objects, rest, code, names, total: Size { flash: total.flash + code, ..total } }
    }
}

impl std::ops::Add for Size {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { flash: self.flash + other.flash, ram: self.ram + other.ram }
    }
}

/// Size of the struct of values in C, including the one-byte node-ID.
pub(crate) fn ram(table: &Table) -> usize {
    let fields = |group| table.members(group).map(|field| (alignment(field.shape), field_size(field)));
    let groups = (0..table.groups.len()).map(|group| structure(fields(Some(group)), false));
    let (_, size) = structure(fields(None).chain(groups).chain([(1, 1)]), true);
    size
}

/// Alignment and size of a struct with members of these.
fn structure(members: impl Iterator<Item = (usize, usize)>, is_ascending: bool) -> (usize, usize) {
    let mut members: Vec<(usize, usize)> = members.collect();
    members.sort_by_key(|&(alignment, _)| alignment);
    let widest = members.last().map_or(1, |&(alignment, _)| alignment);
    if !is_ascending {
        members.reverse();
    }
    let end = members.iter().fold(0, |end: usize, &(alignment, size)| end.next_multiple_of(alignment) + size);
    (widest, end.next_multiple_of(widest))
}

/// Alignment of a group's struct.
pub(crate) fn group_alignment(table: &Table, group: usize) -> usize {
    table.members(Some(group)).map(|field| alignment(field.shape)).max().unwrap_or(1)
}

/// Size of a field in bytes.
pub(crate) fn field_size(field: &TableField) -> usize {
    element_size(field.shape) * if field.array { field.rows.len() } else { 1 }
}

/// Size of one value in RAM, in bytes.
pub(crate) fn element_size(shape: Shape) -> usize {
    match shape {
        Shape::Block(length) => usize::from(length),
        // preceded by its length
        Shape::Bytes(_, capacity) => (2 + usize::from(capacity)).next_multiple_of(2),
        Shape::Word(_) if is_time(shape) => 8,
        Shape::Word(_) => shape.size().next_power_of_two(),
    }
}

/// Alignment of a value.
pub(crate) fn alignment(shape: Shape) -> usize {
    match shape {
        Shape::Block(_) => 1,
        Shape::Bytes(..) => 2,
        Shape::Word(_) if is_time(shape) => 4,
        Shape::Word(_) => shape.size().next_power_of_two(),
    }
}

fn is_time(shape: Shape) -> bool {
    matches!(shape, Shape::Word(data_type)
        if matches!(data_type.kind(), TypeKind::TimeOfDay | TypeKind::TimeDifference))
}

//! The rows of the compact table: their shared parts, and the widths of their numbers.

use std::collections::HashMap;

use super::words::{flags, type_name};
use crate::Sizes;
use crate::memory::{Memory, TypeExtent};
use crate::table::DeviceTable;
use crate::table_size::{TableLayout, ram};

/// The types of the numbers in rows, each as narrow as the device allows, and the shared parts of rows.
pub(super) struct Rows {
    /// The pairs of data type and flags that rows have, as macros after the prefix and as an expression.
    pub(super) kinds: Vec<(&'static str, String)>,
    /// The kind of each row.
    pub(super) kind_of: Vec<usize>,
    /// Bits of a kind's number.
    kind: usize,
    /// Bits of a location in RAM or flash.
    offset: usize,
    /// Bits of a row's number.
    first: usize,
}

impl Rows {
    pub(super) fn new(table: &DeviceTable, upper: &str) -> Self {
        let mut kinds = Vec::new();
        let mut known = HashMap::new();
        let kind_of = table.rows.iter().map(|row| {
            let kind = (type_name(row.resolved.shape), flags(row.flags(), upper));
            *known.entry(kind).or_insert_with_key(|kind| {
                kinds.push(kind.clone());
                kinds.len() - 1
            })
        });
        let kind_of = kind_of.collect();
        Self {
            kind: if kinds.len() > 1 << 8 { 16 } else { 8 },
            offset: bits(ram(table).max(table.rom.len())),
            first: bits(table.rows.len()),
            kinds,
            kind_of,
        }
    }

    /// The type of a kind's number.
    pub(super) fn kind(&self) -> String {
        format!("uint{}_t", self.kind)
    }

    /// The type of a location in RAM or flash.
    pub(super) fn offset(&self) -> String {
        format!("uint{}_t", self.offset)
    }

    /// The type of a row's number.
    pub(super) fn first(&self) -> String {
        format!("uint{}_t", self.first)
    }
}

/// Computes the size of the table.
pub(super) fn size(table: &DeviceTable, names: bool) -> Sizes {
    let rows = Rows::new(table, "");
    let offset = TypeExtent::number(rows.offset / 8);
    let row = TypeExtent::structure([TypeExtent::BYTE, TypeExtent::number(rows.kind / 8), offset, offset]);
    let layout = TableLayout {
        row: row.size,
        object: TypeExtent::structure([TypeExtent::HALF, TypeExtent::number(rows.first / 8)]).size,
        shared: TypeExtent::HALF.times(rows.kinds.len()).size,
        ram: ram(table),
        section: Memory::Zeroed,
        value: |shape| TypeExtent::of(shape).size,
        code: 0,
        name: names.then_some((4, 1)), // a pointer of 32 bits, and the zero
        counted: "the tables and values, on any processor that aligns numbers to their size; without code",
    };
    layout.size(table)
}

/// The bits of an unsigned type for numbers up to this one.
fn bits(largest: usize) -> usize {
    if largest > usize::from(u16::MAX) { 32 } else { 16 }
}

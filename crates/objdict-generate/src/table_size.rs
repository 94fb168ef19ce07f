//! The size of a flat table: its rows, its bytes in flash and the struct of values.

use std::collections::BTreeSet;

use super::memory::{Memory, SizeTally, TypeExtent};
use super::resolve::ValueShape;
use super::size::Sizes;
use super::table::{DeviceTable, TableField};

/// Adds up the sizes of the objects of a table.
pub(crate) fn tally(table: &DeviceTable) -> SizeTally {
    let objects = table.objects.iter();
    SizeTally::new(objects.map(|object| (object.index, object.name.as_str(), object.rows.len())))
}

/// The struct of a storage group in C: the widest members are first.
pub(crate) fn group(table: &DeviceTable, group: usize) -> TypeExtent {
    let mut members: Vec<TypeExtent> = table.members(Some(group)).map(TableField::extent).collect();
    members.sort_by_key(|member| std::cmp::Reverse(member.alignment));
    TypeExtent::structure(members)
}

/// Size of the struct of values in C, including the one-byte node-ID: the widest members are last.
pub(crate) fn ram(table: &DeviceTable) -> usize {
    let groups = (0..table.groups.len()).map(|number| group(table, number));
    let mut members: Vec<TypeExtent> =
        table.members(None).map(TableField::extent).chain(groups).chain([TypeExtent::BYTE]).collect();
    members.sort_by_key(|member| member.alignment);
    TypeExtent::structure(members).size
}

/// The layout of a table of rows.
#[derive(Clone, Copy)]
pub(crate) struct TableLayout {
    /// Size of a row in bytes.
    pub(crate) row: usize,
    /// Size of an object without its rows, in bytes.
    pub(crate) object: usize,
    /// Size of the shared parts of rows except defaults and limits, in bytes.
    pub(crate) shared: usize,
    /// Size of all values in bytes, with the node-ID.
    pub(crate) ram: usize,
    /// Whether the values have initial values in flash, like a `static`.
    pub(crate) section: Memory,
    /// Size of one value in RAM, in bytes.
    pub(crate) value: fn(ValueShape) -> usize,
    /// Size of the code in flash, 0 if unknown.
    pub(crate) code: usize,
    /// Size of a name: in its row, and of its end mark; `None` without names.
    pub(crate) name: Option<(usize, usize)>,
    /// See [`SizeReport::counted`].
    pub(crate) counted: &'static str,
}

impl TableLayout {
    /// The size of a table.
    pub(crate) fn size(self, table: &DeviceTable) -> Sizes {
        let mut tally = tally(table);
        let mut taken = vec![false; table.rom.len()];
        let mut values = 0;
        for row in &table.rows {
            let rom = taken.get_mut(row.rom..row.rom + row.rom_length).unwrap_or_default();
            let new = rom.iter().filter(|taken| !**taken).count();
            rom.fill(true);
            tally.of(row.index, Memory::Flash, self.row + new);
            let value = row.slot.map_or(0, |_| (self.value)(row.resolved.shape));
            tally.of(row.index, self.section, value);
            values += value;
        }
        table.objects.iter().for_each(|object| tally.of(object.index, Memory::Flash, self.object));
        let unused = taken.iter().filter(|taken| !**taken).count();
        tally.rest(Memory::Flash, self.shared + unused);
        tally.rest(self.section, self.ram.saturating_sub(values));
        let mut report = tally.sums(self.counted);
        report.code = self.code;
        report.total.flash += self.code;
        report.names = self.name.map_or(0, |(row, end)| {
            let texts: BTreeSet<&str> = table.rows.iter().map(|row| row.name.as_ref()).collect(); // equal ones are one
            table.rows.len() * row + texts.iter().map(|text| text.len() + end).sum::<usize>()
        });
        Sizes::Known(report)
    }
}

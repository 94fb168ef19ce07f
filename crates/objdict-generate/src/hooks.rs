//! Hooks of the flat table: callbacks of the application before reads and after writes of an entry.

use super::memory::TypeExtent;
use super::notes::in_order;
use super::table::{DeviceTable, Row};
use super::{Note, Options};
use crate::model::{Address, Device, Place};

/// Larger buffers are unexpected on a stack.
const LONG: usize = 256;

/// Marks the requested rows; notes missing entries, and values that a hook cannot change.
pub(super) fn mark(device: &Device, options: &Options, table: &mut DeviceTable) {
    if options.hooks.is_empty() {
        return;
    }
    for &at in &options.hooks {
        let Address { index, sub } = at;
        let asked = |row: &&mut Row| row.index == index && sub.is_none_or(|sub| row.sub == sub);
        let (mut rows, mut constants) = (0, 0);
        for row in table.rows.iter_mut().filter(asked) {
            let is_elsewhere = row.slot.is_none() && !row.resolved.constant;
            row.hooked = !is_elsewhere; // the application provides the value
            rows += usize::from(row.hooked);
            constants += usize::from(row.slot.is_none() && row.hooked);
        }
        let is_described =
            device.objects.get(&index).is_some_and(|object| sub.is_none_or(|sub| object.has(sub)));
        let text = match (rows, is_described) {
            (0, true) => "the table has nothing here that a hook could be called for",
            (0, false) => "no entry to call a hook for",
            _ if rows == constants => {
                "the value is in flash: the hook is called before a read, but cannot change it"
            }
            _ => continue,
        };
        table.notes.push(Note::new(Place::at(at.index, at.sub), text));
    }
    let long = table.rows.iter().filter(|row| row.hooked && TypeExtent::of(row.resolved.shape).size > LONG);
    let long = long.filter(|row| row.slot.is_some() && row.access().is_writable()).map(|row| {
        let text = format!(
            "{} bytes on the stack hold the old value while a hook checks the new one",
            TypeExtent::of(row.resolved.shape).size
        );
        Note::new(Place::entry(row.index, row.sub), text)
    });
    let long: Vec<Note> = long.collect();
    table.notes.extend(long);
    table.notes = in_order(std::mem::take(&mut table.notes));
}

/// Whether any row is marked.
pub(crate) fn has_hooks(table: &DeviceTable) -> bool {
    table.rows.iter().any(|row| row.hooked)
}

/// Size of the longest value to restore after a hook rejects a write, at least that of a number.
pub(crate) fn room(table: &DeviceTable) -> usize {
    let kept = table.rows.iter().filter(|row| row.hooked && row.slot.is_some() && row.access().is_writable());
    kept.map(|row| TypeExtent::of(row.resolved.shape).size).max().unwrap_or(0).max(8)
}

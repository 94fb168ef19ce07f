//! The target `rust`: one file without dependencies, `od.rs`.
//!
//! Values are one byte array (`Data`) in SDO byte order. A handle is a constant with the position of its
//! value, so `get` is a load without code of its own, and access by index uses one path for all entries.

mod literal;
mod meanings;
mod objects;
mod view;

#[cfg(feature = "stacks")]
pub(super) use literal::{value_of, word_type};

use super::defaults::constants;
use super::frames::{frames, freeze_mappings};
use super::meanings::meanings;
use super::memory::Memory;
use super::notes::in_order;
use super::resolve::ValueShape;
use super::table::DeviceTable;
use super::table_size::TableLayout;
use super::{BackendOutput, GenerateError, Options, render, unserved};
use crate::model::{DataType, Device};

/// The size of `Data::new`, `read` and `write` with everything they call, on a Cortex-M4: the compiler omits code that
/// no row of the table needs. `tests/generate/thumb.rs` compares the total with the linker.
fn code(table: &DeviceTable, ram: usize) -> usize {
    let rows = || table.rows.iter();
    let is_any = |is_it: fn(&DataType) -> bool| {
        rows().filter_map(|row| row.resolved.shape.data_type()).any(|of| is_it(&of))
    };
    let flagged = |flags: [&str; 2]| rows().any(|row| row.flags().any(|flag| flags.contains(&flag)));
    let adds_node_id = flagged(["NODE_ID_DEFAULT"; 2]);
    let has_limits = flagged(["LOW", "HIGH"]);
    let has_lengths = rows().any(|row| !matches!(row.resolved.shape, ValueShape::Word(_)));
    let parts = [
        (true, 1_090),
        (has_lengths, 337),
        (adds_node_id || has_limits, 171),
        (adds_node_id, 150),
        (has_limits, 422),
        // offsets that exceed the range of an instruction
        (ram >= 256, 25),
        (is_any(|of| *of == DataType::DOMAIN), 30),
        (is_any(|of| *of == DataType::BOOLEAN), 40),
    ];
    parts.iter().filter(|(is_needed, _)| *is_needed).map(|(_, bytes)| bytes).sum()
}

/// Tables for Rust, with or without the standard library.
pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let module = options.module_or("od")?;
    let mut table = DeviceTable::new(device, options)?;
    let mut notes = std::mem::take(&mut table.notes);
    if options.cell.is_some() && !(options.runtime && table.node_id.is_some()) {
        return Err(GenerateError::NoCell);
    }
    if options.runtime {
        notes.extend(unserved::notes(&table));
    } else {
        notes.extend(freeze_mappings(&mut table, "`--runtime` or `--hook` allows it"));
    }
    let frames = frames(device, &table, &mut notes);
    let constants = constants(device, &table, &mut notes);
    let named = meanings(device, &table, options, &mut notes);
    let od = view::RustView::new(device, &table, options, &frames, &constants, &named)?;
    let file = render(format!("{module}.rs"), od.text());
    let layout = TableLayout {
        row: 10,
        object: 0,
        shared: 0,
        ram: od.places.total,
        section: if options.cell.is_some() { Memory::Initialised } else { Memory::Zeroed },
        value: view::value_size,
        code: code(&table, od.places.total),
        name: options.entry_names.then_some((8, 0)), // a slice on 32 bits
        counted: match options.cell {
            Some(_) => {
                "the tables and values, with the initial values of `SHARED` in flash, on any processor; the code on a Cortex-M4, optimised for size"
            }
            None if options.runtime => {
                "the tables and values, on any processor; the code on a Cortex-M4, optimised for size, without the services of the node (docs/reference/table-size.md)"
            }
            None => {
                "the tables and values, on any processor (a `static` of the values takes as much flash again); the code on a Cortex-M4, optimised for size"
            }
        },
    };
    let size = layout.size(&table);
    Ok(BackendOutput { files: vec![file], notes: in_order(notes), size })
}

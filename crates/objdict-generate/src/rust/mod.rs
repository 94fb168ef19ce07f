//! The target `rust`: one file without dependencies, `od.rs`.
//!
//! Values are one array of bytes (`Data`) in SDO byte order. A handle is a constant with the position of its
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
use super::table::DeviceTable;
use super::table_size::TableLayout;
use super::{BackendOutput, GenerateError, Options, render, unserved};
use crate::model::Device;

/// Bytes of `Data::new`, `read` and `write` with everything they call, for a device that needs all of it.
const CODE: usize = 2_700;

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
        code: CODE,
        name: options.entry_names.then_some((8, 0)), // a slice on 32 bits
        counted: match options.cell {
            Some(_) => {
                "the tables and values, with the initial values of `SHARED` in flash, on any processor; the code on a Cortex-M4, optimised for size"
            }
            None => {
                "the tables and values, on any processor (a `static` of the values takes as much flash again); the code on a Cortex-M4, optimised for size"
            }
        },
    };
    let size = layout.size(&table);
    Ok(BackendOutput { files: vec![file], notes: in_order(notes), size })
}

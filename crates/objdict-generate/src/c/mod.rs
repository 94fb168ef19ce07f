//! The target `c`: `od.h` and `od.c` in C99.

mod meanings;
mod pdo;
mod rows;
mod structs;
mod view;
mod words;

#[cfg(feature = "rust")]
use super::Identifier;
#[cfg(feature = "rust")]
use super::defaults::constants;
use super::frames::{frames, freeze_mappings};
use super::hooks::has_hooks;
use super::notes::in_order;
use super::table::DeviceTable;
use super::{BackendOutput, CTable, GenerateError, Note, Options, PdoMappings, render};
use crate::model::{Device, Place};

/// Identifiers of the targets `c` and `rust` for the objects and entries of a device, without options.
#[cfg(feature = "rust")]
pub(super) fn identifiers(device: &Device) -> Result<Vec<Identifier>, GenerateError> {
    let options = Options::default();
    let (prefix, module) = (options.prefix_or("od")?, options.module_or("od")?);
    let table = DeviceTable::of_names(device, &options)?;
    let constants = constants(device, &table, &mut Vec::new());
    let (objects, _) = view::object_views(&table, &prefix, constants.iter().flat_map(view::item_views));
    let upper = prefix.to_ascii_uppercase();
    let mut identifiers = Vec::with_capacity(table.objects.len() + table.rows.len());
    for view::ObjectMacros { object, name, entries } in &objects {
        let mut add = |sub: Option<u8>, constant: &str, name: &str| {
            let rust = match object.single {
                true => [&module, "::", &object.module.to_ascii_uppercase()].concat(),
                false => [&module, "::", &object.module, "::", constant].concat(),
            };
            let c = [&upper, "_", name].concat();
            identifiers.push(Identifier { index: object.index, sub, rust, c });
        };
        add(None, "INDEX", name);
        for (name, row) in entries {
            add(Some(row.sub), &row.constant.to_ascii_uppercase(), name);
        }
    }
    Ok(identifiers)
}

/// Tables for C.
pub(super) fn make(device: &Device, options: &Options) -> Result<BackendOutput, GenerateError> {
    let prefix = options.prefix_or("od")?;
    let stem = options.prefix.as_deref().unwrap_or(&prefix);
    let mut table = DeviceTable::new(device, options)?;
    let mut notes = std::mem::take(&mut table.notes);
    let are_fixed = options.pdo_mappings == PdoMappings::Fixed;
    if are_fixed {
        notes.extend(freeze_mappings(&mut table, "`--pdo-mapping dynamic` or `--hook` allows it"));
    }
    let frames = frames(device, &table, &mut notes);
    let facts = view::HeaderContents::new(device, &table, options, &mut notes);
    let tables = view::CView::new(&table, (&prefix, stem), &facts);
    let (header, source, size) = match options.table {
        CTable::Compact => (
            render(format!("{stem}.h"), tables.header()),
            render(format!("{stem}.c"), tables.source()),
            rows::size(&table, options.entry_names),
        ),
        CTable::Structs => (
            render(format!("{stem}.h"), tables.structs_header()),
            render(format!("{stem}.c"), tables.structs_source()),
            structs::size(&table, &prefix, options.entry_names),
        ),
    };
    let mut files = vec![header, source];
    if options.table == CTable::Structs && has_hooks(&table) {
        let text = "an array of structures has no functions that could call hooks";
        let note = Note::new(Place::device(), text);
        notes.push(note.help("check the `HOOK` flag where entries are read and written"));
    }
    if !frames.is_empty() {
        let view = pdo::PdoFiles::new(&table, (&prefix, stem), &frames, are_fixed);
        files.push(render(format!("{stem}_pdo.h"), view.header()));
        files.push(render(format!("{stem}_pdo.c"), view.source()));
    }
    Ok(BackendOutput { files, notes: in_order(notes), size })
}

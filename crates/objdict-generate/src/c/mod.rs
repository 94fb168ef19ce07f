//! The target `c`: `od.h` and `od.c` in C99.

mod defaults;
mod meanings;
mod pdo;
mod rows;
mod stored;
mod structs;
mod view;

#[cfg(feature = "rust")]
use super::Identifier;
#[cfg(feature = "rust")]
use super::defaults::constants;
use super::frames::{frames, freeze_mappings};
use super::hooks::has_hooks;
use super::notes::in_order;
use super::size::{Layout, element_size, ram};
use super::table::Table;
use super::{Backend, CTable, Choice, GenerateError, Generated, Note, Options, SizeReport, Sizes, render};
use crate::model::{Device, Place};

/// What allows SDOs to write PDO mappings.
const UNLESS: &str = "`--hook` allows it";

/// Tables for C.
pub(super) struct C;

/// Identifiers of the targets `c` and `rust` for the objects and entries of a device, without options.
#[cfg(feature = "rust")]
pub(super) fn identifiers(device: &Device) -> Result<Vec<Identifier>, GenerateError> {
    let options = Options::default();
    let (prefix, module) = (options.prefix_or("od")?, options.module_or("od")?);
    let table = Table::of_names(device, &options)?;
    let (objects, _) = view::object_views(&table, &prefix, &constants(device, &table, &mut Vec::new()));
    let upper = prefix.to_ascii_uppercase();
    let mut identifiers = Vec::with_capacity(table.objects.len() + table.rows.len());
    for view::ObjectView { object, name, entries } in &objects {
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

impl Backend for C {
    fn name(&self) -> &'static str {
        "c"
    }

    fn summary(&self) -> &'static str {
        "`od.h` and `od.c` in C99 (no malloc): dictionary, values, SDO access by index and sub-index"
    }

    fn uses(&self) -> &'static [Choice] {
        &[
            Choice::Names,
            Choice::Renamed,
            Choice::Prefix,
            Choice::Groups,
            Choice::Hooks,
            Choice::StringCapacity,
            Choice::DomainCapacity,
            Choice::Table,
            Choice::EntryNames,
        ]
    }

    fn generate(&self, device: &Device, options: &Options) -> Result<Generated, GenerateError> {
        let prefix = options.prefix_or("od")?;
        let mut table = Table::new(device, options)?;
        let mut notes = std::mem::take(&mut table.notes);
        notes.extend(freeze_mappings(&mut table, UNLESS));
        let frames = frames(device, &table, &mut notes);
        let facts = view::Facts::new(device, &table, options, &mut notes);
        let (header, source) = (format!("{prefix}.h"), format!("{prefix}.c"));
        let names = options.entry_names;
        let mut files = match options.table {
            CTable::Compact => vec![
                render(header, &view::Header::new(&table, &prefix, &facts))?,
                render(source, &view::Source::new(&table, &prefix, names))?,
            ],
            CTable::Structs => vec![
                render(header, &structs::StructsHeader::new(&table, &prefix, &facts, names))?,
                render(source, &structs::StructsSource::new(&table, &prefix, names))?,
            ],
        };
        if options.table == CTable::Structs && has_hooks(&table) {
            let text = "an array of structures has no functions that could call hooks";
            let note = Note::new(Place::device(), text);
            notes.push(note.help("look at the flag `HOOK` of the entries where they are read and written"));
        }
        if !frames.is_empty() {
            files.push(render(format!("{prefix}_pdo.h"), &pdo::PdoHeader::new(&table, &prefix, &frames))?);
            files.push(render(format!("{prefix}_pdo.c"), &pdo::PdoSource::new(&table, &prefix, &frames))?);
        }
        Ok(Generated { files, notes: in_order(notes) })
    }

    fn size(&self, device: &Device, options: &Options) -> Result<Sizes, GenerateError> {
        let mut table = Table::new(device, options)?;
        freeze_mappings(&mut table, UNLESS);
        if options.table == CTable::Structs {
            let prefix = options.prefix_or("od")?;
            return Ok(Sizes::Known(structs::size(&table, &prefix, options.entry_names)));
        }
        let rows = rows::Rows::new(&table, "");
        let counted =
            "the tables and values, on any processor that aligns numbers to their size; without code";
        let name = options.entry_names.then_some((4, 1)); // a pointer of 32 bits, and the zero
        let layout = Layout {
            row: rows.row_size(),
            object: rows.object_size(),
            shared: rows.kinds_size(),
            ram: ram(&table),
            value: element_size,
            code: 0,
            name,
            counted,
        };
        Ok(Sizes::Known(SizeReport::of_table(&table, layout)))
    }
}

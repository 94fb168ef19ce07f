//! What the tables of targets take, for `objdict generate --report size`.

use std::io::{self, Write};

use serde::Serialize;

use super::table::Table;
use crate::generate::{Size, SizeReport, Target};

/// The version of the JSON document, see docs/json.md.
const VERSION: u32 = 1;

/// So many characters of an object's name are shown.
const LONGEST_NAME: usize = 40;

#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    targets: Vec<OfTarget<'a>>,
}

#[derive(Serialize)]
struct OfTarget<'a> {
    target: &'static str,
    #[serde(flatten)]
    report: &'a SizeReport,
}

/// All reports as one JSON document.
pub(super) fn write_json(reports: &[(Target, SizeReport)], out: &mut dyn Write) -> io::Result<()> {
    let targets = reports.iter().map(|(target, report)| OfTarget { target: target.name(), report }).collect();
    serde_json::to_writer_pretty(&mut *out, &Document { version: VERSION, targets })?;
    writeln!(out)
}

/// A table for each target of which there is a report, a word for the others.
pub(super) fn write_tables(
    targets: impl Iterator<Item = &'static str>,
    reports: &[(Target, SizeReport)],
    out: &mut dyn Write,
) -> io::Result<()> {
    for name in targets {
        let Some((target, report)) = reports.iter().find(|(target, _)| target.name() == name) else {
            writeln!(out, "\n{name}: what the tables take is not known")?;
            continue;
        };
        writeln!(out, "\n{}: bytes of the tables, without the code that serves them", target.name())?;
        let mut table = Table::new(["Object", "Entries", "Flash", "RAM", "Name"], LONGEST_NAME);
        let row = |first: String, entries: String, size: Size, name: &str| {
            [first, entries, size.flash.to_string(), size.ram.to_string(), name.to_owned()]
        };
        for object in &report.objects {
            let index = format!("{:04X}h", object.index);
            table.row(row(index, object.entries.to_string(), object.size, &object.name));
        }
        let entries: usize = report.objects.iter().map(|object| object.entries).sum();
        table.row(row("rest".to_owned(), String::new(), report.rest, "node-ID and gaps"));
        table.row(row("total".to_owned(), entries.to_string(), report.total, ""));
        table.write(out)?;
    }
    Ok(())
}

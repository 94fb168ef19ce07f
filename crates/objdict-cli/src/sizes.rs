//! What the tables of targets take, for `objdict generate --report size`.

use std::io::{self, Write};

use serde::Serialize;

use super::stdout::Output;
use super::table::TextTable;
use objdict_generate::{Size, SizeReport, Sizes, Target};
use objdict_model::json::Version;

/// So many characters of an object's name are shown.
const LONGEST_NAME: usize = 40;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SizesJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The targets, in the order of the command.
    targets: Vec<OfTarget<'a>>,
}

/// The sizes of a target; of one whose sizes are unknown only the reason.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Target"))]
struct OfTarget<'a> {
    /// The name of the target.
    target: &'static str,
    #[serde(flatten)]
    known: Option<&'a SizeReport>,
    /// Why the sizes are unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    unknown: Option<&'static str>,
}

impl<'a> OfTarget<'a> {
    fn new((target, sizes): &'a (Target, Sizes)) -> Self {
        let (known, unknown) = match sizes {
            Sizes::Known(report) => (Some(report), None),
            Sizes::Unknown(why) => (None, Some(*why)),
        };
        Self { target: target.name(), known, unknown }
    }
}

/// All reports as one JSON document.
pub(super) fn write_json(reports: &[(Target, Sizes)], out: &mut Output) -> io::Result<()> {
    let targets = reports.iter().map(OfTarget::new).collect();
    out.pretty_json(&SizesJson { version: Version, targets })
}

/// A table for each target of which the sizes are known, a word for the others.
pub(super) fn write_tables(reports: &[(Target, Sizes)], out: &mut dyn Write) -> io::Result<()> {
    for (target, sizes) in reports {
        let name = target.name();
        match sizes {
            Sizes::Known(report) => write_table(name, report, out)?,
            Sizes::Unknown(why) => writeln!(out, "\n{name}: the table size is unknown: {why}")?,
        }
    }
    Ok(())
}

fn write_table(target: &str, report: &SizeReport, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n{target}: bytes of {}", report.counted)?;
    let mut table = TextTable::new(["Object", "Entries", "Flash", "RAM", "Name"], LONGEST_NAME);
    let row = |first: String, entries: String, size: Size, name: &str| {
        [first, entries, size.flash.to_string(), size.ram.to_string(), name.to_owned()]
    };
    for object in &report.objects {
        let index = format!("{:04X}h", object.index);
        table.row(row(index, object.entries.to_string(), object.size, &object.name));
    }
    let entries: usize = report.objects.iter().map(|object| object.entries).sum();
    table.row(row("rest".to_owned(), String::new(), report.rest, "data outside objects, and gaps"));
    if report.code > 0 {
        let code = Size { flash: report.code, ram: 0 };
        table.row(row("code".to_owned(), String::new(), code, "to read, write and initialise"));
    }
    if report.names > 0 {
        let names = Size { flash: report.names, ram: 0 };
        table.row(row(
            "(names)".to_owned(),
            String::new(),
            names,
            "if the program uses them, not in the total",
        ));
    }
    table.row(row("total".to_owned(), entries.to_string(), report.total, ""));
    table.write(out)
}

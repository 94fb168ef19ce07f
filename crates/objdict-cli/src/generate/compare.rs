//! `objdict generate --compare`: tables that a project has already, beside those that would be written.

use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;

use super::super::args::{GenerateArgs, SizeFormat};
use super::super::ending::{Failure, Outcome};
use super::super::input::name_of;
use super::super::stdout::Output;
use objdict_build::pipeline::Generation;
use objdict_generate::{OptionValue, StackLayout, TableAspect, TableDifference, Target, compare_tables};
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_model::source::{SourceFile, SourceOptions};

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct TableDifferences<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The header that the tables are compared with.
    header: String,
    /// The layout (`--layout`) with the fewest differences, which identifies the editor version that wrote the header.
    #[serde(skip_serializing_if = "Option::is_none")]
    layout: Option<&'static str>,
    /// What differs, by who notices it.
    differences: &'a [TableDifference],
}

pub(super) fn run(
    args: &GenerateArgs,
    header: &Path,
    generation: &Generation,
    produce: impl Fn(StackLayout) -> Option<Generation>,
    out: &mut Output,
) -> Result<Outcome, Failure> {
    let (target, generated) = generation
        .outputs
        .iter()
        .find(|(target, _)| target.is_compared())
        .ok_or_else(|| not_compared(generation))?;
    let made = generated.files.iter().find(|file| file.path.ends_with(".h"));
    let name = made.and_then(|file| file.path.rsplit('/').next()).unwrap_or("OD.h");
    let header = if header.is_dir() { header.join(name) } else { header.to_owned() };
    let (header_text, source) = (read(&header)?, read(&header.with_extension("c"))?);
    let Some(differences) = compare_tables(*target, header_text.text(), source.text(), generated) else {
        let failure = Failure::new(format_args!("`{}` has no tables of {}", name_of(&header), target.name()));
        return Err(
            failure.help(format!("name the header that the stack is compiled with, such as `{name}`"))
        );
    };
    let count = |layout| {
        let generation = produce(layout)?;
        let (_, generated) = generation.outputs.iter().find(|(other, _)| other.name() == target.name())?;
        Some(compare_tables(*target, header_text.text(), source.text(), generated)?.len())
    };
    let layout = layout_of(args.options.given().layout, differences.len(), count);
    if args.format == SizeFormat::Json {
        let document = TableDifferences {
            version: Version,
            header: name_of(&header),
            layout,
            differences: &differences,
        };
        out.pretty_json(&document)?;
    } else {
        write_text(&name_of(&header), &differences, out)?;
        if let Some(layout) = layout {
            writeln!(out, "the old tables have the layout `{layout}`")?;
        }
    }
    Ok(if differences.is_empty() { Outcome::Clean } else { Outcome::Findings })
}

/// The layout with which the fewest differ, of several the given one; `None` if all are alike.
fn layout_of(
    given: StackLayout,
    differing: usize,
    count: impl Fn(StackLayout) -> Option<usize>,
) -> Option<&'static str> {
    let mut counts: Vec<_> = StackLayout::ALL
        .iter()
        .filter_map(|&(layout, name, _)| match layout == given {
            true => Some((differing, 0, name)),
            false => Some((count(layout)?, 1, name)),
        })
        .collect();
    counts.sort_unstable();
    let (fewest, most) = (counts.first()?, counts.last()?);
    (fewest.0 < most.0).then_some(fewest.2)
}

fn not_compared(generation: &Generation) -> Failure {
    let names = generation.outputs.iter().map(|(target, _)| target.name()).collect::<Vec<_>>().join(", ");
    let compared = Target::all().filter(|target| target.is_compared()).map(Target::name).collect::<Vec<_>>();
    Failure::new(format_args!("`--compare` cannot read tables of {names}"))
        .help(format!("it compares tables of {}", compared.join(", ")))
}

fn read(path: &Path) -> Result<SourceFile, Failure> {
    SourceFile::open(path, &SourceOptions::default()).map_err(Failure::new)
}

fn write_text(header: &str, differences: &[TableDifference], out: &mut Output) -> io::Result<()> {
    for aspect in TableAspect::ALL {
        let of_aspect: Vec<_> = differences.iter().filter(|difference| difference.aspect == aspect).collect();
        if !of_aspect.is_empty() {
            writeln!(out, "{}", title(aspect))?;
        }
        for TableDifference { place, old, new, .. } in of_aspect {
            match (old, new) {
                (Some(old), Some(new)) if old == place => writeln!(out, "  {old} -> {new}")?,
                (Some(old), Some(new)) => writeln!(out, "  {place}: {old} -> {new}")?,
                (Some(old), None) => writeln!(out, "  {place}: removed ({old})")?,
                (None, new) => writeln!(out, "  {place}: added ({})", new.as_deref().unwrap_or_default())?,
            }
        }
    }
    match differences.len() {
        0 => writeln!(out, "{header}: the same tables"),
        count => writeln!(out, "{header}: {}", plural(count, "difference")),
    }
}

const fn title(aspect: TableAspect) -> &'static str {
    match aspect {
        TableAspect::Names => "Names and types, for the application:",
        TableAspect::Layout => "Stored values, which are read back from memory:",
        TableAspect::Objects => "Objects and entries, on the bus:",
        TableAspect::Values => "Initial values:",
    }
}

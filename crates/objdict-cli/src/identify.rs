//! `objdict identify`.

use std::io::Write;
use std::path::Path;

use serde::Serialize;

use super::args::{AnswerFormat, IdentifyArgs};
use super::ending::{Failure, Outcome};
use super::input::{name_of, source_name};
use super::stdout::Output;
use objdict_format::identify::{Identification, identify};
use objdict_model::diagnostic::one_line;
use objdict_model::json;

/// The version of the JSON document. It changes when a field is removed or means something else.
const VERSION: u32 = 1;

/// The document, which is written file by file.
#[cfg(feature = "schema")]
#[derive(schemars::JsonSchema)]
#[allow(dead_code, reason = "its schema is all that is made of it")]
pub(super) struct IdentifyJson<'a> {
    /// The version of the document.
    version: objdict_model::json::Version<VERSION>,
    /// The files in the order of the arguments, without unreadable ones.
    files: Vec<IdentifyRow<'a>>,
}

/// A file.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "File"))]
struct IdentifyRow<'a> {
    /// The file as it was given; `<stdin>` for the standard input.
    file: &'a str,
    /// The usual name of the format.
    name: &'static str,
    /// Whether it is a file of classic CANopen, readable or not.
    is_canopen: bool,
    #[serde(flatten)]
    found: &'a Identification,
    /// What to do with a non-CANopen file.
    #[serde(skip_serializing_if = "Option::is_none")]
    advice: Option<&'static str>,
}

pub(super) fn run(args: &IdentifyArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut outcome = Outcome::Clean;
    let mut rows = 0;
    if args.format == AnswerFormat::Json {
        write!(out, "{{\"version\":{VERSION},\"files\":[")?;
    }
    for path in &args.files {
        let found = match args.size.read(path) {
            Ok(bytes) => identify(&source_name(path), &bytes),
            Err(failure) => {
                failure.print();
                outcome = Outcome::Failed;
                continue;
            }
        };
        if !found.kind.is_canopen() && outcome == Outcome::Clean {
            outcome = Outcome::Findings;
        }
        match args.format {
            AnswerFormat::Text => text(path, &found, out)?,
            AnswerFormat::Json => {
                out.write_all(if rows == 0 { b"\n" } else { b",\n" })?;
                write_row(path, &found, out)?;
            }
        }
        rows += 1;
    }
    if args.format == AnswerFormat::Json {
        writeln!(out, "{}]}}", if rows == 0 { "" } else { "\n" })?;
    }
    Ok(outcome)
}

fn text(path: &Path, found: &Identification, out: &mut Output) -> Result<(), Failure> {
    writeln!(out, "{}: {}", name_of(path), one_line(&found.to_string()))?;
    if let Some(advice) = found.advice().filter(|_| !found.kind.is_canopen()) {
        writeln!(out, "  help: {advice}")?;
    }
    Ok(())
}

fn write_row(path: &Path, found: &Identification, out: &mut Output) -> Result<(), Failure> {
    let file = source_name(path);
    let is_canopen = found.kind.is_canopen();
    let advice = found.advice().filter(|_| !is_canopen);
    let row = IdentifyRow { file: &file, found, name: found.kind.name(), is_canopen, advice };
    json::write(&mut out.raw()?, &row)?;
    Ok(())
}

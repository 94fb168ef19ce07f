//! The lock of a network: what `network build` keeps from build to build, and what the other commands read.

use std::path::Path;

use super::ending::{Failure, note};
use super::input::name_of;
use super::written_files::save_in_place;
use objdict_model::diagnostic::{At, Findings, Severity, plural};
use objdict_model::source::{SourceFile, SourceOptions, Span};
use objdict_network::NetworkLock;
use objdict_network_file::{read_lock, write_lock};

/// The PDOs that a lock has.
///
/// # Errors
/// When it cannot be read as one: a PDO that is passed over would move.
pub(crate) fn read(path: &Path) -> Result<NetworkLock, Failure> {
    let source = SourceFile::open(path, &SourceOptions::default()).map_err(Failure::new)?;
    let mut findings = Findings::new();
    let lock = read_lock(source.text(), &mut findings);
    let errors: Vec<String> = findings
        .iter()
        .filter(|finding| finding.severity == Severity::Error)
        .map(|finding| finding.line(&source, span_of))
        .collect();
    if errors.is_empty() {
        return Ok(lock);
    }
    let message = format!("`{}` is not a valid lock\n{}", name_of(path), errors.join("\n"));
    let help = "restore it, or remove it to assign all CAN-IDs and PDOs again";
    Err(Failure::of_lines(message.lines()).help(help))
}

/// Where the text of a lock has what a finding is about.
fn span_of(at: &At) -> Span {
    match at {
        At::Span(span) => *span,
        _ => Span::default(),
    }
}

/// Writes a lock, and reports what it does not keep; `old` is `None` for a new one.
pub(crate) fn update(path: &Path, old: Option<&NetworkLock>, new: &NetworkLock) -> Result<(), Failure> {
    let name = name_of(path);
    match old {
        Some(old) => old.changes(new).iter().for_each(|change| note(&format!("note: `{name}`: {change}\n"))),
        None => note(&format!("note: `{name}` keeps {}\n", plural(new.0.len(), "PDO"))),
    }
    if old != Some(new) {
        save_in_place(path, write_lock(new).as_bytes())?;
    }
    Ok(())
}

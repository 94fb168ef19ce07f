//! Changes as lines for readers.

use std::io::{self, Write};

use super::side::ComparedSide;
use super::{ComparedDescriptions, address};
use crate::stdout::Output;
use objdict_lint::changes::{Audience, ChangeVerdict, DeviceChange};
use objdict_model::model::Place;

pub(super) fn write(comparison: &ComparedDescriptions, out: &mut Output) -> io::Result<()> {
    for same in comparison.changes.chunk_by(is_of_next_entry) {
        write_changes(comparison, same, out)?;
    }
    out.summary(comparison.summary())
}

/// Whether the second change is the same of the next sub-index.
fn is_of_next_entry(first: &DeviceChange, second: &DeviceChange) -> bool {
    let next = first.sub.and_then(|sub| sub.checked_add(1));
    (first.index, next.is_some(), next) == (second.index, true, second.sub)
        && (first.rule.info.id, first.verdict()) == (second.rule.info.id, second.verdict())
        && first.message.shown() == second.message.shown()
}

/// Writes changes that differ in the sub-index alone; the places are those of the first.
fn write_changes(
    comparison: &ComparedDescriptions,
    same: &[DeviceChange],
    out: &mut Output,
) -> io::Result<()> {
    let [change, rest @ ..] = same else { return Ok(()) };
    let verdict = change.verdict();
    let rule = change.rule.info.id;
    let message = change.message.shown();
    let mut address = address(change);
    if let Some(sub) = rest.last().and_then(|last| last.sub) {
        address += &format!("-{sub:02X}");
    }
    writeln!(out, "{:<10}  {address:<9}  {message} [{rule}]", verdict.name())?;
    let places = [(&comparison.old, &change.old_place), (&comparison.new, &change.new_place)];
    let places = places.into_iter().filter_map(|(side, place)| at(side, place.as_ref()?));
    let places: Vec<String> = places.collect();
    if !places.is_empty() {
        writeln!(out, "{:>12}{}", "", places.join(" → "))?;
    }
    if verdict > ChangeVerdict::Compatible {
        let audiences: Vec<&str> = change.audiences(verdict).map(Audience::title).collect();
        writeln!(out, "{:>12}{verdict} for {}", "", audiences.join(", "))?;
    }
    Ok(())
}

/// A place as `file:line:column`.
fn at(side: &ComparedSide, place: &Place) -> Option<String> {
    let at = side.locate(place)?;
    Some(format!("{}:{}:{}", side.name(), at.line, at.column))
}

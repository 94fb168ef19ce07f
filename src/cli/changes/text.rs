//! Changes as lines for readers.

use std::io::{self, Write};

use super::side::Side;
use super::{Comparison, address};
use crate::cli::output::Output;
use crate::lint::changes::{Audience, ChangeVerdict, DeviceChange};
use crate::model::Place;

pub(super) fn write(comparison: &Comparison, out: &mut Output) -> io::Result<()> {
    for change in &comparison.changes {
        write_change(comparison, change, out)?;
    }
    out.summary(comparison.summary())
}

fn write_change(comparison: &Comparison, change: &DeviceChange, out: &mut Output) -> io::Result<()> {
    let verdict = change.verdict();
    let rule = change.rule.info.id;
    let (address, message) = (address(change), change.message.shown());
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
fn at(side: &Side, place: &Place) -> Option<String> {
    let at = side.locate(place)?;
    Some(format!("{}:{}:{}", side.name(), at.line, at.column))
}

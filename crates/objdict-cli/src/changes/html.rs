//! Changes as a page.

use std::io::{self, Write};

use super::{ComparedDescriptions, ComparedSide, address};
use crate::stdout::Output;
use objdict_document::{ChangeEffect, ChangeRow, ChangedDevice, ChangesPage};
use objdict_lint::changes::{Audience, ChangeImpact, ChangeVerdict, DeviceChange};
use objdict_model::model::{Device, PdoKind, Place};

pub(super) fn write(
    comparison: &ComparedDescriptions,
    devices: [&Device; 2],
    out: &mut Output,
) -> io::Result<()> {
    let expanded = devices.map(Device::with_implicit_pdos);
    let names = [comparison.old.name(), comparison.new.name()];
    let page = ChangesPage {
        old: ChangedDevice { file: &names[0], device: &expanded[0] },
        new: ChangedDevice { file: &names[1], device: &expanded[1] },
        summary: comparison.summary(),
        verdicts: ChangeVerdict::ALL.into_iter().rev().map(ChangeVerdict::name).collect(),
        audiences: Audience::ALL.into_iter().map(|audience| (audience.name(), audience.title())).collect(),
        changes: comparison.changes.iter().map(|change| row(comparison, change)).collect(),
    };
    out.raw()?.write_all(page.html().as_bytes())
}

fn row(comparison: &ComparedDescriptions, change: &DeviceChange) -> ChangeRow {
    let effect = |effect: &ChangeImpact| ChangeEffect {
        audience: effect.audience.name(),
        title: effect.audience.title(),
        verdict: effect.verdict.name(),
        reason: effect.reason,
    };
    ChangeRow {
        verdict: change.verdict().name(),
        address: address(change),
        rule: change.rule.info.id,
        message: change.message.to_string(),
        old: change.old.clone().unwrap_or_default(),
        new: change.new.clone().unwrap_or_default(),
        places: [
            at(&comparison.old, change.old_place.as_ref()),
            at(&comparison.new, change.new_place.as_ref()),
        ],
        effects: change.effects().map(effect).collect(),
        pdo: pdo(change),
    }
}

fn at(side: &ComparedSide, place: Option<&Place>) -> String {
    let at = place.and_then(|place| side.locate(place));
    at.map_or_else(String::new, |at| format!("{}:{}", at.line, at.column))
}

/// The PDO of a change of a mapping, or of a PDO as a whole.
fn pdo(change: &DeviceChange) -> Option<(PdoKind, u16)> {
    let is_whole = change.sub.is_none() && change.rule.info.name().starts_with("pdo-");
    change.index.filter(|_| is_whole).and_then(PdoKind::of_communication)
}

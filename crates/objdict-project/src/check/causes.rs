//! The patches that caused findings.

use objdict_format::Description;
use objdict_model::diagnostic::{At, Findings};

/// Adds the places in patches that caused the findings.
pub(super) fn named(description: &Description, findings: Findings) -> Findings {
    let Some(patched) = description.patched() else { return findings };
    findings.filter_map(|finding| {
        let cause = finding.labels.iter().find_map(|label| match &label.at {
            At::Place(place) => patched.cause_of(place),
            _ => None,
        });
        Some(match cause {
            Some((patch, span)) => finding.label(At::Patch(patch, span), "changed by this patch"),
            None => finding,
        })
    })
}

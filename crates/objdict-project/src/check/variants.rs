//! The findings of a device's variants, each of which is checked like a file.

use objdict_format::Description;
use objdict_model::diagnostic::{Diagnostic, Findings, Text, say};

/// Adds the name of the variant to findings and, for content of the extended file, the name of that file.
pub(super) fn named(description: &Description, findings: Findings) -> Findings {
    let (variant, extended) = (description.variant(), description.extended());
    if variant.is_none() && extended.is_none() {
        return findings;
    }
    findings.filter_map(|finding| {
        let at = finding.labels.first().map(|label| description.span_of(&label.at));
        let mut message = finding.message.clone();
        if let Some((name, _)) = extended.filter(|(_, span)| at == Some(*span)) {
            message = message.followed_by(&say!(" (in `{}`)", name));
        }
        if let Some(variant) = variant {
            message = message.followed_by(&suffix(variant));
        }
        Some(Diagnostic { message, ..finding })
    })
}

/// The findings of each device of a file; for a variant, those that the base device does not have.
pub fn of_devices(description: &Description, examine: impl Fn(&Description) -> Findings) -> Vec<Findings> {
    let mut of_base = None;
    description.map_devices(|device| match (device.variant(), &of_base) {
        (Some(variant), Some(base)) => without_those_of_base(variant, base, examine(device)),
        _ => of_base.insert(examine(device)).clone(),
    })
}

/// The findings of a variant without those of the base device.
fn without_those_of_base(name: &str, base: &Findings, findings: Findings) -> Findings {
    findings.filter_map(|finding| {
        let at = |finding: &Diagnostic| finding.labels.first().map(|label| label.at.clone());
        let is_it = |of_base: &Diagnostic| {
            let message = || of_base.message.clone().followed_by(&suffix(name));
            of_base.rule.id == finding.rule.id
                && at(of_base) == at(&finding)
                && message().shown() == finding.message.shown()
        };
        (!base.iter().any(is_it)).then_some(finding)
    })
}

fn suffix(name: &str) -> Text {
    say!(" (variant `{}`)", name)
}

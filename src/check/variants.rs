//! Findings of the variants of a device, each of which is checked like a file.

use crate::diagnostic::{Diagnostic, Findings, Text, say};
use crate::format::Description;

/// The findings of a variant with its name.
pub(super) fn named(description: &Description, findings: Findings) -> Findings {
    let Some(name) = description.variant() else { return findings };
    findings.filter_map(|finding| {
        let message = finding.message.clone().followed_by(&suffix(name));
        Some(Diagnostic { message, ..finding })
    })
}

/// The findings of the variant of a name without those that the file has without it.
pub(crate) fn without_those_of_base(name: &str, base: &Findings, findings: Findings) -> Findings {
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

//! Descriptions as tools read them.

use super::REACTIONS;
use objdict_format::Description;
use objdict_lint::Options;
use objdict_model::diagnostic::{Applicability, Tool};

/// Applies the safe fixes for content that these tools reject, misread or drop.
pub fn adapt(description: Description, tools: &[Tool]) -> Description {
    let options = Options { tools: tools.to_vec(), ..Options::default() };
    let concerns = |rule: &str| {
        REACTIONS.iter().any(|row| row.rule == rule && row.tools.iter().any(|tool| tools.contains(tool)))
    };
    let check = |description: &Description| {
        let findings = crate::check_with(description, &options);
        findings.filter_map(|finding| concerns(finding.rule.id).then_some(finding))
    };
    crate::fix(description, Applicability::Safe, check).description
}

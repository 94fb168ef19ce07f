//! The spellings that CiA 306 allows and a reader rejects, so that fixing them helps only in some tools.

use super::{Effect, REACTIONS, Reaction, reactions};
use objdict_format::Description;
use objdict_lint::{Options, Severities};
use objdict_model::diagnostic::{Applicability, Change, Findings, Fix, Tool};
use objdict_model::source::Encoding;

/// Spellings that CiA 306 allows and python-canopen rejects, with fixes that change neither the device nor
/// the result in other tools.
const REFUSED_SPELLINGS: [&str; 7] = [
    "portability/domain-without-type",
    "portability/dummy-usage",
    "portability/empty-key",
    "portability/hex-baud-rate",
    "portability/hex-count",
    "portability/hex-flag",
    "portability/key-case",
];

/// The findings of a check without tools, for fixing: including spellings that a reader rejects.
pub fn with_refused_spellings(
    description: &Description,
    safety: Applicability,
    findings: Findings,
    severities: &Severities,
) -> Findings {
    const READER: Tool = Tool::PythonCanopen;
    let is_of_one_byte = reactions::is_of_one_byte(description);
    let mut findings = findings.filter_map(|mut finding| {
        // the readers treat every text as UTF-8; a UTF-8 text only has a fix that changes its content
        if finding.rule.id == "cia306/not-ascii" && safety == Applicability::Safe {
            let fix = Fix::safe("save the file as UTF-8").with(Change::Encode(Encoding::Utf8));
            finding.fix = Some(fix);
            return is_of_one_byte.then_some(finding);
        }
        Some(finding)
    });
    let device = description.device();
    let mut spellings = description.portability_findings(device);
    let options = Options { tools: vec![READER], ..Options::default() };
    spellings.append(objdict_lint::check(device, &options));
    findings.append(severities.apply(spellings).filter_map(|finding| {
        let refuses = |reaction: &Reaction| {
            reaction.rule == finding.rule.id
                && reaction.effect == Effect::Refused
                && reaction.tools.contains(&READER)
                && reaction.when.is_none_or(|when| (when.holds)(description, &finding))
        };
        let is_refused = REFUSED_SPELLINGS.contains(&finding.rule.id) && REACTIONS.iter().any(refuses);
        is_refused.then_some(finding)
    }));
    findings
}

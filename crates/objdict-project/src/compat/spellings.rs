//! The spellings that CiA 306 allows and a reader refuses, so that fixing repairs them for no certain tool.

use super::{Effect, REACTIONS, Reaction, reactions};
use objdict_format::Description;
use objdict_lint::{Options, Severities};
use objdict_model::diagnostic::{Applicability, Change, Findings, Fix, Tool};
use objdict_model::source::Encoding;

/// What CiA 306 allows and python-canopen refuses, with fixes that change neither the device nor what other tools read.
const REFUSED_SPELLINGS: [&str; 7] = [
    "portability/domain-without-type",
    "portability/dummy-usage",
    "portability/empty-key",
    "portability/hex-baud-rate",
    "portability/hex-count",
    "portability/hex-flag",
    "portability/key-case",
];

/// The findings of a check without tools, as fixes need them: with the spellings that a reader refuses.
pub fn with_refused_spellings(
    description: &Description,
    safety: Applicability,
    findings: Findings,
    severities: &Severities,
) -> Findings {
    const READER: Tool = Tool::PythonCanopen;
    let is_of_one_byte = reactions::is_of_one_byte(description);
    let mut findings = findings.filter_map(|mut finding| {
        // the readers take every text for UTF-8; what is UTF-8 has only a fix that changes the text
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

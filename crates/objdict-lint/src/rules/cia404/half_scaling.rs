use crate::demands::{Applied, is_there};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, series};
use crate::model::Place;
use crate::{Facts, rule};

rule! {
    "cia404/half-scaling", Warning, Applied(check);
    summary: "the scaling of a channel is described by half",
    checks: "Whether the four objects that scale a field value to a process value by two points come together: x120h to x123h of analogue inputs, x320h to x323h of analogue outputs.",
    why: "A line needs two points of two numbers each: with less nobody can change the scale.",
    example: "`[7120]`, `[7121]` and `[7122]`, and no `[7123]`",
    remedy: "Describe the missing object.",
    source: "CiA 404-1, analogue inputs and analogue outputs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, _: &Applied<'_>, findings: &mut Findings) {
    let families = [0x6000, 0x7000, 0x8000, 0x9000];
    for first in families.iter().flat_map(|family| [family + 0x120, family + 0x320]) {
        let is_described = |index: &u16| is_there(facts.device, *index);
        let Some(there) = (first..=first + 3).find(is_described) else { continue };
        let missing = (first..=first + 3).filter(|index| !is_described(index));
        let missing: Vec<String> = missing.map(|index| format!("{index:04X}h")).collect();
        if missing.is_empty() {
            continue;
        }
        let verb = if missing.len() == 1 { "is not" } else { "are not" };
        let message =
            say!("{:04X}h is there, and {} {}, which belong together", there, series(&missing), verb);
        let finding = Diagnostic::new(rule, Place::object(there), message);
        findings.push(finding.help("describe what is missing"));
    }
}

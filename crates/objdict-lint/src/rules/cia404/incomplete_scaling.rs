use crate::demands::{Applied, is_there};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, series};
use crate::model::Place;
use crate::{Facts, rule};

rule! {
    "cia404/incomplete-scaling", Warning, Applied(check);
    summary: "the scaling of a channel is incomplete",
    checks: "Whether the four objects that scale a field value to a process value by two points are all described: x120h to x123h for analogue inputs, x320h to x323h for analogue outputs.",
    why: "A linear scaling needs two points of two numbers each. If one is missing, the scaling cannot be changed.",
    example: "`[7120]`, `[7121]` and `[7122]` without `[7123]`",
    remedy: "Describe the missing objects.",
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
        let message = say!("{:04X}h needs {} for a complete scaling", there, series(&missing));
        let finding = Diagnostic::new(rule, Place::object(there), message);
        findings.push(finding.help("describe the missing objects"));
    }
}

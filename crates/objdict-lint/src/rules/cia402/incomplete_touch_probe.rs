use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text, say, series};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/incomplete-touch-probe", Warning, Applied(check);
    summary: "the description of a touch probe is incomplete",
    checks: "Whether 60B8h (touch probe function) and 60B9h (touch probe status) are both described if one of them or 60BAh to 60BDh (positions of touch probes) is.",
    why: "Without the function the probe cannot be enabled; without the status a master does not know whether the position was sampled.",
    example: "`[60B8]` and `[60BA]` without `[60B9]`",
    remedy: "Describe the missing object.",
    source: "CiA 402-2, touch probe",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(there) = (0x60B8..=0x60BD).find(|&index| drive.has(index)) else { return };
    let missing = [(0x60B8, "touch probe function"), (0x60B9, "touch probe status")];
    let missing = missing.into_iter().filter(|&(index, _)| drive.lacks(index));
    let missing: Vec<Text> = missing.map(|(index, name)| say!("{} ({})", drive.name(index), name)).collect();
    if missing.is_empty() {
        return;
    }
    let message = say!("{} is described without {}", drive.name(there), series(&missing));
    findings.push(Diagnostic::new(rule, drive.place(there), message).help("describe the missing objects"));
}

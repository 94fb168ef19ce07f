use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text, say, series};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/half-touch-probe", Warning, Applied(check);
    summary: "a touch probe is described by half",
    checks: "Whether 60B8h (touch probe function) and 60B9h (touch probe status) come together, and whether they are there when 60BAh to 60BDh (positions of touch probes) are.",
    why: "Without the function nobody can switch the probe on; without the status nobody knows whether the position is one that was sampled.",
    example: "`[60B8]` and `[60BA]`, and no `[60B9]`",
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
    let verb = if missing.len() == 1 { "is not" } else { "are not" };
    let message = say!("{} is there, and {} {}", drive.name(there), series(&missing), verb);
    findings.push(Diagnostic::new(rule, drive.place(there), message).help("describe what is missing"));
}

use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/target-outside-limits", Warning, Applied(check);
    summary: "a target position is outside the software limits",
    checks: "Whether the configured or default value of 607Ah (target position) is within 607Dh (software position limit), if its lower limit is below the upper one.",
    why: "The axis stops at the limit with a warning or an error after the first set-point.",
    example: "`DefaultValue=5000` in `[607A]`, `DefaultValue=1000` in `[607Dsub2]`",
    remedy: "Correct the target or the limits.",
    source: "CiA 402-2, target position and software position limit",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let (Some(min), Some(max)) = (drive.value(0x607D, 1), drive.value(0x607D, 2)) else { return };
    let Some(target) = drive.value(0x607A, 0) else { return };
    if min >= max || (min..=max).contains(&target) {
        return;
    }
    let sub = if target < min { 1 } else { 2 };
    let message = say!(
        "the target position `{}` is outside the software limits {} to {} of {}",
        target,
        min,
        max,
        drive.name(0x607D)
    );
    let finding = Diagnostic::new(rule, drive.value_place(0x607A, 0), message);
    let finding = finding.label(drive.value_place(0x607D, sub), "the limit");
    findings.push(finding.help("correct the target or the limits"));
}

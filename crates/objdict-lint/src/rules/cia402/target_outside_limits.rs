use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/target-outside-limits", Warning, Applied(check);
    summary: "a target position is outside the limits of the axis",
    checks: "Whether the configured or default value of 607Ah (target position) is within 607Dh (software position limit) and 607Bh (position range limit), if the lower limit is below the upper one.",
    why: "The axis stops at the limit, or rejects the first set-point.",
    example: "`DefaultValue=5000` in `[607A]`, `DefaultValue=1000` in `[607Dsub2]`",
    remedy: "Correct the target or the limits.",
    source: "CiA 402-2, target position and software position limit",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(target) = drive.value(0x607A, 0) else { return };
    for (index, name) in [(0x607D, "software limits"), (0x607B, "position range")] {
        let (Some(min), Some(max)) = (drive.value(index, 1), drive.value(index, 2)) else { continue };
        if min >= max || (min..=max).contains(&target) {
            continue;
        }
        let sub = if target < min { 1 } else { 2 };
        let message = say!(
            "the target position `{}` is outside the {} {} to {} of {}",
            target,
            name,
            min,
            max,
            drive.name(index)
        );
        let finding = Diagnostic::new(rule, drive.value_place(0x607A, 0), message);
        let finding = finding.label(drive.value_place(index, sub), "the limit");
        findings.push(finding.help("correct the target or the limits"));
        return;
    }
}

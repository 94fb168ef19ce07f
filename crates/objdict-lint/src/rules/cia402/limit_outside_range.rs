use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/limit-outside-range", Warning, Applied(check);
    summary: "a software limit is outside the position range",
    checks: "Whether the limits of 607Dh (software position limit) are within 607Bh (position range limit), if both have a lower limit below the upper one.",
    why: "Positions wrap at the end of the range before they reach the limit, so the limit never stops the axis.",
    example: "`DefaultValue=100000` in `[607Dsub2]`, `DefaultValue=36000` in `[607Bsub2]`",
    remedy: "Move the software limit into the range, or widen the range.",
    source: "CiA 402-2, position range limit and software position limit",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let limits =
        |index| Some((drive.value(index, 1)?, drive.value(index, 2)?)).filter(|(min, max)| min < max);
    let (Some((first, last)), Some((min, max))) = (limits(0x607B), limits(0x607D)) else { return };
    let outside = if !(first..=last).contains(&max) {
        (2, max)
    } else if min < first {
        (1, min)
    } else {
        return;
    };
    let (sub, limit) = outside;
    let message = say!(
        "the limit `{}` of {} is outside the range {} to {} of {}",
        limit,
        drive.name(0x607D),
        first,
        last,
        drive.name(0x607B)
    );
    let finding = Diagnostic::new(rule, drive.value_place(0x607D, sub), message);
    let finding = finding.label(drive.value_place(0x607B, sub), "the position range");
    findings.push(finding.help("move the limit into the range or widen the range"));
}

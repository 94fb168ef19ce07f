use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/limit-min-above-max", Error, Applied(check);
    summary: "the lower limit of a drive is above the upper limit",
    checks: "Whether sub-index 1 of 607Bh (position range limit), 607Dh (software position limit) and 6046h (vl velocity min max amount) is not greater than sub-index 2, configured or default.",
    why: "No position is between the limits: depending on the vendor, the drive rejects every target or treats the limits as disabled.",
    example: "`DefaultValue=1000` in `[607Dsub1]`, `DefaultValue=-1000` in `[607Dsub2]`",
    remedy: "Swap the values. Two equal values, mostly 0, are not reported: many drives disable the limits this way.",
    source: "CiA 402-2, IEC 61800-7-201",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for index in [0x607B, 0x607D, 0x6046] {
        let (Some(min), Some(max)) = (drive.value(index, 1), drive.value(index, 2)) else { continue };
        if min <= max {
            continue;
        }
        let message =
            say!("the lower limit `{}` of {} is above the upper limit `{}`", min, drive.name(index), max);
        let finding = Diagnostic::new(rule, drive.value_place(index, 1), message);
        let finding = finding.label(drive.value_place(index, 2), "the upper limit");
        findings.push(finding.help("swap the values"));
    }
}

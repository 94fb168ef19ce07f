use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Severity, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/limit-min-above-max", Error, Applied(check);
    summary: "no position or speed is between the limits of a drive",
    checks: "Whether sub-index 1 of 607Bh (position range limit), 607Dh (software position limit) and 6046h (vl velocity min max amount) is not greater than sub-index 2, configured or default. Two equal positions other than 0 are a warning.",
    why: "No position is between the limits: depending on the vendor, the drive rejects every target or treats the limits as disabled.",
    example: "`DefaultValue=1000` in `[607Dsub1]`, `DefaultValue=-1000` in `[607Dsub2]`",
    remedy: "Swap the values, or write the limits of the machine. If both limits are 0, many drives disable them, so they are not reported.",
    source: "CiA 402-2, IEC 61800-7-201",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for index in [0x607B, 0x607D, 0x6046] {
        let (Some(min), Some(max)) = (drive.value(index, 1), drive.value(index, 2)) else { continue };
        // a speed may be fixed, and two limits of 0 are mostly disabled
        let is_one_position = min == max && min != 0 && index != 0x6046;
        let (message, help, severity) = if min > max {
            let message =
                say!("the lower limit `{}` of {} is above the upper limit `{}`", min, drive.name(index), max);
            (message, "swap the values", Severity::Error)
        } else if is_one_position {
            let message = say!("both limits of {} are `{}`: no movement is possible", drive.name(index), min);
            (message, "write the limits of the machine, or 0 to both", Severity::Warning)
        } else {
            continue;
        };
        let finding = Diagnostic::new(rule, drive.value_place(index, 1), message).severity(severity);
        findings.push(finding.label(drive.value_place(index, 2), "the upper limit").help(help));
    }
}

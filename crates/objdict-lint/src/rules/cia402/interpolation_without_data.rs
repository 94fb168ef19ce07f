use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/interpolation-without-data", Warning, Applied(check);
    summary: "interpolation is described without its data record",
    checks: "Whether a drive with 60C0h (interpolation sub mode select) or 60C4h (interpolation data configuration) has 60C1h (interpolation data record).",
    why: "Set-points of interpolated position mode are written to 60C1h. Sub mode and buffer are useless without it.",
    example: "`[60C0]` and `[60C4]` without `[60C1]`",
    remedy: "Describe 60C1h (ARRAY of INTEGER32), or remove the other objects.",
    source: "CiA 402-2, interpolated position mode",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(there) = [0x60C0, 0x60C4].into_iter().find(|&index| drive.has(index)) else { return };
    if drive.lacks(0x60C1) {
        let (there_name, missing) = (drive.name(there), drive.name(0x60C1));
        let message = say!("{} is described without {} (interpolation data record)", there_name, missing);
        let finding = Diagnostic::new(rule, drive.place(there), message);
        findings.push(finding.help(say!("describe {} (ARRAY of INTEGER32)", missing)));
    }
}

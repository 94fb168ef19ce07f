use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/value-beyond-support", Warning, Applied(check);
    summary: "a value exceeds what another sub-index of the object supports",
    checks: "Whether the actual buffer size of 60C4h (sub-index 2) is at most the maximum (sub-index 1), whether 60A4h has as many jerks as 60A3h says, and whether each digital output that 60FEh switches on (sub-index 1) is enabled in the bit mask (sub-index 2).",
    why: "The drive rejects the size of the buffer or has no value for a jerk; an output that the mask does not enable stays off.",
    example: "`DefaultValue=0x00010000` in `[60FEsub1]`, and `DefaultValue=0` in `[60FEsub2]`",
    remedy: "Correct one of the two values.",
    source: "CiA 402-2, interpolation data configuration, profile jerk and digital outputs",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let values = |index| Some((drive.value(index, 1)?, drive.value(index, 2)?));
    if let Some((maximum, actual)) = values(0x60C4).filter(|(maximum, actual)| actual > maximum) {
        let message = say!("the buffer size `{}` is above the maximum `{}`", actual, maximum);
        let finding = Diagnostic::new(rule, drive.value_place(0x60C4, 2), message);
        let finding = finding.label(drive.value_place(0x60C4, 1), "the maximum");
        findings.push(finding.help("lower the buffer size"));
    }
    let jerks = drive.object(0x60A4).and_then(crate::model::Object::highest_sub);
    if let (Some(used), Some(jerks)) = (drive.value(0x60A3, 0), jerks)
        && used > jerks.into()
    {
        let message = say!("the profile uses {} jerks, but {} has {}", used, drive.name(0x60A4), jerks);
        let finding = Diagnostic::new(rule, drive.value_place(0x60A3, 0), message);
        let finding = finding.label(drive.value_place(0x60A4, 0), "the number of jerks");
        findings.push(finding.help("describe the jerks, or use fewer"));
    }
    if let Some((outputs, mask)) = values(0x60FE).filter(|(outputs, mask)| outputs & !mask != 0) {
        let message = say!(
            "{} switches on outputs (`0x{:08X}`) that the bit mask `0x{:08X}` does not enable",
            drive.name(0x60FE),
            outputs & !mask,
            mask
        );
        let finding = Diagnostic::new(rule, drive.value_place(0x60FE, 1), message);
        let finding = finding.label(drive.value_place(0x60FE, 2), "the bit mask");
        findings.push(finding.help("enable the outputs in the bit mask, or switch them off"));
    }
}

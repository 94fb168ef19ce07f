use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/axis-without-device-type", Note, Applied(check);
    summary: "a further axis has no device type",
    checks: "Whether each axis after the first, 800h indexes apart, has a device type at the end of its range: 6FFFh, 77FFh and so on.",
    why: "1000h states the type of the first axis, these objects that of the others: without it a master does not detect the axis or its kind.",
    example: "`[6840]` and `[6841]` without `[6FFF]`",
    remedy: "Describe the device type of the axis (UNSIGNED32, `ro`).",
    source: "CiA 301 §7.5.2.1; CiA 402-3, single device type",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let is_axis = applied.block > 0 && drive.has(0x6040);
    if is_axis && drive.lacks(0x67FF) {
        let (axis, name) = (applied.block + 1, drive.name(0x67FF));
        let message = say!("axis {} has no device type: {} is missing", axis, name);
        let finding = Diagnostic::new(rule, drive.place(0x6040), message);
        findings.push(finding.help(say!("describe {} (UNSIGNED32, `ro`)", name)));
    }
}

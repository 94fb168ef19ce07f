use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    /// a further axis has no device type
    ///
    /// ## What it checks
    /// Whether each axis but the first, 800h indexes apart, has the device type at its end: 6FFFh, 77FFh and so on.
    ///
    /// ## Why it matters
    /// The first axis has its type in 1000h, the others there: a master that does not find it does not know that there is an axis, or of what kind.
    ///
    /// ## Example
    /// `[6840]` and `[6841]`, and no `[6FFF]`
    ///
    /// ## How to mend
    /// Describe the device type of the axis (UNSIGNED32, `ro`).
    ///
    /// ## Source
    /// CiA 301 §7.5.2.1; CiA 402-3, single device type
    "cia402/axis-without-device-type", Note, Applied(check)
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let is_axis = applied.block > 0 && drive.has(0x6040);
    if is_axis && drive.lacks(0x67FF) {
        let (axis, name) = (applied.block + 1, drive.name(0x67FF));
        let message = say!("axis {} has no device type, {} is missing", axis, name);
        let finding = Diagnostic::new(rule, drive.place(0x6040), message);
        findings.push(finding.help(say!("describe {} (UNSIGNED32, `ro`)", name)));
    }
}

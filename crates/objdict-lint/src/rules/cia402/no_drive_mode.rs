use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/no-drive-mode", Warning, Applied(check);
    summary: "6502h states no mode",
    checks: "Whether at least one bit of 6502h (supported drive modes) is set, manufacturer-specific bits included.",
    why: "A master finds no mode that it can use.",
    example: "`DefaultValue=0` in `[6502]`",
    remedy: "Set the bits of the modes that the drive has.",
    source: "CiA 402-2, supported drive modes",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    if drive.modes() == Some(0) {
        let message = say!("{} states no mode of operation", drive.name(0x6502));
        let finding = Diagnostic::new(rule, drive.value_place(0x6502, 0), message);
        findings.push(
            finding.help("set the bits of the modes, such as `0x00000021` for profile position and homing"),
        );
    }
}

use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, MODES, rule};

rule! {
    "cia402/unsupported-mode", Warning, Applied(check);
    summary: "a drive starts in a mode that it does not support",
    checks: "Whether 6502h has the bit of the mode that is the configured or default value of 6060h or 6061h. Manufacturer-specific modes (below 0) and 0 (no mode) are not checked.",
    why: "One of the two is wrong: a master that relies on 6502h never uses the mode, one that relies on 6060h sends targets that the drive rejects.",
    example: "`DefaultValue=8` in `[6060]`, and `DefaultValue=0x00000005` in `[6502]`",
    remedy: "Correct the mode, or set its bit in 6502h.",
    source: "CiA 402-2, modes of operation and supported drive modes",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    for index in [0x6060, 0x6061] {
        let Some(number) = drive.value(index, 0) else { continue };
        let Some(mode) = MODES.iter().find(|mode| mode.number == number) else { continue };
        if drive.supports(mode.bit) != Some(false) {
            continue;
        }
        let (name, modes) = (drive.name(index), drive.name(0x6502));
        let message = say!(
            "{} is `{}` ({}), but {} does not have bit {} set",
            name,
            number,
            mode.name,
            modes,
            mode.bit
        );
        let finding = Diagnostic::new(rule, drive.value_place(index, 0), message);
        let finding = finding.label(drive.value_place(0x6502, 0), "the supported drive modes");
        findings.push(finding.help("correct the mode or set the bit"));
    }
}

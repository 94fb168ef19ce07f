use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, MODES, rule};

rule! {
    "cia402/mode-without-display", Warning, Applied(check);
    summary: "only one of modes of operation and modes of operation display is described",
    checks: "Whether 6060h (modes of operation) and 6061h (modes of operation display) are both described. `cia402/no-mode-selection` reports a drive with several modes and without 6060h.",
    why: "A drive may change its mode with a delay: a master waits until 6061h shows the mode before it sends targets.",
    example: "`[6060]` without `[6061]`",
    remedy: "Describe the other object.",
    source: "CiA 402-2, modes of operation",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let (there, missing) = match (drive.has(0x6060), drive.has(0x6061)) {
        (true, false) => (0x6060, 0x6061),
        // with several modes the selection is missing, which another rule reports
        (false, true) if !has_several_modes(drive) => (0x6061, 0x6060),
        _ => return,
    };
    if drive.lacks(missing) {
        let name = |index| match index {
            0x6060 => "modes of operation",
            _ => "modes of operation display",
        };
        let message = say!(
            "{} ({}) is described without {} ({})",
            drive.name(there),
            name(there),
            drive.name(missing),
            name(missing)
        );
        let finding = Diagnostic::new(rule, drive.place(there), message);
        findings.push(finding.help(say!("describe {}", drive.name(missing))));
    }
}

fn has_several_modes(drive: Drive<'_>) -> bool {
    let modes = drive.modes().unwrap_or_default();
    MODES.iter().filter(|mode| modes >> mode.bit & 1 == 1).count() > 1
}

use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say, series};
use crate::{Drive, Facts, MODES, rule};

rule! {
    "cia402/no-mode-selection", Warning, Applied(check);
    summary: "a drive with several modes has no object to select one",
    checks: "Whether a drive whose 6502h states more than one mode of operation has 6060h.",
    why: "Without 6060h (modes of operation) a master cannot leave the start-up mode.",
    example: "`DefaultValue=0x00000005` in `[6502]`, and no `[6060]`",
    remedy: "Describe 6060h (INTEGER8, `rw`) and 6061h (INTEGER8, `ro`), or state only the mode that is always active.",
    source: "CiA 402-2, modes of operation and supported drive modes",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let modes = drive.modes().unwrap_or_default();
    let names = MODES.iter().filter(|mode| modes >> mode.bit & 1 == 1).map(|mode| mode.name);
    let names: Vec<&str> = names.collect();
    if names.len() < 2 || !drive.lacks(0x6060) {
        return;
    }
    let message = say!("{} is missing, so a master cannot select {}", drive.name(0x6060), series(names));
    let finding = Diagnostic::new(rule, drive.value_place(0x6502, 0), message);
    findings.push(finding.help("describe 6060h, the modes of operation (INTEGER8, `rw`)"));
}

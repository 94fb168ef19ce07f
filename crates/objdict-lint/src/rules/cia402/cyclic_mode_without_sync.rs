use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, MODES, rule};

rule! {
    "cia402/cyclic-mode-without-sync", Warning, Applied(check);
    summary: "a drive with cyclic modes has no SYNC",
    checks: "Whether a drive whose 6502h states a cyclic synchronous mode has 1005h, the COB-ID of SYNC.",
    why: "In these modes SYNC synchronizes the interpolation of drive and master. Without 1005h the drive does not know when a target takes effect.",
    example: "`DefaultValue=0x00000080` in `[6502]`, and no `[1005]`",
    remedy: "Add 1005h with the default 80h, or clear the bits of the modes in 6502h.",
    source: "CiA 402-2, cyclic synchronous modes; CiA 301 §7.5.2.5",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let cyclic =
        MODES.iter().find(|mode| (7..=10).contains(&mode.bit) && drive.supports(mode.bit) == Some(true));
    let Some(mode) = cyclic.filter(|_| applied.block == 0 && drive.lacks(0x1005)) else { return };
    let message = say!("{} mode is supported, but 1005h (COB-ID SYNC) is missing", mode.name);
    let finding = Diagnostic::new(rule, drive.value_place(0x6502, 0), message);
    findings.push(finding.help("add 1005h (COB-ID SYNC, UNSIGNED32, default 0x80)"));
}

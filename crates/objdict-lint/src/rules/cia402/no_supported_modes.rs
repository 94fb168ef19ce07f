use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/no-supported-modes", Warning, Applied(check);
    summary: "a drive does not state its modes",
    checks: "Whether a drive with the controlword 6040h has 6502h (supported drive modes).",
    why: "Masters read 6502h before they select a mode, and many do not use an axis without it. Version 2 made the object optional, since version 3 it is mandatory: more than a quarter of the real drives examined lack it, so it is a warning.",
    example: "`[6040]` without `[6502]`",
    remedy: "Describe 6502h (UNSIGNED32, `ro`) with the bits of the modes.",
    source: "CiA 402-2, supported drive modes",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    if drive.has(0x6040) && drive.lacks(0x6502) {
        let message = say!("{} (supported drive modes) is missing", drive.name(0x6502));
        let finding = Diagnostic::new(rule, drive.place(0x6040), message);
        findings.push(finding.help("describe 6502h (UNSIGNED32, `ro`) with the bits of the modes"));
    }
}

use crate::demands::Applied;
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, say};
use crate::{Drive, Facts, rule};

rule! {
    "cia402/enabled-by-default", Warning, Applied(check);
    summary: "the controlword of a drive is the command to move from the start",
    checks: "Whether 6040h, configured or default, is not `Enable operation`: bits 0 to 3 set and bit 7 not.",
    why: "The axis is powered as soon as its state allows it, before a master has checked anything: after a restart or a repaired fault, it may move.",
    example: "`DefaultValue=0x000F` in `[6040]`",
    remedy: "Write 0, and let the master command the states one after the other.",
    source: "CiA 402-2, controlword",
}

fn check(rule: &'static RuleInfo, facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let drive = Drive::new(facts, applied);
    let Some(command) = drive.value(0x6040, 0).filter(|command| command & 0x8F == 0x0F) else { return };
    let message = say!("the controlword `0x{:04X}` enables the operation at power-on", command);
    let finding = Diagnostic::new(rule, drive.value_place(0x6040, 0), message);
    findings.push(finding.help("write 0, and let the master enable the operation"));
}

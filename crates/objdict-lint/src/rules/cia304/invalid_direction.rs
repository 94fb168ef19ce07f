use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia304/invalid-direction", Error, Facts(check);
    summary: "an SRDO goes in no direction",
    checks: "Whether the information direction of each SRDO is 0 (switched off), 1 (sent) or 2 (received).",
    why: "The device refuses any other value, and nobody knows whether it is the one that sends.",
    example: "`[1301sub1]` with `DefaultValue=3`",
    remedy: "Write 0, 1 or 2.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(direction) = srdo.number(1).filter(|direction| !(0..=2).contains(direction)) else {
            continue;
        };
        let place = facts.device.value_place(srdo.communication_index(), 1);
        let message = say!("`{}` is no information direction of {}", direction, srdo);
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("write 0 for none, 1 for one that is sent or 2 for one that is received"));
    }
}

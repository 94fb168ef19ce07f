use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia304/invalid-direction", Error, Facts(check);
    summary: "the information direction of an SRDO is not valid",
    checks: "Whether the information direction of each SRDO is 0 (not valid), 1 (transmit) or 2 (receive).",
    why: "The device rejects any other value, and tools do not know whether it transmits the SRDO.",
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
        let message = say!("`{}` is not a valid information direction of {}", direction, srdo);
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("write 0 (not valid), 1 (transmit) or 2 (receive)"));
    }
}

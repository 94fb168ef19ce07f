use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Place;
use crate::{Facts, rule};

rule! {
    "cia304/checksum-missing", Error, Facts(check);
    summary: "13FFh has no checksum for an SRDO",
    checks: "Whether 13FFh has a sub-index for each SRDO of the device: sub-index 1 for 1301h, and so on.",
    why: "The configuration of an SRDO without a checksum can never become valid.",
    example: "`[1302]` and a 13FFh with one element",
    remedy: "Describe an element for each SRDO.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(object) =
        facts.device.object(0x13FF).filter(|object| !object.orphan && object.object_type().has_subs())
    else {
        return;
    };
    let number = |srdo: &crate::Srdo<'_>| u8::try_from(srdo.number).unwrap_or(u8::MAX);
    if let Some(srdo) = facts.srdos.iter().find(|srdo| !object.has(number(srdo))) {
        let message = say!("13FFh has no sub-index {} for the checksum of {}", srdo.number, srdo);
        let finding = Diagnostic::new(&RULE.info, Place::object(0x13FF), message);
        findings.push(finding.help("describe an element for each SRDO"));
    }
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::PdoKind;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/rtr-only-pdo", Note, Pdo(check);
    summary: "a TPDO is sent only on request",
    checks: "Whether a valid TPDO has transmission type 252 or 253, with which it waits for a remote frame. A TPDO that also forbids remote frames has its own rule.",
    why: "CiA advises against remote frames: controllers of different vendors answer them differently or not at all, and CAN FD has none.",
    example: "`[1800sub2]` with `DefaultValue=253`",
    remedy: "Use 254 or 255 with an event timer, or a synchronous type.",
    source: "CiA 301 §7.5.2.37, table 72; CiA 801",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(transmission_type @ (252 | 253)) = pdo.transmission_type else { return };
    let allows_rtr = pdo.cob_id.is_some_and(|cob_id| cob_id.is_valid() && !cob_id.bit_30());
    if pdo.kind != PdoKind::Tpdo || !allows_rtr {
        return;
    }
    let message = say!(
        "{} has transmission type `{}` and is sent only in response to remote frames",
        pdo,
        transmission_type
    );
    let place = facts.device.value_place(pdo.communication_index(), 2);
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("use 254 or 255 with an event timer, or a synchronous type"));
}

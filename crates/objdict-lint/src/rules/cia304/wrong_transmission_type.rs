use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::{Facts, rule};

rule! {
    "cia304/wrong-transmission-type", Error, Facts(check), fix Unsafe;
    summary: "the transmission type of an SRDO is not 254",
    checks: "Whether the transmission type of each SRDO is 254. The standard allows no other value.",
    why: "SRDOs are always sent cyclically, and their safety depends on their timing. SYNC or a remote frame must not trigger them.",
    example: "`[1301sub4]` with `DefaultValue=255`",
    remedy: "Write `0xFE` and `AccessType=const`.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(transmission_type) = srdo.number(4).filter(|&value| value != 254) else { continue };
        let place = facts.device.value_place(srdo.communication_index(), 4);
        let message = say!("the transmission type of {} is `{}`; it must be 254", srdo, transmission_type);
        let fix = Fix::risky("write `0xFE`").set(place.clone(), "0xFE");
        findings.push(Diagnostic::new(&RULE.info, place, message).help("write `0xFE`").fix(fix));
    }
}

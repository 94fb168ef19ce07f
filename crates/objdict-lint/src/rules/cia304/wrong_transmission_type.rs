use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::{Facts, rule};

rule! {
    "cia304/wrong-transmission-type", Error, Facts(check), fix Unsafe;
    summary: "an SRDO has another transmission type than 254",
    checks: "Whether the transmission type of each SRDO is 254. The standard knows no other one.",
    why: "SRDOs are sent cyclically whatever happens; that they come in time is what makes them safe. SYNC or a remote frame must not decide about it.",
    example: "`[1301sub4]` with `DefaultValue=255`",
    remedy: "Write `0xFE`, and `AccessType=const`.",
    source: "EN 50325-5 (CiA 304)",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(transmission_type) = srdo.number(4).filter(|&value| value != 254) else { continue };
        let place = facts.device.value_place(srdo.communication_index(), 4);
        let message = say!("`{}` as transmission type of {}, which is always 254", transmission_type, srdo);
        let fix = Fix::risky("write the transmission type of SRDOs").set(place.clone(), "0xFE");
        findings.push(Diagnostic::new(&RULE.info, place, message).help("write `0xFE`").fix(fix));
    }
}

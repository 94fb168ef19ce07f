use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::PdoKind;
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/reserved-transmission-type", Error, Pdo(check);
    summary: "a PDO has a reserved transmission type",
    checks: "Whether the transmission type of an RPDO is outside 241 to 253, and that of a TPDO outside 241 to 251.",
    why: "A device rejects the value. 252 and 253 mean transmission on request, which does not apply to an RPDO.",
    example: "`[1400sub2]` with `DefaultValue=253`",
    remedy: "Write 255 or 254 for event-driven, 1 to 240 for every n-th SYNC, 0 for acyclic with SYNC.",
    source: "CiA 301 §7.5.2.35 table 68, §7.5.2.37 table 72",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let highest = match pdo.kind {
        PdoKind::Rpdo => 253,
        PdoKind::Tpdo => 251,
    };
    let reserved =
        pdo.transmission_type.filter(|transmission_type| (241..=highest).contains(transmission_type));
    if let Some(transmission_type) = reserved {
        let message = say!("transmission type `{}` of {} is reserved", transmission_type, pdo);
        let place = facts.device.value_place(pdo.communication_index(), 2);
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("write 254 or 255 for event-driven, 0 to 240 for synchronous"));
    }
}

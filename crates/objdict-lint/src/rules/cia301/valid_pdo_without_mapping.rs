use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/valid-pdo-without-mapping", Warning, Pdo(check);
    summary: "a valid PDO maps no objects",
    checks: "Whether each PDO that maps 0 objects is not valid (bit 31 of its COB-ID set).",
    why: "A TPDO without objects sends empty frames, or the device rejects it; an RPDO occupies a CAN-ID without use.",
    example: "`[1801sub1]` with `DefaultValue=$NODEID+0x280`, and `[1A01sub0]` with `DefaultValue=0`",
    remedy: "Set bit 31 of the COB-ID, or map an object.",
    source: "CiA 301 §7.5.2.35 to §7.5.2.38",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    // another rule reports a restricted CAN-ID
    if pdo.cob_id().is_some_and(|cob_id| facts.is_restricted(&cob_id)) {
        return;
    }
    let Some(cob_id) = pdo.pdo.cob_id.filter(|cob_id| cob_id.is_valid() && cob_id.stray_bits() == 0) else {
        return;
    };
    if pdo.pdo.mapped_count != Some(0) {
        return;
    }
    let place = facts.device.value_place(pdo.pdo.communication_index(), 1);
    let message = say!("`{}` makes {} valid, but it maps no objects", cob_id, pdo.pdo);
    let finding = Diagnostic::new(&RULE.info, place, message);
    let finding =
        finding.label(facts.device.value_place(pdo.pdo.mapping_index(), 0), "no objects are mapped");
    findings.push(finding.help(say!("set bit 31: `{}`, or map an object", cob_id.disabled())));
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia301/short-can-id-in-extended-frame", Warning, Facts(check);
    summary: "a COB-ID is marked as 29 bits long but has only 11",
    checks: "Whether each active COB-ID with bit 29 set (extended frame) has more than 11 bits.",
    why: "Extended frames are rare, and a base frame with the same number is another identifier. Often bit 29 was set instead of bit 30 or 31.",
    example: "`[1800sub1]` with `DefaultValue=$NODEID+0x20000180`",
    remedy: "Clear bit 29.",
    source: "CiA 301 §7.5.2.5, §7.5.2.35, figures 53 to 71",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in facts.cob_ids.iter().filter(|cob_id| cob_id.cob_id.is_extended() && cob_id.is_in_use()) {
        if cob_id.cob_id.can_id(127) > 0x7FF || cob_id.wrong_bits() != 0 {
            continue;
        }
        let message = say!(
            "`{}` of {} is marked as a 29-bit identifier, but has only 11 bits",
            cob_id.cob_id,
            cob_id.service
        );
        let place = facts.device.value_place(cob_id.index, cob_id.sub);
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("clear bit 29, or set bit 31 if the service is not valid"));
    }
}

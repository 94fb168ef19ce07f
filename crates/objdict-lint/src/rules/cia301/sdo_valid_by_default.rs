use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, Service, rule};

rule! {
    "cia301/sdo-valid-by-default", Warning, Facts(check);
    summary: "an additional SDO channel is switched on by default",
    checks: "Whether the additional SDO channels of an EDS (1201h to 12FFh) are switched off by bit 31, or have the COB-ID 0.",
    why: "The predefined connection set has no CAN-ID for them: two devices of the type on a network use the same. CiA 301 gives 80000000h as default.",
    example: "`[1201sub1]` with `DefaultValue=0x640`",
    remedy: "Write `0x80000000`.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.device.kind != DeviceKind::Type {
        return;
    }
    for cob_id in facts.cob_ids.iter().filter(|cob_id| cob_id.is_in_use() && cob_id.wrong_bits() == 0) {
        let is_additional = match cob_id.service {
            Service::ServerRequest(number) => number > 1,
            service => matches!(service, Service::ClientRequest(_)),
        };
        // one that belongs to another service, or is half valid, is reported as that
        let pair = facts.cob_ids.iter().find(|other| other.index == cob_id.index && other.sub == 2);
        let is_half = pair.is_none_or(|other| !other.is_in_use());
        if !is_additional || is_half || facts.is_restricted(cob_id) {
            continue;
        }
        let message = say!("`{}` switches {} on in every new device", cob_id.cob_id, cob_id.service);
        let finding =
            Diagnostic::new(&RULE.info, facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help("write `0x80000000` into both COB-IDs"));
    }
}

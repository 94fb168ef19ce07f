use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::DeviceKind;
use crate::{Facts, Service, rule};

rule! {
    "cia301/sdo-valid-by-default", Warning, Facts(check);
    summary: "an additional SDO channel is valid by default",
    checks: "Whether the COB-IDs of the additional SDO channels of an EDS (1201h to 12FFh) are not valid (bit 31 set) or 0.",
    why: "The predefined connection set has no CAN-ID for them: two devices of the type on one network use the same CAN-ID. The default in CiA 301 is 80000000h.",
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
        // other rules report a restricted CAN-ID and a channel with only one valid COB-ID
        let pair = facts.cob_ids.iter().find(|other| other.index == cob_id.index && other.sub == 2);
        let is_half = pair.is_none_or(|other| !other.is_in_use());
        if !is_additional || is_half || facts.is_restricted(cob_id) {
            continue;
        }
        let message = say!("`{}` makes {} valid by default", cob_id.cob_id, cob_id.service);
        let finding =
            Diagnostic::new(&RULE.info, facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help("write `0x80000000` to both COB-IDs"));
    }
}

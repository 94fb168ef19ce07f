use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{Facts, rule};

rule! {
    "cia301/can-id-of-other-service", Warning, Facts(check);
    summary: "a PDO or SDO channel uses the CAN-ID of SYNC, TIME or EMCY",
    checks: "Whether the CAN-ID of each active PDO and additional SDO channel is not 80h (SYNC), 81h to FFh (EMCY of the nodes) or 100h (TIME). If a service of the device uses the same CAN-ID, `cia301/cob-id-collision` or `cia301/can-id-in-both-directions` reports it instead.",
    why: "The predefined connection set gives these CAN-IDs to other services: nodes take the frame for SYNC and transmit their process data, or a master reports an error that does not exist.",
    example: "`[1804sub1]` with `DefaultValue=0x80`",
    remedy: "Use a CAN-ID from 181h to 57Fh or from 680h to 6DFh.",
    source: "CiA 301 §7.3.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        let Some(owner) = facts.foreign_service(cob_id) else { continue };
        let message = say!("`{}` gives {} the CAN-ID of {}", cob_id.cob_id, cob_id.service, owner);
        let place = facts.device.value_place(cob_id.index, cob_id.sub);
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help("use a CAN-ID from 181h to 57Fh or 680h to 6DFh"));
    }
}

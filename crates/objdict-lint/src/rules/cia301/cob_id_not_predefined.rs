use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{CobId, DeviceKind, predefined};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/cob-id-not-predefined", Warning, Pdo(check);
    summary: "the default CAN-ID of one of the first four PDOs differs from the predefined connection set",
    checks: "Whether the default COB-IDs of RPDO 1 to 4 and TPDO 1 to 4 of a device with a device profile are 200h, 300h, 400h, 500h and 180h, 280h, 380h, 480h plus the node-ID. PDOs that are not valid (bit 31), numbers with a missing node-ID and CAN-IDs that another service of the device uses are not checked. A DCF is not checked either: it holds the configuration of a node.",
    why: "A simple network works without configuration because all devices use these identifiers. A device that does not may use the CAN-ID of another node.",
    example: "`[1401sub1]` with `DefaultValue=$NODEID+0x200`",
    remedy: "Write the CAN-ID of the predefined connection set.",
    source: "CiA 301 §7.3.5, §7.5.2.35 table 67, §7.5.2.37 table 71",
}

fn check(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(base) = pdo.pdo.kind.predefined_can_id(pdo.pdo.number).filter(|_| facts.has_profile()) else {
        return;
    };
    let Some(cob_id) = pdo.cob_id().filter(|cob_id| cob_id.cob_id.is_valid() && cob_id.wrong_bits() == 0)
    else {
        return;
    };
    let entry = pdo.pdo.communication.and_then(|object| object.subs.get(1));
    let is_configured = entry.is_none_or(|entry| entry.configured_value().is_some());
    // other rules report a missing node-ID and CAN-IDs of other services
    let is_reported = facts.base_without_node_id(&cob_id).is_some()
        || facts.is_restricted(&cob_id)
        || facts.foreign_service(&cob_id).is_some()
        || facts.is_shared(&cob_id);
    if facts.device.kind == DeviceKind::Node || is_configured || is_reported {
        return;
    }
    let (cob_id, expected) = (cob_id.cob_id, predefined::per_node(base));
    if !cob_id.depends_on_node_id() || cob_id.can_id(0) != expected.can_id(0) {
        let message =
            say!("the default COB-ID of {} is `{}`; CiA 301 defines `{!}`", pdo.pdo, cob_id, expected);
        let place = facts.device.value_place(pdo.pdo.communication_index(), 1);
        let flags = cob_id.number() & CobId::BIT_30;
        let finding = Diagnostic::new(&RULE.info, place, message);
        findings.push(finding.help(say!("write `$NODEID+0x{:X}`", flags | u32::from(base))));
    }
}

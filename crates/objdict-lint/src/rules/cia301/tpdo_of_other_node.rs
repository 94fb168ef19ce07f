use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DeviceKind, PdoKind};
use crate::{Facts, PdoFacts, rule};

rule! {
    "cia301/tpdo-of-other-node", Warning, Facts(check);
    summary: "a node sends a PDO with the CAN-ID of another node",
    checks: "Whether each valid TPDO of a DCF with a CAN-ID of the TPDOs of the predefined connection set uses that of its own node. CAN-IDs of RPDOs are not checked, because they link the TPDO to another node.",
    why: "The other node sends its TPDO with the same CAN-ID unless it was reconfigured: two transmitters of one identifier disturb each other.",
    example: "`NodeID=5` and `[1800sub1]` with `ParameterValue=0x186`",
    remedy: "Use the CAN-ID of this node, and configure the RPDO of the other node to receive it.",
    source: "CiA 301 §7.3.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(own) = facts.device.node_id().filter(|_| facts.device.kind == DeviceKind::Node) else { return };
    for cob_id in facts.pdos.iter().filter(|pdo| pdo.pdo.kind == PdoKind::Tpdo).filter_map(PdoFacts::cob_id) {
        let can_id = cob_id.cob_id.can_id(own);
        let is_plain = cob_id.is_in_use() && !cob_id.cob_id.is_extended() && cob_id.wrong_bits() == 0;
        let is_of_tpdo = (0x181..0x500).contains(&can_id) && can_id & 0x80 != 0;
        let node = can_id & 0x7F;
        if !is_plain || !is_of_tpdo || node == 0 || node == u32::from(own) {
            continue;
        }
        let number = (can_id >> 8) & 0x7;
        let message = say!(
            "{} of node {} uses CAN-ID `{:03X}h`, which belongs to TPDO {} of node {}",
            cob_id.service,
            own,
            can_id,
            number,
            node
        );
        let finding =
            Diagnostic::new(&RULE.info, facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help("use a CAN-ID of this node, and configure the other node to receive it"));
    }
}

use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::model::CobId;
use crate::{CobIdUse, Facts, Service, rule};

rule! {
    "cia301/restricted-can-id", Error, Facts(check);
    summary: "a service uses a restricted CAN-ID",
    checks: "Whether the CAN-ID of each active SYNC, TIME, EMCY, PDO and additional SDO channel is outside 000h to 07Fh, 101h to 180h, 581h to 5FFh, 601h to 67Fh, 6E0h to 6FFh and 701h to 7FFh, which CiA 301 reserves for NMT, the default SDOs, error control and future use. An SDO channel may use the CAN-IDs of a default SDO; a channel with COB-ID 0 is not active. A formula is evaluated for every node-ID in an EDS and for the node of a DCF; if only high node-IDs lead to a restricted CAN-ID, the finding is a warning; so is COB-ID 0 of an EMCY consumer, which is an unused entry of 1028h.",
    why: "Another node answers an SDO or sends its heartbeat with this CAN-ID: two nodes transmit the same identifier and disturb each other.",
    example: "`[1804sub1]` with `DefaultValue=$NODEID+0x580`",
    remedy: "Use a CAN-ID from 181h to 57Fh or from 680h to 6DFh, or set bit 31 to mark the service as not valid.",
    source: "CiA 301 §7.3.5, table 40",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let mut nodes = Vec::new();
    for cob_id in &facts.cob_ids {
        nodes.clear();
        nodes.extend(facts.node_ids().filter_map(|node| Some((node, facts.owner(cob_id, node)?))));
        let (Some(&first), Some(&last)) = (nodes.first(), nodes.last()) else { continue };
        let finding = finding(facts, cob_id, first, last.0, nodes.len() == facts.node_ids().count());
        findings.push(finding);
    }
}

fn finding(
    facts: &Facts<'_>,
    cob_id: &CobIdUse,
    (first, owner): (u8, &'static str),
    last: u8,
    everywhere: bool,
) -> Diagnostic {
    let can_id = cob_id.cob_id.can_id(first);
    let on_nodes = match (cob_id.cob_id.depends_on_node_id(), everywhere) {
        (false, _) => Text::default(),
        (true, true) => say!(" (on node {})", first),
        (true, false) => say!(" (on nodes {} to {})", first, last),
    };
    let message = say!(
        "`{}` gives {} CAN-ID {:03X}h{}, which is restricted ({})",
        cob_id.cob_id,
        cob_id.service,
        can_id,
        on_nodes,
        owner
    );
    let place = facts.device.value_place(cob_id.index, cob_id.sub);
    let finding = Diagnostic::new(&RULE.info, place, message);
    if cob_id.service == Service::EmcyConsumer && cob_id.cob_id == CobId::new(0) {
        return finding.severity(Severity::Warning).help("write `0x80000000` for an unused entry");
    }
    let finding = finding.help(
        "use a CAN-ID from 181h to 57Fh or 680h to 6DFh, or set bit 31 to mark the service as not valid",
    );
    let is_likely = everywhere || first == *facts.node_ids().start();
    if is_likely { finding } else { finding.severity(Severity::Warning) }
}

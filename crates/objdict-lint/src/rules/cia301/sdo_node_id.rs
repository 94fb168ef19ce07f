use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{CobIdUse, Facts, Service, rule};

rule! {
    "cia301/sdo-node-id", Warning, Facts(check);
    summary: "an SDO channel has the wrong node-ID",
    checks: "Whether sub-index 3 of each active SDO channel except the default SDO is a node-ID from 1 to 127 and not that of the DCF itself, and whether a client that uses the CAN-IDs of a default SDO, 600h and 580h plus a node-ID, states that node.",
    why: "Tools find the peer of the channel by the node-ID. With a wrong node-ID, the channel reaches no node or is shown for the wrong one.",
    example: "`[1280sub1]` with `DefaultValue=0x605` and `[1280sub3]` with `DefaultValue=6`",
    remedy: "Write the node-ID of the peer.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let requests = facts.cob_ids.iter().filter(|cob_id| match cob_id.service {
        Service::ServerRequest(number) => number > 1,
        service => matches!(service, Service::ClientRequest(_)),
    });
    for request in requests.filter(|request| request.is_in_use()) {
        let Some(node) = facts.number(request.index, 3) else { continue };
        let own = facts.device.node_id().map(i128::from);
        let service = request.service;
        let message = if !(1..=127).contains(&node) {
            say!("{} has the node-ID `{}`, which is not from 1 to 127", service, node)
        } else if own == Some(node) {
            say!("{} has the node-ID {}, which is the node itself", service, node)
        } else if let Some(server) = default_server(facts, request).filter(|&server| server != node) {
            say!("{} uses the default SDO of node {}, but has the node-ID {}", service, server, node)
        } else {
            continue;
        };
        let finding = Diagnostic::new(&RULE.info, facts.device.value_place(request.index, 3), message)
            .label(facts.device.value_place(request.index, 1), "the COB-ID");
        findings.push(finding.help("write the node-ID of the peer"));
    }
}

/// The node whose default SDO a client uses.
fn default_server(facts: &Facts<'_>, request: &CobIdUse) -> Option<i128> {
    let is_client = matches!(request.service, Service::ClientRequest(_));
    if !is_client || request.cob_id.depends_on_node_id() && facts.device.node_id().is_none() {
        return None;
    }
    let can_id = request.cob_id.can_id(*facts.node_ids().start());
    (0x601..=0x67F).contains(&can_id).then_some(i128::from(can_id) - 0x600)
}

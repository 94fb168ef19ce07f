use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::{CobIdUse, Facts, Service, rule};

rule! {
    "cia301/sdo-cob-ids-exchanged", Error, Facts(check), fix Unsafe;
    summary: "the COB-IDs of an SDO channel are exchanged",
    checks: "Whether the client of each active SDO client and additional SDO server transmits with a CAN-ID from 600h to 67Fh and receives with one from 580h to 5FFh, not the reverse, if the channel uses the CAN-IDs of default SDOs.",
    why: "The client sends its requests with the CAN-ID of the server's responses, and waits for a response where the server listens: every transfer times out.",
    example: "`[1280sub1]` with `DefaultValue=0x585` and `[1280sub2]` with `DefaultValue=0x605`",
    remedy: "Write 600h plus the node-ID of the server to sub-index 1 and 580h plus the node-ID to sub-index 2.",
    source: "CiA 301 §7.5.2.33, §7.5.2.34; §7.3.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let node = *facts.node_ids().start();
    let can_id = |cob_id: &CobIdUse| cob_id.cob_id.can_id(node);
    for (request, response) in facts.sdo_channels() {
        let is_active = request.is_in_use() && response.is_in_use();
        let is_exchanged = (0x580..0x600).contains(&can_id(request))
            && (0x600..0x680).contains(&can_id(response))
            && !request.cob_id.is_extended()
            && !response.cob_id.is_extended();
        // the default SDO has its own rule
        if !is_active || !is_exchanged || request.service == Service::ServerRequest(1) {
            continue;
        }
        let place = |cob_id: &CobIdUse| facts.device.value_place(cob_id.index, cob_id.sub);
        let message = say!(
            "{} has `{}` from client to server and `{}` from server to client; the predefined connection set is the reverse",
            request.service,
            request.cob_id,
            response.cob_id
        );
        let fix = Fix::risky("exchange the COB-IDs")
            .set(place(request), response.cob_id.to_string())
            .set(place(response), request.cob_id.to_string());
        let finding = Diagnostic::new(&RULE.info, place(request), message)
            .label(place(response), "the other direction");
        findings.push(finding.help("exchange the COB-IDs").fix(fix));
    }
}

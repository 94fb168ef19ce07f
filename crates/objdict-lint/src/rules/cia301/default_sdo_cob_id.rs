use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::predefined;
use crate::{Facts, Service, rule};

rule! {
    "cia301/default-sdo-cob-id", Error, Facts(check), fix Unsafe;
    summary: "the CAN-ID of the default SDO differs from CiA 301",
    checks: "Whether 1200h sub-index 1 is 600h plus the node-ID and sub-index 2 is 580h plus the node-ID: as formulas in an EDS, as formulas or as numbers for the node in a DCF.",
    why: "Every tool reaches the device through the default SDO, and its CAN-IDs cannot be changed. A tool that uses the CAN-IDs of the description gets no answer, or addresses another node.",
    example: "`[1200sub1]` with `DefaultValue=0x600`",
    remedy: "Write `$NODEID+0x600` and `$NODEID+0x580`.",
    source: "CiA 301 §7.5.2.33, §7.3.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        let (base, direction) = match cob_id.service {
            Service::ServerRequest(1) => (predefined::SDO_REQUEST, "from client to server"),
            Service::ServerResponse(1) => (predefined::SDO_RESPONSE, "from server to client"),
            _ => continue,
        };
        let expected = predefined::per_node(base);
        let is_right = match facts.device.node_id() {
            Some(node) => cob_id.cob_id.on_node(node) == expected.on_node(node),
            None => cob_id.cob_id == expected,
        };
        if !is_right {
            let message = say!(
                "the COB-ID of the default SDO {} is `{}`; it must be `{!}`",
                direction,
                cob_id.cob_id,
                expected
            );
            let place = facts.device.value_place(cob_id.index, cob_id.sub);
            let title = say!("write `{}`", expected);
            let fix = Fix::risky(title.clone()).set(place.clone(), expected.to_string());
            findings.push(Diagnostic::new(&RULE.info, place, message).help(title).fix(fix));
        }
    }
}

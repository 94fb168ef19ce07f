use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::{Facts, rule};

rule! {
    "cia301/fixed-node-id", Warning, Facts(check), fix Unsafe;
    summary: "a COB-ID is a number instead of a formula with the node-ID",
    checks: "Whether the default COB-IDs of EMCY and of PDO 1 to 4 in an EDS are formulas if they lie in the predefined connection set: 81h to FFh for EMCY, 181h to 1FFh for TPDO 1 and so on, or the bare base such as 180h. COB-IDs that are not valid (bit 31) are not checked. A DCF describes one node and may contain numbers.",
    why: "An EDS describes a device type, not a node: two such devices on one network use the same CAN-ID. Tools do not add the node-ID to a number.",
    example: "`[1014]` with `DefaultValue=0x81`",
    remedy: "Write `$NODEID+0x80`.",
    source: "CiA 301 §7.3.5, tables 38 and 39; CiA 306-1 §4.3",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        if let Some(base) = facts.base_without_node_id(cob_id) {
            let node = cob_id.cob_id.number() & 0x7F;
            let message = match node {
                0 => say!("the COB-ID `{}` of {} is missing the node-ID", cob_id.cob_id, cob_id.service),
                _ => say!(
                    "the COB-ID `{}` of {} is that of node {} alone",
                    cob_id.cob_id,
                    cob_id.service,
                    node
                ),
            };
            let place = facts.device.value_place(cob_id.index, cob_id.sub);
            let number = cob_id.cob_id.number() & !0x7FF | u32::from(base);
            let title = say!("write `$NODEID+0x{:X}`", number);
            let fix = Fix::risky(title.clone()).set(place.clone(), format!("$NODEID+0x{number:X}"));
            findings.push(Diagnostic::new(&RULE.info, place, message).help(title).fix(fix));
        }
    }
}

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{CobId, DeviceKind, predefined};
use crate::{CobIdUse, Facts, Service, rule};

rule! {
    "cia301/service-cob-id-not-predefined", Warning, Facts(check), fix Unsafe;
    summary: "the CAN-ID of SYNC, TIME or EMCY differs from the predefined connection set",
    checks: "Whether the defaults of an EDS are 80h for SYNC, 100h for TIME and 80h plus the node-ID for EMCY. In a DCF, SYNC and EMCY must not have the CAN-ID of the EMCY of another node (81h to FFh). Flags are ignored. COB-IDs that another rule reports are not checked.",
    why: "With the predefined connection set, devices of all vendors work together without configuration. A device that expects SYNC on another CAN-ID does not receive it.",
    example: "`[1005]` with `DefaultValue=$NODEID+0x80`",
    remedy: "Write `0x80`, `0x100` or `$NODEID+0x80`.",
    source: "CiA 301 §7.3.5, tables 38 and 39",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.device.kind == DeviceKind::Node {
        return emergency_of_other_node(facts, findings);
    }
    for cob_id in &facts.cob_ids {
        let base = match cob_id.service {
            Service::Sync => predefined::SYNC,
            Service::Time => predefined::TIME,
            Service::Emcy => predefined::EMCY,
            _ => continue,
        };
        if let Some(expected) = expected(facts, cob_id, base) {
            let place = facts.device.value_place(cob_id.index, cob_id.sub);
            let message = say!(
                "the default COB-ID `{}` of {} is not in the predefined connection set",
                cob_id.cob_id,
                cob_id.service
            );
            let finding = Diagnostic::new(&RULE.info, place.clone(), message);
            let fix = Fix::risky("write the CAN-ID of the predefined connection set")
                .set(place, expected.to_string());
            findings.push(finding.help(say!("write `{}`", expected)).fix(fix));
        }
    }
}

/// The expected COB-ID with the same flags, if it differs.
fn expected(facts: &Facts<'_>, cob_id: &CobIdUse, base: u16) -> Option<CobId> {
    let per_node = cob_id.service == Service::Emcy;
    let stated = cob_id.cob_id;
    let is_explained = !cob_id.is_in_use()
        || cob_id.wrong_bits() != 0
        || facts.is_restricted(cob_id)
        || facts.base_without_node_id(cob_id).is_some();
    let is_right = !stated.is_extended()
        && stated.depends_on_node_id() == per_node
        && stated.number() & 0x7FF == u32::from(base);
    if is_explained || is_right {
        return None;
    }
    let number = stated.number() & (CobId::BIT_30 | CobId::BIT_31) | u32::from(base);
    if per_node { CobId::per_node(number) } else { Some(CobId::new(number)) }
}

/// Reports a node whose EMCY or SYNC has the CAN-ID of the EMCY of another node.
fn emergency_of_other_node(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(own) = facts.device.node_id() else { return };
    let services =
        facts.cob_ids.iter().filter(|cob_id| matches!(cob_id.service, Service::Emcy | Service::Sync));
    for cob_id in services.filter(|cob_id| cob_id.is_in_use() && !cob_id.cob_id.is_extended()) {
        let can_id = cob_id.cob_id.can_id(own);
        if !(0x81..=0xFF).contains(&can_id) || can_id == 0x80 + u32::from(own) {
            continue;
        }
        let service = cob_id.service;
        let message =
            say!("{} has `{:03X}h`, the CAN-ID of the EMCY of node {}", service, can_id, can_id - 0x80);
        let finding =
            Diagnostic::new(&RULE.info, facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help(match service {
            Service::Sync => {
                say!("write `0x{:X}`", u32::from(predefined::SYNC) | cob_id.cob_id.number() & CobId::BIT_30)
            }
            _ => say!("write `$NODEID+0x{:X}`", predefined::EMCY),
        }));
    }
}

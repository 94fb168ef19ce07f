use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, Findings, Severity, Text, say};
use crate::model::PdoKind;
use crate::{CobIdUse, Facts, Service, rule};

rule! {
    "cia301/cob-id-collision", Error, Facts(check);
    summary: "two services of the device use the same CAN-ID",
    checks: "Whether two active services among SYNC, TIME, EMCY, SDO channels and PDOs transmit with the same CAN-ID or receive with the same CAN-ID. A formula is evaluated for every node-ID in an EDS and for the node of a DCF. Two RPDOs that receive the same frame are a warning, because this can be intended.",
    why: "A receiver cannot distinguish the frames: data for one service is processed by the other.",
    example: "`[1400sub1]` and `[1401sub1]`, both with `DefaultValue=$NODEID+0x200`",
    remedy: "Give each service its own CAN-ID. The predefined connection set has one for each of the first four PDOs in each direction.",
    source: "CiA 301 §7.3.3, §7.3.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let mut fixed: BTreeMap<Key, &CobIdUse> = BTreeMap::new();
    let mut per_node: BTreeMap<Key, &CobIdUse> = BTreeMap::new();
    let is_looked_at = |cob_id: &&CobIdUse| {
        let is_readable = cob_id.is_in_use() && cob_id.wrong_bits() == 0;
        // other rules report a missing node-ID and a restricted CAN-ID
        is_readable && facts.base_without_node_id(cob_id).is_none() && !facts.is_restricted(cob_id)
    };
    for cob_id in facts.cob_ids.iter().filter(is_looked_at) {
        let node = facts.device.node_id();
        let key = Key::new(cob_id, node.unwrap_or(0));
        // with a known node-ID every formula is a number
        let map =
            if cob_id.cob_id.depends_on_node_id() && node.is_none() { &mut per_node } else { &mut fixed };
        match map.get(&key) {
            Some(first) => findings.push(collision(facts, first, cob_id, node)),
            None => {
                map.insert(key, cob_id);
            }
        }
    }
    for (key, cob_id) in &fixed {
        let bases = key.with(key.can_id.saturating_sub(127))..key.with(key.can_id);
        for (base, other) in per_node.range(bases) {
            let node = u8::try_from(key.can_id - base.can_id).ok();
            findings.push(collision(facts, other, cob_id, node));
        }
    }
}

/// The value that must be unique. Without a node-ID, formulas are compared by their offset.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    is_sent: bool,
    is_extended: bool,
    can_id: u32,
}

impl Key {
    fn new(cob_id: &CobIdUse, node: u8) -> Self {
        let (is_sent, is_extended) = (cob_id.is_sent(), cob_id.cob_id.is_extended());
        Self { is_sent, is_extended, can_id: cob_id.cob_id.can_id(node) }
    }

    fn with(self, can_id: u32) -> Self {
        Self { can_id, ..self }
    }
}

fn collision(facts: &Facts<'_>, first: &CobIdUse, second: &CobIdUse, node: Option<u8>) -> Diagnostic {
    let place = |cob_id: &CobIdUse| facts.device.value_place(cob_id.index, cob_id.sub);
    let does = if second.is_sent() { "transmit" } else { "receive" };
    let on_node = match node {
        Some(node) if facts.device.node_id().is_none() => say!(" on node {}", node),
        _ => Text::default(),
    };
    let (one, other) = (first.service, second.service);
    let message = say!("{} and {} both {} with COB-ID `{}`{}", other, one, does, second.cob_id, on_node);
    let finding = Diagnostic::new(&RULE.info, place(second), message)
        .label(place(first), say!("{} uses it here", one))
        .help("give each service its own CAN-ID, or set bit 31 to mark one of them as not valid");
    let is_rpdo = |service| matches!(service, Service::Pdo(PdoKind::Rpdo, _));
    if is_rpdo(one) && is_rpdo(other) { finding.severity(Severity::Warning) } else { finding }
}

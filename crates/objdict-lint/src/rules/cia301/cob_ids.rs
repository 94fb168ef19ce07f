//! The CAN-IDs of services: collisions, restrictions and the predefined connection set.

use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, Text, joined, say};
use crate::model::{CobId, DeviceKind, Field, PdoKind, predefined};
use crate::rule::rules;
use crate::{CobIdService, CobIdUse, Facts, PdoFacts};

rules! {
    "cia301/can-id-in-both-directions" = CAN_ID_IN_BOTH_DIRECTIONS, Error, Facts(can_id_in_both_directions);
    summary: "a service receives with a CAN-ID that the device itself transmits",
    checks: "No active SYNC, TIME, EMCY, SDO channel or PDO may receive with the CAN-ID of an active service that transmits. Examples are a TPDO with the CAN-ID of its own RPDO or of the SYNC that the device consumes, an SDO client with the same COB-ID in both directions and an EMCY consumer with the CAN-ID of a TPDO. In an EDS, formulas are compared with formulas and numbers with numbers. Restricted CAN-IDs have their own rule.",
    why: "A CAN controller does not receive its own frames. The peer that transmits to the service uses a CAN-ID of the device, so two nodes transmit the same identifier. Other nodes mistake the data of one service for a different one, such as process data for SYNC.",
    example: "`[1400sub1]` and `[1800sub1]`, both with `DefaultValue=$NODEID+0x180`",
    remedy: "Give one of the services its own CAN-ID, or set bit 31 to mark it as not valid.",
    source: "CiA 301 §7.3.3, §7.3.5",

    "cia301/can-id-of-other-service" = CAN_ID_OF_OTHER_SERVICE, Warning, Facts(can_id_of_other_service);
    summary: "a PDO or SDO channel uses the CAN-ID of SYNC, TIME or EMCY",
    checks: "An active PDO or additional SDO channel must not use 80h (SYNC), 81h to FFh (EMCY of the nodes) or 100h (TIME) as its CAN-ID. If a service of the device uses the same CAN-ID, `cia301/cob-id-collision` or `cia301/can-id-in-both-directions` reports it instead.",
    why: "The predefined connection set gives these CAN-IDs to other services: nodes mistake the frame for SYNC and transmit their process data, or a master reports an error that does not exist.",
    example: "`[1804sub1]` with `DefaultValue=0x80`",
    remedy: "Use a CAN-ID from 181h to 57Fh or from 680h to 6DFh.",
    source: "CiA 301 §7.3.5",

    "cia301/cob-id-collision" = COB_ID_COLLISION, Error, Facts(cob_id_collision);
    summary: "two services of the device use the same CAN-ID",
    checks: "Two active services must not transmit with the same CAN-ID or receive with the same CAN-ID. The rule compares SYNC, TIME, EMCY, SDO channels and PDOs. A formula is evaluated for every node-ID in an EDS and for the node of a DCF. Two RPDOs that receive the same frame are a warning, because this can be intended.",
    why: "A receiver cannot distinguish the frames: data for one service is processed by the other.",
    example: "`[1400sub1]` and `[1401sub1]`, both with `DefaultValue=$NODEID+0x200`",
    remedy: "Give each service its own CAN-ID. The predefined connection set has one for each of the first four PDOs in each direction.",
    source: "CiA 301 §7.3.3, §7.3.5",

    "cia301/cob-id-not-predefined" = COB_ID_NOT_PREDEFINED, Warning, Pdo(cob_id_not_predefined);
    summary: "the default CAN-ID of one of the first four PDOs differs from the predefined connection set",
    checks: "In a device with a device profile, the default COB-IDs of RPDO 1 to 4 must be 200h, 300h, 400h and 500h plus the node-ID. For TPDO 1 to 4, they must be 180h, 280h, 380h and 480h plus the node-ID. PDOs that are not valid (bit 31), numbers with a missing node-ID and CAN-IDs that a different service of the device uses are not checked. A DCF is not checked either: it holds the configuration of a node.",
    why: "A simple network works without configuration because all devices use these identifiers. A device that does not may use a different node's CAN-ID.",
    example: "`[1401sub1]` with `DefaultValue=$NODEID+0x200`",
    remedy: "Write the CAN-ID of the predefined connection set.",
    source: "CiA 301 §7.3.5, §7.5.2.35 table 67, §7.5.2.37 table 71",

    "cia301/fixed-node-id" = FIXED_NODE_ID, Warning, Facts(fixed_node_id), fix Unsafe;
    summary: "a COB-ID is a number instead of a formula with the node-ID",
    checks: "In an EDS, the default COB-IDs of EMCY and of PDO 1 to 4 must be formulas if they lie in the predefined connection set. These are 81h to FFh for EMCY, 181h to 1FFh for TPDO 1 and so on, and the bare bases such as 180h. COB-IDs that are not valid (bit 31) are not checked. A DCF describes one node and may contain numbers.",
    why: "An EDS describes a device type, not a node: two such devices on one network use the same CAN-ID. Tools do not add the node-ID to a number.",
    example: "`[1014]` with `DefaultValue=0x81`",
    remedy: "Write `$NODEID+0x80`.",
    source: "CiA 301 §7.3.5, tables 38 and 39; CiA 306-1 §4.3",

    "cia301/invalid-cob-id" = INVALID_COB_ID, Error, Facts(invalid_cob_id), fix Unsafe;
    summary: "reserved bits of a COB-ID are set",
    checks: "Bits 11 to 28 must be clear in each COB-ID with an 11-bit CAN-ID (bit 29 clear). Bit 30 must be clear in COB-IDs of EMCY, where it is reserved. The rule checks SYNC, TIME, EMCY, SDO and PDO and evaluates a formula for the highest node-ID.",
    why: "Some devices reject such a value, others truncate it, so the service uses a different CAN-ID. Often a digit is missing: `0x8000000` was meant to be `0x80000000`.",
    example: "`[1804sub1]` with `DefaultValue=0x8000000`",
    remedy: "Check the number of digits: bit 31 is `0x80000000`, and the CAN-ID is in the three lowest digits.",
    source: "CiA 301 §7.5.2.5, §7.5.2.17, §7.5.2.33, §7.5.2.35",

    "cia301/restricted-can-id" = RESTRICTED_CAN_ID, Error, Facts(restricted_can_id);
    summary: "a service uses a restricted CAN-ID",
    checks: "An active SYNC, TIME, EMCY, PDO or additional SDO channel must not use a CAN-ID from 000h to 07Fh, 101h to 180h, 581h to 5FFh, 601h to 67Fh, 6E0h to 6FFh or 701h to 7FFh. CiA 301 reserves these for NMT, the default SDOs, error control and future use. An SDO channel may use the CAN-IDs of a default SDO; a channel with COB-ID 0 is not active. A formula is evaluated for every node-ID in an EDS and for the node of a DCF. If only high node-IDs lead to a restricted CAN-ID, the finding is a warning. COB-ID 0 of an EMCY consumer, an unused entry of 1028h, is a warning too.",
    why: "A different node responds to SDO requests or sends its heartbeat with this CAN-ID: two nodes transmit the same identifier and disturb each other.",
    example: "`[1804sub1]` with `DefaultValue=$NODEID+0x580`",
    remedy: "Use a CAN-ID from 181h to 57Fh or from 680h to 6DFh, or set bit 31 to mark the service as not valid.",
    source: "CiA 301 §7.3.5, table 40",

    "cia301/service-cob-id-not-predefined" = SERVICE_COB_ID_NOT_PREDEFINED, Warning,
        Facts(service_cob_id_not_predefined), fix Unsafe;
    summary: "the CAN-ID of SYNC, TIME or EMCY differs from the predefined connection set",
    checks: "In an EDS, the default must be 80h for SYNC, 100h for TIME and 80h plus the node-ID for EMCY. In a DCF, SYNC and EMCY must not use the CAN-ID of a different node's EMCY (81h to FFh). Flags are ignored. COB-IDs with findings of other rules are not checked.",
    why: "With the predefined connection set, devices of all vendors work together without configuration. A device that expects SYNC on a different CAN-ID does not receive it.",
    example: "`[1005]` with `DefaultValue=$NODEID+0x80`",
    remedy: "Write `0x80`, `0x100` or `$NODEID+0x80`.",
    source: "CiA 301 §7.3.5, tables 38 and 39",

    "cia301/short-can-id-in-extended-frame" = SHORT_CAN_ID_IN_EXTENDED_FRAME, Warning,
        Facts(short_can_id_in_extended_frame);
    summary: "a COB-ID is marked as 29 bits long but has only 11",
    checks: "Each active COB-ID with bit 29 set (extended frame) must have more than 11 bits.",
    why: "Extended frames are rare, and a base frame with the same number is a different identifier. Often bit 29 was set instead of bit 30 or 31.",
    example: "`[1800sub1]` with `DefaultValue=$NODEID+0x20000180`",
    remedy: "Clear bit 29.",
    source: "CiA 301 §7.5.2.5, §7.5.2.35, figures 53 to 71",

    "cia301/tpdo-of-other-node" = TPDO_OF_OTHER_NODE, Warning, Facts(tpdo_of_other_node);
    summary: "a node sends a PDO with a different node's CAN-ID",
    checks: "If a valid TPDO of a DCF uses a TPDO CAN-ID of the predefined connection set, it must be the CAN-ID of its own node. CAN-IDs of RPDOs are not checked, because they link the TPDO to another node.",
    why: "The other node sends its TPDO with the same CAN-ID unless it was reconfigured: two transmitters of one identifier disturb each other.",
    example: "`NodeID=5` and `[1800sub1]` with `ParameterValue=0x186`",
    remedy: "Use the CAN-ID of this node and configure the RPDO of the other node to receive it.",
    source: "CiA 301 §7.3.5",
}

/// The COB-IDs in use, except COB-IDs with wrong bits, without node-ID or with a restricted CAN-ID: other rules report them.
fn unreported_cob_ids<'a>(facts: &'a Facts<'_>) -> impl Iterator<Item = &'a CobIdUse> {
    facts.cob_ids.iter().filter(|cob_id| {
        let is_readable = cob_id.is_in_use() && cob_id.wrong_bits() == 0;
        is_readable && facts.base_without_node_id(cob_id).is_none() && !facts.is_restricted(cob_id)
    })
}

fn can_id_in_both_directions(facts: &Facts<'_>, findings: &mut Findings) {
    let (sent, received): (Vec<_>, Vec<_>) = unreported_cob_ids(facts).partition(|cob_id| cob_id.is_sent());
    let mut pairs = BTreeSet::new();
    for transmitter in &sent {
        let same = |other: &&&CobIdUse| collision_key(facts, other) == collision_key(facts, transmitter);
        for receiver in received.iter().filter(same).filter(|other| !has_peer_rule(facts, transmitter, other))
        {
            // collisions in both directions of a client and a server have one cause
            let objects = [transmitter.index, receiver.index];
            if pairs.insert([objects[0].min(objects[1]), objects[0].max(objects[1])]) {
                findings.push(both_directions(facts, transmitter, receiver));
            }
        }
    }
}

/// The key that two COB-IDs share if they collide on every node of the description.
fn collision_key(facts: &Facts<'_>, cob_id: &CobIdUse) -> (bool, bool, u32) {
    let node = facts.device.node_id();
    let is_formula = cob_id.cob_id.depends_on_node_id() && node.is_none();
    (is_formula, cob_id.cob_id.is_extended(), cob_id.cob_id.can_id(node.unwrap_or(0)))
}

/// Whether another rule reports that the device is its own peer.
fn has_peer_rule(facts: &Facts<'_>, transmitter: &CobIdUse, receiver: &CobIdUse) -> bool {
    let own = facts.device.node_id().map(i128::from);
    let client = [transmitter, receiver]
        .into_iter()
        .find(|one| matches!(one.service, CobIdService::ClientRequest(_) | CobIdService::ClientResponse(_)));
    let is_own_client = client.is_some_and(|client| own.is_some() && facts.number(client.index, 3) == own);
    let is_own_emcy =
        transmitter.service == CobIdService::Emcy && receiver.service == CobIdService::EmcyConsumer;
    is_own_emcy || is_own_client && transmitter.index != receiver.index
}

fn both_directions(facts: &Facts<'_>, transmitter: &CobIdUse, receiver: &CobIdUse) -> Diagnostic {
    let place = |cob_id: &CobIdUse| facts.device.value_place(cob_id.index, cob_id.sub);
    if transmitter.index == receiver.index {
        let message = say!("{} uses `{}` in both directions", transmitter.service, transmitter.cob_id);
        return CAN_ID_IN_BOTH_DIRECTIONS
            .at(place(receiver), message)
            .label(place(transmitter), "the other direction")
            .help("give each direction its own CAN-ID, or set bit 31 in both");
    }
    let message = say!(
        "{} transmits and {} receives with the CAN-ID `{}`",
        transmitter.service,
        receiver.service,
        transmitter.cob_id.without_flags()
    );
    // the mistake is probably in the entry for a different node
    let is_at_receiver = receiver.service == CobIdService::EmcyConsumer || receiver.index > transmitter.index;
    let (at, other) = if is_at_receiver { (receiver, transmitter) } else { (transmitter, receiver) };
    CAN_ID_IN_BOTH_DIRECTIONS
        .at(place(at), message)
        .label(place(other), say!("{} uses it here", other.service))
        .help("give each service its own CAN-ID, or set bit 31 to mark one of them as not valid")
}

fn can_id_of_other_service(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        let Some(owner) = facts.foreign_service(cob_id) else { continue };
        let message = say!("`{}` gives {} the CAN-ID of {}", cob_id.cob_id, cob_id.service, owner);
        let place = facts.device.value_place(cob_id.index, cob_id.sub);
        let finding = CAN_ID_OF_OTHER_SERVICE.at(place, message);
        findings.push(finding.help("use a CAN-ID from 181h to 57Fh or 680h to 6DFh"));
    }
}

fn cob_id_collision(facts: &Facts<'_>, findings: &mut Findings) {
    let mut fixed: BTreeMap<CanIdKey, &CobIdUse> = BTreeMap::new();
    let mut per_node: BTreeMap<CanIdKey, &CobIdUse> = BTreeMap::new();
    for cob_id in unreported_cob_ids(facts) {
        let node = facts.device.node_id();
        let key = CanIdKey::new(cob_id, node.unwrap_or(0));
        // with a known node-ID every formula is a number
        let map =
            if cob_id.cob_id.depends_on_node_id() && node.is_none() { &mut per_node } else { &mut fixed };
        match map.get(&key) {
            Some(first) => findings.push(collision_of(facts, first, cob_id, node)),
            None => {
                map.insert(key, cob_id);
            }
        }
    }
    for (key, cob_id) in &fixed {
        let bases = key.with(key.can_id.saturating_sub(127))..key.with(key.can_id);
        for (base, other) in per_node.range(bases) {
            let node = u8::try_from(key.can_id - base.can_id).ok();
            findings.push(collision_of(facts, other, cob_id, node));
        }
    }
}

/// The value that must be unique. Without a node-ID, formulas are compared by their offset.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct CanIdKey {
    is_sent: bool,
    is_extended: bool,
    can_id: u32,
}

impl CanIdKey {
    fn new(cob_id: &CobIdUse, node: u8) -> Self {
        let (is_sent, is_extended) = (cob_id.is_sent(), cob_id.cob_id.is_extended());
        Self { is_sent, is_extended, can_id: cob_id.cob_id.can_id(node) }
    }

    fn with(self, can_id: u32) -> Self {
        Self { can_id, ..self }
    }
}

fn collision_of(facts: &Facts<'_>, first: &CobIdUse, second: &CobIdUse, node: Option<u8>) -> Diagnostic {
    let place = |cob_id: &CobIdUse| facts.device.value_place(cob_id.index, cob_id.sub);
    let does = if second.is_sent() { "transmit" } else { "receive" };
    let on_node = match node {
        Some(node) if facts.device.node_id().is_none() => say!(" on node {}", node),
        _ => Text::default(),
    };
    let (one, other) = (first.service, second.service);
    let message = say!("{} and {} both {} with COB-ID `{}`{}", other, one, does, second.cob_id, on_node);
    let finding = COB_ID_COLLISION
        .at(place(second), message)
        .label(place(first), say!("{} uses it here", one))
        .help("give each service its own CAN-ID, or set bit 31 to mark one of them as not valid");
    let is_rpdo = |service| matches!(service, CobIdService::Pdo(PdoKind::Rpdo, _));
    if is_rpdo(one) && is_rpdo(other) { finding.severity(Severity::Warning) } else { finding }
}

fn cob_id_not_predefined(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
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
        let finding = COB_ID_NOT_PREDEFINED.at(place, message);
        findings.push(finding.help(say!("write `$NODEID+0x{:X}`", flags | u32::from(base))));
    }
}

fn fixed_node_id(facts: &Facts<'_>, findings: &mut Findings) {
    for configured in &facts.cob_ids {
        let CobIdUse { index, sub, service, .. } = *configured;
        // a `ParameterValue` belongs in a DCF, where a number is right
        let entry = facts.device.entry(index, sub);
        let default = entry.and_then(|entry| CobId::from_value(entry.default.as_ref()?));
        let Some(cob_id) = default.map(|cob_id| CobIdUse { index, sub, service, cob_id }) else { continue };
        if let Some(base) = facts.base_without_node_id(&cob_id) {
            let node = cob_id.cob_id.number() & 0x7F;
            let message = match node {
                0 => say!("the COB-ID `{}` of {} is missing the node-ID", cob_id.cob_id, cob_id.service),
                _ => say!("COB-ID `{}` of {} works only for node {}", cob_id.cob_id, cob_id.service, node),
            };
            let mut place = facts.device.value_place(index, sub);
            if place.field == Some(Field::ParameterValue) {
                place = place.field(Field::DefaultValue);
            }
            let number = cob_id.cob_id.number() & !0x7FF | u32::from(base);
            let title = say!("write `$NODEID+0x{:X}`", number);
            let fix = Fix::risky(title.clone()).set(place.clone(), format!("$NODEID+0x{number:X}"));
            findings.push(FIXED_NODE_ID.at(place, message).help(title).fix(fix));
        }
    }
}

fn invalid_cob_id(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in &facts.cob_ids {
        let bits = cob_id.wrong_bits();
        if bits == 0 {
            continue;
        }
        let message = say!(
            "the COB-ID `{}` of {} has {} set, which {} reserved",
            cob_id.cob_id,
            cob_id.service,
            reserved_bit_names(bits),
            if bits.count_ones() == 1 { "is" } else { "are" }
        );
        let place = facts.device.value_place(cob_id.index, cob_id.sub);
        let number = cob_id.cob_id.number();
        let finding = INVALID_COB_ID.at(place.clone(), message).help(cob_id_help(number));
        let meant = number_with_shifted_flag(number).filter(|_| !cob_id.cob_id.depends_on_node_id());
        findings.push(match meant {
            Some(meant) => {
                finding.fix(Fix::risky(say!("write `0x{:08X}`", meant)).set(place, format!("0x{meant:08X}")))
            }
            None => finding,
        });
    }
}

fn reserved_bit_names(bits: u32) -> Text {
    let word = if bits.count_ones() == 1 { "bit" } else { "bits" };
    say!("{} {}", word, joined((0..32).filter(|bit| bits >> bit & 1 == 1), ", "))
}

fn cob_id_help(number: u32) -> Text {
    match number_with_shifted_flag(number) {
        Some(meant) => say!("did you mean `0x{:08X}`?", meant),
        None => "write a CAN-ID up to 7FFh, with flags in the first digit only".into(),
    }
}

/// The probable number if the flag digit is one place too far to the right.
fn number_with_shifted_flag(number: u32) -> Option<u32> {
    matches!(number >> 24, 0x04 | 0x08 | 0x0C).then_some((number >> 24 << 28) | (number & 0x7FF))
}

fn restricted_can_id(facts: &Facts<'_>, findings: &mut Findings) {
    let mut nodes = Vec::new();
    for cob_id in &facts.cob_ids {
        nodes.clear();
        nodes.extend(facts.node_ids().filter_map(|node| Some((node, facts.owner(cob_id, node)?))));
        let (Some(&first), Some(&last)) = (nodes.first(), nodes.last()) else { continue };
        let finding =
            use_of_restricted(facts, cob_id, first, last.0, nodes.len() == facts.node_ids().count());
        findings.push(finding);
    }
}

fn use_of_restricted(
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
    let finding = RESTRICTED_CAN_ID.at(place, message);
    if cob_id.service == CobIdService::EmcyConsumer && cob_id.cob_id == CobId::new(0) {
        return finding.severity(Severity::Warning).help("write `0x80000000` for an unused entry");
    }
    let finding = finding.help(
        "use a CAN-ID from 181h to 57Fh or 680h to 6DFh, or set bit 31 to mark the service as not valid",
    );
    let is_likely = everywhere || first == *facts.node_ids().start();
    if is_likely { finding } else { finding.severity(Severity::Warning) }
}

fn service_cob_id_not_predefined(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.device.kind == DeviceKind::Node {
        return emergency_of_other_node(facts, findings);
    }
    for cob_id in &facts.cob_ids {
        let base = match cob_id.service {
            CobIdService::Sync => predefined::SYNC,
            CobIdService::Time => predefined::TIME,
            CobIdService::Emcy => predefined::EMCY,
            _ => continue,
        };
        if let Some(expected) = predefined_cob_id(facts, cob_id, base) {
            let place = facts.device.value_place(cob_id.index, cob_id.sub);
            let message = say!(
                "the default COB-ID `{}` of {} is not in the predefined connection set",
                cob_id.cob_id,
                cob_id.service
            );
            let finding = SERVICE_COB_ID_NOT_PREDEFINED.at(place.clone(), message);
            let fix = Fix::risky("write the CAN-ID of the predefined connection set")
                .set(place, expected.to_string());
            findings.push(finding.help(say!("write `{}`", expected)).fix(fix));
        }
    }
}

/// The expected COB-ID with the same flags, if it differs.
fn predefined_cob_id(facts: &Facts<'_>, cob_id: &CobIdUse, base: u16) -> Option<CobId> {
    let per_node = cob_id.service == CobIdService::Emcy;
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

/// Reports a node whose EMCY or SYNC uses the CAN-ID of a different node's EMCY.
fn emergency_of_other_node(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(own) = facts.device.node_id() else { return };
    let services = facts
        .cob_ids
        .iter()
        .filter(|cob_id| matches!(cob_id.service, CobIdService::Emcy | CobIdService::Sync));
    for cob_id in services.filter(|cob_id| cob_id.is_in_use() && !cob_id.cob_id.is_extended()) {
        let can_id = cob_id.cob_id.can_id(own);
        if !(0x81..=0xFF).contains(&can_id) || can_id == 0x80 + u32::from(own) {
            continue;
        }
        let service = cob_id.service;
        let message =
            say!("{} has `{:03X}h`, the CAN-ID of the EMCY of node {}", service, can_id, can_id - 0x80);
        let finding =
            SERVICE_COB_ID_NOT_PREDEFINED.at(facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help(match service {
            CobIdService::Sync => {
                say!("write `0x{:X}`", u32::from(predefined::SYNC) | cob_id.cob_id.number() & CobId::BIT_30)
            }
            _ => say!("write `$NODEID+0x{:X}`", predefined::EMCY),
        }));
    }
}

fn short_can_id_in_extended_frame(facts: &Facts<'_>, findings: &mut Findings) {
    for cob_id in facts.cob_ids.iter().filter(|cob_id| cob_id.cob_id.is_extended() && cob_id.is_in_use()) {
        if cob_id.cob_id.can_id(127) > 0x7FF || cob_id.wrong_bits() != 0 {
            continue;
        }
        let message = say!(
            "`{}` of {} is marked as a 29-bit identifier, but has only 11 bits",
            cob_id.cob_id,
            cob_id.service
        );
        let place = facts.device.value_place(cob_id.index, cob_id.sub);
        let finding = SHORT_CAN_ID_IN_EXTENDED_FRAME.at(place, message);
        findings.push(finding.help("clear bit 29, or set bit 31 if the service is not valid"));
    }
}

fn tpdo_of_other_node(facts: &Facts<'_>, findings: &mut Findings) {
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
        let finding = TPDO_OF_OTHER_NODE.at(facts.device.value_place(cob_id.index, cob_id.sub), message);
        findings.push(finding.help("use a CAN-ID of this node, and configure the other node to receive it"));
    }
}

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::{CobIdUse, Facts, Service, rule};

rule! {
    "cia301/can-id-in-both-directions", Error, Facts(check);
    summary: "a service receives with the CAN-ID with which the device itself transmits",
    checks: "Whether no active service among SYNC, TIME, EMCY, SDO channels and PDOs receives with the CAN-ID of another one that transmits: a TPDO with the CAN-ID of the SYNC that the device consumes or of its own RPDO, an SDO client with the same COB-ID in both directions, an EMCY consumer with the CAN-ID of a TPDO. In an EDS formulas are compared with formulas and numbers with numbers. Restricted CAN-IDs have their own rule.",
    why: "A CAN controller does not receive its own frames, and the peer that transmits to the service uses the CAN-ID of the device: two nodes transmit the same identifier, and other nodes take the data of one service for another, such as process data for SYNC.",
    example: "`[1400sub1]` and `[1800sub1]`, both with `DefaultValue=$NODEID+0x180`",
    remedy: "Give one of the services its own CAN-ID, or set bit 31 to mark it as not valid.",
    source: "CiA 301 §7.3.3, §7.3.5",
}

fn check(facts: &Facts<'_>, findings: &mut Findings) {
    let is_looked_at = |cob_id: &&CobIdUse| {
        let is_readable = cob_id.is_in_use() && cob_id.wrong_bits() == 0;
        // other rules report a missing node-ID and a restricted CAN-ID
        is_readable && facts.base_without_node_id(cob_id).is_none() && !facts.is_restricted(cob_id)
    };
    let (sent, received): (Vec<_>, Vec<_>) =
        facts.cob_ids.iter().filter(is_looked_at).partition(|cob_id| cob_id.is_sent());
    let mut pairs = BTreeSet::new();
    for transmitter in &sent {
        let same = |other: &&&CobIdUse| key(facts, other) == key(facts, transmitter);
        for receiver in received.iter().filter(same).filter(|other| !has_own_rule(facts, transmitter, other))
        {
            // both directions of a client and a server have one cause
            let objects = [transmitter.index, receiver.index];
            if pairs.insert([objects[0].min(objects[1]), objects[0].max(objects[1])]) {
                findings.push(finding(facts, transmitter, receiver));
            }
        }
    }
}

/// The key that two COB-IDs share if they collide on every node of the description.
fn key(facts: &Facts<'_>, cob_id: &CobIdUse) -> (bool, bool, u32) {
    let node = facts.device.node_id();
    let is_formula = cob_id.cob_id.depends_on_node_id() && node.is_none();
    (is_formula, cob_id.cob_id.is_extended(), cob_id.cob_id.can_id(node.unwrap_or(0)))
}

/// Whether another rule reports that the device is its own peer.
fn has_own_rule(facts: &Facts<'_>, transmitter: &CobIdUse, receiver: &CobIdUse) -> bool {
    let own = facts.device.node_id().map(i128::from);
    let client = [transmitter, receiver]
        .into_iter()
        .find(|one| matches!(one.service, Service::ClientRequest(_) | Service::ClientResponse(_)));
    let is_own_client = client.is_some_and(|client| own.is_some() && facts.number(client.index, 3) == own);
    let is_own_emcy = transmitter.service == Service::Emcy && receiver.service == Service::EmcyConsumer;
    is_own_emcy || is_own_client && transmitter.index != receiver.index
}

fn finding(facts: &Facts<'_>, transmitter: &CobIdUse, receiver: &CobIdUse) -> Diagnostic {
    let place = |cob_id: &CobIdUse| facts.device.value_place(cob_id.index, cob_id.sub);
    if transmitter.index == receiver.index {
        let message = say!("{} uses `{}` in both directions", transmitter.service, transmitter.cob_id);
        return Diagnostic::new(&RULE.info, place(receiver), message)
            .label(place(transmitter), "the other direction")
            .help("give each direction its own CAN-ID, or set bit 31 in both");
    }
    let message = say!(
        "{} transmits and {} receives with the CAN-ID `{}`",
        transmitter.service,
        receiver.service,
        transmitter.cob_id
    );
    // the mistake is probably in the entry for another node
    let is_at_receiver = receiver.service == Service::EmcyConsumer || receiver.index > transmitter.index;
    let (at, other) = if is_at_receiver { (receiver, transmitter) } else { (transmitter, receiver) };
    Diagnostic::new(&RULE.info, place(at), message)
        .label(place(other), say!("{} uses it here", other.service))
        .help("give each service its own CAN-ID, or set bit 31 to mark one of them as not valid")
}

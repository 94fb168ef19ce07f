//! Node-IDs, bit rates and CAN-IDs.

use std::collections::BTreeMap;

use super::NetworkCheck;
use crate::compiled::{PdoState, indexes};
use crate::connect::NodePdos;
use crate::diagnostic::{At, Diagnostic, Severity, say, series};
use crate::messages::{Message, MessageId, Party, Service};
use crate::model::{BaudRates, Field, Part, Place, restricted};
use crate::network::{Node, Said};
use crate::rules::{
    DUPLICATE_CAN_ID, DUPLICATE_NODE_ID, DUPLICATE_SYNC_SENDER, PDO_LENGTH, RESTRICTED_CAN_ID,
    UNSUPPORTED_BIT_RATE,
};

impl NetworkCheck<'_, '_> {
    pub(super) fn nodes(&mut self) {
        self.node_ids();
        self.bit_rates();
    }

    /// Checks the bit rate of the network, otherwise the first one stated by a DCF, against the nodes.
    fn bit_rates(&mut self) {
        let stated = |node: &Node| node.device.commissioning.as_ref()?.baud_rate.filter(|rate| *rate != 0);
        let of_node = |node: usize| At::Node(node, Place::of(Part::Commissioning).field(Field::Baudrate));
        let nodes = || self.network.nodes.iter().enumerate();
        let (rate, at, whose) = match self.network.bit_rate {
            Some(Said { value, at }) => (value, at.into(), say!("the bit rate of the network")),
            None => match nodes().find_map(|(position, node)| Some((position, node, stated(node)?))) {
                Some((position, node, rate)) => {
                    (rate, of_node(position), say!("the bit rate of `{}`", node.name.value))
                }
                None => return,
            },
        };
        if let Some(said) = self.network.bit_rate.filter(|rate| !BaudRates::DEFINED.contains(&rate.value)) {
            let message = say!("{} kbit/s is not a bit rate of CiA 301", rate);
            let finding = Diagnostic::new(&UNSUPPORTED_BIT_RATE, said.at, message).understood();
            let help = say!("use one of the bit rates in kbit/s: {}", series(BaudRates::DEFINED));
            self.findings.push(finding.help(help));
        }
        for (position, node) in self.network.nodes.iter().enumerate() {
            let info = node.device.device_info.as_ref();
            let mut rates = info.into_iter().flat_map(|info| info.baud_rates.iter());
            let refused =
                rates.find(|(known, _, is_supported)| (*known, *is_supported) == (rate, Some(false)));
            let (message, label, help) = if let Some((_, field, _)) = refused {
                (
                    say!("`{}` does not support {} kbit/s", node.name.value, rate),
                    (At::Node(position, Place::of(Part::DeviceInfo).field(field)), "not supported"),
                    say!("use a bit rate that all nodes support"),
                )
            } else if let Some(stated) = stated(node).filter(|stated| *stated != rate) {
                (
                    say!("`{}` is configured for {} kbit/s", node.name.value, stated),
                    (of_node(position), "the configured bit rate"),
                    say!("set its bit rate to {} kbit/s", rate),
                )
            } else {
                continue;
            };
            let finding = Diagnostic::new(&UNSUPPORTED_BIT_RATE, node.file.at, message);
            let finding = finding.label(at.clone(), whose.clone()).label(label.0, label.1);
            self.findings.push(finding.help(help).understood());
        }
    }

    fn node_ids(&mut self) {
        let described = self.network.nodes.iter().enumerate();
        let described = described.map(|(at, node)| (&node.name.value, node.node_id, node.node_id_origin(at)));
        let mut known: BTreeMap<u8, (Said<&str>, Option<At>)> = BTreeMap::new();
        for (name, node_id, origin) in described {
            let Some(Said { value: node_id, at }) = node_id else { continue };
            let Some((first, first_origin)) = known.get(&node_id) else {
                known.insert(node_id, (Said::new(name, at), origin));
                continue;
            };
            let message = say!("`{}` has the node-ID {} of `{}`", name, node_id, first.value);
            let finding = Diagnostic::new(&DUPLICATE_NODE_ID, at, message)
                .label(first.at, "it is used here")
                .label_each(origin.into_iter().chain(first_origin.clone()), "the node-ID");
            self.findings.push(finding.help("give one of them a different node-ID").understood());
        }
    }

    pub(super) fn can_ids(&mut self) {
        for (can_id, message) in &self.messages.0 {
            self.senders(*can_id, message);
            let senders = message.senders.iter().map(|party| (party, true));
            let parties = senders.chain(message.receivers.iter().map(|party| (party, false)));
            let is_own = |(party, is_sender): &(&Party, bool)| match party.service {
                // the PDOs of a generated description have the CAN-IDs of the nodes' PDOs
                Service::Pdo(_) => !self.network.is_made(party.node),
                // values set by the network file are checked with the rules about devices
                Service::Sync | Service::Time => self.can_id_origin(*can_id, party).is_some(),
                Service::Emcy => *is_sender && self.can_id_origin(*can_id, party).is_some(),
                _ => false,
            };
            let parties: Vec<&Party> = parties.filter(is_own).map(|(party, _)| party).collect();
            for party in parties {
                let Some(owner) = restricted(can_id.number).filter(|_| !can_id.is_extended) else { continue };
                let message = format!(
                    "{} has the CAN-ID {can_id}, which is restricted: {owner}",
                    self.described(party)
                );
                let finding = Diagnostic::new(&RESTRICTED_CAN_ID, party.at, message)
                    .label_each(self.can_id_origin(*can_id, party), "the CAN-ID");
                self.findings
                    .push(finding.help("use a CAN-ID from 181h to 57Fh or 680h to 6DFh").understood());
            }
        }
    }

    /// A CAN-ID may have only one sender. Nodes with the same node-ID share all of them, which is reported
    /// once.
    fn senders(&mut self, can_id: MessageId, message: &Message) {
        let Some((first, others)) = message.senders.split_first() else { return };
        for other in others {
            let is_general = |service| matches!(service, Service::Sync | Service::Time);
            let is_same_service = other.service == first.service && is_general(first.service);
            if self.node_id(first) == self.node_id(other)
                && (first.node != other.node
                    || first.service == other.service
                    || self.have_one_node_id(&message.receivers))
            {
                continue;
            }
            let are_clients = (first.service, other.service) == (Service::SdoRequest, Service::SdoRequest);
            // the manager is the client by rule
            let is_manager = self.network.is_manager(other.node);
            // the user knows the PDO of the node, not its counterpart in the manager
            let is_pdo = |party: &Party| matches!(party.service, Service::Pdo(_));
            let is_mirrored = self.network.is_made(first.node) && is_pdo(first) && !is_pdo(other);
            let is_swapped = are_clients && is_manager || is_mirrored;
            let (first, other) = if is_swapped { (other, first) } else { (first, other) };
            let rule = if is_same_service { &DUPLICATE_SYNC_SENDER } else { &DUPLICATE_CAN_ID };
            let message =
                format!("{} and {} both send {can_id}", self.described(first), self.described(other));
            let finding = Diagnostic::new(rule, other.at, message)
                .label(first.at, "the other sender")
                .label_each(
                    self.can_id_origin(can_id, other),
                    say!("the CAN-ID of {}", other.service.to_string()),
                )
                .label_each(
                    self.can_id_origin(can_id, first),
                    say!("the CAN-ID of {}", first.service.to_string()),
                );
            let help = if are_clients {
                "give one of the clients its own channel (1280h), which the node also has in 1201h"
            } else if self.network.is_made(first.node) && first.node == other.node && is_pdo(first) {
                "give each RPDO that receives it its own CAN-ID"
            } else {
                "give one of them a different CAN-ID, or switch it off"
            };
            self.findings.push(finding.help(help).understood());
        }
    }

    /// Whether several nodes among these have the same node-ID.
    fn have_one_node_id(&self, parties: &[Party]) -> bool {
        let Some((first, others)) = parties.split_first() else { return false };
        others.iter().any(|other| other.node != first.node && self.node_id(other) == self.node_id(first))
    }

    fn node_id(&self, party: &Party) -> Option<u8> {
        self.network.nodes[party.node].node_id.map(|node_id| node_id.value)
    }

    /// The place of the mapping of a party's PDO in the description.
    fn mapping_origin(&self, party: &Party) -> Option<At> {
        let Service::Pdo(pdo) = party.service else { return None };
        self.compiled.node(party.node)?.origin(self.network, indexes(pdo).1, 0)
    }

    /// Possible remedies for a receiver that uses only the first bytes.
    fn remedy(&self, receiver: &Party, received: &PdoState, sent: &PdoState) -> &'static str {
        let node = NodePdos::of(&self.network.nodes[receiver.node], self.compiled.node(receiver.node));
        match node.has_room(received.pdo, sent.bits() - received.bits()) {
            true => "fill the rest with dummies",
            false => "send fewer entries: the RPDO has no room for dummies",
        }
    }

    /// Whether receivers of a PDO get all mapped bytes. A receiver that maps fewer uses the first ones.
    pub(super) fn pdo_lengths(&mut self) {
        for message in self.messages.0.values() {
            // several senders are an error
            let [sender] = message.senders.as_slice() else { continue };
            let Some(sent) = self.compiled.pdo(sender) else { continue };
            for receiver in &message.receivers {
                let Some(received) =
                    self.compiled.pdo(receiver).filter(|state| state.bytes() != sent.bytes())
                else {
                    continue;
                };
                let text = format!(
                    "{} maps {} bits of the {} that {} sends",
                    self.described(receiver),
                    received.bits(),
                    sent.bits(),
                    self.described(sender)
                );
                let finding = Diagnostic::new(&PDO_LENGTH, receiver.at, text)
                    .label(sender.at, "the sender")
                    .label_each(self.mapping_origin(receiver), say!("{} bits are mapped", received.bits()))
                    .label_each(self.mapping_origin(sender), say!("{} bits are mapped", sent.bits()))
                    .understood();
                self.findings.push(match received.bytes() > sent.bytes() {
                    true => {
                        finding.help("map fewer entries: the node does not process a PDO that is too short")
                    }
                    false => finding.severity(Severity::Warning).help(self.remedy(receiver, received, sent)),
                });
            }
        }
    }
}

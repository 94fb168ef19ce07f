//! PDOs that no other node sends or receives.

use std::collections::BTreeMap;

use crate::compiled::{Compiled, Slave, indexes};
use crate::configure::PdoName;
use crate::messages::{MessageId, Messages, Party, Service};
use crate::model::{Object, PdoKind};
use crate::network::Network;
use crate::source::Span;

/// A PDO without a counterpart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UnlinkedPdo {
    pub(crate) can_id: MessageId,
    pub(crate) pdo: PdoName,
    pub(crate) party: Party,
}

/// The PDOs without a counterpart.
#[derive(Default)]
pub(crate) struct UnlinkedPdos {
    /// Those that the network file or a DCF configures, by CAN-ID.
    pub(crate) configured: Vec<UnlinkedPdo>,
    /// Those with the default configuration of their description, by node and direction.
    pub(crate) default: BTreeMap<(usize, PdoKind), Vec<UnlinkedPdo>>,
}

impl UnlinkedPdos {
    pub(crate) fn new(network: &Network, compiled: &Compiled, messages: &Messages) -> Self {
        let mut unlinked = Self::default();
        for (can_id, message) in &messages.0 {
            let ((parties, []) | ([], parties)) = (message.senders.as_slice(), message.receivers.as_slice())
            else {
                continue;
            };
            for party in parties {
                let Service::Pdo(pdo) = party.service else { continue };
                let found = UnlinkedPdo { can_id: *can_id, pdo, party: *party };
                let slave = compiled.node(party.node);
                match slave.is_some_and(|slave| slave.configures(network, pdo)) {
                    true => unlinked.configured.push(found),
                    false => unlinked.default.entry((party.node, pdo.kind)).or_default().push(found),
                }
            }
        }
        unlinked
    }
}

impl Slave {
    /// The position of a PDO's settings in the network file.
    pub(crate) fn stated(&self, network: &Network, pdo: PdoName) -> Option<Span> {
        let (communication, mapping) = indexes(pdo);
        let request = network.nodes[self.node].pdos.iter().find(|request| request.pdo == pdo);
        let said = |index: u16| self.origins.range((index, 0)..=(index, u8::MAX)).map(|(_, at)| *at).next();
        request.map(|request| request.at).or_else(|| said(communication)).or_else(|| said(mapping))
    }

    /// Whether the network file has settings for a PDO, or one of its values differs from the default.
    fn configures(&self, network: &Network, pdo: PdoName) -> bool {
        let (communication, mapping) = indexes(pdo);
        let is_changed = |index: u16| {
            let entries = self.device.object(index).into_iter().flat_map(Object::entries);
            entries.into_iter().any(|(_, entry)| entry.is_changed(Some(self.node_id)))
        };
        self.stated(network, pdo).is_some() || is_changed(communication) || is_changed(mapping)
    }
}

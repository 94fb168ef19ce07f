//! The users of each CAN-ID, from the dictionaries of the nodes.

use std::cell::OnceCell;

use objdict_network::Service;

use super::signals::PdoContent;
use super::stale::Stale;
use super::talker::TalkingNode;
use crate::model::{CobId, PdoKind, SdoChannel, predefined};

/// A CAN-ID as a number: bit 31 marks 29 bits.
pub(super) type IdKey = u32;

pub(super) const fn key(can_id: u32, is_extended: bool) -> IdKey {
    if is_extended { can_id | 1 << 31 } else { can_id }
}

/// A node that uses a CAN-ID.
#[derive(Debug)]
pub(super) struct CanIdUser {
    pub(super) node_id: u8,
    pub(super) service: Service,
    /// The number of an SDO channel, from 2 on.
    pub(super) channel: u16,
    /// The content of a PDO, once one of its frames was seen.
    content: OnceCell<PdoContent>,
}

impl CanIdUser {
    /// The content of a PDO of the node.
    pub(super) fn content(&self, node: &TalkingNode<'_>) -> &PdoContent {
        self.content.get_or_init(|| match self.service {
            Service::Pdo(pdo) => {
                let pdo = node.device.pdo(pdo.kind, pdo.number);
                pdo.map(|pdo| PdoContent::new(node, &pdo)).unwrap_or_default()
            }
            _ => PdoContent::default(),
        })
    }
}

/// The services with CAN-IDs that nodes configure, by CAN-ID.
#[derive(Debug, Default)]
pub(super) struct Users(Vec<(IdKey, CanIdUser)>);

impl Users {
    /// The users of a CAN-ID, and the sender: a TPDO before RPDOs.
    pub(super) fn of(&self, key: IdKey) -> Option<(usize, &CanIdUser)> {
        let is_rpdo = |service| matches!(service, Service::Pdo(pdo) if pdo.kind == PdoKind::Rpdo);
        self.all(key).enumerate().min_by_key(|(_, user)| is_rpdo(user.service))
    }

    /// All users of a CAN-ID.
    pub(super) fn all(&self, key: IdKey) -> impl Iterator<Item = &CanIdUser> {
        let start = self.0.partition_point(|(other, _)| *other < key);
        let users = self.0[start..].iter().take_while(move |(other, _)| *other == key);
        users.map(|(_, user)| user)
    }

    /// Updates services of a node to their current state.
    pub(super) fn update(&mut self, node: &TalkingNode<'_>, stale: Stale) {
        let is_stale = |user: &CanIdUser| user.node_id == node.node_id && stale.has(user.service);
        if let Stale::Content(kind, number) = stale {
            let mut known = self.0.iter_mut().filter(|(_, user)| is_stale(user)).peekable();
            if known.peek().is_none() {
                self.add_pdo(node, kind, number, node.device.pdo_cob_id(kind, number));
                return;
            }
            known.for_each(|(_, user)| drop(user.content.take()));
            return;
        }
        self.0.retain(|(_, user)| !is_stale(user));
        match stale {
            Stale::Pdo(kind, number) => {
                self.add_pdo(node, kind, number, node.device.pdo_cob_id(kind, number));
            }
            Stale::Others => self.add_services(node),
            Stale::All => {
                self.add_services(node);
                node.device.pdos().for_each(|pdo| self.add_pdo(node, pdo.kind, pdo.number, pdo.cob_id));
            }
            Stale::Content(..) => {}
        }
    }

    fn add_pdo(&mut self, node: &TalkingNode<'_>, kind: PdoKind, number: u16, cob_id: Option<CobId>) {
        // for a node without a description, a log may contain only the mapping
        let default = || {
            let base = kind.predefined_can_id(number).filter(|_| !node.is_described)?;
            node.device.pdo(kind, number)?.mapped_count.filter(|count| *count > 0)?;
            Some(predefined::per_node(base))
        };
        let cob_id = cob_id.or_else(default);
        self.add(node, cob_id.filter(|cob_id| cob_id.is_valid()), Service::pdo(kind, number), 0);
    }

    fn add_services(&mut self, node: &TalkingNode<'_>) {
        let services = node.device.services();
        let mut add = |cob_id, service, channel| self.add(node, cob_id, service, channel);
        add(services.sync.or(Some(CobId::new(predefined::SYNC.into()))), Service::Sync, 0);
        add(services.time.or(Some(CobId::new(predefined::TIME.into()))), Service::Time, 0);
        let emcy = services.emcy.or(Some(predefined::per_node(predefined::EMCY)));
        add(emcy.filter(|emcy| emcy.is_valid()), Service::Emcy, 0);
        let servers = services.sdo_servers.iter().filter(|server| server.number > 1);
        for SdoChannel { number, request, response, .. } in servers {
            // a channel is disabled as soon as one of its COB-IDs is (CiA 301 §7.5.2.33)
            if [request, response].iter().all(|cob_id| cob_id.is_some_and(CobId::is_valid)) {
                add(*request, Service::SdoRequest, *number);
                add(*response, Service::SdoResponse, *number);
            }
        }
    }

    fn add(&mut self, node: &TalkingNode<'_>, cob_id: Option<CobId>, service: Service, channel: u16) {
        let Some(cob_id) = cob_id else { return };
        let key = key(cob_id.can_id(node.node_id), cob_id.is_extended());
        if key != 0 {
            let user = CanIdUser { node_id: node.node_id, service, channel, content: OnceCell::new() };
            let place = self.0.partition_point(|(other, _)| *other <= key);
            self.0.insert(place, (key, user));
        }
    }
}

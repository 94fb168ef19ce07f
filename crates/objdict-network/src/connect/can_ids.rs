//! CAN-IDs: those in use, and those that are free for links.

use std::collections::{HashMap, HashSet};

use crate::compiled::Compiled;
use crate::configure::PdoName;
use crate::model::{CobId, PdoKind, restricted};
use crate::{Messages, Network, Node, Service};

/// A sender or receiver of a CAN-ID.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum User {
    /// A PDO of a node.
    Pdo(usize, PdoName),
    /// Another service.
    Service,
}

/// The CAN-IDs of a network.
#[derive(Default)]
pub(super) struct CanIds {
    users: HashMap<u32, Vec<User>>,
    /// CAN-IDs that links require.
    demanded: HashSet<u32>,
    /// CAN-IDs that PDOs of the network had in an earlier build.
    locked: HashSet<u32>,
    /// The free ranges in order of use.
    pool: Vec<u32>,
}

impl CanIds {
    pub(super) fn new(network: &Network, compiled: &Compiled) -> Self {
        let mut ids = Self::default();
        ids.demanded.extend(network.links.iter().filter_map(|link| link.parameters.can_id));
        ids.locked.extend(network.lock.can_ids());
        for slave in compiled.nodes() {
            for state in slave.pdos.iter().filter(|state| state.cob_id & CobId::BIT_31 == 0) {
                ids.add(state.can_id().number, User::Pdo(slave.node, state.pdo));
            }
        }
        for (can_id, message) in &Messages::new(network, compiled).0 {
            for party in message.senders.iter().chain(&message.receivers) {
                if !matches!(party.service, Service::Pdo(_)) {
                    ids.add(can_id.number, User::Service);
                }
            }
        }
        let manager = network.manager.as_ref();
        if let Some(time) = manager.and_then(|manager| manager.time_cob_id) {
            ids.add(plain(time.value), User::Service);
        }
        let own = manager.and_then(|manager| manager.node_id);
        let nodes = network.nodes.iter().filter_map(|node| node.node_id).chain(own);
        let nodes: HashSet<u32> = nodes.map(|said| said.value.into()).collect();
        // CAN-IDs that future nodes may need are used last
        let unused = (0x181..=0x57F).rev().filter(|id| !nodes.contains(&(id & 0x7F)));
        ids.pool = SHARED.chain([0x580, 0x600, 0x700]).chain(unused).collect();
        ids.pool.reverse();
        ids
    }

    pub(super) fn add(&mut self, can_id: u32, user: User) {
        self.users.entry(can_id).or_default().push(user);
    }

    /// Removes a user that no longer uses the CAN-ID.
    pub(super) fn release(&mut self, can_id: u32, user: User) {
        if let Some(users) = self.users.get_mut(&can_id) {
            users.retain(|other| *other != user);
        }
    }

    /// The sender's CAN-ID in an earlier build, unless it has a different sender, a link requires it, or no
    /// PDO may use it.
    pub(super) fn keep(&self, locked: Option<u32>) -> Option<u32> {
        let is_possible = |id: &u32| restricted(*id).is_none() && !self.demanded.contains(id);
        locked.filter(|id| is_possible(id) && self.sender(*id).is_none())
    }

    /// The predefined CAN-ID of a sender unless it has a different sender, otherwise the first free one of these
    /// CAN-IDs, otherwise one of the free ranges.
    pub(super) fn choose(
        &mut self,
        of_sender: Option<u32>,
        preferred: impl IntoIterator<Item = u32>,
    ) -> Option<u32> {
        let is_sent = |id: &u32| self.sender(*id).is_some();
        let own = of_sender.filter(|id| !self.is_reserved(*id) && !is_sent(id));
        let free = own.or_else(|| preferred.into_iter().find(|id| self.is_free(*id)));
        free.or_else(|| {
            while let Some(id) = self.pool.pop() {
                if self.is_free(id) {
                    return Some(id);
                }
            }
            None
        })
    }

    /// Who sends or receives a CAN-ID.
    pub(super) fn users(&self, can_id: u32) -> impl Iterator<Item = User> + '_ {
        self.users.get(&can_id).into_iter().flatten().copied()
    }

    /// Who sends a CAN-ID.
    pub(super) fn sender(&self, can_id: u32) -> Option<User> {
        let is_sender = |user: &User| !matches!(user, User::Pdo(_, pdo) if pdo.kind == PdoKind::Rpdo);
        self.users(can_id).find(is_sender)
    }

    fn is_reserved(&self, can_id: u32) -> bool {
        restricted(can_id).is_some() || self.demanded.contains(&can_id) || self.locked.contains(&can_id)
    }

    fn is_free(&self, can_id: u32) -> bool {
        !self.is_reserved(can_id) && self.users.get(&can_id).is_none_or(Vec::is_empty)
    }
}

/// The range that CiA 301 does not assign to a service; PDOs with the CAN-ID `auto` also use it.
const SHARED: std::ops::RangeInclusive<u32> = 0x680..=0x6DF;

/// The CAN-ID of a COB-ID without flags.
pub(super) const fn plain(cob_id: u32) -> u32 {
    let cob_id = CobId::new(cob_id);
    cob_id.number() & cob_id.can_id_mask()
}

/// The CAN-ID of a PDO in the predefined connection set.
pub(super) fn predefined(node: &Node, pdo: PdoName) -> Option<u32> {
    let base = pdo.kind.predefined_can_id(pdo.number)?;
    Some(u32::from(base) + u32::from(node.node_id?.value))
}

/// The COB-ID on a node; `None` if it depends on a node-ID that is unknown.
pub(super) fn on_node(cob_id: CobId, node_id: Option<u8>) -> Option<u32> {
    match node_id {
        Some(node_id) => Some(cob_id.on_node(node_id)),
        None => Some(cob_id.number()).filter(|_| !cob_id.depends_on_node_id()),
    }
}

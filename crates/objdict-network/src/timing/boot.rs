//! The duration of the nodes' configuration.

use super::{sdo_bits, sdo_requests};
use crate::compiled::{Compiled, Slave};
use crate::network::Network;

/// The manager's time for configuring the nodes. Times are in nanoseconds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BootTimes {
    /// The time that mandatory nodes have (1F89h); 0: no limit.
    pub limit: u64,
    /// The nodes that the manager configures.
    pub nodes: Vec<NodeBootTime>,
}

/// The time for configuring a node. Times are in nanoseconds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NodeBootTime {
    /// The name of the node.
    pub name: String,
    /// Its node-ID.
    pub node_id: u8,
    /// Whether the network does not start without the node.
    pub is_mandatory: bool,
    /// The number of downloads.
    pub downloads: usize,
    /// The time of their frames, each with maximum bit stuffing.
    pub bus: u64,
    /// As above, plus the node's response times.
    pub total: u64,
}

impl BootTimes {
    pub(super) fn new(
        network: &Network,
        compiled: &Compiled,
        bit_rate: u16,
        response_time: u64,
    ) -> Option<Self> {
        let manager = network.manager.as_ref()?;
        let booted = compiled.slaves.iter().filter(|slave| network.nodes[slave.node].boot.boot);
        let nodes = booted.map(|slave| NodeBootTime::new(network, slave, bit_rate, response_time));
        let limit = u64::from(manager.boot_time.value) * super::frames::MILLISECOND;
        Some(Self { limit, nodes: nodes.collect() })
    }

    /// The frames of all nodes in sequence.
    pub fn bus(&self) -> u64 {
        self.nodes.iter().map(|node| node.bus).sum()
    }

    /// Whether a node may exceed the boot time.
    pub fn is_late(&self, node: &NodeBootTime) -> bool {
        node.is_mandatory && self.limit != 0 && node.total > self.limit
    }
}

impl NodeBootTime {
    fn new(network: &Network, slave: &Slave, bit_rate: u16, response_time: u64) -> Self {
        let node = &network.nodes[slave.node];
        let downloads = &slave.arranged_or_stated().0;
        let sizes = || downloads.iter().map(|download| download.data.len());
        let bits: u64 = sizes().map(sdo_bits).sum();
        let bus = (bits * 1_000_000).div_ceil(bit_rate.max(1).into());
        Self {
            name: node.name.value.clone(),
            node_id: slave.node_id,
            is_mandatory: node.boot.mandatory,
            downloads: downloads.len(),
            bus,
            total: bus + sizes().map(sdo_requests).sum::<u64>() * response_time,
        }
    }
}

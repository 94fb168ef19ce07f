//! A network compared with its description.

use objdict_bus::Abort;
use objdict_node::download::{Download, remaining};

use crate::client::{BusClient, ClientError, unless_refused};
use crate::safety::OtherIdentity;
use crate::scan::ScannedNode;

/// A node as a network describes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExpectedNode {
    /// The node-ID.
    pub node_id: u8,
    /// Device type, vendor-ID, product code, revision number, serial number; 0 where not stated.
    pub identity: [u32; 5],
    /// The values that configure it; of several of one entry the last one counts.
    pub values: Vec<Download>,
    /// The NMT state; `None` for any.
    pub state: Option<u8>,
}

/// A difference between a network and its description.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NodeDifference {
    /// The node is not on the bus.
    Missing,
    /// The node is not in the description.
    Extra,
    /// It is another device.
    Identity(OtherIdentity),
    /// An entry has another value: described and found.
    Value(u16, u8, Vec<u8>, Vec<u8>),
    /// An entry cannot be read.
    Unreadable(u16, u8, Abort),
    /// The node is in another state, or sends none.
    State(u8, Option<u8>),
    /// The node sends no heartbeat, but has this period in milliseconds.
    NoHeartbeat(u16),
}

/// Whether a heartbeat with this period in milliseconds should have been heard twice in so many microseconds.
pub fn is_heartbeat_due(period: u64, time: u64) -> bool {
    period > 0 && time >= period.saturating_mul(2000)
}

impl BusClient {
    /// Compares nodes that were found with those that a network describes; each difference with the node-ID.
    ///
    /// # Errors
    /// When the adapter is lost, another client interferes, a node stops to answer or the user interrupts.
    pub fn compare(
        &mut self,
        wanted: &[ExpectedNode],
        found: &[ScannedNode],
    ) -> Result<Vec<(u8, NodeDifference)>, ClientError> {
        let mut differences = Vec::new();
        for node in found {
            if wanted.iter().all(|wanted| wanted.node_id != node.node_id) {
                differences.push((node.node_id, NodeDifference::Extra));
            }
        }
        for node in wanted {
            match found.iter().find(|found| found.node_id == node.node_id && found.answers) {
                Some(found) => self.compare_node(node, found, &mut differences)?,
                None => differences.push((node.node_id, NodeDifference::Missing)),
            }
        }
        differences.sort_by_key(|(node_id, _)| *node_id);
        Ok(differences)
    }

    fn compare_node(
        &mut self,
        wanted: &ExpectedNode,
        found: &ScannedNode,
        differences: &mut Vec<(u8, NodeDifference)>,
    ) -> Result<(), ClientError> {
        let node_id = wanted.node_id;
        let own = std::iter::once(found.device_type).chain(found.identity);
        let places = [(0x1000, 0), (0x1018, 1), (0x1018, 2), (0x1018, 3), (0x1018, 4)];
        for (((index, sub), found), expected) in places.into_iter().zip(own).zip(wanted.identity) {
            if expected != 0 && found != Some(expected) {
                let other = OtherIdentity { index, sub, expected, found };
                differences.push((node_id, NodeDifference::Identity(other)));
            }
        }
        for (Download { index, sub, data }, remains) in wanted.values.iter().zip(remaining(&wanted.values)) {
            if !remains {
                continue;
            }
            match self.upload(node_id, *index, *sub) {
                Ok(bytes) if bytes == *data => {}
                Ok(bytes) => {
                    differences.push((node_id, NodeDifference::Value(*index, *sub, data.clone(), bytes)));
                }
                Err(ClientError::Refused { abort, .. }) => {
                    differences.push((node_id, NodeDifference::Unreadable(*index, *sub, abort)));
                }
                Err(error) => return Err(error),
            }
        }
        let state = self.states().get(&node_id).copied().flatten();
        if state.is_none() && wanted.values.iter().any(|value| value.entry() == (0x1017, 0)) {
            let period = unless_refused(self.number(node_id, 0x1017, 0))?
                .and_then(|period| u16::try_from(period).ok());
            let due = period.filter(|period| is_heartbeat_due((*period).into(), self.now()));
            differences.extend(due.map(|period| (node_id, NodeDifference::NoHeartbeat(period))));
        }
        if let Some(wanted) = wanted.state.filter(|wanted| state != Some(*wanted)) {
            differences.push((node_id, NodeDifference::State(wanted, state)));
        }
        Ok(())
    }
}

//! Which nodes are on a bus.

use std::ops::RangeInclusive;

use objdict_bus::Frame;

use crate::client::{BusClient, ClientError};

/// The time between two requests to different nodes, in microseconds.
const GAP: u64 = 1000;

/// A node on a bus.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct ScannedNode {
    /// The node-ID.
    pub node_id: u8,
    /// The NMT state, as in a heartbeat; `None` if the node sent none.
    pub state: Option<u8>,
    /// Whether its SDO server answers.
    pub answers: bool,
    /// The device type (1000h).
    pub device_type: Option<u32>,
    /// Vendor-ID, product code, revision number and serial number (1018h).
    pub identity: [Option<u32>; 4],
}

impl BusClient {
    /// Finds the nodes with these node-IDs that were heard, or that answer within so many milliseconds; then reads their identity.
    ///
    /// # Errors
    /// When the adapter is lost, another client interferes or the user interrupts. What a node refuses is unknown.
    pub fn scan(
        &mut self,
        ids: RangeInclusive<u8>,
        milliseconds: u64,
    ) -> Result<Vec<ScannedNode>, ClientError> {
        if !self.is_replay() {
            for node_id in ids.clone() {
                self.require_own(node_id)?;
                // the answer has four bytes, so the transfer ends with it
                let request = [0x40, 0, 0x10, 0, 0, 0, 0, 0];
                if let Some(frame) = Frame::new(0x600 + u16::from(node_id), &request) {
                    self.send(&frame.into())?;
                }
                let until = self.now() + GAP;
                while self.next_frame(until)?.is_some() {}
            }
            self.listen(milliseconds)?;
        }
        let heard: Vec<u8> = self.states().keys().copied().filter(|id| ids.contains(id)).collect();
        heard.into_iter().map(|node_id| self.found(node_id)).collect()
    }

    /// The identity and state of a node.
    fn found(&mut self, node_id: u8) -> Result<ScannedNode, ClientError> {
        let mut node = ScannedNode { node_id, ..ScannedNode::default() };
        if !self.is_replay() {
            (node.answers, node.device_type) = self.stated(node_id, 0x1000, 0)?;
            for sub in 1..=4_u8 {
                if node.answers {
                    node.identity[usize::from(sub) - 1] = self.stated(node_id, 0x1018, sub)?.1;
                }
            }
        }
        node.state = self.states().get(&node_id).copied().flatten();
        Ok(node)
    }

    /// Whether a node answers, and a number of it.
    pub(crate) fn stated(
        &mut self,
        node_id: u8,
        index: u16,
        sub: u8,
    ) -> Result<(bool, Option<u32>), ClientError> {
        match self.number(node_id, index, sub) {
            Ok(number) => Ok((true, u32::try_from(number).ok())),
            Err(ClientError::Refused { .. } | ClientError::NoNumber { .. }) => Ok((true, None)),
            Err(ClientError::Silent { .. }) => Ok((false, None)),
            Err(error) => Err(error),
        }
    }
}

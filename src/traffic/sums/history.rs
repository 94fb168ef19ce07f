//! The first events of a kind; more are counted.

use serde::Serialize;

use crate::format::log::LogTime;

/// The most events that are kept.
const MAX_EVENTS: usize = 1000;

/// An event of a node.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct NodeEvent {
    /// When it happened, in seconds with the digits of the log.
    pub(crate) time: String,
    /// The node-ID.
    pub(crate) node: u8,
    /// What happened.
    pub(crate) text: String,
}

/// Events in their order.
#[derive(Debug, Default)]
pub(super) struct History {
    pub(super) events: Vec<NodeEvent>,
    pub(super) count: u64,
}

impl History {
    /// Adds an event, whose text is made if it is kept.
    pub(super) fn add(&mut self, time: LogTime, node: u8, text: impl FnOnce() -> String) {
        self.count += 1;
        if self.events.len() < MAX_EVENTS {
            self.events.push(NodeEvent { time: time.to_string(), node, text: text() });
        }
    }
}

//! The sums of a bus as rows of tables.

use super::{BusReport, NodeEvent};

/// The headings of the nodes.
pub(crate) const NODES: [&str; 10] =
    ["Node", "Name", "Frames", "Frames/s", "Load", "State", "Boot-ups", "Lost", "EMCY", "Aborts"];

/// The headings of the messages.
pub(crate) const MESSAGES: [&str; 8] =
    ["CAN-ID", "Message", "Frames", "Min ms", "Mean ms", "Max ms", "Jitter ms", "Described"];

impl BusReport {
    /// Such as: 120 frames from 0.1 to 2.2, 57.1 frames/s, 12.50 % load
    pub(crate) fn sentence(&self) -> String {
        let load = self.load.map_or_else(String::new, |load| format!(", {load:.2} % load"));
        let (from, to, rate) = (&self.from, &self.to, self.frames_per_second);
        let frames = if self.frames == 1 { "frame" } else { "frames" };
        format!("{} {frames} from {from} to {to}, {rate:.1} frames/s{load}", self.frames)
    }

    pub(crate) fn node_rows(&self) -> impl Iterator<Item = [String; NODES.len()]> {
        let some = |count: u64| if count == 0 { String::new() } else { count.to_string() };
        self.nodes.iter().map(move |node| {
            [
                if node.node == 0 { "-".to_owned() } else { node.node.to_string() },
                node.name.clone().unwrap_or_default(),
                node.frames.to_string(),
                format!("{:.1}", node.frames_per_second),
                node.load.map_or_else(String::new, |load| format!("{load:.2} %")),
                node.state.clone().unwrap_or_default(),
                some(node.boot_ups),
                some(node.lost_heartbeats),
                some(node.emergencies),
                some(node.aborted_transfers),
            ]
        })
    }

    pub(crate) fn message_rows(&self) -> impl Iterator<Item = [String; MESSAGES.len()]> {
        self.messages.iter().map(|message| {
            let width = if message.extended { 8 } else { 3 };
            let name = if message.name.is_empty() { message.kind } else { &message.name };
            let [min, mean, max, jitter] = match &message.cycle {
                Some(cycle) => [&cycle.min, &cycle.mean, &cycle.max, &cycle.jitter].map(Clone::clone),
                None => Default::default(),
            };
            let described = message.described.clone().unwrap_or_default();
            let id = format!("{:0width$X}", message.can_id);
            [id, name.to_owned(), message.frames.to_string(), min, mean, max, jitter, described]
        })
    }

    /// The events by their titles.
    pub(crate) fn events(&self) -> [(&'static str, &[NodeEvent]); 4] {
        [
            ("Lost heartbeats", &self.lost_heartbeats),
            ("Aborted transfers", &self.aborted_transfers),
            ("Emergencies", &self.emergencies),
            ("Not as described", &self.deviations),
        ]
    }
}

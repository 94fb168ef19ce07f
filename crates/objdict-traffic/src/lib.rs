//! What a bus carries, in words and in sums: the frames of logs with the descriptions of the nodes.

mod against;
mod candidates;
mod described;
mod error_frame;
mod history;
mod incident;
mod line;
pub mod log;
mod merged;
pub mod probe;
mod recording;
mod sight;
mod sums;

use std::io::{self, BufRead};

pub use self::against::findings;
use self::candidates::Candidates;
pub use self::described::{DescribedNode, Descriptions};
pub use self::history::NodeEvent;
pub use self::incident::{Incident, IncidentState, verdict};
pub use self::line::FrameDocument;
pub use self::line::digits;
pub use self::merged::{MergedLogs, NamedLog, Origin};
pub use self::recording::{PageTexts, PlotChoice, Recording, address};
pub use self::sums::{BusReport, BusSums, incidents};
use crate::log::LoggedFrame;
use objdict_document::describe::frames::{DecodedFrame, FrameReader, RawFrame};
pub use objdict_lint::recorded::traffic::RULES;

/// The NMT state of a node that has sent its boot-up message.
const PRE_OPERATIONAL: u8 = 0x7F;

/// The most buses.
const MAX_BUSES: usize = 64;

/// A bus: what is known of its nodes, and where its frames are.
#[derive(Debug)]
pub struct Bus<'d> {
    /// The name of its channel in the logs; empty if it has none.
    pub channel: String,
    /// Reads the frames.
    pub reader: FrameReader<'d>,
    /// The descriptions of the nodes.
    pub descriptions: &'d Descriptions,
    candidates: Candidates<'d>,
    /// The nodes that were found for descriptions without a node-ID.
    pub found: Vec<(u8, &'d DescribedNode)>,
}

impl<'d> Bus<'d> {
    fn new(channel: &str, descriptions: &'d Descriptions) -> Self {
        let talkers = descriptions.nodes.iter().filter_map(|node| Some(node.talker(node.node_id?)));
        let mut reader = FrameReader::of_bus(talkers.collect());
        if let Some(profile) = descriptions.profile {
            reader.assume_profile(profile);
        }
        let (candidates, found) = (Candidates::new(descriptions), Vec::new());
        Self { channel: channel.to_owned(), reader, descriptions, candidates, found }
    }

    fn describe(&mut self, node_id: u8, node: &'d DescribedNode) {
        self.reader.describe(node.talker(node_id));
        self.found.push((node_id, node));
    }

    /// What a frame is. With it descriptions may find their nodes.
    pub fn decode(&mut self, frame: &LoggedFrame) -> DecodedFrame {
        let Some(observed) = observed(frame) else { return DecodedFrame::UNKNOWN };
        let decoded = self.reader.decode(&observed);
        if self.candidates.is_open() {
            self.candidates.take(&decoded, &self.reader);
        }
        decoded
    }

    /// Describes the nodes that descriptions without a node-ID are for; with `is_all` nothing more is to come.
    pub fn assign(&mut self, is_all: bool) -> Vec<String> {
        let mut notes = Vec::new();
        // each frame asks
        if !self.candidates.is_open() {
            return notes;
        }
        for (node_id, description, note) in self.candidates.found(is_all, &self.reader) {
            if let Some(node) = description {
                self.describe(node_id, node);
            }
            notes.extend(note);
        }
        notes
    }

    /// The bus before its first frame, with the nodes that were found.
    fn again(&self) -> Self {
        let mut bus = Self::new(&self.channel, self.descriptions);
        self.found.iter().for_each(|(node_id, node)| bus.describe(*node_id, node));
        bus.candidates.close();
        bus
    }

    /// The description of a node.
    pub fn description(&self, node_id: u8) -> Option<&'d DescribedNode> {
        let stated = self.descriptions.nodes.iter().find(|node| node.node_id == Some(node_id));
        let found = || self.found.iter().find(|(found, _)| *found == node_id).map(|(_, node)| *node);
        stated.or_else(found)
    }

    /// What a frame says.
    pub fn words(&self, decoded: &DecodedFrame, frame: &LoggedFrame) -> String {
        match frame {
            LoggedFrame { is_error: true, .. } => error_frame::words(frame),
            LoggedFrame { is_fd: true, .. } => format!("CAN FD, {} bytes", frame.data().len()),
            _ => self.reader.words(decoded, &raw(frame)),
        }
    }
}

/// The frame as CANopen sees it.
pub fn raw(frame: &LoggedFrame) -> RawFrame<'_> {
    let LoggedFrame { can_id, is_extended, is_remote, .. } = *frame;
    RawFrame { can_id, is_extended, is_remote, data: frame.data() }
}

/// The frame, if it is one of CANopen.
pub(crate) fn observed(frame: &LoggedFrame) -> Option<RawFrame<'_>> {
    (!frame.is_error && !frame.is_fd).then(|| raw(frame))
}

/// The buses in logs, by the names of their channels.
#[derive(Debug)]
pub struct Buses<'d> {
    /// What describes the nodes of a channel.
    by_channel: &'d [(String, Descriptions)],
    /// What describes those of the other channels.
    others: &'d Descriptions,
    /// The buses, in the order of their first frames.
    pub all: Vec<Bus<'d>>,
    /// The position of the bus by the log and the number of its channel.
    positions: Vec<Vec<Option<usize>>>,
}

impl<'d> Buses<'d> {
    /// Buses whose nodes are described by channel, or for all channels.
    pub fn new(by_channel: &'d [(String, Descriptions)], others: &'d Descriptions) -> Self {
        Self { by_channel, others, all: Vec::new(), positions: Vec::new() }
    }

    /// The position of the bus of a frame.
    pub fn of<R: BufRead>(&mut self, log: usize, frame: &LoggedFrame, logs: &MergedLogs<R>) -> usize {
        let number = usize::from(frame.channel);
        if self.positions.len() <= log {
            self.positions.resize(log + 1, Vec::new());
        }
        let positions = &mut self.positions[log];
        if positions.len() <= number {
            positions.resize(number + 1, None);
        }
        *positions[number].get_or_insert_with(|| {
            let channel = logs.channel(log, frame.channel);
            let known = self.all.iter().position(|bus| bus.channel == channel);
            known.unwrap_or_else(|| {
                let own = self.by_channel.iter().find(|(name, _)| name == channel);
                let descriptions = own.map_or(self.others, |(_, descriptions)| descriptions);
                if self.all.len() < MAX_BUSES {
                    self.all.push(Bus::new(channel, descriptions));
                }
                self.all.len() - 1
            })
        })
    }

    /// Whether a description waits for the node that it is for.
    pub fn is_open(&self) -> bool {
        let open = |descriptions: &Descriptions| descriptions.nodes.iter().any(|node| node.node_id.is_none());
        open(self.others) || self.by_channel.iter().any(|(_, descriptions)| open(descriptions))
    }

    /// Reads all frames of logs to find the nodes of descriptions without a node-ID, and says what was found. The frames are
    /// read again by buses that know it.
    pub fn find<R: BufRead>(&mut self, logs: &mut MergedLogs<R>) -> io::Result<Vec<String>> {
        while let Some((log, frame)) = logs.next_frame()? {
            let at = self.of(log, &frame, logs);
            self.all[at].decode(&frame);
        }
        let notes = self.all.iter_mut().flat_map(|bus| bus.assign(true)).collect();
        let read = std::mem::take(&mut self.all);
        self.all = read.iter().map(Bus::again).collect();
        Ok(notes)
    }
}

#[cfg(test)]
mod tests;

//! What nodes send over time.

use std::collections::BTreeMap;

use super::{Meanings, Series};
use crate::describe::frames::{DecodedFrame, FrameKind, nmt_state};
use crate::format::log::LoggedFrame;
use crate::traffic::PRE_OPERATIONAL;

/// What a node sends; node-ID 0 has the frames of no node, such as SYNC, NMT and the requests of SDO clients.
#[derive(Debug)]
pub(crate) struct Lane {
    pub(crate) frames: BTreeMap<&'static str, Series>,
    /// Its NMT states.
    pub(crate) states: Meanings,
}

/// The lanes of nodes, by the position of their bus and their node-IDs.
#[derive(Debug)]
pub(crate) struct Lanes {
    /// The most marks of a kind.
    limit: usize,
    pub(crate) all: BTreeMap<(usize, u8), Lane>,
}

impl Lanes {
    pub(crate) fn new(limit: usize) -> Self {
        Self { limit, all: BTreeMap::new() }
    }

    /// Adds a frame of the bus at a position.
    pub(crate) fn add(&mut self, decoded: &DecodedFrame, frame: &LoggedFrame, at: usize) {
        let (limit, time) = (self.limit, frame.time.nanoseconds());
        let sender = decoded.sender(frame.is_remote).filter(|_| !frame.is_error).unwrap_or(0);
        let lane = self
            .all
            .entry((at, sender))
            .or_insert_with(|| Lane { frames: BTreeMap::new(), states: Meanings::new(limit) });
        let kind = if frame.is_error { "error" } else { decoded.kind.word() };
        lane.frames.entry(kind).or_insert_with(|| Series::new(limit)).add(time, 0.0);
        let has_state =
            matches!(decoded.kind, FrameKind::Heartbeat | FrameKind::BootUp | FrameKind::Guarding);
        if let (true, Some(state)) = (has_state && !frame.is_remote && sender != 0, frame.data().first()) {
            let is_boot_up = decoded.kind == FrameKind::BootUp;
            let state = if is_boot_up { PRE_OPERATIONAL } else { state & 0x7F };
            lane.states.add(time, &nmt_state(state));
        }
    }
}

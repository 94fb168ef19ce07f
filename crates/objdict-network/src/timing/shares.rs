//! Who uses how much of the bus.

use std::collections::BTreeMap;

use super::frames::TimedFrame;
use super::{Load, Schedule, TrafficKind};
use crate::messages::Party;
use crate::network::Network;
use crate::overview::End;

/// The share of some messages in the load.
#[derive(Clone, Debug)]
pub struct LoadShare<T> {
    /// The part.
    pub of: T,
    /// Its load.
    pub load: Load,
}

impl Schedule {
    pub(super) fn by_node(&self, network: &Network) -> Vec<LoadShare<End>> {
        let mut shares: BTreeMap<usize, (Party, Vec<&TimedFrame>)> = BTreeMap::new();
        for frame in &self.frames {
            shares.entry(frame.sender.node).or_insert((frame.sender, Vec::new())).1.push(frame);
        }
        let share = |(party, frames): (Party, Vec<&TimedFrame>)| LoadShare {
            of: End::new(network, &party),
            load: Load::of(frames),
        };
        shares.into_values().map(share).collect()
    }

    pub(super) fn by_kind(&self) -> Vec<LoadShare<TrafficKind>> {
        let mut shares: BTreeMap<TrafficKind, Vec<&TimedFrame>> = BTreeMap::new();
        for frame in &self.frames {
            shares.entry(frame.kind).or_default().push(frame);
        }
        let shares = shares.into_iter().map(|(of, frames)| LoadShare { of, load: Load::of(frames) });
        shares.filter(|share| share.load != Load::default()).collect()
    }
}

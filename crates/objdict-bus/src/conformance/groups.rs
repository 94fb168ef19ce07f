//! What the checks of a device on a bus may do.

use super::{CheckEffect, Verdict};

/// What the checks of a device may do in addition to reading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RemoteGroups {
    /// Write values and mappings; a reset of the node before each check puts back what was written.
    pub writes: bool,
    /// Command the node by NMT: it starts and stops. Its heartbeat shows the state, and the period is written, so this needs `writes`.
    pub commands: bool,
}

impl RemoteGroups {
    /// The verdict of a check before it is made, by its effect if it is possible on a bus.
    pub(super) fn verdict(self, effect: Option<CheckEffect>) -> Verdict {
        let Some(effect) = effect else {
            let reason =
                "here it needs simulated time, faults or a broadcast, or the standard leaves the answer open";
            return Verdict::Impossible(reason.to_owned());
        };
        let is_allowed = match effect {
            CheckEffect::Reads => true,
            CheckEffect::Writes => self.writes,
            CheckEffect::Commands => self.writes && self.commands,
        };
        if is_allowed {
            Verdict::Planned(effect)
        } else {
            Verdict::Impossible(format!("it {effect}, which was not chosen"))
        }
    }
}

//! What the checks of a device on a bus may do.

/// What the checks of a device may do in addition to reading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RemoteGroups {
    /// Write values and mappings; a reset of the node before each check puts back what was written.
    pub writes: bool,
    /// Command the node by NMT: it starts and stops.
    pub commands: bool,
}

impl RemoteGroups {
    pub(super) const READS: Self = Self { writes: false, commands: false };
    pub(super) const WRITES: Self = Self { writes: true, commands: false };
    /// The state of the node is seen by its heartbeat, whose period is written.
    pub(super) const COMMANDS: Self = Self { writes: true, commands: true };

    pub(super) const fn allow(self, needed: Self) -> bool {
        (self.writes || !needed.writes) && (self.commands || !needed.commands)
    }
}

//! What a check is told beside the description.

use std::sync::Arc;

use super::Severities;
use crate::diagnostic::Tool;
use crate::profile::Profile;

/// What a check is told beside the description.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The node-ID that formulas are worked out for; without it that of a DCF, else every node-ID from 1 to 127.
    pub node_id: Option<u8>,
    /// Profiles that the device shall follow, beside those that it says itself; see [`crate::profile::named`] and
    /// [`Profile::from_toml`].
    pub profiles: Vec<Arc<Profile>>,
    /// The tools that the description shall be fit for: rules of the group `portability` look for what they choke on.
    pub tools: Vec<Tool>,
    /// How grave findings are, where that is not left to the rules.
    pub severities: Severities,
}

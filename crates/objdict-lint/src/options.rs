//! The options of a check.
//!
//! They include the severities of rules; `Config::options` sets them for a path.

use std::sync::Arc;

use super::Severities;
use crate::diagnostic::Tool;
use crate::profile::Profile;

/// The options of a check.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The node-ID for which formulas are evaluated; by default the one in a DCF, otherwise every node-ID
    /// from 1 to 127.
    pub node_id: Option<u8>,
    /// Profiles that apply in addition to the one of the device type; see [`crate::profile::named`]
    /// and [`Profile::from_toml`].
    pub profiles: Vec<Arc<Profile>>,
    /// The tools that the description must be compatible with; rules of the group `portability` check this.
    pub tools: Vec<Tool>,
    /// Severities that differ from those of the rules.
    pub severities: Severities,
}

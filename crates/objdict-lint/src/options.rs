//! The options of a check.
//!
//! The severities of rules are part of them; `Config::options` fills them for a path.

use std::sync::Arc;

use super::Severities;
use crate::diagnostic::Tool;
use crate::profile::Profile;

/// The options of a check.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The node-ID for which formulas are evaluated; by default that of a DCF, otherwise every node-ID from
    /// 1 to 127.
    pub node_id: Option<u8>,
    /// Profiles that apply in addition to that of the device type; see [`crate::profile::named`] and
    /// [`Profile::from_toml`].
    pub profiles: Vec<Arc<Profile>>,
    /// The tools that the description must be compatible with; rules of the group `portability` check this.
    pub tools: Vec<Tool>,
    /// Severities that differ from those of the rules.
    pub severities: Severities,
}

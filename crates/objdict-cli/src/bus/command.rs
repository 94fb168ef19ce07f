//! The document of a command that a node obeys: restore, NMT and LSS.

use objdict_can::LssIdentity;
use objdict_document::describe::frames::nmt_state;
use objdict_model::json::Version;
use serde::Serialize;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct BusCommandJson {
    /// The version of the document.
    version: Version<1>,
    /// `restore`, `lss assign`, or the NMT command, such as `start`.
    pub(super) command: &'static str,
    /// Whether it was sent; false after `--dry-run` or a declined question.
    pub(super) is_sent: bool,
    /// Of `lss assign` vendor-ID, product code, revision number and serial number of the device.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) identity: Option<LssIdentity>,
    /// Of `lss assign --bit-rate` whether the bit rate was tested, so that the device works at it already.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) is_tested: Option<bool>,
    /// The nodes that the command was sent to.
    nodes: Vec<CommandedNode>,
}

/// A node that a command was sent to.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct CommandedNode {
    /// The node-ID.
    node_id: u8,
    /// The NMT state that the node has shown since; absent if it has not shown the expected one, and of `restore`.
    #[serde(skip_serializing_if = "Option::is_none")]
    state: Option<String>,
}

impl BusCommandJson {
    pub(super) const fn new(command: &'static str, is_sent: bool) -> Self {
        Self { version: Version, command, is_sent, identity: None, is_tested: None, nodes: Vec::new() }
    }

    /// Adds a node that the command was sent to, with the state that it has shown.
    pub(super) fn node(&mut self, node_id: u8, state: Option<u8>) {
        self.nodes.push(CommandedNode { node_id, state: state.map(nmt_state) });
    }
}

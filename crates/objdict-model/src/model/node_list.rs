//! Node lists: the nodes of a network and their configurations (CiA 306-3).

use super::Extra;

/// The networks of a project.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NodeList {
    /// The networks, in the order of the file: `Topology`, `Topology2` and so on.
    pub networks: Vec<Topology>,
}

/// One network.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Topology {
    /// `NetName`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub name: Option<String>,
    /// `NetRefd`: the reference designator of the network.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub reference_designator: Option<String>,
    /// `Nodes`: the number of nodes, as stated.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub stated_count: Option<u8>,
    /// `EDSBaseName`: the folder of the descriptions.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub eds_folder: Option<String>,
    /// The nodes in the file, in ascending order of their node-IDs.
    pub nodes: Vec<TopologyNode>,
    /// Keys that the standard does not define; vendors may add their own.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Extra::is_empty"))]
    pub extra: Extra,
}

/// A node of a network, present or not.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(default))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TopologyNode {
    /// The node-ID, 1 to 127.
    pub id: u8,
    /// `NodeXPresent`: whether the node is in the network.
    pub present: bool,
    /// `NodeXName`.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub name: Option<String>,
    /// `NodeXRefd`: the reference designator of the node.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub reference_designator: Option<String>,
    /// `NodeXDCFName`: the file with the configuration of the node, relative to the folder of the node list.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    pub dcf: Option<String>,
}

impl Topology {
    /// The number of nodes that are present in the network.
    pub fn present(&self) -> usize {
        self.nodes.iter().filter(|node| node.present).count()
    }
}

//! The descriptions of the nodes of a bus.

use std::path::Path;

use objdict_document::describe::frames::Talker;
use objdict_model::model::Device;
use objdict_network_file::NetworkFile;

/// A description of a node.
#[derive(Debug)]
pub struct DescribedNode {
    /// What the node is called.
    pub name: String,
    /// `None` for an EDS that does not say which node it is for.
    pub node_id: Option<u8>,
    /// The device with its configured values.
    pub device: Device,
    /// The name of the file.
    pub file: String,
    /// Whether values are those after a configuration: of a DCF, or of a node that the manager of a network configures.
    pub is_configured: bool,
    /// Whether the description is made of its network, whose nodes describe the entries in its PDOs.
    pub is_made: bool,
}

impl DescribedNode {
    /// The node as a sender of frames.
    pub(crate) fn talker(&self, node_id: u8) -> Talker<'_> {
        let Self { name, device, is_made, .. } = self;
        Talker { name, node_id, device, is_counterpart: *is_made }
    }
}

/// What describes the nodes of a bus.
#[derive(Debug, Default)]
pub struct Descriptions {
    /// The nodes that have a description.
    pub nodes: Vec<DescribedNode>,
    /// The bit rate in kbit/s, if a network or a DCF states it.
    pub bit_rate: Option<u16>,
    /// Whether they are the nodes of a network, which has no others.
    pub is_network: bool,
    /// The device profile of nodes without a description that do not state one.
    pub profile: Option<u16>,
}

impl Descriptions {
    /// Adds the nodes of a network, as they are after their configuration.
    pub fn add_network(&mut self, file: &NetworkFile) {
        let (Some(network), Some(compiled)) = (file.network(), file.compiled()) else { return };
        self.is_network = true;
        self.bit_rate = self.bit_rate.or(network.bit_rate.as_ref().map(|rate| rate.value));
        let manager = network.manager.as_ref().and_then(|manager| manager.node);
        self.nodes.extend(compiled.nodes().map(|slave| DescribedNode {
            name: network.nodes[slave.node].name.value.clone(),
            node_id: Some(slave.node_id),
            device: slave.device.clone(),
            file: file.source.name().to_owned(),
            is_configured: manager != Some(slave.node),
            is_made: network.is_made(slave.node),
        }));
    }

    /// Adds a device, for a node if it is stated.
    pub fn add_device(&mut self, device: Device, node_id: Option<u8>, path: &Path, file: String) {
        let commissioning = device.commissioning.as_ref();
        let stated = commissioning.and_then(|node| node.node_name.clone()).filter(|name| !name.is_empty());
        let stem = || path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let rate = commissioning.and_then(|node| node.baud_rate).filter(|rate| *rate != 0);
        self.bit_rate = self.bit_rate.or(rate);
        let own = device.node_id().filter(|node_id| (1..=127).contains(node_id));
        self.nodes.push(DescribedNode {
            name: stated.unwrap_or_else(stem),
            node_id: node_id.or(own),
            is_configured: own.is_some(),
            is_made: false,
            device,
            file,
        });
    }
}

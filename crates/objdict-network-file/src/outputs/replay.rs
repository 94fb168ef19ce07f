//! Replays built files: applies to each node its downloads, and checks the resulting network again.

use std::fmt;

use objdict_bus::{Configurations, PlantNode};

use super::super::boot::{
    DescribedFile, configurations, configured, described, manager_among, switched_on, take,
};
use super::super::{InstallError, stored, topology};
use super::{Build, BuiltFile};
use objdict_model::diagnostic::{Diagnostic, Findings, Severity};
use objdict_model::model::{Device, DeviceKind};
use objdict_model::source::Span;
use objdict_network as network;
use objdict_network::{DcfgenMode, Network, Node, Said, Slave};
use objdict_node::download::{ConciseDcf, Download};

/// The rule about configurations that nodes reject.
const REFUSED: &str = "network/refused-configuration";

/// An objection to built files.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct BuildObjection {
    /// The name of the node that rejects a download; `None` for a finding about the resulting network.
    pub node: Option<String>,
    /// The objection: a sentence in lower case without a full stop.
    pub message: String,
}

impl fmt::Display for BuildObjection {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.node {
            Some(node) => write!(out, "`{node}` {}", self.message),
            None => out.write_str(&self.message),
        }
    }
}

impl Build<'_> {
    /// Replays built files: each node receives its concise DCF, from the manager or from its own file, as in
    /// [`ConciseDcf::verify`]. Then the rules about networks check the nodes, with the downloads or with the values of
    /// their built DCFs, and the manager. Returns all objections, including the errors of these rules.
    ///
    /// # Errors
    /// If a file cannot be read, or several describe a manager.
    pub fn verify(&self, files: &[BuiltFile]) -> Result<Vec<BuildObjection>, InstallError> {
        let mut described = described(files)?;
        let manager = match manager_among(&described) {
            Ok(position) => Some(described.remove(position)),
            Err(InstallError::NoManager) => None,
            Err(error) => return Err(error),
        };
        let manager = manager.map(|manager| configured(manager, files)).transpose()?;
        let streams = manager.as_ref().map(|manager| configurations(&manager.device, files));
        let streams = streams.unwrap_or_default();
        let mut objections = Vec::new();
        let slaves = self.compiled.slaves.iter();
        let nodes = slaves.map(|slave| self.replayed(slave, &described, &streams, files, &mut objections));
        let nodes = nodes.collect();
        let network = self.network_of(nodes, manager);
        let mut findings = Findings::new();
        let network = read_stored(network, &mut findings);
        network::check(&network, &network::compile(&network, DcfgenMode::Corrected), &mut findings);
        let is_error = |finding: &Diagnostic| finding.severity == Severity::Error;
        // some rules only warn about values that the network file does not configure; these are not new
        // either
        let said = self.file.check();
        let is_known = |rule: &str| said.iter().any(|finding| finding.rule.id == rule && !is_error(finding));
        // rejections by nodes are reported for the nodes
        let is_news = |rule: &str| rule != REFUSED && !is_known(rule);
        let errors = findings.iter().filter(|finding| is_error(finding) && is_news(finding.rule.id));
        let errors = errors
            .map(|finding| BuildObjection { node: None, message: finding.message.shown().into_owned() });
        objections.extend(errors);
        Ok(objections)
    }

    /// A node after it received its downloads from the files.
    fn replayed(
        &self,
        slave: &Slave,
        described: &[DescribedFile],
        streams: &Configurations,
        files: &[BuiltFile],
        objections: &mut Vec<BuildObjection>,
    ) -> Node {
        let node = &self.network.nodes[slave.node];
        let mut object = |message: String| {
            objections.push(BuildObjection { node: Some(node.name.value.clone()), message });
        };
        let start = self.start(slave);
        let downloads = match streams.get(&slave.node_id) {
            Some(stream) => Some(stream.clone()),
            None => self.own_stream(slave, files),
        };
        let downloads = downloads.unwrap_or_else(|| Ok(Vec::new())).unwrap_or_else(|reason| {
            object(format!("has no valid configuration: {reason}"));
            Vec::new()
        });
        let stream = ConciseDcf(downloads);
        for refusal in stream.verify(&start, Some(slave.node_id)).aborts() {
            let (number, index, sub) = (refusal.number, refusal.index, refusal.sub);
            object(format!("rejects download {number}, {index:04X}:{sub:02X}: {}", refusal.kind));
        }
        let built = described.iter().find(|other| other.device.node_id() == Some(slave.node_id));
        let device = built.map_or_else(|| after(start, &stream), |built| built.device.clone());
        Node {
            name: node.name.clone(),
            file: node.file.clone(),
            node_id: Some(Said::new(slave.node_id, Span::empty(0))),
            device,
            boot: node.boot.clone(),
            ..Node::default()
        }
    }

    /// The concise DCF of a node in a separate file.
    fn own_stream(&self, slave: &Slave, files: &[BuiltFile]) -> Option<Result<Vec<Download>, String>> {
        let name = format!("{}.cdcf", self.stems[slave.node]);
        let file = files.iter().find(|file| file.name == name)?;
        Some(ConciseDcf::parse(&file.bytes).map(|stream| stream.0).map_err(|error| error.to_string()))
    }

    /// A node at power-on, before its configuration.
    fn start(&self, slave: &Slave) -> Device {
        let node = &self.network.nodes[slave.node];
        switched_on(self.network, node, slave.node_id).switched_on()
    }

    /// The network of nodes that are already configured. Its manager is the one in the files, otherwise the
    /// matching one.
    fn network_of(&self, mut nodes: Vec<Node>, built: Option<PlantNode>) -> Network {
        let manager = self.network.manager.as_ref();
        let own = || {
            let device = self.manager_device().ok()?;
            Some((device, self.compiled.manager.as_ref()?.node_id))
        };
        let found = built.map(|built| (built.device, built.node_id)).or_else(own);
        let manager = manager.zip(found).map(|(manager, (device, node_id))| {
            let node_id = Some(Said::new(node_id, Span::empty(0)));
            let node = Node { name: manager.name.clone(), device, node_id, ..Node::default() };
            let manager = topology::manager(nodes.len(), &node);
            nodes.push(node);
            manager
        });
        let (name, bit_rate) = (self.network.name.clone(), self.network.bit_rate);
        Network { name, bit_rate, manager, nodes, ..Network::default() }
    }
}

/// A node after its downloads.
fn after(mut device: Device, stream: &ConciseDcf) -> Device {
    take(&mut device, stream);
    device.kind = DeviceKind::Node;
    device
}

/// Reads the configurations stored in the manager.
fn read_stored(mut network: Network, findings: &mut Findings) -> Network {
    stored::read(&mut network, findings);
    network.as_described()
}

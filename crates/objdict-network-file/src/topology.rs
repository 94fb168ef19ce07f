//! Node lists (CiA 306-3): a network of DCFs, each of which fully describes its node.

use super::NodeDescriptions;
use super::rules::{INVALID_NODE_LIST, NODE_COUNT};
use objdict_format::nodelist;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, say};
use objdict_model::model::{Topology, TopologyNode};
use objdict_model::source::{Folder, SourceFile, Span};
use objdict_network::{Heartbeat, Manager, Network, Node, Said};

/// Reads the first network of a node list; `None` if there is none.
pub(super) fn read(
    source: &SourceFile,
    descriptions: &mut NodeDescriptions<'_>,
    findings: &mut Findings,
) -> Option<Network> {
    let list = match nodelist::read(source) {
        Ok(list) => list,
        Err(error) => {
            let finding = Diagnostic::new(&INVALID_NODE_LIST, Span::empty(0), error.to_string());
            findings.push(finding.help("correct the file to follow CiA 306-3"));
            return None;
        }
    };
    let others = list.networks.len().saturating_sub(1);
    let topology = list.networks.into_iter().next()?;
    let mut reader = TopologyReader { text: source.text(), descriptions, findings };
    if others > 0 {
        let message = say!("the file has {} networks; only the first is read", others + 1);
        let finding =
            Diagnostic::new(&INVALID_NODE_LIST, Span::empty(0), message).severity(Severity::Warning);
        reader.findings.push(finding.help("use one file per network"));
    }
    reader.count(&topology);
    let mut network = Network { name: topology.name.clone(), ..Network::default() };
    for listed in topology.nodes.iter().filter(|node| node.present) {
        let node = reader.node(&topology, listed);
        network.nodes.extend(node);
    }
    let stated = |node: &Node| node.device.commissioning.as_ref().and_then(|node| node.baud_rate);
    network.bit_rate = network
        .nodes
        .iter()
        .find_map(|node| Some(Said::new(stated(node).filter(|rate| *rate != 0)?, node.file.at)));
    network.manager =
        network.nodes.iter().position(is_manager).map(|position| manager(position, &network.nodes[position]));
    Some(network.as_described())
}

/// Whether a node is the manager according to its description.
pub(super) fn is_manager(node: &Node) -> bool {
    node.device.commissioning.as_ref().is_some_and(|node| node.manager == Some(true))
}

/// The manager according to its DCF: it monitors the nodes in its configuration.
pub(super) fn manager(position: usize, node: &Node) -> Manager {
    let heartbeat = Heartbeat { consumer: Some(Said::new(false, node.file.at)), ..Heartbeat::default() };
    Manager {
        name: node.name.clone(),
        node_id: node.node_id,
        node: Some(position),
        heartbeat,
        ..Manager::default()
    }
}

/// The file of a node in a node list, relative to the folder of the list: there, or in the folder of the descriptions.
pub fn location(folder: Option<&Folder>, topology: &Topology, listed: &TopologyNode) -> String {
    // the paths have Windows separators
    let path = |text: &str| text.replace('\\', "/");
    let name = path(listed.dcf.as_deref().unwrap_or_default());
    let among =
        topology.eds_folder.as_deref().map(|folder| format!("{}/{name}", path(folder).trim_end_matches('/')));
    let is_there = |path: &str| folder.is_some_and(|folder| folder.resolve(path).is_ok());
    among.filter(|path| !is_there(&name) && is_there(path)).unwrap_or(name)
}

struct TopologyReader<'a, 'd> {
    text: &'a str,
    descriptions: &'a mut NodeDescriptions<'d>,
    findings: &'a mut Findings,
}

impl TopologyReader<'_, '_> {
    /// The value of a key; the start of the text for a missing one.
    fn span(&self, key: &str) -> Span {
        let mut start = 0;
        for line in self.text.split_inclusive('\n') {
            let value = line.split_once('=').filter(|(name, _)| name.trim().eq_ignore_ascii_case(key));
            if let Some((name, value)) = value {
                let first = start + name.len() + 1 + (value.len() - value.trim_start().len());
                let offset = |offset: usize| u32::try_from(offset).unwrap_or(u32::MAX);
                return Span::new(offset(first), offset(first + value.trim().len()));
            }
            start += line.len();
        }
        Span::empty(0)
    }

    fn count(&mut self, topology: &Topology) {
        let Some(stated) = topology.stated_count.filter(|stated| usize::from(*stated) != topology.present())
        else {
            return;
        };
        let message = say!("`Nodes` is {}, but {} nodes are present", stated, topology.present());
        let finding = Diagnostic::new(&NODE_COUNT, self.span("Nodes"), message);
        self.findings.push(finding.help(say!("write `Nodes=0x{:02X}`", topology.present())));
    }

    /// A node of the list.
    fn node(&mut self, topology: &Topology, listed: &TopologyNode) -> Option<Node> {
        let key = format!("Node{}DCFName", listed.id);
        let at = self.span(&key);
        let name = listed.name.clone().unwrap_or_else(|| format!("node{}", listed.id));
        let file = Said::new(location(self.descriptions.folder.as_ref(), topology, listed), at);
        let device = self.descriptions.read(&name, &file, self.findings)?;
        let node_id = Some(Said::new(listed.id, at));
        Some(Node { name: Said::new(name, at), file, device, node_id, ..Node::default() })
    }
}

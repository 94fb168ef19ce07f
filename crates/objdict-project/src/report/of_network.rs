//! Networks as subjects of findings.

use std::collections::BTreeMap;

use super::Subject;
use objdict_model::diagnostic::Findings;
use objdict_network_file::NetworkFile;

impl<'a> Subject<'a> {
    /// The findings of a network by subject: its file or, if it has none, the descriptions of its nodes.
    pub fn of_network(network: &'a NetworkFile, findings: Findings) -> Vec<(Self, Findings)> {
        if !network.is_made {
            return vec![(network.into(), findings)];
        }
        let nodes = network.described_nodes();
        let mut by_node: BTreeMap<Option<usize>, Findings> =
            nodes.map(|node| (Some(node), Findings::new())).collect();
        for finding in &findings {
            let described = network.in_description(finding);
            let (node, finding) =
                described.map_or_else(|| (None, finding.clone()), |(node, finding)| (Some(node), finding));
            by_node.entry(node).or_default().push(finding);
        }
        let subject =
            |node: Option<usize>| node.map_or(Self::Network(network), |node| Self::Node(network, node));
        by_node.into_iter().map(|(node, findings)| (subject(node), findings)).collect()
    }
}

impl<'a> From<&'a NetworkFile> for Subject<'a> {
    fn from(network: &'a NetworkFile) -> Self {
        Self::Network(network)
    }
}

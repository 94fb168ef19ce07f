//! Names of files.

use std::collections::HashSet;

use crate::network::{Network, Node};
use crate::source::portable;

impl Network {
    /// The file stem of each node, by its position in [`nodes`](Self::nodes): the name of the node, made [`portable`].
    /// If several names differ only in case, the later ones get the node-ID as suffix (`plc-5`).
    pub fn file_stems(&self) -> Vec<String> {
        let mut taken: HashSet<String> = HashSet::new();
        let stem = |node: &Node| {
            let name = portable(&node.name.value);
            let numbered = node.node_id.map(|node_id| format!("{name}-{}", node_id.value));
            let further = (2..).map(|number| format!("{name}-{number}"));
            let mut stems = std::iter::once(name.clone()).chain(numbered).chain(further);
            // one of the endless names is free
            stems.find(|stem| taken.insert(stem.to_lowercase())).unwrap_or_default()
        };
        self.nodes.iter().map(stem).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::network::Said;
    use crate::source::Span;

    #[test]
    fn stems_differ_in_more_than_their_case() {
        let node = |name: &str, node_id| Node {
            name: Said::new(name.to_owned(), Span::empty(0)),
            node_id: Some(Said::new(node_id, Span::empty(0))),
            ..Node::default()
        };
        let nodes = vec![node("PLC", 1), node("plc", 5), node("left", 2), node("Plc-5", 3), node("plc", 5)];
        let network = Network { nodes, ..Network::default() };
        assert_eq!(network.file_stems(), ["PLC", "plc-5", "left", "Plc-5-3", "plc-2"]);
        let nodes = vec![node("a:b", 1), node("a/b", 5), node("CON", 2)];
        let network = Network { nodes, ..Network::default() };
        assert_eq!(network.file_stems(), ["a_b", "a_b-5", "_CON"]);
    }
}

//! What a network file names: descriptions, nodes and their entries.

use std::path::PathBuf;

use super::file::CheckedFile;
use objdict_model::source::{Span, absolute};
use objdict_network_file::NodeMention;

/// The description of a node that the text names.
pub(super) struct NamedFile {
    pub(super) span: Span,
    pub(super) path: PathBuf,
}

/// All descriptions that a network names, in the order of its nodes.
pub(super) fn named_files(file: &CheckedFile) -> Vec<NamedFile> {
    let network = file.analysis.network();
    let nodes = network.and_then(|of_file| of_file.network()).map(|network| &network.nodes[..]);
    let nodes = nodes.unwrap_or_default().iter().enumerate();
    nodes
        .filter_map(|(number, node)| {
            Some(NamedFile { span: node.file.at, path: path_of_node(file, number)? })
        })
        .collect()
}

/// The file that describes a node.
pub(super) fn path_of_node(file: &CheckedFile, node: usize) -> Option<PathBuf> {
    let description = file.analysis.network()?.description(node)?;
    Some(absolute(description.source().name().as_ref()))
}

/// The entry of a node that an offset names.
pub(super) fn node_mention_at(file: &CheckedFile, offset: u32) -> Option<NodeMention> {
    let mentions = file.analysis.network()?.mentions();
    mentions.into_iter().find(|found| found.mention.has(offset))
}

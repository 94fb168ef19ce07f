//! What a network file names: descriptions, nodes and their entries.

use std::path::PathBuf;

use super::file::File;
use crate::model::{Device, Place};
use crate::network::LinkEnd;
use crate::source::Span;

/// The first entry at an end of a link.
pub(super) fn address_of(end: &LinkEnd, device: &Device) -> Option<(u16, u8)> {
    let address = end.entries.as_ref()?.addresses()?.next()?;
    device.object(address.index)?;
    Some((address.index, address.sub.unwrap_or(0)))
}

/// What the text at an offset names.
pub(super) struct Named {
    pub(super) span: Span,
    /// The description of a node.
    pub(super) file: PathBuf,
    /// The place in it; `None` for all of it.
    pub(super) place: Option<Place>,
}

/// All that a network names, in no order.
pub(super) fn named(file: &File) -> Vec<Named> {
    let Some((of_file, network)) = file.analysis.network().and_then(|file| Some((file, file.network()?)))
    else {
        return Vec::new();
    };
    let path = |name: &str| {
        let description = of_file.descriptions.get(name)?;
        Some(PathBuf::from(description.source().name()))
    };
    let files = network
        .nodes
        .iter()
        .filter_map(|node| Some(Named { span: node.file.at, file: path(&node.file.value)?, place: None }));
    let ends = network.links.iter().flat_map(|link| std::iter::once(&link.from).chain(&link.to));
    let entries = ends.filter_map(|end| {
        let node = network.nodes.iter().find(|node| node.name.value == end.node)?;
        let address = address_of(end, &node.device);
        let place = address.map(|(index, sub)| node.device.entry_place(index, sub));
        Some(Named { span: end.at, file: path(&node.file.value)?, place })
    });
    files.chain(entries).collect()
}

//! What a network file names: descriptions, nodes and their entries.

use std::path::PathBuf;

use lsp_types::{CompletionItem, CompletionItemKind};

use super::completion::item;
use super::file::File;
use super::words;
use crate::model::{Device, PdoKind, Place};
use crate::network::LinkEnd;
use crate::source::Span;

/// The first entry at an end of a link.
pub(super) fn address_of(end: &LinkEnd, device: &Device) -> Option<(u16, u8)> {
    let address = end.entries.as_ref()?.addresses()?.next()?;
    device.object(address.index)?;
    Some((address.index, address.sub.unwrap_or(0)))
}

/// Nodes and their entries, in the quotes behind `from` and `to` of a `network.toml`.
pub(super) fn completion(file: &File, offset: u32) -> Vec<CompletionItem> {
    let network = file.analysis.network().and_then(|file| file.network());
    let (Some(network), Some(before)) = (network, file.text().get(..offset as usize)) else {
        return Vec::new();
    };
    let line = &before[before.rfind('\n').map_or(0, |end| end + 1)..];
    let key = line.split('=').next().unwrap_or_default().trim();
    let (true, Some((_, typed))) = (matches!(key, "from" | "to"), line.rsplit_once('"')) else {
        return Vec::new();
    };
    let span = Span::new(offset - typed.len() as u32, offset);
    let Some((name, _)) = typed.split_once('.') else {
        let names = network.nodes.iter().map(|node| &node.name.value);
        return names.map(|name| item(file, span, name, name.clone(), CompletionItemKind::MODULE)).collect();
    };
    let Some(node) = network.nodes.iter().find(|node| node.name.value == name) else { return Vec::new() };
    let kind = if key == "from" { PdoKind::Tpdo } else { PdoKind::Rpdo };
    let mut items = Vec::new();
    for (&index, object) in &node.device.objects {
        let entries = object.entries().filter(|(_, entry)| entry.is_mappable() && entry.fits_pdo(kind));
        for (sub, _) in entries {
            let has_subs = object.object_type().has_subs();
            let text =
                if has_subs { format!("{name}.{index:04X}:{sub:X}") } else { format!("{name}.{index:04X}") };
            let item = item(file, span, &text, text.clone(), CompletionItemKind::FIELD);
            items.push(CompletionItem { detail: words::name(&node.device, index, Some(sub)), ..item });
        }
    }
    items
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

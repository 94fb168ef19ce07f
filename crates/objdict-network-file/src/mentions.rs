//! Locations in the text of a network that refer to entries of its nodes.

use super::NetworkFile;
use objdict_format::mention::{Digits, Mention, MentionKind};
use objdict_keyed as keyed;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_keyed::yaml;
use objdict_model::diagnostic::Findings;
use objdict_model::source::Span;
use objdict_network::Network;
use objdict_node::resolve;

/// A reference in the text to an object or entry of a node, by address or name.
#[derive(Clone, Copy, Debug)]
pub struct NodeMention {
    /// The position of the node in the network; of a type, one for each node that uses it.
    pub node: usize,
    /// The mention.
    pub mention: Mention,
}

impl NetworkFile {
    /// All references to entries in the text, in text order.
    pub fn mentions(&self) -> Vec<NodeMention> {
        let Some(network) = self.network() else { return Vec::new() };
        let mut finder = MentionFinder { text: self.source.text(), network, found: Vec::new() };
        let is_toml = keyed::toml::is_toml(finder.text);
        let read = if is_toml { keyed::toml::read } else { yaml::read };
        if let Some(tree) = read(finder.text, &mut Findings::new()) {
            if is_toml { finder.of_toml(&tree) } else { finder.of_yaml(&tree) }
        }
        finder.found.sort_by_key(|found| found.mention.span.start);
        finder.found
    }
}

struct MentionFinder<'a> {
    text: &'a str,
    network: &'a Network,
    found: Vec<NodeMention>,
}

impl MentionFinder<'_> {
    fn of_toml(&mut self, tree: &KeyedTree) {
        let table = |name: &str| tree.get(name).and_then(KeyedTree::entries).unwrap_or_default();
        for Pair { key, value } in table("node") {
            self.settings(&self.named(&key.spelled()), value);
        }
        for Pair { key, value } in table("type") {
            let name = key.spelled();
            let uses = |entry: &&Pair| entry.value.get("use").is_some_and(|used| used.spelled() == name);
            let users = table("node").iter().filter(uses);
            let users: Vec<usize> = users.flat_map(|entry| self.named(&entry.key.spelled())).collect();
            self.settings(&users, value);
        }
        for link in tree.get("link").map(items).unwrap_or_default() {
            let ends = ["from", "to"].into_iter().filter_map(|key| link.get(key));
            ends.flat_map(items).for_each(|end| self.end(end));
        }
    }

    fn of_yaml(&mut self, tree: &KeyedTree) {
        let nodes = tree.get("nodes").unwrap_or(tree);
        for Pair { key, value } in nodes.entries().unwrap_or_default() {
            let nodes = self.named(&key.spelled());
            for item in value.get("sdo").map(items).unwrap_or_default() {
                self.pair(&nodes, item);
            }
            for pdo in pdos(value) {
                pdo.get("mapping")
                    .map(items)
                    .unwrap_or_default()
                    .iter()
                    .for_each(|item| self.pair(&nodes, item));
            }
        }
    }

    fn named(&self, name: &str) -> Vec<usize> {
        self.network.nodes.iter().position(|node| node.name.value == name).into_iter().collect()
    }

    /// The keys of `set`, the entries of `sdo`, and the mappings of PDOs.
    fn settings(&mut self, nodes: &[usize], table: &KeyedTree) {
        for Pair { key, .. } in table.get("set").and_then(KeyedTree::entries).unwrap_or_default() {
            self.text(nodes, key.span);
        }
        let downloads = table.get("sdo").map(items).unwrap_or_default();
        downloads.iter().filter_map(|item| item.get("entry")).for_each(|entry| self.text(nodes, entry.span));
        for pdo in pdos(table) {
            pdo.get("map").map(items).unwrap_or_default().iter().for_each(|item| self.text(nodes, item.span));
        }
    }

    /// One end of a link: a node and its entries after a dot.
    fn end(&mut self, end: &KeyedTree) {
        let text = end.span.of(self.text);
        let Some((node, _)) = text.split_once('.') else { return };
        let name = node.trim_start_matches(['"', '\'']).trim();
        let first = self.found.len();
        self.text(&self.named(name), Span::new(end.span.start + node.len() as u32 + 1, end.span.end));
        self.found[first..].iter_mut().for_each(|found| found.mention.span = end.span);
    }

    /// An address, or a unique name of an object or entry.
    fn text(&mut self, nodes: &[usize], span: Span) {
        if let Some(mention) = Mention::of_address(self.text, span, MentionKind::List) {
            self.found.extend(nodes.iter().map(|&node| NodeMention { node, mention }));
            return;
        }
        let name = span.of(self.text).trim_matches(['"', '\'', ' ']);
        let (name, subs) = name.rsplit_once(':').map_or((name, None), |(name, subs)| (name, Some(subs)));
        for &node in nodes {
            if let [address] = resolve(&self.network.nodes[node].device, name)[..] {
                let sub = subs.and_then(|subs| u8::from_str_radix(subs, 16).ok()).or(address.sub);
                let (kind, index) = (MentionKind::List, address.index);
                let mention = Mention { kind, span, index, sub, index_at: None, sub_at: None, last: None };
                self.found.push(NodeMention { node, mention });
            }
        }
    }

    /// `index` and `sub_index` of `bus.yml`.
    fn pair(&mut self, nodes: &[usize], item: &KeyedTree) {
        let number = |name: &str| match item.get(name).map(|tree| (&*tree.kind, tree.span)) {
            Some((Kind::Integer(number), span)) => Some((u16::try_from(*number).ok()?, span)),
            _ => None,
        };
        let Some((index, at)) = number("index") else { return };
        let sub = number("sub_index").and_then(|(sub, span)| Some((u8::try_from(sub).ok()?, span)));
        let mention = Mention {
            kind: MentionKind::List,
            span: sub.map_or(at, |(_, sub)| Span::new(at.start.min(sub.start), at.end.max(sub.end))),
            index,
            sub: Some(sub.map_or(0, |(sub, _)| sub)),
            index_at: Some(Digits::of_number(self.text, at)),
            sub_at: sub.map(|(_, span)| Digits::of_number(self.text, span)),
            last: None,
        };
        self.found.extend(nodes.iter().map(|&node| NodeMention { node, mention }));
    }
}

/// The items of a list, or the single value.
fn items(tree: &KeyedTree) -> &[KeyedTree] {
    match &*tree.kind {
        Kind::List(items) => items,
        _ => std::slice::from_ref(tree),
    }
}

fn pdos(table: &KeyedTree) -> impl Iterator<Item = &KeyedTree> {
    let kinds = ["rpdo", "tpdo"].into_iter().filter_map(|kind| table.get(kind)?.entries());
    kinds.flatten().map(|entry| &entry.value)
}

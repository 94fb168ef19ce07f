//! References to objects in the text of a `device.toml`: tables, mappings, lists and links.

use crate::mention::{Digits, Mention, MentionKind};
use objdict_keyed::toml;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::source::Span;

/// All references in a text, including its variants, in text order.
pub(super) fn of(text: &str) -> Vec<Mention> {
    let mut finder = Finder { text, found: Vec::new() };
    if let Some(tree) = toml::read(text, &mut objdict_model::diagnostic::Findings::new()) {
        finder.of_device(&tree);
        for Pair { value, .. } in tree.get("variant").and_then(KeyedTree::entries).unwrap_or_default() {
            finder.of_device(value);
        }
        finder.headers();
    }
    let mut found = finder.found;
    found.sort_by_key(|mention| mention.span.start);
    found.dedup_by_key(|mention| mention.span);
    found
}

struct Finder<'a> {
    text: &'a str,
    found: Vec<Mention>,
}

impl Finder<'_> {
    fn of_device(&mut self, tree: &KeyedTree) {
        for Pair { key, value } in tree.get("object").and_then(KeyedTree::entries).unwrap_or_default() {
            let Some(object) = Mention::of_address(self.text, key.span, MentionKind::Section) else {
                continue;
            };
            self.found.push(object);
            for entry in value.get("sub").and_then(KeyedTree::entries).unwrap_or_default() {
                self.sub(object.index, entry.key.span);
            }
            value.get("links").into_iter().for_each(|links| self.words(links));
        }
        let lists = tree.get("lists").and_then(KeyedTree::entries).unwrap_or_default();
        lists.iter().for_each(|entry| self.words(&entry.value));
        let removed = tree.get("remove");
        removed.into_iter().for_each(|removed| self.words(removed));
        for Pair { key, .. } in removed.and_then(KeyedTree::entries).unwrap_or_default() {
            self.found.extend(Mention::of_address(self.text, key.span, MentionKind::List));
        }
        for kind in ["rpdo", "tpdo"] {
            for Pair { value, .. } in tree.get(kind).and_then(KeyedTree::entries).unwrap_or_default() {
                let mapped = value.get("map").map(items).unwrap_or_default().iter();
                let mapped =
                    mapped.filter_map(|item| Mention::of_address(self.text, item.span, MentionKind::Mapping));
                let mapped = mapped.filter(|mention| mention.index >= 0x1000);
                self.found
                    .extend(mapped.map(|mention| Mention { sub: Some(mention.sub.unwrap_or(0)), ..mention }));
            }
        }
    }

    /// The table of a sub-index, by the digits of its key.
    fn sub(&mut self, index: u16, span: Span) {
        let digits = span.of(self.text).trim_matches(['"', '\'']);
        if let Ok(sub) = u8::from_str_radix(digits, 16) {
            let quotes = (span.end - span.start - digits.len() as u32) / 2;
            let at = Digits::hex(Span::new(span.start + quotes, span.end - quotes));
            self.found.push(Mention {
                kind: MentionKind::Section,
                span,
                index,
                sub: Some(sub),
                index_at: None,
                sub_at: Some(at),
                last: None,
            });
        }
    }

    /// Addresses separated by spaces; ranges do not refer to single objects.
    fn words(&mut self, list: &KeyedTree) {
        for item in items(list) {
            let Kind::Text(_) = &*item.kind else { continue };
            let mut start = item.span.start;
            for word in item.span.of(self.text).split(' ') {
                let span = Span::new(start, start + word.len() as u32);
                self.found.extend(Mention::of_address(self.text, span, MentionKind::List));
                start = span.end + 1;
            }
        }
    }

    /// The headers of tables: the tree only contains the first key of a name.
    fn headers(&mut self) {
        let mut start = 0;
        for line in self.text.split_inclusive('\n') {
            let at = start;
            start += line.len() as u32;
            let Some(path) = line.trim_end().strip_prefix('[').and_then(|line| line.split(']').next()) else {
                continue;
            };
            let mut offset = at + 1;
            let mut object = None;
            let mut before: [&str; 2] = ["", ""];
            for key in path.split('.') {
                let span = Span::new(offset, offset + key.len() as u32);
                if before[1] == "object" {
                    object = Mention::of_address(self.text, span, MentionKind::Section);
                    self.found.extend(object);
                } else if let Some(object) = object.filter(|_| before[1] == "sub") {
                    self.sub(object.index, span);
                }
                before = [before[1], key];
                offset = span.end + 1;
            }
        }
    }
}

/// The items of a list, or the single value.
fn items(tree: &KeyedTree) -> &[KeyedTree] {
    match &*tree.kind {
        Kind::List(items) => items,
        _ => std::slice::from_ref(tree),
    }
}

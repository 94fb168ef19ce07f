//! Formats a text in canonical order: elements and attributes in the order of CiA 311, objects in ascending order, two
//! spaces per level. Names, values, texts and comments are kept as written.

use super::fact;
use super::findings::body_schema;
use super::schema::{self, CONTAINER};
use crate::xml::{Element, Tree, n};

/// The rearranged text of a document; `None` if it is not well-formed or has a document type. Without `sorted`,
/// elements keep their order.
pub fn arrange(tree: &Tree, sorted: bool) -> Option<String> {
    let text = tree.text();
    let root = tree.root().filter(|_| tree.is_complete())?;
    let (before, after) = (&text[..root.span().start as usize], &text[root.span().end as usize..]);
    if before.contains("<!DOCTYPE") {
        return None;
    }
    let line_end = tree.line_end();
    let mut out = Arranged {
        source: text,
        text: String::with_capacity(text.len()),
        sorted,
        is_in_container: false,
        line_end,
    };
    for piece in pieces(before) {
        out.text.push_str(piece);
        out.line(0);
    }
    out.element(root, None, 0);
    for piece in pieces(after) {
        out.line(0);
        out.text.push_str(piece);
    }
    out.line(0);
    Some(out.text)
}

/// The comments and processing instructions in a text without elements.
fn pieces(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        rest = rest.trim_start_matches(is_blank);
        let end = match rest {
            "" => return None,
            _ if rest.starts_with("<!--") => rest.find("-->").map(|end| end + 3),
            _ => rest.find("?>").map(|end| end + 2),
        };
        let (piece, behind) = rest.split_at(end.unwrap_or(rest.len()));
        rest = behind;
        Some(piece)
    })
}

const fn is_blank(character: char) -> bool {
    matches!(character, ' ' | '\t' | '\n' | '\r' | '\u{feff}')
}

/// A child with the comments before it, and one after it on the same line.
struct ChildBlock<'a> {
    comments: Vec<&'a str>,
    child: Element<'a>,
    known: Option<&'static schema::SchemaElement>,
    trailing: Option<&'a str>,
    rank: (usize, u32),
}

/// A text during formatting.
struct Arranged<'a> {
    source: &'a str,
    text: String,
    sorted: bool,
    /// Whether a container was met; in a network, other elements are around it.
    is_in_container: bool,
    line_end: &'static str,
}

impl<'a> Arranged<'a> {
    fn line(&mut self, depth: usize) {
        self.text.push_str(self.line_end);
        (0..depth).for_each(|_| self.text.push_str("  "));
    }

    fn element(&mut self, element: Element<'a>, known: Option<&'static schema::SchemaElement>, depth: usize) {
        let is_container = element.tag() == n::ISO15745ProfileContainer;
        let known = if is_container { Some(&CONTAINER.element) } else { known };
        self.is_in_container |= is_container;
        let is_preserved =
            || element.attributes().any(|attribute| attribute.name_span().of(self.source) == "xml:space");
        // the model keeps non-standard elements as written
        let is_foreign = known.is_none() && self.is_in_container;
        if is_foreign || is_preserved() {
            self.text.push_str(element.span().of(self.source));
            return;
        }
        self.tag(element, known);
        let inner = element.inner_span().of(self.source);
        if element.is_empty_tag() || inner.is_empty() {
            self.text.push_str(" />");
            return;
        }
        self.text.push('>');
        match element.children().next().is_none() && !inner.contains("<!--") || element.has_text() {
            // whitespace in a text is part of it
            true => self.text.push_str(inner),
            false => self.children(element, known, depth),
        }
        self.text.push_str("</");
        self.text.push_str(element.name_span().of(self.source));
        self.text.push('>');
    }

    /// A start tag without its closing bracket. Declarations and attributes with a prefix come first, unknown
    /// attributes last.
    fn tag(&mut self, element: Element<'a>, known: Option<&'static schema::SchemaElement>) {
        self.text.push('<');
        self.text.push_str(element.name_span().of(self.source));
        let mut attributes: Vec<_> = element.all_attributes().collect();
        attributes.sort_by_key(|attribute| match known.and_then(|known| known.attribute(attribute.tag())) {
            _ if !attribute.prefix().is_empty() || attribute.name() == "xmlns" => 0,
            Some((number, _)) => number + 1,
            None => usize::MAX,
        });
        for attribute in attributes {
            let value = attribute.value_span().of(self.source);
            let quote = if value.contains('"') { '\'' } else { '"' };
            self.text.push(' ');
            self.text.push_str(attribute.name_span().of(self.source));
            self.text.extend(['=', quote]);
            self.text.push_str(value);
            self.text.push(quote);
        }
    }

    fn children(
        &mut self,
        element: Element<'a>,
        known: Option<&'static schema::SchemaElement>,
        depth: usize,
    ) {
        let (mut blocks, end) = self.blocks(element, known);
        if self.sorted {
            blocks.sort_by_key(|block| block.rank);
        }
        for block in blocks {
            for comment in block.comments {
                self.line(depth + 1);
                self.text.push_str(comment);
            }
            self.line(depth + 1);
            self.element(block.child, block.known, depth + 1);
            if let Some(comment) = block.trailing {
                self.text.push(' ');
                self.text.push_str(comment);
            }
        }
        for comment in end {
            self.line(depth + 1);
            self.text.push_str(comment);
        }
        self.line(depth);
    }

    /// The children of an element in text order, and the comments after the last one.
    fn blocks(
        &self,
        element: Element<'a>,
        known: Option<&'static schema::SchemaElement>,
    ) -> (Vec<ChildBlock<'a>>, Vec<&'a str>) {
        let mut blocks: Vec<ChildBlock<'a>> = Vec::new();
        let mut at = element.inner_span().start;
        let mut rank = (0, 0);
        let comments = |from: u32, to: u32, last: Option<&mut ChildBlock<'a>>| {
            let gap = &self.source[from as usize..to as usize];
            let mut comments: Vec<&str> = pieces(gap).collect();
            let is_line =
                |first: &&str| gap.split_once(['\n', '\r']).is_some_and(|(line, _)| line.trim() == *first);
            if let Some(last) = last.filter(|_| comments.first().is_some_and(is_line)) {
                last.trailing = Some(comments.remove(0));
            }
            comments
        };
        for child in element.children() {
            let comments = comments(at, child.span().start, blocks.last_mut());
            at = child.span().end;
            // elements without a defined position remain after the element that they follow
            let found = known.and_then(|known| known.slot(child.tag(), rank.0));
            if let Some((slot, _)) = found {
                let number = match child.tag() {
                    n::CANopenObject => child.attribute(n::index),
                    n::CANopenSubObject => child.attribute(n::subIndex),
                    _ => None,
                };
                let number = number.and_then(|number| fact::hex(number.value().trim(), 4));
                rank = (slot, number.unwrap_or(if rank.0 == slot { rank.1 } else { 0 }));
            }
            let known = found.map(|(_, known)| body_schema(child).unwrap_or(known));
            blocks.push(ChildBlock { comments, child, known, trailing: None, rank });
        }
        let end = comments(at, element.inner_span().end, blocks.last_mut());
        (blocks, end)
    }
}

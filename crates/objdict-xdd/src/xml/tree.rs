//! An XML document as elements and attributes with positions.

use std::borrow::Cow;
use std::fmt;

use super::build::build;
use super::chars::is_blank;
use super::markup::Markup;
use super::names::Name;
use super::parts::{AttributeRecord, DECLARES, Parts, Record};
use crate::diagnostic::Findings;
use crate::source::{SourceFile, Span};

/// An XML document, well-formed or not: its text, and the positions of elements and attributes.
///
/// An element needs 40 bytes and an attribute 20; texts and values are read from the source on demand.
pub struct Tree {
    source: SourceFile,
    parts: Parts,
}

/// The number of an element in its tree, in the order of the start tags.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ElementId(u32);

/// An element of a tree.
#[derive(Clone, Copy)]
pub struct Element<'a> {
    tree: &'a Tree,
    id: u32,
}

/// An attribute of an element.
#[derive(Clone, Copy)]
pub struct Attribute<'a> {
    tree: &'a Tree,
    element: u32,
    number: u32,
}

/// A name for searching elements and attributes: a CiA 311 name, or any string.
pub trait Called: Copy {
    /// Whether an element has the name, with any prefix.
    fn is_element(self, element: Element<'_>) -> bool;

    /// Whether an attribute has the name, with any prefix.
    fn is_attribute(self, attribute: Attribute<'_>) -> bool;
}

impl Called for Name {
    fn is_element(self, element: Element<'_>) -> bool {
        element.tag() == self
    }

    fn is_attribute(self, attribute: Attribute<'_>) -> bool {
        attribute.tag() == self
    }
}

impl Called for &str {
    fn is_element(self, element: Element<'_>) -> bool {
        element.name() == self
    }

    fn is_attribute(self, attribute: Attribute<'_>) -> bool {
        attribute.name() == self
    }
}

impl Tree {
    /// Reads the text of a source. Errors are added to `findings`, and the tree contains all readable
    /// content.
    pub fn new(source: SourceFile, findings: &mut Findings) -> Self {
        let parts = build(&source, findings);
        Self { source, parts }
    }

    /// The source.
    pub fn source(&self) -> &SourceFile {
        &self.source
    }

    /// The source, without the tree.
    pub fn into_source(self) -> SourceFile {
        self.source
    }

    /// The decoded text.
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// The line end of its first line, also used for new lines.
    pub fn line_end(&self) -> &'static str {
        let text = self.text();
        match memchr::memchr2(b'\n', b'\r', text.as_bytes()).map(|at| &text[at..]) {
            Some(rest) if rest.starts_with("\r\n") => "\r\n",
            Some(rest) if rest.starts_with('\r') => "\r",
            _ => "\n",
        }
    }

    /// The outermost element.
    pub fn root(&self) -> Option<Element<'_>> {
        self.get(0)
    }

    /// The element with this id in this tree; the root for any other id.
    ///
    /// # Panics
    /// If the tree has no elements, so that the id belongs to a different tree.
    pub fn element(&self, id: ElementId) -> Element<'_> {
        let id = if (id.0 as usize) < self.parts.elements.len() { id.0 } else { 0 };
        Element { tree: self, id }
    }

    /// The first element that starts at or after an offset.
    pub fn next_element(&self, offset: u32) -> Option<Element<'_>> {
        let before = self.parts.elements.partition_point(|record| record.start < offset);
        self.get(before as u32)
    }

    /// The innermost element around an offset.
    pub fn element_at(&self, offset: u32) -> Option<Element<'_>> {
        let behind = self.parts.elements.partition_point(|record| record.start <= offset);
        let nearest = self.get(behind.checked_sub(1)? as u32);
        std::iter::successors(nearest, |element| element.parent())
            .find(|element| offset < element.record().end)
    }

    /// Whether the document is well-formed and was read completely: there is no finding of severity error.
    pub fn is_complete(&self) -> bool {
        self.parts.is_complete
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.parts.elements.len()
    }

    /// Whether there are no elements.
    pub fn is_empty(&self) -> bool {
        self.parts.elements.is_empty()
    }

    fn get(&self, id: u32) -> Option<Element<'_>> {
        ((id as usize) < self.parts.elements.len()).then_some(Element { tree: self, id })
    }

    fn attribute_numbers(&self, id: u32) -> std::ops::Range<u32> {
        let first = |id: u32| self.parts.elements.get(id as usize).map(|record| record.attributes);
        let end = || self.parts.attributes.len() as u32;
        first(id).unwrap_or_else(end)..first(id + 1).unwrap_or_else(end)
    }

    fn attributes_of(&self, id: u32) -> &[AttributeRecord] {
        let numbers = self.attribute_numbers(id);
        self.parts.attributes.get(numbers.start as usize..numbers.end as usize).unwrap_or_default()
    }
}

impl fmt::Debug for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tree").field("source", &self.source.name()).field("elements", &self.len()).finish()
    }
}

impl<'a> Element<'a> {
    fn record(self) -> &'a Record {
        &self.tree.parts.elements[self.id as usize]
    }

    fn at(self, start: u32, end: u32) -> &'a str {
        Span::new(start, end).of(self.tree.text())
    }

    /// The id for [`Tree::element`].
    pub fn id(self) -> ElementId {
        ElementId(self.id)
    }

    /// The tree of the element.
    pub fn tree(self) -> &'a Tree {
        self.tree
    }

    /// The local name.
    pub fn name(self) -> &'a str {
        let name = self.name_span();
        self.at(name.start + u32::from(self.record().prefix_length), name.end)
    }

    /// The local name, if CiA 311 defines it.
    pub fn tag(self) -> Name {
        self.record().tag
    }

    /// The prefix; empty without one.
    pub fn prefix(self) -> &'a str {
        let start = self.record().start + 1;
        self.at(start, (start + u32::from(self.record().prefix_length)).saturating_sub(1))
    }

    /// The URI of its namespace; `None` without a namespace, and for an undeclared prefix.
    pub fn namespace(self) -> Option<&'a str> {
        self.tree.parts.namespaces.get(self.record().namespace as usize).map(|uri| &**uri)
    }

    /// From the start of the start tag to the end of the end tag.
    pub fn span(self) -> Span {
        Span::new(self.record().start, self.record().end)
    }

    /// The start tag.
    pub fn tag_span(self) -> Span {
        Span::new(self.record().start, self.record().tag_end)
    }

    /// The name in the start tag, with its prefix.
    pub fn name_span(self) -> Span {
        let start = self.record().start + 1;
        Span::new(start, start + u32::from(self.record().name_length))
    }

    /// The content between start tag and end tag.
    pub fn inner_span(self) -> Span {
        Span::new(self.record().tag_end, self.record().inner_end)
    }

    /// Whether the element is a single tag, `<a/>`.
    pub fn is_empty_tag(self) -> bool {
        let tag = self.tag_span();
        self.record().end == tag.end && tag.of(self.tree.text()).ends_with("/>")
    }

    /// The attributes in order, without namespace declarations.
    pub fn attributes(self) -> impl Iterator<Item = Attribute<'a>> {
        self.all_attributes().filter(|attribute| !attribute.record().declares())
    }

    /// The attributes in order, including namespace declarations.
    pub(crate) fn all_attributes(self) -> impl Iterator<Item = Attribute<'a>> {
        let numbers = self.tree.attribute_numbers(self.id);
        numbers.map(move |number| Attribute { tree: self.tree, element: self.id, number })
    }

    /// The first attribute with this local name, with any prefix.
    pub fn attribute(self, name: impl Called) -> Option<Attribute<'a>> {
        self.attributes().find(|attribute| name.is_attribute(*attribute))
    }

    /// The parent element.
    pub fn parent(self) -> Option<Element<'a>> {
        self.tree.get(self.record().parent)
    }

    /// The child elements, in order.
    pub fn children(self) -> impl Iterator<Item = Element<'a>> {
        let first = self.tree.get(self.id + 1).filter(|child| child.record().parent == self.id);
        std::iter::successors(first, |child| self.tree.get(child.record().next))
    }

    /// The first child with this local name.
    pub fn child(self, name: impl Called) -> Option<Element<'a>> {
        self.children().find(|child| name.is_element(*child))
    }

    /// The children with this local name, in order.
    pub fn children_named<N: Called>(self, name: N) -> impl Iterator<Item = Element<'a>> + use<'a, N> {
        self.children().filter(move |child| name.is_element(*child))
    }

    /// All descendants, in the order of their start tags.
    pub fn descendants(self) -> impl Iterator<Item = Element<'a>> {
        let end = self.record().end;
        let is_inside = move |element: &Element<'a>| element.record().start < end;
        (self.id + 1..).map_while(move |id| self.tree.get(id)).take_while(is_inside)
    }

    /// The character data of the element, without that of its children: CDATA sections and references are
    /// resolved, each line end is one LF, and whitespace is kept.
    pub fn text(self) -> Cow<'a, str> {
        // most elements with text contain nothing else
        let inner = self.inner_span().of(self.tree.text());
        if memchr::memchr3(b'&', b'<', b'\r', inner.as_bytes()).is_none() {
            return Cow::Borrowed(inner);
        }
        let mut text = Cow::Borrowed("");
        for gap in self.gaps() {
            self.tree.add_text(gap, &mut text);
        }
        text
    }

    /// Whether [`text`](Self::text) contains more than whitespace, determined without building the text.
    pub fn has_text(self) -> bool {
        if !self.record().has_text {
            return false;
        }
        let bytes = self.tree.text().as_bytes();
        let is_blank_span = |span: Span| {
            let range = span.start as usize..span.end as usize;
            bytes.get(range).unwrap_or_default().iter().all(|&byte| is_blank(byte))
        };
        // most gaps contain only whitespace
        let mut gaps = self.gaps().filter(|gap| !is_blank_span(*gap));
        gaps.any(|gap| self.tree.pieces(gap).any(|piece| !is_blank_span(piece.span)))
    }

    /// The source of [`text`](Self::text) from its first to its last non-whitespace character; without
    /// one, the empty span after the start tag.
    pub fn text_span(self) -> Span {
        if !self.record().has_text {
            return Span::empty(self.record().tag_end);
        }
        let bytes = self.tree.text().as_bytes();
        let mut span: Option<Span> = None;
        for gap in self.gaps() {
            for piece in self.tree.pieces(gap) {
                let range = piece.span.start as usize..piece.span.end as usize;
                let piece_bytes = bytes.get(range).unwrap_or_default();
                let Some(first) = piece_bytes.iter().position(|&byte| !is_blank(byte)) else { continue };
                let last = piece_bytes.iter().rposition(|&byte| !is_blank(byte)).unwrap_or(first);
                let start = span.map_or(piece.span.start + first as u32, |span| span.start);
                span = Some(Span::new(start, piece.span.start + last as u32 + 1));
            }
        }
        span.unwrap_or(Span::empty(self.record().tag_end))
    }

    /// The gaps between the start tag, the children and the end tag.
    fn gaps(self) -> impl Iterator<Item = Span> {
        let mut start = self.record().tag_end;
        let ends = self.children().map(Element::span).chain([Span::empty(self.record().inner_end)]);
        ends.map(move |next| {
            let gap = Span::new(start, next.start);
            start = next.end;
            gap
        })
    }
}

impl fmt::Debug for Element<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "<{}> at {}", self.name(), self.record().start)
    }
}

impl<'a> Attribute<'a> {
    fn record(self) -> &'a AttributeRecord {
        &self.tree.parts.attributes[self.number as usize]
    }

    /// The local name.
    pub fn name(self) -> &'a str {
        let name = self.name_span();
        Span::new(name.start + u32::from(self.record().prefix_length & !DECLARES), name.end)
            .of(self.tree.text())
    }

    /// The local name, if CiA 311 defines it.
    pub fn tag(self) -> Name {
        self.record().tag
    }

    /// The prefix; empty without one.
    pub fn prefix(self) -> &'a str {
        let start = self.record().name;
        let end = (start + u32::from(self.record().prefix_length & !DECLARES)).saturating_sub(1);
        Span::new(start, end).of(self.tree.text())
    }

    /// The URI of its namespace; `None` without prefix, and for an undeclared prefix.
    pub fn namespace(self) -> Option<Cow<'a, str>> {
        let prefix = self.prefix();
        match prefix {
            "" => return None,
            "xml" => return Some(Cow::Borrowed(super::namespaces::XML)),
            _ => {}
        }
        let element = self.tree.get(self.element);
        let mut ancestors = std::iter::successors(element, |element| element.parent());
        ancestors.find_map(|element| self.tree.declared(element.id, prefix))
    }

    /// The value: references are resolved, literal line ends and tabs are replaced by spaces.
    pub fn value(self) -> Cow<'a, str> {
        if self.record().is_plain {
            return Cow::Borrowed(self.value_span().of(self.tree.text()));
        }
        self.tree.parts.entities.value(self.value_span().of(self.tree.text()))
    }

    /// From the name to the closing quote.
    pub fn span(self) -> Span {
        let end = self.record().value_end as usize;
        let is_quoted = matches!(self.tree.text().as_bytes().get(end), Some(b'"' | b'\''));
        Span::new(self.record().name, self.record().value_end + u32::from(is_quoted))
    }

    /// The name with its prefix.
    pub fn name_span(self) -> Span {
        Span::new(self.record().name, self.record().name + u32::from(self.record().name_length))
    }

    /// The value without its quotes.
    pub fn value_span(self) -> Span {
        Span::new(self.record().value, self.record().value_end)
    }
}

impl fmt::Debug for Attribute<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={:?}", self.name(), self.value())
    }
}

/// Character data as written in the source.
#[derive(Clone, Copy)]
struct Piece {
    span: Span,
    /// Whether it is in a CDATA section, where `&` is a plain character.
    is_literal: bool,
}

impl Tree {
    /// The namespace that an element declares for a prefix.
    fn declared(&self, id: u32, prefix: &str) -> Option<Cow<'_, str>> {
        let declarations = self.attributes_of(id).iter().filter(|record| record.declares());
        for record in declarations {
            let length = u32::from(record.prefix_length & !DECLARES);
            let local = Span::new(record.name + length, record.name + u32::from(record.name_length));
            if length > 0 && local.of(self.text()) == prefix {
                let value = Span::new(record.value, record.value_end).of(self.text());
                return Some(self.parts.entities.value(value));
            }
        }
        None
    }

    fn add_text<'a>(&'a self, gap: Span, text: &mut Cow<'a, str>) {
        for piece in self.pieces(gap) {
            let raw = piece.span.of(self.text());
            let more = match piece.is_literal {
                true if raw.contains('\r') => Cow::Owned(raw.replace("\r\n", "\n").replace('\r', "\n")),
                true => Cow::Borrowed(raw),
                false => self.parts.entities.text(raw),
            };
            if text.is_empty() {
                *text = more;
            } else {
                text.to_mut().push_str(&more);
            }
        }
    }

    /// The character data of a gap between tags: without comments, processing instructions and malformed
    /// markup.
    fn pieces(&self, gap: Span) -> impl Iterator<Item = Piece> {
        let mut at = gap.start as usize;
        let text = self.text();
        let end = (gap.end as usize).min(text.len());
        std::iter::from_fn(move || {
            while at < end {
                let start = at;
                let rest = &text[start..end];
                let length = memchr::memchr(b'<', rest.as_bytes()).unwrap_or(rest.len());
                if length > 0 {
                    at += length;
                    return Some(Piece { span: Span::new(start as u32, at as u32), is_literal: false });
                }
                let length_of = |markup: Markup| markup.length(rest.as_bytes()).unwrap_or(rest.len());
                let length = match (self.damage_at(start as u32), Markup::at(rest.as_bytes())) {
                    (Some(damage), _) => damage.len() as usize,
                    (None, Some(Markup::Section)) => {
                        at += length_of(Markup::Section);
                        let section_end = at.saturating_sub(3).max(start + 9) as u32;
                        return Some(Piece {
                            span: Span::new(start as u32 + 9, section_end),
                            is_literal: true,
                        });
                    }
                    (None, Some(markup)) => length_of(markup),
                    (None, None) => {
                        at += 1;
                        return Some(Piece { span: Span::new(start as u32, at as u32), is_literal: true });
                    }
                };
                at += length.max(1);
            }
            None
        })
    }

    fn damage_at(&self, start: u32) -> Option<Span> {
        let damage = &self.parts.damage;
        let found = damage.binary_search_by_key(&start, |span| span.start).ok()?;
        damage.get(found).copied()
    }
}

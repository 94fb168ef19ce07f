//! Edits a tree by spans: the rest of the text is unchanged, and new text is indented like its
//! siblings.

use std::collections::BTreeMap;

use super::chars::{is_blank, is_blank_text, is_forbidden, prefix_length};
use super::write::{escaped_text, escaped_value};
use super::{Attribute, Element, ElementId, Tree};
use crate::source::{EditError, Edits, Span};

/// Changes of one document, in any order.
#[derive(Debug)]
pub struct XmlEditor<'a> {
    tree: &'a Tree,
    edits: Edits<'a>,
    line_end: &'static str,
    /// Content for elements that are a single tag, `<a/>`.
    opened: BTreeMap<ElementId, String>,
    /// The first new text with a character that XML cannot represent.
    not_xml: Option<String>,
}

impl<'a> XmlEditor<'a> {
    /// Creates an editor without changes. New lines end like the first line of the document.
    pub fn new(tree: &'a Tree) -> Self {
        let (edits, opened) = (Edits::new(tree.source()), BTreeMap::new());
        Self { tree, edits, line_end: tree.line_end(), opened, not_xml: None }
    }

    /// Replaces `span` by `text`.
    pub fn replace(&mut self, span: Span, text: impl Into<String>) {
        self.edits.replace(span, text);
    }

    /// Sets an attribute: at its existing position, or after the last attribute. `name` is the spelling with
    /// prefix; two calls for one missing attribute add it twice.
    pub fn set_attribute(&mut self, element: Element<'a>, name: &str, value: &str) {
        self.check(value);
        match self.attribute(element, name) {
            Some(attribute) if attribute.value() == value => {}
            Some(attribute) => self.replace_value(attribute, value),
            None => {
                if prefix_length(name).is_none() {
                    self.not_xml.get_or_insert_with(|| name.to_owned());
                }
                let (at, blanks) = self.behind_attributes(element);
                let blanks = blanks.of(self.tree.text());
                let blanks = if blanks.contains(['\n', '\r']) { blanks } else { " " };
                self.edits.replace(Span::empty(at), format!("{blanks}{name}=\"{}\"", escaped_value(value)));
            }
        }
    }

    /// Removes an attribute and the whitespace before it.
    pub fn remove_attribute(&mut self, element: Element<'a>, name: &str) {
        if let Some(attribute) = self.attribute(element, name) {
            let span = attribute.span();
            self.edits.replace(Span::new(self.blanks_before(span.start).start, span.end), "");
        }
    }

    /// Inserts elements, given as text, into `parent`: after one of its children, or as the first child.
    /// Each line gets the indentation of the children of `parent`.
    pub fn insert_child(&mut self, parent: Element<'a>, behind: Option<Element<'a>>, xml: &str) {
        self.check(xml);
        let xml = self.indented(xml, &self.child_indent(parent));
        if parent.is_empty_tag() {
            self.opened.entry(parent.id()).or_default().push_str(&xml);
            return;
        }
        let text = self.tree.text();
        let at = behind.map_or(parent.tag_span().end, |behind| behind.span().end);
        let is_only = parent.children().next().is_none();
        let inner = parent.inner_span().of(text);
        let end = match is_only
            && is_blank_text(inner)
            && !inner.contains(['\n', '\r'])
            && self.has_lines(parent)
        {
            true => format!("{}{}", self.line_end, self.indent(parent)),
            false => String::new(),
        };
        self.edits.replace(Span::empty(at), format!("{xml}{end}"));
    }

    /// Removes an element, and its line if the line has no other content.
    pub fn remove_element(&mut self, element: Element<'a>) {
        let text = self.tree.text().as_bytes();
        let span = element.span();
        let behind = text.get(span.end as usize..).unwrap_or_default();
        let next = behind.iter().find(|&&byte| !matches!(byte, b' ' | b'\t'));
        let before = self.blanks_before(span.start);
        let blanks = before.of(self.tree.text());
        // the line end before the element is removed and the one after it remains
        let start = match blanks.rfind('\n').or(blanks.rfind('\r')) {
            Some(line_end) if matches!(next, None | Some(b'\n' | b'\r')) => {
                let is_crlf = blanks[..line_end].ends_with('\r') && blanks[line_end..].starts_with('\n');
                before.start + line_end as u32 - u32::from(is_crlf)
            }
            _ => span.start,
        };
        self.edits.replace(Span::new(start, span.end), "");
    }

    /// Replaces the content of an element by a text.
    pub fn set_text(&mut self, element: Element<'a>, text: &str) {
        self.check(text);
        let has_children = element.children().next().is_some();
        if element.text() == text && !has_children {
            return;
        }
        let text = escaped_text(text);
        if element.is_empty_tag() {
            self.opened.insert(element.id(), text.into_owned());
        } else {
            self.edits.replace(element.inner_span(), text);
        }
    }

    /// The edited text.
    ///
    /// # Errors
    /// If two changes overlap, or a new text contains a character that XML cannot represent.
    pub fn text(&self) -> Result<String, EditError> {
        self.complete()?.text()
    }

    /// The edited document in the encoding of the file; without changes, the original bytes.
    ///
    /// # Errors
    /// If two changes overlap, a new text contains a character that XML cannot represent, or the document
    /// cannot be written in the encoding of the file.
    pub fn to_bytes(&self) -> Result<Vec<u8>, EditError> {
        self.complete()?.to_bytes()
    }

    /// The changes as spans with their new texts, in the order of the document.
    ///
    /// # Errors
    /// If two changes overlap, or a new text contains a character that XML cannot represent.
    pub fn into_list(self) -> Result<Vec<(Span, String)>, EditError> {
        self.complete()?.into_list()
    }

    /// All changes, including those of opened elements.
    fn complete(&self) -> Result<Edits<'a>, EditError> {
        if let Some(text) = &self.not_xml {
            return Err(EditError::NotXml(text.clone()));
        }
        let mut edits = self.edits.clone();
        for (&id, inner) in &self.opened {
            let element = self.tree.element(id);
            let slash = element.tag_span().end - 2;
            let start = self.blanks_before(slash).start;
            let name = element.name_span().of(self.tree.text());
            let end = match inner.starts_with(self.line_end) {
                true => format!("{}{}", self.line_end, self.indent(element)),
                false => String::new(),
            };
            edits.replace(Span::new(start, slash + 2), format!(">{inner}{end}</{name}>"));
        }
        Ok(edits)
    }

    /// Records a text that XML cannot represent.
    fn check(&mut self, text: &str) {
        if text.contains(is_forbidden) {
            self.not_xml.get_or_insert_with(|| text.to_owned());
        }
    }

    fn attribute(&self, element: Element<'a>, name: &str) -> Option<Attribute<'a>> {
        element.attributes().find(|attribute| attribute.name_span().of(self.tree.text()) == name)
    }

    fn replace_value(&mut self, attribute: Attribute<'a>, value: &str) {
        let (text, span) = (self.tree.text(), attribute.value_span());
        let before = text[..span.start as usize].bytes().next_back();
        let behind = text[span.end as usize..].bytes().next();
        let value = escaped_value(value);
        match before {
            Some(b'"') if behind == before => self.edits.replace(span, value),
            Some(b'\'') if behind == before => self.edits.replace(span, value.replace('\'', "&apos;")),
            // add the missing quotes of a malformed attribute
            Some(b'"' | b'\'') => {
                self.edits.replace(Span::new(span.start - 1, span.end), format!("\"{value}\""));
            }
            _ => self.edits.replace(span, format!("\"{value}\"")),
        }
    }

    /// The offset after the last attribute, otherwise after the name, and the whitespace before that
    /// attribute.
    fn behind_attributes(&self, element: Element<'a>) -> (u32, Span) {
        match element.all_attributes().last() {
            Some(last) => (last.span().end, self.blanks_before(last.span().start)),
            None => (element.name_span().end, Span::default()),
        }
    }

    /// The whitespace before an offset.
    fn blanks_before(&self, offset: u32) -> Span {
        let before = &self.tree.text().as_bytes()[..offset as usize];
        let length = before.iter().rev().take_while(|&&byte| is_blank(byte)).count();
        Span::new(offset - length as u32, offset)
    }

    /// Whether the children of an element have their own lines; without children, whether the element does.
    fn has_lines(&self, parent: Element<'a>) -> bool {
        let sample = parent.children().next().unwrap_or(parent);
        let blanks = self.blanks_before(sample.span().start);
        blanks.start == 0 || blanks.of(self.tree.text()).contains(['\n', '\r'])
    }

    /// The indentation of an element.
    fn indent(&self, element: Element<'a>) -> &'a str {
        let blanks = self.blanks_before(element.span().start).of(self.tree.text());
        blanks.rsplit(['\n', '\r']).next().unwrap_or_default()
    }

    /// A line end and the indentation of an element's children; empty if they are not on separate lines.
    fn child_indent(&self, parent: Element<'a>) -> String {
        if !self.has_lines(parent) {
            return String::new();
        }
        let indent = match parent.children().next() {
            Some(child) => self.indent(child).to_owned(),
            None => {
                let own = self.indent(parent);
                let around = parent.parent().map_or("", |around| self.indent(around));
                let step = own.strip_prefix(around).filter(|step| !step.is_empty()).unwrap_or("  ");
                format!("{own}{step}")
            }
        };
        format!("{}{indent}", self.line_end)
    }

    /// Elements as text, with `indent` before each and the line ends of the file. Only line ends between
    /// tags are followed by indentation, because line ends in texts are significant.
    fn indented(&self, xml: &str, indent: &str) -> String {
        let mut indented = indent.to_owned();
        let mut lines = xml.trim_ascii().split_inclusive('\n').peekable();
        while let Some(line) = lines.next() {
            let content = line.trim_end_matches(['\n', '\r']);
            indented.push_str(content);
            let Some(next) = lines.peek() else { break };
            let is_between = content.ends_with('>') && next.trim_ascii_start().starts_with('<');
            indented.push_str(if is_between && !indent.is_empty() { indent } else { self.line_end });
        }
        indented
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Findings;
    use crate::source::SourceFile;

    fn edit(text: &str, change: impl for<'a> Fn(&mut XmlEditor<'a>, Element<'a>)) -> String {
        let tree = Tree::new(SourceFile::from_text("test.xdd", text), &mut Findings::new());
        let mut editor = XmlEditor::new(&tree);
        change(&mut editor, tree.root().unwrap());
        let edited = editor.text().unwrap();
        if tree.is_complete() {
            assert!(Tree::new(SourceFile::from_text("", edited.clone()), &mut Findings::new()).is_complete());
        }
        edited
    }

    #[test]
    fn attributes_are_set_where_they_stand() {
        let edited = edit("<a b = 'x'  c=\"y\"><d/></a >", |editor, root| {
            editor.set_attribute(root, "b", "it's <\"");
            editor.set_attribute(root, "c", "y");
            editor.set_attribute(root, "e", "\t1");
            editor.set_attribute(root.child("d").unwrap(), "f", "2");
        });
        assert_eq!(edited, "<a b = 'it&apos;s &lt;&quot;'  c=\"y\" e=\"&#9;1\"><d f=\"2\"/></a >");
    }

    #[test]
    fn new_attributes_stand_like_the_last_one() {
        let edited = edit("<a xmlns:b='c'\n   d='1' />", |editor, root| {
            editor.set_attribute(root, "b:d", "2");
            editor.remove_attribute(root, "d");
        });
        assert_eq!(edited, "<a xmlns:b='c'\n   b:d=\"2\" />");
    }

    #[test]
    fn damaged_attributes_become_sound() {
        let edited = edit("<a b=1 c='2 d='3'/>", |editor, root| {
            editor.set_attribute(root, "b", "4");
            editor.set_attribute(root, "c", "5");
        });
        assert_eq!(edited, "<a b=\"4\" c=\"5\" d='3'/>");
    }

    #[test]
    fn children_are_laid_out_like_their_siblings() {
        let edited = edit("<a>\r\n\t<b/>\r\n\t<c></c>\r\n</a>", |editor, root| {
            editor.insert_child(root, None, "<x>\n  <y/>\n</x>\n");
            editor.insert_child(root, root.child("b"), "<z/>");
            editor.insert_child(root.child("b").unwrap(), None, "<d/>");
            editor.insert_child(root.child("b").unwrap(), None, "<e>1\n2</e>");
            editor.insert_child(root.child("c").unwrap(), None, "<f/>");
        });
        let expected = "<a>\r\n\t<x>\r\n\t  <y/>\r\n\t</x>\r\n\t<b>\r\n\t\t<d/>\r\n\t\t<e>1\r\n2</e>\r\n\t</b>\
            \r\n\t<z/>\r\n\t<c>\r\n\t\t<f/>\r\n\t</c>\r\n</a>";
        assert_eq!(edited, expected);
        let edited = edit("<a><b/></a>", |editor, root| editor.insert_child(root, root.child("b"), "<c/>"));
        assert_eq!(edited, "<a><b/><c/></a>");
    }

    #[test]
    fn removed_elements_leave_no_trace() {
        let edited = edit("<a>\r\n  <b/>\r\n  <c>\r\n  </c>\r\n  <d/><e/>\r\n</a>", |editor, root| {
            editor.remove_element(root.child("c").unwrap());
            editor.insert_child(root, root.child("c"), "<x/>");
            editor.remove_element(root.child("d").unwrap());
        });
        assert_eq!(edited, "<a>\r\n  <b/>\r\n  <x/>\r\n  <e/>\r\n</a>");
    }

    #[test]
    fn texts_are_set_in_any_element() {
        let edited = edit("<a><b> x </b><c /><d><e/></d></a>", |editor, root| {
            editor.set_text(root.child("b").unwrap(), "1 < 2");
            editor.set_text(root.child("c").unwrap(), "3");
            editor.set_text(root.child("d").unwrap(), "");
        });
        assert_eq!(edited, "<a><b>1 &lt; 2</b><c>3</c><d></d></a>");
    }

    #[test]
    fn what_xml_cannot_hold_is_refused() {
        let tree = Tree::new(SourceFile::from_text("test.xdd", "<a/>"), &mut Findings::new());
        let root = tree.root().unwrap();
        let mut editor = XmlEditor::new(&tree);
        editor.set_attribute(root, "b", "\0");
        assert_eq!(editor.to_bytes(), Err(EditError::NotXml("\0".to_owned())));
        let mut editor = XmlEditor::new(&tree);
        editor.set_attribute(root, "b c", "d");
        assert_eq!(editor.to_bytes(), Err(EditError::NotXml("b c".to_owned())));
    }

    #[test]
    fn without_changes_the_bytes_stay() {
        let tree = Tree::new(SourceFile::from_text("test.xdd", "<a b='1'>2</a>"), &mut Findings::new());
        let root = tree.root().unwrap();
        let mut editor = XmlEditor::new(&tree);
        editor.set_attribute(root, "b", "1");
        editor.set_text(root, "2");
        editor.remove_attribute(root, "c");
        assert_eq!(editor.to_bytes(), Ok(b"<a b='1'>2</a>".to_vec()));
    }
}

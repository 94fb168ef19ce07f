//! Writes XML documents: output is deterministic, and all names and texts are escaped.

use std::borrow::Cow;

use quick_xml::escape::partial_escape;

use super::chars::{is_forbidden, is_name, is_name_char, prefix_length};

/// Writes a document: an XML declaration, two spaces per level, LF as line end.
#[derive(Debug, Default)]
pub struct XmlWriter {
    text: String,
    open: Vec<String>,
    /// Whether the innermost open element has no content yet.
    is_empty: bool,
}

/// The state of a document before an element is written.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WriterMark {
    length: usize,
    depth: usize,
    is_empty: bool,
}

impl XmlWriter {
    /// A document with an XML declaration for UTF-8, and without elements.
    pub fn new() -> Self {
        Self { text: "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n".to_owned(), ..Self::default() }
    }

    /// Opens an element; the following calls write its content until it is closed.
    pub fn open<'t>(&mut self, name: &str, attributes: impl IntoIterator<Item = (&'t str, &'t str)>) {
        let name = self.tag(name, attributes).into_owned();
        self.text.push_str(">\n");
        self.open.push(name);
        self.is_empty = true;
    }

    /// Writes an element without content.
    pub fn empty<'t>(&mut self, name: &str, attributes: impl IntoIterator<Item = (&'t str, &'t str)>) {
        self.tag(name, attributes);
        self.text.push_str(" />\n");
    }

    /// Writes an element that only contains a text.
    pub fn text_element<'t>(
        &mut self,
        name: &str,
        attributes: impl IntoIterator<Item = (&'t str, &'t str)>,
        text: &str,
    ) {
        if text.is_empty() {
            return self.empty(name, attributes);
        }
        let name = self.tag(name, attributes);
        self.text.push('>');
        if is_plain(text) {
            self.text.push_str(text);
        } else {
            self.text.push_str(&escaped_text(&allowed(text)));
        }
        self.text.push_str("</");
        self.text.push_str(&name);
        self.text.push_str(">\n");
    }

    /// Closes the element opened last. Does nothing without an open element.
    pub fn close(&mut self) {
        let Some(name) = self.open.pop() else { return };
        if std::mem::take(&mut self.is_empty) {
            self.text.truncate(self.text.len() - ">\n".len());
            return self.text.push_str(" />\n");
        }
        self.indent();
        self.text.push_str("</");
        self.text.push_str(&name);
        self.text.push_str(">\n");
    }

    /// A mark for [`reset`](Self::reset).
    pub(crate) fn mark(&self) -> WriterMark {
        WriterMark { length: self.text.len(), depth: self.open.len(), is_empty: self.is_empty }
    }

    /// Discards the output since a mark, if nothing before it was closed or [taken](Self::take).
    pub(crate) fn reset(&mut self, mark: WriterMark) {
        self.text.truncate(mark.length);
        self.open.truncate(mark.depth);
        self.is_empty = mark.is_empty;
    }

    /// Returns and removes the output so far, unless the last call opened an element; later calls
    /// continue it. A long document thus need not be in memory at once.
    pub fn take(&mut self) -> String {
        // an element without content is closed by changing its start tag
        if self.is_empty { String::new() } else { std::mem::take(&mut self.text) }
    }

    /// The document. Elements that are still open are closed.
    pub fn finish(mut self) -> String {
        while !self.open.is_empty() {
            self.close();
        }
        self.text
    }

    /// Writes a start tag without its end; returns the written name.
    fn tag<'n, 't>(
        &mut self,
        name: &'n str,
        attributes: impl IntoIterator<Item = (&'t str, &'t str)>,
    ) -> Cow<'n, str> {
        self.is_empty = false;
        let name = valid_name(name);
        self.indent();
        self.text.push('<');
        self.text.push_str(&name);
        for (attribute, value) in attributes {
            self.text.push(' ');
            self.text.push_str(&valid_name(attribute));
            self.text.push_str("=\"");
            if is_plain(value) {
                self.text.push_str(value);
            } else {
                self.text.push_str(&escaped_value(&allowed(value)));
            }
            self.text.push('"');
        }
        name
    }

    fn indent(&mut self) {
        for _ in 0..self.open.len() {
            self.text.push_str("  ");
        }
    }
}

/// A valid name: forbidden characters, and a forbidden first character, become `_`.
fn valid_name(name: &str) -> Cow<'_, str> {
    if prefix_length(name).is_some() {
        return Cow::Borrowed(name);
    }
    let good: String = name.chars().map(|c| if is_name_char(c) { c } else { '_' }).collect();
    Cow::Owned(if is_name(&good) { good } else { format!("_{good}") })
}

/// A text whose forbidden characters became U+FFFD.
fn allowed(text: &str) -> Cow<'_, str> {
    match text.contains(is_forbidden) {
        true => Cow::Owned(text.replace(is_forbidden, "\u{FFFD}")),
        false => Cow::Borrowed(text),
    }
}

/// Whether a text or value needs no escaping.
fn is_plain(text: &str) -> bool {
    text.bytes().all(|byte| matches!(byte, b' '..=b'~') && !matches!(byte, b'<' | b'>' | b'&' | b'"'))
}

/// A text, escaped for an element. A CR is written as a character reference because it would be read as LF.
pub(super) fn escaped_text(text: &str) -> Cow<'_, str> {
    partial_escape(text)
}

/// A value, escaped for double quotes. Tabs and line ends are written as character references because they
/// would be read as spaces.
pub(crate) fn escaped_value(value: &str) -> Cow<'_, str> {
    let escaped = partial_escape(value);
    if !escaped.contains(['"', '\t', '\n']) {
        return escaped;
    }
    Cow::Owned(escaped.replace('"', "&quot;").replace('\t', "&#9;").replace('\n', "&#10;"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Findings;
    use crate::source::SourceFile;
    use crate::xml::Tree;

    fn read(text: String) -> Tree {
        let mut findings = Findings::new();
        let tree = Tree::new(SourceFile::from_text("test.xdd", text), &mut findings);
        assert!(findings.is_empty(), "{findings:?}");
        tree
    }

    #[test]
    fn elements_nest() {
        let mut writer = XmlWriter::new();
        writer.open("a", [("b", "1")]);
        writer.empty("c", []);
        writer.open("d", []);
        writer.close();
        writer.text_element("e", [("f", "2")], "x\ny");
        writer.text_element("g", [], "");
        let text = writer.finish();
        let expected = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n\
            <a b=\"1\">\n  <c />\n  <d />\n  <e f=\"2\">x\ny</e>\n  <g />\n</a>\n";
        assert_eq!(text, expected);
        assert_eq!(read(text).root().unwrap().children().count(), 4);
    }

    #[test]
    fn every_text_comes_back() {
        let text = " <&>\"' \t\r\n ]]> \u{85} é -- &amp; ";
        let mut writer = XmlWriter::new();
        writer.text_element("a", [("b", text)], text);
        let tree = read(writer.finish());
        let root = tree.root().unwrap();
        assert_eq!(root.text(), text);
        assert_eq!(root.attribute("b").unwrap().value(), text);
    }

    #[test]
    fn what_has_no_place_in_xml_is_replaced() {
        let mut writer = XmlWriter::new();
        writer.text_element("1 a", [("b>", "\0")], "\u{1F}");
        let tree = read(writer.finish());
        assert_eq!(tree.root().unwrap().name(), "_1_a");
        assert_eq!(tree.root().unwrap().text(), "\u{FFFD}");
    }
}

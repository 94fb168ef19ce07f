//! XML documents as text: the same calls give the same bytes, and no name or text can leave its place.

use std::borrow::Cow;

use quick_xml::escape::partial_escape;

use super::chars::{is_forbidden, is_name, is_name_char, prefix_length};

/// Writes a document: an XML declaration, two blanks for each level, LF as line end.
#[derive(Debug, Default)]
pub struct XmlWriter {
    text: String,
    open: Vec<String>,
    /// Nothing was written since the innermost open element began.
    is_empty: bool,
    replaced: Vec<Replaced>,
}

/// A character that has no place in XML, so another was written for it: `_` in a name, U+FFFD in a text or value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replaced {
    /// The element that it is of.
    pub element: String,
    /// The attribute that it is of; `None` for the name or text of the element.
    pub attribute: Option<String>,
    /// The character.
    pub character: char,
}

/// So many replaced characters are told.
const MAX_REPLACED: usize = 1000;

impl XmlWriter {
    /// A document that has its XML declaration, for the encoding UTF-8, and no element.
    pub fn new() -> Self {
        Self { text: "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n".to_owned(), ..Self::default() }
    }

    /// Begins an element. What follows is in it, until it is closed.
    pub fn open(&mut self, name: &str, attributes: &[(&str, &str)]) {
        let name = self.tag(name, attributes);
        self.text.push_str(">\n");
        self.open.push(name);
        self.is_empty = true;
    }

    /// Writes an element that has nothing in it.
    pub fn empty(&mut self, name: &str, attributes: &[(&str, &str)]) {
        self.tag(name, attributes);
        self.text.push_str(" />\n");
    }

    /// Writes an element that has only a text in it.
    pub fn text_element(&mut self, name: &str, attributes: &[(&str, &str)], text: &str) {
        if text.is_empty() {
            return self.empty(name, attributes);
        }
        let name = self.tag(name, attributes);
        let text = self.allowed(&name, None, text);
        self.text.push('>');
        self.text.push_str(&escaped_text(&text));
        self.text.push_str("</");
        self.text.push_str(&name);
        self.text.push_str(">\n");
    }

    /// Ends the element that was opened last. Without one, nothing happens.
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

    /// The characters that could not be written so far; of very many the first ones.
    pub fn replaced(&self) -> &[Replaced] {
        &self.replaced
    }

    /// The text so far, where the last call did not open an element; what follows continues it. So a long document need not
    /// be in memory at once.
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

    /// Writes a start tag but for its end; gives the name that it has.
    fn tag(&mut self, name: &str, attributes: &[(&str, &str)]) -> String {
        self.is_empty = false;
        let name = self.name(name, name);
        self.indent();
        self.text.push('<');
        self.text.push_str(&name);
        for (attribute, value) in attributes {
            let attribute = self.name(&name, attribute);
            let value = self.allowed(&name, Some(&attribute), value);
            self.text.push(' ');
            self.text.push_str(&attribute);
            self.text.push_str("=\"");
            self.text.push_str(&escaped_value(&value));
            self.text.push('"');
        }
        name
    }

    fn indent(&mut self) {
        for _ in 0..self.open.len() {
            self.text.push_str("  ");
        }
    }

    /// A name that is one: what is not allowed in it, and a start that is none, become `_`.
    fn name(&mut self, element: &str, name: &str) -> String {
        if prefix_length(name).is_some() {
            return name.to_owned();
        }
        let bad = name.chars().find(|&character| !is_name_char(character)).or(name.chars().next());
        self.note(element, None, bad.unwrap_or(' '));
        let good: String = name.chars().map(|c| if is_name_char(c) { c } else { '_' }).collect();
        if is_name(&good) { good } else { format!("_{good}") }
    }

    fn allowed<'t>(&mut self, element: &str, attribute: Option<&str>, text: &'t str) -> Cow<'t, str> {
        if !text.contains(is_forbidden) {
            return Cow::Borrowed(text);
        }
        for character in text.chars().filter(|&character| is_forbidden(character)) {
            self.note(element, attribute, character);
        }
        Cow::Owned(text.replace(is_forbidden, "\u{FFFD}"))
    }

    fn note(&mut self, element: &str, attribute: Option<&str>, character: char) {
        if self.replaced.len() < MAX_REPLACED {
            let (element, attribute) = (element.to_owned(), attribute.map(str::to_owned));
            self.replaced.push(Replaced { element, attribute, character });
        }
    }
}

/// A text as it stands in an element. A CR would be read as LF, so it is written as a number.
pub(super) fn escaped_text(text: &str) -> Cow<'_, str> {
    partial_escape(text)
}

/// A value as it stands in double quotes. Tabs and line ends would be read as blanks, so they are written as numbers.
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
        writer.open("a", &[("b", "1")]);
        writer.empty("c", &[]);
        writer.open("d", &[]);
        writer.close();
        writer.text_element("e", &[("f", "2")], "x\ny");
        writer.text_element("g", &[], "");
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
        writer.text_element("a", &[("b", text)], text);
        assert_eq!(writer.replaced(), []);
        let tree = read(writer.finish());
        let root = tree.root().unwrap();
        assert_eq!(root.text(), text);
        assert_eq!(root.attribute("b").unwrap().value(), text);
    }

    #[test]
    fn what_has_no_place_in_xml_is_reported() {
        let mut writer = XmlWriter::new();
        writer.text_element("1 a", &[("b>", "\0")], "\u{1F}");
        let replaced: Vec<char> = writer.replaced().iter().map(|replaced| replaced.character).collect();
        assert_eq!(replaced, [' ', '>', '\0', '\u{1F}']);
        let tree = read(writer.finish());
        assert_eq!(tree.root().unwrap().name(), "_1_a");
        assert_eq!(tree.root().unwrap().text(), "\u{FFFD}");
    }
}

//! Edits a document by spans: the rest of the text remains unchanged, byte for byte.

use super::{Document, Line, LineKind, Section};
use crate::source::{EditError, Edits, Span};

/// Changes of one document, in any order.
#[derive(Debug)]
pub struct IniEditor<'a> {
    document: &'a Document,
    line_end: &'static str,
    edits: Edits<'a>,
    /// The first new text that contains a line end.
    many_lines: Option<String>,
}

impl<'a> IniEditor<'a> {
    /// Creates an editor without changes. New lines end like the first line of the document, or with CR LF
    /// if it has none.
    pub fn new(document: &'a Document) -> Self {
        let line_end = document.line_end();
        Self { document, line_end, edits: Edits::new(document.source()), many_lines: None }
    }

    /// Replaces `span` by `text`.
    pub fn replace(&mut self, span: Span, text: impl Into<String>) {
        self.edits.replace(span, text);
    }

    /// Removes the lines of a span, which consists of complete lines.
    pub fn remove(&mut self, span: Span) {
        self.replace(span, "");
    }

    /// Sets a key: in its existing line, or in a new line after the last key of the section.
    pub fn set(&mut self, section: &Section, key: &str, value: &str) {
        self.check_line(key);
        self.check_line(value);
        let text = self.document.text();
        match section.entries.iter().find(|entry| entry.key.of(text).eq_ignore_ascii_case(key)) {
            Some(entry) if entry.value.of(text) == value => {}
            Some(entry) => self.replace(entry.value, value),
            None => {
                let line = format!("{key}={value}");
                self.insert_lines(end_of(section), &[line]);
            }
        }
    }

    /// Renames a section.
    pub fn rename_section(&mut self, section: &Section, name: &str) {
        self.check_line(name);
        let Some(header) = section.header else { return };
        let line = header.line.of(self.document.text());
        // for some tools, spaces between brackets and name are part of the name
        let inside = line.find('[').zip(line.rfind(']')).filter(|(open, close)| open < close);
        let inside = inside.map(|(open, close)| {
            let at = |offset: usize| header.line.start + u32::try_from(offset).unwrap_or_default();
            Span::new(at(open + 1), at(close))
        });
        self.replace(inside.unwrap_or(header.name), name);
    }

    /// Removes the line of a key.
    pub fn remove_key(&mut self, section: &Section, key: &str) {
        let text = self.document.text();
        let entries = section.entries.iter().filter(|entry| entry.key.of(text).eq_ignore_ascii_case(key));
        for line in entries.filter_map(|entry| self.line_at(entry.key.start)).collect::<Vec<_>>() {
            self.remove(Span::new(line.span.start, line.next));
        }
    }

    /// Removes a section: its header, its entries and the blank lines after them. Comments after the last
    /// entry are kept, because they probably belong to the following section.
    pub fn remove_section(&mut self, section: &Section) {
        let Some(first) = section.header.and_then(|header| self.line_at(header.line.start)) else { return };
        let last = self.line_at(end_of(section)).unwrap_or(first);
        let lines = super::Lines::from(self.document.text(), last.next);
        let blank = lines.take_while(|line| line.kind == LineKind::Blank).last();
        let end = blank.map_or(last.next, |line| line.next);
        self.remove(Span::new(first.span.start, end));
    }

    /// Inserts a section after the given one, or at the start of the document.
    pub fn insert_section(&mut self, behind: Option<&Section>, name: &str, entries: &[(&str, String)]) {
        self.check_line(name);
        for (key, value) in entries {
            self.check_line(key);
            self.check_line(value);
        }
        let mut lines: Vec<String> = vec![format!("[{name}]")];
        lines.extend(entries.iter().map(|(key, value)| format!("{key}={value}")));
        match behind {
            Some(section) => {
                lines.insert(0, String::new());
                self.insert_lines(end_of(section), &lines);
            }
            None => {
                lines.push(String::new());
                let text: String = lines.iter().flat_map(|line| [line.as_str(), self.line_end]).collect();
                self.replace(Span::empty(0), text);
            }
        }
    }

    /// Records a text that contains a line end.
    fn check_line(&mut self, text: &str) {
        if text.contains(['\n', '\r']) {
            self.many_lines.get_or_insert_with(|| text.to_owned());
        }
    }

    /// Adds lines after the line that contains `offset`, which may be the last one and lack a line end.
    fn insert_lines(&mut self, offset: u32, lines: &[String]) {
        let at = self.line_at(offset).map_or(offset, |line| line.span.end);
        let text: String = lines.iter().flat_map(|line| [self.line_end, line.as_str()]).collect();
        self.replace(Span::empty(at), text);
    }

    fn line_at(&self, offset: u32) -> Option<Line> {
        self.document.line_at(offset)
    }

    /// The edited text.
    ///
    /// # Errors
    /// If two changes overlap, or a new text contains a line end.
    pub fn text(&self) -> Result<String, EditError> {
        self.sound()?.text()
    }

    /// The edited document in the encoding of the file; without changes, the original bytes.
    ///
    /// # Errors
    /// If two changes overlap, a new text contains a line end, or the document cannot be written in the
    /// encoding of the file.
    pub fn to_bytes(&self) -> Result<Vec<u8>, EditError> {
        self.sound()?.to_bytes()
    }

    fn sound(&self) -> Result<&Edits<'a>, EditError> {
        match &self.many_lines {
            Some(text) => Err(EditError::LineEnd(text.clone())),
            None => Ok(&self.edits),
        }
    }
}

/// An offset in the last line of a section.
fn end_of(section: &Section) -> u32 {
    let header = section.header.map_or(0, |header| header.line.start);
    section.entries.last().map_or(header, |entry| entry.key.start)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::SourceFile;

    fn edit(text: &str, change: impl Fn(&mut IniEditor<'_>, &[Section])) -> String {
        let document = Document::new(SourceFile::from_text("test.eds", text));
        let mut sections = Vec::new();
        document.visit(|section| sections.push(section.clone()), |_| {});
        let mut editor = IniEditor::new(&document);
        change(&mut editor, &sections);
        editor.text().unwrap()
    }

    #[test]
    fn a_set_value_keeps_everything_around_it() {
        let edited = edit("; a\n[A]\nKey =  1  \nB=2", |editor, sections| {
            editor.set(&sections[1], "key", "17");
            editor.set(&sections[1], "C", "3");
        });
        assert_eq!(edited, "; a\n[A]\nKey =  17  \nB=2\nC=3");
    }

    #[test]
    fn removed_lines_leave_no_trace() {
        let edited = edit("[A]\r\nB=1\r\nC=2\r\n\r\n; of D\r\n[D]\r\nE=1\r\n", |editor, sections| {
            editor.remove_key(&sections[1], "b");
            editor.remove_section(&sections[2]);
        });
        assert_eq!(edited, "[A]\r\nC=2\r\n\r\n; of D\r\n");
    }

    #[test]
    fn a_new_section_stands_behind_the_last_key() {
        let entries = [("NodeID", "5".to_owned())];
        let edited = edit("[A]\nB=1\n\n[C]\n", |editor, sections| {
            editor.insert_section(Some(&sections[1]), "N", &entries);
            editor.insert_section(Some(&sections[2]), "M", &[]);
            editor.insert_section(None, "Z", &entries);
        });
        assert_eq!(edited, "[Z]\nNodeID=5\n\n[A]\nB=1\n\n[N]\nNodeID=5\n\n[C]\n\n[M]\n");
    }

    #[test]
    fn a_value_stays_in_its_line() {
        let document = Document::new(SourceFile::from_text("test.eds", "[A]\nB=1\n"));
        let mut editor = IniEditor::new(&document);
        editor.insert_section(None, "N", &[("NodeName", "x\n[1000]".to_owned())]);
        assert_eq!(editor.to_bytes(), Err(EditError::LineEnd("x\n[1000]".to_owned())));
    }
}

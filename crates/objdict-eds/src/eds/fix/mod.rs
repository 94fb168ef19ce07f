//! Applies changes of a description as edits of its text: the rest of the text remains unchanged, byte for
//! byte.

mod list;
mod section;

use std::cell::OnceCell;
use std::collections::BTreeMap;

use self::section::{SectionEdit, key_line};
use super::SectionLocator;
use super::order::Rank;
use super::section::{SectionName, section_name};
use crate::diagnostic::{Change, MAX_FIX_LINES};
use crate::ini::{self, Document, LineKind, Lines, Section};
use crate::literal::{self, Quirks};
use crate::model::{Device, Field, ModulePart, Part, Place};
use crate::source::{Edits, Span};

/// The edits for the changes, in text order; `None` if a change cannot be expressed as an edit.
pub fn edits(
    document: &Document,
    locator: &SectionLocator,
    device: &Device,
    changes: &[Change],
) -> Option<Vec<(Span, String)>> {
    let edits = Edits::new(document.source());
    let (sections, headers, added) = (BTreeMap::new(), OnceCell::new(), Vec::new());
    let mut rewriter = EdsRewriter { document, locator, device, edits, sections, headers, added };
    changes.iter().try_for_each(|change| rewriter.change(change))?;
    rewriter.finish()
}

/// A text while it is rewritten.
struct EdsRewriter<'a> {
    document: &'a Document,
    locator: &'a SectionLocator,
    device: &'a Device,
    edits: Edits<'a>,
    /// The sections with changed keys, by the start of their header lines.
    sections: BTreeMap<u32, SectionEdit>,
    /// The parts that have sections, with the starts of their header lines.
    headers: OnceCell<Vec<(Part, u32)>>,
    /// New sections, each with the part and its lines.
    added: Vec<(Part, Vec<String>)>,
}

impl<'a> EdsRewriter<'a> {
    fn change(&mut self, change: &Change) -> Option<()> {
        match change {
            Change::Replace(span, text) => self.edits.replace(*span, text.as_str()),
            Change::Set(place, value) => return self.set(place, value),
            Change::Remove(Place { part, field: Some(field) }) => return self.remove_field(part, field),
            Change::Remove(Place { part, field: None }) => return self.remove_part(part),
            Change::Add(part, fields) => return self.add(part, fields),
            Change::List(list, indexes) => return self.list(*list, indexes),
            Change::Comment(span, text) => return self.comment(*span, text),
            Change::CommentOut(span) => return self.comment_out(*span),
            Change::RemoveLine(span) => {
                let line = self.document.line_at(span.start)?;
                self.edits.replace(Span::new(line.span.start, line.next), "");
            }
            Change::RemoveSection(span) => {
                let header = self.document.line_at(span.start)?.span.start;
                return self.remove_section(&self.document.section_at(header)?);
            }
            Change::Tidy(what) => return ini::tidy(self.document, *what, &mut self.edits),
            // not an edit of the text
            Change::Encode(_) => return None,
        }
        Some(())
    }

    /// Adds a comment above the line that contains the start of a span.
    fn comment(&mut self, span: Span, text: &str) -> Option<()> {
        let at = self.document.line_at(span.start)?.span.start;
        let is_line = !text.contains(['\n', '\r']);
        let line = format!("; {}{}", text.trim_ascii(), self.document.line_end());
        is_line.then(|| self.edits.replace(Span::empty(at), line))
    }

    /// Comments out a line, or the header and keys of a section.
    fn comment_out(&mut self, span: Span) -> Option<()> {
        let line = self.document.line_at(span.start)?;
        let mut starts = vec![line.span.start];
        if matches!(line.kind, LineKind::Section { .. }) {
            let section = self.document.section_at(line.span.start)?;
            if section.entries.len() > MAX_FIX_LINES {
                return None;
            }
            starts.extend(section.entries.iter().map(|entry| entry.key.start));
        }
        for start in starts {
            let line = self.document.line_at(start)?.span;
            let indent =
                line.of(self.document.text()).bytes().take_while(|b| matches!(b, b' ' | b'\t')).count();
            self.edits.replace(Span::new(line.start, line.start + indent as u32), "; ");
        }
        Some(())
    }

    fn set(&mut self, place: &Place, value: &str) -> Option<()> {
        let field = place.field.as_ref()?;
        if let (Part::List(list), Field::Item(number)) = (&place.part, field) {
            let index = literal::integer_in_line(value, 1, 0xFFFF, &mut Quirks::default()).ok()?;
            let mut indexes = self.device.lists.get(*list).to_vec();
            *indexes.get_mut(usize::try_from(*number).ok()?.checked_sub(1)?)? = u16::try_from(index).ok()?;
            return self.list(*list, &indexes);
        }
        let (section, field) = self.holder(&place.part, field)?;
        self.edit(section)?.set(field.name().into_owned(), value.to_owned());
        Some(())
    }

    /// The section that contains a field, and its key there: an entry of a compactly stored object has no
    /// section of its own.
    fn holder(&self, part: &Part, field: &Field) -> Option<(Section, Field)> {
        match (self.section(part), part) {
            (Some(section), _) => Some((section, field.clone())),
            (None, &Part::Entry(index, sub)) => {
                let compact = self.device.object(index)?.compact.as_ref()?;
                let in_list = (1..=compact.count).contains(&sub);
                let list = match field {
                    Field::ParameterName => Part::CompactNames(index),
                    Field::ParameterValue => Part::CompactValues(index),
                    Field::Denotation => Part::CompactDenotations(index),
                    _ => return None,
                };
                let section = self.section(&list).filter(|_| in_list)?;
                Some((section, Field::Item(sub.into())))
            }
            (None, _) => None,
        }
    }

    fn remove_field(&mut self, part: &Part, field: &Field) -> Option<()> {
        if let (Part::List(list), Field::Item(number)) = (part, field) {
            let mut indexes = self.device.lists.get(*list).to_vec();
            let position = usize::try_from(*number).ok()?.checked_sub(1)?;
            (position < indexes.len()).then(|| indexes.remove(position))?;
            return self.list(*list, &indexes);
        }
        let (section, field) = self.holder(part, field)?;
        let name = field.name();
        self.edit(section)?.remove(&name).then_some(())
    }

    /// Removes all sections of a part: an object with its sub-indexes and related sections.
    fn remove_part(&mut self, part: &Part) -> Option<()> {
        let sections = match *part {
            Part::Object(index) => self.sections_of(|part| part.object() == Some(index)),
            Part::Module(number, ModulePart::Info) => {
                self.sections_of(|part| matches!(part, Part::Module(other, _) if *other == number))
            }
            _ => self.locator.sections(self.document, part).collect(),
        };
        for section in &sections {
            self.remove_section(section)?;
        }
        (!sections.is_empty()).then_some(())
    }

    /// Removes a section with the blank lines after it. Comments after the last key are kept if they
    /// probably belong to the following section.
    fn remove_section(&mut self, section: &Section) -> Option<()> {
        let header = section.header?;
        let last = self.document.line_at(end_of(self.document, section))?;
        let lines = Lines::from(self.document.text(), last.next);
        let blank = lines.take_while(|line| line.kind == LineKind::Blank).last();
        let end = blank.map_or(last.next, |line| line.next);
        self.edits.replace(Span::new(header.line.start, end), "");
        Some(())
    }

    fn add(&mut self, part: &Part, fields: &[(Field, String)]) -> Option<()> {
        if self.section(part).is_some() {
            return None;
        }
        let mut lines = vec![format!("[{}]", section_name(part)?)];
        for (field, value) in fields {
            lines.push(key_line(&field.name(), value)?);
        }
        self.added.push((part.clone(), lines));
        Some(())
    }

    /// The section of a part; the first if there are several.
    fn section(&self, part: &Part) -> Option<Section> {
        self.locator.sections(self.document, part).next()
    }

    /// The keys of a section, for changes; `None` if there are too many.
    fn edit(&mut self, section: Section) -> Option<&mut SectionEdit> {
        if section.entries.len() > MAX_FIX_LINES {
            return None;
        }
        let start = section.header?.line.start;
        Some(self.sections.entry(start).or_insert_with(|| SectionEdit::new(self.document, section)))
    }

    fn sections_of(&self, wanted: impl Fn(&Part) -> bool) -> Vec<Section> {
        let headers = self.headers.get_or_init(|| {
            let text = self.document.text();
            let of_line = |line: ini::Line| match line.kind {
                LineKind::Section { name } => Some((SectionName::parse(name.of(text)).part, line.span.start)),
                _ => None,
            };
            self.document.headers().filter_map(of_line).collect()
        });
        let found = headers.iter().filter(|(part, _)| wanted(part));
        found.filter_map(|(_, start)| self.document.section_at(*start)).collect()
    }

    fn finish(mut self) -> Option<Vec<(Span, String)>> {
        for section in std::mem::take(&mut self.sections).into_values() {
            section.finish(self.document, &mut self.edits)?;
        }
        self.insert_sections()?;
        self.edits.into_list().ok()
    }

    /// Inserts new sections after their predecessors in the canonical order.
    fn insert_sections(&mut self) -> Option<()> {
        let mut added = std::mem::take(&mut self.added);
        if added.is_empty() {
            return Some(());
        }
        added.sort_by_key(|(part, _)| Rank::of(part));
        let line_end = self.document.line_end();
        let outline = self.locator.outline(self.document);
        for (part, lines) in added {
            let text = lines.join(line_end);
            let before = outline.iter().filter(|(rank, _)| rank.is_known() && *rank < Rank::of(&part));
            match before.max_by_key(|(rank, start)| (*rank, *start)) {
                Some(&(_, start)) => {
                    let section = self.document.section_at(start)?;
                    let last = self.document.line_at(end_of(self.document, &section))?;
                    let text = format!("{line_end}{line_end}{text}");
                    self.edits.replace(Span::empty(last.span.end), text);
                }
                None => {
                    let (_, first) = outline.first()?;
                    self.edits.replace(Span::empty(*first), format!("{text}{line_end}{line_end}"));
                }
            }
        }
        Some(())
    }
}

/// An offset in the last line of a section: its last key, or a tool setting in a comment directly after
/// it.
fn end_of(document: &Document, section: &Section) -> u32 {
    let header = section.header.map_or(0, |header| header.line.start);
    let last = section.entries.last().map_or(header, |entry| entry.key.start);
    let mut end = last;
    let behind = document.line_at(last).map_or(last, |line| line.next);
    for line in Lines::from(document.text(), behind) {
        let text = line.span.of(document.text());
        let is_setting = text.starts_with(";S") || text.starts_with(";C");
        if line.kind != LineKind::Comment || !is_setting || !text.contains('=') {
            break;
        }
        end = line.span.start;
    }
    end
}

/// The spelling of an index in lists.
fn index_text(index: u16) -> String {
    format!("0x{index:04X}")
}

/// The keys of a list of objects.
fn list_lines(indexes: &[u16]) -> Vec<(Field, String)> {
    let items = (1..).zip(indexes).map(|(number, index)| (Field::Item(number), index_text(*index)));
    std::iter::once((Field::SupportedObjects, indexes.len().to_string())).chain(items).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Fix;
    use crate::model::{DeviceKind, ObjectList};
    use crate::source::SourceFile;

    const TEXT: &str = "; made by hand\n[DeviceInfo]\nVendorName=A\n\n[OptionalObjects]\nSupportedObjects=2\n1=0x1003\n\
        2=0x1017 \n\n[1003]\nParameterName=Errors\nObjectType=8\nDataType=7\nCompactSubObj=2\n;StorageLocation=RAM\n\n\
        [1003Value]\nNrOfEntries=1\n1=5\n\n; last\n[1017]\nParameterName=Time\nLowLimit=1";

    fn fixed(text: &str, fix: &Fix) -> Option<String> {
        let document = Document::new(SourceFile::from_text("test.eds", text));
        let (device, _) = crate::eds::read(&document, DeviceKind::Node);
        let mut edits = Edits::new(document.source());
        for (span, text) in super::edits(&document, &SectionLocator::new(&document), &device, &fix.changes)? {
            edits.replace(span, text);
        }
        Some(edits.text().unwrap())
    }

    /// Asserts the replacements of `fix`, as pairs of old and new text.
    fn assert_fixes(fix: &Fix, replacements: &[(&str, &str)]) {
        let mut expected = TEXT.to_owned();
        for (old, new) in replacements {
            assert_eq!(expected.matches(old).count(), 1, "{old}");
            expected = expected.replace(old, new);
        }
        assert_eq!(fixed(TEXT, fix).as_deref(), Some(expected.as_str()));
    }

    fn list(indexes: &[u16]) -> Fix {
        Fix::safe("").with(Change::List(ObjectList::Optional, indexes.to_vec()))
    }

    #[test]
    fn fields_are_set_where_they_belong() {
        let place = |field| Place::object(0x1017).field(field);
        let fix = Fix::safe("").set(place(Field::LowLimit), "0x2").set(place(Field::DataType), "0x0006");
        assert_fixes(&fix, &[("Name=Time", "Name=Time\nDataType=0x0006"), ("LowLimit=1", "LowLimit=0x2")]);
        let fix = Fix::safe("").set(Place::object(0x1018).field(Field::DataType), "0x0006");
        assert_eq!(fixed(TEXT, &fix), None, "there is no such section");
        let fix = Fix::safe("").set(place(Field::LowLimit), "1\n[1018]");
        assert_eq!(fixed(TEXT, &fix), None, "no value of one line");
        assert_fixes(&Fix::safe("").set(place(Field::LowLimit), "1"), &[]);
    }

    #[test]
    fn compact_entries_have_their_fields_in_lists() {
        let place = |sub, field| Place::entry(0x1003, sub).field(field);
        let fix = Fix::safe("").set(place(2, Field::ParameterValue), "7");
        assert_fixes(&fix, &[("Entries=1\n1=5", "Entries=2\n1=5\n2=7")]);
        let fix = Fix::safe("").remove(place(1, Field::ParameterValue));
        assert_fixes(&fix, &[("Entries=1\n1=5\n", "Entries=0\n")]);
        for place in
            [place(3, Field::ParameterValue), place(1, Field::DefaultValue), place(1, Field::ParameterName)]
        {
            assert_eq!(fixed(TEXT, &Fix::safe("").set(place.clone(), "7")), None, "{place}");
        }
    }

    #[test]
    fn lists_are_numbered_again() {
        assert_fixes(&list(&[0x1017]), &[("Objects=2\n1=0x1003\n2=", "Objects=1\n1=")]);
        assert_fixes(
            &list(&[0x1002, 0x1003, 0x1005, 0x1017]),
            &[("Objects=2\n1=0x1003\n2=", "Objects=4\n1=0x1002\n2=0x1003\n3=0x1005\n4=")],
        );
        assert_fixes(&list(&[0x1017, 0x1003]), &[("1=0x1003\n2=0x1017 \n", "1=0x1017\n2=0x1003\n")]);
        assert_fixes(&list(&[]), &[("Objects=2\n1=0x1003\n2=0x1017 \n", "Objects=0\n")]);
        let fix = Fix::safe("").remove(Place::of(Part::List(ObjectList::Optional)).field(Field::Item(2)));
        assert_fixes(&fix, &[("Objects=2\n1=0x1003\n2=0x1017 \n", "Objects=1\n1=0x1003\n")]);
    }

    #[test]
    fn new_sections_come_into_their_order() {
        let add = |part| crate::diagnostic::Change::Add(part, vec![(Field::ParameterName, "X".to_owned())]);
        let behind = |part| Fix::safe("").with(add(part));
        let new = |name| format!("\n\n[{name}]\nParameterName=X");
        for (part, name, anchor) in [
            (Part::Object(0x1005), "1005", "1=5"),
            (Part::Entry(0x1003, 0), "1003sub0", ";StorageLocation=RAM"),
            (Part::Object(0x2000), "2000", "LowLimit=1"),
            (Part::DummyUsage, "DummyUsage", "VendorName=A"),
        ] {
            assert_fixes(&behind(part), &[(anchor, &format!("{anchor}{}", new(name)))]);
        }
        let first = "[FileInfo]\nParameterName=X\n\n[DeviceInfo]";
        assert_fixes(&behind(Part::FileInfo), &[("[DeviceInfo]", first)]);
        assert_eq!(fixed(TEXT, &behind(Part::Object(0x1003))), None, "it is there");
        let two = Fix::safe("").with(add(Part::Entry(0x1003, 1))).with(add(Part::Entry(0x1003, 0)));
        let both = format!(";StorageLocation=RAM{}{}", new("1003sub0"), new("1003sub1"));
        assert_fixes(&two, &[(";StorageLocation=RAM", &both)]);
    }

    #[test]
    fn an_object_goes_with_all_that_belongs_to_it() {
        let fix = Fix::safe("").remove(Place::object(0x1003));
        let start = TEXT.find("[1003]").unwrap();
        let end = TEXT.find("; last").unwrap();
        assert_fixes(&fix, &[(&TEXT[start..end], "")]);
    }
}

//! Edits of the keys of one section.

use crate::eds::keys::FieldKey;
use crate::eds::misspelt;
use crate::eds::order::{COUNTERS, counter_of, key_rank};
use crate::eds::section::SectionName;
use crate::ini::{Document, IniEntry, LineKind, Lines, Section};
use crate::model::{Field, Part};
use crate::source::{Edits, Span};

/// A section whose keys are edited.
pub(super) struct SectionEdit {
    section: Section,
    part: Part,
    lines: Vec<KeyLine>,
    /// The key with the number of items, if that number was correct.
    counter: Option<Field>,
}

/// An existing, changed or new key.
pub(super) struct KeyLine {
    /// The entry in the text; `None` for a new key.
    pub entry: Option<IniEntry>,
    pub key: String,
    /// The new value, if it changes.
    pub value: Option<String>,
    pub is_removed: bool,
}

impl KeyLine {
    /// Whether the key of the line is a misspelt `key`.
    fn is_misspelt(&self, part: &Part, key: &str) -> bool {
        FieldKey::find(key).is_some_and(|key| {
            FieldKey::find(&self.key).is_none() && misspelt::key(part, &self.key) == Some(key)
        })
    }
}

impl SectionEdit {
    pub(super) fn new(document: &Document, section: Section) -> Self {
        let text = document.text();
        let lines: Vec<KeyLine> = section
            .entries
            .iter()
            .map(|entry| KeyLine {
                entry: Some(*entry),
                key: entry.key.of(text).to_owned(),
                value: None,
                is_removed: false,
            })
            .collect();
        let part =
            section.header.map_or(Part::Device, |header| SectionName::parse(header.name.of(text)).part);
        let counter = counter_of(&part).filter(|counter| {
            let items = lines.iter().filter(|line| Field::item(&line.key).is_some()).count();
            let stated = section.entries.iter().find(|entry| is_key(entry.key.of(text), counter));
            stated.is_some_and(|entry| entry.value.of(text) == items.to_string())
        });
        Self { section, part, lines, counter }
    }

    /// Sets a key: in its existing line, or in a new line after its predecessors in canonical order.
    pub(super) fn set(&mut self, key: String, value: String) {
        if let Some(line) = line_of(&mut self.lines, &self.part, &key) {
            line.value = Some(value);
            return;
        }
        let position = self.position_of(&key);
        self.lines.insert(position, KeyLine { entry: None, key, value: Some(value), is_removed: false });
    }

    /// Removes all lines of a key; `false` if the section does not have it.
    pub(super) fn remove(&mut self, key: &str) -> bool {
        let mut found = false;
        let is_of =
            |line: &&mut KeyLine| line.key.eq_ignore_ascii_case(key) || line.is_misspelt(&self.part, key);
        for line in self.lines.iter_mut().filter(is_of) {
            line.is_removed = true;
            found = true;
        }
        found
    }

    /// All keys, for changes.
    pub(super) fn lines_mut(&mut self) -> &mut Vec<KeyLine> {
        // the caller also updates the count
        self.counter = None;
        &mut self.lines
    }

    /// The position after the last key that precedes `key`, or after all keys if `key` has no defined
    /// position.
    fn position_of(&self, key: &str) -> usize {
        let Some(rank) = key_rank(key) else { return self.lines.len() };
        let before = self
            .lines
            .iter()
            .enumerate()
            .filter(|(_, line)| key_rank(&line.key).is_some_and(|other| other <= rank));
        let last = before.max_by_key(|(position, line)| (key_rank(&line.key), *position));
        last.map_or(0, |(position, _)| position + 1)
    }

    fn count(&mut self) {
        let Some(counter) = self.counter.take() else { return };
        let is_item = |line: &&KeyLine| !line.is_removed && Field::item(&line.key).is_some();
        let items = self.lines.iter().filter(is_item).count();
        self.set(counter.name().into_owned(), items.to_string());
    }

    /// Adds the edits; `None` if a new line would not be read back unchanged.
    pub(super) fn finish(mut self, document: &Document, edits: &mut Edits<'_>) -> Option<()> {
        self.count();
        let text = document.text();
        let line_end = document.line_end();
        // after the last existing line
        let mut last = self.section.header?.line.start;
        for line in &self.lines {
            let value = line.value.as_deref();
            match line.entry {
                Some(entry) if line.is_removed => {
                    let whole = document.line_at(entry.key.start)?;
                    edits.replace(Span::new(whole.span.start, whole.next), "");
                }
                Some(entry) => {
                    if entry.key.of(text) != line.key {
                        edits.replace(entry.key, line.key.as_str());
                    }
                    if let Some(value) = value.filter(|value| entry.value.of(text) != *value) {
                        key_line(&line.key, value)?;
                        edits.replace(entry.value, value);
                    }
                    last = entry.key.start;
                }
                None if line.is_removed => {}
                None => {
                    let new = key_line(&line.key, value.unwrap_or_default())?;
                    let at = document.line_at(last)?.span.end;
                    edits.replace(Span::empty(at), format!("{line_end}{new}"));
                }
            }
        }
        Some(())
    }
}

/// The line of a key with the spelling `key`; a misspelt key gets the correct name.
pub(super) fn line_of<'a>(lines: &'a mut [KeyLine], part: &Part, key: &str) -> Option<&'a mut KeyLine> {
    let find =
        |is_of: &dyn Fn(&KeyLine) -> bool| lines.iter().position(|line| !line.is_removed && is_of(line));
    if let Some(position) = find(&|line| line.key.eq_ignore_ascii_case(key)) {
        return lines.get_mut(position);
    }
    let position = find(&|line| line.is_misspelt(part, key))?;
    let line = lines.get_mut(position)?;
    key.clone_into(&mut line.key);
    Some(line)
}

/// Whether a key names a field.
pub(super) fn is_key(key: &str, field: &Field) -> bool {
    key.eq_ignore_ascii_case(&field.name())
}

/// Whether a key contains a number of items.
pub(super) fn is_counter(key: &str) -> bool {
    COUNTERS.iter().any(|counter| is_key(key, counter))
}

/// Formats `key=value`, if a reader reads back the same key and value.
pub(super) fn key_line(key: &str, value: &str) -> Option<String> {
    let line = format!("{key}={value}");
    let mut lines = Lines::new(&line);
    let is_entry = match lines.next()?.kind {
        LineKind::Entry { key: read, value: text } => read.of(&line) == key && text.of(&line) == value,
        _ => false,
    };
    (is_entry && lines.next().is_none()).then_some(line)
}

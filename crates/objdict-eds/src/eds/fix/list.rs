//! Edits of a numbered list: items that remain keep their lines.

use std::collections::{HashMap, HashSet};

use super::section::{KeyLine, is_counter, line_of};
use super::{EdsRewriter, index_text, list_lines};
use crate::eds::order::counter_of;
use crate::ini::Section;
use crate::literal::{self, Quirks};
use crate::model::{Field, ObjectList, Part};

impl EdsRewriter<'_> {
    /// Sets the indexes of a list of objects.
    pub(super) fn list(&mut self, list: ObjectList, indexes: &[u16]) -> Option<()> {
        let part = Part::List(list);
        let mut sections = self.locator.sections(self.document, &part);
        let Some(first) = sections.next() else {
            return self.add(&part, &list_lines(indexes));
        };
        let others: Vec<Section> = sections.collect();
        for other in &others {
            // other content of the section would be lost
            let is_plain = other.comments.is_empty() && self.has_only_items(other);
            is_plain.then(|| self.remove_section(other))??;
        }
        self.rewrite_items(first, &part, indexes)
    }

    fn has_only_items(&self, section: &Section) -> bool {
        let text = self.document.text();
        section.entries.iter().all(|entry| {
            is_counter(entry.key.of(text))
                || (is_item(entry.key.of(text)) && index_of(entry.value.of(text)).is_some())
        })
    }

    /// Keeps lines whose index is in order, and renumbers them if needed. Items that are not an index are
    /// also kept and numbered.
    fn rewrite_items(&mut self, section: Section, part: &Part, indexes: &[u16]) -> Option<()> {
        let text = self.document.text();
        let counter = counter_of(part)?;
        let lines = self.edit(section)?.lines_mut();
        let mut wanted = indexes.iter().copied();
        let mut left: HashMap<u16, u32> = HashMap::new();
        indexes.iter().for_each(|&index| *left.entry(index).or_default() += 1);
        let mut seen = HashSet::new();
        let mut rewritten: Vec<KeyLine> = Vec::new();
        let new = |index: u16| KeyLine {
            entry: None,
            key: String::new(),
            value: Some(index_text(index)),
            is_removed: false,
        };
        for mut line in std::mem::take(lines) {
            let Some(entry) = line.entry.filter(|_| is_item(&line.key)) else {
                rewritten.push(line);
                continue;
            };
            if !seen.insert(line.key.to_ascii_lowercase()) {
                // a number used twice is reported by another rule
                return None;
            }
            if let Some(index) = index_of(entry.value.of(text)) {
                let is_wanted = left.get(&index).is_some_and(|&count| count > 0);
                line.is_removed = !is_wanted;
                while is_wanted && let Some(next) = wanted.next() {
                    *left.entry(next).or_default() -= 1;
                    if next == index {
                        break;
                    }
                    rewritten.push(new(next));
                }
            }
            rewritten.push(line);
        }
        rewritten.extend(wanted.map(new));
        *lines = rewritten;
        number(lines, part, &counter);
        Some(())
    }
}

/// Numbers the items from 1, and updates their count.
fn number(lines: &mut Vec<KeyLine>, part: &Part, counter: &Field) {
    let mut number = 0;
    for line in lines.iter_mut() {
        let is_new = line.entry.is_none() && line.key.is_empty();
        if !line.is_removed && (is_new || is_item(&line.key)) {
            number += 1;
            line.key = Field::Item(number).name().into_owned();
        }
    }
    let name = counter.name();
    let count = Some(number.to_string());
    match line_of(lines, part, &name) {
        Some(line) => line.value = count,
        None => {
            let line = KeyLine { entry: None, key: name.into_owned(), value: count, is_removed: false };
            lines.insert(0, line);
        }
    }
}

/// Whether a key belongs to an item, in any spelling.
fn is_item(key: &str) -> bool {
    key.bytes().next().is_some_and(|byte| byte.is_ascii_digit())
}

fn index_of(value: &str) -> Option<u16> {
    let index = literal::integer_in_line(value, 1, u64::from(u16::MAX), &mut Quirks::default()).ok()?;
    u16::try_from(index).ok()
}

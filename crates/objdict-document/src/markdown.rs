//! A page of Markdown as forges render it: headings, tables, lists, and nothing that only one of them knows.

use std::borrow::Cow;

use askama::Template;

use super::details::{Details, Part};
use super::entry::EntryView;
use super::escape::filters;
use super::object::ObjectView;
use super::page::Page;
use super::texts::Texts;

/// An array with more entries than this is folded.
const LONG: usize = 10;

#[derive(Template)]
#[template(path = "markdown/page.md")]
struct PageTemplate<'a> {
    page: &'a Page<'a>,
    version: &'static str,
}

/// A line of a cell.
struct Line<'a> {
    /// What the text is called; may be empty.
    label: Cow<'a, str>,
    /// Whether the label stands so in the file.
    is_key: bool,
    text: Cow<'a, str>,
    /// Numbers with their names.
    values: Vec<(String, &'a str)>,
}

impl<'a> Line<'a> {
    fn new(label: impl Into<Cow<'a, str>>, text: impl Into<Cow<'a, str>>) -> Self {
        Self { label: label.into(), is_key: false, text: text.into(), values: Vec::new() }
    }

    fn key(label: impl Into<Cow<'a, str>>, text: impl Into<Cow<'a, str>>) -> Self {
        Self { is_key: true, ..Self::new(label, text) }
    }

    fn part(part: &Part<'a>, texts: &Texts) -> Self {
        Self {
            values: part.values.clone(),
            ..Self::key(format!("{} {}", texts.bit, part.range()), part.name)
        }
    }
}

impl<'a> PageTemplate<'a> {
    /// What the last column of an entry says.
    fn lines_of_entry(&self, entry: &'a EntryView<'a>) -> Vec<Line<'a>> {
        let mut lines: Vec<Line<'a>> =
            entry.own_name.iter().map(|name| Line::key(name.as_ref(), "")).collect();
        lines.extend(entry.meaning.as_deref().map(|meaning| Line::new("", meaning)));
        if entry.has_limits() {
            lines.push(Line::new(self.page.texts.limits, format!("{} … {}", entry.low, entry.high)));
        }
        self.add(&entry.details, &mut lines);
        lines
    }

    /// What is said of an object as a whole.
    fn lines_of_object(&self, object: &'a ObjectView<'a>) -> Vec<Line<'a>> {
        let mut lines: Vec<Line<'a>> =
            object.own_name.iter().map(|name| Line::key(name.as_ref(), "")).collect();
        self.add(&object.details, &mut lines);
        lines
    }

    fn add(&self, details: &'a Details<'a>, lines: &mut Vec<Line<'a>>) {
        let texts = self.page.texts;
        lines.extend(details.description.as_deref().map(|text| Line::new("", text)));
        lines.extend(details.allowed.as_deref().map(|values| Line::new(texts.allowed, values)));
        lines.extend(details.unit.as_deref().map(|unit| Line::new(texts.unit, unit)));
        lines.extend(details.denotation.as_deref().map(|text| Line::new(texts.denotation, text)));
        lines.extend(details.carried_by.as_deref().map(|pdos| Line::new(texts.mapped, pdos)));
        lines.extend(details.facts.iter().map(|(name, text)| Line::new(*name, text)));
        lines.extend(details.keys.iter().map(|(name, text)| Line::key(name, text)));
        if !details.values.is_empty() {
            let values = details.values.iter().map(|&(number, name)| (number.to_string(), name));
            lines.push(Line { values: values.collect(), ..Line::new("", "") });
        }
        lines.extend(details.parts.iter().chain(&details.word).map(|part| Line::part(part, texts)));
        lines.extend(details.word_of.map(|first| Line::new(texts.bits_as, first.spoken())));
    }

    /// Whether an object has so many entries that are alike that it is folded.
    fn is_long(&self, object: &ObjectView<'_>) -> bool {
        object.is_array && object.entries.len() > LONG
    }
}

/// The page as Markdown.
pub(super) fn write(page: &Page<'_>) -> String {
    let template = PageTemplate { page, version: env!("CARGO_PKG_VERSION") };
    // about what an entry takes, so that the text is not moved while it grows
    let mut text = String::with_capacity(10_000 + 200 * page.entry_count());
    // a String takes every text, and no filter of the templates fails
    let _ = template.render_into(&mut text);
    text.push('\n');
    text
}

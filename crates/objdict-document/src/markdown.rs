//! Markdown output as forges render it: headings, tables, lists, and no site-specific markup.

use std::borrow::Cow;

use askama::Template;

use super::details::{BitPart, Details};
use super::entry::EntryView;
use super::escape::filters;
use super::html::rendered;
use super::object::ObjectView;
use super::page::Page;
use super::texts::LanguageTexts;

/// Larger arrays are folded.
const LONG: usize = 10;

#[derive(Template)]
#[template(path = "markdown/page.md")]
struct MarkdownPage<'a> {
    page: &'a Page<'a>,
}

/// A line of a table cell.
struct CellLine<'a> {
    /// The label; may be empty.
    label: Cow<'a, str>,
    /// Whether the label is a key of the file.
    is_key: bool,
    text: Cow<'a, str>,
    /// PDOs of the page.
    pdos: &'a [String],
    /// Numbers with their names.
    values: Vec<(String, &'a str)>,
}

impl<'a> CellLine<'a> {
    fn new(label: impl Into<Cow<'a, str>>, text: impl Into<Cow<'a, str>>) -> Self {
        Self { label: label.into(), is_key: false, text: text.into(), pdos: &[], values: Vec::new() }
    }

    fn key(label: impl Into<Cow<'a, str>>, text: impl Into<Cow<'a, str>>) -> Self {
        Self { is_key: true, ..Self::new(label, text) }
    }

    fn part(part: &BitPart<'a>, texts: &LanguageTexts) -> Self {
        Self {
            values: part.values.clone(),
            ..Self::key(format!("{} {}", texts.bit, part.range()), part.name)
        }
    }
}

impl<'a> MarkdownPage<'a> {
    /// The last column of an entry.
    fn lines_of_entry(&self, entry: &'a EntryView<'a>) -> Vec<CellLine<'a>> {
        let mut lines: Vec<CellLine<'a>> =
            entry.own_name.iter().map(|name| CellLine::key(name.as_ref(), "")).collect();
        lines.extend(entry.meaning.as_deref().map(|meaning| CellLine::new("", meaning)));
        if entry.has_limits() {
            lines.push(CellLine::new(self.page.texts.limits, format!("{} … {}", entry.low, entry.high)));
        }
        self.add(&entry.details, &mut lines);
        lines
    }

    /// The details of the whole object.
    fn lines_of_object(&self, object: &'a ObjectView<'a>) -> Vec<CellLine<'a>> {
        let mut lines: Vec<CellLine<'a>> =
            object.own_name.iter().map(|name| CellLine::key(name.as_ref(), "")).collect();
        self.add(&object.details, &mut lines);
        lines
    }

    fn add(&self, details: &'a Details<'a>, lines: &mut Vec<CellLine<'a>>) {
        let texts = self.page.texts;
        lines.extend(details.description.as_deref().map(|text| CellLine::new("", text)));
        lines.extend(details.allowed.as_deref().map(|values| CellLine::new(texts.allowed, values)));
        lines.extend(details.unit.as_deref().map(|unit| CellLine::new(texts.unit, unit)));
        lines.extend(details.denotation.as_deref().map(|text| CellLine::new(texts.denotation, text)));
        if !details.carried_by.is_empty() {
            lines.push(CellLine { pdos: &details.carried_by, ..CellLine::new(texts.mapped, "") });
        }
        lines.extend(details.facts.iter().map(|(name, text)| CellLine::new(*name, text)));
        lines.extend(details.keys.iter().map(|(name, text)| CellLine::key(name, text)));
        if !details.values.is_empty() {
            let values = details.values.iter().map(|&(number, name)| (number.to_string(), name));
            lines.push(CellLine { values: values.collect(), ..CellLine::new("", "") });
        }
        lines.extend(details.parts.iter().chain(&details.word).map(|part| CellLine::part(part, texts)));
        lines.extend(details.word_of.map(|first| CellLine::new(texts.bits_as, first.spoken())));
    }

    /// Whether an object is folded because it has many similar entries.
    fn is_long(&self, object: &ObjectView<'_>) -> bool {
        object.is_array && object.entries.len() > LONG
    }
}

/// Writes the page as Markdown.
pub(super) fn write(page: &Page<'_>) -> String {
    // approximate size per entry, to avoid reallocation
    rendered(&MarkdownPage { page }, 10_000 + 200 * page.entry_count()) + "\n"
}

//! Collects sections during writing: every string passes through here, so that none can contain a line end.

use std::borrow::Cow;

use crate::eds::Style;
use crate::eds::section::{SectionName, section_name};
use crate::model::{EMBEDDED_COMMENT, EMBEDDED_SECTION, Extra, ExtraSection, Field, InvalidValues, Part};
use crate::source::transliterate;

/// The sections of a description, in order.
pub(super) struct SectionWriter<'a> {
    pub(super) options: &'a Style,
    sections: Vec<CleanSection>,
    /// Keys without a field in the model, by the known section they belong to.
    extras: Vec<(Part, Extra)>,
    /// The comment lines at the end, for content that the format does not support.
    embedded: Vec<String>,
}

/// A section with cleaned keys and values.
struct CleanSection {
    part: Part,
    /// Empty for the keys before the first section.
    name: String,
    entries: Vec<(String, String)>,
}

impl<'a> SectionWriter<'a> {
    /// A writer without sections; `extra` are unknown sections, and unknown keys of known ones.
    pub(super) fn new(options: &'a Style, extra: &[ExtraSection]) -> Self {
        let extras = extra.iter().map(|section| (SectionName::parse(section.name()).part, section));
        let extras = extras.filter(|(part, _)| !matches!(part, Part::Section(_)));
        let extras = extras.map(|(part, section)| (part, section.entries().collect())).collect();
        Self { options, sections: Vec::new(), extras, embedded: Vec::new() }
    }

    /// Starts the section of a part; the following keys are added to it.
    pub(super) fn open(&mut self, part: Part) {
        let name = section_name(&part).unwrap_or_default();
        self.sections.push(CleanSection { part, name, entries: Vec::new() });
    }

    /// Writes a key with its value, unless the unknown keys of the section already contain it: the
    /// original text has priority.
    pub(super) fn put(&mut self, field: &Field, value: impl AsRef<str>) {
        let Some(part) = self.sections.last().map(|section| section.part.clone()) else { return };
        let key = field.name().into_owned();
        if self.is_taken(&part, &key) {
            return;
        }
        let value = self.clean(value.as_ref());
        self.push(key, value);
    }

    /// Writes a key if it has a value.
    pub(super) fn put_some(&mut self, field: &Field, value: Option<impl AsRef<str>>) {
        if let Some(value) = value {
            self.put(field, value);
        }
    }

    /// Writes a key with 0 or 1 if it has a value.
    pub(super) fn put_flag(&mut self, field: &Field, flag: Option<bool>) {
        self.put_some(field, flag.map(|flag| if flag { "1" } else { "0" }));
    }

    /// Writes a key with a decimal number if it has a value.
    pub(super) fn put_number(&mut self, field: &Field, number: Option<impl Into<u64>>) {
        self.put_some(field, number.map(|number| number.into().to_string()));
    }

    /// A comment that is a setting of a tool: `;StorageLocation=RAM`.
    pub(super) fn comment(&mut self, name: &str, value: &str) {
        let value = self.clean(value);
        // a line with a semicolon is written like a key and read as a comment
        self.push(format!(";{name}"), value);
    }

    /// A count with numbered items.
    pub(super) fn list(&mut self, counter: &Field, items: impl ExactSizeIterator<Item = String>) {
        let taken = self.sections.last().and_then(|section| self.extra_of(&section.part));
        let taken =
            taken.map_or(0, |extra| extra.iter().filter(|(key, _)| Field::item(key).is_some()).count());
        self.put(counter, (items.len() + taken).to_string());
        let mut number = 0;
        for item in items {
            number += 1;
            while self
                .sections
                .last()
                .is_some_and(|section| self.is_taken(&section.part, &number.to_string()))
            {
                number += 1;
            }
            self.put(&Field::Item(number), item);
        }
    }

    /// Unknown keys.
    pub(super) fn extra<'b>(&mut self, extra: impl Iterator<Item = (&'b str, &'b str)>) {
        for (key, value) in extra {
            let (key, value) = (self.clean_key(key), self.clean(value));
            self.push(key, value);
        }
    }

    /// Texts that are not valid in their fields, as written.
    pub(super) fn invalid_values(&mut self, invalid_values: &InvalidValues) {
        for invalid in invalid_values.iter() {
            self.put(&invalid.field, &invalid.text);
        }
    }

    /// Ends the section with its unparsed content.
    pub(super) fn close_with(&mut self, extra: &Extra, invalid_values: &InvalidValues) {
        self.extra(extra.iter());
        self.invalid_values(invalid_values);
        self.close();
    }

    /// Ends the section with its unknown keys.
    pub(super) fn close(&mut self) {
        let Some(part) = self.sections.last().map(|section| section.part.clone()) else { return };
        while let Some(position) = self.extras.iter().position(|(other, _)| *other == part) {
            let (_, extra) = self.extras.remove(position);
            self.extra(extra.iter());
        }
    }

    /// Writes unknown sections, and unknown keys of known sections that were not written. Content that only an XDD
    /// supports does not become a section.
    pub(super) fn rest(&mut self, extra: &[ExtraSection]) {
        for section in extra {
            let part = SectionName::parse(section.name()).part;
            match part {
                Part::Section(_) if section.name() == EMBEDDED_SECTION => self.embed(section),
                Part::Section(_) if section.name().starts_with("xml:") => {}
                Part::Section(_) => {
                    let name = self.clean_name(section.name());
                    self.sections.push(CleanSection { part, name, entries: Vec::new() });
                    self.extra(section.entries());
                }
                part if self.extras.iter().any(|(other, _)| *other == part) => {
                    self.open(part);
                    self.close();
                }
                _ => {}
            }
        }
    }

    fn embed(&mut self, section: &ExtraSection) {
        let lines = section
            .entries()
            .map(|(key, value)| format!(";{EMBEDDED_COMMENT}{}={}", self.clean_key(key), self.clean(value)));
        self.embedded = lines.collect();
    }

    /// The text. Keys without a section come first, because no header may precede them.
    pub(super) fn finish(mut self) -> String {
        const END: &str = "\r\n";
        self.sections.sort_by_key(|section| !section.name.is_empty());
        let mut text = String::new();
        let mut has_keys = false;
        for CleanSection { name, entries, .. } in &self.sections {
            if has_keys && !entries.is_empty() && !name.is_empty() {
                text.push_str(END);
            }
            has_keys |= !entries.is_empty();
            if !name.is_empty() {
                text.extend(["[", name, "]", END]);
            }
            for (key, value) in entries {
                text.extend([key, "=", value, END]);
            }
        }
        // separated from the last section, so that they do not move with it
        let apart = self.embedded.first().map(|_| "");
        apart
            .into_iter()
            .chain(self.embedded.iter().map(String::as_str))
            .for_each(|line| text.extend([line, END]));
        text
    }

    fn push(&mut self, key: String, value: String) {
        if let Some(section) = self.sections.last_mut() {
            section.entries.push((key, value));
        }
    }

    fn extra_of(&self, part: &Part) -> Option<&Extra> {
        self.extras.iter().find(|(other, _)| other == part).map(|(_, extra)| extra)
    }

    fn is_taken(&self, part: &Part, key: &str) -> bool {
        self.extra_of(part).is_some_and(|extra| extra.get(key).is_some())
    }

    /// A string without line ends, in the encoding, that is read back unchanged.
    fn clean(&self, text: &str) -> String {
        self.clean_characters(text).trim_matches(BLANKS).to_owned()
    }

    /// A string that is read back as a key.
    fn clean_key(&self, key: &str) -> String {
        let clean = self.clean_characters(key).replace('=', " ");
        let trimmed = clean.trim_matches(BLANKS);
        let is_key =
            !trimmed.is_empty() && !trimmed.starts_with([';', '#', '[']) && !trimmed.starts_with("//");
        if is_key { trimmed.to_owned() } else { format!("_{trimmed}") }
    }

    /// A string that is read back as a section name. The empty name belongs to the keys before the
    /// first section.
    fn clean_name(&self, name: &str) -> String {
        let written = self.clean_characters(name).replace(']', " ").trim_matches(BLANKS).to_owned();
        if written.is_empty() && !name.is_empty() { "_".to_owned() } else { written }
    }

    fn clean_characters<'t>(&self, text: &'t str) -> Cow<'t, str> {
        if text.bytes().all(|byte| (0x20..0x7F).contains(&byte) || byte == b'\t') {
            return Cow::Borrowed(text);
        }
        let mut written = String::with_capacity(text.len());
        for c in text.chars() {
            match c {
                c if is_control(c) => written.push(' '),
                c if self.options.can_write(c) => written.push(c),
                c => written.push_str(transliterate(c).unwrap_or("?")),
            }
        }
        written.into()
    }
}

/// The characters that a reader trims from the ends of keys and values.
const BLANKS: [char; 2] = [' ', '\t'];

/// Whether a reader may end the line or the text at this character.
fn is_control(c: char) -> bool {
    (c < ' ' && c != '\t') || matches!(c, '\u{7F}' | '\u{85}' | '\u{2028}' | '\u{2029}')
}

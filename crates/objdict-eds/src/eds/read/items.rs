//! The keys of one section, and their values as numbers and keywords.

use std::cell::OnceCell;
use std::collections::HashSet;
use std::hash::{BuildHasher, RandomState};

use crate::diagnostic::Findings;
use crate::eds::item::Item;
use crate::eds::keys::{FieldKey, KeySet};
use crate::eds::section::SectionName;
use crate::eds::{findings, misspelt};
use crate::ini;
use crate::literal::{self, Quirks};
use crate::model::{Extra, Field, InvalidValues, Part, Reason};
use crate::source::Span;

/// A section during reading: its text, and its findings.
pub(crate) struct Items<'a> {
    text: &'a str,
    section: &'a ini::Section,
    pub findings: &'a mut Findings,
    /// The part of the section and its standard keys; determined at the first unknown key.
    known: OnceCell<(Part, KeySet)>,
}

impl<'a> Items<'a> {
    pub(crate) fn new(text: &'a str, section: &'a ini::Section, findings: &'a mut Findings) -> Self {
        Self { text, section, findings, known: OnceCell::new() }
    }

    /// The comment lines of the section.
    pub(crate) fn comments(&self) -> impl Iterator<Item = &'a str> {
        self.section.comments.iter().map(|comment| comment.of(self.text))
    }

    /// The name of the section as written; empty before the first header.
    pub(crate) fn section_name(&self) -> &'a str {
        self.section.header.map_or("", |header| header.name.of(self.text))
    }

    /// The span of the section name.
    pub(crate) fn section_at(&self) -> Span {
        self.section.header.map_or(Span::empty(0), |header| header.name)
    }

    /// Number of keys.
    pub(crate) fn len(&self) -> usize {
        self.section.entries.len()
    }

    /// The key at a position.
    pub(crate) fn item(&self, position: usize) -> Item<'a> {
        self.item_of(&self.section.entries[position])
    }

    #[inline]
    fn item_of(&self, entry: &ini::IniEntry) -> Item<'a> {
        let name = entry.key.of(self.text);
        // no field starts with a digit, but most keys of long lists do
        let is_number = name.as_bytes().first().is_some_and(u8::is_ascii_digit);
        Item {
            key: if is_number { None } else { FieldKey::find(name) },
            name,
            value: entry.value.of(self.text),
            name_at: entry.key,
            value_at: entry.value,
        }
    }

    /// Calls `take` for each key. A key that is defined twice is reported, and only the first one is used,
    /// as in other readers.
    pub(crate) fn each(&mut self, take: impl FnMut(&mut Self, &Item<'a>)) {
        self.each_with(None, take);
    }

    /// Calls `take` for each key, like [`each`](Self::each), and for the key at `renumbered`, which is read
    /// with its corrected number.
    pub(crate) fn each_with(&mut self, renumbered: Option<Span>, mut take: impl FnMut(&mut Self, &Item<'a>)) {
        let mut seen = KeySet::default();
        let mut others = Others::default();
        let mut is_other_section = false;
        for (position, entry) in self.section.entries.iter().enumerate() {
            let mut item = self.item_of(entry);
            if renumbered == Some(item.name_at) {
                take(self, &item);
                continue;
            }
            if let Some(meant) = self.meant(&item).filter(|&meant| !seen.contains(meant)) {
                item.key = Some(meant);
                self.findings.push_with(&findings::MISSPELT_KEY, || findings::misspelt_key(&item, meant));
            }
            let is_new = match item.key {
                Some(key) => seen.insert(key),
                None => others.is_new(item.name, || (0..position).map(|at| self.item(at).name)),
            };
            if is_new {
                take(self, &item);
            } else if !is_other_section {
                is_other_section = self.begins_section(position, &item, &seen);
                self.duplicate(position, &item, is_other_section);
            }
        }
    }

    /// The intended key for a misspelt one, unless the section also has that key.
    fn meant(&self, item: &Item<'a>) -> Option<FieldKey> {
        let is_word = item.key.is_none() && !item.name.as_bytes().first().is_some_and(u8::is_ascii_digit);
        // avoids a search for each key in a file of unknown keys
        let is_word = is_word && !self.findings.is_full(&findings::UNKNOWN_KEY);
        let (part, keys) = is_word.then(|| {
            self.known.get_or_init(|| {
                let mut keys = KeySet::default();
                let names = self.section.entries.iter().map(|entry| entry.key.of(self.text));
                names.filter_map(FieldKey::find).for_each(|key| _ = keys.insert(key));
                (SectionName::parse(self.section_name()).part, keys)
            })
        })?;
        misspelt::key(part, item.name).filter(|&meant| !keys.contains(meant))
    }

    /// Whether the keys of a different object or sub-index begin at a repeated key, because their header is
    /// missing.
    fn begins_section(&self, position: usize, item: &Item<'a>, seen: &KeySet) -> bool {
        let mut next = self.section.entries.iter().skip(position + 1).take(3);
        let repeats =
            next.any(|entry| FieldKey::find(entry.key.of(self.text)).is_some_and(|key| seen.contains(key)));
        let before = &self.text[..item.name_at.start as usize];
        let line = before.trim_end_matches([' ', '\t']);
        let is_below_empty_line = ["\n\n", "\r\n\r\n", "\r\r"].iter().any(|end| line.ends_with(end));
        (is_below_empty_line || item.field() == Some(&Field::ParameterName))
            && repeats
            && matches!(SectionName::parse(self.section_name()).part, Part::Object(_) | Part::Entry(..))
    }

    fn duplicate(&mut self, position: usize, item: &Item<'a>, is_other_section: bool) {
        // searching for the first one would need quadratic time in a file of duplicates
        if self.findings.is_full(&findings::DUPLICATE_KEY) {
            return;
        }
        let first =
            (0..position).map(|at| self.item(at)).find(|first| first.name.eq_ignore_ascii_case(item.name));
        if let Some(first) = first {
            self.findings.push(match is_other_section {
                true => findings::missing_header(self.section_name(), item, &first),
                false => findings::duplicate_key(item, &first),
            });
        }
    }

    /// A whole number within `low..=high`; any other text becomes an invalid value.
    #[inline]
    pub(crate) fn integer<T: TryFrom<u32> + TryFrom<i128>>(
        &mut self,
        item: &Item<'a>,
        (low, high): (i64, u64),
        invalid_values: &mut InvalidValues,
    ) -> Option<T> {
        match literal::small_number(item.value.as_bytes()) {
            Some(number) if low <= i64::from(number) && u64::from(number) <= high => T::try_from(number).ok(),
            _ => self.any_integer(item, (low, high), invalid_values),
        }
    }

    fn any_integer<T: TryFrom<i128>>(
        &mut self,
        item: &Item<'a>,
        range: (i64, u64),
        invalid_values: &mut InvalidValues,
    ) -> Option<T> {
        if item.value.is_empty() {
            return None;
        }
        let mut quirks = Quirks::default();
        let number = literal::integer_in_line(item.value, range.0, range.1, &mut quirks);
        match number {
            Ok(number) => {
                if !quirks.is_empty() {
                    findings::quirks(item, quirks, None, self.findings);
                }
                T::try_from(number).ok()
            }
            Err(reason) => {
                invalid_values.push(item.to_field(), item.value, reason);
                None
            }
        }
    }

    /// A name or similar string. Quotes around it are kept, because they may be part of it.
    pub(crate) fn text(&mut self, item: &Item<'a>) -> &'a str {
        let text = item.value;
        if text.len() > 1 && text.starts_with('"') && text.ends_with('"') {
            self.findings.push(findings::quoted_name(item));
        }
        text
    }

    /// 0 or 1.
    pub(crate) fn boolean(&mut self, item: &Item<'a>, invalid_values: &mut InvalidValues) -> Option<bool> {
        self.integer::<u8>(item, (0, 1), invalid_values).map(|number| number == 1)
    }

    /// A word of a list; a word that `find` does not know becomes an invalid value.
    pub(crate) fn word<T>(
        &mut self,
        item: &Item<'a>,
        find: impl Fn(&str) -> Option<T>,
        invalid_values: &mut InvalidValues,
    ) -> Option<T> {
        if item.value.is_empty() {
            return None;
        }
        if let Some(word) = find(item.value) {
            return Some(word);
        }
        let mut quirks = Quirks::default();
        let word = find(literal::strip_comment(item.value, &mut quirks));
        match word {
            Some(_) => findings::quirks(item, quirks, None, self.findings),
            None => invalid_values.push(item.to_field(), item.value, Reason::UnknownWord),
        }
        word
    }

    /// Reports an unknown key and keeps it.
    pub(crate) fn unknown(&mut self, item: &Item<'a>, extra: &mut Extra) {
        self.report_unknown(item);
        extra.push(item.name, item.value);
    }

    /// Reports a key that the standard does not define.
    pub(crate) fn report_unknown(&mut self, item: &Item<'a>) {
        let section = self.section_name();
        self.findings.push_with(&findings::UNKNOWN_KEY, || findings::unknown_key(item, section));
    }
}

impl Item<'_> {
    /// The field of the key, fixed or not.
    pub(crate) fn to_field(self) -> Field {
        FieldKey::field_of(self.key, self.name)
    }
}

/// The keys so far that have no fixed name. Numbered keys in ascending order, by far the most common, need
/// no memory.
enum Others {
    /// Only numbers up to this one, in ascending order.
    Ascending(u32),
    /// The hashes of all names in lower case.
    Any(HashSet<u64>, RandomState),
}

impl Default for Others {
    fn default() -> Self {
        Self::Ascending(0)
    }
}

impl Others {
    /// Records a name; `before` returns all names before it and is called at most once.
    fn is_new<'a, I: Iterator<Item = &'a str>>(&mut self, name: &str, before: impl FnOnce() -> I) -> bool {
        if let (Self::Ascending(last), Some(number)) = (&mut *self, Field::item_number(name))
            && number > *last
        {
            *last = number;
            return true;
        }
        if let Self::Ascending(_) = self {
            let state = RandomState::new();
            let hashes = before().map(|name| state.hash_one(name.to_ascii_lowercase())).collect();
            *self = Self::Any(hashes, state);
        }
        match self {
            Self::Ascending(_) => true,
            Self::Any(hashes, state) => hashes.insert(state.hash_one(name.to_ascii_lowercase())),
        }
    }
}

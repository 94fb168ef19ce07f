//! One section of a rearranged text.

use std::borrow::Cow;

use super::spell;
use super::text::{ArrangedText, Extent};
use crate::eds::keys::FieldKey;
use crate::eds::order::{COUNTERS, Rank, key_rank};
use crate::model::{Device, ModulePart, Part};

/// A section and the lines that move with it.
pub(super) struct SectionBlock<'a> {
    pub(super) rank: Rank,
    pub(super) part: Part,
    pub(super) name: String,
    /// The paragraphs above the header.
    pub(super) above: Vec<Vec<&'a str>>,
    /// Whether the last of them is directly above the header.
    pub(super) is_above: bool,
    /// The text after the header on its line.
    pub(super) remark: Option<&'a str>,
    pub(super) entries: Vec<KeyBlock<'a>>,
    /// The lines after the last key.
    pub(super) behind: Vec<&'a str>,
}

/// A key with the lines above it.
pub(super) struct KeyBlock<'a> {
    pub(super) notes: Vec<&'a str>,
    pub(super) key: &'a str,
    pub(super) value: &'a str,
}

impl SectionBlock<'_> {
    pub(super) fn write(&self, device: &Device, extent: Extent, text: &mut ArrangedText) {
        for (number, paragraph) in self.above.iter().enumerate() {
            text.lines(paragraph);
            if number + 1 < self.above.len() || !self.is_above {
                text.line("");
            }
        }
        if let Some(remark) = self.remark {
            text.line(&format!("; {remark}"));
        }
        text.line(&format!("[{}]", self.name));
        let mut entries: Vec<&KeyBlock<'_>> = self.entries.iter().collect();
        if extent.keys {
            entries.sort_by_key(|entry| self.rank_of(entry.key));
        }
        for entry in entries {
            text.lines(&entry.notes);
            let value = match extent.values {
                true => spell::value(device, &self.part, entry.key, entry.value),
                false => Cow::Borrowed(entry.value),
            };
            let key = if extent.names { self.key(entry.key) } else { Cow::Borrowed(entry.key) };
            text.line(&format!("{key}={value}"));
        }
        text.lines(&self.behind);
    }

    /// The rank of a key. In a list only the count has one, because the items are read in the order of the
    /// text; unknown keys come last.
    fn rank_of(&self, key: &str) -> u32 {
        let has_order = matches!(
            self.part,
            Part::FileInfo
                | Part::DeviceInfo
                | Part::Commissioning
                | Part::Object(_)
                | Part::Entry(..)
                | Part::Module(
                    _,
                    ModulePart::Info
                        | ModulePart::Fixed(_)
                        | ModulePart::FixedEntry(..)
                        | ModulePart::SubExt(_)
                )
        );
        match FieldKey::find(key).map(FieldKey::field) {
            Some(_) if has_order => key_rank(key).unwrap_or(u32::MAX),
            Some(field) if COUNTERS.contains(field) && !matches!(self.part, Part::Section(_)) => 0,
            _ => u32::MAX,
        }
    }

    /// A key in the spelling of the standard.
    fn key<'k>(&self, key: &'k str) -> Cow<'k, str> {
        match FieldKey::find(key) {
            Some(found) if !matches!(self.part, Part::Section(_)) => found.field().name(),
            _ => Cow::Borrowed(key),
        }
    }
}

//! One section of a rearranged text.

use std::borrow::Cow;

use super::spell;
use super::text::{ArrangedText, Extent};
use crate::eds::keys::FieldKey;
use crate::eds::order::{COUNTERS, key_rank};
use crate::ini::{LineKind, Lines};
use crate::model::{Device, ModulePart, Part};

/// A section and the lines that move with it.
pub(super) struct SectionBlock<'a> {
    pub(super) part: Part,
    pub(super) name: String,
    /// The paragraphs above the header.
    pub(super) above: Vec<Vec<&'a str>>,
    /// Whether the last of them is directly above the header.
    pub(super) is_above: bool,
    /// The text after the header on its line.
    pub(super) remark: Option<&'a str>,
    /// The rank of each key, and where the lines above it start.
    pub(super) entries: Vec<(u32, u32)>,
    /// The lines after the last key.
    pub(super) behind: Vec<&'a str>,
}

impl SectionBlock<'_> {
    pub(super) fn write(&mut self, source: &str, device: &Device, extent: Extent, text: &mut ArrangedText) {
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
        if extent.keys {
            self.entries.sort_unstable();
        }
        for &(_, start) in &self.entries {
            for line in Lines::from(source, start) {
                if let LineKind::Entry { key, value } = line.kind {
                    let (key, value) = (key.of(source), value.of(source));
                    let value = match extent.values {
                        true => spell::value(device, &self.part, key, value),
                        false => Cow::Borrowed(value),
                    };
                    let key = if extent.names { self.key(key) } else { Cow::Borrowed(key) };
                    text.line(&format!("{key}={value}"));
                    break;
                }
                let above = line.span.of(source).trim_end();
                if !above.is_empty() {
                    text.line(above);
                }
            }
        }
        text.lines(&self.behind);
    }

    /// The rank of a key. In a list only the count has one, because the items are read in the order of the
    /// text; unknown keys come last.
    pub(super) fn rank_of(&self, key: &str) -> u32 {
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

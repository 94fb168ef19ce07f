//! One section of a rearranged text.

use std::borrow::Cow;

use super::spell;
use super::text::{ArrangedKey, ArrangedText, Extent};
use crate::eds::keys::FieldKey;
use crate::eds::order::{COUNTERS, field_rank};
use crate::ini::Lines;
use crate::model::{Device, ModulePart, Part};
use crate::source::Span;

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
    pub(super) keys: Vec<ArrangedKey<'a>>,
    /// The lines after the last key.
    pub(super) behind: Vec<&'a str>,
}

impl<'a> SectionBlock<'a> {
    pub(super) fn write(&mut self, source: &str, device: &Device, extent: Extent, text: &mut ArrangedText) {
        for (number, paragraph) in self.above.iter().enumerate() {
            text.lines(paragraph);
            if number + 1 < self.above.len() || !self.is_above {
                text.line("");
            }
        }
        if let Some(remark) = self.remark {
            text.parts(["; ", remark, ""]);
        }
        text.parts(["[", &self.name, "]"]);
        if extent.keys {
            self.keys.sort_unstable_by_key(|key| (key.rank, key.above));
        }
        for key in &self.keys {
            if key.above < key.line {
                let above = Span::new(key.above, key.line).of(source);
                let lines = Lines::new(above).map(|line| line.span.of(above).trim_end());
                lines.filter(|line| !line.is_empty()).for_each(|line| text.line(line));
            }
            let value = match extent.values {
                true => spell::value(device, &self.part, key),
                false => Cow::Borrowed(key.value),
            };
            let name = if extent.names { self.spelling(key) } else { Cow::Borrowed(key.name) };
            text.parts([&name, "=", &value]);
        }
        text.lines(&self.behind);
    }

    /// The rank of a key. In a list, only the count has one, because the items keep their order; unknown
    /// keys come last.
    pub(super) fn rank_of(&self, key: Option<FieldKey>) -> u32 {
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
        match key {
            Some(key) if has_order => field_rank(key),
            Some(key) if COUNTERS.contains(key.field()) && !matches!(self.part, Part::Section(_)) => 0,
            _ => u32::MAX,
        }
    }

    /// The name of a key in the spelling of the standard.
    fn spelling(&self, key: &ArrangedKey<'a>) -> Cow<'a, str> {
        match key.field {
            Some(field) if !matches!(self.part, Part::Section(_)) => field.name(),
            _ => Cow::Borrowed(key.name),
        }
    }
}

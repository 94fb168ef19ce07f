//! Dynamic channels and tools.

use super::EdsReader;
use super::items::Items;
use super::lists::check_count;
use super::modules::index_range;
use crate::diagnostic::Severity;
use crate::ini;
use crate::model::{DataType, DynamicChannels, Extra, Field, InvalidValues, Segment, ToolCommand};

/// The maximum number of segments; a device has a handful. A key with a larger number is an unknown key.
const MAX_SEGMENTS: usize = 1024;

impl EdsReader<'_> {
    pub(super) fn dynamic_channels(&mut self, section: &ini::Section) {
        let mut channels = DynamicChannels::default();
        let mut count = None;
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| {
            if item.field() == Some(&Field::NrOfSeg) {
                count = Some(*item);
                return;
            }
            let Some((word, number)) = segment_key(item.name) else {
                return items.unknown(item, &mut channels.extra);
            };
            if channels.segments.len() < number {
                channels.segments.resize_with(number, Segment::default);
            }
            let segment = &mut channels.segments[number - 1];
            match word {
                SegmentKey::Type => {
                    segment.data_type =
                        items.integer(item, (0, 0xFFFF), &mut channels.invalid_values).map(DataType);
                }
                SegmentKey::Direction => segment.direction = Some(item.value.into()),
                SegmentKey::Range if item.value.is_empty() => {}
                SegmentKey::Range => match index_range(item.value) {
                    Ok(range) => segment.range = Some(range),
                    Err(reason) => channels.invalid_values.push(item.to_field(), item.value, reason),
                },
                SegmentKey::Offset => segment.offset = Some(item.value.into()),
            }
        });
        let first = items.findings.len();
        check_count(&mut items, count, "NrOfSeg", channels.segments.len());
        let info = self.device.device_info.as_ref();
        let is_used = info.and_then(|info| info.dynamic_channels_supported).is_some_and(|count| count > 0);
        let is_stated = count.is_some_and(|item| !item.value.is_empty());
        if channels.segments.is_empty() && !is_used && !is_stated {
            items.findings.limit_from(first, Severity::Note);
        }
        self.device.dynamic_channels = Some(channels);
    }

    pub(super) fn tools(&mut self, section: &ini::Section) {
        let mut extra = Extra::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        let mut invalid_values = InvalidValues::default();
        items.each(|items, item| match item.field() {
            Some(Field::Items) => {
                let _: Option<u32> = items.integer(item, (0, u64::from(u32::MAX)), &mut invalid_values);
            }
            _ => items.unknown(item, &mut extra),
        });
        for invalid in invalid_values.iter() {
            extra.push(&invalid.field.name(), &invalid.text);
        }
        self.keep("Tools", &extra);
    }

    /// Tools are numbered from 1 in order; the next tool fills a gap.
    pub(super) fn tool(&mut self, _number: u16, section: &ini::Section) {
        let mut tool = ToolCommand::default();
        let mut extra = Extra::default();
        let (name, _) = self.header_of(section);
        let mut items = Items::new(self.text, section, &mut self.findings);
        items.each(|items, item| match item.field() {
            Some(Field::Name) => item.value.clone_into(&mut tool.name),
            Some(Field::Command) => item.value.clone_into(&mut tool.command),
            _ => items.unknown(item, &mut extra),
        });
        self.device.tools.push(tool);
        self.keep(name, &extra);
    }
}

enum SegmentKey {
    Type,
    Direction,
    Range,
    Offset,
}

/// The keyword and the 1-based number of a key such as `Range2`.
fn segment_key(name: &str) -> Option<(SegmentKey, usize)> {
    let digits = name.len() - name.bytes().rev().take_while(u8::is_ascii_digit).count();
    let number: usize = name.get(digits..)?.parse().ok()?;
    let word = name[..digits].to_ascii_lowercase();
    let key = match word.as_str() {
        "type" => SegmentKey::Type,
        "dir" => SegmentKey::Direction,
        "range" => SegmentKey::Range,
        "ppoffset" => SegmentKey::Offset,
        _ => return None,
    };
    (1..=MAX_SEGMENTS).contains(&number).then_some((key, number))
}

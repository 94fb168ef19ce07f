//! Names, values and denotations of compactly stored objects.

use super::EdsReader;
use super::items::Items;
use super::lists::check_count;
use crate::eds::findings;
use crate::eds::item::Item;
use crate::ini;
use crate::literal::{self, Quirks};
use crate::model::{Compact, DataType, Extra, Field, InvalidValues, Part, Value};

impl EdsReader<'_> {
    pub(super) fn compact_section(&mut self, part: Part, section: &ini::Section) {
        self.compact.push((part, section.clone()));
    }

    /// Reads the pending sections into their objects.
    pub(super) fn apply_compact(&mut self) {
        for (part, section) in std::mem::take(&mut self.compact) {
            self.apply(&part, &section);
        }
    }

    fn apply(&mut self, part: &Part, section: &ini::Section) {
        let (Part::CompactNames(index) | Part::CompactValues(index) | Part::CompactDenotations(index)) =
            *part
        else {
            return;
        };
        let (name, at) = self.header_of(section);
        let mut items = Items::new(self.text, section, &mut self.findings);
        let object = self.objects.get_mut(index);
        let object_type = object.as_ref().map(|object| object.object_type());
        let data_type = object.as_ref().and_then(|object| object.main.data_type);
        // another finding already reports the count
        let is_invalid = object
            .as_ref()
            .is_some_and(|object| object.main.invalid_values.get(&Field::CompactSubObj).is_some());
        let Some(compact) = object.and_then(|object| object.compact.as_mut()) else {
            let mut extra = Extra::default();
            items.each(|_, item| extra.push(item.name, item.value));
            if !is_invalid {
                self.findings.push(findings::stray_compact_section(name, at, object_type));
            }
            return self.keep(name, &extra);
        };
        read_compact(&mut items, part, data_type, compact);
    }
}

fn read_compact(items: &mut Items<'_>, part: &Part, data_type: Option<DataType>, compact: &mut Compact) {
    let mut count = None;
    let mut entries = 0;
    let mut extra = Extra::default();
    items.each(|items, item| {
        if item.field() == Some(&Field::NrOfEntries) {
            count = Some(*item);
            return;
        }
        let Some(number) = item.number() else {
            entries += usize::from(item.hex_number().is_some());
            return items.unknown(item, &mut extra);
        };
        entries += 1;
        let sub = u8::try_from(number).ok().filter(|sub| (1..=compact.count).contains(sub));
        let Some(sub) = sub else {
            items.findings.push(findings::stray_compact_entry(item, compact.count));
            return extra.push(item.name, item.value);
        };
        match part {
            Part::CompactNames(_) => compact.names.push((sub, items.text(item).into())),
            Part::CompactDenotations(_) => compact.denotations.push((sub, items.text(item).into())),
            _ => {
                if let Some(value) = compact_value(items, item, data_type, &mut compact.invalid_values) {
                    compact.values.push((sub, value));
                }
            }
        }
    });
    check_count(items, count, "NrOfEntries", entries);
    for (key, value) in extra.iter() {
        compact.extra.push(key, value);
    }
}

fn compact_value(
    items: &mut Items<'_>,
    item: &Item<'_>,
    data_type: Option<DataType>,
    invalid_values: &mut InvalidValues,
) -> Option<Value> {
    if item.value.is_empty() {
        return None;
    }
    let mut quirks = Quirks::default();
    let value = literal::value_in_line(item.value, data_type, &mut quirks);
    if let Ok(value) = &value {
        findings::quirks(item, quirks, Some(value), items.findings);
    }
    value.map_err(|reason| invalid_values.push(item.to_field(), item.value, reason)).ok()
}

//! Numbered lists: of objects, of links, of modules.

use std::collections::HashSet;

use super::EdsReader;
use super::items::Items;
use crate::diagnostic::{Fix, MAX_FIX_LINES};
use crate::eds::findings;
use crate::eds::item::Item;
use crate::eds::section::section_name;
use crate::ini;
use crate::literal::{self, Quirks};
use crate::model::{Extra, Field, ObjectList, Part};

impl EdsReader<'_> {
    pub(super) fn object_list(&mut self, list: ObjectList, section: &ini::Section) {
        let mut extra = Extra::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        let indexes = index_list(&mut items, &Field::SupportedObjects, &mut extra);
        match self.device.lists.get_mut(list) {
            empty @ None => *empty = Some(indexes),
            // a repeated list is one finding, without findings for its items
            Some(before) => {
                let known: HashSet<u16> = before.iter().copied().collect();
                before.extend(indexes.into_iter().filter(|index| !known.contains(index)));
            }
        }
        self.keep(list.name(), &extra);
    }

    pub(super) fn links(&mut self, index: u16, section: &ini::Section) {
        let mut extra = Extra::default();
        let mut items = Items::new(self.text, section, &mut self.findings);
        let links = index_list(&mut items, &Field::ObjectLinks, &mut extra);
        self.objects.get_or_insert(index).links = links;
        self.keep(&section_name(&Part::Links(index)).unwrap_or_default(), &extra);
    }
}

/// The indexes of a list in file order; checks the count and the numbering. Items that are not an index are
/// added to `extra`.
pub(super) fn index_list(items: &mut Items<'_>, counter: &Field, extra: &mut Extra) -> Vec<u16> {
    numbered(items, counter, extra, |items, item, extra| {
        let mut quirks = Quirks::default();
        let index = literal::integer_in_line(item.value, 1, u64::from(u16::MAX), &mut quirks);
        if !quirks.is_empty() {
            findings::quirks(item, quirks, None, items.findings);
        }
        match index {
            Ok(index) => u16::try_from(index).ok(),
            Err(reason) => {
                items.findings.push(findings::invalid_list_entry(item, &reason));
                extra.push(item.name, item.value);
                None
            }
        }
    })
}

/// The items of a list in file order; checks the count and the numbering.
pub(super) fn numbered<'a, T>(
    items: &mut Items<'a>,
    counter: &Field,
    extra: &mut Extra,
    mut read: impl FnMut(&mut Items<'a>, &Item<'a>, &mut Extra) -> Option<T>,
) -> Vec<T> {
    let mut count = None;
    let mut expected = 1;
    // later incorrect entries have the same cause as the first one
    let mut wrong: Option<(Item<'_>, u32, Fix)> = None;
    let can_be_fixed = items.len() <= MAX_FIX_LINES;
    let mut entries = 0;
    let mut list = Vec::new();
    let repeated = repeated_number(items, counter);
    if let Some(Renumbered { item, other, number }) = &repeated {
        items.findings.push(findings::repeated_number(item, other, *number));
    }
    let renumbered = repeated.map(|repeated| repeated.item.name_at);
    items.each_with(renumbered, |items, item| {
        if item.field() == Some(counter) {
            count = Some(*item);
            return;
        }
        if !item.name.bytes().next().is_some_and(|byte| byte.is_ascii_digit()) {
            return items.unknown(item, extra);
        }
        if item.number() != Some(expected) && renumbered != Some(item.name_at) {
            let first = || (*item, expected, Fix::safe("number the entries 1, 2, 3 …"));
            let (first, number, fix) = wrong.take().unwrap_or_else(first);
            let fix = if can_be_fixed { fix.replace(item.name_at, expected.to_string()) } else { fix };
            wrong = Some((first, number, fix));
        }
        expected += 1;
        entries += 1;
        list.extend(read(items, item, extra));
    });
    if let Some((item, expected, fix)) = wrong {
        items.findings.push(findings::list_numbering(&item, &expected.to_string(), fix));
    }
    check_count(items, count, &counter.name(), entries);
    list
}

/// An item of a list with the number of a different item.
struct Renumbered<'a> {
    item: Item<'a>,
    other: Item<'a>,
    /// The correct number, which no item has.
    number: u32,
}

/// The only item out of order in a list with a correct count, if its number is used twice: then only one number is
/// unused.
fn repeated_number<'a>(items: &Items<'a>, counter: &Field) -> Option<Renumbered<'a>> {
    let all = || (0..items.len()).map(|position| items.item(position));
    let mut stated = None;
    let mut misplaced = None;
    let mut last = 0;
    for item in all() {
        if item.field() == Some(counter) {
            stated = literal::small_number(item.value.as_bytes());
        } else if item.name.bytes().next().is_some_and(|byte| byte.is_ascii_digit()) {
            last += 1;
            if item.number() != Some(last) && misplaced.replace((item, last)).is_some() {
                return None;
            }
        }
    }
    let (item, number) = misplaced.filter(|_| stated == Some(last))?;
    let other = all().find(|other| other.name == item.name && other.name_at != item.name_at)?;
    (other.value != item.value).then_some(Renumbered { item, other, number })
}

/// Reports a missing or wrong count.
pub(super) fn check_count(items: &mut Items<'_>, count: Option<Item<'_>>, key: &str, actual: usize) {
    let mut quirks = Quirks::default();
    let stated = match &count {
        Some(item) => literal::integer_in_line(item.value, 0, u64::from(u32::MAX), &mut quirks).ok(),
        None => None,
    };
    if let Some(item) = &count {
        findings::quirks(item, quirks, None, items.findings);
    }
    if stated.and_then(|stated| usize::try_from(stated).ok()) != Some(actual) {
        items.findings.push(findings::wrong_count(
            count.as_ref(),
            key,
            (items.section_name(), items.section_at()),
            actual,
        ));
    }
}

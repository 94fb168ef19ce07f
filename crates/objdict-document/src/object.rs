//! Objects and areas of the dictionary.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::ops::RangeInclusive;

use super::anchor::{Anchor, in_one_spelling};
use super::context::{CodeName, Context};
use super::details::{self, Details};
use super::entry::EntryView;
use super::texts::LanguageTexts;
use crate::describe::is_of_cia;
use crate::model::{Device, Object, ObjectType};
use crate::profile;

/// An area of the dictionary (CiA 301 §7.4.1).
pub(crate) struct Area<'a> {
    /// Prefix of anchors in the page.
    pub(crate) id: &'static str,
    pub(crate) title: String,
    /// Its indexes: `0x1000–0x1FFF`.
    pub(crate) range: String,
    /// At least one.
    pub(crate) objects: Vec<ObjectView<'a>>,
}

/// View of an object.
pub(crate) struct ObjectView<'a> {
    pub(crate) index: u16,
    /// The name in the language of the page if available, otherwise the name in the file.
    pub(crate) name: Cow<'a, str>,
    /// The name in the file, if it differs from the displayed one.
    pub(crate) own_name: Option<Cow<'a, str>>,
    /// `ARRAY`; empty if only sub-indexes are described.
    pub(crate) object_type: String,
    /// Whether it has one value and no sub-indexes.
    pub(crate) is_single: bool,
    /// Whether its entries are alike; readers rarely need them one by one.
    pub(crate) is_array: bool,
    /// The entries; a single one for an object without sub-indexes.
    pub(crate) entries: Vec<EntryView<'a>>,
    /// The details of the object; empty if it has a single value, whose entry contains them.
    pub(crate) details: Details<'a>,
    /// The objects it refers to.
    pub(crate) links: Vec<Anchor>,
    /// Its purpose according to CiA documents; empty if a previous object has the same text.
    pub(crate) about: Option<String>,
    pub(crate) code: Option<&'a CodeName>,
}

impl<'a> ObjectView<'a> {
    fn new(context: &Context<'a>, index: u16, object: &'a Object) -> Self {
        let object_type = object.object_type();
        let is_single = !object_type.has_subs() && object.subs.is_empty() && object.compact.is_none();
        let (name, own_name) = match object.orphan {
            true => (Cow::Borrowed(context.texts.not_described), None),
            false => context.names(Cow::Borrowed(&object.main)),
        };
        let documents: Vec<_> = profile::of_object(context.device, index).map(|(_, facts)| facts).collect();
        let about = documents.iter().find_map(|facts| facts.about);
        let details = match is_single {
            true => Details::default(),
            false => details::of_object(context, &object.main),
        };
        Self {
            index,
            name,
            own_name,
            object_type: if object.orphan { String::new() } else { object_type.to_string() },
            is_single,
            is_array: object_type == ObjectType::Array,
            entries: object
                .entries()
                .map(|(sub, entry)| EntryView::new(context, (index, sub), entry, &documents))
                .collect(),
            details,
            links: object.links.iter().copied().map(Anchor::object).collect(),
            about: about.map(in_one_spelling),
            code: context.identifiers.get(&(index, None)),
        }
    }

    /// The only entry of an object without sub-indexes.
    pub(crate) fn single(&self) -> Option<&EntryView<'a>> {
        self.entries.first().filter(|_| self.is_single)
    }

    /// The anchor in the page.
    pub(crate) fn anchor(&self) -> Anchor {
        Anchor::object(self.index)
    }

    /// The common data type of all entries except sub-index 0; empty if they differ.
    pub(crate) fn common_type(&self) -> &str {
        let mut types = self.entries.iter().filter(|entry| entry.sub != 0).map(|entry| &*entry.data_type);
        let Some(first) = types.next() else { return "" };
        if types.all(|other| other == first) { first } else { "" }
    }
}

/// The areas in which the device has objects.
pub(super) fn areas<'a>(context: &Context<'a>) -> Vec<Area<'a>> {
    let areas = AREAS.iter().map(|(id, title, range)| {
        let objects = context.device.objects.range(range.clone());
        Area {
            id,
            title: title(context.texts, context.device, *range.start()),
            range: format!("0x{:04X}–0x{:04X}", range.start(), range.end()),
            objects: objects.map(|(&index, object)| ObjectView::new(context, index, object)).collect(),
        }
    });
    let mut areas: Vec<Area<'a>> = areas.filter(|area| !area.objects.is_empty()).collect();
    say_once(&mut areas);
    areas
}

/// Shows sentences and bit tables that several objects share only at the first one; the others link to it.
fn say_once(areas: &mut [Area<'_>]) {
    let (mut sentences, mut words) = (HashSet::new(), HashMap::new());
    for object in areas.iter_mut().flat_map(|area| &mut area.objects) {
        object.about = object.about.take().filter(|about| sentences.insert(about.clone()));
        for entry in object.entries.iter_mut().filter(|entry| !entry.details.word.is_empty()) {
            let anchor = entry.anchor();
            let first = *words.entry(entry.details.word.clone()).or_insert(anchor);
            if first != anchor {
                entry.details.word.clear();
                entry.details.word_of = Some(first).filter(|first| first.index != anchor.index);
            }
        }
    }
}

type Title = fn(&LanguageTexts, &Device, u16) -> String;

/// CiA 301 table 31, with the standardised device profiles separated.
const AREAS: [(&str, Title, RangeInclusive<u16>); 14] = [
    ("types", |texts, _, _| texts.data_types.to_owned(), 0..=0x0FFF),
    ("communication-area", |texts, _, _| texts.communication_area.to_owned(), 0x1000..=0x1FFF),
    ("manufacturer", |texts, _, _| texts.manufacturer_area.to_owned(), 0x2000..=0x5FFF),
    ("profile-1", profile_title, 0x6000..=0x67FF),
    ("profile-2", profile_title, 0x6800..=0x6FFF),
    ("profile-3", profile_title, 0x7000..=0x77FF),
    ("profile-4", profile_title, 0x7800..=0x7FFF),
    ("profile-5", profile_title, 0x8000..=0x87FF),
    ("profile-6", profile_title, 0x8800..=0x8FFF),
    ("profile-7", profile_title, 0x9000..=0x97FF),
    ("profile-8", profile_title, 0x9800..=0x9FFF),
    ("network-variables", |texts, _, _| texts.network_area.to_owned(), 0xA000..=0xAFFF),
    ("system-variables", |texts, _, _| texts.system_area.to_owned(), 0xB000..=0xBFFF),
    ("reserved", |texts, _, _| texts.reserved_area.to_owned(), 0xC000..=0xFFFF),
];

/// `Device profile CiA 402`; with a number if the device has several profiles.
fn profile_title(texts: &LanguageTexts, device: &Device, first: u16) -> String {
    let block = u8::try_from((first - 0x6000) / 0x800).unwrap_or_default();
    let has_several = device.objects.range(0x6800..=0x9FFF).next().is_some();
    let number = crate::profile::number_of(device, block).filter(|&number| is_of_cia(number.into()));
    let mut title = texts.profile_area.to_owned();
    if let Some(number) = number {
        title.push_str(&format!(" CiA {number}"));
    }
    if has_several {
        title.push_str(&format!(", {} {}", texts.logical_device, block + 1));
    }
    title
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_index_lies_in_one_area() {
        let mut next = 0u32;
        for (id, _, range) in AREAS {
            assert_eq!(u32::from(*range.start()), next, "{id}");
            next = u32::from(*range.end()) + 1;
        }
        assert_eq!(next, 0x1_0000);
    }
}

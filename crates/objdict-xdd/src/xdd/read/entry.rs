//! The attributes of objects and sub-objects.

use crate::diagnostic::Findings;
use crate::model::{Entry, StackOptions};
use crate::xdd::defaults::{self, Placeholders};
use crate::xdd::fact::{PlacedText, hex};
use crate::xdd::schema::network::OBJECT;
use crate::xdd::schema::{AttributePlace, Slots};
use crate::xdd::shape::{facts, stack_attribute};
use crate::xml::{Attribute, Element, Name, n};

/// The number of attributes of an object.
const COUNT: usize = OBJECT.element.attributes.len();

/// The unparsed attributes of a `CANopenObject` or `CANopenSubObject`.
pub(crate) struct EntryAttributes<'a> {
    /// In schema order; the first is `index` or `subIndex`.
    known: [Option<Attribute<'a>>; COUNT],
    /// The attributes that the standard does not define.
    unknown: Vec<Attribute<'a>>,
}

impl<'a> EntryAttributes<'a> {
    /// Sorts the attributes of an element.
    pub(crate) fn of(element: Element<'a>) -> Self {
        let mut found = Self { known: [None; COUNT], unknown: Vec::new() };
        for attribute in element.attributes() {
            let name = match attribute.tag() {
                n::subIndex => n::index,
                // the model has no field for it
                n::rangeSelector => Name::OTHER,
                Name::OTHER => match attribute.name() {
                    // projects of CANopenNode
                    "lowValue" => n::lowLimit,
                    "highValue" => n::highLimit,
                    _ => Name::OTHER,
                },
                name => name,
            };
            match OBJECT.attribute(name) {
                Some((number, _)) => {
                    found.known[number].get_or_insert(attribute);
                }
                None => found.unknown.push(attribute),
            }
        }
        found
    }

    /// The attribute with this name.
    pub(crate) fn get(&self, name: Name) -> Option<Attribute<'a>> {
        self.known[OBJECT.attribute(name)?.0]
    }

    /// Whether the element exists only for its sub-objects.
    pub(crate) fn is_orphan(&self) -> bool {
        self.get(n::objectType).is_some_and(|code| code.value() == defaults::ORPHAN)
    }

    /// Whether the element is the placeholder of a device without objects.
    pub(crate) fn is_placeholder(&self) -> bool {
        let is = |name: Name, text: &str| self.get(name).is_some_and(|attribute| attribute.value() == text);
        is(n::index, defaults::INDEX) && is(n::name, defaults::NOT_STATED)
    }

    /// The index of an object.
    pub(crate) fn index(&self) -> Option<u16> {
        let number = hex(self.known[0]?.value().trim_ascii(), 4)?;
        u16::try_from(number).ok()
    }

    /// The sub-index of a sub-object.
    pub(crate) fn sub_index(&self) -> Option<u8> {
        self.index().and_then(|number| u8::try_from(number).ok())
    }

    /// Reads all attributes except values.
    pub(crate) fn read(&self, findings: &mut Findings) -> Entry {
        let mut entry = Entry::default();
        if let Some(name) = self.get(n::name) {
            entry.name = name.value().trim_ascii().into();
        }
        for ((known, at), attribute) in OBJECT.attributes.iter().zip(OBJECT.values).zip(self.known) {
            if let Some(attribute) = attribute {
                let text = PlacedText::of(attribute);
                facts::take_at(&mut entry, known, at, &text, Placeholders::Dropped, findings);
            }
        }
        let denotation = self.get(n::denotation).map(PlacedText::of);
        if let Some(text) = denotation.filter(|text| !text.trimmed().is_empty()) {
            entry.configured_mut().denotation = Some(text.trimmed().into());
        }
        let mut options = StackOptions::default();
        for attribute in &self.unknown {
            let (name, value) = (attribute.name(), attribute.value());
            if !stack_attribute(&mut options, name, &value) {
                entry.extra.push(name, &value);
            }
        }
        entry.stack = Some(options).filter(|options| *options != StackOptions::default()).map(Box::new);
        entry
    }

    /// Reads the values of an entry whose data type is known.
    pub(crate) fn read_values(&self, entry: &mut Entry, findings: &mut Findings) {
        let data_type = entry.implied_type();
        for (at, attribute) in OBJECT.values.iter().zip(self.known) {
            let (&AttributePlace::Value(place), Some(attribute)) = (at, attribute) else { continue };
            let text = PlacedText::of(attribute);
            let value = match place {
                // its spelling is checked once the default is known
                Slots::High => text.value(data_type, &mut Findings::new()),
                _ => text.value(data_type, findings),
            };
            match value {
                Ok(Some(value)) => place.set(entry, value),
                Ok(None) => {}
                Err(reason) => entry.invalid_values.push(place.field(), &text.text, reason),
            }
        }
    }

    /// Reads the high limit again, now that the other values are known, which may come from the parameter.
    pub(crate) fn settle_high_limit(&self, entry: &mut Entry, findings: &mut Findings) {
        let Some(text) = self.get(n::highLimit).map(PlacedText::of) else { return };
        if let Ok(Some(value)) = text.high_limit(entry, findings) {
            entry.high_limit = Some(value);
        }
    }
}

//! The configuration of a node together with the description of its type, from which it was created.

use std::borrow::Cow;

use crate::diagnostic::{At, Diagnostic, RuleInfo, Text, say};
use crate::model::{Device, Entry, Field, Object, Place, Value};
use crate::stated;

/// A configuration and its original type description.
pub(crate) struct ConfiguredDevice<'a> {
    /// The configuration.
    pub device: &'a Device,
    /// The description of the type, with the PDOs that it implies.
    pub origin: &'a Device,
    /// The type description as written, into which labels point.
    pub written: &'a Device,
}

/// An entry that both describe.
pub(crate) struct EntryPair<'a> {
    pub index: u16,
    /// The sub-index; `None` for the section of an object.
    pub sub: Option<u8>,
    /// The entry of the configuration.
    pub entry: &'a Entry,
    /// The entry of the type.
    pub original: Cow<'a, Entry>,
}

impl<'a> ConfiguredDevice<'a> {
    /// The sections of the configuration that contain values, each with its object.
    pub(crate) fn sections(&self) -> impl Iterator<Item = (u16, &'a Object, Option<u8>, &'a Entry)> {
        self.device.objects.iter().flat_map(|(&index, object)| {
            let holds_value = !object.object_type().has_subs() || object.compact.is_some();
            let sections = object.described().filter(move |(sub, _)| sub.is_some() || holds_value);
            sections.map(move |(sub, entry)| (index, object, sub, entry))
        })
    }

    /// The entry of the type that a section of the configuration describes.
    pub(crate) fn original(&self, index: u16, object: &Object, sub: Option<u8>) -> Option<Cow<'a, Entry>> {
        let origin = self.origin.object(index)?;
        match (sub, &object.compact) {
            (Some(sub), _) => origin.entry(sub),
            (None, Some(_)) => origin.entry(1),
            (None, None) => origin.entry(0),
        }
    }

    /// The entries that both describe.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = EntryPair<'a>> {
        self.sections().filter_map(|(index, object, sub, entry)| {
            let original = self.original(index, object, sub)?;
            Some(EntryPair { index, sub, entry, original })
        })
    }

    /// The node-ID for which formulas are evaluated.
    pub(crate) fn node_id(&self) -> u8 {
        stated::node_ids(self.device)[0]
    }

    /// Whether two values certainly differ on the node.
    pub(crate) fn differ(&self, left: &Value, right: &Value) -> bool {
        match (left, right) {
            (Value::Text(left), Value::Text(right)) => left.trim() != right.trim(),
            _ => stated::compare(left, right, self.node_id()).is_some_and(std::cmp::Ordering::is_ne),
        }
    }

    /// A finding about a field of an entry, with a label at the same field of the type.
    pub(crate) fn finding(
        &self,
        rule: &'static RuleInfo,
        pair: &EntryPair<'_>,
        field: Field,
        message: Text,
    ) -> Diagnostic {
        let finding = Diagnostic::new(rule, pair.place().field(field.clone()), message);
        match self.written.object(pair.index) {
            // a compact object, or an implied one, has no section for the sub-index
            Some(object) => {
                let sub = pair.sub.filter(|sub| object.subs.get(*sub).is_some());
                let place = Place::at(pair.index, sub);
                finding.label(At::Node(0, place.field(field)), say!("in the {EDS}"))
            }
            None => finding,
        }
    }
}

impl EntryPair<'_> {
    /// The section as a place.
    pub(crate) fn place(&self) -> Place {
        Place::at(self.index, self.sub)
    }

    /// The address as users write it.
    pub(crate) fn name(&self) -> Text {
        match self.sub {
            Some(sub) => say!("{:04X}h:{:02X}", self.index, sub),
            None => say!("{:04X}h", self.index),
        }
    }
}

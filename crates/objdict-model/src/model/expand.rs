//! Expands compactly stored entries, and stores entries compactly.
//!
//! The model keeps compact objects compact: real files describe tens of thousands of entries this way.
//! `Object::entries` shows them expanded, `Object::described` shows the stated ones.

use std::borrow::Cow;

use super::{Compact, Device, Entry, ExtraSection, Field, InvalidValue, InvalidValues, Object, ObjectType};

impl Object {
    /// The object with a description of every entry, if it is stored compactly; otherwise unchanged.
    ///
    /// Common properties of all entries (data type, access, default, limits) are removed from the section
    /// of the object, because each entry now has them. Unknown keys of the sections with names and values
    /// are omitted; the device keeps them ([`Device::expanded`]).
    pub fn expanded(&self) -> Cow<'_, Object> {
        let Some(compact) = &self.compact else { return Cow::Borrowed(self) };
        let mut subs = self.subs.clone();
        let (shared, own) = split(&self.main.invalid_values);
        for (sub, entry) in self.entries() {
            if subs.get(sub).is_none() {
                let invalid_values = if sub == 0 { InvalidValues::default() } else { shared.clone() };
                subs.insert(sub, Entry { invalid_values, ..entry.into_owned() });
            }
        }
        for invalid in compact.invalid_values.iter() {
            let sub = match invalid.field {
                Field::Item(number) => u8::try_from(number).ok(),
                _ => None,
            };
            if let Some(entry) = sub.and_then(|sub| subs.get_mut(sub)) {
                entry.invalid_values.push(Field::ParameterValue, &invalid.text, invalid.reason.clone());
            }
        }
        let main = Entry {
            // a configured value here, although it has no entry, keeps its type
            data_type: self.main.data_type.filter(|_| self.main.configured_value().is_some()),
            access: None,
            pdo_mapping: None,
            default: None,
            low_limit: None,
            high_limit: None,
            invalid_values: own,
            ..self.main.clone()
        };
        let described = subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
        Cow::Owned(Object {
            main,
            sub_number: u8::try_from(described).ok(),
            compact: None,
            subs,
            ..self.clone()
        })
    }

    /// The object with its entries stored compactly (CiA 306-1 §4.6.3.2), if it is an ARRAY or RECORD whose entries
    /// differ only in names, values and denotations. `None` if more than the name of sub-index 0 would be lost.
    pub fn compacted(&self) -> Option<Object> {
        if self.compact.is_some() || self.orphan || !self.object_type().has_subs() {
            return None;
        }
        let count = self.highest_sub().filter(|count| (1..=254).contains(count))?;
        let first = self.subs.get(1)?;
        let main = Entry {
            data_type: first.data_type,
            access: first.access,
            pdo_mapping: first.pdo_mapping,
            default: first.default.clone(),
            low_limit: first.low_limit.clone(),
            high_limit: first.high_limit.clone(),
            flags: first.flags,
            ..self.main.clone()
        };
        let mut compact = Compact { count, ..Compact::default() };
        for (sub, entry) in self.subs.iter().filter(|(sub, _)| *sub > 0) {
            if *entry.name != *format!("{}{sub}", self.main.name) {
                compact.names.push((sub, entry.name.clone()));
            }
            let Some(configured) = &entry.configured else { continue };
            compact.values.extend(configured.value.clone().map(|value| (sub, value)));
            compact.denotations.extend(configured.denotation.clone().map(|denotation| (sub, denotation)));
        }
        let compacted = Object {
            main,
            sub_number: None,
            compact: Some(Box::new(compact)),
            subs: Default::default(),
            ..self.clone()
        };
        same_entries(self, &compacted).then_some(compacted)
    }
}

/// Whether two objects have the same entries. The name of sub-index 0 may differ, and VAR is the object type of an entry without one.
fn same_entries(left: &Object, right: &Object) -> bool {
    let entries = |object: &Object| -> Vec<(u8, Entry)> {
        let alike = |(sub, entry): (u8, Cow<'_, Entry>)| {
            let entry = entry.into_owned();
            let name = if sub == 0 { Box::default() } else { entry.name.clone() };
            (sub, Entry { name, object_type: entry.object_type.or(Some(ObjectType::Var)), ..entry })
        };
        object.entries().map(alike).collect()
    };
    entries(left) == entries(right)
}

impl Device {
    /// How many entries are stored compactly. Ten bytes of a file may state 254, so a reader of foreign files limits them.
    pub fn compact_entries(&self) -> usize {
        self.objects.values().filter_map(|object| object.compact.as_ref()).map(|c| usize::from(c.count)).sum()
    }

    /// The device with a description of every entry of its compactly stored objects. Unknown keys in the
    /// sections of such an object get their own section.
    pub fn expanded(&self) -> Cow<'_, Device> {
        if self.objects.values().all(|object| object.compact.is_none()) {
            return Cow::Borrowed(self);
        }
        let mut device = self.clone();
        for (index, object) in device.objects.iter_mut() {
            if let Some(compact) = object.compact.as_ref().filter(|compact| !compact.extra.is_empty()) {
                device.extra.push(ExtraSection::new(&format!("{index:X}Value"), &compact.extra));
            }
            if let Cow::Owned(expanded) = object.expanded() {
                *object = expanded;
            }
        }
        Cow::Owned(device)
    }
}

/// The invalid values that all compactly stored entries share, and the others.
fn split(invalid_values: &InvalidValues) -> (InvalidValues, InvalidValues) {
    let (mut shared, mut own) = (InvalidValues::default(), InvalidValues::default());
    for InvalidValue { field, text, reason } in invalid_values.iter() {
        let is_shared = matches!(field, Field::DefaultValue | Field::LowLimit | Field::HighLimit);
        let of = if is_shared { &mut shared } else { &mut own };
        of.push(field.clone(), text, reason.clone());
    }
    (shared, own)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Compact, DataType, ObjectType, Reason, Value};

    fn stored(compact: Compact) -> Object {
        let main = Entry {
            name: "Gain".into(),
            object_type: Some(ObjectType::Array),
            data_type: Some(DataType::UNSIGNED8),
            default: Some(Value::Unsigned(7)),
            ..Entry::default()
        };
        Object { main, compact: Some(Box::new(compact)), ..Object::default() }
    }

    #[test]
    fn entries_keep_what_they_had() {
        let mut invalid_values = InvalidValues::default();
        invalid_values.push(Field::Item(2), "x", Reason::NotANumber);
        let compact =
            Compact { count: 2, values: vec![(1, Value::Unsigned(9))], invalid_values, ..Compact::default() };
        let object = stored(compact);
        let expanded = object.expanded();
        assert_eq!(expanded.sub_number, Some(3));
        assert!(expanded.main.data_type.is_none() && expanded.main.default.is_none());
        assert_eq!(expanded.subs.get(1).and_then(Entry::value), Some(&Value::Unsigned(9)));
        let second = expanded.subs.get(2);
        let invalid = second.and_then(|entry| entry.invalid_values.get(&Field::ParameterValue));
        assert_eq!(invalid.map(|invalid| &*invalid.text), Some("x"));
        assert_eq!(object.entry(1), expanded.entry(1));
    }

    #[test]
    fn entries_that_are_alike_are_stored_compactly() {
        let compact = Compact {
            count: 3,
            names: vec![(2, "Middle".into())],
            values: vec![(1, Value::Unsigned(9))],
            denotations: vec![(3, "last".into())],
            ..Compact::default()
        };
        let object = stored(compact);
        let expanded = object.expanded().into_owned();
        assert_eq!(expanded.compacted(), Some(object));
        let mut changed = expanded.clone();
        changed.subs.get_mut(3).unwrap().default = Some(Value::Unsigned(8));
        assert_eq!(changed.compacted(), None, "one default differs");
        let mut changed = expanded.clone();
        changed.subs.remove(2);
        assert_eq!(changed.compacted(), None, "a sub-index is missing");
        let mut changed = expanded;
        changed.subs.get_mut(0).unwrap().name = "Highest sub-index".into();
        assert!(changed.compacted().is_some(), "the name of sub-index 0 is not kept");
    }
}

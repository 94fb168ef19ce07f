//! Objects: the content of an index.

use std::borrow::Cow;

use super::part::part;
use super::{Access, DataType, Entry, Extra, InvalidValues, ObjectType, PdoMapping, Value};

part! {
    /// An object of the dictionary.
    ///
    /// [`main`](Self::main) describes the value of a VAR or DOMAIN; an ARRAY, RECORD or DEFSTRUCT describes its
    /// entries in [`subs`](Self::subs) or, stored compactly, in [`compact`](Self::compact). [`Object::entries`]
    /// returns the entries in all cases.
    pub struct Object from "super::flat::ObjectForm" {
        /// Whether only sub-indexes are described but not the object itself, which is a defect of the
        /// description.
        pub orphan: bool,
        /// The section of the object; for an ARRAY or RECORD usually just name and object type.
        #[cfg_attr(feature = "serde", serde(flatten))]
        always() pub main: Entry,
        /// `SubNumber`: the number of described sub-indexes without FFh, as stated.
        pub sub_number: Option<u8>,
        /// Compact storage with `CompactSubObj`; `None` if the key is missing or 0.
        pub compact: Option<Box<Compact>>,
        /// The described entries.
        pub subs: Subs,
        /// `ObjectLinks`: indexes that a tool can show together with this object (CiA 306-1 §4.6.4).
        #[cfg_attr(feature = "serde", serde(with = "super::index_list"))]
        #[cfg_attr(feature = "schema", schemars(with = "Vec<super::HexText<u16>>"))]
        pub links: Vec<u16>,
    }
}

/// Described entries in ascending order of their sub-indexes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Subs(Vec<(u8, Entry)>);

impl Subs {
    /// Whether there are no described entries.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The number of described entries.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// The entry at a sub-index.
    pub fn get(&self, sub: u8) -> Option<&Entry> {
        self.position(sub).ok().map(|at| &self.0[at].1)
    }

    /// Mutable access to the entry at a sub-index.
    pub fn get_mut(&mut self, sub: u8) -> Option<&mut Entry> {
        self.position(sub).ok().map(|at| &mut self.0[at].1)
    }

    /// Inserts an entry; returns the previous one.
    pub fn insert(&mut self, sub: u8, entry: Entry) -> Option<Entry> {
        match self.position(sub) {
            Ok(at) => Some(std::mem::replace(&mut self.0[at].1, entry)),
            Err(at) => {
                self.add(at, sub, entry);
                None
            }
        }
    }

    /// Mutable access to the entry at a sub-index, which is created if missing.
    pub fn get_or_insert(&mut self, sub: u8) -> &mut Entry {
        let at = self.position(sub).unwrap_or_else(|at| {
            self.add(at, sub, Entry::default());
            at
        });
        &mut self.0[at].1
    }

    fn add(&mut self, at: usize, sub: u8, entry: Entry) {
        if self.0.is_empty() {
            // a file may consist of objects with one entry, and a list reserves four
            self.0.reserve_exact(1);
        }
        self.0.insert(at, (sub, entry));
    }

    /// Removes an entry.
    pub fn remove(&mut self, sub: u8) -> Option<Entry> {
        self.position(sub).ok().map(|at| self.0.remove(at).1)
    }

    /// Sub-indexes and entries in ascending order.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (u8, &Entry)> + Clone {
        self.0.iter().map(|(sub, entry)| (*sub, entry))
    }

    /// Sub-indexes and mutable entries in ascending order.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (u8, &mut Entry)> {
        self.0.iter_mut().map(|(sub, entry)| (*sub, entry))
    }

    fn position(&self, sub: u8) -> Result<usize, usize> {
        match self.0.last() {
            // descriptions list sub-indexes in order, so most inserts are at the end
            Some((last, _)) if *last < sub => Err(self.0.len()),
            _ => self.0.binary_search_by_key(&sub, |(sub, _)| *sub),
        }
    }
}

impl FromIterator<(u8, Entry)> for Subs {
    fn from_iter<T: IntoIterator<Item = (u8, Entry)>>(entries: T) -> Self {
        let mut subs = Self::default();
        for (sub, entry) in entries {
            subs.insert(sub, entry);
        }
        subs
    }
}

/// Compact storage of the entries of an object (CiA 306-1 §4.6.3.4.2): sub-indexes 1 to `count` differ only
/// in names and values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Compact {
    /// `CompactSubObj`: the highest sub-index, 1 to 254.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "super::spelled::compact_count::deserialize"))]
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = 254)))]
    pub count: u8,
    /// Names of single entries; other entries have the name of the object with their number appended.
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "super::sub_list", skip_serializing_if = "Vec::is_empty")
    )]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "std::collections::BTreeMap<super::HexText<u8>, Box<str>>")
    )]
    pub names: Vec<(u8, Box<str>)>,
    /// Configured values of single entries (DCF).
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "super::sub_list", skip_serializing_if = "Vec::is_empty")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "std::collections::BTreeMap<super::HexText<u8>, Value>"))]
    pub values: Vec<(u8, Value)>,
    /// Denotations of single entries (DCF).
    #[cfg_attr(
        feature = "serde",
        serde(default, with = "super::sub_list", skip_serializing_if = "Vec::is_empty")
    )]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "std::collections::BTreeMap<super::HexText<u8>, Box<str>>")
    )]
    pub denotations: Vec<(u8, Box<str>)>,
    /// Texts that are not valid in their fields.
    #[cfg_attr(
        feature = "serde",
        serde(default, rename = "misfits", skip_serializing_if = "InvalidValues::is_empty")
    )]
    pub invalid_values: InvalidValues,
    /// Keys without a field in the model.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Extra::is_empty"))]
    pub extra: Extra,
}

fn of_sub<T>(list: &[(u8, T)], sub: u8) -> Option<&T> {
    list.iter().find(|(number, _)| *number == sub).map(|(_, item)| item)
}

impl Object {
    /// Whether it is described and no part of the device: an editor for CANopenNode marks it so (`CO_disabled`).
    pub fn is_disabled(&self) -> bool {
        self.main.stack.as_ref().is_some_and(|stack| stack.disabled == Some(true))
    }

    /// The object type; VAR if missing.
    pub fn object_type(&self) -> ObjectType {
        self.main.object_type.unwrap_or(ObjectType::Var)
    }

    /// `ParameterName`; empty if missing.
    pub fn name(&self) -> &str {
        &self.main.name
    }

    /// The entry at a sub-index: described, stored compactly, or the value of a VAR (sub-index 0).
    pub fn entry(&self, sub: u8) -> Option<Cow<'_, Entry>> {
        if let Some(entry) = self.subs.get(sub) {
            return Some(Cow::Borrowed(entry));
        }
        if let Some(compact) = &self.compact {
            return self.compact_entry(compact, sub).map(Cow::Owned);
        }
        (sub == 0 && !self.orphan && !self.object_type().has_subs()).then_some(Cow::Borrowed(&self.main))
    }

    /// The value of a sub-index after configuration: [`Entry::value`] of [`Object::entry`], without creating
    /// an entry for a compactly stored one.
    pub fn value(&self, sub: u8) -> Option<Cow<'_, Value>> {
        if let Some(entry) = self.subs.get(sub) {
            return entry.value().map(Cow::Borrowed);
        }
        if let Some(compact) = &self.compact {
            return match sub {
                0 => Some(Cow::Owned(Value::Unsigned(u64::from(compact.count)))),
                _ if sub > compact.count => None,
                _ => of_sub(&compact.values, sub).or(self.main.default.as_ref()).map(Cow::Borrowed),
            };
        }
        let single = sub == 0 && !self.orphan && !self.object_type().has_subs();
        if single { self.main.value().map(Cow::Borrowed) } else { None }
    }

    /// The sub-indexes from 1 to `last` that the object has, with their [values](Self::value).
    pub(super) fn values(&self, last: u8) -> impl Iterator<Item = (u8, Option<Cow<'_, Value>>)> {
        let compact = self.compact.is_some();
        let highest = if compact { self.highest_sub().unwrap_or(0).min(last) } else { 0 };
        let implied = (1..=highest).filter(|&sub| self.has(sub)).map(|sub| (sub, self.value(sub)));
        let stated = self.subs.iter().filter(move |(sub, _)| !compact && (1..=last).contains(sub));
        implied.chain(stated.map(|(sub, entry)| (sub, entry.value().map(Cow::Borrowed))))
    }

    /// Whether the object has a sub-index, described or stored compactly.
    pub fn has(&self, sub: u8) -> bool {
        self.subs.get(sub).is_some()
            || match &self.compact {
                Some(compact) => sub <= compact.count,
                None => sub == 0 && !self.orphan && !self.object_type().has_subs(),
            }
    }

    /// All entries of the object, in ascending order of their sub-indexes.
    pub fn entries(&self) -> impl Iterator<Item = (u8, Cow<'_, Entry>)> {
        let compact = self.compact.as_ref().map(|compact| compact.count);
        let implied = compact
            .map(|count| 0..=count)
            .into_iter()
            .flatten()
            .filter(|&sub| self.subs.get(sub).is_none())
            .filter_map(|sub| self.entry(sub).map(|entry| (sub, entry)));
        merge_by_sub(implied, self.stated().map(|(sub, entry)| (sub, Cow::Borrowed(entry))))
    }

    /// The entries that are described individually: [`Object::entries`] without those that are stored
    /// compactly.
    pub fn stated(&self) -> impl Iterator<Item = (u8, &Entry)> {
        let is_single = self.compact.is_none()
            && !self.orphan
            && !self.object_type().has_subs()
            && self.subs.get(0).is_none();
        is_single.then_some((0, &self.main)).into_iter().chain(self.subs.iter())
    }

    /// The sections of the object: its own, if it has one, then each described sub-index. Rules about the
    /// text of single fields check these; compact entries have no text of their own.
    pub fn described(&self) -> impl Iterator<Item = (Option<u8>, &Entry)> {
        (!self.orphan)
            .then_some((None, &self.main))
            .into_iter()
            .chain(self.subs.iter().map(|(sub, entry)| (Some(sub), entry)))
    }

    /// The highest sub-index, without FFh.
    pub fn highest_sub(&self) -> Option<u8> {
        let described = self.subs.iter().map(|(sub, _)| sub).filter(|&sub| sub != 0xFF).max();
        let compact = self.compact.as_ref().map(|compact| compact.count);
        described.max(compact).or_else(|| (!self.object_type().has_subs()).then_some(0))
    }

    fn compact_entry(&self, compact: &Compact, sub: u8) -> Option<Entry> {
        if sub == 0 {
            return Some(compact_count(compact.count));
        }
        if sub > compact.count {
            return None;
        }
        let name = match of_sub(&compact.names, sub) {
            Some(name) => name.clone(),
            None => [&*self.main.name, &*sub.to_string()].concat().into(),
        };
        let mut entry = Entry {
            name,
            object_type: Some(ObjectType::Var),
            data_type: self.main.data_type,
            access: self.main.access,
            pdo_mapping: self.main.pdo_mapping,
            default: self.main.default.clone(),
            low_limit: self.main.low_limit.clone(),
            high_limit: self.main.high_limit.clone(),
            flags: self.main.flags,
            ..Entry::default()
        };
        if let Some(value) = of_sub(&compact.values, sub) {
            entry.configured_mut().value = Some(value.clone());
        }
        if let Some(denotation) = of_sub(&compact.denotations, sub).filter(|text| !text.is_empty()) {
            entry.configured_mut().denotation = Some(denotation.clone());
        }
        Some(entry)
    }
}

/// Sub-index 0 of a compactly stored object.
fn compact_count(count: u8) -> Entry {
    Entry {
        name: "NrOfObjects".into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(DataType::UNSIGNED8),
        access: Some(Access::Ro),
        pdo_mapping: Some(PdoMapping::No),
        default: Some(Value::Unsigned(u64::from(count))),
        ..Entry::default()
    }
}

/// Merges two ascending sequences.
fn merge_by_sub<'a>(
    left: impl Iterator<Item = (u8, Cow<'a, Entry>)>,
    right: impl Iterator<Item = (u8, Cow<'a, Entry>)>,
) -> impl Iterator<Item = (u8, Cow<'a, Entry>)> {
    let (mut left, mut right) = (left.peekable(), right.peekable());
    std::iter::from_fn(move || match (left.peek(), right.peek()) {
        (Some((a, _)), Some((b, _))) if a < b => left.next(),
        (_, Some(_)) => right.next(),
        (_, None) => left.next(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn compact() -> Object {
        let main =
            Entry { name: "Channel".into(), data_type: Some(DataType::UNSIGNED16), ..Entry::default() };
        let compact = Compact { count: 3, names: vec![(2, "Middle".into())], ..Compact::default() };
        let main = Entry { object_type: Some(ObjectType::Array), ..main };
        Object { main, compact: Some(Box::new(compact)), ..Object::default() }
    }

    #[test]
    fn compact_entries_are_named_by_number_unless_they_have_a_name() {
        let names: Vec<String> = compact().entries().map(|(_, entry)| entry.name.to_string()).collect();
        assert_eq!(names, ["NrOfObjects", "Channel1", "Middle", "Channel3"]);
    }

    #[test]
    fn a_described_entry_comes_before_the_compact_one() {
        let mut object = compact();
        object.subs.insert(3, Entry { name: "Own".into(), ..Entry::default() });
        object.subs.insert(9, Entry { name: "Above".into(), ..Entry::default() });
        let names: Vec<(u8, String)> =
            object.entries().map(|(sub, entry)| (sub, entry.name.to_string())).collect();
        assert_eq!(names[3..], [(3, "Own".to_owned()), (9, "Above".to_owned())]);
    }

    #[test]
    fn values_are_those_of_the_entries() {
        let mut object = compact();
        object.main.default = Some(Value::Unsigned(7));
        if let Some(compact) = &mut object.compact {
            compact.values = vec![(2, Value::Unsigned(9))];
        }
        object.subs.insert(5, Entry { default: Some(Value::Unsigned(1)), ..Entry::default() });
        for sub in 0..=6 {
            let entry = object.entry(sub);
            assert_eq!(object.has(sub), entry.is_some(), "sub-index {sub}");
            let value = entry.as_ref().and_then(|entry| entry.value().cloned());
            assert_eq!(object.value(sub).map(Cow::into_owned), value, "sub-index {sub}");
        }
        let values: Vec<_> = object.values(5).collect();
        assert_eq!(values, [1, 2, 3, 5].map(|sub| (sub, object.value(sub))));
    }

    #[test]
    fn a_var_is_its_own_sub_index_0() {
        let object = Object::default();
        assert_eq!(object.entries().count(), 1);
        assert!(object.entry(0).is_some() && object.entry(1).is_none());
    }
}

//! Positions of device data in the text.

use std::collections::BTreeMap;

use super::words::{index, subs};
use objdict_keyed::tree::KeyedTree;
use objdict_model::model::field_names::{facts_of, key_of};
use objdict_model::model::{Field, Part, PdoKind, Place};
use objdict_model::source::Span;

/// A key of the text and its value.
#[derive(Clone, Copy, Debug)]
pub(super) struct KeySpan {
    pub(super) key: Span,
    pub(super) value: Span,
    /// Whether the value is a table.
    pub(super) is_table: bool,
}

impl KeySpan {
    /// The span that findings point to: for a table, its name.
    fn shown(self) -> Span {
        if self.is_table { self.key } else { self.value }
    }
}

/// The keys of a text by their paths.
#[derive(Debug, Default)]
pub(super) struct KeyPlaces {
    spots: BTreeMap<Vec<String>, KeySpan>,
}

impl KeyPlaces {
    pub(super) fn new(tree: &KeyedTree) -> Self {
        let mut places = Self::default();
        places.add(tree, &mut Vec::new());
        places
    }

    fn add(&mut self, tree: &KeyedTree, path: &mut Vec<String>) {
        for entry in tree.entries().unwrap_or_default() {
            let name = entry.key.spelled();
            // digits of indexes in one spelling
            let is_number = matches!(path.as_slice(), [object] if object == "object")
                || matches!(path.as_slice(), [object, _, sub] if object == "object" && sub == "sub");
            path.push(if is_number { name.to_ascii_uppercase() } else { name });
            let is_table = entry.value.entries().is_some();
            let spot = KeySpan { key: entry.key.span, value: entry.value.span, is_table };
            self.spots.insert(path.clone(), spot);
            self.add(&entry.value, path);
            path.pop();
        }
    }

    /// The key at a path.
    pub(super) fn at(&self, path: &[String]) -> Option<KeySpan> {
        self.spots.get(path).copied()
    }

    /// The keys below a path, with the rest of their paths.
    pub(super) fn below<'a>(&'a self, path: &'a [String]) -> impl Iterator<Item = (&'a [String], KeySpan)> {
        let found = self.spots.range(path.to_vec()..).take_while(move |(key, _)| key.starts_with(path));
        found.filter(|(key, _)| key.len() > path.len()).map(move |(key, spot)| (&key[path.len()..], *spot))
    }

    /// The values of several lines.
    pub(super) fn long_values(&self, text: &str) -> Vec<Span> {
        let spots = self.spots.values().filter(|spot| !spot.is_table);
        spots.map(|spot| spot.value).filter(|span| span.of(text).contains('\n')).collect()
    }

    /// The span of a place; for a derived value, the span of the part that it belongs to.
    pub(super) fn locate(&self, place: &Place) -> Option<Span> {
        let path = self.path_of(&place.part);
        if let Some(spot) = self.of_pdo(&path, place) {
            return Some(spot.shown());
        }
        let of_field = place.field.as_ref().into_iter().flat_map(|field| keys_of(&place.part, field));
        let mut fields = of_field.filter_map(|key| self.at(&[path.clone(), vec![key]].concat()));
        if let Some(spot) = fields.next() {
            return Some(spot.shown());
        }
        let mut path = path;
        while !path.is_empty() {
            if let Some(spot) = self.at(&path) {
                return Some(spot.shown());
            }
            path.pop();
            // content without its own table comes from the profile
            if path.len() == 1
                && path[0] == "object"
                && let Some(spot) = self.at(&["profile".to_owned()])
            {
                return Some(spot.shown());
            }
        }
        self.at(&["format".to_owned()]).map(KeySpan::shown)
    }

    /// The key that generates a PDO parameter or a mapping, if the text has no table for the object.
    fn of_pdo(&self, path: &[String], place: &Place) -> Option<KeySpan> {
        let (Part::Object(index) | Part::Entry(index, _)) = place.part else { return None };
        if self.at(path.get(..2)?).is_some() {
            return None;
        }
        let mapping = PdoKind::of_mapping(index);
        let (kind, number) = mapping.or_else(|| PdoKind::of_communication(index))?;
        let name = if kind == PdoKind::Rpdo { "rpdo" } else { "tpdo" };
        let table = vec![name.to_owned(), number.to_string()];
        let key = match place.part {
            _ if mapping.is_some() => "map",
            Part::Entry(_, sub) => super::pdos::key_of(sub).unwrap_or_default(),
            _ => "",
        };
        self.at(&[table.clone(), vec![key.to_owned()]].concat()).or_else(|| self.at(&table))
    }

    /// The path of a part.
    pub(super) fn path_of(&self, part: &Part) -> Vec<String> {
        let object = |index: u16| vec!["object".to_owned(), format!("{index:04X}")];
        let within = |index: u16, key: &str| [object(index), vec![key.to_owned()]].concat();
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect();
        match part {
            Part::FileInfo => words(&["file"]),
            Part::DeviceInfo => words(&["device"]),
            Part::Commissioning => words(&["node"]),
            Part::Comments => words(&["comments"]),
            Part::DummyUsage => words(&["dummies"]),
            Part::List(list) => {
                let name = super::words::NAMES.iter().find(|(known, _)| known == list).map(|(_, name)| *name);
                words(&["lists", name.unwrap_or_default()])
            }
            Part::Object(index) => object(*index),
            Part::Entry(index, sub) => {
                let path = within(*index, "sub");
                let holds = |key: &str| subs(key).is_some_and(|(first, last)| (first..=last).contains(sub));
                let found = self.below(&path).find(|(rest, _)| rest.len() == 1 && holds(&rest[0]));
                let key = found.map_or_else(|| format!("{sub:X}"), |(rest, _)| rest[0].clone());
                [path.clone(), vec![key]].concat()
            }
            Part::CompactNames(index) => within(*index, "names"),
            Part::CompactValues(index) => within(*index, "values"),
            Part::CompactDenotations(index) => within(*index, "denotations"),
            Part::Links(index) => within(*index, "links"),
            Part::Section(name) => words(&["extra", name]),
            part => self.raw_path(part),
        }
    }

    /// The first value of a part that has no keys.
    fn raw_path(&self, part: &Part) -> Vec<String> {
        let name = match part {
            Part::SupportedModules | Part::ConnectedModules | Part::Module(..) => "/modules",
            Part::DynamicChannels => "/dynamic_channels",
            Part::Tools | Part::Tool(_) => "/tools",
            Part::Headers => "/headers",
            Part::Identity => "/identity",
            Part::NetworkIdentity => "/network_identity",
            Part::Manager => "/manager",
            Part::Functions => "/functions",
            Part::Application => "/application",
            Part::ModuleObjects => "/module_objects",
            _ => return vec!["format".to_owned()],
        };
        let raw = ["raw".to_owned()];
        let found = self.below(&raw).find(|(rest, _)| rest.len() == 1 && rest[0].starts_with(name));
        let found = found.map(|(rest, _)| vec!["raw".to_owned(), rest[0].clone()]);
        found.unwrap_or_else(|| vec!["format".to_owned()])
    }

    /// The part of the model that a byte belongs to.
    pub(super) fn place_at(&self, at: u32) -> Option<Place> {
        let holds = |spot: &KeySpan| spot.key.start <= at && at <= spot.value.end.max(spot.key.end);
        let path = self.spots.iter().filter(|(_, spot)| holds(spot)).max_by_key(|(path, _)| path.len())?.0;
        let words: Vec<&str> = path.iter().map(String::as_str).collect();
        let part = match words.as_slice() {
            ["file", ..] => Part::FileInfo,
            ["device", ..] => Part::DeviceInfo,
            ["node", ..] => Part::Commissioning,
            ["comments"] => Part::Comments,
            ["dummies"] => Part::DummyUsage,
            ["object", object, "sub", sub, ..] => Part::Entry(index(object)?, subs(sub)?.0),
            ["object", object, ..] => Part::Object(index(object)?),
            _ => return None,
        };
        Some(Place::of(part))
    }
}

/// The keys that may state a field, the nearest first.
pub(super) fn keys_of(part: &Part, field: &Field) -> Vec<String> {
    match field {
        Field::Item(number) => return vec![format!("{number:X}")],
        // the type determines the object type; `data-type` belongs to a record or array as a whole
        Field::ObjectType => return vec!["object-type".to_owned(), "type".to_owned()],
        Field::DataType => return vec!["data-type".to_owned(), "type".to_owned()],
        Field::CompactSubObj => return vec!["type".to_owned()],
        _ => {}
    }
    let named = || facts_of(part).map(|_| field.name().into_owned());
    key_of(part, field).map(str::to_owned).or_else(named).into_iter().collect()
}

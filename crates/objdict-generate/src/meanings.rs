//! Enumerations and bit fields with identifiers for the targets `rust` and `c`. The model defines their
//! contents ([`crate::model::Meanings`]).

use super::names::{Scope, words};
use super::table::{Row, Table};
use super::{Names, Note, Options};
use crate::model::{BitStruct, DataType, Device, Enumeration, Meaning, NamedValue, Part, Place};

/// Named values and bit fields of a device.
#[derive(Debug, Default)]
pub(crate) struct Named {
    pub(crate) enums: Vec<EnumType>,
    pub(crate) words: Vec<WordType>,
}

/// An enumeration.
#[derive(Debug)]
pub(crate) struct EnumType {
    /// In lower case; unique among enumerations.
    pub(crate) name: String,
    /// Its name and the entries that use it, for comments; contains texts of the description.
    pub(crate) title: String,
    pub(crate) entries: Vec<(u16, u8)>,
    /// The type of the values.
    pub(crate) data_type: DataType,
    /// At least one.
    pub(crate) values: Vec<EnumValue>,
}

/// A named value.
#[derive(Debug)]
pub(crate) struct EnumValue {
    /// In lower case; unique in its enumeration.
    pub(crate) name: String,
    /// The name in the description.
    pub(crate) label: String,
    pub(crate) number: i128,
    /// An earlier value with the same number.
    pub(crate) alias_of: Option<usize>,
}

/// A word with bit fields.
#[derive(Debug)]
pub(crate) struct WordType {
    /// In lower case; unique among words; not a keyword.
    pub(crate) name: String,
    /// The name in the description.
    pub(crate) title: String,
    pub(crate) entries: Vec<(u16, u8)>,
    /// The type of the word.
    pub(crate) data_type: DataType,
    /// At least one.
    pub(crate) parts: Vec<WordPart>,
}

/// A bit field.
#[derive(Debug)]
pub(crate) struct WordPart {
    /// In lower case; unique in its word; not a keyword.
    pub(crate) name: String,
    /// The name in the description.
    pub(crate) label: String,
    pub(crate) first: u8,
    pub(crate) bits: u8,
    pub(crate) is_signed: bool,
    pub(crate) mask: u64,
    /// The type of its values.
    pub(crate) data_type: DataType,
}

impl Named {
    /// Whether there are no named values and no bit fields.
    pub(crate) fn is_empty(&self) -> bool {
        self.enums.is_empty() && self.words.is_empty()
    }
}

/// Identifies equal enumerations: the type, the data type and the number of values, or the entries of one
/// object with the same values.
#[derive(Debug, PartialEq, Eq)]
enum Key {
    Defined(Box<str>, DataType, usize),
    Listed(u16, DataType, Vec<(String, i128)>),
}

struct Namer<'a> {
    named: Named,
    keys: Vec<Key>,
    word_keys: Vec<(Box<str>, DataType)>,
    enum_names: Scope,
    word_names: Scope,
    by_index: bool,
    table: &'a Table,
    notes: &'a mut Vec<Note>,
}

/// The enumerations and bit fields of the entries in the table. What cannot be expressed is noted.
pub(crate) fn meanings(device: &Device, table: &Table, options: &Options, notes: &mut Vec<Note>) -> Named {
    let mut namer = Namer {
        named: Named::default(),
        keys: Vec::new(),
        word_keys: Vec::new(),
        enum_names: Scope::of_constants("self"),
        word_names: Scope::of_lower_case(""),
        by_index: options.names == Names::Index,
        table,
        notes,
    };
    if device.application.is_empty() && !has_parameters(device) {
        return namer.named;
    }
    let meanings = device.meanings();
    for row in &table.rows {
        match meanings.of(row.index, row.sub) {
            Some(Meaning::Enumeration(enumeration)) => namer.enumeration(row, &enumeration, None),
            Some(Meaning::BitStruct(word)) => namer.word(row, &word),
            None => {}
        }
    }
    namer.named
}

fn has_parameters(device: &Device) -> bool {
    let has_parameter = |entry: &crate::model::Entry| entry.parameter.is_some();
    device.objects.values().any(|object| {
        has_parameter(&object.main) || object.subs.iter().any(|(_, entry)| has_parameter(entry))
    })
}

impl Namer<'_> {
    /// `part` is the described name of the bit field with these values.
    fn enumeration(&mut self, row: &Row, enumeration: &Enumeration<'_>, part: Option<&str>) {
        let key = key_of(row, enumeration, part);
        let at = (row.index, row.sub);
        if let Some(known) = self.keys.iter().position(|other| *other == key) {
            if let Some(known) =
                self.named.enums.get_mut(known).filter(|known| known.entries.last() != Some(&at))
            {
                known.entries.push(at);
            }
            return;
        }
        self.note(row, &enumeration.defects);
        if enumeration.values.is_empty() {
            return;
        }
        let defined = enumeration.definition.map(|definition| &*definition.name);
        let (base, title) = match (defined, part) {
            (Some(name), _) if !self.by_index => (words(name), name.to_owned()),
            (_, Some(part)) => (format!("{}_{}", self.name_of(row), words(part)), part.to_owned()),
            (defined, None) => (self.name_of(row), defined.unwrap_or(&row.name).to_owned()),
        };
        let name = self.enum_names.claim(&base, format_args!("{:04x}_{:02x}", row.index, row.sub));
        self.keys.push(key);
        self.named.enums.push(EnumType {
            name,
            title,
            entries: vec![at],
            data_type: enumeration.data_type,
            values: values(&enumeration.values),
        });
    }

    fn word(&mut self, row: &Row, word: &BitStruct<'_>) {
        let key = (word.definition.unique_id.clone(), word.data_type);
        let at = (row.index, row.sub);
        for field in &word.fields {
            if let Some(values) = &field.values {
                self.enumeration(row, values, Some(field.name));
            }
        }
        if let Some(known) = self.word_keys.iter().position(|other| *other == key) {
            self.named.words[known].entries.push(at);
            return;
        }
        self.note(row, &word.defects);
        if word.fields.is_empty() {
            return;
        }
        let title = word.definition.name.to_string();
        let base = if self.by_index { self.name_of(row) } else { words(&title) };
        let name = self.word_names.claim(&base, format_args!("{:04x}_{:02x}", row.index, row.sub));
        let mut scope = Scope::of_lower_case("");
        let parts = word.fields.iter().map(|field| WordPart {
            name: scope.claim(&words(field.name), format_args!("{}", field.first)),
            label: field.name.to_owned(),
            first: field.first,
            bits: field.bits,
            is_signed: field.is_signed,
            mask: field.mask(),
            data_type: field.data_type(),
        });
        let parts = parts.collect();
        self.word_keys.push(key);
        self.named.words.push(WordType { name, title, entries: vec![at], data_type: word.data_type, parts });
    }

    /// The source of an entry's identifiers.
    fn name_of(&self, row: &Row) -> String {
        let object = self.table.objects.iter().find(|object| object.index == row.index);
        match object {
            Some(object) if object.single => object.module.clone(),
            Some(object) => format!("{}_{}", object.module, row.constant),
            None => row.constant.clone(),
        }
    }

    fn note(&mut self, row: &Row, defects: &[String]) {
        for defect in defects {
            let is_same = |note: &Note| {
                note.message == *defect
                    && matches!(note.place.part, Part::Entry(index, _) if index == row.index)
            };
            if !self.notes.iter().any(is_same) {
                self.notes.push(Note::new(Place::entry(row.index, row.sub), defect.clone()));
            }
        }
    }
}

fn key_of(row: &Row, enumeration: &Enumeration<'_>, part: Option<&str>) -> Key {
    match enumeration.definition {
        Some(definition) => {
            Key::Defined(definition.unique_id.clone(), enumeration.data_type, enumeration.values.len())
        }
        None => {
            let values = enumeration.values.iter().map(|value| (value.name.to_owned(), value.number));
            let part = part.map(|part| (part.to_owned(), -1));
            Key::Listed(row.index, enumeration.data_type, part.into_iter().chain(values).collect())
        }
    }
}

/// Makes names of values unique; equal values with equal names are merged.
fn values(named: &[NamedValue<'_>]) -> Vec<EnumValue> {
    let mut scope = Scope::of_constants("");
    let mut values: Vec<EnumValue> = Vec::new();
    for &NamedValue { name, number } in named {
        let is_same = |other: &EnumValue| other.number == number && words(&other.label) == words(name);
        if values.iter().any(is_same) {
            continue;
        }
        let suffix = if number < 0 { format!("m{}", -number) } else { number.to_string() };
        let base = words(name);
        let base = if base.is_empty() { format!("value_{suffix}") } else { base };
        let alias_of = values.iter().position(|other| other.number == number);
        let label = name.to_owned();
        values.push(EnumValue {
            name: scope.claim(&base, format_args!("{suffix}")),
            label,
            number,
            alias_of,
        });
    }
    values
}

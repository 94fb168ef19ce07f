//! Enumerations and bit fields with identifiers for the targets `rust` and `c`. The model defines their contents
//! ([`crate::model::Meanings`]); for undefined objects of a device profile, the document does.

use super::names::{NameScope, words};
use super::resolve::ValueShape;
use super::table::{DeviceTable, Row, TableObject};
use super::{Names, Note, Options};
use crate::model::{
    BitField, BitStruct, DataType, Device, Enumeration, Meaning, NamedValue, Part, Place, Scaling,
};

/// Named values and bit fields of a device.
#[derive(Default)]
pub(crate) struct NamedMeanings {
    pub(crate) enums: Vec<EnumType>,
    pub(crate) words: Vec<WordType>,
}

/// An enumeration.
pub(crate) struct EnumType {
    /// In lower case; unique among enumerations.
    pub(crate) name: String,
    /// Its name and the entries that use it, for comments; contains texts of the description.
    pub(crate) title: String,
    pub(crate) entries: Vec<(u16, u8)>,
    /// The type of the values.
    pub(crate) data_type: DataType,
    /// Bits of a value.
    pub(crate) bits: u8,
    /// At least one.
    pub(crate) values: Vec<EnumConstant>,
}

/// A named value.
pub(crate) struct EnumConstant {
    /// In lower case; unique in its enumeration.
    pub(crate) name: String,
    /// The name in the description.
    pub(crate) label: String,
    pub(crate) number: i128,
    /// Further numbers with this meaning.
    pub(crate) others: Vec<i128>,
    /// An earlier value with the same number.
    pub(crate) alias_of: Option<usize>,
}

/// A word with bit fields.
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

impl NamedMeanings {
    /// Whether there are no named values and no bit fields.
    pub(crate) fn is_empty(&self) -> bool {
        self.enums.is_empty() && self.words.is_empty()
    }
}

/// Identifies equal enumerations: the type, the data type and the number of values, or the entries of one
/// object with the same values.
#[derive(PartialEq, Eq)]
enum MeaningKey {
    Defined(Box<str>, DataType, usize),
    Listed(u16, DataType, Vec<(String, i128)>),
}

struct Namer<'a> {
    named: NamedMeanings,
    keys: Vec<MeaningKey>,
    word_keys: Vec<(Box<str>, DataType)>,
    by_index: bool,
    table: &'a DeviceTable,
    notes: &'a mut Vec<Note>,
}

/// The enumerations and bit fields of the entries in the table. Inexpressible ones are noted.
pub(crate) fn meanings(
    device: &Device,
    table: &DeviceTable,
    options: &Options,
    notes: &mut Vec<Note>,
) -> NamedMeanings {
    let mut namer = Namer {
        named: NamedMeanings::default(),
        keys: Vec::new(),
        word_keys: Vec::new(),
        by_index: options.names == Names::Index,
        table,
        notes,
    };
    let meanings = device.meanings();
    for row in &table.rows {
        match meanings.of(row.index, row.sub) {
            Some(Meaning::Enumeration(enumeration)) => namer.enumeration(row, &enumeration, None),
            Some(Meaning::BitStruct(word)) => namer.word(row, &word),
            None if OF_PROFILES.contains(&row.index) => namer.documented(device, row),
            None => {}
        }
    }
    let NamedMeanings { enums, words, .. } = &mut namer.named;
    name_all(
        NameScope::of_constants("self"),
        enums.iter_mut().map(|of| (&mut of.name, of.entries[0])).collect(),
    );
    name_all(
        NameScope::of_lower_case(""),
        words.iter_mut().map(|of| (&mut of.name, of.entries[0])).collect(),
    );
    namer.named
}

/// Makes names unique by their first entries, without regard to their order.
fn name_all(mut scope: NameScope, mut names: Vec<(&mut String, (u16, u8))>) {
    scope.foresee(names.iter().map(|(name, _)| name.as_str()));
    for (name, (index, sub)) in &mut names {
        **name = scope.claim(name, format_args!("{index:04x}_{sub:02x}"));
    }
}

/// The objects of device profiles (CiA 301 §7.4.1).
const OF_PROFILES: std::ops::RangeInclusive<u16> = 0x6000..=0x9FFF;

impl Namer<'_> {
    /// `part` is the described name of the bit field with these values.
    fn enumeration(&mut self, row: &Row, enumeration: &Enumeration<'_>, part: Option<&str>) {
        let key = key_of(row, enumeration, part);
        if self.is_known(row, &key) {
            return;
        }
        self.note(row, &enumeration.defects);
        if enumeration.values.is_empty() {
            return;
        }
        let defined = enumeration.definition.map(|definition| &*definition.name);
        let (base, title) = match (defined, part) {
            (Some(name), _) if !self.by_index => (words(name), name.to_owned()),
            (_, Some(part)) => (format!("{}_{}", self.table.words_of(row), words(part)), part.to_owned()),
            (defined, None) => (self.table.words_of(row), defined.unwrap_or(&row.name).to_owned()),
        };
        let bits = enumeration.data_type.bit_length().unwrap_or(64);
        self.add_enum(row, key, (&base, title), (enumeration.data_type, bits), values(&enumeration.values));
    }

    /// Whether such an enumeration exists; it is then assigned to the entry.
    fn is_known(&mut self, row: &Row, key: &MeaningKey) -> bool {
        let at = (row.index, row.sub);
        let Some(known) = self.keys.iter().position(|other| other == key) else { return false };
        if let Some(known) = self.named.enums.get_mut(known).filter(|known| known.entries.last() != Some(&at))
        {
            known.entries.push(at);
        }
        true
    }

    fn add_enum(
        &mut self,
        row: &Row,
        key: MeaningKey,
        (base, title): (&str, String),
        (data_type, bits): (DataType, u8),
        values: Vec<EnumConstant>,
    ) {
        let name = base.to_owned();
        self.keys.push(key);
        let entries = vec![(row.index, row.sub)];
        self.named.enums.push(EnumType { name, title, entries, data_type, bits, values });
    }

    /// The bits of an entry in the document of the device's profile.
    fn documented(&mut self, device: &Device, row: &Row) {
        let ValueShape::Word(data_type) = row.resolved.shape else { return };
        let (Some((low, _)), Some(bits)) = (data_type.integer_range(), data_type.bit_length()) else {
            return;
        };
        let documents = objdict_profile::of_object(device, row.index).map(|(_, facts)| facts);
        let mut fields = objdict_profile::bits(documents, row.sub);
        fields.retain(|field| field.last < bits);
        let part = |field: &objdict_profile::BitFieldFacts<'static>| BitField {
            name: field.name,
            first: field.first,
            bits: field.last - field.first + 1,
            is_signed: false,
            values: None,
            scaling: Scaling::default(),
        };
        let parts: Vec<BitField<'static>> = fields.iter().map(part).collect();
        let is_whole = matches!(parts.as_slice(), [part] if part.bits == bits);
        let (name, title) = match self.array_of(row) {
            Some(array) => (array.module.clone(), array.name.clone()),
            None => (self.table.words_of(row), row.name.clone()),
        };
        for (field, part) in fields.iter().zip(&parts) {
            let values = documented_values(field, (is_whole && low < 0).then_some(bits));
            let listed = values.iter().map(|value| (value.label.clone(), value.number));
            let listed = listed.chain([(part.name.to_owned(), part.first.into())]).collect();
            let key = MeaningKey::Listed(row.index, data_type, listed);
            if values.is_empty() || self.is_known(row, &key) {
                continue;
            }
            let (base, title, of) = match is_whole {
                true => (name.clone(), title.clone(), (data_type, bits)),
                false => {
                    let base = format!("{name}_{}", words(part.name));
                    (base, part.name.to_owned(), (part.data_type(), part.bits))
                }
            };
            self.add_enum(row, key, (&base, title), of, values);
        }
        if is_whole || parts.is_empty() {
            return;
        }
        let bits: Vec<_> = parts.iter().map(|part| (part.name, part.first, part.bits)).collect();
        let key = (format!("{:04X}h {bits:?}", row.index).into(), data_type);
        match self.word_keys.iter().position(|other| *other == key) {
            Some(known) => self.named.words[known].entries.push((row.index, row.sub)),
            None => self.add_word(row, key, (&name, title), data_type, &parts),
        }
    }

    fn add_word(
        &mut self,
        row: &Row,
        key: (Box<str>, DataType),
        (base, title): (&str, String),
        data_type: DataType,
        fields: &[BitField<'_>],
    ) {
        let mut scope = NameScope::of_lower_case("");
        let names: Vec<String> = fields.iter().map(|field| words(field.name)).collect();
        scope.foresee(names.iter().map(String::as_str));
        let parts = fields.iter().zip(&names).map(|(field, name)| WordPart {
            name: scope.claim(name, format_args!("{}", field.first)),
            label: field.name.to_owned(),
            first: field.first,
            bits: field.bits,
            is_signed: field.is_signed,
            mask: field.mask(),
            data_type: field.data_type(),
        });
        let parts = parts.collect();
        self.word_keys.push(key);
        self.named.words.push(WordType {
            name: base.to_owned(),
            title,
            entries: vec![(row.index, row.sub)],
            data_type,
            parts,
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
        let base = if self.by_index { self.table.words_of(row) } else { words(&title) };
        self.add_word(row, key, (&base, title), word.data_type, &word.fields);
    }

    /// The array that an entry is an element of.
    fn array_of(&self, row: &Row) -> Option<&TableObject> {
        let is_element = row.slot.is_some_and(|slot| slot.element.is_some());
        self.table.objects.iter().find(|object| is_element && object.index == row.index)
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

/// The entries as text, the first few by name.
pub(crate) fn entries(all: &[(u16, u8)], name: impl Fn(u16, u8) -> String) -> String {
    const SHOWN: usize = 8;
    let shown: Vec<String> = all.iter().take(SHOWN).map(|&(index, sub)| name(index, sub)).collect();
    let more = all.len().checked_sub(SHOWN).filter(|&more| more > 0);
    shown.join(", ") + &more.map(|more| format!(" and {more} more")).unwrap_or_default()
}

fn key_of(row: &Row, enumeration: &Enumeration<'_>, part: Option<&str>) -> MeaningKey {
    match enumeration.definition {
        Some(definition) => {
            MeaningKey::Defined(definition.unique_id.clone(), enumeration.data_type, enumeration.values.len())
        }
        None => {
            let values = enumeration.values.iter().map(|value| (value.name.to_owned(), value.number));
            let part = part.map(|part| (part.to_owned(), -1));
            MeaningKey::Listed(row.index, enumeration.data_type, part.into_iter().chain(values).collect())
        }
    }
}

/// Makes names of values unique; equal values with equal names are merged.
fn values(named: &[NamedValue<'_>]) -> Vec<EnumConstant> {
    let mut scope = NameScope::of_constants("");
    let mut values: Vec<EnumConstant> = Vec::new();
    for &NamedValue { name, number } in named {
        let is_same = |other: &EnumConstant| other.number == number && words(&other.label) == words(name);
        if values.iter().any(is_same) {
            continue;
        }
        let suffix = if number < 0 { format!("m{}", -number) } else { number.to_string() };
        let base = words(name);
        let base = if base.is_empty() { format!("value_{suffix}") } else { base };
        let alias_of = values.iter().position(|other| other.number == number);
        let label = name.to_owned();
        values.push(EnumConstant {
            name: scope.claim(&base, format_args!("{suffix}")),
            label,
            number,
            others: Vec::new(),
            alias_of,
        });
    }
    values
}

/// The named values of a bit field in a document: each name once. The highest bit of a signed number of this
/// many bits is its sign. A range of values has no name.
fn documented_values(field: &objdict_profile::BitFieldFacts<'_>, signed: Option<u8>) -> Vec<EnumConstant> {
    let single = field.meanings().filter(|(range, _)| range.start() == range.end());
    let number = |(range, label): (std::ops::RangeInclusive<u64>, &str)| {
        let number = i128::from(*range.start());
        let is_negative = signed.is_some_and(|bits| number >> (bits - 1) & 1 == 1);
        (label.to_owned(), if is_negative { number - (1 << signed.unwrap_or(0)) } else { number })
    };
    let mut values: Vec<EnumConstant> = Vec::new();
    let mut scope = NameScope::of_constants("");
    for (label, number) in single.map(number) {
        match values.iter_mut().find(|value| value.label == label) {
            Some(known) => known.others.push(number),
            None => {
                let name = scope.claim(&words(&label), format_args!("{number}"));
                values.push(EnumConstant { name, label, number, others: Vec::new(), alias_of: None });
            }
        }
    }
    values
}

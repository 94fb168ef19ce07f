//! The attributes of objects and sub-objects.

use super::text::{Text, boolean, hex};
use crate::diagnostic::Findings;
use crate::literal::{self, Quirks};
use crate::model::{
    Access, DataType, Entry, Field, Misfits, ObjFlags, ObjectType, PdoMapping, Reason, StackOptions, Value,
};
use crate::xdd::defaults;
use crate::xdd::shape::stack_attribute;
use crate::xml::{Attribute, Element};

/// The attributes of a `CANopenObject` or `CANopenSubObject`, not yet understood.
#[derive(Default)]
pub(crate) struct EntryAttributes<'a> {
    /// `index` or `subIndex`.
    pub(crate) address: Option<Attribute<'a>>,
    /// `uniqueIDRef`.
    pub(crate) reference: Option<Attribute<'a>>,
    /// `subNumber`.
    pub(crate) sub_number: Option<Attribute<'a>>,
    name: Option<Attribute<'a>>,
    object_type: Option<Attribute<'a>>,
    data_type: Option<Attribute<'a>>,
    access: Option<Attribute<'a>>,
    mapping: Option<Attribute<'a>>,
    flags: Option<Attribute<'a>>,
    denotation: Option<Attribute<'a>>,
    low: Option<Attribute<'a>>,
    high: Option<Attribute<'a>>,
    default: Option<Attribute<'a>>,
    actual: Option<Attribute<'a>>,
    /// Those that the standard does not have.
    unknown: Vec<Attribute<'a>>,
}

/// The attributes with values, which can only be read when the data type is known.
pub(crate) struct ValueAttributes<'a> {
    low: Option<Text<'a>>,
    high: Option<Text<'a>>,
    default: Option<Text<'a>>,
    actual: Option<Text<'a>>,
}

impl<'a> EntryAttributes<'a> {
    /// Sorts the attributes of an element.
    pub(crate) fn of(element: Element<'a>) -> Self {
        let mut found = Self::default();
        for attribute in element.attributes() {
            let place = match attribute.name() {
                "index" | "subIndex" => &mut found.address,
                "uniqueIDRef" => &mut found.reference,
                "subNumber" => &mut found.sub_number,
                "name" => &mut found.name,
                "objectType" => &mut found.object_type,
                "dataType" => &mut found.data_type,
                "accessType" => &mut found.access,
                "PDOmapping" => &mut found.mapping,
                "objFlags" => &mut found.flags,
                "denotation" => &mut found.denotation,
                "lowLimit" => &mut found.low,
                "highLimit" => &mut found.high,
                "defaultValue" => &mut found.default,
                "actualValue" => &mut found.actual,
                _ => {
                    found.unknown.push(attribute);
                    continue;
                }
            };
            place.get_or_insert(attribute);
        }
        found
    }

    /// Whether the element is only there for its sub-objects.
    pub(crate) fn is_orphan(&self) -> bool {
        self.object_type.is_some_and(|code| code.value() == defaults::ORPHAN)
    }

    /// The index of an object.
    pub(crate) fn index(&self) -> Option<u16> {
        let number = hex(self.address?.value().trim_ascii(), 4)?;
        u16::try_from(number).ok()
    }

    /// The sub-index of a sub-object.
    pub(crate) fn sub_index(&self) -> Option<u8> {
        let number = hex(self.address?.value().trim_ascii(), 4)?;
        u8::try_from(number).ok()
    }

    /// What the attributes say but for values, and the values.
    pub(crate) fn read(&self) -> (Entry, ValueAttributes<'a>) {
        let mut entry = Entry::default();
        let misfits = &mut entry.misfits;
        if let Some(name) = self.name {
            entry.name = name.value().trim_ascii().into();
        }
        if let Some(text) = self.object_type.map(Text::of) {
            entry.object_type = object_type(&text, misfits);
        }
        if let Some(text) = self.data_type.map(Text::of) {
            entry.data_type = data_type(&text, misfits);
        }
        if let Some(text) = self.access.map(Text::of) {
            entry.access = text.word(Field::AccessType, Access::from_name, misfits);
        }
        if let Some(text) = self.mapping.map(Text::of) {
            entry.pdo_mapping = text.word(Field::PdoMapping, pdo_mapping, misfits);
        }
        if let Some(text) = self.flags.map(Text::of) {
            entry.flags = text.hex(Field::ObjFlags, 8, misfits).map(ObjFlags);
        }
        if let Some(text) = self.denotation.map(Text::of).filter(|text| !text.is_blank()) {
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
        let text = |attribute: Option<Attribute<'a>>| attribute.map(Text::of);
        let values = ValueAttributes {
            low: text(self.low),
            high: text(self.high),
            default: text(self.default),
            actual: text(self.actual),
        };
        (entry, values)
    }
}

impl ValueAttributes<'_> {
    /// Reads the values of an entry whose data type is known.
    pub(crate) fn read(&self, entry: &mut Entry, findings: &mut Findings) {
        let data_type = value_type(entry);
        let mut read = |text: &Option<Text<'_>>, field: Field, misfits: &mut Misfits| -> Option<Value> {
            let text = text.as_ref()?;
            match text.value(data_type, findings)? {
                Ok(value) => Some(value),
                Err(reason) => {
                    text.misfit(field, reason, misfits);
                    None
                }
            }
        };
        entry.default = read(&self.default, Field::DefaultValue, &mut entry.misfits);
        entry.low_limit = read(&self.low, Field::LowLimit, &mut entry.misfits);
        entry.high_limit = read(&self.high, Field::HighLimit, &mut entry.misfits);
        if let Some(value) = read(&self.actual, Field::ParameterValue, &mut entry.misfits) {
            entry.configured_mut().value = Some(value);
        }
    }
}

/// The data type of an entry's values: a DOMAIN has the type of that name, stated or not.
pub(crate) fn value_type(entry: &Entry) -> Option<DataType> {
    match (entry.data_type, entry.object_type) {
        (None, Some(ObjectType::Domain)) => Some(DataType::DOMAIN),
        (data_type, _) => data_type,
    }
}

/// A decimal object code, or the name of one.
fn object_type(text: &Text<'_>, misfits: &mut Misfits) -> Option<ObjectType> {
    let word = text.trimmed();
    if matches!(word, "" | defaults::OBJECT_TYPE | defaults::ORPHAN) {
        return None;
    }
    let named = |object_type: &ObjectType| object_type.name().eq_ignore_ascii_case(word);
    if let Some(object_type) = (0..=9).filter_map(ObjectType::from_code).find(named) {
        return Some(object_type);
    }
    let code = literal::integer(word, 0, 255, &mut Quirks::default());
    let reason = match code.map(|code| u8::try_from(code).ok().and_then(ObjectType::from_code)) {
        Ok(Some(object_type)) => return Some(object_type),
        Ok(None) => Reason::UnknownWord,
        Err(reason) => reason,
    };
    text.misfit(Field::ObjectType, reason, misfits);
    None
}

/// Two or four hex digits, or a name.
fn data_type(text: &Text<'_>, misfits: &mut Misfits) -> Option<DataType> {
    let word = text.trimmed();
    if word.is_empty() {
        return None;
    }
    let index = hex(word, 4).and_then(|index| u16::try_from(index).ok());
    let data_type = index.map(DataType).or_else(|| DataType::from_name(word));
    if data_type.is_none() {
        text.misfit(Field::DataType, Reason::NotANumber, misfits);
    }
    data_type
}

fn pdo_mapping(word: &str) -> Option<PdoMapping> {
    let words = [
        ("no", PdoMapping::No),
        ("default", PdoMapping::Default),
        ("optional", PdoMapping::Optional),
        ("TPDO", PdoMapping::Tpdo),
        ("RPDO", PdoMapping::Rpdo),
    ];
    let known = words.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(word));
    // what an EDS writes
    let flag = || boolean(word).map(|yes| if yes { PdoMapping::Optional } else { PdoMapping::No });
    known.map(|(_, mapping)| mapping).or_else(flag)
}

//! The sections of objects and sub-indexes.

use super::EdsReader;
use super::items::Items;
use crate::eds::findings::{self, DuplicateKind};
use crate::eds::item::Item;
use crate::ini;
use crate::literal::{self, Quirks};
use crate::model::{
    Access, Compact, Configured, DataType, Entry, ExtensionCount, Field, InvalidValues, LANGUAGE, Labels,
    ObjFlags, Object, ObjectType, PdoMapping, Place, Reason, SafetyMapping, StackOptions, Unit, Value,
};

/// The keys in the section of an object or module that are not part of the entry.
#[derive(Default)]
pub(super) struct ObjectKeys {
    sub_number: Option<u8>,
    compact_count: Option<u8>,
    pub count: Option<ExtensionCount>,
    pub obj_extend: Option<u8>,
}

/// The keys that a section may have in addition to those of every entry.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum SectionKind {
    Object,
    Entry,
    Extension,
}

impl EdsReader<'_> {
    /// `[1018]`.
    pub(super) fn object(&mut self, index: u16, section: &ini::Section) {
        let mut items = Items::new(self.text, section, &mut self.findings);
        let object = self.objects.get_or_insert(index);
        if object.orphan {
            return read_object(&mut items, object);
        }
        let mut other = Object::default();
        read_object(&mut items, &mut other);
        let (compact, first) = (other.compact.as_deref(), object.compact.as_deref());
        let is_equal = other.main == object.main
            && other.sub_number == object.sub_number
            && compact.map(|compact| compact.count) == first.map(|compact| compact.count);
        self.duplicate_object(section, Place::object(index), is_equal);
    }

    /// `[1018sub1]`.
    pub(super) fn entry(&mut self, index: u16, sub: u8, section: &ini::Section) {
        let mut items = Items::new(self.text, section, &mut self.findings);
        let subs = &mut self.objects.get_or_insert(index).subs;
        let Some(first) = subs.get(sub) else {
            read_object_section(&mut items, SectionKind::Entry, subs.get_or_insert(sub));
            return;
        };
        let mut other = Entry::default();
        read_object_section(&mut items, SectionKind::Entry, &mut other);
        let is_equal = *first == other;
        self.duplicate_object(section, Place::entry(index, sub), is_equal);
    }

    fn duplicate_object(&mut self, section: &ini::Section, first: Place, is_equal: bool) {
        let (name, at) = self.header_of(section);
        let kind = if is_equal { DuplicateKind::Equal } else { DuplicateKind::Other };
        self.findings.push(findings::duplicate_section(name, at, first, kind));
    }
}

/// Reads the section of an object into the object, which may already have entries.
pub(super) fn read_object(items: &mut Items<'_>, object: &mut Object) {
    object.orphan = false;
    object.main = Entry::default();
    let read = read_object_section(items, SectionKind::Object, &mut object.main);
    object.sub_number = read.sub_number;
    object.compact = read.compact_count.map(|count| Box::new(Compact { count, ..Compact::default() }));
}

/// The values of a section, which can be read only once the data type is known.
#[derive(Default)]
struct SectionValues<'a> {
    default: Option<Item<'a>>,
    low: Option<Item<'a>>,
    high: Option<Item<'a>>,
    configured: Option<Item<'a>>,
    /// Whether the object cannot have values, which is reported elsewhere.
    is_unsupported: bool,
}

/// Reads a section into an empty entry.
pub(super) fn read_object_section(items: &mut Items<'_>, kind: SectionKind, entry: &mut Entry) -> ObjectKeys {
    let mut read = ObjectKeys::default();
    let mut values = SectionValues::default();
    items.each(|items, item| match item.field() {
        Some(Field::DefaultValue) => values.default = Some(*item),
        Some(Field::LowLimit) => values.low = Some(*item),
        Some(Field::HighLimit) => values.high = Some(*item),
        Some(Field::ParameterValue) => values.configured = Some(*item),
        Some(Field::ParameterName) => entry.name = items.text(item).into(),
        Some(Field::SubNumber) if kind == SectionKind::Object => {
            read.sub_number = items.integer(item, (0, 255), &mut entry.invalid_values);
        }
        Some(Field::CompactSubObj) if kind == SectionKind::Object => {
            read.compact_count = compact_count(items, item, &mut entry.invalid_values);
        }
        Some(Field::Count) if kind == SectionKind::Extension => {
            read.count = extension_count(item, &mut entry.invalid_values);
        }
        Some(Field::ObjExtend) if kind == SectionKind::Extension => {
            read.obj_extend = items.integer(item, (0, 255), &mut entry.invalid_values);
        }
        Some(field) => entry_item(entry, field, items, item),
        None => unknown(entry, items, item),
    });
    let is_structure = entry.object_type.is_some_and(ObjectType::has_subs);
    values.is_unsupported = kind == SectionKind::Object && is_structure && read.compact_count.is_none();
    read_values(entry, &values, items);
    items.comments().for_each(|comment| stack_option(entry, comment));
    drop_empty(entry);
    read
}

/// A comment with a setting of CANopenEditor for CANopenNode generators: `;StorageLocation=RAM`,
/// `;CO_countLabel=TPDO`. Of two equal settings, the first is used.
pub(super) fn stack_option(entry: &mut Entry, comment: &str) {
    let setting = comment.strip_prefix(';').and_then(|comment| comment.split_once('='));
    if let Some((name, value)) = setting.filter(|(name, _)| name.starts_with(['S', 'C'])) {
        let name = if name == "StorageLocation" { "CO_storageGroup" } else { name };
        let mut options = entry.stack.take().unwrap_or_default();
        options.set(name, value.trim());
        entry.stack = Some(options).filter(|options| **options != StackOptions::default());
    }
}

/// An empty key means the same as a missing one.
fn drop_empty(entry: &mut Entry) {
    entry.configured = entry.configured.take().filter(|configured| **configured != Configured::default());
    entry.safety = entry.safety.take().filter(|safety| **safety != SafetyMapping::default());
}

fn entry_item<'a>(entry: &mut Entry, field: &Field, items: &mut Items<'a>, item: &Item<'a>) {
    let invalid_values = &mut entry.invalid_values;
    match field {
        Field::ObjectType => entry.object_type = object_type(items, item, invalid_values),
        Field::DataType => entry.data_type = items.integer(item, (0, 0xFFFF), invalid_values).map(DataType),
        Field::AccessType => entry.access = items.word(item, Access::from_name, invalid_values),
        Field::PdoMapping => {
            let mappable = items.boolean(item, invalid_values);
            entry.pdo_mapping = mappable.map(|yes| if yes { PdoMapping::Optional } else { PdoMapping::No });
        }
        Field::ObjFlags => {
            entry.flags = items.integer(item, (0, u64::from(u32::MAX)), invalid_values).map(ObjFlags);
        }
        Field::Denotation => entry.configured_mut().denotation = text(items, item),
        Field::UploadFile => entry.configured_mut().upload_file = text(items, item),
        Field::DownloadFile => entry.configured_mut().download_file = text(items, item),
        Field::ParamRefd => entry.configured_mut().reference_designator = text(items, item),
        Field::SrdoMapping => {
            entry.safety_mut().srdo_mapping = items.boolean(item, &mut entry.invalid_values);
        }
        Field::InvertedSrad => {
            entry.safety_mut().inverted_srad =
                items.integer(item, (0, u64::from(u32::MAX)), &mut entry.invalid_values);
        }
        _ => unknown(entry, items, item),
    }
}

/// A key that CiA 306 does not define for an entry. python-canopen reads a unit, a factor and a description.
fn unknown<'a>(entry: &mut Entry, items: &mut Items<'a>, item: &Item<'a>) {
    let value = item.value.trim();
    let is_number = || value.parse::<f64>().is_ok_and(f64::is_finite);
    match item.name.to_ascii_lowercase().as_str() {
        _ if value.is_empty() => return items.unknown(item, &mut entry.extra),
        "unit" => entry.parameter_mut().unit = Some(Unit::named(LANGUAGE, value)),
        "factor" if is_number() => entry.parameter_mut().multiplier = Some(value.into()),
        "description" => entry.parameter_mut().labels = Labels::description(LANGUAGE, value),
        _ => return items.unknown(item, &mut entry.extra),
    }
    items.report_unknown(item);
}

/// The string if it is not empty.
fn text<'a>(items: &mut Items<'a>, item: &Item<'a>) -> Option<Box<str>> {
    Some(items.text(item)).filter(|text| !text.is_empty()).map(Into::into)
}

fn object_type<'a>(
    items: &mut Items<'a>,
    item: &Item<'a>,
    invalid_values: &mut InvalidValues,
) -> Option<ObjectType> {
    let code: u8 = items.integer(item, (0, 255), invalid_values)?;
    let object_type = ObjectType::from_code(code);
    if object_type.is_none() {
        invalid_values.push(Field::ObjectType, item.value, Reason::UnknownWord);
    }
    object_type
}

/// 1 to 254; 0 means that the object is not stored compactly. 255 is invalid, because FFh is not an element (CiA 301
/// §7.4.7.1), and obviously means all of them.
fn compact_count<'a>(
    items: &mut Items<'a>,
    item: &Item<'a>,
    invalid_values: &mut InvalidValues,
) -> Option<u8> {
    let all =
        || literal::integer_in_line(item.value, 255, 255, &mut Quirks::default()).is_ok().then_some(254);
    items.integer(item, (0, 254), invalid_values).or_else(all).filter(|&count| count > 0)
}

/// `n`, or `0;b`.
fn extension_count(item: &Item<'_>, invalid_values: &mut InvalidValues) -> Option<ExtensionCount> {
    let integer =
        |text: &str| literal::integer_in_line(text.trim_ascii(), 0, 255, &mut Quirks::default()).ok();
    let number = |text| u8::try_from(integer(text)?).ok().filter(|&number| number > 0);
    let count = match item.value.split_once(';') {
        Some((zero, bits)) if integer(zero) == Some(0) => number(bits).map(ExtensionCount::SharedBits),
        Some(_) => None,
        None => number(item.value).map(ExtensionCount::Subs),
    };
    if count.is_none() && !item.value.is_empty() {
        invalid_values.push(Field::Count, item.value, Reason::Malformed);
    }
    count
}

fn read_values(entry: &mut Entry, values: &SectionValues<'_>, items: &mut Items<'_>) {
    let is_domain = entry.object_type == Some(ObjectType::Domain);
    let mut read = |item: &Option<Item<'_>>, entry: &mut Entry| match item {
        Some(item) if !item.value.is_empty() => {
            let is_limit = matches!(item.field(), Some(Field::LowLimit | Field::HighLimit));
            read_value((item, values.is_unsupported || is_domain && is_limit), entry, items)
        }
        _ => None,
    };
    entry.default = read(&values.default, entry);
    entry.low_limit = read(&values.low, entry);
    if let Some(value) = read(&values.configured, entry) {
        entry.configured_mut().value = Some(value);
    }
    // its meaning depends on the other values
    entry.high_limit = read(&values.high, entry);
}

fn read_value(
    (item, is_unsupported): (&Item<'_>, bool),
    entry: &mut Entry,
    items: &mut Items<'_>,
) -> Option<Value> {
    let data_type = entry.implied_type();
    if let Some(value) = literal::plain_value(item.value, data_type) {
        return Some(value);
    }
    let mut quirks = Quirks::default();
    let value = literal::value_in_line(item.value, data_type, &mut quirks);
    match value {
        Ok(value) => {
            let value = match item.field() {
                Some(Field::HighLimit) => literal::high_limit(value, entry, &mut quirks),
                _ => value,
            };
            if !quirks.is_empty() && !is_unsupported {
                findings::quirks(item, quirks, Some(&value), items.findings);
            }
            Some(value)
        }
        Err(reason) => {
            entry.invalid_values.push(item.to_field(), item.value, reason);
            None
        }
    }
}

//! Object lists, objects and their entries.

use std::borrow::Cow;
use std::collections::BTreeSet;

use super::EdsWriter;
use super::section_writer::SectionWriter;
use crate::literal::{self, Spelling};
use crate::model::{
    Access, Compact, DataType, Device, Entry, Extension, ExtensionCount, Field, LANGUAGE, Meanings,
    ModulePart, Object, ObjectList, ObjectLists, ObjectType, Part, PdoMapping, Value,
};

/// The owner of the written objects.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ObjectOwner {
    /// The device.
    Device,
    /// The module with this number.
    Module(u16),
}

impl ObjectOwner {
    fn object(self, index: u16) -> Part {
        match self {
            Self::Device => Part::Object(index),
            Self::Module(number) => Part::Module(number, ModulePart::Fixed(index)),
        }
    }

    fn entry(self, index: u16, sub: u8) -> Part {
        match self {
            Self::Device => Part::Entry(index, sub),
            Self::Module(number) => Part::Module(number, ModulePart::FixedEntry(index, sub)),
        }
    }
}

/// The keys that occur only in the section of an object, and the array of an element.
#[derive(Default)]
struct Own<'a> {
    array: Option<&'a Entry>,
    sub_number: Option<u8>,
    compact: Option<u8>,
    count: Option<ExtensionCount>,
    obj_extend: Option<u8>,
}

/// `0x1018`.
pub(super) fn index_text(index: &u16) -> String {
    format!("0x{index:04X}")
}

impl EdsWriter<'_> {
    /// The lists, each followed by its objects: data types first, objects in no list last.
    pub(super) fn objects(&self, sections: &mut SectionWriter<'_>) {
        let lists = lists(self.device);
        let listed: BTreeSet<u16> = lists.iter().map(|(_, index)| index).collect();
        let (types, others): (Vec<u16>, Vec<u16>) = {
            let unlisted = self.device.objects.keys().filter(|index| !listed.contains(index));
            unlisted.partition(|&&index| index < 0x1000)
        };
        self.objects_of(sections, &types, &mut BTreeSet::new());
        let mut written = BTreeSet::new();
        for list in ObjectList::ALL {
            if let Some(indexes) = stated(&lists, list) {
                sections.open(Part::List(list));
                sections.list(&Field::SupportedObjects, indexes.iter().map(index_text));
                sections.close();
                self.objects_of(sections, indexes, &mut written);
            }
        }
        self.objects_of(sections, &others, &mut written);
    }

    fn objects_of(&self, sections: &mut SectionWriter<'_>, indexes: &[u16], written: &mut BTreeSet<u16>) {
        for &index in indexes {
            if let Some(object) = self.device.object(index).filter(|_| written.insert(index)) {
                self.object(sections, index, object, ObjectOwner::Device);
            }
        }
    }

    /// An object with all its sections.
    pub(super) fn object(
        &self,
        sections: &mut SectionWriter<'_>,
        index: u16,
        object: &Object,
        parts: ObjectOwner,
    ) {
        let stays_compact = |compact: &Compact| {
            // only objects of the device itself have sections for the names and values of compact entries
            let named =
                !compact.names.is_empty() || !compact.values.is_empty() || !compact.denotations.is_empty();
            sections.options.compact && (parts == ObjectOwner::Device || !named)
        };
        let unknown = object.compact.as_ref().map(|compact| &compact.extra);
        let object = match &object.compact {
            Some(compact) if !stays_compact(compact) => object.expanded(),
            _ => Cow::Borrowed(object),
        };
        if !object.orphan {
            let own = Own {
                sub_number: sub_number(&object),
                compact: object.compact.as_ref().map(|compact| compact.count),
                ..Own::default()
            };
            self.entry(sections, parts.object(index), index, &object.main, &own);
        }
        let array = (object.object_type() == ObjectType::Array).then_some(&object.main);
        for (sub, entry) in object.subs.iter() {
            let own = Own { array: array.filter(|_| sub > 0), ..Own::default() };
            self.entry(sections, parts.entry(index, sub), index, entry, &own);
        }
        if parts == ObjectOwner::Device {
            if let Some(compact) = &object.compact {
                self.compact(sections, index, &object, compact);
            } else if let Some(unknown) = unknown.filter(|unknown| !unknown.is_empty()) {
                sections.open(Part::CompactValues(index));
                sections.extra(unknown.iter());
                sections.close();
            }
            if !object.links.is_empty() {
                sections.open(Part::Links(index));
                sections.list(&Field::ObjectLinks, object.links.iter().map(index_text));
                sections.close();
            }
        }
    }

    /// The sub-indexes that a module adds to an object.
    pub(super) fn extension(
        &self,
        sections: &mut SectionWriter<'_>,
        part: Part,
        index: u16,
        extension: &Extension,
    ) {
        let Extension { entry, count, obj_extend } = extension;
        let own = Own { count: *count, obj_extend: *obj_extend, ..Own::default() };
        self.entry(sections, part, index, entry, &own);
    }

    fn entry(&self, sections: &mut SectionWriter<'_>, part: Part, index: u16, entry: &Entry, own: &Own<'_>) {
        let spelling = spelling(sections, index, entry.data_type);
        // a key without a value has no meaning; an empty string is quoted
        let value = |value: Option<&Value>| {
            value.map(|value| literal::print(value, spelling)).filter(|text| !text.trim().is_empty())
        };
        let text = |text: Option<&Box<str>>| text.filter(|text| !text.trim().is_empty()).cloned();
        sections.open(part);
        sections.put(&Field::ParameterName, &entry.name);
        sections.put_some(
            &Field::ObjectType,
            entry.object_type.map(|object_type| format!("0x{:X}", object_type.code())),
        );
        sections.put_number(&Field::SubNumber, own.sub_number);
        for (name, value) in entry.stack.iter().flat_map(|stack| stack.settings()) {
            sections.comment(if name == "CO_storageGroup" { "StorageLocation" } else { name }, &value);
        }
        sections
            .put_some(&Field::DataType, entry.data_type.map(|data_type| format!("0x{:04X}", data_type.0)));
        sections.put_some(
            &Field::AccessType,
            entry.access.map(|access| directed(access, entry.pdo_mapping).name()),
        );
        sections.put_some(&Field::DefaultValue, value(entry.default.as_ref()));
        sections.put_flag(&Field::PdoMapping, entry.pdo_mapping.map(PdoMapping::is_mappable));
        sections.put_some(&Field::LowLimit, value(entry.low_limit.as_ref()));
        sections.put_some(&Field::HighLimit, value(entry.high_limit.as_ref()));
        sections.put_some(&Field::ObjFlags, entry.flags.map(|flags| format!("0x{:X}", flags.0)));
        sections.put_number(&Field::CompactSubObj, own.compact);
        sections.put_some(&Field::Count, own.count.map(count_text));
        sections.put_number(&Field::ObjExtend, own.obj_extend);
        if let Some(safety) = &entry.safety {
            sections.put_flag(&Field::SrdoMapping, safety.srdo_mapping);
            sections.put_some(&Field::InvertedSrad, safety.inverted_srad.map(|srad| format!("0x{srad:06X}")));
        }
        if let Some(configured) = &entry.configured {
            sections.put_some(&Field::ParameterValue, value(configured.value.as_ref()));
            sections.put_some(&Field::Denotation, text(configured.denotation.as_ref()));
            sections.put_some(&Field::UploadFile, text(configured.upload_file.as_ref()));
            sections.put_some(&Field::DownloadFile, text(configured.download_file.as_ref()));
            sections.put_some(&Field::ParamRefd, text(configured.reference_designator.as_ref()));
        }
        if let Some(meanings) = &self.meanings {
            // an element without a meaning uses the meaning of its array
            let array = own.array.filter(|_| entry.parameter.is_none());
            meaning(sections, meanings, array.unwrap_or(entry));
        }
        sections.close_with(&entry.extra, &entry.invalid_values);
    }

    /// The names of all entries, because readers do not derive them; values and denotations of entries that
    /// have them.
    fn compact(&self, sections: &mut SectionWriter<'_>, index: u16, object: &Object, compact: &Compact) {
        let subs = 1..=compact.count;
        let name = |sub| match compact.names.iter().find(|(named, _)| *named == sub) {
            Some((_, name)) => name.to_string(),
            None => format!("{}{sub}", object.main.name),
        };
        let names: Vec<(u8, String)> = subs.map(|sub| (sub, name(sub))).collect();
        sub_section(sections, Part::CompactNames(index), &names, String::clone);
        let spelling = spelling(sections, index, object.main.data_type);
        let is_kept = !compact.extra.is_empty() || !compact.invalid_values.is_empty();
        if !compact.values.is_empty() || is_kept {
            sub_section(sections, Part::CompactValues(index), &compact.values, |value| {
                literal::print(value, spelling)
            });
            sections.extra(compact.extra.iter());
            sections.invalid_values(&compact.invalid_values);
        }
        if !compact.denotations.is_empty() {
            sub_section(sections, Part::CompactDenotations(index), &compact.denotations, ToString::to_string);
        }
    }
}

/// The keys of python-canopen, which does not support offsets.
fn meaning(sections: &mut SectionWriter<'_>, meanings: &Meanings<'_>, entry: &Entry) {
    let scaling = meanings.scaling_of(entry);
    let name = scaling.unit.and_then(|unit| unit.labels.name_in(LANGUAGE));
    let description = entry.parameter.as_ref().and_then(|found| found.labels.description_in(LANGUAGE));
    let in_line = |text: &&str| !text.trim().is_empty() && !text.contains(['\n', '\r']);
    sections.put_some(&Field::Named("Unit".into()), name.filter(in_line));
    sections.put_some(&Field::Named("Factor".into()), scaling.factor());
    sections.put_some(&Field::Named("Description".into()), description.filter(in_line));
}

/// A section with an item for each sub-index that has a string.
fn sub_section<T>(
    sections: &mut SectionWriter<'_>,
    part: Part,
    list: &[(u8, T)],
    print: impl Fn(&T) -> String,
) {
    sections.open(part);
    sections.put(&Field::NrOfEntries, list.len().to_string());
    for (sub, item) in list {
        sections.put(&Field::Item((*sub).into()), print(item));
    }
    sections.close();
}

/// The access type that states which PDOs carry the entry, because `PDOMapping` of CiA 306 has no direction.
const fn directed(access: Access, mapping: Option<PdoMapping>) -> Access {
    match (access, mapping) {
        (Access::Rw, Some(PdoMapping::Tpdo)) => Access::Rwr,
        (Access::Rw, Some(PdoMapping::Rpdo)) => Access::Rww,
        _ => access,
    }
}

/// COB-IDs, mappings and other communication parameters are written in hex.
fn spelling(sections: &SectionWriter<'_>, index: u16, data_type: Option<DataType>) -> Spelling {
    let hex = (0x1000..=0x1FFF).contains(&index) && data_type == Some(DataType::UNSIGNED32);
    Spelling { real: sections.options.real, quote_strings: sections.options.quote_strings, hex }
}

/// `SubNumber`: as stated, otherwise the number of described entries if the standard requires the key.
fn sub_number(object: &Object) -> Option<u8> {
    let is_due = object.object_type().has_subs()
        && object.compact.is_none()
        && object.main.invalid_values.get(&Field::SubNumber).is_none();
    let described = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).count();
    object.sub_number.or_else(|| u8::try_from(described).ok().filter(|_| is_due))
}

fn count_text(count: ExtensionCount) -> String {
    match count {
        ExtensionCount::Subs(subs) => subs.to_string(),
        ExtensionCount::SharedBits(bits) => format!("0;{bits}"),
    }
}

/// The object lists of the device; if there are none, those that CiA 306-1 §4.6.3.1 requires.
fn lists(device: &Device) -> ObjectLists {
    let is_stated = ObjectList::ALL.into_iter().any(|list| stated(&device.lists, list).is_some());
    if is_stated || device.objects.is_empty() {
        return device.lists.clone();
    }
    let of = |wanted: fn(u16) -> bool| {
        let indexes = device.objects.keys().copied().filter(|&index| index >= 0x1000 && wanted(index));
        Some(indexes.collect())
    };
    ObjectLists {
        mandatory: of(is_mandatory),
        optional: of(|index| !is_mandatory(index) && !is_manufacturer(index)),
        manufacturer: of(is_manufacturer),
    }
}

fn stated(lists: &ObjectLists, list: ObjectList) -> Option<&Vec<u16>> {
    match list {
        ObjectList::Mandatory => lists.mandatory.as_ref(),
        ObjectList::Optional => lists.optional.as_ref(),
        ObjectList::Manufacturer => lists.manufacturer.as_ref(),
    }
}

const fn is_mandatory(index: u16) -> bool {
    matches!(index, 0x1000 | 0x1001 | 0x1018)
}

const fn is_manufacturer(index: u16) -> bool {
    matches!(index, 0x2000..=0x5FFF)
}

//! Whole sections that are written at once: a device, objects of the documents, PDOs, and objects of the vendor.

use serde::{Deserialize, Serialize};

use super::completion_item::{item, mappable};
use super::file::CheckedFile;
use super::protocol::{CompletionItem, CompletionItemKind, Markdown, SNIPPET, TextEdit};
use super::{edits, words};
use objdict_eds::eds;
use objdict_eds::eds::additions;
use objdict_format::scaffold;
use objdict_model::diagnostic::{Change, Fix, section_name};
use objdict_model::model::{
    Access, DataType, Device, Entry, Field, MappedObject, Object, ObjectList, ObjectType, Part, PdoKind,
    PdoMapping, Place, Value,
};
use objdict_model::source::Span;
use objdict_profile as profile;
use objdict_profile::{ObjectFacts, Profile};

/// The bits of a frame.
const FRAME: u32 = 64;

/// The first index of objects that the vendor defines.
const FIRST_OF_VENDOR: u16 = 0x2000;

/// What an item needs when it is resolved.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct WantedItem {
    pub(super) uri: String,
    /// The objects that the item adds.
    indexes: Vec<u16>,
    /// The object that gets a sub-index.
    grown: Option<u16>,
}

/// An item with what the documents say of its object.
pub(super) fn documented(
    device: &Device,
    document: &Profile,
    index: u16,
    item: CompletionItem,
) -> CompletionItem {
    CompletionItem {
        detail: Some(document.document.to_string()),
        documentation: Some(Markdown::new(words::of_object(device, index, None))),
        ..item
    }
}

/// Whether the documents state what each entry of an object needs.
fn is_whole(object: &Object) -> bool {
    let is_typed = |entry: &Entry| entry.data_type.is_some() && entry.access.is_some();
    match object.object_type().has_subs() {
        true => object.has(0) && object.subs.iter().all(|(_, entry)| is_typed(entry)),
        false => object.object_type() == ObjectType::Domain || is_typed(&object.main),
    }
}

/// The objects of the documents that a device does not have; PDOs are written as a whole.
pub(super) fn missing(device: &Device) -> impl Iterator<Item = (&'static Profile, ObjectFacts<'static>)> {
    let documents = profile::of_device(device).into_iter().chain(profile::for_all(device));
    let is_of_pdo =
        |index: u16| PdoKind::of_communication(index).is_some() || PdoKind::of_mapping(index).is_some();
    documents.flat_map(move |document| {
        let objects = document.objects().map(move |facts| (document, facts));
        let is_for =
            |facts: &ObjectFacts<'_>| facts.only.is_none_or(|only| only.holds(device, 0) != Some(false));
        objects.filter(move |(_, facts)| {
            let is_of_modules = facts.first == 0x1027 && device.modules.is_none();
            device.object(facts.first).is_none() && !is_of_pdo(facts.first) && !is_of_modules && is_for(facts)
        })
    })
}

/// Sections that a text does not have, for the line that the cursor is in.
pub(super) struct MissingSections<'a> {
    pub(super) file: &'a CheckedFile,
    pub(super) device: &'a Device,
    pub(super) line_end: &'static str,
    pub(super) line: Span,
    /// Whether the editor expands snippets.
    pub(super) expands_snippets: bool,
}

impl MissingSections<'_> {
    pub(super) fn items(&self) -> Vec<CompletionItem> {
        let device = self.device;
        let mut items = self.next_sub_indexes();
        if device.objects.is_empty() {
            items.extend(scaffold::PROFILES.iter().filter_map(|(number, _)| self.device_of(*number)));
        } else {
            items.extend(PdoKind::ALL.into_iter().filter_map(|kind| self.pdo(kind)));
            items.extend(self.of_vendor());
        }
        items.extend(missing(device).filter_map(|(document, facts)| self.object(document, &facts)));
        items
    }

    /// The next sub-index of each object that may have another.
    fn next_sub_indexes(&self) -> Vec<CompletionItem> {
        let item = |(&index, object): (&u16, &Object)| {
            let fix = edits::new_sub_index(self.device, index)?;
            let text = added(&fix.changes, self.line_end);
            let name = text.lines().next()?;
            let wanted = WantedItem { uri: self.file.uri.clone(), indexes: Vec::new(), grown: Some(index) };
            let item = item(self.file, self.line, name, text.clone(), CompletionItemKind::FIELD);
            let data = serde_json::to_value(wanted).ok();
            Some(CompletionItem { detail: Some(object.name().to_owned()), data, ..item })
        };
        self.device.objects.iter().filter_map(item).collect()
    }

    /// A whole device with what a profile demands, as `objdict new` writes it.
    fn device_of(&self, number: u16) -> Option<CompletionItem> {
        let name = self.file.source().name().rsplit(['/', '\\']).next().unwrap_or_default();
        let wanted = scaffold::Wanted::to_fill_in(number, name)?;
        let device = scaffold::scaffold(&wanted).ok()?;
        let text = String::from_utf8(eds::write(&device, &eds::Style::default())).ok()?;
        let text = text.replace("\r\n", "\n").replace('\n', self.line_end);
        let vendor_id = format!("0x{:08X}", wanted.vendor_id);
        let label = format!("[FileInfo] a device of CiA {number}");
        let blanks = [&*wanted.vendor_name, &vendor_id, &wanted.product_name];
        Some(CompletionItem {
            detail: Some("what the profile requires".to_owned()),
            // in front of the objects
            sort_text: Some(format!("!{label}")),
            ..self.written(&label, text, &blanks, CompletionItemKind::MODULE)
        })
    }

    /// An object as a document demands it.
    fn object(&self, document: &Profile, facts: &ObjectFacts<'_>) -> Option<CompletionItem> {
        let index = facts.first;
        let object = scaffold::object(self.device, index).filter(is_whole)?;
        let label = format!("[{index:X}] {}", facts.name);
        let item = self.objects(&label, [(index, object)], &[], CompletionItemKind::CLASS)?;
        Some(documented(self.device, document, index, item))
    }

    /// The next PDO of a direction, with the objects that no PDO of the direction carries, as many as a frame has room for.
    fn pdo(&self, kind: PdoKind) -> Option<CompletionItem> {
        let device = self.device;
        let number = (1..=PdoKind::MAX).find(|number| {
            let indexes = [kind.communication_index(*number), kind.mapping_index(*number)];
            indexes.into_iter().flatten().all(|index| device.object(index).is_none())
        })?;
        let carried: Vec<MappedObject> = device
            .pdos()
            .filter(|pdo| pdo.kind == kind)
            .flat_map(|pdo| pdo.slots)
            .filter_map(|slot| slot.object)
            .collect();
        let mut room = FRAME;
        let mapped: Vec<MappedObject> = mappable(device, kind)
            .filter(|mapped| !carried.contains(mapped))
            .take_while(|mapped| {
                let left = room.checked_sub(mapped.bits.into());
                room = left.unwrap_or(room);
                left.is_some()
            })
            .collect();
        let names = mapped.iter().filter_map(|mapped| words::name(device, mapped.index, Some(mapped.sub)));
        let names = names.collect::<Vec<_>>().join(", ");
        let objects = scaffold::pdo(device, kind, number, mapped)?;
        let label = format!("[{:X}] {} {number} with its mapping", objects[0].0, kind.name());
        let detail = if names.is_empty() { "nothing is mapped".to_owned() } else { names };
        let item = self.objects(&label, objects, &[], CompletionItemKind::CLASS)?;
        Some(CompletionItem { detail: Some(detail), ..item })
    }

    /// The next object that the vendor defines, of each object type.
    fn of_vendor(&self) -> Vec<CompletionItem> {
        let is_of_vendor = |index: &u16| ObjectList::of(*index) == Some(ObjectList::Manufacturer);
        let last = self.device.objects.keys().copied().filter(is_of_vendor).max();
        let index = last.and_then(|last| last.checked_add(1)).unwrap_or(FIRST_OF_VENDOR);
        if !is_of_vendor(&index) {
            return Vec::new();
        }
        let data_type = format!("0x{:04X}", OF_VALUES.0);
        let kinds: [(ObjectType, &str, &[&str]); 3] = [
            (ObjectType::Record, "two parameters", &["Record", "Entry 1", "Entry 2"]),
            (ObjectType::Array, "two values that a TPDO can carry", &["Array", &data_type]),
            (ObjectType::Var, "a value that a TPDO can carry", &["Value", &data_type]),
        ];
        let item = |(kind, detail, blanks): (ObjectType, &str, &[&str])| {
            let name = format!("{kind}");
            let label = format!("[{index:X}] new {name} of the vendor");
            let item =
                self.objects(&label, [(index, of_vendor(kind))], blanks, CompletionItemKind::STRUCT)?;
            Some(CompletionItem { detail: Some(detail.to_owned()), ..item })
        };
        kinds.into_iter().filter_map(item).collect()
    }

    /// An item that writes the sections of objects, and their lines in the lists when it is resolved.
    fn objects<const COUNT: usize>(
        &self,
        label: &str,
        objects: [(u16, Object); COUNT],
        blanks: &[&str],
        kind: CompletionItemKind,
    ) -> Option<CompletionItem> {
        let indexes = objects.iter().map(|(index, _)| *index).collect();
        let text = sections_of(objects, self.line_end)?;
        let wanted = WantedItem { uri: self.file.uri.clone(), indexes, grown: None };
        let item = self.written(label, text, blanks, kind);
        Some(CompletionItem { data: serde_json::to_value(wanted).ok(), ..item })
    }

    /// An item that writes a text, in which the user fills in these words.
    fn written(
        &self,
        label: &str,
        text: String,
        blanks: &[&str],
        kind: CompletionItemKind,
    ) -> CompletionItem {
        let is_snippet = self.expands_snippets && !blanks.is_empty();
        let text = if is_snippet { snippet(&text, blanks) } else { text };
        CompletionItem {
            filter_text: Some(label.to_owned()),
            insert_text_format: is_snippet.then_some(SNIPPET),
            ..item(self.file, self.line, label, text, kind)
        }
    }
}

/// A text as a snippet: the first value that is or begins with a word is filled in, and the others follow it.
fn snippet(text: &str, words: &[&str]) -> String {
    let escaped = text.replace('\\', "\\\\").replace('$', "\\$").replace('}', "\\}");
    let mut is_filled = vec![false; words.len()];
    let line = |line: &str| {
        let Some((key, value)) = line.split_once('=') else { return line.to_owned() };
        let begins = |word: &&str| {
            let rest = value.strip_prefix(*word)?;
            let is_number =
                rest.strip_prefix(' ').is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
            (rest.trim_end().is_empty() || rest.starts_with(',') || is_number).then_some(rest)
        };
        let found = words.iter().enumerate().find_map(|(at, word)| Some((at, *word, begins(word)?)));
        let Some((at, word, rest)) = found else { return line.to_owned() };
        let number = at + 1;
        match std::mem::replace(&mut is_filled[at], true) {
            true => format!("{key}=${{{number}}}{rest}"),
            false => format!("{key}=${{{number}:{word}}}{rest}"),
        }
    };
    let lines: String = escaped.split_inclusive('\n').map(line).collect();
    lines + "$0"
}

/// The data type of new values.
const OF_VALUES: DataType = DataType::UNSIGNED16;

/// A new object of the vendor: parameters in a record, else values of the process.
fn of_vendor(object_type: ObjectType) -> Object {
    let is_record = object_type == ObjectType::Record;
    let (access, mapping) = match is_record {
        true => (Access::Rw, PdoMapping::No),
        false => (Access::Ro, PdoMapping::Optional),
    };
    let entry = |name: String| Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(OF_VALUES),
        access: Some(access),
        pdo_mapping: Some(mapping),
        default: Value::from_integer(0, OF_VALUES),
        ..Entry::default()
    };
    if !object_type.has_subs() {
        return Object { main: entry("Value".to_owned()), ..Object::default() };
    }
    let highest = Entry {
        data_type: Some(DataType::UNSIGNED8),
        access: Some(Access::Const),
        pdo_mapping: Some(PdoMapping::No),
        default: Value::from_integer(2, DataType::UNSIGNED8),
        ..entry("Highest sub-index supported".to_owned())
    };
    let (name, element) = if is_record { ("Record", "Entry") } else { ("Array", "Array") };
    let elements = (1..=2_u8).map(|sub| (sub, entry(format!("{element} {sub}"))));
    let main = Entry { name: name.into(), object_type: Some(object_type), ..Entry::default() };
    let subs = std::iter::once((0, highest)).chain(elements).collect();
    Object { main, subs, sub_number: Some(3), ..Object::default() }
}

/// Adds the lines of the object lists to an item that adds objects, and the number of PDOs or sub-indexes.
pub(super) fn resolve(file: &CheckedFile, wanted: &WantedItem) -> Option<Vec<TextEdit>> {
    let description = file.description()?;
    let device = description.device();
    let mut fix = Fix::risky("list the object");
    let grown = wanted.grown.and_then(|index| edits::new_sub_index(device, index));
    let is_elsewhere = |change: &Change| !matches!(change, Change::Add(..));
    fix.changes.extend(grown.into_iter().flat_map(|grown| grown.changes).filter(is_elsewhere));
    for list in ObjectList::ALL {
        let mut members = device.lists.get(list).to_vec();
        let is_new = |index: &&u16| ObjectList::of(**index) == Some(list) && !device.lists.contains(**index);
        let new: Vec<u16> = wanted.indexes.iter().filter(is_new).copied().collect();
        for &index in &new {
            members.insert(members.partition_point(|&member| member < index), index);
        }
        if !new.is_empty() {
            fix = fix.with(Change::List(list, members));
        }
    }
    let kinds = wanted.indexes.iter().filter_map(|index| PdoKind::of_communication(*index));
    for (kind, number) in kinds {
        let field = match kind {
            PdoKind::Rpdo => Field::NrOfRxPdo,
            PdoKind::Tpdo => Field::NrOfTxPdo,
        };
        let is_known = device.pdos().any(|pdo| (pdo.kind, pdo.number) == (kind, number));
        let count = device.pdo_count(kind) + usize::from(!is_known);
        if device.device_info.is_some() {
            fix = fix.set(Place::of(Part::DeviceInfo).field(field), count.to_string());
        }
    }
    // multiplexed PDOs
    if wanted.indexes.iter().any(|index| (0x1FA0..=0x1FFF).contains(index)) && device.device_info.is_some() {
        fix = fix.set(Place::of(Part::DeviceInfo).field(Field::GroupMessaging), "1".to_owned());
    }
    Some(file.edits(description.edits(&fix)?))
}

/// The sections of objects.
fn sections_of<const COUNT: usize>(objects: [(u16, Object); COUNT], line_end: &str) -> Option<String> {
    let device = Device { objects: objects.into_iter().collect(), ..Device::default() };
    Some(added(&additions(&Device::default(), &device)?, line_end))
}

/// The sections that changes add.
fn added(changes: &[Change], line_end: &str) -> String {
    let sections = changes.iter().filter_map(|change| match change {
        Change::Add(part, fields) => {
            let lines = fields.iter().map(|(field, value)| format!("{}={value}{line_end}", field.name()));
            Some(format!("[{}]{line_end}{}", section_name(part), lines.collect::<String>()))
        }
        _ => None,
    });
    let sections: Vec<String> = sections.collect();
    sections.join(line_end)
}

//! Converts a project to a device.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::expression::{self, Evaluated};
use super::mapping::{DescribedObject, DescriptionForm, ObjectMapping, SubForm};
use super::pickle::{Pickle, PickleDatum, plain_number};
use super::{NOT_READ, UNKNOWN_OBJECT};
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::literal::{self, Quirks};
use objdict_model::model::{
    Commissioning, DataType, Device, DeviceInfo, Entry, Extra, ExtraSection, Field, FileInfo, Label,
    OBJDICTGEN_SECTION, Object, ObjectLists, ObjectType, PdoMapping, Reason, Subs, TypeKind, Value,
};
use objdict_xdd::xml::Element;

/// The default size of a string.
const TEXT_SIZE: u32 = 10;

/// The first index of an object; lower ones are types.
const FIRST_OBJECT: u16 = 0x1000;

/// The error history: its count is 0, even if the project has space for errors.
const ERRORS: u16 = 0x1003;

/// Longer names are not valid (CiA 306-1).
const LONGEST_NAME: usize = 241;

/// Advice for an unreadable part.
const REMEDY: &str = "open the project with objdictedit, correct or remove this part and save it";

/// The storage group of values that objdictgen marks with `TO_BE_SAVE`.
const SAVED: &str = "saved";

/// A type of the device: a CiA 301 type with limits, or with a length.
struct UserType<'a> {
    base: DataType,
    /// The limits of a number, or the length of a string.
    facts: Vec<Cow<'a, str>>,
}

/// The properties of an object or entry in a project, except its value.
#[derive(Default)]
struct ObjectParameters<'a> {
    comment: Option<Cow<'a, str>>,
    saved: bool,
    callback: Option<bool>,
    size: Option<i64>,
    /// The properties of the entries.
    subs: BTreeMap<u16, Element<'a>>,
}

/// The parts of a project.
pub(super) struct ObjdictgenProject<'a> {
    pickle: &'a Pickle<'a>,
    mappings: Vec<ObjectMapping<'a>>,
    types: BTreeMap<u16, UserType<'a>>,
    parameters: BTreeMap<u16, Element<'a>>,
    text_size: u32,
    node_id: u8,
    /// How many entries are still read: an element that others refer to can be many.
    room: usize,
    device: Device,
    findings: Findings,
}

/// The device of a project whose tree has this many elements.
pub(super) fn read<'a>(pickle: &'a Pickle<'a>, elements: usize) -> (Device, Findings) {
    let mut project = ObjdictgenProject {
        pickle,
        mappings: Vec::new(),
        types: BTreeMap::new(),
        parameters: BTreeMap::new(),
        text_size: TEXT_SIZE,
        node_id: 0,
        room: elements,
        device: Device::default(),
        findings: Findings::new(),
    };
    project.read();
    (project.device, project.findings)
}

impl<'a> ObjdictgenProject<'a> {
    fn read(&mut self) {
        let mut node = Commissioning::default();
        let mut extra = Extra::default();
        let mut info = FileInfo::default();
        let mut dictionary = None;
        let mut maps: [Option<Element<'a>>; 3] = [None; 3];
        for (name, element) in self.pickle.attributes() {
            let datum = self.pickle.datum(element);
            match (&*name, datum) {
                ("Name", Some(PickleDatum::Text(text))) => node.node_name = Some(text.into_owned()),
                ("Type", Some(PickleDatum::Text(text))) => {
                    node.manager = Some(text == "master");
                    extra.push("Type", &text);
                }
                ("ID", Some(PickleDatum::Number(text))) => {
                    self.node_id = plain_number(&text).parse().unwrap_or(0);
                    node.node_id = Some(self.node_id).filter(|id| (1..=127).contains(id));
                }
                ("Description", Some(PickleDatum::Text(text))) => {
                    info.description = Some(text.into_owned()).filter(|text| !text.is_empty());
                }
                ("DefaultStringSize", Some(PickleDatum::Number(text))) => {
                    self.text_size = plain_number(&text).parse().unwrap_or(TEXT_SIZE);
                }
                ("Dictionary", Some(PickleDatum::Map(map))) => dictionary = Some(map),
                ("ParamsDictionary", Some(PickleDatum::Map(map))) => {
                    self.parameters = self.pickle.numbered(map).collect();
                }
                ("Profile", Some(PickleDatum::Map(map))) => maps[0] = Some(map),
                ("DS302", Some(PickleDatum::Map(map))) => maps[1] = Some(map),
                ("UserMapping", Some(PickleDatum::Map(map))) => maps[2] = Some(map),
                ("ProfileName", Some(PickleDatum::Text(text))) => extra.push("Profile", &text),
                // belongs to the editor, or is the order of objects in it
                ("SpecificMenu" | "IndexOrder", _) => {}
                (_, Some(PickleDatum::Text(text) | PickleDatum::Number(text))) => extra.push(&name, &text),
                (_, Some(PickleDatum::Nothing)) => {}
                (_, _) => self.not_read(element),
            }
        }
        self.mappings = maps.into_iter().flatten().map(|map| ObjectMapping::read(self.pickle, map)).collect();
        self.mappings.push(ObjectMapping::of_cia301());
        let product_name = node.node_name.clone();
        self.device.device_info = Some(DeviceInfo { product_name, ..DeviceInfo::default() });
        self.device.file_info = Some(info);
        // without a node-ID the project describes a device type
        self.device.commissioning = Some(node).filter(|node| node.node_id.is_some());
        if let Some(dictionary) = dictionary {
            self.types(dictionary, &mut extra);
            self.objects(dictionary);
        }
        self.device.extra.push(ExtraSection::new(OBJDICTGEN_SECTION, &extra));
        self.device.lists = ObjectLists::naming(self.device.objects.keys().copied());
    }

    fn not_read(&mut self, element: Element<'a>) {
        let message = say!("this part of the project cannot be read");
        self.findings.push(Diagnostic::new(&NOT_READ, element.tag_span(), message).help(REMEDY));
    }

    /// The types of the device, to which its objects refer.
    fn types(&mut self, dictionary: Element<'a>, extra: &mut Extra) {
        for (index, value) in self.pickle.numbered(dictionary).filter(|(index, _)| *index < FIRST_OBJECT) {
            let items = match self.pickle.datum(value) {
                Some(PickleDatum::List(list)) => list.children_named("item").take(4).collect(),
                _ => Vec::new(),
            };
            let facts: Option<Vec<_>> = items
                .into_iter()
                .map(|item| match self.pickle.datum(item)? {
                    PickleDatum::Number(text) => Some(text),
                    _ => None,
                })
                .collect();
            let base =
                facts.as_ref().and_then(|facts| plain_number(facts.first()?).parse().ok()).map(DataType);
            let (Some(mut facts), Some(base)) = (facts, base) else {
                self.not_read(value);
                continue;
            };
            facts.remove(0);
            let stated = [base.to_string()].into_iter().chain(facts.iter().map(ToString::to_string));
            extra.push(&format!("Type{index:04X}"), &stated.collect::<Vec<_>>().join(" "));
            self.types.insert(index, UserType { base, facts });
        }
    }

    fn objects(&mut self, dictionary: Element<'a>) {
        let mut entries: BTreeMap<u16, Element<'a>> = BTreeMap::new();
        for (index, value) in self.pickle.numbered(dictionary).filter(|(index, _)| *index >= FIRST_OBJECT) {
            entries.insert(index, value);
        }
        let mappings = std::mem::take(&mut self.mappings);
        for (index, value) in entries {
            let Some(described) = DescribedObject::new(&mappings, index) else {
                let message = say!("no part of the project defines object {:04X}h", index);
                self.findings.push(Diagnostic::new(&UNKNOWN_OBJECT, value.tag_span(), message).help(REMEDY));
                continue;
            };
            if let Some(object) = self.object(index, &described, value) {
                self.device.objects.insert(index, object);
            } else {
                self.not_read(value);
            }
        }
    }

    /// An object; `None` if its value has an unknown structure, or there are too many.
    fn object(
        &mut self,
        index: u16,
        described: &DescribedObject<'_, 'a>,
        value: Element<'a>,
    ) -> Option<Object> {
        let number = described.number();
        let parameters = self.parameters.get(&index).map(|map| self.parameters_of(*map)).unwrap_or_default();
        let name = described.fact(|form| form.name.clone()).unwrap_or_default();
        let name = self.name(&name, number, 0, value);
        let callback = described.fact(|form| form.callback).or(parameters.callback);
        let items: Vec<Element<'a>> = match self.pickle.datum(value)? {
            PickleDatum::List(list) => list.children_named("item").take(255).collect(),
            PickleDatum::Map(_) => return None,
            single => {
                self.room = self.room.checked_sub(1)?;
                let form = described.sub(0);
                let mut main = self.entry(0, number, &form, Some(single), value);
                if main.name != name {
                    main.extra.push("ObjectName", &name);
                }
                let is_domain = main.data_type == Some(DataType::DOMAIN);
                main.object_type = Some(if is_domain { ObjectType::Domain } else { ObjectType::Var });
                self.annotate(&mut main, &parameters);
                set_callback(&mut main, callback);
                return Some(Object { main, ..Object::default() });
            }
        };
        if items.len() > 254 {
            return None;
        }
        self.room = self.room.checked_sub(items.len() + 1)?;
        let is_array = described.fact(DescriptionForm::is_array) == Some(true);
        let object_type = Some(if is_array { ObjectType::Array } else { ObjectType::Record });
        let mut main = Entry { name, object_type, ..Entry::default() };
        set_callback(&mut main, callback);
        let subs = self.subs(index, described, &items, &parameters);
        if subs.iter().any(|(_, entry)| is_saved(entry)) {
            main.stack_mut().storage_group = Some(SAVED.into());
        }
        if let Some(comment) = &parameters.comment {
            set_comment(&mut main, comment);
        }
        Some(Object { main, subs, ..Object::default() })
    }

    /// The entries of an object: the count, and one entry per item.
    fn subs(
        &mut self,
        index: u16,
        described: &DescribedObject<'_, 'a>,
        items: &[Element<'a>],
        parameters: &ObjectParameters<'a>,
    ) -> Subs {
        let number = described.number();
        let count = if index == ERRORS { 0 } else { items.len() as u64 };
        let all = (0..=254).zip([None].into_iter().chain(items.iter().copied().map(Some)));
        let mut subs = Subs::default();
        for (sub, item) in all {
            let form = described.sub(sub);
            let datum = item.and_then(|item| self.pickle.datum(item));
            let at = item.or(items.first().copied());
            let mut entry = match at {
                Some(at) => self.entry(sub, number, &form, datum, at),
                None => Entry::default(),
            };
            if sub == 0 {
                entry.default = Some(Value::Unsigned(count));
                entry.data_type = entry.data_type.or(Some(DataType::UNSIGNED8));
            }
            let own = parameters.subs.get(&u16::from(sub)).map(|map| self.parameters_of(*map));
            self.annotate(&mut entry, &own.unwrap_or_default());
            subs.insert(sub, entry);
        }
        subs
    }

    /// An entry with its value, if it has one, from an element.
    fn entry(
        &mut self,
        sub: u8,
        number: i64,
        form: &SubForm<'a>,
        datum: Option<PickleDatum<'a>>,
        at: Element<'a>,
    ) -> Entry {
        let name = self.name(form.name.as_deref().unwrap_or_default(), number, sub, at);
        let mut entry = Entry { name, access: form.access, ..Entry::default() };
        entry.pdo_mapping = Some(match form.mappable {
            Some(true) => PdoMapping::Optional,
            _ => PdoMapping::No,
        });
        entry.data_type = form.data_type;
        if let Some(user) = form.data_type.and_then(|data_type| self.types.get(&data_type.0)) {
            entry.data_type = Some(user.base);
            user.limit(&mut entry);
        }
        let data_type = entry.data_type;
        if data_type.is_some_and(is_text) {
            let size = entry.stack.as_ref().and_then(|stack| stack.min_string_length).unwrap_or(0);
            entry.stack_mut().min_string_length = Some(size.max(self.text_size));
        }
        match datum.and_then(|datum| spelled(datum, number)) {
            None => {}
            Some(spelled) => match value(&spelled, data_type) {
                Ok(value) => entry.default = value,
                Err((text, reason)) => entry.invalid_values.push(Field::DefaultValue, &text, reason),
            },
        }
        entry
    }

    fn name(&mut self, text: &str, number: i64, sub: u8, at: Element<'a>) -> Box<str> {
        let name = expression::name(text, number + 1, sub.into());
        match name.char_indices().nth(LONGEST_NAME) {
            None => name.into(),
            Some((end, _)) => {
                let message =
                    say!("a name has more than {} characters and is truncated", LONGEST_NAME as u64);
                self.findings.push(Diagnostic::new(&NOT_READ, at.tag_span(), message).help(REMEDY));
                name[..end].into()
            }
        }
    }

    fn parameters_of(&self, map: Element<'a>) -> ObjectParameters<'a> {
        let mut parameters = ObjectParameters::default();
        let Some(PickleDatum::Map(map)) = self.pickle.datum(map) else { return parameters };
        for (key, value) in self.pickle.entries(map) {
            match key {
                PickleDatum::Number(key) => {
                    let sub = plain_number(&key).parse().ok();
                    parameters.subs.extend(sub.map(|sub: u16| (sub, value)));
                }
                PickleDatum::Text(key) => match &*key {
                    "comment" => parameters.comment = self.pickle.text(value).filter(|text| !text.is_empty()),
                    "save" => parameters.saved = self.pickle.flag(value) == Some(true),
                    "callback" => parameters.callback = self.pickle.flag(value),
                    "buffer_size" => parameters.size = self.pickle.number(value),
                    _ => {}
                },
                _ => {}
            }
        }
        parameters
    }

    fn annotate(&self, entry: &mut Entry, parameters: &ObjectParameters<'a>) {
        if parameters.saved {
            entry.stack_mut().storage_group = Some(SAVED.into());
        }
        let size = parameters.size.and_then(|size| u32::try_from(size).ok()).filter(|&size| size > 0);
        if let Some(size) = size {
            entry.stack_mut().min_string_length = Some(size);
        }
        if let Some(comment) = &parameters.comment {
            set_comment(entry, comment);
        }
    }
}

impl UserType<'_> {
    /// The limits of an entry of this type, or its length.
    fn limit(&self, entry: &mut Entry) {
        match (&self.facts[..], is_text(self.base)) {
            ([length], true) => entry.stack_mut().min_string_length = plain_number(length).parse().ok(),
            ([low, high], false) => {
                for (field, text, slot) in [
                    (Field::LowLimit, low, &mut entry.low_limit),
                    (Field::HighLimit, high, &mut entry.high_limit),
                ] {
                    let text = plain_number(text);
                    match literal::value(text, Some(self.base), &mut Quirks::default()) {
                        Ok(value) => *slot = Some(value),
                        Err(reason) => entry.invalid_values.push(field, text, reason),
                    }
                }
            }
            _ => {}
        }
    }
}

/// Whether a type is a string or bytes whose size a project states.
fn is_text(data_type: DataType) -> bool {
    matches!(data_type.kind(), TypeKind::VisibleString | TypeKind::OctetString | TypeKind::UnicodeString)
}

fn is_saved(entry: &Entry) -> bool {
    entry.stack.as_ref().is_some_and(|stack| stack.storage_group.is_some())
}

fn set_callback(entry: &mut Entry, callback: Option<bool>) {
    if callback == Some(true) {
        entry.stack_mut().io_extension = Some(true);
    }
}

fn set_comment(entry: &mut Entry, comment: &str) {
    let label = Label::Description { lang: "en".into(), text: comment.into(), uri: None };
    entry.parameter_mut().labels.0.push(label);
}

/// A value as the project spells it.
enum Spelled<'a> {
    Number(Cow<'a, str>),
    Text(Cow<'a, str>),
}

/// The spelling of a value, with its expression evaluated for an object of a series; `None` without a value.
fn spelled(datum: PickleDatum<'_>, number: i64) -> Option<Spelled<'_>> {
    Some(match datum {
        PickleDatum::Number(text) => Spelled::Number(text),
        PickleDatum::Bool(value) => Spelled::Number(if value { "1" } else { "0" }.into()),
        PickleDatum::Text(text) if text.to_ascii_uppercase().contains("$NODEID") => {
            match expression::evaluate(&text, &[("base", number)]) {
                Some(Evaluated::Number(number)) => Spelled::Number(number.to_string().into()),
                Some(Evaluated::Text(text)) => Spelled::Text(text.into()),
                _ => Spelled::Text(text),
            }
        }
        PickleDatum::Text(text) => Spelled::Text(text),
        PickleDatum::Nothing | PickleDatum::List(_) | PickleDatum::Map(_) => return None,
    })
}

/// The value of a type; `Ok(None)` for a number given as an empty string.
fn value(spelled: &Spelled<'_>, data_type: Option<DataType>) -> Result<Option<Value>, (String, Reason)> {
    let kind = data_type.map(DataType::kind);
    let text = match (spelled, kind) {
        (Spelled::Text(text), Some(TypeKind::VisibleString | TypeKind::UnicodeString)) => {
            return Ok(Some(Value::Text((&**text).into())));
        }
        (Spelled::Text(text), Some(TypeKind::OctetString)) => {
            return Ok(Some(Value::Bytes(text.as_bytes().into())));
        }
        (Spelled::Text(text), Some(TypeKind::Domain)) => {
            // each character is a byte
            let bytes: Option<Vec<u8>> = text.chars().map(|c| u8::try_from(u32::from(c)).ok()).collect();
            return match bytes {
                Some(bytes) => Ok(Some(Value::Bytes(bytes.into()))),
                None => Err((text.clone().into_owned(), Reason::NotHexBytes)),
            };
        }
        (Spelled::Text(text), _) => text.trim(),
        (Spelled::Number(text), Some(TypeKind::VisibleString | TypeKind::UnicodeString)) => {
            return Err((text.clone().into_owned(), Reason::Malformed));
        }
        (Spelled::Number(text), _) => plain_number(text),
    };
    if text.is_empty() {
        return Ok(None);
    }
    let value = literal::value(text, data_type, &mut Quirks::default());
    value.map(Some).map_err(|reason| (text.to_owned(), reason))
}

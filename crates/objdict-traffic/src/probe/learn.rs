//! The description of an unknown device, of what it answered.

use std::collections::BTreeMap;

use crate::probe::{Exchange, SdoAnswer, SdoRequest};
use objdict_bus::Abort;
use objdict_format::scaffold::base::documents;
use objdict_format::scaffold::demanded::Demanded;
use objdict_format::scaffold::objects::ObjectMaker;
use objdict_format::scaffold::{Features, Wanted, device_info, file_info, newest_version};
use objdict_model::model::{
    Access, ClockTime, DataType, Date, Device, DummyUsage, Entry, Object, ObjectLists, ObjectType,
    PdoMapping, TypeKind, Value,
};

/// What is known of an entry.
#[derive(Debug, Default)]
struct SeenEntry<'a> {
    answer: Option<&'a SdoAnswer>,
    /// Whether a write was accepted.
    is_writable: bool,
    /// Whether reading is refused because the entry is write-only.
    is_write_only: bool,
}

/// The entries that answered.
type AnsweredEntries<'a> = BTreeMap<u16, BTreeMap<u8, SeenEntry<'a>>>;

/// The description of a device that gave these answers; `None` if there is no entry among them. Names, types and access are those of CiA 301 and the
/// profile of its device type (1000h) where they fit the answers. Of other entries the type is the unsigned integer of the size, or a
/// text, and the access is read-only unless a write was accepted.
pub fn learn(
    exchanges: &[Exchange],
    node_id: Option<u8>,
    file_name: &str,
    date: Date,
    time: ClockTime,
) -> Option<Device> {
    let seen = seen(exchanges);
    if seen.is_empty() {
        return None;
    }
    let number = |index, sub| number_of(&seen, index, sub);
    let profile = number(0x1000, 0).and_then(|device_type| u16::try_from(device_type & 0xFFFF).ok());
    let profile = profile.filter(|profile| newest_version(*profile).is_some()).unwrap_or(301);
    let documents = documents(profile);
    let maker = ObjectMaker { plan: Demanded::new(profile, &Features::default()), documents: &documents };
    let mut device = Device::default();
    for (&index, entries) in &seen {
        let object = Learner { maker: &maker, node_id, index }.object(entries);
        device.objects.insert(index, object);
    }
    allow_mapping(&mut device);
    // every device has them, whether it was asked or not
    for index in [0x1000, 0x1001, 0x1018] {
        if !device.objects.contains_key(&index) {
            maker.add(&mut device, index);
        }
    }
    let name = text_of(&seen, 0x1008).unwrap_or_else(|| "Unknown device".to_owned());
    let wanted = Wanted {
        profile,
        features: Features::default(),
        file_name: file_name.to_owned(),
        vendor_name: String::new(),
        vendor_id: number(0x1018, 1).unwrap_or(0),
        product_name: name,
        product_code: number(0x1018, 2).unwrap_or(0),
        revision: number(0x1018, 3).unwrap_or(0),
        author: "objdict".to_owned(),
        date,
        time,
    };
    device.dummy_usage = Some(DummyUsage::default());
    device.comments = Some(Vec::new());
    device.lists = ObjectLists::naming(device.objects.keys().copied());
    device.file_info = Some(file_info(&wanted));
    let mut info = device_info(&maker.plan, &device);
    info.vendor_name = Some(format!("Vendor {:08X}h", wanted.vendor_id));
    info.product_name = Some(wanted.product_name);
    info.vendor_number = Some(wanted.vendor_id);
    info.product_number = Some(wanted.product_code);
    info.revision_number = Some(wanted.revision);
    device.device_info = Some(info);
    Some(device)
}

/// What PDOs carry can be mapped, what an RPDO carries can be written by it, and one bit is a BOOLEAN.
fn allow_mapping(device: &mut Device) {
    let mappings =
        device.objects.iter().filter(|(index, _)| matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF));
    let mut mapped = Vec::new();
    for (&index, object) in mappings {
        let values = object.entries().filter(|(sub, _)| *sub > 0);
        let values = values.filter_map(|(_, entry)| u32::try_from(entry.value()?.as_integer()?).ok());
        mapped.extend(values.map(|value| (index < 0x1A00, value.to_be_bytes())));
    }
    for (is_received, [high, low, sub, bits]) in mapped {
        let Some(object) = device.objects.get_mut(&u16::from_be_bytes([high, low])) else { continue };
        if object.subs.is_empty() {
            allow(&mut object.main, is_received, bits);
        }
        // the elements of an array have one access
        let is_array = object.main.object_type == Some(ObjectType::Array);
        let is_meant = |number: u8| number == sub || is_array && number > 0;
        for (_, entry) in object.subs.iter_mut().filter(|(number, _)| is_meant(*number)) {
            allow(entry, is_received, bits);
        }
    }
}

/// Allows a PDO to carry so many bits of an entry.
fn allow(entry: &mut Entry, is_received: bool, bits: u8) {
    entry.pdo_mapping = Some(PdoMapping::Optional);
    let fits = |access: Access| if is_received { access.fits_rpdo() } else { access.fits_tpdo() };
    if !entry.access.is_some_and(fits) {
        entry.access = Some(if is_received { Access::Rww } else { Access::Rwr });
    }
    let number = entry.default.as_ref().and_then(Value::as_integer).filter(|number| (0..=1).contains(number));
    if let (1, Some(number), Some(DataType::UNSIGNED8)) = (bits, number, entry.data_type) {
        entry.data_type = Some(DataType::BOOLEAN);
        entry.default = Value::from_integer(number, DataType::BOOLEAN);
    }
}

fn seen(exchanges: &[Exchange]) -> AnsweredEntries<'_> {
    let mut seen = AnsweredEntries::new();
    for Exchange { index, sub, request, answer, .. } in exchanges {
        let is_write_only = *request == SdoRequest::Upload && *answer == SdoAnswer::Abort(Abort::WriteOnly);
        let is_written = *answer == SdoAnswer::Done;
        // an entry without a value at present
        let is_empty = matches!(answer, SdoAnswer::Abort(Abort::NoData | Abort::NoSdoConnection));
        if *index < 0x1000 || !(answer.is_value() || is_written || is_write_only || is_empty) {
            continue;
        }
        let entry = seen.entry(*index).or_default().entry(*sub).or_default();
        entry.is_writable |= is_written || is_write_only;
        entry.is_write_only |= is_write_only;
        // the first value is the one before anything was written
        if answer.is_value() {
            entry.answer.get_or_insert(answer);
        }
    }
    seen
}

fn number_of(seen: &AnsweredEntries<'_>, index: u16, sub: u8) -> Option<u32> {
    let bytes = seen.get(&index)?.get(&sub)?.answer?.bytes(Some(DataType::UNSIGNED32))?;
    bytes.try_into().ok().map(u32::from_le_bytes)
}

fn text_of(seen: &AnsweredEntries<'_>, index: u16) -> Option<String> {
    let bytes = seen.get(&index)?.get(&0)?.answer?.bytes(Some(DataType::VISIBLE_STRING))?;
    is_text(&bytes).then(|| String::from_utf8_lossy(&bytes).trim_end_matches('\0').to_owned())
}

/// Makes one object.
struct Learner<'a> {
    maker: &'a ObjectMaker<'a>,
    node_id: Option<u8>,
    index: u16,
}

impl Learner<'_> {
    fn object(&self, entries: &BTreeMap<u8, SeenEntry<'_>>) -> Object {
        let known = self.maker.described(self.index);
        let mut object = Object::default();
        let name = known
            .as_ref()
            .map_or_else(|| format!("Object {:04X}h", self.index), |known| known.name().to_owned());
        let has_subs = match &known {
            Some(known) => known.object_type().has_subs(),
            None => entries.keys().any(|sub| *sub > 0),
        };
        if !has_subs && entries.len() == 1 && entries.contains_key(&0) {
            object.main = Entry { name: name.as_str().into(), ..self.entry(0, &entries[&0], name.clone()) };
            return object;
        }
        let mut entries: BTreeMap<u8, Entry> = entries
            .iter()
            .map(|(sub, seen)| (*sub, self.entry(*sub, seen, format!("Sub-index {sub}"))))
            .collect();
        // an array or record without its number of entries is not one
        let highest = entries.keys().next_back().copied().unwrap_or(0);
        entries.entry(0).or_insert_with(|| Entry {
            default: Some(Value::Unsigned(highest.into())),
            ..plain(0, "Highest sub-index supported".to_owned(), DataType::UNSIGNED8)
        });
        let mut types = entries.iter().filter(|(sub, _)| **sub > 0).map(|(_, entry)| entry.data_type);
        let first = types.next().flatten();
        let is_array = match &known {
            Some(known) if known.object_type().has_subs() => known.object_type() == ObjectType::Array,
            _ => types.all(|other| other == first),
        };
        object.main.name = name.into();
        object.main.object_type = Some(if is_array { ObjectType::Array } else { ObjectType::Record });
        object.sub_number = u8::try_from(entries.len()).ok();
        object.subs = entries.into_iter().collect();
        object
    }

    fn entry(&self, sub: u8, seen: &SeenEntry<'_>, name: String) -> Entry {
        let known = self.maker.knows(self.index, sub).then(|| self.maker.entry(self.index, sub));
        let known_type = known.as_ref().and_then(|known| known.data_type);
        let data_type = match (known_type, seen.answer) {
            (Some(known), Some(answer)) if fits(known, answer) => known,
            (_, Some(answer)) => guessed(answer),
            (known, None) => known.unwrap_or(DataType::DOMAIN),
        };
        let is_known = known_type == Some(data_type);
        let mut entry = match known.filter(|_| is_known) {
            Some(known) => Entry { default: None, ..known },
            None => plain(sub, name, data_type),
        };
        entry.access = match (seen.is_write_only, seen.is_writable, entry.access.filter(|_| is_known)) {
            (true, ..) => Some(Access::Wo),
            (_, true, Some(access)) if access.is_writable() => Some(access),
            (_, true, _) => Some(Access::Rw),
            (_, false, Some(access)) if access != Access::Wo => Some(access),
            _ => Some(Access::Ro),
        };
        let bytes = seen.answer.and_then(|answer| answer.bytes(Some(data_type)));
        let value = bytes.and_then(|bytes| Value::from_bytes(trimmed(&bytes, data_type), data_type));
        entry.default = value.map(|value| self.with_node_id(sub, value));
        entry
    }

    /// The COB-IDs of the predefined connection set follow the node-ID.
    fn with_node_id(&self, sub: u8, value: Value) -> Value {
        let is_cob_id = matches!(
            (self.index, sub),
            (0x1014, 0) | (0x1200, 1 | 2) | (0x1400..=0x1403 | 0x1800..=0x1803, 1)
        );
        match (self.node_id, value.as_integer()) {
            (Some(node_id), Some(number)) if is_cob_id && number & 0x7F == i128::from(node_id) => {
                u64::try_from(number - i128::from(node_id)).map_or(value, Value::NodeId)
            }
            _ => value,
        }
    }
}

fn plain(sub: u8, name: String, data_type: DataType) -> Entry {
    let name = if sub == 0 && name.starts_with("Sub-index") {
        "Highest sub-index supported".to_owned()
    } else {
        name
    };
    Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(Access::Ro),
        pdo_mapping: Some(PdoMapping::No),
        ..Entry::default()
    }
}

/// Whether an answer is a value of a type.
fn fits(data_type: DataType, answer: &SdoAnswer) -> bool {
    let length = match answer {
        SdoAnswer::Length(length) => *length,
        answer => match answer.bytes(Some(data_type)) {
            Some(bytes) => Some(bytes.len()),
            None => return false,
        },
    };
    let own = data_type.byte_length().map(usize::from);
    own.zip(length).is_none_or(|(own, length)| own == length)
}

/// The type of a value by its bytes: a text of more than four printable characters, else the unsigned integer of its size.
fn guessed(answer: &SdoAnswer) -> DataType {
    let bytes = answer.bytes(None).unwrap_or_default();
    let length = if let SdoAnswer::Length(Some(length)) = answer { *length } else { bytes.len() };
    if length == 0 || (length > 4 && is_text(&bytes)) {
        return DataType::VISIBLE_STRING;
    }
    DataType::unsigned(length).unwrap_or(DataType::OCTET_STRING)
}

fn is_text(bytes: &[u8]) -> bool {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    end > 0
        && bytes[..end].iter().all(|byte| matches!(byte, 0x20..=0x7E))
        && bytes[end..].iter().all(|&byte| byte == 0)
}

/// A text without the zeros behind it.
fn trimmed(bytes: &[u8], data_type: DataType) -> &[u8] {
    let is_text = data_type.kind() == TypeKind::VisibleString;
    let end = bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    if is_text { &bytes[..end] } else { bytes }
}

//! JSON projects of CANopenEditor: its message `CanOpenDevice` (`libEDSsharp/proto/CanOpen.proto`) in protobuf JSON.
//! CANopenEditor writes every field, including default values, and rejects files with unknown fields.

use std::fmt;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::json::JsonError;
use crate::scaffold::MIDNIGHT;
use crate::write::{Loss, Written, lost};
use crate::{EditError, complete};
use objdict_model::literal::{self, Quirks};
use objdict_model::model::{
    Access, BaudRates, ClockTime, Commissioning, DataType, Date, Device, DeviceInfo, Entry, Field, FileInfo,
    LANGUAGE, Labels, Object, ObjectLists, ObjectType, ParameterAccess, PdoMapping, Reason, SrdoAccess,
    Value, unique_keys,
};
use objdict_xdd::xdd;

/// Declares messages, whose fields have default values and are all written.
macro_rules! messages {
    ($($Name:ident { $($(#[$of_field:meta])* $field:ident: $Type:ty,)* })+) => {$(
        #[derive(Default, Serialize, Deserialize)]
        #[serde(default, rename_all = "camelCase", deny_unknown_fields)]
        struct $Name { $($(#[$of_field])* $field: $Type,)* }
    )+};
}

messages! {
    ProjectForm {
        file_info: FileForm,
        device_info: DeviceForm,
        device_commissioning: NodeForm,
        #[serde(serialize_with = "map", deserialize_with = "unique_keys::pairs")]
        objects: Vec<(FormKey<4>, ObjectForm)>,
    }
    FileForm {
        file_version: String, description: String, creation_time: String, created_by: String,
        modification_time: String, modified_by: String,
    }
    DeviceForm {
        vendor_name: String, product_name: String, baud_rate10: bool, baud_rate20: bool, baud_rate50: bool, baud_rate125: bool,
        baud_rate250: bool, baud_rate500: bool, baud_rate800: bool, baud_rate1000: bool, baud_rate_auto: bool,
        lss_slave: bool, lss_master: bool,
    }
    NodeForm { node_id: FormNumber<NODE_ID>, node_name: String, baudrate: FormNumber<BIT_RATE>, }
    ObjectForm {
        disabled: bool, name: String, alias: String, description: String, object_type: FormNumber<OBJECT_TYPE>,
        count_label: String, storage_group: String,
        #[serde(rename = "flagsPDO")]
        flags_pdo: bool,
        #[serde(serialize_with = "map", deserialize_with = "unique_keys::pairs")]
        sub_objects: Vec<(FormKey<2>, SubForm)>,
    }
    SubForm {
        name: String, alias: String, data_type: FormNumber<DATA_TYPE>, sdo: FormNumber<SDO>, pdo: FormNumber<PDO>, srdo: FormNumber<SRDO>,
        default_value: String, actual_value: String, low_limit: String, high_limit: String, string_length_min: FormNumber<LENGTH>,
    }
}

/// The number types: the maximum, and the names of an enumeration's values in order, `-` for none.
const NUMBERS: [(u32, &str); 8] = [
    (u32::MAX, ""),
    (0xFF, ""),
    (0xFFFF, ""),
    (
        0xFFFF,
        "UNSPECIFIED BOOLEAN INTEGER8 INTEGER16 INTEGER32 UNSIGNED8 UNSIGNED16 UNSIGNED32 REAL32 VISIBLE_STRING OCTET_STRING \
         UNICODE_STRING TIME_OF_DAY TIME_DIFFERENCE - DOMAIN INTEGER24 REAL64 INTEGER40 INTEGER48 INTEGER56 INTEGER64 UNSIGNED24 - \
         UNSIGNED40 UNSIGNED48 UNSIGNED56 UNSIGNED64",
    ),
    (9, "OBJECT_TYPE_UNSPECIFIED - - - - - - OBJECT_TYPE_VAR OBJECT_TYPE_ARRAY OBJECT_TYPE_RECORD"),
    (3, "ACCESS_SDO_NO ACCESS_SDO_RO ACCESS_SDO_WO ACCESS_SDO_RW"),
    (3, "ACCESS_PDO_NO ACCESS_PDO_T ACCESS_PDO_R ACCESS_PDO_TR"),
    (3, "ACCESS_SRDO_NO ACCESS_SRDO_TX ACCESS_SRDO_RX ACCESS_SRDO_TRX"),
];
const LENGTH: usize = 0;
const NODE_ID: usize = 1;
const BIT_RATE: usize = 2;
const DATA_TYPE: usize = 3;
const OBJECT_TYPE: usize = 4;
const SDO: usize = 5;
const PDO: usize = 6;
const SRDO: usize = 7;

/// A number of one of these types, which is read by name or number, and written by name if possible.
#[derive(Clone, Copy, Default)]
struct FormNumber<const KIND: usize>(u32);

impl<const KIND: usize> Serialize for FormNumber<KIND> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match NUMBERS[KIND].1.split_whitespace().nth(self.0 as usize).filter(|name| *name != "-") {
            Some(name) => serializer.serialize_str(name),
            None => serializer.serialize_u32(self.0),
        }
    }
}

impl<'de, const KIND: usize> Deserialize<'de> for FormNumber<KIND> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = serde_json::Value::deserialize(deserializer)?;
        let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
        let (most, names) = NUMBERS[KIND];
        let named = (0..).zip(names.split_whitespace()).find(|(_, name)| *name == text && text != "-");
        let number = named.map_or_else(|| text.parse().ok(), |(number, _)| Some(number));
        let wanted = || {
            let names =
                if names.is_empty() { "" } else { &format!(" or one of {}", names.replace(" -", "")) };
            format!("`{text}` is not a number up to {most}{names}")
        };
        number.filter(|number| *number <= most).map(Self).ok_or_else(|| D::Error::custom(wanted()))
    }
}

/// An index or sub-index with this many hexadecimal digits: `1018`, also `0x1018`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct FormKey<const DIGITS: usize>(u16);

impl<const DIGITS: usize> fmt::Display for FormKey<DIGITS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:0DIGITS$X}", self.0)
    }
}

impl<'de, const DIGITS: usize> Deserialize<'de> for FormKey<DIGITS> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(&text);
        let is_hex = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
        let number = u16::from_str_radix(digits, 16).ok();
        let fitting = number.filter(|number| is_hex && number >> (4 * DIGITS - 1) < 2);
        let wanted = || format!("`{text}` is not {DIGITS} hexadecimal digits");
        fitting.map(Self).ok_or_else(|| D::Error::custom(wanted()))
    }
}

fn map<S: Serializer, K: fmt::Display, T: Serialize>(
    pairs: &[(K, T)],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(key, item)| (key.to_string(), item)))
}

/// The device of a project.
///
/// # Errors
/// The first problem with its position.
pub fn read(text: &str) -> Result<Device, JsonError> {
    Ok(device(serde_json::from_str(text)?))
}

/// A string that is not empty.
fn stated<'a, T: From<&'a str>>(text: &'a str) -> Option<T> {
    Some(text).filter(|text| !text.is_empty()).map(T::from)
}

fn device(form: ProjectForm) -> Device {
    let ProjectForm { file_info: file, device_info: info, device_commissioning: node, objects } = form;
    let mut device = Device {
        file_info: Some(file_info(&file)),
        device_info: Some(device_info(&info)),
        ..Device::default()
    };
    let (node_id, baud_rate) = (node.node_id.0.try_into().ok(), node.baudrate.0.try_into().ok());
    let node = Commissioning {
        node_id: node_id.filter(|&id| id > 0),
        node_name: stated(&node.node_name),
        baud_rate: baud_rate.filter(|&rate| rate > 0),
        ..Commissioning::default()
    };
    device.commissioning = Some(node).filter(|node| *node != Commissioning::default());
    for (FormKey(index), form) in objects {
        device.objects.insert(index, object(form));
    }
    device.lists = ObjectLists::naming(device.objects.keys().copied());
    device
}

/// A placeholder for a missing time, which CANopenEditor requires, as in an XDD; it writes the year 1 itself.
const NO_TIME: &str = "1970-01-01T00:00:00Z";

fn file_info(form: &FileForm) -> FileInfo {
    let mut info = FileInfo {
        description: stated(&form.description),
        created_by: stated(&form.created_by),
        modified_by: stated(&form.modified_by),
        file_version: form.file_version.parse().ok(),
        ..FileInfo::default()
    };
    if info.file_version.is_none() && !form.file_version.is_empty() {
        info.invalid_values.push(Field::FileVersion, &form.file_version, Reason::NotANumber);
    }
    let mut time = |text: &str, field: Field| {
        if text.is_empty() || text == NO_TIME || text.starts_with("0001-") {
            return None;
        }
        let (date, time) = text.split_once(['T', 't']).unwrap_or_default();
        let read = Date::from_iso(date).zip(ClockTime::from_iso(&time.to_ascii_uppercase()));
        if read.is_none() {
            info.invalid_values.push(field, text, Reason::Malformed);
        }
        read
    };
    let created = time(&form.creation_time, Field::CreationTime);
    let modified = time(&form.modification_time, Field::ModificationTime);
    (info.creation_date, info.creation_time) = created.unzip();
    (info.modification_date, info.modification_time) = modified.unzip();
    info
}

/// The bit rates, in both directions.
macro_rules! bit_rates {
    ($($field:ident $rate:ident,)+) => {
        fn baud_rates(form: &DeviceForm) -> BaudRates {
            let auto = form.baud_rate_auto.then_some(true);
            BaudRates { $($rate: Some(form.$field),)+ kbit_100: None, auto }
        }

        fn bit_rates(rates: &BaudRates) -> DeviceForm {
            let is = |rate: Option<bool>| rate == Some(true);
            DeviceForm { $($field: is(rates.$rate),)+ baud_rate_auto: is(rates.auto), ..DeviceForm::default() }
        }
    };
}
bit_rates! {
    baud_rate10 kbit_10, baud_rate20 kbit_20, baud_rate50 kbit_50, baud_rate125 kbit_125, baud_rate250 kbit_250,
    baud_rate500 kbit_500, baud_rate800 kbit_800, baud_rate1000 kbit_1000,
}

fn device_info(form: &DeviceForm) -> DeviceInfo {
    DeviceInfo {
        vendor_name: stated(&form.vendor_name),
        product_name: stated(&form.product_name),
        baud_rates: baud_rates(form),
        lss_supported: Some(form.lss_slave),
        lss_master: form.lss_master.then_some(true),
        ..DeviceInfo::default()
    }
}

fn object(form: ObjectForm) -> Object {
    let code = u8::try_from(form.object_type.0).ok().filter(|&code| code > 0);
    let object_type = code.and_then(ObjectType::from_code);
    let mut object = Object::default();
    let is_single = object_type.is_none_or(|object_type| !object_type.has_subs());
    match form.sub_objects.as_slice() {
        [(FormKey(0), sub)] if is_single => {
            object.main = entry(sub);
            let is_domain = object.main.data_type == Some(DataType::DOMAIN);
            object.main.object_type = if is_domain { Some(ObjectType::Domain) } else { object_type };
            // CANopenEditor does not support a second name for a variable
            if !sub.name.is_empty() && sub.name != form.name {
                object.main.extra.push("SubName", &sub.name);
            }
        }
        subs => {
            let of_sub = |(FormKey(sub), form): &(FormKey<2>, SubForm)| {
                let (name, object_type) = (form.name.as_str().into(), Some(ObjectType::Var));
                Some((u8::try_from(*sub).ok()?, Entry { name, object_type, ..entry(form) }))
            };
            object.subs = subs.iter().filter_map(of_sub).collect();
            object.main.object_type = object_type;
            let count = object.subs.iter().filter(|(sub, _)| *sub < 0xFF).count();
            object.sub_number = u8::try_from(count).ok();
        }
    }
    let main = &mut object.main;
    main.name = form.name.into();
    if let Some(alias) = stated(&form.alias) {
        main.configured_mut().denotation = Some(alias);
    }
    if !form.description.is_empty() {
        main.parameter_mut().labels = Labels::description(LANGUAGE, &form.description);
    }
    let mut stack = main.stack.take().unwrap_or_default();
    stack.storage_group = stated(&form.storage_group);
    stack.count_label = stated(&form.count_label);
    stack.disabled = form.disabled.then_some(true);
    stack.detects_change = form.flags_pdo.then_some(true);
    main.stack = Some(stack).filter(|stack| **stack != Default::default());
    object
}

/// In the order of their enumeration.
const PDO_MAPPINGS: [PdoMapping; 4] =
    [PdoMapping::No, PdoMapping::Tpdo, PdoMapping::Rpdo, PdoMapping::Optional];

fn entry(form: &SubForm) -> Entry {
    let (access, pdo_mapping) = (form.sdo.0, form.pdo.0);
    let data_type = u16::try_from(form.data_type.0).ok().filter(|&index| index > 0).map(DataType);
    let mut entry = Entry {
        data_type,
        // the meaning of both, as CANopenEditor writes them to an XDD
        access: match (access, pdo_mapping) {
            (1, _) => Some(Access::Ro),
            (2, _) => Some(Access::Wo),
            (3, 1) => Some(Access::Rwr),
            (3, 2) => Some(Access::Rww),
            (3, _) => Some(Access::Rw),
            _ => None,
        },
        pdo_mapping: PDO_MAPPINGS.get(pdo_mapping as usize).copied(),
        ..Entry::default()
    };
    if access == 0 {
        entry.parameter_mut().access = Some(ParameterAccess::NoAccess);
    }
    if let Some(alias) = stated(&form.alias) {
        entry.configured_mut().denotation = Some(alias);
    }
    if form.srdo.0 > 0 {
        entry.stack_mut().srdo_access = SrdoAccess::ALL.get(form.srdo.0 as usize).copied();
    }
    if form.string_length_min.0 > 0 {
        entry.stack_mut().min_string_length = Some(form.string_length_min.0);
    }
    let values = [&form.default_value, &form.actual_value, &form.low_limit, &form.high_limit];
    for (field, text) in VALUES.into_iter().zip(values) {
        take(&mut entry, field, text);
    }
    entry
}

/// The fields of values; the high limit is last, because the others determine its meaning.
const VALUES: [Field; 4] = [Field::DefaultValue, Field::ParameterValue, Field::LowLimit, Field::HighLimit];

fn take(entry: &mut Entry, field: Field, text: &str) {
    let Some(text) = xdd::stated_text(text, entry.data_type) else { return };
    let mut quirks = Quirks::default();
    match (xdd::read_value(text, entry.data_type, &mut quirks), &field) {
        (Err(reason), _) => entry.invalid_values.push(field, text, reason),
        (Ok(value), Field::DefaultValue) => entry.default = Some(value),
        (Ok(value), Field::ParameterValue) => entry.configured_mut().value = Some(value),
        (Ok(value), Field::LowLimit) => entry.low_limit = Some(value),
        (Ok(value), _) => entry.high_limit = Some(literal::high_limit(value, entry, &mut quirks)),
    }
}

/// The project of a device, and the content that it does not support.
///
/// # Errors
/// If more values would be lost than allowed.
pub fn write(device: &Device, max_losses: usize) -> Result<Written, EditError> {
    let device = device.expanded();
    let text = objdict_model::json::pretty(&project(&device)).unwrap_or_default() + "\n";
    let mut read = read(&text).unwrap_or_default();
    read.kind = device.kind;
    let mut losses = Vec::new();
    complete::stated_anew(&device, &read, &mut |path, value| losses.push(Loss::invented(path, value)));
    losses.splice(0..0, lost(&device, &read, max_losses)?);
    Ok(Written { bytes: text.into_bytes(), losses })
}

fn project(device: &Device) -> ProjectForm {
    let text = |text: &Option<String>| text.clone().unwrap_or_default();
    let file = device.file_info.clone().unwrap_or_default();
    let time = |date: Option<Date>, time: Option<ClockTime>| match date {
        None => NO_TIME.to_owned(),
        Some(date) => {
            let time = time.unwrap_or(MIDNIGHT);
            let time = ClockTime { utc_offset: time.utc_offset.or(Some(0)), ..time };
            format!("{}T{}", date.to_iso(), time.to_iso(true))
        }
    };
    let version = file.invalid_values.get(&Field::FileVersion).map(|invalid| invalid.text.to_string());
    let info = device.device_info.clone().unwrap_or_default();
    let node = device.commissioning.clone().unwrap_or_default();
    let objects =
        device.objects.iter().map(|(&index, object)| (FormKey(index), object_form(device, index, object)));
    ProjectForm {
        file_info: FileForm {
            file_version: text(&file.file_version.map(|version| version.to_string()).or(version)),
            description: text(&file.description),
            creation_time: time(file.creation_date, file.creation_time),
            created_by: text(&file.created_by),
            modification_time: time(file.modification_date, file.modification_time),
            modified_by: text(&file.modified_by),
        },
        device_info: DeviceForm {
            vendor_name: text(&info.vendor_name),
            product_name: text(&info.product_name),
            lss_slave: info.lss_supported == Some(true),
            lss_master: info.lss_master == Some(true),
            ..bit_rates(&info.baud_rates)
        },
        device_commissioning: NodeForm {
            node_id: FormNumber(node.node_id.unwrap_or(0).into()),
            node_name: text(&node.node_name),
            baudrate: FormNumber(node.baud_rate.unwrap_or(0).into()),
        },
        objects: objects.collect(),
    }
}

fn object_form(device: &Device, index: u16, object: &Object) -> ObjectForm {
    // an entry without a valid type or access gets the one that CiA 301 specifies, as in the dialects of an
    // EDS
    let mut completed = object.clone();
    complete::complete(device, index, &mut completed);
    let (main, stack) = (&object.main, object.main.stack.clone().unwrap_or_default());
    let description = main.parameter.as_ref().and_then(|own| own.labels.description_in(LANGUAGE));
    let sub_form = |(sub, entry): (u8, &Entry)| {
        let of = completed.entry(sub);
        let form = sub_form(index, entry, of.as_deref().unwrap_or(entry));
        let name = if object.subs.is_empty() { String::new() } else { entry.name.to_string() };
        (FormKey(sub.into()), SubForm { name, ..form })
    };
    // CANopenEditor drops the value of an object that is neither VAR, ARRAY nor RECORD
    let object_type = match object.object_type() {
        ObjectType::Domain => ObjectType::Var,
        other => other,
    };
    ObjectForm {
        disabled: stack.disabled == Some(true),
        name: main.name.to_string(),
        alias: alias(main),
        description: description.unwrap_or_default().to_owned(),
        object_type: FormNumber(object_type.code().into()),
        count_label: stack.count_label.unwrap_or_default().into(),
        storage_group: stack.storage_group.unwrap_or_default().into(),
        flags_pdo: stack.detects_change == Some(true),
        sub_objects: object.stated().map(sub_form).collect(),
    }
}

fn alias(entry: &Entry) -> String {
    let own = entry.configured.as_ref().and_then(|configured| configured.denotation.as_deref());
    let named = || entry.parameter.as_ref()?.denotation.name_in(LANGUAGE);
    own.or_else(named).unwrap_or_default().to_owned()
}

fn sub_form(index: u16, entry: &Entry, completed: &Entry) -> SubForm {
    let stated_access = entry.parameter.as_ref().and_then(|parameter| parameter.access);
    let access = match entry.access {
        None if stated_access == Some(ParameterAccess::NoAccess) => None,
        _ => completed.access,
    };
    let text =
        |value: Option<&Value>, field| xdd::print_value(index, entry, value, &field).unwrap_or_default();
    let [default, actual, low, high] = VALUES;
    let stack = entry.stack.clone().unwrap_or_default();
    SubForm {
        name: String::new(),
        alias: alias(entry),
        data_type: FormNumber(completed.data_type.map_or(0, |data_type| data_type.0.into())),
        sdo: FormNumber(match access {
            None => 0,
            Some(Access::Ro | Access::Const) => 1,
            Some(Access::Wo) => 2,
            Some(Access::Rw | Access::Rwr | Access::Rww) => 3,
        }),
        pdo: FormNumber(match (entry.pdo_mapping, access) {
            (None | Some(PdoMapping::No), _) => 0,
            (Some(PdoMapping::Tpdo), _) | (_, Some(Access::Rwr)) => 1,
            (Some(PdoMapping::Rpdo), _) | (_, Some(Access::Rww)) => 2,
            (Some(PdoMapping::Optional | PdoMapping::Default), _) => 3,
        }),
        srdo: FormNumber(stack.srdo_access.map_or(0, |access| access as u32)),
        default_value: text(entry.default.as_ref(), default),
        actual_value: text(entry.configured_value(), actual),
        low_limit: text(entry.low_limit.as_ref(), low),
        high_limit: text(entry.high_limit.as_ref(), high),
        string_length_min: FormNumber(stack.min_string_length.unwrap_or(0)),
    }
}

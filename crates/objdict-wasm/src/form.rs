//! An object as a form: each field as the text of the file has it.

use objdict::describe::Decoder;
use objdict::format::Description;
use objdict::model::{Entry, Field, Object, Part, Place};
use serde::Serialize;

use crate::outline::name_of;

/// An object with its entries.
#[derive(Debug, Serialize)]
pub(crate) struct ObjectForm {
    index: u16,
    name: String,
    kind: &'static str,
    /// Whether its entries are in sub-indexes.
    has_subs: bool,
    parts: Vec<PartForm>,
}

/// An object or entry with its fields.
#[derive(Debug, Serialize)]
pub(crate) struct PartForm {
    /// As findings name it: `0x1018sub1`.
    place: String,
    /// `None` for the object itself.
    sub: Option<u8>,
    name: String,
    data_type: Option<String>,
    /// The meaning of the value.
    words: Option<String>,
    /// The unit of the engineering value.
    unit: Option<String>,
    /// The line of its section or element, counted from 1; `None` in compact storage.
    line: Option<u32>,
    fields: Vec<FieldForm>,
}

/// A field that the text states, or that a form offers.
#[derive(Debug, Serialize)]
pub(crate) struct FieldForm {
    /// In the spelling of CiA 306.
    name: String,
    /// As it is in the text; `None` where the text does not state it.
    text: Option<String>,
    /// The value as CIA 306 spells it, if the text states it elsewhere or spells it differently.
    value: Option<String>,
    line: Option<u32>,
}

/// What a form shows of an object with entries.
const OF_OBJECT: [Field; 3] = [Field::ParameterName, Field::ObjectType, Field::ObjFlags];

/// What it shows of an entry, in this order.
const OF_ENTRY: [Field; 9] = [
    Field::ParameterName,
    Field::ObjectType,
    Field::DataType,
    Field::AccessType,
    Field::DefaultValue,
    Field::LowLimit,
    Field::HighLimit,
    Field::PdoMapping,
    Field::ObjFlags,
];

/// What it shows of the file, the device and the node, by their names in CiA 306.
const OF_FILE: [&str; 11] = [
    "FileName",
    "Description",
    "FileVersion",
    "FileRevision",
    "EDSVersion",
    "CreatedBy",
    "CreationDate",
    "CreationTime",
    "ModifiedBy",
    "ModificationDate",
    "ModificationTime",
];
const OF_DEVICE: [&str; 23] = [
    "VendorName",
    "VendorNumber",
    "ProductName",
    "ProductNumber",
    "RevisionNumber",
    "OrderCode",
    "BaudRate_10",
    "BaudRate_20",
    "BaudRate_50",
    "BaudRate_125",
    "BaudRate_250",
    "BaudRate_500",
    "BaudRate_800",
    "BaudRate_1000",
    "SimpleBootUpMaster",
    "SimpleBootUpSlave",
    "LSS_Supported",
    "Granularity",
    "DynamicChannelsSupported",
    "GroupMessaging",
    "NrOfRXPDO",
    "NrOfTXPDO",
    "CompactPDO",
];
const OF_NODE_INFO: [&str; 7] =
    ["NodeID", "NodeName", "Baudrate", "NetNumber", "NetworkName", "CANopenManager", "LSS_SerialNumber"];

/// Beside these, what is configured for a node.
const OF_NODE: [Field; 1] = [Field::ParameterValue];

pub(crate) fn form(description: &Description, index: u16) -> Option<ObjectForm> {
    let device = description.described();
    let object = device.object(index)?;
    let decoder = Decoder::english(device, device.node_id());
    let is_node = device.kind == objdict::model::DeviceKind::Node;
    let has_subs = object.object_type().has_subs();
    let make = |sub: Option<u8>, entry: &Entry| {
        let place = sub.map_or_else(|| Place::object(index), |sub| Place::entry(index, sub));
        let fields = match (sub, has_subs) {
            (None, true) => &OF_OBJECT[..],
            _ => &OF_ENTRY[..],
        };
        let of_node = OF_NODE.iter().filter(|_| is_node && !(sub.is_none() && has_subs));
        let value = entry.value().filter(|_| sub.is_some() || !has_subs);
        PartForm {
            place: place.to_string(),
            sub,
            name: entry.name.to_string(),
            data_type: entry.data_type.map(|data_type| data_type.to_string()),
            words: value.and_then(|value| decoder.of(index, sub.unwrap_or_default(), value)),
            unit: entry.parameter.as_ref().and_then(|parameter| unit(parameter)),
            line: line(description, &place),
            fields: fields
                .iter()
                .chain(of_node)
                .map(|field| FieldForm {
                    value: value_of(entry, field),
                    ..field_form(description, &place, field)
                })
                .collect(),
        }
    };
    let entries = object.entries().filter(|_| has_subs);
    let mut parts = vec![make(None, &object.main)];
    parts.extend(entries.map(|(sub, entry)| make(Some(sub), &entry)));
    Some(ObjectForm {
        index,
        name: Object::name(object).to_owned(),
        kind: object.object_type().name(),
        has_subs,
        parts,
    })
}

fn field_form(description: &Description, place: &Place, field: &Field) -> FieldForm {
    let source = description.source();
    let place = place.clone().field(field.clone());
    let span = description.locate(&place).filter(|span| {
        // a place without a text of its own is located at its part
        let part = description.locate(&Place::of(place.part.clone()));
        part != Some(*span)
    });
    FieldForm {
        name: field.name().into_owned(),
        text: span.map(|span| span.of(source.text()).to_owned()),
        value: None,
        line: span.map(|span| source.line_column(span.start).line),
    }
}

fn unit(parameter: &objdict::model::Parameter) -> Option<String> {
    parameter.unit.as_ref()?.labels.names().next().map(|(_, name)| name.to_owned())
}

fn value_of(entry: &Entry, field: &Field) -> Option<String> {
    match field {
        Field::ParameterName => Some(entry.name.to_string()),
        Field::ObjectType => entry.object_type.map(|kind| format!("0x{:X}", kind as u8)),
        Field::DataType => entry.data_type.map(|data_type| format!("0x{:04X}", data_type.0)),
        Field::AccessType => entry.access.map(|access| access.name().to_owned()),
        Field::PdoMapping => entry.pdo_mapping.map(|mapping| u8::from(mapping.is_mappable()).to_string()),
        Field::DefaultValue => entry.default.as_ref().map(ToString::to_string),
        Field::LowLimit => entry.low_limit.as_ref().map(ToString::to_string),
        Field::HighLimit => entry.high_limit.as_ref().map(ToString::to_string),
        _ => None,
    }
}

/// The fields of the file, of the device and of the node that it is, where the text has a place for them.
pub(crate) fn facts(description: &Description) -> Vec<PartForm> {
    let is_node = description.described().kind == objdict::model::DeviceKind::Node;
    let parts = [
        (Part::FileInfo, &OF_FILE[..]),
        (Part::DeviceInfo, &OF_DEVICE),
        (Part::Commissioning, &OF_NODE_INFO),
    ];
    let parts = parts.into_iter().filter(|(part, _)| is_node || *part != Part::Commissioning);
    let make = |(part, names): (Part, &[&str])| {
        let place = Place::of(part);
        PartForm {
            place: place.to_string(),
            sub: None,
            name: String::new(),
            data_type: None,
            words: None,
            unit: None,
            line: line(description, &place),
            fields: names
                .iter()
                .map(|name| field_form(description, &place, &Field::from_name(name)))
                .collect(),
        }
    };
    parts.map(make).collect()
}

/// An entry that a configuration may set.
#[derive(Debug, Serialize)]
pub(crate) struct SettableEntry {
    index: u16,
    sub: u8,
    name: String,
    data_type: Option<String>,
    value: Option<String>,
    words: Option<String>,
    low: Option<String>,
    high: Option<String>,
}

/// The entries that SDO can write.
pub(crate) fn settings(description: &Description) -> Vec<SettableEntry> {
    let device = description.device();
    let decoder = Decoder::english(device, device.node_id());
    let of_object = |(&index, object): (&u16, &Object)| {
        let entries =
            object.entries().filter(|(_, entry)| entry.access.is_some_and(|access| access.is_writable()));
        let rows = entries.map(|(sub, entry)| SettableEntry {
            index,
            sub,
            name: name_of(device, index, sub).unwrap_or_default(),
            data_type: entry.data_type.map(|data_type| data_type.to_string()),
            value: entry.value().map(ToString::to_string),
            words: entry.value().and_then(|value| decoder.of(index, sub, value)),
            low: entry.low_limit.as_ref().map(ToString::to_string),
            high: entry.high_limit.as_ref().map(ToString::to_string),
        });
        rows.collect::<Vec<_>>()
    };
    device.objects.iter().flat_map(of_object).collect()
}

fn line(description: &Description, place: &Place) -> Option<u32> {
    description.locate(place).map(|span| description.source().line_column(span.start).line)
}

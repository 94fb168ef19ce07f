//! What a device has, in short: its objects and PDOs.

use objdict::describe::Decoder;
use objdict::format::Description;
use objdict::model::{Device, Entry, Object, Pdo, PdoKind, Place};
use serde::Serialize;

/// The lists of a device.
#[derive(Debug, Serialize)]
pub(crate) struct Outline<'a> {
    product: Option<&'a str>,
    vendor: Option<&'a str>,
    profile: Option<u16>,
    node_id: Option<u8>,
    is_node: bool,
    objects: Vec<OutlineRow<'a>>,
    pdos: Vec<PdoRow>,
    mappable: Vec<Mappable>,
}

/// An object, as a row of a list.
#[derive(Debug, Serialize)]
struct OutlineRow<'a> {
    index: u16,
    name: &'a str,
    /// `VAR`, `ARRAY` …
    kind: &'static str,
    /// The data type of a VAR.
    data_type: Option<String>,
    /// The line of its section or element, counted from 1.
    line: Option<u32>,
    subs: Vec<SubRow>,
}

#[derive(Debug, Serialize)]
struct SubRow {
    sub: u8,
    name: String,
    data_type: Option<String>,
}

/// A PDO with what it carries.
#[derive(Debug, Serialize)]
struct PdoRow {
    kind: &'static str,
    number: u16,
    communication: u16,
    mapping: u16,
    /// As the value of the entry spells it.
    cob_id: Option<String>,
    /// The CAN-ID for the node-ID of the file, or 1.
    can_id: Option<u32>,
    is_valid: Option<bool>,
    transmission_type: Option<u8>,
    transmission_words: Option<String>,
    /// In multiples of 100 µs.
    inhibit_time: Option<u16>,
    /// In milliseconds.
    event_timer: Option<u16>,
    /// The sub-indexes of the communication parameter that are described.
    communication_subs: Vec<u8>,
    /// How many objects count.
    mapped_count: Option<u8>,
    /// The described mapping entries.
    slots: Vec<SlotRow>,
    mapped: Vec<MappedRow>,
}

/// A mapping entry as it is described, also behind those that count.
#[derive(Debug, Serialize)]
struct SlotRow {
    sub: u8,
    number: Option<u32>,
}

#[derive(Debug, Serialize)]
struct MappedRow {
    index: u16,
    sub: u8,
    bits: u8,
    name: Option<String>,
}

/// An entry that PDOs may carry.
#[derive(Debug, Serialize)]
pub(crate) struct Mappable {
    index: u16,
    sub: u8,
    bits: u32,
    name: String,
    rpdo: bool,
    tpdo: bool,
}

pub(crate) fn outline(description: &Description) -> Outline<'_> {
    let device = description.described();
    let decoder = Decoder::english(device, device.node_id());
    let info = device.device_info.as_ref();
    Outline {
        product: info.and_then(|info| info.product_name.as_deref()),
        vendor: info.and_then(|info| info.vendor_name.as_deref()),
        profile: device.profile(),
        node_id: device.node_id(),
        is_node: device.kind == objdict::model::DeviceKind::Node,
        objects: device.objects.iter().map(|(&index, object)| row(description, index, object)).collect(),
        pdos: device.pdos().map(|pdo| pdo_row(device, &decoder, &pdo)).collect(),
        mappable: mappable(device),
    }
}

fn row<'a>(description: &Description, index: u16, object: &'a Object) -> OutlineRow<'a> {
    let type_of = |entry: &Entry| entry.data_type.map(|data_type| data_type.to_string());
    let has_subs = object.object_type().has_subs();
    let subs = object.entries().filter(|_| has_subs).map(|(sub, entry)| SubRow {
        sub,
        name: entry.name.to_string(),
        data_type: type_of(&entry),
    });
    let span = description.locate(&Place::object(index));
    OutlineRow {
        index,
        name: object.name(),
        kind: object.object_type().name(),
        data_type: type_of(&object.main).filter(|_| !has_subs),
        line: span.map(|span| description.source().line_column(span.start).line),
        subs: subs.collect(),
    }
}

fn pdo_row(device: &Device, decoder: &Decoder<'_>, pdo: &Pdo<'_>) -> PdoRow {
    let value = |sub| pdo.communication.and_then(|object| object.value(sub));
    let words = |sub| decoder.of(pdo.communication_index(), sub, value(sub)?.as_ref());
    let mapped = pdo.mapped().map(|mapped| MappedRow {
        index: mapped.index,
        sub: mapped.sub,
        bits: mapped.bits,
        name: name_of(device, mapped.index, mapped.sub),
    });
    let slots = pdo
        .slots
        .iter()
        .map(|slot| SlotRow { sub: slot.sub, number: slot.object.map(|object| object.to_number()) });
    let subs = pdo.communication.into_iter().flat_map(Object::entries).map(|(sub, _)| sub);
    PdoRow {
        kind: if pdo.kind == PdoKind::Rpdo { "RPDO" } else { "TPDO" },
        number: pdo.number,
        communication: pdo.communication_index(),
        mapping: pdo.mapping_index(),
        cob_id: value(1).map(|value| value.to_string()),
        can_id: pdo.cob_id.map(|cob_id| cob_id.can_id(device.node_id().unwrap_or(1))),
        is_valid: pdo.is_valid(),
        transmission_type: pdo.transmission_type,
        transmission_words: words(2),
        inhibit_time: pdo.inhibit_time,
        event_timer: pdo.event_timer,
        communication_subs: subs.collect(),
        mapped_count: pdo.mapped_count,
        slots: slots.collect(),
        mapped: mapped.collect(),
    }
}

pub(crate) fn name_of(device: &Device, index: u16, sub: u8) -> Option<String> {
    let object = device.object(index)?;
    Some(match object.entry(sub).filter(|_| object.object_type().has_subs()) {
        Some(entry) => format!("{} / {}", object.name(), entry.name),
        None => object.name().to_owned(),
    })
}

/// The entries that PDOs can carry.
pub(crate) fn mappable(device: &Device) -> Vec<Mappable> {
    let mut rows = Vec::new();
    for (&index, object) in device.objects.iter() {
        for (sub, entry) in object.entries().filter(|(_, entry)| entry.is_mappable()) {
            let bits =
                entry.data_type.and_then(|data_type| data_type.bit_length()).filter(|bits| *bits <= 64);
            let Some(bits) = bits else { continue };
            rows.push(Mappable {
                index,
                sub,
                bits: bits.into(),
                name: name_of(device, index, sub).unwrap_or_default(),
                rpdo: entry.fits_pdo(PdoKind::Rpdo),
                tpdo: entry.fits_pdo(PdoKind::Tpdo),
            });
        }
    }
    rows
}

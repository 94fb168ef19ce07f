//! The PDOs of a new device: those that its profile maps by default; further disabled ones for the remaining channels;
//! and requested ones without a mapping.

use super::demanded::Demanded;
use super::features::Features;
use super::number;
use super::objects::ObjectMaker;
use objdict_model::model::{
    CobId, DataType, Device, Entry, MappedObject, Object, ObjectType, PdoKind, predefined,
};
use objdict_profile::default_mapping::{self, PdoMap};

/// The encoder type with several sensors, whose positions are in a separate array.
const MULTI_SENSOR: u16 = 10;
/// Application objects that a mapping without objects has room for.
const ROOM: u16 = 8;

/// Adds the PDOs.
pub(super) fn add(device: &mut Device, maker: &ObjectMaker<'_>) {
    for pdo in wanted(device, maker) {
        device.objects.extend(records(maker, &pdo).into_iter().flatten());
    }
}

/// The communication parameter and the mapping parameter of a PDO.
pub(super) fn records(maker: &ObjectMaker<'_>, pdo: &PdoMap) -> Option<[(u16, Object); 2]> {
    let communication = pdo.kind.communication_index(pdo.number)?;
    let mapping = pdo.kind.mapping_index(pdo.number)?;
    let communication = (communication, communication_record(maker, pdo, communication));
    Some([communication, (mapping, mapping_record(maker, pdo, mapping))])
}

/// The PDOs that the features request, with the default mapping of the profile if it has one.
fn wanted(device: &Device, maker: &ObjectMaker<'_>) -> Vec<PdoMap> {
    let usual = default_pdos(device, &maker.plan);
    let of_kind = |kind: PdoKind, count: Option<u16>| -> Vec<PdoMap> {
        let usual = usual.iter().filter(|pdo| pdo.kind == kind);
        let Some(count) = count else { return usual.cloned().collect() };
        let mut pdos: Vec<PdoMap> =
            (1..=count).map(|number| PdoMap { kind, number, mapped: Vec::new() }).collect();
        for pdo in usual {
            if let Some(at) = pdos.get_mut(usize::from(pdo.number) - 1) {
                at.mapped.clone_from(&pdo.mapped);
            }
        }
        pdos
    };
    let features = &maker.plan.features;
    [of_kind(PdoKind::Rpdo, features.rpdos), of_kind(PdoKind::Tpdo, features.tpdos)].concat()
}

/// The profile's default PDOs, as far as the device has their objects.
pub(super) fn default_pdos(device: &Device, plan: &Demanded) -> Vec<PdoMap> {
    let mut pdos = match plan.profile {
        401 => default_mapping::of_channels(&counts(&plan.features)),
        402 => of_drive(),
        404 => of_measured(device, plan),
        406 => positions(&plan.features),
        _ => Vec::new(),
    };
    for pdo in &mut pdos {
        pdo.mapped.retain(|mapped| device.object(mapped.index).is_some());
    }
    // a PDO for an unsupported mode keeps only the controlword or statusword
    pdos.retain(|pdo| {
        !pdo.mapped.is_empty() && (plan.profile != 402 || pdo.number == 1 || pdo.mapped.len() > 1)
    });
    pdos
}

/// The number of elements of the channel arrays.
fn counts(features: &Features) -> default_mapping::Channels {
    let elements = |channels: Option<u16>, lines| {
        u8::try_from(channels.unwrap_or_default().div_ceil(lines)).unwrap_or(u8::MAX)
    };
    default_mapping::Channels {
        digital_inputs: elements(features.digital_inputs, 8),
        digital_outputs: elements(features.digital_outputs, 8),
        analog_inputs: elements(features.analog_inputs, 1),
        analog_outputs: elements(features.analog_outputs, 1),
    }
}

/// The PDOs of drives that CiA 402 defines, by number: the object after the controlword in the RPDO and after the
/// statusword in the TPDO, with its bits.
const OF_DRIVES: [(u16, u16, u8); 6] = [
    (0, 0, 0),
    (0x6060, 0x6061, 8),
    (0x607A, 0x6064, 32),
    (0x60FF, 0x606C, 32),
    (0x6071, 0x6077, 16),
    (0x6042, 0x6044, 16),
];

fn of_drive() -> Vec<PdoMap> {
    let object = |index, bits| MappedObject { index, sub: 0, bits };
    let pdos = (1u16..).zip(OF_DRIVES).flat_map(|(number, (command, status, bits))| {
        [(PdoKind::Rpdo, 0x6040, command), (PdoKind::Tpdo, 0x6041, status)].map(|(kind, word, index)| {
            PdoMap { kind, number, mapped: vec![object(word, 16), object(index, bits)] }
        })
    });
    pdos.collect()
}

/// Digital channels, then analogue ones, as many as fit into a PDO each (CiA 404 leaves it to the device).
fn of_measured(device: &Device, plan: &Demanded) -> Vec<PdoMap> {
    let entries = |index: u16, bits: usize| -> Vec<MappedObject> {
        let index = plan.channel_index(index);
        let count = device.object(index).and_then(Object::highest_sub).unwrap_or_default();
        let bits = u8::try_from(bits).unwrap_or_default();
        (1..=count).map(|sub| MappedObject { index, sub, bits }).collect()
    };
    let bits = plan.features.value_type.and_then(DataType::bit_length).map_or(32, usize::from);
    let of_kind = |kind, lines: u16, values: u16| {
        let (lines, values) = (entries(lines, 8), entries(values, bits));
        let frames = lines.chunks(8).chain(values.chunks(64 / bits)).map(<[MappedObject]>::to_vec);
        (1u16..).zip(frames).map(|(number, mapped)| PdoMap { kind, number, mapped }).collect::<Vec<_>>()
    };
    [of_kind(PdoKind::Rpdo, 0x6200, 0x6300), of_kind(PdoKind::Tpdo, 0x6000, 0x6130)].concat()
}

/// The position, once when it changes or a timer runs off and once with SYNC (CiA 406).
fn positions(features: &Features) -> Vec<PdoMap> {
    let position = match features.encoder_type {
        Some(MULTI_SENSOR) => MappedObject { index: 0x6020, sub: 1, bits: 32 },
        _ => MappedObject { index: 0x6004, sub: 0, bits: 32 },
    };
    [1, 2].map(|number| PdoMap { kind: PdoKind::Tpdo, number, mapped: vec![position] }).into()
}

/// The trigger of a PDO: an event of the profile, or the SYNC for the second position.
fn transmission_type(profile: u16, pdo: &PdoMap) -> u32 {
    match (profile, pdo.kind, pdo.number) {
        (406, PdoKind::Tpdo, 1) => 254,
        (406, PdoKind::Tpdo, 2) => 1,
        _ => 255,
    }
}

fn communication_record(maker: &ObjectMaker<'_>, pdo: &PdoMap, index: u16) -> Object {
    let cob_id = match pdo.kind.predefined_can_id(pdo.number) {
        Some(base) if pdo.mapped.is_empty() => predefined::per_node(base).disabled(),
        Some(base) => predefined::per_node(base),
        None => CobId::new(CobId::BIT_31),
    };
    let features = &maker.plan.features;
    let highest = match pdo.kind {
        PdoKind::Rpdo => features.rpdo_parameters,
        PdoKind::Tpdo => features.tpdo_parameters,
    };
    // sub-index 4 is reserved
    let subs = (0..=6u8).filter(|&sub| sub != 4 && Some(u16::from(sub)) <= highest);
    let entries = subs.map(|sub| {
        let mut entry = maker.entry(index, sub);
        match sub {
            0 => entry.default = number(highest.unwrap_or_default().into(), DataType::UNSIGNED8),
            1 => entry.default = Some(cob_id.to_value()),
            2 => entry.default = number(transmission_type(maker.plan.profile, pdo), DataType::UNSIGNED8),
            _ => {}
        }
        (sub, entry)
    });
    record(format!("{} {} communication parameter", pdo.kind.name(), pdo.number), entries)
}

fn mapping_record(maker: &ObjectMaker<'_>, pdo: &PdoMap, index: u16) -> Object {
    let count = u32::try_from(pdo.mapped.len()).unwrap_or(0);
    let sub_0 = Entry { default: number(count, DataType::UNSIGNED8), ..maker.entry(index, 0) };
    let usual = if pdo.mapped.is_empty() { ROOM.into() } else { pdo.mapped.len() };
    let room =
        maker.plan.features.mapping_entries.map_or(usual, |room| usize::from(room).max(pdo.mapped.len()));
    let slots = (1..=64u8).take(room).map(|sub| {
        let mapped = pdo.mapped.get(usize::from(sub) - 1).map_or(0, |mapped| mapped.to_number());
        let default = number(mapped, DataType::UNSIGNED32);
        let name = format!("Application object {sub}").into();
        (sub, Entry { name, default, ..maker.entry(index, sub) })
    });
    let name = format!("{} {} mapping parameter", pdo.kind.name(), pdo.number);
    record(name, std::iter::once((0, sub_0)).chain(slots))
}

fn record(name: String, entries: impl Iterator<Item = (u8, Entry)>) -> Object {
    let main = Entry { name: name.into(), object_type: Some(ObjectType::Record), ..Entry::default() };
    let mut object = Object { main, subs: entries.collect(), ..Object::default() };
    object.sub_number = u8::try_from(object.subs.len()).ok();
    object
}

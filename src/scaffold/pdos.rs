//! The PDOs of a new device: those that its profile maps by default, and further ones, switched off, for channels that
//! these have no room for.

use super::objects::Maker;
use super::{ChannelCounts, Encoder, Functions, number};
use crate::model::{CobId, DataType, Device, Entry, MappedObject, Object, ObjectType, PdoKind, predefined};
use crate::profile::default_mapping::{self, PdoMap};

/// The encoder type with several sensors, whose positions have an array of their own.
const MULTI_SENSOR: u8 = 10;

/// Adds the PDOs.
pub(super) fn add(device: &mut Device, maker: &Maker<'_>) {
    let pdos = match maker.functions {
        Functions::Bare => Vec::new(),
        Functions::InputsOutputs(channels) => default_mapping::of_channels(&counts(channels)),
        Functions::Encoder(encoder) => positions(encoder),
    };
    for pdo in pdos.iter().filter(|pdo| !pdo.mapped.is_empty()) {
        let (Some(communication), Some(mapping)) =
            (pdo.kind.communication_index(pdo.number), pdo.kind.mapping_index(pdo.number))
        else {
            continue;
        };
        device.objects.insert(communication, communication_record(maker, pdo, communication));
        device.objects.insert(mapping, mapping_record(maker, pdo, mapping));
    }
}

/// Entries of the arrays that hold the channels.
fn counts(channels: ChannelCounts) -> default_mapping::Channels {
    let bytes = |bits: u16| u8::try_from(bits.div_ceil(8)).unwrap_or(u8::MAX);
    default_mapping::Channels {
        digital_inputs: bytes(channels.digital_inputs),
        digital_outputs: bytes(channels.digital_outputs),
        analog_inputs: channels.analog_inputs,
        analog_outputs: channels.analog_outputs,
    }
}

/// The position, once when it changes or a timer runs off and once with SYNC (CiA 406).
fn positions(encoder: Encoder) -> Vec<PdoMap> {
    let position = match encoder.encoder_type {
        MULTI_SENSOR => MappedObject { index: 0x6020, sub: 1, bits: 32 },
        _ => MappedObject { index: 0x6004, sub: 0, bits: 32 },
    };
    [1, 2].map(|number| PdoMap { kind: PdoKind::Tpdo, number, mapped: vec![position] }).into()
}

/// What triggers a PDO: an event of the profile, or the SYNC for the second position.
fn transmission_type(functions: Functions, pdo: &PdoMap) -> u32 {
    match functions {
        Functions::Encoder(_) if pdo.number == 1 => 254,
        Functions::Encoder(_) => 1,
        _ => 255,
    }
}

fn communication_record(maker: &Maker<'_>, pdo: &PdoMap, index: u16) -> Object {
    let cob_id = match pdo.kind.predefined_can_id(pdo.number) {
        Some(base) => predefined::per_node(base),
        None => CobId::new(CobId::BIT_31),
    };
    let subs: &[u8] = match pdo.kind {
        PdoKind::Rpdo => &[0, 1, 2],
        PdoKind::Tpdo => &[0, 1, 2, 3, 5],
    };
    let entries = subs.iter().map(|&sub| {
        let mut entry = maker.entry(index, sub);
        match sub {
            0 => entry.default = number(subs.last().copied().unwrap_or(0).into(), DataType::UNSIGNED8),
            1 => entry.default = Some(cob_id.to_value()),
            2 => entry.default = number(transmission_type(maker.functions, pdo), DataType::UNSIGNED8),
            _ => {}
        }
        (sub, entry)
    });
    record(format!("{} {} communication parameter", pdo.kind.name(), pdo.number), entries)
}

fn mapping_record(maker: &Maker<'_>, pdo: &PdoMap, index: u16) -> Object {
    let count = u32::try_from(pdo.mapped.len()).unwrap_or(0);
    let sub_0 = Entry { default: number(count, DataType::UNSIGNED8), ..maker.entry(index, 0) };
    let slots = (1..=64u8).zip(&pdo.mapped).map(|(sub, mapped)| {
        let default = number(mapped.to_number(), DataType::UNSIGNED32);
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

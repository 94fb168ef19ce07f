//! The kinds of channels of an I/O module and their numbers (CiA 401, 1000h).

use std::ops::RangeInclusive;

use crate::demands::{self, Applied};
use crate::model::{Device, DeviceKind, MappedObject};
use crate::profile::default_mapping::{Channels, of_channels};
use crate::profile::{device_type_index, index_in, number_of};
use crate::{Facts, PdoFacts};

/// The last PDO with a default mapping.
const LAST: u16 = 4;

/// A kind of channel.
pub(crate) struct ChannelKind {
    /// The bit of the kind in the device type.
    pub bit: u8,
    /// The name in messages.
    pub name: &'static str,
    /// The objects with the values of the channels, the usual one first.
    indexes: &'static [RangeInclusive<u16>],
}

/// All kinds, in the order of their bits.
pub(crate) static KINDS: [ChannelKind; 4] = [
    ChannelKind {
        bit: 16,
        name: "digital inputs",
        indexes: &[0x6000..=0x6000, 0x6100..=0x6100, 0x6120..=0x6120, 0x6020..=0x6027],
    },
    ChannelKind {
        bit: 17,
        name: "digital outputs",
        indexes: &[0x6200..=0x6200, 0x6300..=0x6300, 0x6320..=0x6320, 0x6220..=0x6227],
    },
    ChannelKind {
        bit: 18,
        name: "analogue inputs",
        indexes: &[0x6401..=0x6401, 0x6400..=0x6400, 0x6402..=0x6404],
    },
    ChannelKind {
        bit: 19,
        name: "analogue outputs",
        indexes: &[0x6411..=0x6411, 0x6410..=0x6410, 0x6412..=0x6414],
    },
];

impl ChannelKind {
    fn indexes(&self, block: u8) -> impl Iterator<Item = u16> {
        self.indexes.iter().cloned().flatten().map(move |index| index_in(block, index))
    }

    /// Whether a logical device has channels of the kind, or a module may provide them.
    pub(crate) fn may_be_in(&self, device: &Device, block: u8) -> bool {
        self.indexes(block).any(|index| demands::is_there(device, index))
    }

    /// The first object of a logical device that has channels of the kind.
    pub(crate) fn first_in(&self, device: &Device, block: u8) -> Option<u16> {
        self.indexes(block).find(|&index| device.object(index).is_some_and(|object| !object.orphan))
    }
}

/// The kinds of channels that the device type of an I/O module states, but that it does not have.
pub(crate) fn only_stated(device: &Device, block: u8) -> impl Iterator<Item = &'static ChannelKind> {
    let is_module = number_of(device, block) == Some(401);
    let value =
        device.object(device_type_index(device, block)).and_then(|object| object.value(0)?.as_integer());
    let value = value.filter(|_| is_module).unwrap_or(0);
    KINDS.iter().filter(move |kind| value >> kind.bit & 1 == 1 && !kind.may_be_in(device, block))
}

/// The PDOs of an EDS that have a default mapping in the profile: none if bit 23 of the device type
/// marks the mapping as manufacturer-specific, and none for a module with several logical devices.
pub(crate) fn default_pdos<'a>(
    facts: &'a Facts<'a>,
    applied: &Applied<'_>,
) -> Vec<(&'a PdoFacts<'a>, Vec<MappedObject>)> {
    let device = facts.device;
    let device_type = device.object(0x1000).and_then(|object| object.value(0)?.as_integer());
    let is_of_manufacturer = device_type.is_some_and(|device_type| device_type >> 23 & 1 == 1);
    let is_single = applied.block == 0 && device.profile() == number_of(device, 0);
    if device.kind != DeviceKind::Type || is_of_manufacturer || !is_single {
        return Vec::new();
    }
    let defaults = of_device(device).map(|channels| of_channels(&channels)).unwrap_or_default();
    let defaults = defaults.into_iter().filter(|default| default.number <= LAST);
    let described = defaults.filter_map(|default| {
        let is_it = |pdo: &&PdoFacts<'_>| (pdo.pdo.kind, pdo.pdo.number) == (default.kind, default.number);
        Some((facts.pdos.iter().find(is_it)?, default.mapped))
    });
    described.collect()
}

/// The number of elements of the arrays in the default mapping; `None` if modules provide them.
pub(crate) fn of_device(device: &Device) -> Option<Channels> {
    let number = |index: u16| {
        let object = device.object(index).filter(|object| !object.orphan);
        object.and_then(crate::model::Object::highest_sub).unwrap_or(0)
    };
    (!device.is_modular()).then(|| Channels {
        digital_inputs: number(0x6000),
        digital_outputs: number(0x6200),
        analog_inputs: number(0x6401),
        analog_outputs: number(0x6411),
    })
}

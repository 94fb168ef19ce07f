//! The channels of an I/O module, its device type and its PDOs.

use crate::demands::Applied;
use crate::diagnostic::{Findings, Fix, say, series};
use crate::model::{MappedObject, PdoKind, Place};
use crate::profile::{device_type_index, number_of};
use crate::rule::rules;
use crate::{Facts, channels};

rules! {
    source: "CiA 401 (1000h)";

    "cia401/channels-not-in-device-type" = CHANNELS_NOT_IN_DEVICE_TYPE, Warning,
        Applied(channels_not_in_device_type), fix Unsafe;
    summary: "the module has channels that its device type does not state",
    checks: "Whether 1000h states each kind of channel that the description has objects for: bit 16 for digital inputs, bit 17 for digital outputs, bit 18 for analogue inputs, bit 19 for analogue outputs.",
    why: "A master that relies on the device type does not use these channels.",
    example: "`[6401]`, and `[1000]` with `DefaultValue=0x00030191`",
    remedy: "Set the bit, in the description and in the device.",

    "cia401/channels-without-pdo" = CHANNELS_WITHOUT_PDO, Warning, Applied(channels_without_pdo);
    summary: "channels of an I/O module have no PDO",
    checks: "Whether a module with more than 8 bytes of digital inputs or outputs, or more than 12 words of analogue ones, maps the last of them or has a PDO above PDO 4. Channels of modules of a modular device are not counted.",
    why: "The default PDOs are full, so the remaining channels are accessible by SDO only, which is too slow for process data.",
    example: "`[6000sub0]` with `DefaultValue=12`, and no TPDO above TPDO 4",
    remedy: "Add PDOs from PDO 5 on for the remaining channels, not valid by default.",
    source: "CiA 401, default PDOs; CiA 301 §7.5.2.35 (PDO 5 and above)",

    "cia401/device-type-without-channels" = DEVICE_TYPE_WITHOUT_CHANNELS, Error,
        Applied(device_type_without_channels), fix Unsafe;
    summary: "the device type states channels that the module does not have",
    checks: "Whether there is an object of any width for each kind of channel that 1000h states: bit 16 for digital inputs (6000h, 6100h, 6120h or 6020h to 6027h), bit 17 for digital outputs (6200h, 6300h, 6320h, 6220h to 6227h), bit 18 for analogue inputs (6400h to 6404h), bit 19 for analogue outputs (6410h to 6414h). In a device with several logical devices the types are in 67FFh and each object 800h further. Channels that a module of a modular device may add are not reported. The PDOs of channels that the module does not have are not demanded.",
    why: "A master relies on the device type: it uses the channels and the PDOs that carry them. In real files the device type is nearly always copied from a larger device of the same family.",
    example: "`[1000]` with `DefaultValue=0x000F0191`, and no analogue channels",
    remedy: "Clear the bit, or describe the channels.",
}

fn channels_not_in_device_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let Some(value) = value.filter(|_| number_of(device, block) == applied.profile.number) else { return };
    let unnamed = channels::KINDS.iter().filter(|kind| value >> kind.bit & 1 == 0);
    let unnamed: Vec<_> = unnamed.filter_map(|kind| Some((kind, kind.first_in(device, block)?))).collect();
    if unnamed.is_empty() {
        return;
    }
    let names = series(unnamed.iter().map(|(kind, _)| kind.name));
    let message = say!("the device has {}, but its device type does not state them", names);
    let right = unnamed.iter().fold(value, |value, (kind, _)| value | 1 << kind.bit);
    let place = device.value_place(index, 0);
    let mut finding = CHANNELS_NOT_IN_DEVICE_TYPE.at(place.clone(), message);
    for (kind, index) in unnamed {
        finding = finding.label(Place::object(index), kind.name);
    }
    let text = format!("0x{right:08X}");
    let finding = finding.help(say!("write `{}`", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}

/// The number of elements that the default PDOs carry: PDO 1, and PDOs 2 to 4.
const DEFAULT_BYTES: u8 = 8;
const DEFAULT_WORDS: u8 = 12;

/// The last PDO with a default mapping.
const LAST_DEFAULT_PDO: u16 = 4;

fn channels_without_pdo(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let channels = channels::of_device(facts.device).filter(|_| applied.block == 0);
    let Some(channels) = channels else { return };
    let arrays = [
        (PdoKind::Tpdo, 0x6000, channels.digital_inputs, DEFAULT_BYTES),
        (PdoKind::Rpdo, 0x6200, channels.digital_outputs, DEFAULT_BYTES),
        (PdoKind::Tpdo, 0x6401, channels.analog_inputs, DEFAULT_WORDS),
        (PdoKind::Rpdo, 0x6411, channels.analog_outputs, DEFAULT_WORDS),
    ];
    for (kind, index, number, room) in arrays.into_iter().filter(|(_, _, number, room)| number > room) {
        let mut pdos = facts.pdos.iter().filter(|pdo| pdo.pdo.kind == kind);
        let carries = |object: MappedObject| (object.index, object.sub) == (index, number);
        if pdos.any(|pdo| {
            pdo.pdo.number > LAST_DEFAULT_PDO || pdo.mapped.iter().any(|mapped| carries(mapped.object))
        }) {
            continue;
        }
        let kind = kind.name();
        let message = say!(
            "{:04X}h has {} elements, but {}s 1 to 4 have room for only {} of them",
            index,
            number,
            kind,
            room
        );
        let finding = CHANNELS_WITHOUT_PDO.at(facts.device.value_place(index, 0), message);
        findings.push(finding.help(say!("add {}s from {} 5 on for the remaining elements", kind, kind)));
    }
}

fn device_type_without_channels(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let index = device_type_index(device, block);
    let value = device.object(index).and_then(|object| object.value(0)?.as_integer());
    let missing: Vec<_> = channels::only_stated(device, block).collect();
    let Some(value) = value.filter(|_| !missing.is_empty()) else { return };
    let names = series(missing.iter().map(|kind| kind.name));
    let message = say!("the device type states {}, but there are no objects for them", names);
    let cleared = missing.iter().fold(value, |value, kind| value & !(1 << kind.bit));
    let place = device.value_place(index, 0);
    let finding = DEVICE_TYPE_WITHOUT_CHANNELS.at(place.clone(), message);
    let text = format!("0x{cleared:08X}");
    let finding = finding.help(say!("write `{}` or describe the channels", text));
    findings.push(finding.fix(Fix::risky(say!("write `{}`", text)).set(place, text)));
}

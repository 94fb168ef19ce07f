//! The functions of an encoder: class C2, scaling, alarms and CAMs; and its TPDOs.

use crate::demands::{self, Applied};
use crate::diagnostic::{Findings, Fix, Severity, counted_bits, say, series, sub_index};
use crate::model::{DeviceKind, Field, MappedObject, PdoKind, Place};
use crate::profile::{device_type_index, index_in};
use crate::rule::rules;
use crate::{Facts, MappedTo, PdoFacts};

rules! {
    "cia406/cam-without-limits" = CAM_WITHOUT_LIMITS, Warning, Applied(cam_without_limits);
    summary: "an encoder enables a CAM that has no limits",
    checks: "Each CAM that 6301h (CAM enable register) enables must have a low limit (6310h to 6317h) and a high limit (6320h to 6327h), configured or by default.",
    why: "The CAM is active between its limits. Without them its state is not defined.",
    example: "`[6301sub1]` with `DefaultValue=0x02`, without `[6311]` and `[6321]`",
    remedy: "Describe the limits, or clear the bit of the CAM.",
    source: "CiA 406 (6301h, 6310h to 6327h)",

    "cia406/contradictory-copy" = CONTRADICTORY_COPY, Warning, Applied(contradictory_copy);
    summary: "two objects of an encoder that must have the same value differ",
    checks: "By default, 6500h (operating status) must have the value of 6000h (operating parameters), and 650Bh must have the serial number of 1018h sub-index 4. A serial number of 0 is not compared.",
    why: "The parameters determine the status, so one of the two values is wrong for the device. A master that compares them rejects the configuration.",
    example: "`[6000]` with `DefaultValue=0x0004`, `[6500]` with `DefaultValue=0x0000`",
    remedy: "Write the same value to both, in the description and in the device.",
    source: "CiA 406 (6000h, 6500h, 650Bh)",

    "cia406/cyclic-timer-mismatch" = CYCLIC_TIMER_MISMATCH, Error, Applied(cyclic_timer_mismatch);
    summary: "the cyclic timer and the event timer of TPDO 1 differ",
    checks: "If 6200h and 1800h sub-index 5 are both described, they must have the same value.",
    why: "Both objects access one timer, so one of the values is wrong, and the start-up value of the encoder is ambiguous.",
    example: "`[6200]` with `DefaultValue=100`, `[1800sub5]` with `DefaultValue=0`",
    remedy: "Write the same time, in milliseconds.",
    source: "CiA 406 (6200h, 1800h)",

    "cia406/incomplete-class-2" = INCOMPLETE_CLASS_2, Warning, Applied(incomplete_class_2);
    summary: "an encoder has some but not all functions of class C2",
    checks: "An encoder with scaling and preset (6002h and 6003h), which only class C2 requires, must have the other objects of that class. These are 6001h if it is rotary or 6005h if it is linear, 6200h unless 1800h has an event timer, alarms and warnings (6503h to 6506h), 6507h, 6509h, 650Ah and 650Bh. Encoders with several sensors or with only one of 6002h and 6003h are not checked.",
    why: "An encoder of class C1 may have any of these objects, so nothing fails. However, a master that expects class C2 gets SDO aborts.",
    example: "`[6002]` and `[6003]` without `[6503]`",
    remedy: "Describe the other objects too, or declare an encoder of class C1 with scaling.",
    source: "CiA 406, class C2; manuals of encoders",

    "cia406/scaling-off" = SCALING_OFF, Warning, Applied(scaling_off);
    summary: "a configuration scales the position of an encoder, but scaling is switched off",
    checks: "If a configuration (DCF or XDC) sets 6001h (measuring units per revolution) or 6002h (measuring range) to a value other than the default, bit 2 of 6000h must be set.",
    why: "Without the bit, the encoder ignores the values and sends its physical position, so the master computes with the wrong resolution.",
    example: "`[6001]` with `ParameterValue=3600` and `DefaultValue=8192`, `[6000]` with `ParameterValue=0`",
    remedy: "Set bit 2 of 6000h, or remove the values.",
    source: "CiA 406 (6000h to 6002h)",

    "cia406/unsupported-alarm" = UNSUPPORTED_ALARM, Warning, Applied(unsupported_alarm);
    summary: "an alarm or a warning is set that the encoder does not support",
    checks: "Each bit that is set in 6503h (alarms) must be set in 6504h (supported alarms). Each bit that is set in 6505h (warnings) must be set in 6506h (supported warnings). The rule checks configured and default values.",
    why: "A master evaluates only the supported bits, so it overlooks the alarm or mistakes it for an error of the device.",
    example: "`[6503]` with `DefaultValue=0x0002`, `[6504]` with `DefaultValue=0x0001`",
    remedy: "Correct one of the two values. Alarms and warnings are 0 by default.",
    source: "CiA 406 (6503h to 6506h)",

    "cia406/wrong-default-mapping" = WRONG_DEFAULT_MAPPING, Error, Applied(wrong_default_mapping), fix Unsafe;
    summary: "a TPDO of an encoder does not carry the position",
    checks: "In an EDS, TPDO 1 and TPDO 2 must carry the position and nothing else: 6004h with 32 bits, 6008h with 64 bits in encoders of high precision, 6020h sub-index 1 in encoders with several sensors. Further objects after the position are a warning. TPDO 2 is not checked if TPDO 3 is present, which was the synchronous one before edition 3. PDOs with invalid entries are not checked.",
    why: "Encoders are interchangeable because the position is in the first four bytes of TPDO 1.",
    example: "`[1A00sub1]` with `DefaultValue=0x65030010`",
    remedy: "Write `0x60040020`, in the description and in the device.",
    source: "CiA 406 (1A00h, 1A01h)",

    "cia406/wrong-transmission-type" = WRONG_TRANSMISSION_TYPE, Warning,
        Applied(wrong_transmission_type), fix Unsafe;
    summary: "the transmission type of an encoder's TPDO differs from CiA 406",
    checks: "In an EDS, TPDO 1 must be sent by its timer (transmission type 254; 255 is accepted) and TPDO 2 on each SYNC (type 1). TPDO 2 is not checked if TPDO 3 is present, which was the synchronous one before edition 3.",
    why: "A master that knows the profile expects TPDO 1 asynchronously and TPDO 2 with each SYNC.",
    example: "`[1800sub2]` with `DefaultValue=1`",
    remedy: "Write 254 for TPDO 1 and 1 for TPDO 2.",
    source: "CiA 406 (1800h, 1801h)",
}

fn cam_without_limits(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let Some(enabled) = device.object(at(0x6301)) else { return };
    for (sub, _) in enabled.entries().filter(|(sub, _)| (1..0xFF).contains(sub)) {
        let Some(bits) = enabled.value(sub).and_then(|value| value.as_integer()) else { continue };
        let limits = |cam: u16| [at(0x6310 + cam), at(0x6320 + cam)];
        let lacks = |index: &u16| match device.object(*index) {
            Some(object) => !object.has(sub),
            None => !demands::is_there(device, *index),
        };
        let cams = (0..8).filter(|cam| bits >> cam & 1 == 1);
        let Some((cam, limit)) =
            cams.flat_map(|cam| limits(cam).map(|limit| (cam, limit))).find(|(_, limit)| lacks(limit))
        else {
            continue;
        };
        let message = say!(
            "channel {} enables CAM {}, but {:04X}h has no limit for it",
            sub_index(sub),
            cam + 1,
            limit
        );
        let finding = CAM_WITHOUT_LIMITS.at(device.value_place(at(0x6301), sub), message);
        findings.push(finding.help("describe the limits, or clear the bit of the CAM"));
    }
}

fn contradictory_copy(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    // a configuration changes only one of them
    let value = |(index, sub): (u16, u8)| device.object(index)?.entry(sub)?.default.as_ref()?.as_integer();
    let pairs = [((at(0x6500), 0), (at(0x6000), 0), true), ((at(0x650B), 0), (0x1018, 4), false)];
    for (copy, original, may_be_0) in pairs {
        let (Some(shown), Some(right)) = (value(copy), value(original)) else { continue };
        if shown == right || (!may_be_0 && (shown == 0 || right == 0)) {
            continue;
        }
        let name = |(index, sub): (u16, u8)| match sub {
            0 => say!("{:04X}h", index),
            _ => say!("{:04X}h sub-index {}", index, sub),
        };
        let message = say!("{} is `0x{:X}`, but {} is `0x{:X}`", name(copy), shown, name(original), right);
        let place = |(index, sub): (u16, u8)| match sub {
            0 => Place::object(index).field(Field::DefaultValue),
            _ => Place::entry(index, sub).field(Field::DefaultValue),
        };
        let finding = CONTRADICTORY_COPY.at(place(copy), message).label(place(original), "the same value");
        findings.push(finding.help("write the same value to both"));
    }
}

/// The objects that class C2 adds to class C1, scaling and preset, for all encoder types.
const CLASS_2_OBJECTS: [u16; 8] = [0x6503, 0x6504, 0x6505, 0x6506, 0x6507, 0x6509, 0x650A, 0x650B];

fn incomplete_class_2(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let (device, block) = (facts.device, applied.block);
    let device_type = device.object(device_type_index(device, block));
    let device_type = device_type.and_then(|object| object.value(0)?.as_integer());
    let of_type = match device_type.map(|device_type| device_type >> 16) {
        Some(1..=5) => 0x6001,
        Some(6..=9) => 0x6005,
        _ => return,
    };
    let is_there = |index: u16| demands::is_there(device, index_in(block, index));
    if !is_there(0x6002) || !is_there(0x6003) {
        return;
    }
    let has_timer = block == 0 && device.object(0x1800).is_some_and(|object| object.has(5));
    let timer = (!has_timer).then_some(0x6200);
    let all = std::iter::once(of_type).chain(timer).chain(CLASS_2_OBJECTS);
    let missing: Vec<String> = all
        .filter(|&index| !is_there(index))
        .map(|index| format!("{:04X}h", index_in(block, index)))
        .collect();
    if !missing.is_empty() {
        let message = say!("the encoder has scaling and preset of class C2, but lacks {}", series(missing));
        let finding = INCOMPLETE_CLASS_2.at(Place::object(index_in(block, 0x6003)), message);
        findings.push(finding.help("describe the missing objects"));
    }
}

fn scaling_off(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let at = |index: u16| index_in(applied.block, index);
    let control = facts.number(at(0x6000), 0);
    let scaled = [0x6001, 0x6002].map(at).into_iter().filter(|&index| {
        let entry = device.object(index).map(|object| &object.main);
        entry.is_some_and(|entry| {
            entry.configured_value().is_some_and(|value| entry.default.as_ref() != Some(value))
        })
    });
    for index in scaled.filter(|_| control.is_some_and(|control| control & 4 == 0)) {
        let message = say!("{:04X}h is configured, but bit 2 of {:04X}h disables scaling", index, at(0x6000));
        let finding = SCALING_OFF.at(device.value_place(index, 0), message);
        let finding = finding.label(device.value_place(at(0x6000), 0), "bit 2 is not set");
        findings.push(finding.help("set bit 2, or remove the values"));
    }
}

fn unsupported_alarm(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    for (set, supported, name) in [(0x6503, 0x6504, "alarm"), (0x6505, 0x6506, "warning")] {
        let [set, supported] = [set, supported].map(|index| index_in(applied.block, index));
        let value = |index: u16| device.object(index)?.value(0)?.as_integer();
        let (Some(bits), Some(known)) = (value(set), value(supported)) else { continue };
        if bits & !known != 0 {
            let message =
                say!("{:04X}h sets `0x{:04X}`, which is not a supported {}", set, bits & !known, name);
            let finding = UNSUPPORTED_ALARM.at(device.value_place(set, 0), message);
            let finding = finding.label(device.value_place(supported, 0), "supported");
            findings.push(finding.help("write 0, or set the bit in the supported ones"));
        }
    }
}

fn cyclic_timer_mismatch(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    let value = |index: u16, sub: u8| device.object(index)?.value(sub)?.as_integer();
    let (Some(cyclic), Some(event)) = (value(0x6200, 0), value(0x1800, 5)) else { return };
    if cyclic != event && applied.block == 0 {
        let message =
            say!("the cyclic timer is `{}` ms, but the event timer of TPDO 1 is {} ms", cyclic, event);
        let finding = CYCLIC_TIMER_MISMATCH.at(device.value_place(0x6200, 0), message);
        let finding = finding.label(device.value_place(0x1800, 5), "the same timer");
        findings.push(finding.help("write the same time to both"));
    }
}

/// The object with the position in its different formats.
const POSITION_OBJECTS: [MappedObject; 3] = [
    MappedObject { index: 0x6004, sub: 0, bits: 32 },
    MappedObject { index: 0x6008, sub: 0, bits: 64 },
    MappedObject { index: 0x6020, sub: 1, bits: 32 },
];

fn wrong_default_mapping(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    if device.kind != DeviceKind::Type || applied.block > 0 || device.profile() == Some(0xFFFF) {
        return;
    }
    let numbers = if device.objects.contains_key(&0x1802) { 1..=1 } else { 1..=2 };
    let pdos = facts.pdos.iter();
    for pdo in pdos.filter(|pdo| pdo.pdo.kind == PdoKind::Tpdo && numbers.contains(&pdo.pdo.number)) {
        let Some(first) = pdo.mapped.first().filter(|_| is_mapping_readable(pdo)) else { continue };
        let right = POSITION_OBJECTS.contains(&first.object);
        if right && pdo.mapped.len() == 1 {
            continue;
        }
        let index = pdo.pdo.mapping_index();
        if right {
            let message = say!("{} maps more than the position", pdo.pdo);
            let place = device.value_place(index, pdo.mapped.get(1).map_or(0, |second| second.slot));
            let finding = WRONG_DEFAULT_MAPPING.at(place, message).severity(Severity::Warning);
            let fix = Fix::risky("map the position only").set(device.value_place(index, 0), "1");
            findings.push(finding.help("map other values into other TPDOs").fix(fix));
            continue;
        }
        let MappedObject { index: found, sub, bits } = first.object;
        let message = match POSITION_OBJECTS.iter().find(|right| (right.index, right.sub) == (found, sub)) {
            Some(right) => say!(
                "{} maps {} of {:04X}h:{:02X}, but CiA 406 maps {}",
                pdo.pdo,
                counted_bits(bits),
                found,
                sub,
                right.bits
            ),
            None => say!("{} maps {:04X}h:{:02X} first, not the position", pdo.pdo, found, sub),
        };
        let finding = WRONG_DEFAULT_MAPPING.at(device.value_place(index, first.slot), message);
        let (is_there, number) = match device.object(0x6004) {
            Some(_) => (true, "0x60040020"),
            None => (device.objects.contains_key(&0x6020), "0x60200120"),
        };
        let finding = finding.help(say!("write `{}` and 1 as number of mapped objects", number));
        let fix = Fix::risky("map the position").set(device.value_place(index, 0), "1");
        let fix = fix.set(device.value_place(index, first.slot), number);
        findings.push(if is_there { finding.fix(fix) } else { finding });
    }
}

/// Whether the mapping is complete and no other rule reports it.
fn is_mapping_readable(pdo: &PdoFacts<'_>) -> bool {
    let fits = |target: &MappedTo<'_>| match target {
        MappedTo::Entry(entry) => entry.is_mappable() && entry.fits_pdo(pdo.pdo.kind),
        _ => false,
    };
    pdo.lengths_are_right() && pdo.mapped.iter().all(|mapped| fits(&mapped.target))
}

/// A TPDO with its default type and all types it may have.
const ALLOWED_TYPES: [(u16, u8, &[u8]); 2] = [(1, 254, &[254, 255]), (2, 1, &[1])];

fn wrong_transmission_type(facts: &Facts<'_>, applied: &Applied<'_>, findings: &mut Findings) {
    let device = facts.device;
    if device.kind != DeviceKind::Type || applied.block > 0 || device.profile() == Some(0xFFFF) {
        return;
    }
    let has_third = device.objects.contains_key(&0x1802);
    for (number, right, allowed) in
        ALLOWED_TYPES.into_iter().filter(|(number, ..)| *number == 1 || !has_third)
    {
        let Some(pdo) = device.pdo(PdoKind::Tpdo, number) else { continue };
        // another rule reports reserved transmission types
        let wrong =
            pdo.transmission_type.filter(|found| !allowed.contains(found) && !(241..=251).contains(found));
        let Some(found) = wrong else { continue };
        let message = say!("transmission type `{}` of {} differs from CiA 406 ({!})", found, pdo, right);
        let place = device.value_place(pdo.communication_index(), 2);
        let finding = WRONG_TRANSMISSION_TYPE.at(place.clone(), message).help(say!("write {}", right));
        findings.push(finding.fix(Fix::risky(say!("write `{}`", right)).set(place, right.to_string())));
    }
}

//! The TPDOs of an encoder.

use crate::demands::Applied;
use crate::diagnostic::{Findings, Fix, Severity, say};
use crate::model::{DeviceKind, MappedObject, PdoKind};
use crate::rule::rules;
use crate::{Facts, MappedTo, PdoFacts};

rules! {
    "cia406/cyclic-timer-mismatch" = CYCLIC_TIMER_MISMATCH, Error, Applied(cyclic_timer_mismatch);
    summary: "the cyclic timer and the event timer of TPDO 1 differ",
    checks: "Whether 6200h and 1800h sub-index 5 have the same value if both are described.",
    why: "Both objects access one timer, so one of the values is wrong, and the start-up value of the encoder is ambiguous.",
    example: "`[6200]` with `DefaultValue=100`, `[1800sub5]` with `DefaultValue=0`",
    remedy: "Write the same time, in milliseconds.",
    source: "CiA 406 (6200h, 1800h)",

    "cia406/wrong-default-mapping" = WRONG_DEFAULT_MAPPING, Error, Applied(wrong_default_mapping), fix Unsafe;
    summary: "a TPDO of an encoder does not carry the position",
    checks: "Whether TPDO 1 and TPDO 2 of an EDS carry the position and nothing else: 6004h with 32 bits, 6008h with 64 bits in encoders of high precision, 6020h sub-index 1 in those with several sensors. Further objects after the position are a warning. TPDO 2 is not checked if there is a TPDO 3, which was the synchronous one before edition 3. PDOs with invalid entries are not checked.",
    why: "Encoders are interchangeable because the position is in the first four bytes of TPDO 1.",
    example: "`[1A00sub1]` with `DefaultValue=0x65030010`",
    remedy: "Write `0x60040020`, in the description and in the device.",
    source: "CiA 406 (1A00h, 1A01h)",

    "cia406/wrong-transmission-type" = WRONG_TRANSMISSION_TYPE, Warning,
        Applied(wrong_transmission_type), fix Unsafe;
    summary: "a TPDO of an encoder has a transmission type other than that of CiA 406",
    checks: "Whether TPDO 1 of an EDS is sent by its timer (transmission type 254; 255 is accepted) and TPDO 2 on each SYNC (type 1). TPDO 2 is not checked if there is a TPDO 3, which was the synchronous one before edition 3.",
    why: "A master that knows the profile expects TPDO 1 asynchronously and TPDO 2 with each SYNC.",
    example: "`[1800sub2]` with `DefaultValue=1`",
    remedy: "Write 254 for TPDO 1 and 1 for TPDO 2.",
    source: "CiA 406 (1800h, 1801h)",
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

/// The object with the position, in its different formats.
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
                "{} maps {} bits of {:04X}h:{:02X}, CiA 406 maps {}",
                pdo.pdo,
                bits,
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

/// Whether the mapping is stated and not reported by another rule.
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

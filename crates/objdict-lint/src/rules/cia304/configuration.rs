//! The protection of the SRDO configuration, and the flag for CANopen Safety.

use crate::diagnostic::{Findings, say};
use crate::model::{Field, Part, Place};
use crate::rule::rules;
use crate::{Facts, Srdo, stated};

rules! {
    source: "EN 50325-5 (CiA 304)";

    "cia304/checksum-missing" = CHECKSUM_MISSING, Error, Facts(checksum_missing);
    summary: "13FFh has no checksum for an SRDO",
    checks: "Whether 13FFh has a sub-index for each SRDO of the device: sub-index 1 for 1301h, and so on.",
    why: "The configuration of an SRDO without a checksum can never become valid.",
    example: "`[1302]` and a 13FFh with one element",
    remedy: "Describe an element for each SRDO.",

    "cia304/missing-safety-object" = MISSING_SAFETY_OBJECT, Error, Facts(missing_safety_object);
    summary: "a device with SRDOs lacks the objects that protect their configuration",
    checks: "Whether a device with SRDOs has 13FEh, the validity of the configuration, and 13FFh, its checksums.",
    why: "A configuration tool writes the checksums and then marks the configuration valid. Without these objects the device can never transmit or accept an SRDO.",
    example: "`[1301]` and `[1381]` without `[13FF]`",
    remedy: "Add 13FEh, an UNSIGNED8, and 13FFh, an ARRAY of UNSIGNED16 with an element for each SRDO.",

    "cia304/safety-flag" = SAFETY_FLAG, Warning, Facts(safety_flag);
    summary: "`CANopenSafetySupported` contradicts the objects",
    checks: "Whether a device with `CANopenSafetySupported=1` has SRDOs, and one with `CANopenSafetySupported=0` has none.",
    why: "A safety tool evaluates the flag: it finds nothing to configure, or ignores SRDOs that it must configure.",
    example: "`CANopenSafetySupported=1` without an object from 1301h to 1340h",
    remedy: "Correct the flag, or the objects.",
    source: "CiA 306-1 annex A, EN 50325-5 (CiA 304)",

    "cia304/wrong-checksum" = WRONG_CHECKSUM, Warning, Facts(wrong_checksum);
    summary: "the checksum of a valid configuration is wrong",
    checks: "Whether the checksum in 13FFh of each active SRDO matches its parameters if 13FEh marks the configuration as valid (A5h): a 16-bit CRC with the polynomial 1021h and start value 0 over direction, refresh time, validation time, both COB-IDs, the number of mapped objects, and sub-index and value of each mapping entry. SRDOs with missing values are not checked.",
    why: "At power-up the device calculates the checksum, detects the difference and sends no safety data.",
    example: "`[13FE]` with `DefaultValue=0xA5` and `[13FFsub1]` with `DefaultValue=0`",
    remedy: "Verify the configuration and write the reported checksum; or write 0 to 13FEh.",
}

fn checksum_missing(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(object) =
        facts.device.object(0x13FF).filter(|object| !object.orphan && object.object_type().has_subs())
    else {
        return;
    };
    let number = |srdo: &crate::Srdo<'_>| u8::try_from(srdo.number).unwrap_or(u8::MAX);
    if let Some(srdo) = facts.srdos.iter().find(|srdo| !object.has(number(srdo))) {
        let message = say!("13FFh has no sub-index {} for the checksum of {}", srdo.number, srdo);
        let finding = CHECKSUM_MISSING.at(Place::object(0x13FF), message);
        findings.push(finding.help("describe an element for each SRDO"));
    }
}

fn missing_safety_object(facts: &Facts<'_>, findings: &mut Findings) {
    let Some(first) = facts.srdos.first() else { return };
    let place = match first.communication {
        Some(_) => Place::object(first.communication_index()),
        None => Place::object(first.mapping_index()),
    };
    for (index, name) in [(0x13FE, "configuration valid"), (0x13FF, "safety configuration checksum")] {
        if !stated::is_there(facts.device, index) {
            let message = say!("the device has SRDOs but no {:04X}h ({})", index, name);
            findings.push(MISSING_SAFETY_OBJECT.at(place.clone(), message).help(say!("add {:04X}h", index)));
        }
    }
}

fn safety_flag(facts: &Facts<'_>, findings: &mut Findings) {
    let info = facts.device.device_info.as_ref();
    let Some(supported) = info.and_then(|info| info.safety_supported) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::CanOpenSafetySupported);
    let finding = match (supported, facts.srdos.first()) {
        (true, None) => SAFETY_FLAG.at(place, "the device supports SRDOs but has no SRDO objects"),
        (false, Some(srdo)) => {
            let finding = SAFETY_FLAG.at(place, say!("the device has {} but does not support SRDOs", srdo));
            finding.label(Place::object(srdo.first_index()), "the SRDO")
        }
        _ => return,
    };
    findings.push(finding.help("correct the flag, or the SRDO objects"));
}

fn wrong_checksum(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.number(0x13FE, 0) != Some(0xA5) {
        return;
    }
    for srdo in facts.srdos.iter().filter(|srdo| srdo.is_on()) {
        let Ok(sub) = u8::try_from(srdo.number) else { continue };
        let (Some(stated), Some(right)) = (facts.number(0x13FF, sub), checksum(facts, srdo)) else {
            continue;
        };
        if stated != i128::from(right) {
            let message = say!(
                "the checksum of {} is `0x{:04X}`, but its parameters yield 0x{:04X}",
                srdo,
                stated,
                right
            );
            let finding = WRONG_CHECKSUM
                .at(facts.device.value_place(0x13FF, sub), message)
                .label(facts.device.value_place(0x13FE, 0), "the configuration is marked valid");
            findings.push(finding.help("verify the configuration and write its checksum"));
        }
    }
}

/// The checksum over all parameters of an SRDO; `None` if one of them is unknown.
fn checksum(facts: &Facts<'_>, srdo: &Srdo<'_>) -> Option<u16> {
    let count = srdo.mapped_count.filter(|&count| count <= 16)?;
    let mut bytes = Vec::with_capacity(100);
    bytes.push(u8::try_from(srdo.number(1)?).ok()?);
    bytes.extend(u16::try_from(srdo.number(2)?).ok()?.to_le_bytes());
    bytes.push(u8::try_from(srdo.number(3)?).ok()?);
    for sub in [5, 6] {
        // the device adds its node-ID to default values below 101h
        let cob_id = srdo.cob_id(&facts.node_ids(), sub).filter(|&cob_id| cob_id > 0x100)?;
        bytes.extend(u32::try_from(cob_id).ok()?.to_le_bytes());
    }
    bytes.push(count);
    for sub in 1..=count {
        let slot = srdo.slots.iter().find(|slot| slot.sub == sub)?;
        bytes.push(sub);
        bytes.extend(slot.object?.to_number().to_le_bytes());
    }
    Some(crc(&bytes))
}

/// CRC-16: polynomial 1021h, initial value 0, most significant bit first.
fn crc(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |crc, &byte| {
        (0..8).fold(
            crc ^ u16::from(byte) << 8,
            |crc, _| if crc & 0x8000 == 0 { crc << 1 } else { crc << 1 ^ 0x1021 },
        )
    })
}

//! The communication parameters of SRDOs, the protection of their configuration and the flag for CANopen Safety.

use crate::diagnostic::{Findings, Fix, Severity, say};
use crate::model::{DeviceKind, Field, Part, Place};
use crate::rule::rules;
use crate::{Facts, Srdo, stated};

rules! {
    source: "EN 50325-5 (CiA 304)";

    "cia304/checksum-missing" = CHECKSUM_MISSING, Error, Facts(checksum_missing);
    summary: "13FFh has no checksum for an SRDO",
    checks: "13FFh must have a sub-index for each SRDO of the device: sub-index 1 for 1301h, and so on.",
    why: "The configuration of an SRDO without a checksum can never become valid.",
    example: "`[1302]` and a 13FFh with one element",
    remedy: "Describe an element for each SRDO.",

    "cia304/cob-id-collision" = COB_ID_COLLISION, Error, Facts(cob_id_collision);
    summary: "two SRDOs of the device have the same COB-ID",
    checks: "The COB-IDs of all active SRDOs (information direction 1 or 2) must differ.",
    why: "The device cannot distinguish the two SRDOs; one that is sent disturbs one that is received.",
    example: "`[1301sub5]` and `[1302sub5]`, both with `DefaultValue=0x101`",
    remedy: "Give each SRDO its own pair of COB-IDs.",

    "cia304/incomplete-srdo-parameter" = INCOMPLETE_SRDO_PARAMETER, Error, Facts(incomplete_srdo_parameter);
    summary: "an SRDO communication parameter lacks a sub-index",
    checks: "Each object from 1301h to 1340h must have the sub-indexes 1 to 6.",
    why: "All of them are part of the safety configuration and its checksum, and none has an implicit value.",
    example: "`[1301]` with only sub-indexes 0 to 4",
    remedy: "Describe the missing sub-index.",

    "cia304/invalid-cob-id-pair" = INVALID_COB_ID_PAIR, Error, Facts(invalid_cob_id_pair);
    summary: "the two COB-IDs of an SRDO are not a valid pair",
    checks: "COB-ID 1 of each active SRDO must be an odd CAN-ID from 101h to 17Fh, and COB-ID 2 must be the next one. A formula is evaluated for the node of a DCF. In an EDS, the defaults FFh and 100h are accepted, because stacks add twice the node-ID to them.",
    why: "The data are sent twice, plain and inverted, with identifiers that differ in at least two bits, so that a corrupted frame is never accepted as its counterpart. A device rejects any other pair.",
    example: "`[1301sub5]` with `DefaultValue=0x101` and `[1301sub6]` with `DefaultValue=0x103`",
    remedy: "Write an odd CAN-ID and the next one; the default of the standard is FFh and 100h plus twice the node-ID.",

    "cia304/invalid-direction" = INVALID_DIRECTION, Error, Facts(invalid_direction);
    summary: "the information direction of an SRDO is not valid",
    checks: "The information direction of each SRDO must be 0 (not valid), 1 (transmit) or 2 (receive).",
    why: "The device rejects any other value, and tools do not know whether it transmits the SRDO.",
    example: "`[1301sub1]` with `DefaultValue=3`",
    remedy: "Write 0, 1 or 2.",

    "cia304/invalid-time" = INVALID_TIME, Error, Facts(invalid_time);
    summary: "the times of an SRDO cannot be met",
    checks: "The refresh time (SCT for a received SRDO) and the validation time (SRVT) of each active SRDO must not be 0. The validation time must not be longer than the refresh time.",
    why: "The two frames of an SRDO must arrive within the validation time, and the next pair within the cycle time. A time of 0 can never be met. If the validation time is longer than the cycle, frames of two cycles are accepted as one pair.",
    example: "`[1301sub2]` with `DefaultValue=20` and `[1301sub3]` with `DefaultValue=50`",
    remedy: "Write times in milliseconds, with the validation time not longer than the refresh time.",

    "cia304/missing-safety-object" = MISSING_SAFETY_OBJECT, Error, Facts(missing_safety_object);
    summary: "a device with SRDOs lacks the objects that protect their configuration",
    checks: "A device with SRDOs must have 13FEh (validity of the configuration) and 13FFh (checksums).",
    why: "A configuration tool writes the checksums and then marks the configuration valid. Without these objects the device can never transmit or accept an SRDO.",
    example: "`[1301]` and `[1381]` without `[13FF]`",
    remedy: "Add 13FEh, an UNSIGNED8, and 13FFh, an ARRAY of UNSIGNED16 with an element for each SRDO.",

    "cia304/safety-flag" = SAFETY_FLAG, Warning, Facts(safety_flag);
    summary: "`CANopenSafetySupported` contradicts the objects",
    checks: "A device with `CANopenSafetySupported=1` must have SRDOs. A device with `CANopenSafetySupported=0` must have none.",
    why: "A safety tool evaluates the flag: it finds nothing to configure or ignores SRDOs that it must configure.",
    example: "`CANopenSafetySupported=1` without an object from 1301h to 1340h",
    remedy: "Correct the flag, or the objects.",
    source: "CiA 306-1 annex A, EN 50325-5 (CiA 304)",

    "cia304/srdo-without-mapping" = SRDO_WITHOUT_MAPPING, Error, Facts(srdo_without_mapping);
    summary: "an SRDO has only one of its two objects",
    checks: "Each SRDO communication parameter (1301h to 1340h) must have a mapping parameter (1381h to 13C0h), and the reverse.",
    why: "The communication parameter defines when the SRDO is sent and with which identifiers. The mapping defines its contents. The checksum of the safety configuration covers both.",
    example: "`[1301]` without `[1381]`",
    remedy: "Add the missing object.",

    "cia304/wrong-checksum" = WRONG_CHECKSUM, Warning, Facts(wrong_checksum);
    summary: "the checksum of a valid configuration is wrong",
    checks: "If 13FEh marks the configuration as valid (A5h), the checksum in 13FFh of each active SRDO must match its parameters. It is a 16-bit CRC with the polynomial 1021h and start value 0. It covers direction, refresh time, validation time, both COB-IDs, the number of mapped objects, and sub-index and value of each mapping entry. SRDOs with missing values are not checked.",
    why: "At power-up the device calculates the checksum, detects the difference and sends no safety data.",
    example: "`[13FE]` with `DefaultValue=0xA5` and `[13FFsub1]` with `DefaultValue=0`",
    remedy: "Verify the configuration and write the reported checksum, or write 0 to 13FEh.",

    "cia304/wrong-transmission-type" = WRONG_TRANSMISSION_TYPE, Error,
        Facts(wrong_transmission_type), fix Unsafe;
    summary: "the transmission type of an SRDO is not 254",
    checks: "The transmission type of each SRDO must be 254. The standard allows no other value.",
    why: "SRDOs are always sent cyclically, and their safety depends on their timing. SYNC or a remote frame must not trigger them.",
    example: "`[1301sub4]` with `DefaultValue=255`",
    remedy: "Write `0xFE` and `AccessType=const`.",
}

fn cob_id_collision(facts: &Facts<'_>, findings: &mut Findings) {
    let mut seen: Vec<(i128, usize)> = Vec::new();
    for (at, srdo) in facts.srdos.iter().enumerate().filter(|(_, srdo)| srdo.is_on()) {
        // `invalid-cob-id-pair` checks that the second COB-ID follows the first
        let Some(cob_id) = srdo.cob_id(&facts.node_ids(), 5) else { continue };
        let place = |at: usize| {
            let index = facts.srdos.get(at).map_or(0x1301, Srdo::communication_index);
            facts.device.value_place(index, 5)
        };
        match seen.iter().find(|(other, _)| *other == cob_id) {
            Some(&(_, first)) => {
                let message = say!(
                    "{} has the same COB-IDs as SRDO {}",
                    srdo,
                    facts.srdos.get(first).map_or(0, |srdo| srdo.number)
                );
                let finding = COB_ID_COLLISION.at(place(at), message).label(place(first), "first used here");
                findings.push(finding.help("give each SRDO its own pair of COB-IDs"));
            }
            None => seen.push((cob_id, at)),
        }
    }
}

const PARAMETER_SUBS: [(u8, &str); 6] = [
    (1, "information direction"),
    (2, "refresh time or SCT"),
    (3, "SRVT"),
    (4, "transmission type"),
    (5, "COB-ID 1"),
    (6, "COB-ID 2"),
];

fn incomplete_srdo_parameter(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(object) =
            srdo.communication.filter(|object| !object.orphan && object.object_type().has_subs())
        else {
            continue;
        };
        let index = srdo.communication_index();
        for (sub, name) in PARAMETER_SUBS.into_iter().filter(|(sub, _)| !object.has(*sub)) {
            let message = say!("{} is missing sub-index {} ({}) of {:04X}h", srdo, sub, name, index);
            let finding = INCOMPLETE_SRDO_PARAMETER.at(Place::object(index), message);
            findings.push(finding.help(say!("add `{}`", Part::Entry(index, sub))));
        }
    }
}

fn invalid_cob_id_pair(facts: &Facts<'_>, findings: &mut Findings) {
    let is_type = facts.device.kind == DeviceKind::Type;
    for srdo in facts.srdos.iter().filter(|srdo| srdo.is_on()) {
        let (Some(plain), Some(inverted)) =
            (srdo.cob_id(&facts.node_ids(), 5), srdo.cob_id(&facts.node_ids(), 6))
        else {
            continue;
        };
        if is_type && (plain, inverted) == (0xFF, 0x100) {
            continue;
        }
        let index = srdo.communication_index();
        let place = |sub| facts.device.value_place(index, sub);
        let is_plain = (0x101..=0x17F).contains(&plain) && plain % 2 == 1;
        let finding = if !is_plain {
            let message =
                say!("COB-ID 1 of {} is `{:X}h`, which is not an odd CAN-ID from 101h to 17Fh", srdo, plain);
            INVALID_COB_ID_PAIR.at(place(5), message)
        } else if inverted != plain + 1 {
            let message = say!(
                "COB-ID 2 of {} is `{:X}h`, which does not follow COB-ID 1 `{:X}h`",
                srdo,
                inverted,
                plain
            );
            INVALID_COB_ID_PAIR.at(place(6), message).label(place(5), "COB-ID 1")
        } else {
            continue;
        };
        findings.push(
            finding.help("write an odd CAN-ID from 101h to 17Fh as COB-ID 1 and the next one as COB-ID 2"),
        );
    }
}

fn invalid_direction(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(direction) = srdo.number(1).filter(|direction| !(0..=2).contains(direction)) else {
            continue;
        };
        let place = facts.device.value_place(srdo.communication_index(), 1);
        let message = say!("`{}` is not a valid information direction of {}", direction, srdo);
        let finding = INVALID_DIRECTION.at(place, message);
        findings.push(finding.help("write 0 (not valid), 1 (transmit) or 2 (receive)"));
    }
}

fn invalid_time(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in facts.srdos.iter().filter(|srdo| srdo.is_on()) {
        let (cycle, validation) = (srdo.number(2), srdo.number(3));
        let place = |sub| facts.device.value_place(srdo.communication_index(), sub);
        let name = if srdo.number(1) == Some(2) { "safeguard cycle time" } else { "refresh time" };
        let finding = match (cycle, validation) {
            (Some(0), _) => INVALID_TIME.at(place(2), say!("the {} of {} is 0 ms", name, srdo)),
            (_, Some(0)) => INVALID_TIME.at(place(3), say!("the validation time of {} is 0 ms", srdo)),
            (Some(cycle), Some(validation)) if validation > cycle => {
                let message = say!(
                    "the validation time of {} is {} ms, longer than its {} of {} ms",
                    srdo,
                    validation,
                    name,
                    cycle
                );
                let finding = INVALID_TIME.at(place(3), message).severity(Severity::Warning);
                finding.label(place(2), say!("the {}", name))
            }
            _ => continue,
        };
        findings.push(finding.help(
            "write times in milliseconds, with a validation time not longer than the refresh time or SCT",
        ));
    }
}

fn srdo_without_mapping(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let (there, missing, what) = match (srdo.communication, srdo.mapping) {
            (Some(_), None) => (srdo.communication_index(), srdo.mapping_index(), "mapping parameter"),
            (None, Some(_)) => (srdo.mapping_index(), srdo.communication_index(), "communication parameter"),
            _ => continue,
        };
        if stated::is_there(facts.device, missing) {
            continue;
        }
        let message = say!("{} has {:04X}h but no {:04X}h ({})", srdo, there, missing, what);
        let finding = SRDO_WITHOUT_MAPPING.at(Place::object(there), message);
        findings.push(finding.help(say!("add {:04X}h, or remove {:04X}h", missing, there)));
    }
}

fn wrong_transmission_type(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let Some(transmission_type) = srdo.number(4).filter(|&value| value != 254) else { continue };
        let place = facts.device.value_place(srdo.communication_index(), 4);
        let message = say!("the transmission type of {} is `{}`; it must be 254", srdo, transmission_type);
        let fix = Fix::risky("write `0xFE`").set(place.clone(), "0xFE");
        findings.push(WRONG_TRANSMISSION_TYPE.at(place, message).help("write `0xFE`").fix(fix));
    }
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

//! The mapping of SRDOs and the safety entries with their inverted copies.

use crate::diagnostic::{Findings, Text, counted_bits, say, sub_index};
use crate::model::{DataType, Device, Field, MappedObject, Place};
use crate::rule::rules;
use crate::{Facts, MappedTo, Srdo};

rules! {
    source: "EN 50325-5 (CiA 304)";

    "cia304/invalid-inverted-object" = INVALID_INVERTED_OBJECT, Error, Device(invalid_inverted_object);
    summary: "the inverted entry of a safety entry is missing or not suitable",
    checks: "`InvertedSRAD` must refer to a described entry, other than itself, of the same data type.",
    why: "A tool that creates an SRDO maps the entry together with its `InvertedSRAD`. If it is wrong, the receiver compares unrelated values.",
    example: "`InvertedSRAD=0x610101` without `[6101sub1]`",
    remedy: "Write index and sub-index of the inverted entry as six hex digits.",
    source: "CiA 306-1 annex A",

    "cia304/mapped-object-missing" = MAPPED_OBJECT_MISSING, Error, Facts(mapped_object_missing);
    summary: "an SRDO maps an object that does not exist",
    checks: "Each object that an SRDO maps must be described. Dummy entries and objects that modules may provide are not checked.",
    why: "The device rejects the mapping, or the description lacks a part of the safety function.",
    example: "`[1381sub1]` with `DefaultValue=0x61000108`, without `[6100]`",
    remedy: "Describe the object, or map the intended one.",

    "cia304/object-not-safe" = OBJECT_NOT_SAFE, Warning, Facts(object_not_safe);
    summary: "an SRDO maps an entry that is not mappable to SRDOs",
    checks: "In a description that uses `SRDOMapping` at all, each entry that an SRDO maps must have `SRDOMapping=1`.",
    why: "A tool that configures the SRDO does not offer the entry and rejects the existing mapping.",
    example: "`[1381sub1]` maps an entry with `SRDOMapping=0`",
    remedy: "Write `SRDOMapping=1`, or map a different entry.",
    source: "CiA 306-1 annex A, EN 50325-5 (CiA 304)",

    "cia304/srdo-length-exceeded" = SRDO_LENGTH_EXCEEDED, Error, Facts(srdo_length_exceeded);
    summary: "an SRDO is longer than 64 bits",
    checks: "The total length of an SRDO's plain objects must be at most 64 bits. The same applies to its inverted objects.",
    why: "A CAN frame has eight data bytes.",
    example: "nine pairs of 8 bits in `[1381]`",
    remedy: "Remove objects, or move them to a different SRDO.",

    "cia304/unequal-pair" = UNEQUAL_PAIR, Error, Facts(unequal_pair);
    summary: "the two objects of a pair in an SRDO have different lengths",
    checks: "The inverted object of each mapped pair (even sub-index) must have the length of the plain object (odd sub-index).",
    why: "The receiver compares the two frames bit by bit. After objects of different lengths it compares unrelated bits, and the device enters its safe state.",
    example: "`[1381sub1]` with `DefaultValue=0x61000108` and `[1381sub2]` with `DefaultValue=0x61010110`",
    remedy: "Map the matching inverted object.",

    "cia304/wrong-mapping-count" = WRONG_MAPPING_COUNT, Error, Facts(wrong_mapping_count);
    summary: "the number of mapped objects of an SRDO is not valid",
    checks: "Sub-index 0 of each SRDO mapping must be an even number from 0 to 16. Each entry within this number must be described and must contain an object.",
    why: "Entries are pairs of a plain and an inverted object. A device rejects an odd number and an entry without an object.",
    example: "`[1381sub0]` with `DefaultValue=3`",
    remedy: "Map the inverted object of each plain one and count both.",

    "cia304/wrong-mapping-length" = WRONG_MAPPING_LENGTH, Error, Facts(wrong_mapping_length);
    summary: "the length in an SRDO mapping differs from the length of the object",
    checks: "The length in each SRDO mapping entry must match the data type of the object.",
    why: "The device rejects the mapping or reads the following objects from the wrong position of the frame.",
    example: "`[1381sub1]` with `DefaultValue=0x61000110`, where 6100h sub-index 1 is UNSIGNED8",
    remedy: "Write the length of the data type in bits as the last two digits.",
}

fn invalid_inverted_object(device: &Device, findings: &mut Findings) {
    for (&index, object) in &device.objects {
        for (sub, entry) in object.described().filter(|(_, entry)| entry.safety.is_some()) {
            let Some(srad) = entry.safety.as_ref().and_then(|safety| safety.inverted_srad) else { continue };
            let part = Place::at(index, sub);
            let Some(what) = inversion_problem(device, (index, sub.unwrap_or(0)), srad, entry.data_type)
            else {
                continue;
            };
            let message = say!("`0x{:06X}` is not a valid inverted entry: {}", srad, what);
            let finding = INVALID_INVERTED_OBJECT.at(part.field(Field::InvertedSrad), message);
            findings.push(finding.help("write index and sub-index of the inverted entry as six hex digits"));
        }
    }
}

fn inversion_problem(
    device: &Device,
    own: (u16, u8),
    srad: u32,
    data_type: Option<DataType>,
) -> Option<Text> {
    let [sub, low, high, above] = srad.to_le_bytes();
    let named = (u16::from_le_bytes([low, high]), sub);
    if above != 0 {
        return Some("the address has more than six digits".into());
    }
    if named == own {
        return Some("the address is the entry's own".into());
    }
    let Some(inverted) = device.entry(named.0, named.1) else {
        return (!device.is_modular()).then(|| "there is no such entry".into());
    };
    match (data_type, inverted.data_type) {
        (Some(plain), Some(other)) if plain != other => {
            Some(say!("its data type is {} instead of {}", other, plain))
        }
        _ => None,
    }
}

/// The mapping entries in use of all SRDOs, with their places and targets.
fn mapped_entries<'a>(
    facts: &'a Facts<'_>,
) -> impl Iterator<Item = (&'a Srdo<'a>, Place, MappedObject, MappedTo<'a>)> {
    facts.srdos.iter().flat_map(move |srdo| {
        srdo.mapped().map(move |(sub, mapped)| {
            let place = facts.device.value_place(srdo.mapping_index(), sub);
            (srdo, place, mapped, MappedTo::of(facts.device, mapped))
        })
    })
}

fn mapped_object_missing(facts: &Facts<'_>, findings: &mut Findings) {
    for (srdo, place, mapped, target) in mapped_entries(facts) {
        let what = match target {
            MappedTo::NoObject => "but there is no such object",
            MappedTo::NoEntry => "but the object has no such sub-index",
            MappedTo::Count => "the number of entries of an array or record",
            _ => continue,
        };
        let message = say!("{} maps {:04X}h:{:02X}, {}", srdo, mapped.index, mapped.sub, what);
        let finding = MAPPED_OBJECT_MISSING.at(place, message);
        findings.push(finding.help("describe the object, or map the intended one"));
    }
}

fn object_not_safe(facts: &Facts<'_>, findings: &mut Findings) {
    if facts.srdos.is_empty() || !uses_srdo_mapping(facts.device) {
        return;
    }
    for (srdo, place, mapped, target) in mapped_entries(facts) {
        let MappedTo::Entry(entry) = target else { continue };
        if entry.safety.as_ref().and_then(|safety| safety.srdo_mapping) == Some(true) {
            continue;
        }
        let message =
            say!("{} maps {:04X}h:{:02X}, which is not mappable to SRDOs", srdo, mapped.index, mapped.sub);
        let finding = OBJECT_NOT_SAFE.at(place, message);
        let part = facts.device.value_place(mapped.index, mapped.sub).part;
        findings.push(finding.help(say!("write `{SRDOMapping=1}` in `{}`, or map a different entry", part)));
    }
}

fn uses_srdo_mapping(device: &Device) -> bool {
    let says = |entry: &crate::model::Entry| {
        entry.safety.as_ref().is_some_and(|safety| safety.srdo_mapping == Some(true))
    };
    device.objects.values().any(|object| object.described().any(|(_, entry)| says(entry)))
}

fn srdo_length_exceeded(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let bits: u32 = srdo.pairs().map(|(plain, _)| u32::from(plain.1.bits)).sum();
        if bits > 64 {
            let place = facts.device.value_place(srdo.mapping_index(), 0);
            let message = say!("{} maps {} bits, more than the 64 bits of a CAN frame", srdo, bits);
            let finding = SRDO_LENGTH_EXCEEDED.at(place, message);
            findings.push(finding.help("remove objects, or move them to another SRDO"));
        }
    }
}

fn unequal_pair(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        for (plain, inverted) in srdo.pairs().filter(|(plain, inverted)| plain.1.bits != inverted.1.bits) {
            let place = |sub| facts.device.value_place(srdo.mapping_index(), sub);
            let message = say!(
                "{} maps {} with the inverted object {}, whose length differs",
                srdo,
                plain.1,
                inverted.1
            );
            let finding =
                UNEQUAL_PAIR.at(place(inverted.0), message).label(place(plain.0), "the plain object");
            findings.push(finding.help("map the matching inverted object"));
        }
    }
}

fn wrong_mapping_count(facts: &Facts<'_>, findings: &mut Findings) {
    for srdo in &facts.srdos {
        let (Some(count), Some(object)) = (srdo.mapped_count, srdo.mapping) else { continue };
        let index = srdo.mapping_index();
        let place = facts.device.value_place(index, 0);
        let finding = if count > 16 {
            let message = say!("{} maps `{}` objects, but 16 is the maximum", srdo, count);
            WRONG_MAPPING_COUNT.at(place, message).help("write 0, or an even number up to 16")
        } else if count % 2 == 1 {
            let message = say!("{} maps `{}` objects, an odd number", srdo, count);
            WRONG_MAPPING_COUNT.at(place, message).help("map the inverted object of each plain one")
        } else {
            let is_filled = |sub: u8| {
                srdo.slots
                    .iter()
                    .any(|slot| slot.sub == sub && slot.object.is_some_and(|object| !object.is_unused()))
            };
            let Some(sub) = (1..=count).find(|&sub| !is_filled(sub)) else { continue };
            let what = if object.has(sub) { "is empty" } else { "is not described" };
            let message = say!(
                "{} maps `{}` objects, but sub-index {} of {:04X}h {}",
                srdo,
                count,
                sub_index(sub),
                index,
                what
            );
            WRONG_MAPPING_COUNT
                .at(place, message)
                .help("describe the entry with its object, or write a smaller number")
        };
        findings.push(finding);
    }
}

fn wrong_mapping_length(facts: &Facts<'_>, findings: &mut Findings) {
    for (srdo, place, mapped, target) in mapped_entries(facts) {
        let MappedTo::Entry(entry) = target else { continue };
        let Some(data_type) = entry.data_type else { continue };
        let Some(bits) = data_type.bit_length().filter(|&bits| bits != mapped.bits) else { continue };
        let message =
            say!("{} maps {}, but its data type {} has {}", srdo, mapped, data_type, counted_bits(bits));
        let finding = WRONG_MAPPING_LENGTH.at(place, message);
        let right = u64::from(mapped.to_number() & !0xFF) | u64::from(bits);
        findings.push(finding.help(say!("write `0x{:08X}`", right)));
    }
}

//! The mapping of a PDO as a whole: its number of entries, length and access types; multiplexed PDOs with their scanner and
//! dispatching lists.

use std::collections::HashMap;

use crate::diagnostic::{Argument, Findings, Fix, Text, say, sub_index};
use crate::model::{Access, Device, Field, MappedObject, Object, Part, Pdo, PdoKind, Place};
use crate::rule::rules;
use crate::{Facts, PdoFacts, is_unstated, stated};

rules! {
    source: "CiA 301 §7.5.2.35 to §7.5.2.38";

    "cia301/gap-in-mapping" = GAP_IN_MAPPING, Note, Pdo(gap_in_mapping);
    summary: "the sub-indexes of a PDO mapping have a gap",
    checks: "The described sub-indexes of each PDO mapping beyond those in use must be consecutive. A gap in the sub-indexes in use has its own rule.",
    why: "Objects are mapped in consecutive sub-indexes, so the sub-indexes after a gap cannot be used.",
    example: "`[1A00sub1]` and `[1A00sub3]` without `[1A00sub2]`",
    remedy: "Describe the missing sub-index, or remove the sub-indexes after the gap.",
    source: "CiA 301 §7.5.2.36, table 69",

    "cia301/granularity-against-access" = GRANULARITY_AGAINST_ACCESS, Warning,
        Facts(granularity_against_access), fix Unsafe;
    summary: "`Granularity` contradicts the access types of the PDO mappings",
    checks: "`Granularity` must be 0 if no PDO mapping is writable. It must not be 0 if a mapping is writable. A partly writable mapping has its own rule.",
    why: "Tools read `Granularity` to decide whether the mapping can be changed. With 0 they do not offer the change. With any other value they offer a change that the device rejects.",
    example: "`Granularity=0`, and `[1A00sub0]` and `[1A00sub1]` with `AccessType=rw`",
    remedy: "Write 0 for a fixed mapping, 8 for a mapping of whole bytes, 1 for a mapping of single bits.",
    source: "CiA 306-1 §4.5",

    "cia301/listed-entry-missing" = LISTED_ENTRY_MISSING, Error, ObjectOf(listed_entry_missing);
    summary: "a list for multiplexed PDOs refers to an entry that does not exist",
    checks: "Each value of an object scanner list (1FA0h to 1FCFh) must refer to described entries, with all sub-indexes of its block. The same applies to the local entry of each value of an object dispatching list (1FD0h to 1FFFh). Modular devices are not checked.",
    why: "The device cannot send the entry and discards data received for it.",
    example: "`[1FA0sub1]` with `DefaultValue=0x01200001`, without `[2000sub1]`",
    remedy: "Describe the entry, or write 0 to an unused element of the list.",
    source: "CiA 301 §7.5.2.39, §7.5.2.40",

    "cia301/mappable-without-pdo" = MAPPABLE_WITHOUT_PDO, Warning, Device(mappable_without_pdo);
    summary: "entries are mappable, but the device has no PDO in their direction",
    checks: "A device with PDOs must have a TPDO for entries with `PDOMapping=1` and access `ro` or `rwr`. It must have an RPDO for entries with `PDOMapping=1` and access `wo` or `rww`. PDOs may be described or implied by `CompactPDO`. Modular devices and objects below 2000h are not checked.",
    why: "Tools offer the entries for mapping, but no PDO can carry them. Often the description lacks PDOs.",
    example: "`AccessType=rww` and `PDOMapping=1` in `[2000]` of a device with only TPDOs",
    remedy: "Describe the PDOs, or write `PDOMapping=0`.",

    "cia301/mapping-beyond-count" = MAPPING_BEYOND_COUNT, Note, Pdo(mapping_beyond_count);
    summary: "a PDO mapping has more entries than its sub-index 0 specifies",
    checks: "The entries of a PDO mapping above the number in sub-index 0 must be 0 or empty. A mapping with 0 objects is disabled and may keep its entries.",
    why: "The entries seem to be mapped but are not. Often sub-index 0 was not increased when an entry was added.",
    example: "`[1A00sub0]` with `DefaultValue=1`, and `[1A00sub2]` with `DefaultValue=0x60000208`",
    remedy: "Increase sub-index 0, or write 0 to the entry.",
    source: "CiA 301 §7.5.2.36 table 69",

    "cia301/mapping-without-count" = MAPPING_WITHOUT_COUNT, Warning, Pdo(mapping_without_count);
    summary: "the number of mapped objects of a PDO is missing",
    checks: "Sub-index 0 of each read-only PDO mapping must have a value.",
    why: "Tools read the contents of such a PDO from the description. Without the number of objects they cannot show it.",
    example: "`[1A00sub0]` with `AccessType=const` and no `DefaultValue`",
    remedy: "Write the number of mapped objects.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "cia301/mapping-without-valid-bit" = MAPPING_WITHOUT_VALID_BIT, Note, Pdo(mapping_without_valid_bit);
    summary: "a PDO mapping is writable, but its COB-ID is not",
    checks: "If the mapping of a PDO is writable, its COB-ID must be writable too.",
    why: "A mapping may only be changed while the PDO is not valid (bit 31 of the COB-ID set). If the bit cannot be written, devices reject a changed mapping, or tools do not attempt the change.",
    example: "`[1800sub1]` with `AccessType=const` and `[1A00sub0]` with `AccessType=rw`",
    remedy: "Make the COB-ID `rw`, or the mapping `const`.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38",

    "cia301/mixed-mapping-access" = MIXED_MAPPING_ACCESS, Warning, Pdo(mixed_mapping_access);
    summary: "a PDO mapping is only partly writable",
    checks: "Sub-index 0 and the entries of a PDO mapping must be all writable or all read-only.",
    why: "To change an entry, a tool first writes 0 to sub-index 0 and finally the new number. If sub-index 0 is constant, the entries cannot be changed in spite of their access type. If the entries are constant, changing the number is useless.",
    example: "`[1A00sub0]` with `AccessType=ro`, and `[1A00sub1]` with `AccessType=rw`",
    remedy: "Use the access of the device for all sub-indexes: `rw` for a changeable mapping, otherwise `const` or `ro`.",
    source: "CiA 301 §7.5.2.36",

    "cia301/multiplexed-pdo-transmission-type" = MULTIPLEXED_PDO_TRANSMISSION_TYPE, Warning,
        Pdo(multiplexed_pdo_transmission_type);
    summary: "a multiplexed PDO has a synchronous transmission type",
    checks: "The transmission type of each multiplexed PDO (sub-index 0 of the mapping is 254 or 255) must be 254 or 255.",
    why: "A multiplexed PDO transmits one entry per frame when that entry changes. SYNC cannot trigger it.",
    example: "`[1A00sub0]` with `DefaultValue=255` and `[1800sub2]` with `DefaultValue=1`",
    remedy: "Write 254 or 255.",
    source: "CiA 301 §7.2.2.6, §7.5.2.36",

    "cia301/multiplexed-pdo-without-list" = MULTIPLEXED_PDO_WITHOUT_LIST, Error,
        Facts(multiplexed_pdo_without_list);
    summary: "a multiplexed PDO in source address mode has no list",
    checks: "If a TPDO mapping has 254 in sub-index 0, the device must have an object scanner list (1FA0h to 1FCFh). If an RPDO mapping has 254, the device must have an object dispatching list (1FD0h to 1FFFh).",
    why: "In source address mode, the lists define the entries to send and the destinations of received entries. Without them nothing is sent, and received data are discarded.",
    example: "`[1600sub0]` with `DefaultValue=254`, without `[1FD0]`",
    remedy: "Add the list, or write 255 to sub-index 0. This selects destination address mode, which needs no list.",
    source: "CiA 301 §7.2.2.6, §7.5.2.39, §7.5.2.40",

    "cia301/pdo-length-exceeded" = PDO_LENGTH_EXCEEDED, Error, Pdo(pdo_length_exceeded);
    summary: "a PDO is longer than 64 bits",
    checks: "The total length of the mapped objects of a PDO must be at most 64 bits. Missing objects and wrong lengths have their own rules.",
    why: "A CAN frame has eight data bytes. The device rejects the mapping with abort 0604 0042h when sub-index 0 is written.",
    example: "five UNSIGNED16 in `[1A00]`",
    remedy: "Move objects to a different PDO.",
    source: "CiA 301 §7.5.2.36",

    "cia301/same-mapping" = SAME_MAPPING, Warning, Facts(same_mapping);
    summary: "two PDOs map the same objects",
    checks: "Two valid PDOs of the same direction and transmission type must not map the same objects in the same order. Encoders (CiA 406) send their position in two PDOs and are not checked.",
    why: "A second TPDO sends the data of the first one again, and a second RPDO overwrites them. Mostly the mapping was copied and not adapted, so the intended objects are in no PDO.",
    example: "`DefaultValue=0x64010110` in `[1A00sub1]` and `[1A01sub1]`, which are the only objects of TPDO 1 and 2",
    remedy: "Map the missing objects, or set bit 31 of one PDO's COB-ID.",

    "cia301/valid-pdo-without-mapping" = VALID_PDO_WITHOUT_MAPPING, Warning, Pdo(valid_pdo_without_mapping);
    summary: "a valid PDO maps no objects",
    checks: "A PDO that maps 0 objects must not be valid: bit 31 of its COB-ID must be set.",
    why: "A TPDO without objects sends empty frames, or the device rejects it; an RPDO occupies a CAN-ID without use.",
    example: "`[1801sub1]` with `DefaultValue=$NODEID+0x280`, and `[1A01sub0]` with `DefaultValue=0`",
    remedy: "Set bit 31 of the COB-ID, or map an object.",

    "cia301/wrong-mapping-count" = WRONG_MAPPING_COUNT, Error, Pdo(wrong_mapping_count), fix Unsafe;
    summary: "the number of mapped objects is out of range or greater than the number of entries",
    checks: "Sub-index 0 of each PDO mapping must be 0 to 64, or 254 or 255 for a multiplexed PDO. Each entry within this number must be described and must contain an object.",
    why: "A device rejects a number greater than its entries. Tools show a frame with gaps.",
    example: "`[1A00sub0]` with `DefaultValue=3`, without `[1A00sub3]`",
    remedy: "Write the number of entries in use, counted from sub-index 1 without gaps.",
    source: "CiA 301 §7.5.2.36 table 69",
}

fn gap_in_mapping(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let mut expected = 1..=64u8;
    let Some(slot) = pdo.slots.iter().find(|slot| expected.next() != Some(slot.sub)) else { return };
    let missing = pdo.slots.iter().take_while(|other| other.sub < slot.sub).count();
    let missing = u8::try_from(missing + 1).unwrap_or(u8::MAX);
    let counts = pdo.mapped_count.is_some_and(|count| (missing..=64).contains(&count));
    if counts || pdo.is_multiplexed() {
        return;
    }
    let index = pdo.mapping_index();
    let message =
        say!("{:04X}h has sub-index {} but no sub-index {}", index, sub_index(slot.sub), sub_index(missing));
    let finding = GAP_IN_MAPPING.at(Place::entry(index, slot.sub), message);
    findings.push(
        finding.help(say!("add `{}`, or remove the sub-indexes after it", Part::Entry(index, missing))),
    );
}

fn granularity_against_access(facts: &Facts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let Some(granularity) = granularity.filter(|&granularity| granularity <= 64) else { return };
    let described = facts.pdos.iter().filter_map(|PdoFacts { pdo, .. }| Some((pdo, pdo.mapping?)));
    let known: Vec<_> =
        described.filter_map(|(pdo, object)| Some((pdo, is_mapping_writable(object)?))).collect();
    let (message, help, related) = match granularity {
        0 => {
            let Some((pdo, _)) = known.iter().find(|(_, writable)| *writable) else { return };
            let message = "`0` means a fixed PDO mapping, but the mapping is writable".into();
            let help =
                say!("write `{Granularity=8}` if whole bytes can be mapped, or make the mapping `const`");
            (message, help, (pdo, "this mapping is writable"))
        }
        _ => {
            let all_fixed = known.len() == facts.pdos.len() && known.iter().all(|(_, writable)| !writable);
            let Some((pdo, _)) = known.first().filter(|_| all_fixed) else { return };
            let message = say!("`{}` allows PDO mapping changes, but no mapping is writable", granularity);
            (
                message,
                say!("write `{Granularity=0}` for a fixed mapping"),
                (pdo, "this mapping is not writable"),
            )
        }
    };
    let place = Place::of(Part::DeviceInfo).field(Field::Granularity);
    let (pdo, text) = related;
    let value = if granularity == 0 { "8" } else { "0" };
    let fix = Fix::risky(say!("write `{}`", Argument::setting(Field::Granularity, value)))
        .set(place.clone(), value);
    let finding = GRANULARITY_AGAINST_ACCESS.at(place, message).help(help).fix(fix);
    findings.push(finding.label(Place::object(pdo.mapping_index()), text));
}

/// Whether the whole mapping is writable; `None` if its access types are missing or differ.
fn is_mapping_writable(object: &Object) -> Option<bool> {
    let mut accesses = object.entries().filter(|(sub, _)| *sub <= 64);
    // sub-index 0 of a compactly stored mapping is read-only by definition
    let skipped = usize::from(object.compact.is_some());
    let first = accesses.nth(skipped)?.1.access.map(Access::is_writable)?;
    accesses.all(|(_, entry)| entry.access.map(Access::is_writable) == Some(first)).then_some(first)
}

fn mappable_without_pdo(device: &Device, findings: &mut Findings) {
    let [rpdo, tpdo] = PdoKind::ALL.map(|kind| has_pdo(device, kind));
    let (missing, fits): (PdoKind, fn(Access) -> bool) = match (rpdo, tpdo) {
        (true, false) => (PdoKind::Tpdo, |access| access.fits_tpdo() && !access.fits_rpdo()),
        (false, true) => (PdoKind::Rpdo, |access| access.fits_rpdo() && !access.fits_tpdo()),
        _ => return,
    };
    if device.is_modular() || device.dynamic_channels.is_some() {
        return;
    }
    let mut entries = device.objects.range(0x2000..).flat_map(|(&index, object)| {
        let place = move |sub: Option<u8>| Place::at(index, sub);
        object.described().map(move |(sub, entry)| (place(sub), entry))
    });
    let found = entries.find(|(_, entry)| {
        let has_length = entry.data_type.is_some_and(|data_type| data_type.bit_length().is_some());
        entry.is_mappable() && has_length && entry.access.is_some_and(fits)
    });
    let Some((place, _)) = found else { return };
    let message = say!("the entry is mappable to {}s, but the device has none", missing);
    let finding = MAPPABLE_WITHOUT_PDO.at(place.field(Field::PdoMapping), message);
    findings.push(finding.help(say!("describe the PDOs, or write `{PDOMapping=0}`")));
}

fn has_pdo(device: &Device, kind: PdoKind) -> bool {
    let info = device.device_info.as_ref();
    let declared = info.and_then(|info| match kind {
        PdoKind::Rpdo => info.rpdo_count,
        PdoKind::Tpdo => info.tpdo_count,
    });
    // another rule reports a count without objects
    declared.is_some_and(|count| count > 0) || device.pdos().any(|pdo| pdo.kind == kind)
}

fn mapping_beyond_count(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(count) = pdo.pdo.mapped_count.filter(|count| (1..=64).contains(count)) else { return };
    let index = pdo.pdo.mapping_index();
    let beyond = pdo.pdo.slots.iter().filter(|slot| slot.sub > count);
    let mut beyond = beyond.filter(|slot| slot.object.is_some_and(|object| !object.is_unused()));
    let Some(first) = beyond.next() else { return };
    let message = say!(
        "sub-index {} of {:04X}h contains an object, but {} maps only `{}`",
        first.sub,
        index,
        pdo.pdo,
        count
    );
    let finding = MAPPING_BEYOND_COUNT.at(facts.device.value_place(index, first.sub), message);
    let finding = finding.label(facts.device.value_place(index, 0), "the number of mapped objects");
    findings.push(finding.help("increase sub-index 0, or write 0 here"));
}

fn mapping_without_count(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(object) = pdo.mapping.filter(|object| !object.orphan && is_unstated(object, 0)) else { return };
    let Some(entry) =
        object.subs.get(0).filter(|entry| entry.access.is_some_and(|access| !Access::is_writable(access)))
    else {
        return;
    };
    if entry.data_type.is_none() {
        return;
    }
    let place = Place::entry(pdo.mapping_index(), 0).field(Field::DefaultValue);
    let message = say!("{} has a fixed mapping, but no number of mapped objects", pdo);
    findings.push(MAPPING_WITHOUT_COUNT.at(place, message).help("write the number of mapped objects"));
}

fn mapping_without_valid_bit(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let access = |object: Option<&Object>, sub| object?.subs.get(sub)?.access;
    let writable = |sub| access(pdo.mapping, sub).is_some_and(Access::is_writable);
    let fixed = access(pdo.communication, 1).filter(|access| !access.is_writable());
    let Some(fixed) = fixed.filter(|_| writable(0) && writable(1)) else { return };
    let at = |index, sub| Place::entry(index, sub).field(Field::AccessType);
    let message =
        say!("the COB-ID of {} is `{}`, so it cannot be disabled to change its mapping", pdo, fixed);
    let finding = MAPPING_WITHOUT_VALID_BIT
        .at(at(pdo.communication_index(), 1), message)
        .label(at(pdo.mapping_index(), 0), "the mapping is writable");
    findings.push(finding.help("make the COB-ID `rw`, or the mapping `const`"));
}

fn mixed_mapping_access(_: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let Some(object) = pdo.pdo.mapping.filter(|object| object.compact.is_none()) else { return };
    let index = pdo.pdo.mapping_index();
    let Some(count) = is_entry_writable(object, 0) else { return };
    let mut entries = (1..=64).filter_map(|sub| Some((sub, is_entry_writable(object, sub)?)));
    let Some((sub, _)) = entries.find(|&(_, entry)| entry != count) else { return };
    let message = if count {
        say!("sub-index {} of {:04X}h is read-only, but the number of mapped objects is writable", sub, index)
    } else {
        say!("sub-index {} of {:04X}h is writable, but the number of mapped objects is read-only", sub, index)
    };
    let finding = MIXED_MAPPING_ACCESS.at(Place::entry(index, sub).field(Field::AccessType), message);
    let finding =
        finding.label(Place::entry(index, 0).field(Field::AccessType), "the number of mapped objects");
    findings.push(finding.help("make all sub-indexes `rw`, or all of them `const`"));
}

fn is_entry_writable(object: &Object, sub: u8) -> Option<bool> {
    object.subs.get(sub)?.access.map(Access::is_writable)
}

fn pdo_length_exceeded(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let bits: u32 = pdo.mapped.iter().map(|mapped| u32::from(mapped.object.bits)).sum();
    if bits <= Pdo::FRAME_BITS || !pdo.lengths_are_right() {
        return;
    }
    let mut placed = MappedObject::placed(&pdo.mapped, |mapped| mapped.object.bits);
    let beyond = placed.find(|(first, mapped)| first + u32::from(mapped.object.bits) > Pdo::FRAME_BITS);
    let index = pdo.pdo.mapping_index();
    let place = facts.device.value_place(index, beyond.map_or(0, |(_, mapped)| mapped.slot));
    let message =
        say!("{} maps {} bits, {} more than a CAN frame holds", pdo.pdo, bits, bits - Pdo::FRAME_BITS);
    let finding = PDO_LENGTH_EXCEEDED.at(place, message);
    let finding = finding.label(facts.device.value_place(index, 0), "the number of mapped objects");
    findings.push(finding.help("move this object and the following ones to another PDO"));
}

fn same_mapping(facts: &Facts<'_>, findings: &mut Findings) {
    // an encoder sends its position in two PDOs, and a CiA 406 rule checks their transmission types
    if facts.device.profile() == Some(406) {
        return;
    }
    let mut seen: HashMap<(PdoKind, u8, Vec<MappedObject>), &Pdo<'_>> = HashMap::new();
    for PdoFacts { pdo, mapped } in &facts.pdos {
        let is_whole = pdo.mapped_count.is_some_and(|count| usize::from(count) == mapped.len());
        let is_valid = pdo.cob_id.is_some_and(|cob_id| cob_id.is_valid() && cob_id.stray_bits() == 0);
        let Some(transmission_type) = pdo.transmission_type.filter(|_| is_valid) else { continue };
        if mapped.is_empty() || !is_whole || pdo.is_multiplexed() {
            continue;
        }
        let objects = mapped.iter().map(|mapped| mapped.object).collect();
        let first = *seen.entry((pdo.kind, transmission_type, objects)).or_insert(pdo);
        if first.number == pdo.number {
            continue;
        }
        let finding = SAME_MAPPING
            .at(Place::object(pdo.mapping_index()), say!("{} maps the same objects as {}", pdo, first));
        let finding = finding.label(Place::object(first.mapping_index()), "the same mapping");
        let index = pdo.communication_index();
        findings.push(finding.help(say!("map other objects, or set bit 31 of the COB-ID in {:04X}h", index)));
    }
}

fn valid_pdo_without_mapping(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    // another rule reports a restricted CAN-ID
    if pdo.cob_id().is_some_and(|cob_id| facts.is_restricted(&cob_id)) {
        return;
    }
    let Some(cob_id) = pdo.pdo.cob_id.filter(|cob_id| cob_id.is_valid() && cob_id.stray_bits() == 0) else {
        return;
    };
    if pdo.pdo.mapped_count != Some(0) {
        return;
    }
    let place = facts.device.value_place(pdo.pdo.communication_index(), 1);
    let message = say!("`{}` makes {} valid, but it maps no objects", cob_id, pdo.pdo);
    let finding = VALID_PDO_WITHOUT_MAPPING.at(place, message);
    let finding =
        finding.label(facts.device.value_place(pdo.pdo.mapping_index(), 0), "no objects are mapped");
    findings.push(finding.help(say!("set bit 31: `{}`, or map an object", cob_id.disabled())));
}

fn wrong_mapping_count(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let (Some(count), Some(object)) = (pdo.pdo.mapped_count, pdo.pdo.mapping) else { return };
    let index = pdo.pdo.mapping_index();
    let place = facts.device.value_place(index, 0);
    let finding = |message: Text| WRONG_MAPPING_COUNT.at(place.clone(), message);
    if (65..=253).contains(&count) {
        let finding =
            finding(say!("the number of mapped objects of {} is `{}`, but must be 0 to 64", pdo.pdo, count));
        findings
            .push(finding.help("write the number of entries in use; 254 and 255 are for multiplexed PDOs"));
        return;
    }
    if count > 64 || object.orphan || !object.object_type().has_subs() {
        return;
    }
    let is_empty = |sub: u8| is_unstated(object, sub) || mapped_number(object, sub) == Some(0);
    let Some(sub) = (1..=count).find(|&sub| !object.has(sub) || is_empty(sub)) else { return };
    let message = say!("{} maps `{}` objects", pdo.pdo, count);
    let finding = if object.has(sub) {
        let finding = finding(say!("{}, but sub-index {} of {:04X}h is empty", message, sub, index));
        finding.label(facts.device.value_place(index, sub), "the first entry without an object")
    } else {
        finding(say!("{}, but {:04X}h has no sub-index {}", message, index, sub))
    };
    let title = say!("write the number of entries in use: `{}`", sub - 1);
    let fix = Fix::risky(title.clone()).set(place.clone(), (sub - 1).to_string());
    findings.push(finding.help(title).fix(fix));
}

fn mapped_number(object: &Object, sub: u8) -> Option<i128> {
    object.value(sub)?.as_integer()
}

fn listed_entry_missing(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    // the local index of a dispatching list begins 32 bits further up
    let shift = match index {
        0x1FA0..=0x1FCF => 0,
        0x1FD0..=0x1FFF => 32,
        _ => return,
    };
    if device.is_modular() {
        return;
    }
    for (sub, _) in object.entries().filter(|(sub, _)| (1..0xFF).contains(sub)) {
        let value = object.value(sub).and_then(|value| value.as_integer());
        let Some(value) = value.and_then(|value| u64::try_from(value).ok()).filter(|&value| value != 0)
        else {
            continue;
        };
        let [.., block, high, low, first] = (value >> shift).to_be_bytes();
        let target = u16::from_be_bytes([high, low]);
        let last = first.saturating_add(block.saturating_sub(1));
        let lacks = |sub: &u8| device.object(target).and_then(|target| target.entry(*sub)).is_none();
        let Some(missing) = (first..=last).find(lacks) else { continue };
        // an object without its own section
        if stated::is_there(device, target) && device.object(target).is_none_or(|target| target.orphan) {
            continue;
        }
        let message =
            say!("{:04X}h names {:04X}h:{:02X}, but there is no such entry", index, target, missing);
        let finding = LISTED_ENTRY_MISSING.at(device.value_place(index, sub), message);
        findings.push(finding.help("describe the entry, or write 0"));
    }
}

fn multiplexed_pdo_transmission_type(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let pdo = &pdo.pdo;
    let Some(transmission_type @ 0..=240) = pdo.transmission_type.filter(|_| pdo.is_multiplexed()) else {
        return;
    };
    let place = facts.device.value_place(pdo.communication_index(), 2);
    let message =
        say!("{} is a multiplexed PDO, but transmission type `{}` is synchronous", pdo, transmission_type);
    let finding = MULTIPLEXED_PDO_TRANSMISSION_TYPE
        .at(place, message)
        .label(facts.device.value_place(pdo.mapping_index(), 0), "this makes it a multiplexed PDO");
    findings.push(finding.help("write 254 or 255"));
}

fn multiplexed_pdo_without_list(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    for kind in PdoKind::ALL {
        let (first, last, name) = match kind {
            PdoKind::Tpdo => (0x1FA0, 0x1FCF, "object scanner list"),
            PdoKind::Rpdo => (0x1FD0, 0x1FFF, "object dispatching list"),
        };
        let mut pdos = facts.pdos.iter().map(|facts| &facts.pdo).filter(|pdo| pdo.kind == kind);
        let Some(pdo) = pdos.find(|pdo| pdo.mapped_count == Some(0xFE)) else { continue };
        let is_listed = device.lists.iter().any(|(_, index)| (first..=last).contains(&index));
        if is_listed || device.objects.range(first..=last).next().is_some() {
            continue;
        }
        let message = say!("{} is a multiplexed PDO in source address mode, but there is no {}", pdo, name);
        let finding = MULTIPLEXED_PDO_WITHOUT_LIST.at(device.value_place(pdo.mapping_index(), 0), message);
        findings.push(finding.help(say!(
            "add {:04X}h ({}), or write 255 for destination address mode",
            first,
            name
        )));
    }
}

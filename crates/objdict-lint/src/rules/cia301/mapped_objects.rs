//! The objects that a PDO maps, entry by entry.

use std::collections::BTreeMap;

use crate::diagnostic::{Findings, Fix, Severity, Text, counted_bits, say};
use crate::model::{Access, DataType, Field, MappedObject, Part, PdoKind, Place};
use crate::rule::rules;
use crate::{Facts, MappedTo, PdoFacts};

rules! {
    source: "CiA 301 §7.5.2.36";

    "cia301/invalid-dummy-mapping" = INVALID_DUMMY_MAPPING, Error, Pdo(invalid_dummy_mapping);
    summary: "a dummy entry of a PDO mapping is not valid",
    checks: "A mapping entry that refers to a data type instead of an object (below 0020h) must be in an RPDO and refer to an integer type or BOOLEAN. It must have sub-index 0 and the length of the type, and must not be disabled in `DummyUsage`.",
    why: "A dummy entry makes an RPDO skip data for other nodes. A TPDO has no value to send for it, and a device rejects a type that it does not support as a dummy entry.",
    example: "`[1600sub2]` with `DefaultValue=0x00050010`",
    remedy: "Write `0x00050008` for one byte, `0x00060010` for two, `0x00070020` for four, and enable the type in `DummyUsage`.",
    source: "CiA 301 §7.4.7.1; CiA 306-1 §4.6.2",

    "cia301/mapped-object-missing" = MAPPED_OBJECT_MISSING, Error, Pdo(mapped_object_missing);
    summary: "a PDO maps an object that does not exist",
    checks: "Each mapping entry in use must refer to a described object and sub-index. Objects that a module or a dynamic channel may provide are treated as existing. On a modular device, any other missing object is a note.",
    why: "The device rejects the mapping with an abort, and the PDO does not work. Tools cannot resolve the contents of the frame.",
    example: "`[1A00sub1]` with `DefaultValue=0x60000108`, without `[6000]`",
    remedy: "Describe the object, or map a different one. The eight digits are index, sub-index and length.",
    source: "CiA 301 §7.5.2.36, §7.5.2.38; CiA 306-1 §6.2.2",

    "cia301/mapped-object-not-mappable" = MAPPED_OBJECT_NOT_MAPPABLE, Error,
        Pdo(mapped_object_not_mappable), fix Unsafe;
    summary: "a PDO maps an object that is not mappable",
    checks: "Each mapped entry must have `PDOMapping` set.",
    why: "Either the object is mappable and no tool offers it, or it is not and the default mapping is wrong.",
    example: "`[1A00sub1]` with `DefaultValue=0x60000108`, and `[6000sub1]` with `PDOMapping=0`",
    remedy: "Write `PDOMapping=1` at the object, or map a different one.",
    source: "CiA 301 §7.5.2.36; CiA 306-1 §4.6.3.2",

    "cia301/mapping-granularity" = MAPPING_GRANULARITY, Warning, Pdo(mapping_granularity);
    summary: "the length of a mapped object is not a multiple of the granularity",
    checks: "The length of each object that a PDO maps by default must be a multiple of `Granularity`. With 0 the mapping is fixed and not checked.",
    why: "A device with a granularity of 8 maps whole bytes and rejects a BOOLEAN. Either the granularity is smaller than stated or the mapping does not work.",
    example: "`Granularity=8`, and `[1A00sub1]` with `DefaultValue=0x60200101`",
    remedy: "Write the granularity of the device, or map objects of whole bytes.",
    source: "CiA 306-1 §4.5",

    "cia301/mapping-of-count" = MAPPING_OF_COUNT, Error, Pdo(mapping_of_count);
    summary: "a PDO maps the number of entries instead of an entry",
    checks: "A mapping entry with sub-index 0 must refer to a VAR. Sub-index 0 of an ARRAY or RECORD is the number of entries.",
    why: "The PDO transmits a constant. Often the sub-indexes were counted from 0, and the last one is not mapped.",
    example: "`[1A01sub1]` with `DefaultValue=0x64010010` for the ARRAY 6401h",
    remedy: "Start with sub-index 1: `0x64010110`.",
    source: "CiA 301 §7.4.7.2, §7.5.2.36",

    "cia301/mapping-of-variable-length" = MAPPING_OF_VARIABLE_LENGTH, Error, Pdo(mapping_of_variable_length);
    summary: "a PDO maps an object without a fixed length",
    checks: "The data type of each mapped object must have a fixed length. An OCTET_STRING of 1 to 8 bytes and a string whose value has the mapped length can be mapped.",
    why: "The position of each object in the frame depends on the lengths of the objects before it. The device rejects the mapping, and tools reserve a wrong number of bytes.",
    example: "`[1600sub1]` with `DefaultValue=0x20000040`, and `DataType=0x0009` (VISIBLE_STRING) in `[2000]`",
    remedy: "Map a different object, or describe the object with a type of fixed length.",
    source: "CiA 301 §7.4.7, §7.5.2.36",

    "cia301/object-mapped-twice" = OBJECT_MAPPED_TWICE, Warning, Pdo(object_mapped_twice);
    summary: "a PDO maps the same object twice",
    checks: "The mapping of a PDO must contain each object only once. Dummy entries may be repeated. The same object in two PDOs is common, for example in CiA 402, and is not checked.",
    why: "Often a copied line was not changed: one object is transferred twice and the intended one is missing.",
    example: "`[1A00sub1]` and `[1A00sub2]`, both with `DefaultValue=0x60000108`",
    remedy: "Map the intended object.",

    "cia301/unaligned-mapping" = UNALIGNED_MAPPING, Note, Pdo(unaligned_mapping);
    summary: "a byte-sized object does not start at a byte boundary of its PDO",
    checks: "Each mapped object of 8 bits or more must start at a byte boundary of the frame.",
    why: "Most devices and masters copy whole bytes and reject the mapping or read it incorrectly.",
    example: "`[1A00sub1]` with `DefaultValue=0x60200101` and `[1A00sub2]` with `DefaultValue=0x60000108`",
    remedy: "Map the single bits last, or fill the previous byte.",

    "cia301/wrong-mapping-direction" = WRONG_MAPPING_DIRECTION, Error, Pdo(wrong_mapping_direction);
    summary: "a PDO maps an object of the opposite direction",
    checks: "The objects of a TPDO must be readable and must not be process outputs (`wo`, `rww`). The objects of an RPDO must be writable and must not be process inputs (`ro`, `const`, `rwr`).",
    why: "An RPDO cannot write a read-only object: the device rejects the mapping or drops the data silently.",
    example: "`[1600sub1]` with `DefaultValue=0x60000108`, and `[6000sub1]` with `AccessType=ro`",
    remedy: "Map the object to a PDO of its direction, or correct its access type: `rww` for an output, `ro` or `rwr` for an input, `rw` for both.",
    source: "CiA 301 §7.5.2.36 (corrigendum 3); CiA 306-1 §4.6.3.2",

    // canopen-stack uses the length of the object, so the following objects move in the frame
    "cia301/wrong-mapping-length" = WRONG_MAPPING_LENGTH, Error,
        Pdo(wrong_mapping_length), fix Unsafe, stops "canopen-stack";
    summary: "the length in a PDO mapping differs from the length of the object",
    checks: "The last two digits of each mapping entry, the length in bits, must match the data type of the object. Objects of variable length are not checked. A BOOLEAN with 8 bits is a warning: devices that map only whole bytes do this, such as those with CANopenNode.",
    why: "The device rejects the mapping with an abort; a receiver reads the following objects from the wrong position of the frame.",
    example: "`[1A00sub1]` with `DefaultValue=0x60000110`, where `[6000sub1]` is UNSIGNED8",
    remedy: "Write the length of the data type in hexadecimal: 08, 10, 20, 40 for 8, 16, 32 and 64 bits.",
}

fn invalid_dummy_mapping(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| matches!(mapped.target, MappedTo::Dummy)) {
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        if let Some((what, help)) = dummy_defect(pdo.pdo.kind, mapped.object) {
            let message = say!("{} {}", pdo.pdo, what);
            findings.push(INVALID_DUMMY_MAPPING.at(place, message).help(help));
        } else if let Some(key) = forbidding_key(facts, mapped.object) {
            let data_type = DataType(mapped.object.index);
            let message =
                say!("{} has a dummy entry of type {}, which `DummyUsage` disables", pdo.pdo, data_type);
            let key = Place::of(Part::DummyUsage).field(key);
            let finding = INVALID_DUMMY_MAPPING.at(place, message).label(key, "disabled here");
            findings.push(finding.help("use a type that `DummyUsage` enables"));
        }
    }
}

fn dummy_defect(kind: PdoKind, dummy: MappedObject) -> Option<(Text, Text)> {
    let data_type = DataType(dummy.index);
    let bits = data_type.bit_length();
    if kind == PdoKind::Tpdo {
        let what = say!("maps the data type {}, but only an RPDO can have dummy entries", data_type);
        return Some((what, "map an object".into()));
    }
    let Some(bits) = bits.filter(|_| data_type.is_dummy()) else {
        let what = say!("maps {:04X}h, which is not a data type for dummy entries", dummy.index);
        return Some((what, "use BOOLEAN or an integer type: `0x00050008` skips one byte".into()));
    };
    let right = say!("write `0x{:08X}`", MappedObject { bits, sub: 0, ..dummy }.to_number());
    if dummy.sub != 0 {
        return Some((say!("has a dummy entry with sub-index {}, which must be 0", dummy.sub), right));
    }
    let what = say!("has a dummy entry of {}, but {} has {}", counted_bits(dummy.bits), data_type, bits);
    (bits != dummy.bits).then_some((what, right))
}

/// The key that disables the type as a dummy entry.
fn forbidding_key(facts: &Facts<'_>, dummy: MappedObject) -> Option<Field> {
    let usage = facts.device.dummy_usage.as_ref()?;
    let allowed = usage.types.get(&DataType(dummy.index))?;
    (!allowed).then(|| Field::Named(format!("Dummy{:04X}", dummy.index).into()))
}

fn mapped_object_missing(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| mapped.target.is_missing()) {
        let (object, index) = (mapped.object, pdo.pdo.mapping_index());
        let place = facts.device.value_place(index, mapped.slot);
        let finding = match mapped.target {
            MappedTo::NoEntry => {
                let message = say!(
                    "{} maps {:04X}h:{:02X}, but the object has no such sub-index",
                    pdo.pdo,
                    object.index,
                    object.sub
                );
                let finding = MAPPED_OBJECT_MISSING.at(place, message);
                let finding = finding.label(Place::object(object.index), "the object");
                finding.help("describe the sub-index, or map a different one")
            }
            _ => {
                let message = say!(
                    "{} maps {:04X}h:{:02X}, but there is no such object",
                    pdo.pdo,
                    object.index,
                    object.sub
                );
                MAPPED_OBJECT_MISSING.at(place, message).help("describe the object, or map a different one")
            }
        };
        findings.push(if facts.device.is_modular() { finding.severity(Severity::Note) } else { finding });
    }
}

/// The section of a mapped entry: a sub-index, or the object itself.
fn target_place(facts: &Facts<'_>, MappedObject { index, sub, .. }: MappedObject) -> Place {
    let is_single = facts.device.object(index).is_some_and(|object| object.subs.get(sub).is_none());
    if is_single { Place::object(index) } else { Place::entry(index, sub) }
}

fn mapped_object_not_mappable(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let MappedTo::Entry(entry) = &mapped.target else { continue };
        // another rule reports a type without a fixed length
        let is_variable = mapped.variable_type().is_some();
        if entry.is_mappable() || is_variable || entry.invalid_values.get(&Field::PdoMapping).is_some() {
            continue;
        }
        let (index, sub) = (mapped.object.index, mapped.object.sub);
        let message = say!("{} maps {:04X}h:{:02X}, which is not mappable", pdo.pdo, index, sub);
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let finding = MAPPED_OBJECT_NOT_MAPPABLE.at(place, message);
        let target = target_place(facts, mapped.object);
        let part = target.part.clone();
        let fix = Fix::risky(say!("write `{PDOMapping=1}` in `{}`", part.clone()))
            .set(target.clone().field(Field::PdoMapping), "1");
        let finding = finding.label(target.field(Field::PdoMapping), "not mappable").fix(fix);
        findings.push(finding.help(say!("write `{PDOMapping=1}` in `{}`, or map a different object", part)));
    }
}

fn mapping_granularity(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let Some(granularity) = granularity.filter(|granularity| (2..=64).contains(granularity)) else { return };
    let is_odd = |bits: u8| !bits.is_multiple_of(granularity);
    let mut known = pdo.mapped.iter().filter(|mapped| match mapped.target {
        MappedTo::Entry(_) => mapped.wrong_length().is_none(),
        _ => matches!(mapped.target, MappedTo::Dummy),
    });
    let Some(first) = known.find(|mapped| is_odd(mapped.object.bits)) else { return };
    let message = say!(
        "{} maps {}, which is not a multiple of the granularity of `{}` bits",
        pdo.pdo,
        first.object,
        granularity
    );
    let place = facts.device.value_place(pdo.pdo.mapping_index(), first.slot);
    let finding = MAPPING_GRANULARITY.at(place, message);
    let finding = finding.label(Place::of(Part::DeviceInfo).field(Field::Granularity), "the granularity");
    findings.push(finding.help("correct the granularity, or map only objects that are multiples of it"));
}

fn mapping_of_count(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in pdo.mapped.iter().filter(|mapped| matches!(mapped.target, MappedTo::Count)) {
        let index = mapped.object.index;
        let message = say!("{} maps {:04X}h:00, the number of entries of an array or record", pdo.pdo, index);
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let finding = MAPPING_OF_COUNT.at(place, message);
        let finding = finding.label(Place::object(index), "the values are in sub-index 1 and above");
        findings.push(finding.help("map a sub-index above 0"));
    }
}

fn mapping_of_variable_length(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let Some(data_type) = mapped.variable_type() else { continue };
        let message = say!("{} maps {}, a {} without a fixed length", pdo.pdo, mapped.object, data_type);
        let device = facts.device;
        let place = device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        findings.push(MAPPING_OF_VARIABLE_LENGTH.at(place, message).help("map a different object"));
    }
}

fn object_mapped_twice(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let mut seen = BTreeMap::new();
    for mapped in pdo.mapped.iter().filter(|mapped| !matches!(mapped.target, MappedTo::Dummy)) {
        let object = mapped.object;
        let place = |slot| facts.device.value_place(pdo.pdo.mapping_index(), slot);
        match seen.get(&object.entry()) {
            Some(&first) => {
                let message = say!("{} maps {:04X}h:{:02X} twice", pdo.pdo, object.index, object.sub);
                let finding = OBJECT_MAPPED_TWICE.at(place(mapped.slot), message);
                findings
                    .push(finding.label(place(first), "first mapped here").help("map the intended object"));
            }
            None => {
                seen.insert(object.entry(), mapped.slot);
            }
        }
    }
}

fn unaligned_mapping(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity).unwrap_or(0);
    // if the granularity differs, `mapping-granularity` reports the object
    if granularity > 1 || !pdo.lengths_are_right() {
        return;
    }
    let mut placed = MappedObject::placed(&pdo.mapped, |mapped| mapped.object.bits);
    let unaligned = placed.find(|(start, mapped)| mapped.object.bits >= 8 && !start.is_multiple_of(8));
    let Some((start, mapped)) = unaligned else { return };
    let message = say!("{} maps {} at bit {}, which is not a byte boundary", pdo.pdo, mapped.object, start);
    let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
    let finding = UNALIGNED_MAPPING.at(place, message);
    findings.push(finding.help("map single bits last, or pad the preceding byte"));
}

fn wrong_mapping_direction(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let MappedTo::Entry(entry) = &mapped.target else { continue };
        let Some(access) = entry.access.filter(|_| entry.is_mappable() && !entry.fits_pdo(pdo.pdo.kind))
        else {
            continue;
        };
        let (index, sub) = (mapped.object.index, mapped.object.sub);
        let message = say!("{} maps {:04X}h:{:02X}, which is {}", pdo.pdo, index, sub, direction_of(access));
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let target = target_place(facts, mapped.object);
        let finding = WRONG_MAPPING_DIRECTION.at(place, message);
        let finding = finding.label(target.field(Field::AccessType), "the access type");
        findings.push(finding.help(match pdo.pdo.kind {
            PdoKind::Rpdo => "map a writable object: `rww`, `rw` or `wo`",
            PdoKind::Tpdo => "map a readable object: `ro`, `rwr` or `rw`",
        }));
    }
}

fn direction_of(access: Access) -> &'static str {
    match access {
        Access::Ro => "read-only (`ro`)",
        Access::Const => "constant (`const`)",
        Access::Wo => "write-only (`wo`)",
        Access::Rwr => "a process input (`rwr`)",
        Access::Rww => "a process output (`rww`)",
        Access::Rw => "for PDOs of the other direction",
    }
}

fn wrong_mapping_length(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    for mapped in &pdo.mapped {
        let (Some(bits), MappedTo::Entry(entry)) = (mapped.wrong_length(), &mapped.target) else { continue };
        let MappedObject { index, sub, bits: stated } = mapped.object;
        let data_type = entry.data_type.map(|data_type| data_type.to_string()).unwrap_or_default();
        let unit = if stated == 1 { "bit" } else { "bits" };
        let message = say!(
            "{} maps {} {} of {:04X}h:{:02X}, whose length is {} ({})",
            pdo.pdo,
            stated,
            unit,
            index,
            sub,
            bits,
            data_type
        );
        let place = facts.device.value_place(pdo.pdo.mapping_index(), mapped.slot);
        let target = target_place(facts, mapped.object);
        let finding = WRONG_MAPPING_LENGTH.at(place.clone(), message);
        let finding = finding.label(target.field(Field::DataType), "the data type");
        let right = MappedObject { bits, ..mapped.object };
        let right = format!("0x{:08X}", right.to_number());
        let title = say!("write `{}`", right.clone());
        let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity).unwrap_or(0);
        let help = match granularity > 0 && !bits.is_multiple_of(granularity) {
            true => say!("map {} bits with a different `{Granularity}`, or map a different object", bits),
            false => title.clone(),
        };
        let finding = finding.help(help).fix(Fix::risky(title).set(place, right));
        let whole_byte = entry.data_type == Some(DataType::BOOLEAN) && stated == 8;
        findings.push(if whole_byte { finding.severity(Severity::Warning) } else { finding });
    }
}

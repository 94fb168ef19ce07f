//! PDO mapping keys, dummy entries and the numbers of PDOs in `[DeviceInfo]`.

use crate::diagnostic::{Argument, Findings, Fix, Severity, Text, listing, say, series};
use crate::model::{
    Access, DataType, Device, DeviceInfo, Entry, Field, MappedObject, ObjectType, Part, Place, TypeKind,
    Value,
};
use crate::rule::rules;
use crate::{EntryAt, Facts, stated};

rules! {
    "cia306/access-without-mapping" = ACCESS_WITHOUT_MAPPING, Warning,
        Entry(access_without_mapping), fix Unsafe;
    summary: "the access type specifies a PDO direction, but the entry is not mappable",
    checks: "Entries with access `rwr` or `rww` must have `PDOMapping=1`.",
    why: "`rwr` and `rww` are `rw` with the PDO direction that the entry can be mapped to. One of the two keys is wrong, and tools may not offer the entry for mapping.",
    example: "`AccessType=rww` and `PDOMapping=0`",
    remedy: "Write `PDOMapping=1`, or `AccessType=rw`.",
    source: "CiA 306-1 §4.6.3.2",

    "cia306/dummy-below-granularity" = DUMMY_BELOW_GRANULARITY, Warning,
        Facts(dummy_below_granularity), fix Unsafe;
    summary: "a dummy type is smaller than the granularity",
    checks: "The length of each type that `[DummyUsage]` enables must be a multiple of `Granularity`. With 0 the mapping is fixed and not checked. A device whose default mapping contradicts the granularity is not checked either; see `cia301/mapping-granularity`.",
    why: "A device with a granularity of 8 maps whole bytes: it rejects a dummy entry of one bit, although tools offer it.",
    example: "`Granularity=8` and `Dummy0001=1`, which is BOOLEAN",
    remedy: "Write 0 for the type, or the granularity of the device.",
    source: "CiA 306-1 §4.5, §4.6.2",

    "cia306/dummy-type" = DUMMY_TYPE, Warning, Device(dummy_type), fix Safe;
    summary: "a data type is not allowed as a dummy",
    checks: "The types allowed in `[DummyUsage]` must be BOOLEAN, an INTEGER or an UNSIGNED of any width.",
    why: "A dummy fills unused bits of an RPDO. Only these types may be mapped as dummies; the device aborts the mapping of any other type.",
    example: "`Dummy0008=1`, which is REAL32",
    remedy: "Write 0 or remove the line. Use UNSIGNED32 for a gap of 32 bits.",
    source: "CiA 301 §7.4.7.1, CiA 306-1 §4.6.2",

    "cia306/mapping-not-possible" = MAPPING_NOT_POSSIBLE, Warning, EntryOf(mapping_not_possible), fix Unsafe;
    summary: "an entry is marked as mappable but cannot be mapped",
    checks: "Entries with `PDOMapping=1` must be at most 64 bits long and must not be `const`. A string or OCTET_STRING can be mapped if its value has at most 8 bytes. A string without a value is reported, because its length is open.",
    why: "Tools offer the entry for mapping, but the device rejects the mapping.",
    example: "`PDOMapping=1` of a VISIBLE_STRING with 12 characters",
    remedy: "Write `PDOMapping=0`, or correct `DataType` or `AccessType`.",
    source: "CiA 301 §7.5.2.36",

    "cia306/wrong-compact-pdo" = WRONG_COMPACT_PDO, Warning, Device(wrong_compact_pdo), fix Mixed;
    summary: "`CompactPDO` has an invalid mask",
    checks: "`CompactPDO` must have bits 0 and 1 set (COB-ID and transmission type, present in every PDO). Bits 6 and 7 must be clear, because sub-indexes 7 and 8 do not exist. Bit 3 must be clear, because sub-index 4 is reserved; many masters use it, so the finding is a note. The device must have PDOs.",
    why: "Tools create the communication records of all implied PDOs from this mask.",
    example: "`CompactPDO=0x1`",
    remedy: "Add 01h and 02h, and if needed 04h for an inhibit time, 10h for an event timer and 20h for a SYNC start value. Write 0 for a device without implied PDOs.",
    source: "CiA 306-1 §4.6.3.4.1, CiA 301 §7.4.8.1",

    "cia306/wrong-pdo-count" = WRONG_PDO_COUNT, Error, Device(wrong_pdo_count), fix Mixed;
    summary: "`NrOfRXPDO` or `NrOfTXPDO` does not match the described PDOs",
    checks: "`NrOfRXPDO` must be the number of objects 1400h to 15FFh, and `NrOfTXPDO` the number of objects 1800h to 19FFh. With `CompactPDO` the number may be higher: the other PDOs are implied. Objects that are marked as disabled (`CO_disabled`) are ignored.",
    why: "Configuration tools offer the given number of PDOs. PDOs above it are never configured, and writing missing ones fails.",
    example: "`NrOfRXPDO=2` where only 1400h is described",
    remedy: "Write the number of communication parameter objects, or describe the missing ones.",
    source: "CiA 306-1 §4.5, §4.6.3.4.1",
}

fn access_without_mapping(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let Some(access @ (Access::Rwr | Access::Rww)) = entry.access else { return };
    if entry.is_mappable() || !at.holds_value() || stated::is_invalid(entry, &Field::PdoMapping) {
        return;
    }
    let pdo = if access == Access::Rwr { "a TPDO" } else { "an RPDO" };
    let message = say!("`{}` allows mapping to {}, but the entry is not mappable", access, pdo);
    let finding = ACCESS_WITHOUT_MAPPING
        .at(at.field(Field::AccessType), message)
        .label(at.field(Field::PdoMapping), "not mappable");
    let fix = Fix::risky(say!("write `{AccessType=rw}`")).set(at.field(Field::AccessType), "rw");
    findings.push(finding.help(say!("write `{PDOMapping=1}`, or `{AccessType=rw}`")).fix(fix));
}

/// The data types that `[DummyUsage]` allows as dummy entries.
fn enabled_dummies(device: &Device) -> impl Iterator<Item = DataType> {
    let types = device.dummy_usage.iter().flat_map(|usage| &usage.types);
    types.filter(|(_, enabled)| **enabled).map(|(data_type, _)| *data_type)
}

fn dummy_key(data_type: &DataType) -> String {
    format!("Dummy{:04X}", data_type.0)
}

/// `write Dummy0002=0 and Dummy0003=0`, each in backticks.
fn without_dummies(types: &[DataType]) -> Text {
    let settings = types.iter().map(|data_type| format!("{}=0", dummy_key(data_type)));
    say!("write {}", listing(settings))
}

fn dummy_place(data_type: &DataType) -> Place {
    Place::of(Part::DummyUsage).field(Field::Named(dummy_key(data_type).into()))
}

fn dummy_below_granularity(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    let granularity = device.device_info.as_ref().and_then(|info| info.granularity);
    let Some(granularity) = granularity.filter(|granularity| (2..=64).contains(granularity)) else { return };
    let is_odd = |bits: u8| !bits.is_multiple_of(granularity);
    // another rule reports a mapping that contradicts the granularity
    if facts.pdos.iter().flat_map(|pdo| &pdo.mapped).any(|mapped| is_odd(mapped.object.bits)) {
        return;
    }
    let smaller: Vec<DataType> = enabled_dummies(device)
        .filter(|data_type| data_type.is_dummy() && data_type.bit_length().is_some_and(is_odd))
        .collect();
    let Some(first) = smaller.first() else { return };
    let message = match smaller[..] {
        [one] => say!(
            "`{}` enables {}, which is not a multiple of the granularity of `{}` bits",
            dummy_key(&one),
            one,
            granularity
        ),
        _ => say!(
            "{} enable types that are not multiples of the granularity of `{}` bits",
            listing(smaller.iter().map(dummy_key)),
            granularity
        ),
    };
    let title = without_dummies(&smaller);
    let fix =
        smaller.iter().fold(Fix::risky(title.clone()), |fix, data_type| fix.set(dummy_place(data_type), "0"));
    let finding = DUMMY_BELOW_GRANULARITY
        .at(dummy_place(first), message)
        .label(Place::of(Part::DeviceInfo).field(Field::Granularity), "the granularity");
    findings.push(finding.help(title).fix(fix));
}

fn dummy_type(device: &Device, findings: &mut Findings) {
    let wrong: Vec<DataType> = enabled_dummies(device).filter(|data_type| !data_type.is_dummy()).collect();
    let Some(first) = wrong.first() else { return };
    let message = match wrong[..] {
        [one] => say!("`{}` is 1, but {} cannot be a dummy", dummy_key(&one), one),
        _ => say!("{} allow dummies that no PDO can map", listing(wrong.iter().map(dummy_key))),
    };
    let title = without_dummies(&wrong);
    let fix =
        wrong.iter().fold(Fix::safe(title.clone()), |fix, data_type| fix.set(dummy_place(data_type), "0"));
    findings.push(DUMMY_TYPE.at(dummy_place(first), message).help(title).fix(fix));
}

fn mapping_not_possible(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if !entry.is_mappable() || !at.holds_value() || at.object_type() == Some(ObjectType::Domain) {
        return;
    }
    // another rule reports a PDO that maps an entry without a fixed length
    let is_mapped = |at: &EntryAt<'_>| {
        let this = |mapped: MappedObject| mapped.entry() == (at.index, at.sub.unwrap_or(0));
        device.pdos().any(|pdo| pdo.mapped().any(this))
    };
    let unmappable = entry
        .data_type
        .filter(|data_type| stated::is_unmappable(data_type.kind()) && !is_short_string(entry));
    let (message, field, label) = match (unmappable, entry.access) {
        (Some(data_type), _) => {
            let message = match data_type.kind() {
                TypeKind::Domain | TypeKind::Structure => say!("{} cannot be mapped to a PDO", data_type),
                _ => match string_length(entry) {
                    Some(length) if length > 8 => say!("a PDO holds 8 bytes and its value has {}", length),
                    _ => say!("a PDO holds 8 bytes and this {} may be longer", data_type),
                },
            };
            (message, Field::DataType, "the data type")
        }
        (None, Some(Access::Const)) => {
            (Text::from("a constant never changes"), Field::AccessType, "a constant")
        }
        _ => return,
    };
    if unmappable.is_some() && is_mapped(at) {
        return;
    }
    let message = say!("`{PDOMapping}` is {}, but {}", entry.pdo_mapping.unwrap_or_default(), message);
    let finding = MAPPING_NOT_POSSIBLE.at(at.field(Field::PdoMapping), message).label(at.field(field), label);
    let title = say!("write `{PDOMapping=0}`");
    let fix = Fix::risky(title.clone()).set(at.field(Field::PdoMapping), "0");
    let of_mapped = || say!("replace it in the mapping, then write `{PDOMapping=0}`");
    findings.push(finding.help(if is_mapped(at) { of_mapped() } else { title }).fix(fix));
}

/// Whether the value of a string has 1 to 8 bytes, which a PDO can carry.
fn is_short_string(entry: &Entry) -> bool {
    string_length(entry).is_some_and(|length| (1..=8).contains(&length))
}

/// The bytes of the value of a string.
fn string_length(entry: &Entry) -> Option<usize> {
    match (entry.data_type?, entry.value()?) {
        (DataType::VISIBLE_STRING, Value::Text(text)) => Some(text.len()),
        (DataType::UNICODE_STRING, Value::Text(text)) => Some(text.encode_utf16().count() * 2),
        (DataType::OCTET_STRING, Value::Bytes(bytes)) => Some(bytes.len()),
        _ => None,
    }
}

const MANDATORY_SUBS: u8 = 0x03;
const POSSIBLE_SUBS: u8 = 0x37;

fn wrong_compact_pdo(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let Some(mask) = info.compact_pdo.filter(|&mask| mask != 0) else { return };
    let place = Place::of(Part::DeviceInfo).field(Field::CompactPdo);
    let corrected = (mask & POSSIBLE_SUBS) | MANDATORY_SUBS;
    if info.rpdo_count == Some(0) && info.tpdo_count == Some(0) {
        let fix = Fix::safe(say!("write `{CompactPDO=0}`")).set(place.clone(), "0");
        let finding = WRONG_COMPACT_PDO
            .at(place, say!("`{CompactPDO}` is {:#04x}, but the device has no PDO", mask))
            .label(Place::of(Part::DeviceInfo).field(Field::NrOfRxPdo), "no RPDO")
            .label(Place::of(Part::DeviceInfo).field(Field::NrOfTxPdo), "no TPDO");
        findings.push(finding.help(say!("write `{CompactPDO=0}` or remove {the key}")).fix(fix));
    } else if corrected != mask {
        let message = match mask & MANDATORY_SUBS {
            MANDATORY_SUBS => say!("a PDO has no {}", subs_of_mask(mask & !POSSIBLE_SUBS)),
            present => say!("every PDO has {}", subs_of_mask(MANDATORY_SUBS & !present)),
        };
        let title = say!("write `CompactPDO={:#04x}`", corrected);
        let fix = Fix::risky(title.clone()).set(place.clone(), format!("{corrected:#04x}"));
        let only_sub_4 = mask ^ corrected == 1 << 3;
        let finding = WRONG_COMPACT_PDO
            .at(place, say!("`{CompactPDO}` is {:#04x}, but {}", mask, message))
            .severity(if only_sub_4 { Severity::Note } else { Severity::Warning });
        findings.push(finding.help(title).fix(fix));
    }
}

/// The sub-indexes of the bits of a mask.
fn subs_of_mask(mask: u8) -> Text {
    let subs = (0..8).filter(|bit| mask >> bit & 1 != 0).map(|bit| bit + 1);
    let word = if mask.is_power_of_two() { "sub-index" } else { "sub-indexes" };
    say!("{} {}", word, series(subs))
}

/// The PDOs of one direction: their name, the field of their number and the range of their communication
/// records.
struct PdoRange {
    name: &'static str,
    field: Field,
    low: u16,
    high: u16,
}

fn wrong_pdo_count(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    if let Some(stated) = info.rpdo_count {
        let rpdos = PdoRange { name: "RPDO", field: Field::NrOfRxPdo, low: 0x1400, high: 0x15FF };
        check_pdo_count(device, info, &rpdos, usize::from(stated), findings);
    }
    if let Some(stated) = info.tpdo_count {
        let tpdos = PdoRange { name: "TPDO", field: Field::NrOfTxPdo, low: 0x1800, high: 0x19FF };
        check_pdo_count(device, info, &tpdos, usize::from(stated), findings);
    }
}

fn check_pdo_count(
    device: &Device,
    info: &DeviceInfo,
    pdos: &PdoRange,
    stated: usize,
    findings: &mut Findings,
) {
    let PdoRange { name, field, low, high } = pdos;
    let described = device.objects.range(low..=high);
    let described = described.filter(|(_, object)| !object.orphan).count();
    let compact = info.compact_pdo.is_some_and(|mask| mask != 0)
        || info.invalid_values.get(&Field::CompactPdo).is_some();
    if stated == described || compact && stated > described {
        return;
    }
    let count = match described {
        0 => say!("no {} is", name),
        1 => say!("1 {} is", name),
        _ => say!("{} {}s are", described, name),
    };
    let message = say!("`{}` is {}, but {} described ({:04X}h to {:04X}h)", field, stated, count, low, high);
    let place = Place::of(Part::DeviceInfo).field(field.clone());
    let title = say!("write `{}`", Argument::setting(field, described));
    // a higher number is a remnant of missing PDOs
    let fix = if stated > described { Fix::risky(title.clone()) } else { Fix::safe(title.clone()) };
    let fix = fix.set(place.clone(), described.to_string());
    let finding = WRONG_PDO_COUNT.at(place, message).fix(fix);
    findings.push(if stated > described {
        finding.help(say!("{}, or describe the missing {}s", title, name))
    } else {
        finding.help(title)
    });
}

//! Compact objects, PDO mappings and values that not all tools read correctly or at all.

use crate::diagnostic::{Findings, Fix, counted, listing, listing_or, say};
use crate::model::{
    Access, Compact, DataType, Device, Entry, Field, ModulePart, Object, ObjectType, Part, PdoKind,
    PdoMapping, Place, Value,
};
use crate::rule::rules;
use crate::{EntryAt, EntryOwner, Facts, PdoFacts, stated};

rules! {
    source: "python-canopen 2.4.1, CANopenEditor of 2026";

    "portability/compact-denotations" = COMPACT_DENOTATIONS, Error, Device(compact_denotations);
    summary: "a tool does not support the denotations of a compact object",
    checks: "Reports objects with `CompactSubObj` and a section `[xxxxDenotation]`. The finding is at the first one and lists the others.",
    why: "dcf-tools supports `[xxxxName]` and `[xxxxValue]` but not this section, so it rejects the file.",
    example: "`[2000Denotation]`",
    remedy: "Use `[xxxxName]`, or describe the sub-indexes individually.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/compact-names" = COMPACT_NAMES, Warning, Device(compact_names);
    summary: "a tool ignores the names of a compact object",
    checks: "Reports objects with `CompactSubObj` and a section `[xxxxName]` without a gap. The finding is at the first one and lists the others.",
    why: "CANopenEditor does not read the section and names the sub-indexes after the object, with a hex number appended.",
    example: "`[2000Name]`",
    remedy: "Describe the sub-indexes individually if their names matter.",
    source: "CANopenEditor of 2026",

    "portability/compact-parameter-value" = COMPACT_PARAMETER_VALUE, Error, Device(compact_parameter_value);
    summary: "a compact object has one configured value for all sub-indexes",
    checks: "Reports objects with `CompactSubObj` and a `ParameterValue` but without a section `[xxxxValue]`. The finding is at the first one and lists the others.",
    why: "dcf-tools does not read the value of the key correctly and crashes.",
    example: "`CompactSubObj=8` and `ParameterValue=1`",
    remedy: "Write the value of each sub-index in `[xxxxValue]`.",
    source: "dcf-tools 2.4.2",

    "portability/compact-storage" = COMPACT_STORAGE, Warning, Device(compact_storage);
    summary: "a tool does not support `CompactSubObj` correctly",
    checks: "Reports objects with `CompactSubObj` but without a section of names, values or denotations. These sections have their own rules. The finding is at the first one and lists the others.",
    why: "CANopenEditor creates the sub-indexes but drops their default and mapping and uses the low limit as the high limit. python-canopen creates the sub-indexes of an ARRAY on access, without a value in sub-index 0, and none for a RECORD.",
    example: "`CompactSubObj=8`",
    remedy: "Describe the sub-indexes individually.",

    "portability/compact-values" = COMPACT_VALUES, Warning, Device(compact_values);
    summary: "a tool ignores the values of a compact object",
    checks: "Reports objects with `CompactSubObj` and a section `[xxxxValue]`. The finding is at the first one and lists the others.",
    why: "python-canopen and CANopenEditor do not read the section: they use the default instead of the configured values.",
    example: "`[2000Value]`",
    remedy: "Describe the sub-indexes individually, each with its `ParameterValue`.",

    "portability/domain-without-type" = DOMAIN_WITHOUT_TYPE, Error, Entry(domain_without_type), fix Safe;
    summary: "a DOMAIN has no data type or access",
    checks: "An object of type DOMAIN must have `DataType` and `AccessType`. The standard does not require them: the data type is DOMAIN, the access `rw`.",
    why: "dcf-tools and python-canopen read both keys of each object with a value and fail if one is missing.",
    example: "`ObjectType=0x2` without `DataType`",
    remedy: "Write `DataType=0x000F` and `AccessType=rw` (the defaults).",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",

    "portability/empty-text" = EMPTY_TEXT, Error, Device(empty_text);
    summary: "a tool does not accept an empty string",
    checks: "`VendorName`, `ProductName` and `OrderCode` of the device and of its modules must not be empty if they are present.",
    why: "CANchkEDS reports mandatory keys without a value.",
    example: "`OrderCode=`",
    remedy: "Write the order code.",
    source: "CANchkEDS 4.0",

    "portability/file-reference" = FILE_REFERENCE, Note, Device(file_reference);
    summary: "a tool ignores the file of a DOMAIN",
    checks: "Reports entries of a DCF with an `UploadFile` or a `DownloadFile`. The finding is at the first one and lists the others.",
    why: "python-canopen and CANopenEditor neither load the file nor write its name back.",
    example: "`DownloadFile=firmware.bin`",
    remedy: "Load the file in the application, or use a tool that supports it.",

    "portability/implicit-pdo" = IMPLICIT_PDO, Note, Device(implicit_pdo);
    summary: "a PDO is implied by `CompactPDO` but not described",
    checks: "Reports PDOs that `CompactPDO` and the PDO counts in `[DeviceInfo]` imply without objects in the file.",
    why: "python-canopen and CANopenEditor ignore `CompactPDO` (CANopenEditor unless the file has modules), so they do not detect these PDOs.",
    example: "`NrOfTXPDO=2` and `CompactPDO=0x13` without `[1800]` and `[1801]`",
    remedy: "Describe the objects of the PDOs, for example with `objdict convert`.",

    "portability/long-value" = LONG_VALUE, Note, Device(long_value);
    summary: "a configured value has more than four bytes",
    checks: "Reports writable entries with a default or configured value whose type has more than four bytes or a variable length. The finding is at the first one and lists the others.",
    why: "CODESYS configures entries of up to four bytes by SDO; the application must write longer ones.",
    example: "A writable UNSIGNED64 with a default",
    remedy: "Write the entry from the application, or split it into entries of four bytes.",
    source: "Manual of CODESYS, tab `SDOs` of a CANopen remote device",

    "portability/mapping-of-structure" = MAPPING_OF_STRUCTURE, Error, Entry(mapping_of_structure), fix Safe;
    summary: "an object without a mappable value has `PDOMapping=0`",
    checks: "Reports `PDOMapping=0` in an ARRAY, RECORD or DEFSTRUCT without `CompactSubObj` and in a DOMAIN. The key does not belong there, but its value is right.",
    why: "node-canopen rejects keys of a value for these object types.",
    example: "`[1018]` with `ObjectType=0x9` and `PDOMapping=0`",
    remedy: "Remove the key.",
    source: "node-canopen 6.2.1",

    "portability/time-value" = TIME_VALUE, Warning, Device(time_value);
    summary: "a time of day or a duration has a value",
    checks: "Reports entries of type TIME_OF_DAY or TIME_DIFFERENCE with a default or configured value. The finding is at the first one and lists the others.",
    why: "python-canopen does not support these types and reads an integer: the space between days and milliseconds is removed, and `1 2` becomes 12.",
    example: "`DefaultValue=1 0x36EE80` of a TIME_OF_DAY",
    remedy: "Remove the value if 0 is acceptable.",
    source: "python-canopen 2.4.1",

    "portability/unclear-direction" = UNCLEAR_DIRECTION, Warning, Device(unclear_direction);
    summary: "a mappable entry is readable and writable",
    checks: "Entries with `PDOMapping=1` must have an access type with a direction: `ro`, `const` and `rwr` for TPDOs, `wo` and `rww` for RPDOs. Only the first one is shown.",
    why: "CANchkEDS cannot decide whether an entry with `rw` belongs to a TPDO or to an RPDO.",
    example: "`AccessType=rw` and `PDOMapping=1`",
    remedy: "Write `rwr` for an entry that TPDOs send, `rww` for one that RPDOs receive.",
    source: "CANchkEDS 4.0; CiA 306-1 §4.6.3.2",

    "portability/unused-mapping-slot" = UNUSED_MAPPING_SLOT, Warning, Pdo(unused_mapping_slot);
    summary: "a fixed PDO mapping has entries that it does not use",
    checks: "If `Granularity=0` specifies that the mapping cannot be changed, the default of sub-index 0 of each mapping must be its highest sub-index.",
    why: "CANchkEDS warns because the entries can never be used.",
    example: "`Granularity=0`, `[1A00sub0]` with `DefaultValue=1`, and `[1A00sub2]`",
    remedy: "Remove the unused entries, or write the granularity of a mapping that can be changed.",
    source: "CANchkEDS 4.0",
}

/// The places of the compact objects that a rule applies to.
fn compact_objects(
    device: &Device,
    part: fn(u16) -> Part,
    is_meant: impl Fn(&Object, &Compact) -> bool,
) -> impl Iterator<Item = Place> {
    device.objects.iter().filter_map(move |(&index, object)| {
        let compact = object.compact.as_ref()?;
        is_meant(object, compact).then(|| Place::of(part(index)))
    })
}

fn compact_denotations(device: &Device, findings: &mut Findings) {
    let places =
        compact_objects(device, Part::CompactDenotations, |_, compact| !compact.denotations.is_empty());
    let texts = (
        "not all tools read the denotations of a compact object",
        say!("use `{[xxxxName]}`, or describe the sub-indexes individually"),
    );
    COMPACT_DENOTATIONS.report_each(places, texts, findings);
}

fn compact_names(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::CompactNames, |_, compact| {
        !compact.names.is_empty() && !has_gap_in_names(compact)
    });
    let texts = ("not all tools read the names of a compact object", "describe the sub-indexes individually");
    COMPACT_NAMES.report_each(places, texts, findings);
}

/// Whether a name between 1 and the number of names is missing, which another rule reports.
fn has_gap_in_names(compact: &Compact) -> bool {
    (1..=compact.names.len()).any(|sub| compact.names.iter().all(|(named, _)| usize::from(*named) != sub))
}

fn compact_parameter_value(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::Object, |object, compact| {
        compact.values.is_empty() && object.main.configured_value().is_some()
    });
    let texts = (
        say!("`{ParameterValue}` of a compact object configures all sub-indexes"),
        say!("write the values in `{[xxxxValue]}`"),
    );
    COMPACT_PARAMETER_VALUE.report_each(places, texts, findings);
}

fn compact_storage(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::Object, |object, compact| {
        has_no_sections(compact) && object.main.configured_value().is_none()
    });
    let texts = (
        say!("not all tools support `{CompactSubObj}` as the standard defines it"),
        "describe the sub-indexes individually",
    );
    COMPACT_STORAGE.report_each(places, texts, findings);
}

/// Whether the object has no sections for its sub-indexes.
fn has_no_sections(compact: &Compact) -> bool {
    compact.names.is_empty() && compact.values.is_empty() && compact.denotations.is_empty()
}

fn compact_values(device: &Device, findings: &mut Findings) {
    let places = compact_objects(device, Part::CompactValues, |_, compact| !compact.values.is_empty());
    let texts =
        ("not all tools read the values of a compact object", "describe the sub-indexes individually");
    COMPACT_VALUES.report_each(places, texts, findings);
}

fn implicit_pdo(device: &Device, findings: &mut Findings) {
    let implicit = device.implicit_pdos();
    if implicit.is_empty() {
        return;
    }
    let rpdos = implicit.iter().filter(|(kind, _)| *kind == PdoKind::Rpdo).count();
    let message = match (rpdos, implicit.len() - rpdos) {
        (0, tpdos) => say!("`{CompactPDO}` implies {}", counted(tpdos, "TPDO", "TPDOs")),
        (rpdos, 0) => say!("`{CompactPDO}` implies {}", counted(rpdos, "RPDO", "RPDOs")),
        (rpdos, tpdos) => say!(
            "`{CompactPDO}` implies {} and {}",
            counted(rpdos, "RPDO", "RPDOs"),
            counted(tpdos, "TPDO", "TPDOs")
        ),
    };
    let place = Place::of(Part::DeviceInfo).field(Field::CompactPdo);
    findings.push(IMPLICIT_PDO.at(place, message).help("describe the objects of these PDOs"));
}

fn mapping_of_structure(at: &EntryAt<'_>, findings: &mut Findings) {
    let is_without_value = match at.object_type() {
        _ if at.origin != EntryOwner::Device => false,
        Some(ObjectType::Domain) => true,
        Some(object_type) => object_type.has_subs() && at.sub.is_none() && at.object.compact.is_none(),
        None => false,
    };
    if is_without_value && at.entry.pdo_mapping == Some(PdoMapping::No) {
        let place = at.field(Field::PdoMapping);
        let message = say!("this {} has `{PDOMapping=0}`", at.object_type().unwrap_or(ObjectType::Var));
        let finding = MAPPING_OF_STRUCTURE.at(place.clone(), message).help(say!("remove {the key}"));
        findings.push(finding.fix(Fix::safe(say!("remove {the key}")).remove(place)));
    }
}

fn unclear_direction(device: &Device, findings: &mut Findings) {
    let mut unclear = device.objects.iter().flat_map(|(&index, object)| {
        let entries = object.described();
        let unclear = entries.filter(|(_, entry)| entry.access == Some(Access::Rw) && entry.is_mappable());
        unclear.map(move |(sub, _)| Part::at(index, sub))
    });
    let Some(first) = unclear.next() else { return };
    let entries = counted(unclear.count() + 1, "entry is", "entries are");
    let message = say!("{} mappable with `{AccessType=rw}`, which specifies no direction", entries);
    let finding = UNCLEAR_DIRECTION.at(Place::of(first).field(Field::AccessType), message);
    findings.push(finding.help(say!("write `{AccessType=rwr}` for TPDOs, `{AccessType=rww}` for RPDOs")));
}

fn unused_mapping_slot(facts: &Facts<'_>, pdo: &PdoFacts<'_>, findings: &mut Findings) {
    let granularity = facts.device.device_info.as_ref().and_then(|info| info.granularity);
    let index = pdo.pdo.mapping_index();
    let highest = facts.device.object(index).and_then(crate::model::Object::highest_sub);
    let (Some(0), Some(count), Some(highest)) = (granularity, pdo.pdo.mapped_count, highest) else { return };
    if count < highest {
        let message = say!("{:04X}h has {} entries, but {} maps only `{}`", index, highest, pdo.pdo, count);
        let finding = UNUSED_MAPPING_SLOT.at(facts.device.value_place(index, 0), message);
        findings.push(finding.help("remove the unused entries, or write a different `Granularity`"));
    }
}

fn domain_without_type(at: &EntryAt<'_>, findings: &mut Findings) {
    if at.origin != EntryOwner::Device || at.object_type() != Some(ObjectType::Domain) {
        return;
    }
    let stated = [
        (Field::DataType, "0x000F", at.entry.data_type.is_some()),
        (Field::AccessType, "rw", at.entry.access.is_some()),
    ];
    let missing =
        stated.into_iter().filter(|(field, _, stated)| !stated && !stated::is_invalid(at.entry, field));
    let missing: Vec<(Field, &str)> = missing.map(|(field, value, _)| (field, value)).collect();
    if missing.is_empty() {
        return;
    }
    let lines: Vec<String> = missing.iter().map(|(field, value)| format!("{field}={value}")).collect();
    let message = say!("this DOMAIN has no {}", listing_or(missing.iter().map(|(field, _)| field)));
    let fix = Fix::safe(say!("add {}", listing(&lines)));
    let fix = missing.iter().fold(fix, |fix, (field, value)| fix.set(at.field(field.clone()), *value));
    findings.push(DOMAIN_WITHOUT_TYPE.at(at.place(), message).help(say!("add {}", listing(&lines))).fix(fix));
}

fn empty_text(device: &Device, findings: &mut Findings) {
    if let Some(info) = &device.device_info {
        report_empty_text(&Part::DeviceInfo, Field::VendorName, info.vendor_name.as_deref(), findings);
        report_empty_text(&Part::DeviceInfo, Field::ProductName, info.product_name.as_deref(), findings);
        report_empty_text(&Part::DeviceInfo, Field::OrderCode, info.order_code.as_deref(), findings);
    }
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let info = Part::Module(number, ModulePart::Info);
        report_empty_text(&info, Field::ProductName, module.product_name.as_deref(), findings);
        report_empty_text(&info, Field::OrderCode, module.order_code.as_deref(), findings);
    }
}

fn report_empty_text(part: &Part, field: Field, text: Option<&str>, findings: &mut Findings) {
    if text.is_some_and(|text| text.trim().is_empty()) {
        let message = say!("`{}` of `{}` is empty", field, part);
        findings.push(EMPTY_TEXT.at(Place::of(part.clone()).field(field), message).help("write the text"));
    }
}

fn file_reference(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device).filter_map(|(place, entry)| Some(place.field(file_field(entry)?)));
    let texts = ("not all tools load the file of this entry", "load the file in the application");
    FILE_REFERENCE.report_each(places, texts, findings);
}

fn file_field(entry: &Entry) -> Option<Field> {
    let configured = entry.configured.as_ref()?;
    let stated = [
        (Field::DownloadFile, configured.download_file.is_some()),
        (Field::UploadFile, configured.upload_file.is_some()),
    ];
    stated.into_iter().find(|(_, stated)| *stated).map(|(field, _)| field)
}

fn long_value(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device).filter(|(_, entry)| is_long_value(entry)).map(|(place, entry)| {
        let field =
            if entry.configured_value().is_some() { Field::ParameterValue } else { Field::DefaultValue };
        place.field(field)
    });
    let texts = ("the value has more than four bytes", "write the entry from the application");
    LONG_VALUE.report_each(places, texts, findings);
}

fn is_long_value(entry: &Entry) -> bool {
    let is_short = entry.data_type.and_then(DataType::byte_length).is_some_and(|bytes| bytes <= 4);
    entry.value().is_some() && entry.access.is_some_and(Access::is_writable) && !is_short
}

fn time_value(device: &Device, findings: &mut Findings) {
    let places = stated::entries(device).filter_map(|(place, entry)| Some(place.field(time_field(entry)?)));
    let texts = ("not all tools read times", "remove the value if 0 is acceptable");
    TIME_VALUE.report_each(places, texts, findings);
}

fn time_field(entry: &Entry) -> Option<Field> {
    match (entry.configured_value(), &entry.default) {
        (Some(Value::Time(_)), _) => Some(Field::ParameterValue),
        (_, Some(Value::Time(_))) => Some(Field::DefaultValue),
        _ => None,
    }
}

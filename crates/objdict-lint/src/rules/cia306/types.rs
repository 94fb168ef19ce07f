//! Object types, data types and reserved indexes.

use crate::diagnostic::{Argument, Findings, Fix, Text, counted, say, sub_index};
use crate::model::{DataType, Device, Field, Object, ObjectType, Part, Place, TypeKind};
use crate::rule::rules;
use crate::{EntryAt, profile};

rules! {
    "cia306/described-standard-type" = DESCRIBED_STANDARD_TYPE, Note, Device(described_standard_type);
    summary: "the file describes a data type of CiA 301",
    checks: "Reports objects 0001h to 0025h, the data types and structures that CiA 301 defines. Only the first one is shown.",
    why: "Every tool knows these types. Some reject a file with objects below 1000h, and the others learn nothing new.",
    example: "`[0005]`",
    remedy: "Remove the sections and their lines in the lists. Custom types start at 0040h.",
    source: "CiA 301 §7.4.7, table 44; CiA 306-1 §4.6.3",

    "cia306/domain-mismatch" = DOMAIN_MISMATCH, Warning, Entry(domain_mismatch), fix Unsafe;
    summary: "object type and data type disagree about a DOMAIN",
    checks: "An object or sub-index of object type DOMAIN must have the data type DOMAIN. An object with data type DOMAIN must have an object type other than VAR. A sub-index may have object type VAR.",
    why: "A DOMAIN is transferred in segments and has no value in memory. Some tools evaluate the object type, others the data type, so they treat the object differently.",
    example: "`ObjectType=0x7` and `DataType=0x000F`",
    remedy: "Write `ObjectType=0x2`, or correct the data type.",
    source: "CiA 301 §7.4.3, CiA 306-1 §4.6.3.2",

    "cia306/nested-structure" = NESTED_STRUCTURE, Warning, EntryOf(nested_structure), fix Mixed;
    summary: "an entry is a structure",
    checks: "Reports a sub-index or VAR whose object type has sub-indexes (ARRAY, RECORD, DEFSTRUCT). A structured data type is reported too: 0020h to 0025h, or a DEFSTRUCT of the file.",
    why: "A sub-index cannot have sub-indexes, so the parts of the structure cannot be accessed.",
    example: "`ObjectType=0x8` in `[2000sub1]`",
    remedy: "Use a separate sub-index or object for each part. In an object of CiA 301, write the data type of the document.",
    source: "CiA 301 §7.4.4",

    "cia306/null-object" = NULL_OBJECT, Warning, Object(null_object);
    summary: "an object of type NULL is described",
    checks: "Reports objects of object type 0, NULL.",
    why: "A NULL object has no data to read or write. Some tools show an object that does not respond, others reject the file.",
    example: "`ObjectType=0x0`",
    remedy: "Write the actual object type, or remove the object and its list entry.",
    source: "CiA 301 §7.4.3, table 42",

    "cia306/reserved-index" = RESERVED_INDEX, Warning, Object(reserved_index);
    summary: "an object has a reserved index",
    checks: "Reports objects with index 0000h or in 0260h to 0FFFh, 101Ah to 101Fh, 102Bh to 11FFh, 1C00h to 1EFFh or C000h to FFFFh.",
    why: "A later version of the standard may define the index, and tools will then misinterpret the device. A conformance test fails.",
    example: "`[C000]`",
    remedy: "Move vendor-specific objects to 2000h to 5FFFh.",
    source: "CiA 301 §7.4.1, tables 41 and 44; CiA 302-2 for 102Ah",

    "cia306/undefined-data-type" = UNDEFINED_DATA_TYPE, Error, EntryOf(undefined_data_type), stops "*";
    summary: "a data type is not defined",
    checks: "`DataType` must be a type of CiA 301 or, from 0040h to 025Fh, a DEFTYPE or DEFSTRUCT of the file.",
    why: "Length and meaning of the value are unknown; the value can be neither read nor written.",
    example: "`DataType=0x0017`",
    remedy: "Write the intended type, such as `0x0007` for UNSIGNED32, or describe a custom type in a section with its index.",
    source: "CiA 301 §7.4.7, table 44",
}

fn described_standard_type(device: &Device, findings: &mut Findings) {
    // links without a section do not describe an object
    let is_described = |(_, object): &(&u16, &Object)| !object.orphan || !object.subs.is_empty();
    let mut types = device.objects.range(0x0001..=0x0025).filter(is_described);
    let Some((&index, _)) = types.next() else { return };
    let name = DataType(index).name().unwrap_or("reserved");
    let others = types.count();
    let more = match others {
        0 => Text::default(),
        _ => say!(", and {} more", counted(others, "type", "types")),
    };
    let message = say!("{:04X}h ({}) is a type that CiA 301 defines{}", index, name, more);
    let finding = DESCRIBED_STANDARD_TYPE.at(Place::object(index), message);
    findings.push(
        finding
            .help(say!("remove the {sections}{}", Argument::OfLists(" and their lines in the lists".into()))),
    );
}

fn domain_mismatch(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(data_type) = at.entry.data_type else { return };
    let is_domain = at.entry.object_type == Some(ObjectType::Domain);
    if is_domain && data_type != DataType::DOMAIN {
        let finding = DOMAIN_MISMATCH.at(
            at.field(Field::DataType),
            say!("the object type is DOMAIN, but the data type is {}", data_type),
        );
        let fix = Fix::risky(say!("write `{DataType=0x000F}`")).set(at.field(Field::DataType), "0x000F");
        findings.push(finding.help(say!("write `{DataType=0x000F}`, or correct `{ObjectType}`")).fix(fix));
    } else if at.sub.is_none() && data_type == DataType::DOMAIN && at.object_type() == Some(ObjectType::Var) {
        let message = "the data type is DOMAIN, but the object type is VAR";
        let finding = DOMAIN_MISMATCH
            .at(at.field(Field::ObjectType), message)
            .label(at.field(Field::DataType), "a DOMAIN");
        // node-canopen rejects a DOMAIN with `PDOMapping`, even if it is 0
        let fix = match at.entry.pdo_mapping {
            None => Fix::risky(say!("write `{ObjectType=0x2}`")),
            Some(_) => Fix::risky(say!("write `{ObjectType=0x2}`, and remove `{PDOMapping}`"))
                .remove(at.field(Field::PdoMapping)),
        };
        let fix = fix.set(at.field(Field::ObjectType), "0x2");
        findings.push(finding.help(say!("write `{ObjectType=0x2}`, or correct `{DataType}`")).fix(fix));
    }
}

fn nested_structure(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let nested_type = at.sub.and(entry.object_type).filter(|object_type| object_type.has_subs());
    let structure = entry.data_type.filter(|&data_type| is_structure(device, data_type));
    let (field, kind) = match (nested_type, structure) {
        (Some(object_type), _) => (Field::ObjectType, object_type.to_string()),
        (None, Some(data_type)) if holds_one_value(at) => (Field::DataType, data_type.to_string()),
        _ => return,
    };
    let what = match at.sub {
        Some(sub) => say!("sub-index {} of {:04X}h", sub_index(sub), at.index),
        None => say!("{:04X}h", at.index),
    };
    let message = say!("{} is a structure ({}), but must be a single value", what, kind);
    let is_of_one_type = nested_type.is_some() && structure.is_none() && entry.data_type.is_some();
    let mut finding = NESTED_STRUCTURE.at(at.field(field.clone()), message);
    if is_of_one_type {
        // according to the data type it is a single value
        let title = say!("write `{ObjectType=0x7}`");
        finding = finding.fix(Fix::risky(title.clone()).set(at.field(field), "0x7")).help(title);
    } else {
        let documented =
            profile::data_type(device, at.index, at.sub).map(|data_type| format!("0x{:04X}", data_type.0));
        finding = finding.help(match documented {
            Some(code) => say!("write `{}`", Argument::setting(Field::DataType, code)),
            None => "use a separate sub-index or object for each part of the structure".into(),
        });
    }
    findings.push(finding);
}

/// Type definitions may refer to a structure, but objects and sub-indexes may not. The type of sub-index 0 has
/// its own rule.
fn holds_one_value(at: &EntryAt<'_>) -> bool {
    let is_definition = matches!(at.object.object_type(), ObjectType::DefType | ObjectType::DefStruct);
    at.holds_value() && !is_definition && at.sub != Some(0)
}

fn is_structure(device: &Device, data_type: DataType) -> bool {
    match data_type.kind() {
        TypeKind::Structure => true,
        TypeKind::Defined => device
            .object(data_type.0)
            .is_some_and(|object| object.main.object_type == Some(ObjectType::DefStruct)),
        _ => false,
    }
}

fn null_object(index: u16, object: &Object, findings: &mut Findings) {
    if object.main.object_type != Some(ObjectType::Null) {
        return;
    }
    let message = say!("{:04X}h is a NULL object, which has no data", index);
    let finding = NULL_OBJECT.at(Place::object(index).field(Field::ObjectType), message);
    findings.push(finding.help("write the actual object type, or remove the object"));
}

fn reserved_index(index: u16, object: &Object, findings: &mut Findings) {
    let area = match index {
        0x0260..=0x0FFF => "0260h to 0FFFh",
        0x101A..=0x101F => "101Ah to 101Fh",
        // CiA 302-2 defines 102Ah, the NMT inhibit time
        0x102B..=0x11FF => "102Bh to 11FFh",
        0x1C00..=0x1EFF => "1C00h to 1EFFh",
        0xC000.. => "C000h to FFFFh",
        0 => "0000h",
        _ => return,
    };
    if !object.orphan {
        let message = say!("{:04X}h is in a reserved area ({})", index, area);
        let finding = RESERVED_INDEX.at(Place::object(index), message);
        findings.push(finding.help(match index {
            0x0260..=0x0FFF => "move data types to 0040h to 025Fh",
            _ => "move vendor-specific objects to 2000h to 5FFFh",
        }));
    }
}

fn undefined_data_type(device: &Device, at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(data_type) = at.entry.data_type else { return };
    let why = match data_type.kind() {
        TypeKind::Reserved => "is not the index of a data type",
        TypeKind::Defined if !is_defined(device, data_type) => {
            "is a custom data type, but the file does not define it"
        }
        _ => return,
    };
    // the type of sub-index 0 has its own rule
    let is_count = at.sub == Some(0) && at.object.object_type().has_subs();
    if is_count || !at.holds_value() {
        return;
    }
    let message = say!("{:04X}h {}", data_type.0, why);
    let finding = UNDEFINED_DATA_TYPE.at(at.field(Field::DataType), message);
    findings.push(match data_type.kind() {
        TypeKind::Reserved => finding.help(say!("write a type of CiA 301, such as `{DataType:0x0007}` for UNSIGNED32")),
        _ => finding.help(say!(
            "write a type of CiA 301, such as `{DataType:0x0007}`, or describe a DEFTYPE or DEFSTRUCT in `{}`",
            Part::Object(data_type.0)
        )),
    });
}

fn is_defined(device: &Device, data_type: DataType) -> bool {
    let object_type = device.object(data_type.0).map(|object| object.main.object_type);
    matches!(object_type, Some(Some(ObjectType::DefType | ObjectType::DefStruct)))
}

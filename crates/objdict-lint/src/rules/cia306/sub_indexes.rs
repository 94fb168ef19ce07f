//! Sub-index 0, `SubNumber`, the elements of ARRAYs and RECORDs and sections of sub-indexes that do not match their object.

use crate::diagnostic::{
    Argument, Change, Diagnostic, Findings, Fix, Severity, Text, counted, listing, say, sub_index,
};
use crate::model::{
    Access, DataType, Device, Entry, ExtraSection, Field, Object, ObjectList, ObjectType, Part, Place, Value,
};
use crate::rule::rules;
use crate::{EntryAt, Facts, IndexSet, ListFixes, demands, stated, sub_0, with_members};

rules! {
    source: "CiA 301 §7.4.7.2, CiA 306-1 §4.6.3.2";

    "cia306/array-of-mixed-access" = ARRAY_OF_MIXED_ACCESS, Note, Device(array_of_mixed_access);
    summary: "the entries of an ARRAY have different access types",
    checks: "Sub-indexes 1 to FEh of an ARRAY must not differ in read or write access. `const` is treated as `ro`, `rwr` and `rww` as `rw`. The rule reports one finding per device, which lists every such ARRAY. Objects below 2000h are not checked, because CiA 301 and CiA 302 define their access types.",
    why: "Code generators and configuration tools treat the elements of an ARRAY alike and often use the access type of the first one for all.",
    example: "An ARRAY with `AccessType=rw` at sub-index 1 and `AccessType=ro` at sub-index 2",
    remedy: "Correct the access type, or write `ObjectType=0x9` (RECORD) where the device profile allows it.",
    source: "Not in a standard; CiA 301 §7.4.3 demands one data type only",

    "cia306/array-of-mixed-types" = ARRAY_OF_MIXED_TYPES, Error, Object(array_of_mixed_types), fix Unsafe;
    summary: "the entries of an ARRAY have different data types",
    checks: "Sub-indexes 1 to FEh of an ARRAY must all have the same `DataType`.",
    why: "Code generators use one element type for the whole array and truncate or misread the other elements.",
    example: "An ARRAY with an UNSIGNED8 at sub-index 1 and an UNSIGNED32 at sub-index 2",
    remedy: "Write `ObjectType=0x9` (RECORD), or correct the data type.",
    source: "CiA 301 §7.4.3, table 42",

    "cia306/compact-and-sub-number" = COMPACT_AND_SUB_NUMBER, Error, Object(compact_and_sub_number), fix Safe;
    summary: "an object has both `CompactSubObj` and `SubNumber`",
    checks: "`SubNumber` of an object with `CompactSubObj` must be 0, empty or missing. It may include sub-indexes that are described in addition to the compact ones.",
    why: "Both keys describe the sub-indexes. Some readers use one, some the other.",
    example: "`CompactSubObj=8` and `SubNumber=9`",
    remedy: "Remove `SubNumber`.",
    source: "CiA 306-1 §4.6.3.4.2",

    "cia306/contradictory-sub-0" = CONTRADICTORY_SUB_0, Warning, Object(contradictory_sub_0);
    summary: "the sections of a VAR and of its sub-index 0 disagree",
    checks: "A VAR that also has a section for sub-index 0 must have the same data type, access, mapping, default and limits in both. Keys that are in only one of them are not compared.",
    why: "Both sections describe the same value. Some tools read the first one, others the second one.",
    example: "`DataType=0x0006` in `[6040]` and `DataType=0x0007` in `[6040sub0]`",
    remedy: "Remove the section of the sub-index.",
    source: "CiA 301 §7.4.3, CiA 306-1 §4.6.3.2",

    "cia306/gap-in-array" = GAP_IN_ARRAY, Note, Object(gap_in_array);
    summary: "the sub-indexes of an ARRAY have a gap",
    checks: "The described sub-indexes of each ARRAY from 2000h to 5FFFh must be consecutive, except FFh. Other ranges are not checked: the standards define objects with gaps. For sub-indexes in decimal, see `cia306/wrong-highest-sub-index`.",
    why: "A gap is allowed, but programs iterate over an ARRAY from 1 to sub-index 0 and get an abort at the gap. Generated code has unused elements.",
    example: "`[2000sub1]` and `[2000sub3]`, and no `[2000sub2]`",
    remedy: "Describe the missing elements, or change the object to a RECORD.",
    source: "CiA 306-1 §4.6.3.2, CiA 301 §7.4.3",

    "cia306/missing-sub-0" = MISSING_SUB_0, Error, Object(missing_sub_0), fix Unsafe;
    summary: "an ARRAY or RECORD has no sub-index 0",
    checks: "Each ARRAY, RECORD and DEFSTRUCT without `CompactSubObj` must describe sub-index 0.",
    why: "Managers first read sub-index 0 to get the number of entries.",
    example: "`[1003]` with `[1003sub1]` only",
    remedy: "Describe sub-index 0: UNSIGNED8, with the highest sub-index as its default.",

    "cia306/object-without-entries" = OBJECT_WITHOUT_ENTRIES, Warning, Facts(object_without_entries);
    summary: "an ARRAY or RECORD has no entry except sub-index 0",
    checks: "Each ARRAY and RECORD without `CompactSubObj` must describe a sub-index in addition to sub-index 0. PDO mappings, objects of modular devices and objects whose sub-index 0 specifies more entries are not checked. Missing sub-indexes that a document requires have their own rules.",
    why: "The object holds no data. The descriptions of its entries were probably lost.",
    example: "`[2000]` with `ObjectType=0x8` and `SubNumber=1`, and only `[2000sub0]`",
    remedy: "Describe the entries, or remove the object.",
    source: "CiA 301 §7.4.3; CiA 306-1 §4.6.3.2",

    "cia306/sub-0-type" = SUB_0_TYPE, Error, Entry(sub_0_type), fix Unsafe;
    summary: "sub-index 0 is not an UNSIGNED8",
    checks: "Sub-index 0 of an ARRAY, RECORD or DEFSTRUCT must have the data type UNSIGNED8. An exception is the obsolete 1004h, where it is a number of PDOs.",
    why: "Sub-index 0 is the highest sub-index, and managers read one byte.",
    example: "`[1A00sub0]` with `DataType=0x0007`",
    remedy: "Write `DataType=0x0005`.",
    source: "CiA 301 §7.4.7.2",

    "cia306/sub-number-mismatch" = SUB_NUMBER_MISMATCH, Error, ObjectOf(sub_number_mismatch), fix Mixed,
        explains Object [
            "wrong-highest-sub-index", "gap-in-mapping", "gap-in-array", "missing-sub-index", "wrong-mapping-count",
            "incomplete-pdo-parameter", "incomplete-sdo-parameter"
        ];
    summary: "`SubNumber` does not match the described sub-indexes",
    checks: "`SubNumber` of an ARRAY, RECORD or DEFSTRUCT must equal the number of its sections, including sub-index 0, excluding sub-index FFh. Gaps are legal: `SubNumber` is not the highest sub-index plus one.",
    why: "Readers that use `SubNumber` overlook the last sub-indexes or look for missing ones.",
    example: "`SubNumber=3` where sub-indexes 0 to 3 are described",
    remedy: "Write the number of sections.",
    source: "CiA 306-1 §4.6.3.2",

    "cia306/sub-of-var" = SUB_OF_VAR, Error, Object(sub_of_var);
    summary: "a VAR or DOMAIN has sub-indexes",
    checks: "An object of type VAR, DOMAIN, DEFTYPE or NULL must not describe sub-indexes. Only sub-index 0 is accepted: it may describe the value of a VAR.",
    why: "Some tools treat the object as a single value and drop its sub-indexes, others treat it as a RECORD.",
    example: "`ObjectType=0x7` in `[2000]`, and `[2000sub1]`",
    remedy: "Write `ObjectType=0x9` (RECORD) or `0x8` (ARRAY), or remove the sub-indexes.",
    source: "CiA 301 §7.4.3",

    "cia306/sub-without-object" = SUB_WITHOUT_OBJECT, Error, Device(sub_without_object), fix Unsafe;
    summary: "a sub-index has no object",
    checks: "The object of each sub-index must have a section.",
    why: "Object type and name are missing; many tools reject the file.",
    example: "`[2001sub1]` without `[2001]`",
    remedy: "Describe the object, or remove its sub-indexes.",
    source: "CiA 306-1 §4.6.3.2",

    "cia306/wrong-highest-sub-index" = WRONG_HIGHEST_SUB_INDEX, Error,
        Object(wrong_highest_sub_index), fix Unsafe;
    summary: "sub-index 0 is not the highest sub-index",
    checks: "The value of sub-index 0 must be the highest described sub-index, excluding FFh. A lower value is an error; a higher or missing value is a warning. Sub-indexes that are evidently decimal, `[2000sub10]` after `[2000sub9]` with the name or the count 10, are an error: they are read as hexadecimal, and those from 100 on are lost. Objects with a writable sub-index 0 are not checked. Neither are objects whose sub-index 0 is the number of used entries (error history, PDO and SRDO mappings, lists for multiplexed PDOs).",
    why: "Managers read as many entries as sub-index 0 indicates. They never see entries above it and get an abort for missing ones.",
    example: "`[1018sub0]` with `DefaultValue=3`, and `[1018sub4]`",
    remedy: "Write the highest sub-index, or describe the missing entries.",

    "cia306/wrong-structure-entry" = WRONG_STRUCTURE_ENTRY, Error, Object(wrong_structure_entry);
    summary: "sub-index FFh does not match the object",
    checks: "Each sub-index FFh, which describes the structure of its object, must be an UNSIGNED32 with the object code in the lowest byte and the data type above. A missing value is accepted, and DEFSTRUCTs are not checked.",
    why: "A master that reads FFh gets a wrong object type or data type.",
    example: "`[2000subFF]` with `DefaultValue=0x00000509` in an ARRAY",
    remedy: "Write `0x00`, four digits of the data type and two digits of the object code: `0x00000508` is an ARRAY of UNSIGNED8.",
    source: "CiA 301 §7.4.7.2",
}

fn compact_and_sub_number(index: u16, object: &Object, findings: &mut Findings) {
    let Some(compact) = &object.compact else { return };
    let Some(number) = object.sub_number.filter(|&number| number > 0) else { return };
    let is_structure = stated::object_type(object).is_some_and(ObjectType::has_subs);
    if !is_structure || stated::described_subs(object) == usize::from(number) {
        return;
    }
    let count = compact.count;
    let message = say!("`{SubNumber}` is {}, but `{CompactSubObj}` already defines {}", number, count);
    let place = |field| Place::object(index).field(field);
    let finding = COMPACT_AND_SUB_NUMBER
        .at(place(Field::SubNumber), message)
        .label(place(Field::CompactSubObj), say!("sub-indexes 0 to {}", count));
    let fix = Fix::safe(say!("remove `{SubNumber}`")).remove(place(Field::SubNumber));
    findings.push(finding.help(say!("remove `{SubNumber}`")).fix(fix));
}

fn contradictory_sub_0(index: u16, object: &Object, findings: &mut Findings) {
    let Some(sub_0) = object.subs.get(0).filter(|_| object.subs.len() == 1) else { return };
    if stated::object_type(object).is_none_or(ObjectType::has_subs) {
        return;
    }
    let fields = different_fields(&object.main, sub_0);
    let Some(first) = fields.first() else { return };
    let message = say!("sub-index 0 of {:04X}h has a different {} than the object", index, listing(&fields));
    let finding = CONTRADICTORY_SUB_0
        .at(Place::entry(index, 0).field(first.clone()), message)
        .label(Place::object(index).field(first.clone()), "the object");
    findings.push(finding.help(say!("remove the {section} of the sub-index")));
}

/// The fields that are in both and differ.
fn different_fields(object: &Entry, sub_0: &Entry) -> Vec<Field> {
    fn differ<T: PartialEq>(left: &Option<T>, right: &Option<T>) -> bool {
        matches!((left, right), (Some(left), Some(right)) if left != right)
    }
    let fields = [
        (Field::DataType, differ(&object.data_type, &sub_0.data_type)),
        (Field::AccessType, differ(&object.access, &sub_0.access)),
        (Field::DefaultValue, differ(&object.default, &sub_0.default)),
        (Field::PdoMapping, differ(&object.pdo_mapping, &sub_0.pdo_mapping)),
        (Field::LowLimit, differ(&object.low_limit, &sub_0.low_limit)),
        (Field::HighLimit, differ(&object.high_limit, &sub_0.high_limit)),
    ];
    fields.into_iter().filter(|(_, differ)| *differ).map(|(field, _)| field).collect()
}

fn missing_sub_0(index: u16, object: &Object, findings: &mut Findings) {
    if object.subs.get(0).is_some() || object.compact.is_some() {
        return;
    }
    // other rules report an object without sub-indexes
    let counted_only = object.subs.is_empty() && object.sub_number != Some(0);
    let Some(object_type) = stated::object_type(object).filter(|object_type| object_type.has_subs()) else {
        return;
    };
    if counted_only {
        return;
    }
    let article = if object_type == ObjectType::Array { "an" } else { "a" };
    let message = say!("{:04X}h is {} {} without sub-index 0", index, article, object_type);
    let highest = object.highest_sub().unwrap_or_default();
    let finding = MISSING_SUB_0.at(Place::object(index), message);
    let finding = finding.fix(add_sub_0(index, object));
    findings.push(finding.help(say!(
        "add `{}` of type UNSIGNED8 with `{}`",
        Part::Entry(index, 0),
        Argument::setting(Field::DefaultValue, highest)
    )));
}

/// Adds sub-index 0 and updates `SubNumber`.
fn add_sub_0(index: u16, object: &Object) -> Fix {
    let fix = Fix::risky(say!("add `{}`", Part::Entry(index, 0))).with(sub_0(index, object));
    let described = stated::described_subs(object) + 1;
    if object.sub_number.map(usize::from) == Some(described) {
        return fix;
    }
    fix.set(Place::object(index).field(Field::SubNumber), described.to_string())
}

fn sub_0_type(at: &EntryAt<'_>, findings: &mut Findings) {
    let (Some(0), Some(expected), Some(data_type)) =
        (at.sub, DataType::of_sub_0(at.index), at.entry.data_type)
    else {
        return;
    };
    if data_type != expected && stated::object_type(at.object).is_some_and(ObjectType::has_subs) {
        let message = say!("sub-index 0 of {:04X}h is {}, not UNSIGNED8", at.index, data_type);
        let finding = SUB_0_TYPE.at(at.field(Field::DataType), message);
        let fix = Fix::risky(say!("write `{DataType=0x0005}`")).set(at.field(Field::DataType), "0x0005");
        let finding = Diagnostic { fix: at.entry.fits_type(expected).then_some(fix), ..finding };
        findings.push(finding.help(say!("write `{DataType=0x0005}`")));
    }
}

fn sub_number_mismatch(device: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(stated) = object.sub_number.map(usize::from) else { return };
    // `[1A02subx]`, which has its own finding, is one of the sub-indexes
    let prefix = format!("{index:04X}sub");
    let is_sub = |name: &str| name.get(..7).is_some_and(|start| start.eq_ignore_ascii_case(&prefix));
    let malformed = || device.extra.iter().map(ExtraSection::name).filter(|name| is_sub(name));
    let described = stated::described_subs(object) + malformed().count();
    if stated == described || object.compact.is_some() {
        return;
    }
    // another rule reports a sub-index 0 that is counted but missing
    let only_sub_0_missing = described > 0 && stated == described + 1 && object.subs.get(0).is_none();
    if only_sub_0_missing || !stated::object_type(object).is_some_and(ObjectType::has_subs) {
        return;
    }
    let described_text = match described {
        0 => "no sub-index is".to_owned(),
        _ => counted(described, "sub-index is", "sub-indexes are"),
    };
    let message = say!("`{SubNumber}` is {}, but {} described", stated, described_text);
    let finding = SUB_NUMBER_MISMATCH.at(Place::object(index).field(Field::SubNumber), message);
    findings.push(if described == 0 {
        finding.help(say!("describe the sub-indexes, or correct `{ObjectType}`"))
    } else {
        let title = say!("write `{}`", Argument::setting(Field::SubNumber, described));
        if let Some(name) = malformed().next() {
            findings.push(finding.help(say!("correct the section name `[{}]`, then {}", name, title)));
            return;
        }
        let place = Place::object(index).field(Field::SubNumber);
        // if sub-index 0 agrees with `SubNumber`, a section is missing
        let value = object.value(0).and_then(|value| value.as_integer());
        let is_lost = stated > described && value == i128::try_from(stated).ok().map(|stated| stated - 1);
        let fix = if is_lost { Fix::risky(title.clone()) } else { Fix::safe(title.clone()) };
        finding.fix(fix.set(place, described.to_string())).help(if stated > described {
            say!("describe the others, or {}", title)
        } else {
            title
        })
    });
}

fn sub_of_var(index: u16, object: &Object, findings: &mut Findings) {
    let Some((sub, _)) = object.subs.iter().find(|&(sub, _)| sub != 0) else { return };
    let Some(object_type) = stated::object_type(object).filter(|object_type| !object_type.has_subs()) else {
        return;
    };
    let message = say!("{:04X}h is a {}, but has sub-index {}", index, object_type, sub_index(sub));
    let finding = SUB_OF_VAR
        .at(Place::entry(index, sub), message)
        .label(Place::object(index).field(Field::ObjectType), say!("a {}", object_type));
    findings.push(finding.help(say!(
        "write `{ObjectType=0x9}` in `{}` (or `{ObjectType:0x8}` for an ARRAY), or remove the sub-indexes",
        Part::Object(index)
    )));
}

fn sub_without_object(device: &Device, findings: &mut Findings) {
    let mut orphans = device.objects.iter().filter(|(_, object)| object.orphan).peekable();
    if orphans.peek().is_none() {
        return;
    }
    let listed: IndexSet = device.lists.iter().map(|(_, index)| index).collect();
    let mut fixes = ListFixes::new();
    for (&index, object) in orphans {
        let Some((sub, _)) = object.subs.iter().next() else { continue };
        let message = say!("sub-indexes of {:04X}h are described, but the object is missing", index);
        let finding = SUB_WITHOUT_OBJECT.at(Place::entry(index, sub), message);
        let title =
            say!("add {a section} `{}` with name, object type and `{SubNumber}`", Part::Object(index));
        let mut finding = finding.help(title.clone());
        let list = ObjectList::of(index).filter(|&list| !listed.contains(index) && device.lists.has(list));
        finding.fix = match list {
            Some(list) => {
                let members = device.lists.get(list);
                fixes.next(members, || {
                    let others = with_members(members, [index]);
                    object_section(title, index, object).with(Change::List(list, others))
                })
            }
            None => Some(object_section(title, index, object)),
        };
        findings.push(finding);
    }
}

/// The missing section of the object, with sub-index 0 if that is also missing.
fn object_section(title: Text, index: u16, object: &Object) -> Fix {
    let fix = Fix::risky(title);
    let (fix, described) = match object.subs.get(0) {
        Some(_) => (fix, stated::described_subs(object)),
        None => (fix.with(sub_0(index, object)), stated::described_subs(object) + 1),
    };
    let keys = [
        (Field::ParameterName, format!("Object {index:04X}h")),
        (Field::ObjectType, "0x9".to_owned()),
        (Field::SubNumber, described.to_string()),
    ];
    fix.with(Change::Add(Part::Object(index), keys.to_vec()))
}

fn wrong_highest_sub_index(index: u16, object: &Object, findings: &mut Findings) {
    let Some(sub_0) = object.subs.get(0) else { return };
    let counts = stated::counts_otherwise(index) || sub_0.access.is_some_and(Access::is_writable);
    let is_list = stated::object_type(object).is_some_and(ObjectType::has_subs);
    if is_list && is_decimal(object) {
        let message = say!("{:04X}h has sub-index 10h, which is 16, directly after 9", index);
        let finding = WRONG_HIGHEST_SUB_INDEX.at(Place::entry(index, 0x10), message);
        let (wrong, right) = (Part::Entry(index, 0x10), Part::Entry(index, 0xA));
        let help =
            say!("sub-indexes are hexadecimal: write `{}` for `{}`, and rename the others", right, wrong);
        findings.push(finding.help(help));
        return;
    }
    if counts || object.compact.is_some() || !is_list {
        return;
    }
    let highest = object.highest_sub().unwrap_or_default();
    let (field, value) = match (sub_0.configured_value(), &sub_0.default) {
        (Some(value), _) => (Field::ParameterValue, value.as_integer()),
        (None, Some(value)) => (Field::DefaultValue, value.as_integer()),
        (None, None) => return missing_highest(index, sub_0, highest, findings),
    };
    let Some(value) = value.filter(|&value| value != i128::from(highest)) else { return };
    let place = Place::entry(index, 0).field(field.clone());
    let title = say!("write `{}`", Argument::setting(&field, highest));
    let fix = Fix::risky(title).set(place.clone(), highest.to_string());
    let finding = if value < i128::from(highest) {
        let message =
            say!("sub-index 0 of {:04X}h is {}, but sub-index {} is described", index, value, highest);
        WRONG_HIGHEST_SUB_INDEX
            .at(place, message)
            .label(Place::entry(index, highest), "the highest sub-index")
            .help(say!("write `{}`", Argument::setting(&field, highest)))
    } else {
        let message = say!(
            "sub-index 0 of {:04X}h is {}, but the highest described sub-index is {}",
            index,
            value,
            highest
        );
        WRONG_HIGHEST_SUB_INDEX
            .at(place, message)
            .severity(Severity::Warning)
            .help(say!("describe the missing sub-indexes, or write `{}`", Argument::setting(&field, highest)))
    };
    findings.push(finding.fix(fix));
}

fn missing_highest(index: u16, sub_0: &Entry, highest: u8, findings: &mut Findings) {
    if !sub_0.invalid_values.is_empty() || sub_0.data_type.is_none() {
        return;
    }
    let message = say!("sub-index 0 of {:04X}h has no value", index);
    let place = Place::entry(index, 0).field(Field::DefaultValue);
    let fix = Fix::risky(say!("write `{}`", Argument::setting(Field::DefaultValue, highest)))
        .set(place.clone(), highest.to_string());
    let finding = WRONG_HIGHEST_SUB_INDEX.at(place, message).severity(Severity::Warning).fix(fix);
    findings.push(
        finding
            .help(say!("write `{}`, the highest sub-index", Argument::setting(Field::DefaultValue, highest))),
    );
}

fn wrong_structure_entry(index: u16, object: &Object, findings: &mut Findings) {
    let Some(entry) = object.subs.get(0xFF) else { return };
    let object_type =
        stated::object_type(object).filter(|kind| matches!(kind, ObjectType::Array | ObjectType::Record));
    let Some(object_type) =
        object_type.filter(|_| entry.object_type.is_none_or(|kind| kind == ObjectType::Var))
    else {
        return;
    };
    // if sub-index 0 is 255, FFh is an ordinary element
    let is_element = object.value(0).is_some_and(|count| count.as_integer() == Some(0xFF));
    if is_element {
        return;
    }
    let place = |field| Place::entry(index, 0xFF).field(field);
    let finding = if let Some(other) = entry.data_type.filter(|&data_type| data_type != DataType::UNSIGNED32)
    {
        let message = say!("sub-index FFh of {:04X}h is {}, but must be UNSIGNED32", index, other);
        WRONG_STRUCTURE_ENTRY.at(place(Field::DataType), message)
    } else if let Some(code) =
        stated_object_code(entry).filter(|&code| code != i128::from(object_type.code()))
    {
        let message = say!(
            "sub-index FFh of {:04X}h has object code {}, but the object is {}",
            index,
            code,
            object_type
        );
        let finding = WRONG_STRUCTURE_ENTRY.at(place(Field::DefaultValue), message);
        finding.label(Place::object(index).field(Field::ObjectType), "the object type")
    } else {
        return;
    };
    let code = object_type.code();
    findings.push(finding.help(say!(
        "write an UNSIGNED32 such as `{}{:02X}`, with four digits of the data type",
        "0x0000{data type}",
        code
    )));
}

/// The object code: the lowest byte of the value.
fn stated_object_code(entry: &Entry) -> Option<i128> {
    Some(entry.default.as_ref().and_then(Value::as_integer)? & 0xFF)
}

fn array_of_mixed_access(device: &Device, findings: &mut Findings) {
    let objects = device.objects.range(0x2000..);
    for (&index, object) in objects {
        let Some((first, other)) = first_other_access(object) else { continue };
        let place = |sub| Place::entry(index, sub).field(Field::AccessType);
        let message = say!(
            "sub-index {} of the ARRAY {:04X}h is `{}`, but sub-index {} is `{}`",
            sub_index(other.0),
            index,
            other.1,
            sub_index(first.0),
            first.1
        );
        let finding = ARRAY_OF_MIXED_ACCESS
        .at(place(other.0), message)
        .label(place(first.0), say!("`{}` here", first.1))
        .help(match index {
            0x6000.. => say!(
                "correct the access type, or write `{ObjectType=0x9}` in `{}` where the device profile allows a RECORD",
                Part::Object(index)
            ),
            _ => say!("correct the access type, or write `{ObjectType=0x9}` (RECORD) in `{}`", Part::Object(index)),
        });
        findings.push(finding);
    }
}

/// The first element of an ARRAY and the first element with a different access type.
fn first_other_access(object: &Object) -> Option<((u8, Access), (u8, Access))> {
    let is_array =
        object.main.object_type == Some(ObjectType::Array) && stated::object_type(object).is_some();
    let elements = object.subs.iter().filter(|(sub, _)| is_array && (1..=0xFE).contains(sub));
    let mut stated = elements.filter_map(|(sub, entry)| Some((sub, entry.access?)));
    let kind = |access: Access| (access.is_readable(), access.is_writable());
    let first = stated.next()?;
    stated.find(|other| kind(other.1) != kind(first.1)).map(|other| (first, other))
}

fn array_of_mixed_types(index: u16, object: &Object, findings: &mut Findings) {
    if object.main.object_type != Some(ObjectType::Array) || stated::object_type(object).is_none() {
        return;
    }
    let members = object.subs.iter().filter(|(sub, _)| (1..=0xFE).contains(sub));
    let mut types = members.filter_map(|(sub, entry)| Some((sub, entry.data_type?)));
    let Some((first, data_type)) = types.next() else { return };
    let Some((sub, other)) = types.find(|&(_, other)| other != data_type) else { return };
    let message = say!(
        "sub-index {} of an ARRAY is {}, but sub-index {} is {}",
        sub_index(sub),
        other,
        sub_index(first),
        data_type
    );
    let place = |sub| Place::entry(index, sub).field(Field::DataType);
    let finding =
        ARRAY_OF_MIXED_TYPES.at(place(sub), message).label(place(first), say!("{} here", data_type));
    let object_type = Place::object(index).field(Field::ObjectType);
    let fix = Fix::risky(say!("write `{ObjectType=0x9}`")).set(object_type, "0x9");
    let part = Part::Object(index);
    let help = say!("write `{ObjectType=0x9}` in `{}` (RECORD), or correct the data type", part);
    findings.push(finding.help(help).fix(fix));
}

/// Whether the sub-indexes are numbered in decimal: 10h follows 9, none has a letter, and sub-index 0 or the name is 10 where 10h
/// is 16.
fn is_decimal(object: &Object) -> bool {
    let decimal = |sub: u8| (sub >> 4 < 10 && sub & 0xF < 10).then_some((sub >> 4) * 10 + (sub & 0xF));
    let (Some(_), Some(tenth)) = (object.subs.get(9), object.subs.get(0x10)) else { return false };
    let mut subs = object.subs.iter().filter(|(sub, _)| *sub != 0xFF).map(|(sub, _)| decimal(sub));
    let count = object.value(0).and_then(|count| count.as_integer());
    let is_counted = object.highest_sub().and_then(decimal).map(i128::from) == count;
    let digits = tenth.name.trim_start_matches(|char: char| !char.is_ascii_digit());
    subs.all(|sub| sub.is_some()) && (is_counted || digits.trim_end() == "10")
}

fn gap_in_array(index: u16, object: &Object, findings: &mut Findings) {
    let is_array = object.main.object_type == Some(ObjectType::Array) && object.compact.is_none();
    if !(0x2000..0x6000).contains(&index) || !is_array || object.orphan || is_decimal(object) {
        return;
    }
    let mut subs = object.subs.iter().map(|(sub, _)| sub).filter(|&sub| sub != 0xFF);
    let Some(mut last) = subs.next() else { return };
    for sub in subs {
        if sub != last + 1 {
            let message =
                say!("{:04X}h has sub-index {} directly after {}", index, sub_index(sub), sub_index(last));
            let finding = GAP_IN_ARRAY.at(Place::entry(index, sub), message);
            findings.push(finding.help("describe the missing elements, or change the object to a RECORD"));
            return;
        }
        last = sub;
    }
}

fn object_without_entries(facts: &Facts<'_>, findings: &mut Findings) {
    let device = facts.device;
    if device.is_modular() {
        return;
    }
    for (&index, object) in &device.objects {
        let is_list = matches!(stated::object_type(object), Some(ObjectType::Array | ObjectType::Record));
        let has_only_sub_0 = object.subs.len() == 1 && object.subs.get(0).is_some();
        let counts_none = object.value(0).is_none_or(|count| count.as_integer() == Some(0));
        let is_checked = is_list && has_only_sub_0 && counts_none && object.compact.is_none();
        if !is_checked || stated::counts_otherwise(index) || demands_entries(facts, index) {
            continue;
        }
        let message = say!("{:04X}h has no entry besides sub-index 0", index);
        let finding = OBJECT_WITHOUT_ENTRIES.at(Place::object(index), message);
        findings.push(finding.help("describe the entries, or remove the object"));
    }
}

/// Whether a document requires an entry, which another rule reports.
fn demands_entries(facts: &Facts<'_>, index: u16) -> bool {
    demands::applied(facts.device, facts.options).iter().any(|applied| {
        let object = applied.profile.object_in(applied.block, index);
        object.is_some_and(|object| object.entries().any(|entry| entry.first > 0 && entry.is_mandatory()))
    })
}

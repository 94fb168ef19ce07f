//! The elements of ARRAYs and RECORDs.

use crate::diagnostic::{Findings, Fix, say, sub_index};
use crate::model::{Access, Device, Field, Object, ObjectType, Place};
use crate::rule::rules;
use crate::{Facts, demands, stated, with_others};

rules! {
    source: "CiA 301 §7.4.3, table 42";

    "cia306/array-of-mixed-access" = ARRAY_OF_MIXED_ACCESS, Note, Device(array_of_mixed_access);
    summary: "the entries of an ARRAY have different access types",
    checks: "Whether sub-indexes 1 to FEh of each ARRAY can all be read, and all be written, or none. `const` counts as `ro`, `rwr` and `rww` as `rw`. The rule reports one finding for the device, with every such ARRAY. Objects below 2000h are not checked, because CiA 301 and CiA 302 define their access types.",
    why: "Code generators and configuration tools treat the elements of an ARRAY alike, and often use the access type of the first one for all.",
    example: "An ARRAY with `AccessType=rw` at sub-index 1 and `AccessType=ro` at sub-index 2",
    remedy: "Correct the access type, or write `ObjectType=0x9` (RECORD) where the device profile allows it.",

    "cia306/array-of-mixed-types" = ARRAY_OF_MIXED_TYPES, Error, Object(array_of_mixed_types), fix Unsafe;
    summary: "the entries of an ARRAY have different data types",
    checks: "Whether sub-indexes 1 to FEh of an ARRAY all have the same `DataType`.",
    why: "Code generators use one element type for the whole array and truncate or misread the other elements.",
    example: "An ARRAY with an UNSIGNED8 at sub-index 1 and an UNSIGNED32 at sub-index 2",
    remedy: "Write `ObjectType=0x9` (RECORD), or correct the data type.",

    "cia306/gap-in-array" = GAP_IN_ARRAY, Note, Object(gap_in_array);
    summary: "the sub-indexes of an ARRAY have a gap",
    checks: "Whether the described sub-indexes of each ARRAY from 2000h to 5FFFh are consecutive, except FFh. Other ranges are not checked: the standards define objects with gaps.",
    why: "A gap is allowed, but programs iterate over an ARRAY from 1 to sub-index 0 and get an abort at the gap, and generated code has unused elements. Sometimes sub-indexes were written in decimal: `[2000sub10]` is the sixteenth.",
    example: "`[2000sub1]` and `[2000sub3]`, and no `[2000sub2]`",
    remedy: "Describe the missing elements, or change the object to a RECORD.",
    source: "CiA 306-1 §4.6.3.2, CiA 301 §7.4.3",

    "cia306/object-without-entries" = OBJECT_WITHOUT_ENTRIES, Warning, Facts(object_without_entries);
    summary: "an ARRAY or RECORD has no entry besides sub-index 0",
    checks: "Whether each ARRAY and RECORD without `CompactSubObj` describes a further sub-index. PDO mappings, objects of modular devices, and objects whose sub-index 0 counts more entries are not checked; missing sub-indexes that a document requires have their own rules.",
    why: "The object holds no data. The descriptions of its entries were probably lost.",
    example: "`[2000]` with `ObjectType=0x8` and `SubNumber=1`, and only `[2000sub0]`",
    remedy: "Describe the entries, or remove the object.",
    source: "CiA 301 §7.4.3; CiA 306-1 §4.6.3.2",
}

fn array_of_mixed_access(device: &Device, findings: &mut Findings) {
    let objects = device.objects.range(0x2000..);
    let mut mixed = objects.filter_map(|(&index, object)| Some((index, first_other_access(object)?)));
    let Some((index, (first, other))) = mixed.next() else { return };
    let place = |index, sub| Place::entry(index, sub).field(Field::AccessType);
    let message = say!(
        "sub-index {} of the ARRAY {:04X}h is `{}`, sub-index {} is `{}`",
        sub_index(other.0),
        index,
        other.1,
        sub_index(first.0),
        first.1
    );
    let finding = ARRAY_OF_MIXED_ACCESS
        .at(place(index, other.0), message)
        .label(place(index, first.0), say!("`{}` here", first.1))
        .help(say!(
            "correct the access type, or write `{ObjectType=0x9}` (RECORD) where the device profile allows it"
        ));
    let others = mixed.map(|(index, (_, (sub, access)))| (place(index, sub), say!("`{}` here", access)));
    findings.push(with_others(finding, others));
}

/// The first element of an ARRAY, and the first whose access type differs from it.
fn first_other_access(object: &Object) -> Option<((u8, Access), (u8, Access))> {
    let is_array =
        object.main.object_type == Some(ObjectType::Array) && stated::object_type(object).is_some();
    let elements = object.subs.iter().filter(|(sub, _)| is_array && (1..=0xFE).contains(sub));
    let mut stated = elements.filter_map(|(sub, entry)| Some((sub, entry.access?)));
    let kind = |access: Access| (access.is_readable(), access.is_writable());
    let first = stated.next()?;
    stated.find(|other| kind(other.1) != kind(first.1)).map(|other| (first, other))
}

fn array_of_mixed_types(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    if object.main.object_type != Some(ObjectType::Array) || stated::object_type(object).is_none() {
        return;
    }
    let members = object.subs.iter().filter(|(sub, _)| (1..=0xFE).contains(sub));
    let mut types = members.filter_map(|(sub, entry)| Some((sub, entry.data_type?)));
    let Some((first, data_type)) = types.next() else { return };
    let Some((sub, other)) = types.find(|&(_, other)| other != data_type) else { return };
    let message = say!(
        "sub-index {} of an ARRAY is {}, sub-index {} is {}",
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
    findings.push(finding.help(say!("write `{ObjectType=0x9}` (RECORD), or correct the data type")).fix(fix));
}

fn gap_in_array(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let is_array = object.main.object_type == Some(ObjectType::Array) && object.compact.is_none();
    if !(0x2000..0x6000).contains(&index) || !is_array || object.orphan {
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

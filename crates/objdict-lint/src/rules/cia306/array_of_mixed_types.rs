use crate::diagnostic::{Diagnostic, Findings, Fix, say, sub_index};
use crate::model::{Device, Field, Object, ObjectType, Place};
use crate::{rule, stated};

rule! {
    "cia306/array-of-mixed-types", Error, Object(check), fix Unsafe;
    summary: "the entries of an ARRAY have different data types",
    checks: "Whether sub-indexes 1 to FEh of an ARRAY all have the same `DataType`.",
    why: "Code generators use one element type for the whole array and truncate or misread the other elements.",
    example: "An ARRAY with an UNSIGNED8 at sub-index 1 and an UNSIGNED32 at sub-index 2",
    remedy: "Write `ObjectType=0x9` (RECORD), or correct the data type.",
    source: "CiA 301 §7.4.3, table 42",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
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
        Diagnostic::new(&RULE.info, place(sub), message).label(place(first), say!("{} here", data_type));
    let object_type = Place::object(index).field(Field::ObjectType);
    let fix = Fix::risky(say!("write `{ObjectType=0x9}`")).set(object_type, "0x9");
    findings.push(finding.help(say!("write `{ObjectType=0x9}` (RECORD), or correct the data type")).fix(fix));
}

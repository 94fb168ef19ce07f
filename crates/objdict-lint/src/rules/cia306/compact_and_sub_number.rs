use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Object, ObjectType, Place};
use crate::{rule, stated};

rule! {
    "cia306/compact-and-sub-number", Error, Object(check), fix Safe;
    summary: "an object has both `CompactSubObj` and `SubNumber`",
    checks: "Whether `SubNumber` of an object with `CompactSubObj` is 0, empty or missing. Sub-indexes described in addition to the compact ones may be counted.",
    why: "Both keys describe the sub-indexes. Some readers use one, some the other.",
    example: "`CompactSubObj=8` and `SubNumber=9`",
    remedy: "Remove `SubNumber`.",
    source: "CiA 306-1 §4.6.3.4.2",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some(compact) = &object.compact else { return };
    let Some(number) = object.sub_number.filter(|&number| number > 0) else { return };
    let is_structure = stated::object_type(object).is_some_and(ObjectType::has_subs);
    if !is_structure || stated::described_subs(object) == usize::from(number) {
        return;
    }
    let count = compact.count;
    let message = say!("`{SubNumber}` is {}, but `{CompactSubObj}` already defines {}", number, count);
    let place = |field| Place::object(index).field(field);
    let finding = Diagnostic::new(&RULE.info, place(Field::SubNumber), message)
        .label(place(Field::CompactSubObj), say!("sub-indexes 0 to {}", count));
    let fix = Fix::safe(say!("remove `{SubNumber}`")).remove(place(Field::SubNumber));
    findings.push(finding.help(say!("remove `{SubNumber}`")).fix(fix));
}

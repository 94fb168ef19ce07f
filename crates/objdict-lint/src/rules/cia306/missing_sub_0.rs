use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Object, ObjectType, Part, Place};
use crate::{rule, stated, sub_0};

rule! {
    "cia306/missing-sub-0", Error, Object(check), fix Unsafe;
    summary: "an ARRAY or RECORD has no sub-index 0",
    checks: "Whether each ARRAY, RECORD and DEFSTRUCT without `CompactSubObj` describes sub-index 0.",
    why: "Managers first read sub-index 0 to get the number of entries.",
    example: "`[1003]` with `[1003sub1]` only",
    remedy: "Describe sub-index 0: UNSIGNED8, with the highest sub-index as its default.",
    source: "CiA 301 §7.4.7.2, CiA 306-1 §4.6.3.2",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
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
    let finding = Diagnostic::new(&RULE.info, Place::object(index), message);
    let finding = finding.fix(add_sub_0(index, object));
    findings.push(finding.help(say!(
        "add `{}` of type UNSIGNED8 with `{}`",
        Part::Entry(index, 0),
        Argument::setting(Field::DefaultValue, highest)
    )));
}

/// Adds sub-index 0, and updates `SubNumber`.
fn add_sub_0(index: u16, object: &Object) -> Fix {
    let fix = Fix::risky(say!("add `{}`", Part::Entry(index, 0))).with(sub_0(index, object));
    let described = stated::described_subs(object) + 1;
    if object.sub_number.map(usize::from) == Some(described) {
        return fix;
    }
    fix.set(Place::object(index).field(Field::SubNumber), described.to_string())
}

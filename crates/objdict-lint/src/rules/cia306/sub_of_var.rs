use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::{Device, Field, Object, Place};
use crate::{rule, stated};

rule! {
    "cia306/sub-of-var", Error, Object(check);
    summary: "a VAR or DOMAIN has sub-indexes",
    checks: "Whether an object of type VAR, DOMAIN, DEFTYPE or NULL describes sub-indexes. Sub-index 0 alone is accepted: it may describe the value of a VAR.",
    why: "Some tools treat the object as a single value and drop its sub-indexes, others treat it as a RECORD.",
    example: "`ObjectType=0x7` in `[2000]`, and `[2000sub1]`",
    remedy: "Write `ObjectType=0x9` (RECORD) or `0x8` (ARRAY), or remove the sub-indexes.",
    source: "CiA 301 §7.4.3",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let Some((sub, _)) = object.subs.iter().find(|&(sub, _)| sub != 0) else { return };
    let Some(object_type) = stated::object_type(object).filter(|object_type| !object_type.has_subs()) else {
        return;
    };
    let message = say!("{:04X}h is a {}, but has sub-index {}", index, object_type, sub_index(sub));
    let finding = Diagnostic::new(&RULE.info, Place::entry(index, sub), message)
        .label(Place::object(index).field(Field::ObjectType), say!("a {}", object_type));
    findings.push(finding.help(say!(
        "write `{ObjectType=0x9}` (RECORD) or `{ObjectType:0x8}` (ARRAY), or remove the sub-indexes"
    )));
}

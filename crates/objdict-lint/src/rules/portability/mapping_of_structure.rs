use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Field, ObjectType, PdoMapping};
use crate::{EntryAt, Origin, rule};

rule! {
    "portability/mapping-of-structure", Error, Entry(check), fix Safe;
    summary: "an object without a mappable value has `PDOMapping=0`",
    checks: "Whether an ARRAY, RECORD or DEFSTRUCT without `CompactSubObj`, or a DOMAIN, has `PDOMapping=0`. The key does not belong there, but its value is right.",
    why: "node-canopen refuses keys of a value at these object types.",
    example: "`[1018]` with `ObjectType=0x9` and `PDOMapping=0`",
    remedy: "Remove the key.",
    source: "node-canopen 6.2.1",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let is_without_value = match at.object_type() {
        _ if at.origin != Origin::Device => false,
        Some(ObjectType::Domain) => true,
        Some(object_type) => object_type.has_subs() && at.sub.is_none() && at.object.compact.is_none(),
        None => false,
    };
    if is_without_value && at.entry.pdo_mapping == Some(PdoMapping::No) {
        let place = at.field(Field::PdoMapping);
        let message = say!("this {} has `{PDOMapping=0}`", at.object_type().unwrap_or(ObjectType::Var));
        let finding = Diagnostic::new(&RULE.info, place.clone(), message).help(say!("remove {the key}"));
        findings.push(finding.fix(Fix::safe(say!("remove {the key}")).remove(place)));
    }
}

use crate::diagnostic::{Diagnostic, Findings, Fix, listing, listing_or, say};
use crate::model::{Field, ObjectType};
use crate::{EntryAt, Origin, rule, stated};

rule! {
    "portability/domain-without-type", Error, Entry(check), fix Safe;
    summary: "a DOMAIN has no data type or access",
    checks: "Whether an object of type DOMAIN has `DataType` and `AccessType`. The standard does not require them: the data type is DOMAIN, the access `rw`.",
    why: "dcf-tools and python-canopen read both keys of each object with a value and fail if one is missing.",
    example: "`ObjectType=0x2` without `DataType`",
    remedy: "Write `DataType=0x000F` and `AccessType=rw` (the defaults).",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    if at.origin != Origin::Device || at.object_type() != Some(ObjectType::Domain) {
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
    let finding = Diagnostic::new(&RULE.info, at.place(), message);
    findings.push(finding.help(say!("add {}", listing(&lines))).fix(fix));
}

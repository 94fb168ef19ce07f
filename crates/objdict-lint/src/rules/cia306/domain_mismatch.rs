use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{DataType, Field, ObjectType};
use crate::{EntryAt, rule};

rule! {
    "cia306/domain-mismatch", Warning, Entry(check), fix Unsafe;
    summary: "object type and data type disagree about a DOMAIN",
    checks: "Whether an object or sub-index of object type DOMAIN has no other data type than DOMAIN, and an object with the data type DOMAIN is no VAR. A sub-index may be called a VAR.",
    why: "A DOMAIN is transferred in segments and has no value in memory. Tools that look at one of the two keys treat the object differently from those that look at the other.",
    example: "`ObjectType=0x7` and `DataType=0x000F`",
    remedy: "Write `ObjectType=0x2`, or the data type that the value has.",
    source: "CiA 301 §7.4.3, CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(data_type) = at.entry.data_type else { return };
    let is_domain = at.entry.object_type == Some(ObjectType::Domain);
    if is_domain && data_type != DataType::DOMAIN {
        let finding = Diagnostic::new(
            &RULE.info,
            at.field(Field::DataType),
            say!("the object type is DOMAIN, but the data type {}", data_type),
        );
        let fix = Fix::risky(say!("write `{DataType=0x000F}`")).set(at.field(Field::DataType), "0x000F");
        findings.push(finding.help(say!("write `{DataType=0x000F}`, or correct `{ObjectType}`")).fix(fix));
    } else if at.sub.is_none() && data_type == DataType::DOMAIN && at.object_type() == Some(ObjectType::Var) {
        let message = "the data type is DOMAIN, but the object type VAR";
        let finding = Diagnostic::new(&RULE.info, at.field(Field::ObjectType), message)
            .label(at.field(Field::DataType), "a DOMAIN");
        let fix = Fix::risky(say!("write `{ObjectType=0x2}`")).set(at.field(Field::ObjectType), "0x2");
        findings.push(finding.help(say!("write `{ObjectType=0x2}`, or correct `{DataType}`")).fix(fix));
    }
}

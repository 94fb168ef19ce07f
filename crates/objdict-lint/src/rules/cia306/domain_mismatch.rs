use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{DataType, Field, ObjectType};
use crate::{EntryAt, rule};

rule! {
    "cia306/domain-mismatch", Warning, Entry(check), fix Unsafe;
    summary: "object type and data type disagree about a DOMAIN",
    checks: "Whether an object or sub-index of object type DOMAIN has the data type DOMAIN, and whether an object with data type DOMAIN has an object type other than VAR. A sub-index may have object type VAR.",
    why: "A DOMAIN is transferred in segments and has no value in memory. Tools that evaluate one of the two keys treat the object differently from tools that evaluate the other.",
    example: "`ObjectType=0x7` and `DataType=0x000F`",
    remedy: "Write `ObjectType=0x2`, or correct the data type.",
    source: "CiA 301 §7.4.3, CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(data_type) = at.entry.data_type else { return };
    let is_domain = at.entry.object_type == Some(ObjectType::Domain);
    if is_domain && data_type != DataType::DOMAIN {
        let finding = Diagnostic::new(
            &RULE.info,
            at.field(Field::DataType),
            say!("the object type is DOMAIN, but the data type is {}", data_type),
        );
        let fix = Fix::risky(say!("write `{DataType=0x000F}`")).set(at.field(Field::DataType), "0x000F");
        findings.push(finding.help(say!("write `{DataType=0x000F}`, or correct `{ObjectType}`")).fix(fix));
    } else if at.sub.is_none() && data_type == DataType::DOMAIN && at.object_type() == Some(ObjectType::Var) {
        let message = "the data type is DOMAIN, but the object type is VAR";
        let finding = Diagnostic::new(&RULE.info, at.field(Field::ObjectType), message)
            .label(at.field(Field::DataType), "a DOMAIN");
        let fix = Fix::risky(say!("write `{ObjectType=0x2}`")).set(at.field(Field::ObjectType), "0x2");
        findings.push(finding.help(say!("write `{ObjectType=0x2}`, or correct `{DataType}`")).fix(fix));
    }
}

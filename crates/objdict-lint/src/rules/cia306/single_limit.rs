use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{DataType, Field, ObjectType};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/single-limit", Note, Entry(check);
    summary: "an entry has only one of the two limits",
    checks: "Whether `LowLimit` and `HighLimit` are both given, or neither. A low limit of 0 or above of a signed type, and a high limit of any type, leave the other end open.",
    why: "A single limit is allowed, but tools interpret the missing one differently: 0, the end of the type's range, or no limits at all.",
    example: "`HighLimit=100`, and no `LowLimit`",
    remedy: "Add the other limit.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let (stated, missing) = match (&entry.low_limit, &entry.high_limit) {
        (Some(_), None) => (Field::LowLimit, Field::HighLimit),
        (None, Some(_)) => (Field::HighLimit, Field::LowLimit),
        _ => return,
    };
    let is_number = entry.data_type.is_some_and(DataType::is_numeric);
    let is_domain = at.object_type() == Some(ObjectType::Domain);
    if !is_number || is_domain || !at.holds_value() || stated::is_invalid(entry, &missing) {
        return;
    }
    let message = say!("`{}` is set without `{}`", stated, missing);
    let finding = Diagnostic::new(&RULE.info, at.field(stated), message);
    findings.push(finding.help(say!("add `{}`", missing)));
}

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Field, ObjectType, TypeKind};
use crate::{EntryAt, rule};

rule! {
    "cia306/limits-on-text", Warning, Entry(check), fix Unsafe;
    summary: "a string has limits",
    checks: "Whether `LowLimit` and `HighLimit` are used with numbers only, not with VISIBLE_STRING, UNICODE_STRING, OCTET_STRING or DOMAIN.",
    why: "Strings have no defined order, so limits have no meaning. They may have been meant as lengths, or the data type is wrong.",
    example: "`DataType=0x0009` with `HighLimit=20`",
    remedy: "Remove the limits, or correct the data type.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    let field = match (&entry.low_limit, &entry.high_limit) {
        (Some(_), _) => Field::LowLimit,
        (None, Some(_)) => Field::HighLimit,
        (None, None) => return,
    };
    let Some(data_type) = entry.data_type else { return };
    let is_text = matches!(
        data_type.kind(),
        TypeKind::VisibleString | TypeKind::UnicodeString | TypeKind::OctetString | TypeKind::Domain
    );
    // another rule reports these keys for DOMAIN objects, which do not support them
    if is_text && at.holds_value() && at.object_type() != Some(ObjectType::Domain) {
        let message = say!("`{}` has no meaning for a {}", field, data_type);
        let finding = Diagnostic::new(&RULE.info, at.field(field), message)
            .label(at.field(Field::DataType), "not a number");
        let stated =
            [(Field::LowLimit, entry.low_limit.is_some()), (Field::HighLimit, entry.high_limit.is_some())];
        let stated = stated.into_iter().filter(|(_, stated)| *stated);
        let fix = stated.fold(Fix::risky("remove the limits"), |fix, (field, _)| fix.remove(at.field(field)));
        findings.push(finding.help("remove the limits").fix(fix));
    }
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, ObjectType, TypeKind};
use crate::{EntryAt, rule};

rule! {
    "cia306/missing-constant", Note, Entry(check);
    summary: "a constant has no value",
    checks: "Whether entries with access `const` have a `DefaultValue`. Not checked: strings 1008h to 100Ah and identity 1018h, which often share one description for several versions of a device, DOMAINs, and sub-index 0, which has its own rule.",
    why: "Tools know a constant without asking the device. Code generated from the description contains 0 instead.",
    example: "`AccessType=const` without `DefaultValue`",
    remedy: "Write the value, or `AccessType=ro` for a value that differs between devices.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let entry = at.entry;
    if entry.access != Some(Access::Const) || entry.value().is_some() || !at.holds_value() {
        return;
    }
    let varies = matches!(at.index, 0x1000 | 0x1008..=0x100A | 0x1018);
    let count = at.sub == Some(0) && at.object.object_type().has_subs();
    let values =
        at.sub.is_none() && at.object.compact.as_ref().is_some_and(|compact| !compact.values.is_empty());
    let domain = at.object_type() == Some(ObjectType::Domain)
        || entry.data_type.is_none_or(|data_type| data_type.kind() == TypeKind::Domain);
    if varies || count || values || domain || !entry.invalid_values.is_empty() {
        return;
    }
    let finding = Diagnostic::new(&RULE.info, at.field(Field::DefaultValue), "the constant has no value")
        .label(at.field(Field::AccessType), "a constant");
    findings.push(
        finding
            .help(say!("write `{DefaultValue}`, or `{AccessType=ro}` if the value differs between devices")),
    );
}

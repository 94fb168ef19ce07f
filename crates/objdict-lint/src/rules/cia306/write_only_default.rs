use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Value};
use crate::{EntryAt, rule};

rule! {
    "cia306/write-only-default", Note, Entry(check);
    summary: "an entry that cannot be read has a default",
    checks: "Whether entries with `AccessType=wo` have no `DefaultValue` other than 0.",
    why: "Nobody can read back what was written, so a tool that restores or compares defaults fails at the entry; mostly it is a command, and writing its default would carry it out.",
    example: "`AccessType=wo` and `DefaultValue=1`",
    remedy: "Remove the value, or correct the access type.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    if at.entry.access != Some(Access::Wo) || !at.holds_value() || at.entry.is_mappable() {
        return;
    }
    let Some(default) = at.entry.default.as_ref().filter(|value| !is_nothing(value)) else { return };
    let message = say!("`{}` as default of an entry that nobody can read", default);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::DefaultValue), message);
    let finding = finding.label(at.field(Field::AccessType), "write only");
    findings.push(finding.help(say!("remove the value, or correct `{AccessType}`")));
}

fn is_nothing(value: &Value) -> bool {
    match value {
        Value::Text(text) | Value::Raw(text) => text.is_empty(),
        Value::Bytes(bytes) => bytes.iter().all(|&byte| byte == 0),
        _ => value.as_real() == Some(0.0),
    }
}

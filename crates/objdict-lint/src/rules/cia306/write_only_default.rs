use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, Field, Value};
use crate::{EntryAt, rule};

rule! {
    "cia306/write-only-default", Note, Entry(check);
    summary: "a write-only entry has a default",
    checks: "Whether entries with `AccessType=wo` have a `DefaultValue` other than 0.",
    why: "The entry cannot be read back, so tools that restore or compare defaults fail at it. Mostly the entry is a command, and writing its default would execute the command.",
    example: "`AccessType=wo` and `DefaultValue=1`",
    remedy: "Remove the value, or correct the access type.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    if at.entry.access != Some(Access::Wo) || !at.holds_value() || at.entry.is_mappable() {
        return;
    }
    let Some(default) = at.entry.default.as_ref().filter(|value| !is_nothing(value)) else { return };
    let message = match default {
        Value::Text(text) => say!("`{DefaultValue}` is `{}`, but the entry is write-only", text),
        value => say!("`{DefaultValue}` is {:h}, but the entry is write-only", value),
    };
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

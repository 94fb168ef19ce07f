use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Access, DeviceKind, Field};
use crate::{EntryAt, rule, stated};

rule! {
    "cia306/read-only-value", Warning, Entry(check), fix Unsafe;
    summary: "a DCF configures an entry that is not writable",
    checks: "Whether each `ParameterValue` that differs from the default belongs to a writable entry. For `ro` entries the finding is a note: a tool may have stored a value read from the node, as in the example of the standard. Sub-index 0 and the identity object are not checked.",
    why: "Tools cannot download the value to the node, although the author expects it.",
    example: "`AccessType=const`, `DefaultValue=8` and `ParameterValue=9`",
    remedy: "Remove the `ParameterValue`, or correct `AccessType`.",
    source: "CiA 306-1 §5.3.1",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(value) = at.entry.configured_value() else { return };
    let severity = match at.entry.access {
        Some(Access::Const) => Severity::Warning,
        Some(Access::Ro) => Severity::Note,
        _ => return,
    };
    let Some(default) = at.entry.default.as_ref().filter(|default| *default != value) else { return };
    let [node_id, _] = stated::node_ids(at.device);
    let same = stated::compare(value, default, node_id) == Some(Ordering::Equal);
    if same
        || at.index == 0x1018
        || at.sub == Some(0)
        || !at.holds_value()
        || at.device.kind != DeviceKind::Node
    {
        return;
    }
    let access = at.entry.access.unwrap_or(Access::Ro);
    let message = say!(
        "`{ParameterValue}` is {:h}, but the entry is `{}` and its default is {:h}",
        value,
        access,
        default
    );
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterValue), message)
        .severity(severity)
        .label(at.field(Field::AccessType), "not writable");
    let fix = Fix::risky(say!("remove `{ParameterValue}`")).remove(at.field(Field::ParameterValue));
    findings.push(finding.help(say!("remove `{ParameterValue}`, or correct `{AccessType}`")).fix(fix));
}

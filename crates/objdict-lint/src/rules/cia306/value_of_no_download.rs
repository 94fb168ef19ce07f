use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Access, Field};
use crate::{EntryAt, rule};

rule! {
    "cia306/value-of-no-download", Note, Entry(check), fix Unsafe;
    summary: "a DCF configures an entry that `ObjFlags` excludes from downloads",
    checks: "Whether a writable entry with bit 0 of `ObjFlags` (no download) has a `ParameterValue` other than its default.",
    why: "Tools skip such entries in a download, so the value never reaches the node; a tool that does not know the flag stores, restores or erases something.",
    example: "`ObjFlags=0x1` and `ParameterValue=0x65766173` in `[1010sub1]`",
    remedy: "Remove the `ParameterValue`.",
    source: "CiA 306-1 §4.6.3.3",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(value) = at.entry.configured_value() else { return };
    if at.entry.default.as_ref() == Some(value) || !at.entry.access.is_some_and(Access::is_writable) {
        return;
    }
    let own = at.entry.flags().refuses_write();
    if own || at.sub.is_some_and(|sub| sub > 0) && at.object.main.flags().refuses_write() {
        let message = say!("`{ParameterValue}` is never written: `{ObjFlags}` bit 0 forbids the download");
        let flags = if own { at.place() } else { at.object_place() };
        let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterValue), message)
            .label(flags.field(Field::ObjFlags), "forbids the download");
        let fix = Fix::risky(say!("remove `{ParameterValue}`")).remove(at.field(Field::ParameterValue));
        findings.push(finding.help(say!("remove `{ParameterValue}`")).fix(fix));
    }
}

use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, say};
use crate::model::Field;
use crate::{EntryAt, rule};

rule! {
    "cia306/invalid-object-flags", Warning, Entry(check), fix Unsafe;
    summary: "`ObjFlags` has reserved bits",
    checks: "Whether only bits 0 (no download), 1 (no upload) and 2 (effective after a reset, added by CiA 311) are set.",
    why: "The other bits are reserved: a later version may define them. The value may belong to another key.",
    example: "`ObjFlags=0x8`",
    remedy: "Write the sum of 1 and 2, or remove the key.",
    source: "CiA 306-1 §4.6.3.3",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(flags) = at.entry.flags.filter(|flags| flags.0 > 7) else { return };
    let message = say!(
        "`{ObjFlags}` is {}, but only bits 0 to 2 are defined",
        Argument::value_of(Field::ObjFlags, format_args!("{:#x}", flags.0))
    );
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ObjFlags), message);
    let known = flags.0 & 7;
    findings.push(if known == 0 {
        let fix = Fix::risky(say!("remove {the key}")).remove(at.field(Field::ObjFlags));
        finding.help(say!("remove {the key}")).fix(fix)
    } else {
        let title = say!("write `{}`", Argument::setting(Field::ObjFlags, format_args!("{known:#x}")));
        let fix = Fix::risky(title.clone()).set(at.field(Field::ObjFlags), format!("{known:#x}"));
        finding.help(title).fix(fix)
    });
}

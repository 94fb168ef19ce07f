use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, say};
use crate::model::Field;
use crate::{EntryAt, rule};

rule! {
    "cia306/invalid-object-flags", Warning, Entry(check), fix Safe;
    summary: "`ObjFlags` has bits without a meaning",
    checks: "Whether no other bits are set than 0 (refuse write), 1 (refuse read) and 2, which CiA 311 added (the value counts after a reset).",
    why: "The other bits are reserved: a later version may give them a meaning. Perhaps a number of another key got here.",
    example: "`ObjFlags=0x8`",
    remedy: "Write the sum of 1 and 2, or remove the key.",
    source: "CiA 306-1 §4.6.3.3",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(flags) = at.entry.flags.filter(|flags| flags.0 > 7) else { return };
    let message = say!(
        "`{ObjFlags}` is {}, of which only the bits 0 to 2 have a meaning",
        Argument::worth(Field::ObjFlags, format_args!("{:#x}", flags.0))
    );
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ObjFlags), message);
    let known = flags.0 & 7;
    findings.push(if known == 0 {
        let fix = Fix::safe(say!("remove {the key}")).remove(at.field(Field::ObjFlags));
        finding.help(say!("remove {the key}")).fix(fix)
    } else {
        let title = say!("write `{}`", Argument::setting(Field::ObjFlags, format_args!("{known:#x}")));
        let fix = Fix::safe(title.clone()).set(at.field(Field::ObjFlags), format!("{known:#x}"));
        finding.help(title).fix(fix)
    });
}

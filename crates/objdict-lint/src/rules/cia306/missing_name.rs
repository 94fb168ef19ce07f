use crate::diagnostic::{Diagnostic, Findings, say, sub_index};
use crate::model::Field;
use crate::{EntryAt, rule};

rule! {
    "cia306/missing-name", Warning, Entry(check);
    summary: "an object or sub-index has no name",
    checks: "Whether each section of an object or sub-index has a non-empty `ParameterName`.",
    why: "Tools show the name. python-canopen and others refuse a file without it; code generators have to invent one.",
    example: "`ParameterName=`",
    remedy: "Write the name from the standard or the manual.",
    source: "CiA 306-1 §4.6.3.2",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    if !at.entry.name.is_empty() {
        return;
    }
    let what = match at.sub {
        Some(sub) => say!("sub-index {} of {:04X}h", sub_index(sub), at.index),
        None => say!("{:04X}h", at.index),
    };
    let message = say!("{} has no name", what);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterName), message);
    findings.push(finding.help(say!("write `{ParameterName=}` and a name")));
}

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::Field;
use crate::{EntryAt, rule};

rule! {
    "naming/repeated-blanks", Note, Entry(check), fix Unsafe;
    summary: "a name has blanks that nobody sees",
    checks: "Whether no name starts or ends with a blank, or has two of them in a row.",
    why: "Tools that look an entry up by its name do not find it under the name that people read, and comparisons show a change where nobody sees one.",
    example: "`ParameterName=Motor  speed`",
    remedy: "Remove the blanks.",
    source: "Not in a standard",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    let bytes = name.as_bytes();
    let at_end = [bytes.first(), bytes.last()].into_iter().flatten().any(|&byte| byte == b' ');
    let is_repeated = || bytes.windows(2).any(|pair| pair == b"  ");
    if !at_end && !is_repeated() {
        return;
    }
    let clean = name.split(' ').filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
    if clean.is_empty() {
        return;
    }
    let place = at.field(Field::ParameterName);
    let message = say!("`{}` has blanks that nobody sees", name);
    let fix = Fix::risky("remove the blanks").set(place.clone(), clean.as_str());
    findings.push(Diagnostic::new(&RULE.info, place, message).help(say!("write `{}`", clean)).fix(fix));
}

use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::Field;
use crate::{EntryAt, rule};

rule! {
    "naming/repeated-blanks", Note, Entry(check), fix Unsafe;
    summary: "a name has extra spaces",
    checks: "Whether a name starts or ends with a space, or has two spaces in a row.",
    why: "Tools that look up an entry by the visible name do not find it, and comparisons show changes that are not visible.",
    example: "`ParameterName=Motor  speed`",
    remedy: "Remove the extra spaces.",
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
    let message = say!("`{}` has extra spaces", name);
    let fix = Fix::risky("remove the extra spaces").set(place.clone(), clean.as_str());
    findings.push(Diagnostic::new(&RULE.info, place, message).help(say!("write `{}`", clean)).fix(fix));
}

use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Field;
use crate::{EntryAt, rule};

const PLACEHOLDERS: [&str; 14] = [
    "new object",
    "new entry",
    "new item",
    "unnamed",
    "untitled",
    "no name",
    "noname",
    "todo",
    "tbd",
    "fixme",
    "xxx",
    "asdf",
    "foo",
    "bar",
];

rule! {
    "naming/placeholder", Note, Entry(check);
    summary: "a name is a placeholder",
    checks: "Whether no name is one that a tool gives to something new, or that somebody writes to come back to it: `New object`, `Unnamed`, `Untitled`, `No name`, `TODO`, `TBD`, `FIXME`, `xxx`, `asdf`, `foo`, `bar`.",
    why: "Nobody has come back to it, and the user of the device cannot know what the entry is.",
    example: "`ParameterName=New object`",
    remedy: "Write what the entry is.",
    source: "Not in a standard",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // the longest has ten characters
    if name.len() > 10 || !PLACEHOLDERS.iter().any(|placeholder| placeholder.eq_ignore_ascii_case(name)) {
        return;
    }
    let message = say!("`{}` is a placeholder", name);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterName), message);
    findings.push(finding.help("write what the entry is"));
}

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
    checks: "Whether a name is a default name of a tool or a reminder of the author: `New object`, `Unnamed`, `Untitled`, `No name`, `TODO`, `TBD`, `FIXME`, `xxx`, `asdf`, `foo`, `bar`.",
    why: "Users of the device cannot know the purpose of the entry.",
    example: "`ParameterName=New object`",
    remedy: "Write a descriptive name.",
    source: "Not in a standard",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // the longest placeholder has ten characters
    if name.len() > 10 || !PLACEHOLDERS.iter().any(|placeholder| placeholder.eq_ignore_ascii_case(name)) {
        return;
    }
    let message = say!("`{}` is a placeholder", name);
    let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterName), message);
    findings.push(finding.help("write a descriptive name"));
}

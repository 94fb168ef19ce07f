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
    /// a name is a placeholder
    ///
    /// ## What it checks
    /// Whether no name is one that a tool gives to something new, or that somebody writes to come back to it: `New object`, `Unnamed`, `Untitled`, `No name`, `TODO`, `TBD`, `FIXME`, `xxx`, `asdf`, `foo`, `bar`.
    ///
    /// ## Why it matters
    /// Nobody has come back to it, and the user of the device cannot know what the entry is.
    ///
    /// ## Example
    /// `ParameterName=New object`
    ///
    /// ## How to mend
    /// Write what the entry is.
    ///
    /// ## Source
    /// Not in a standard
    "naming/placeholder", Note, Entry(check)
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

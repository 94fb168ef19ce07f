use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Field;
use crate::{EntryAt, rule};

/// The maximum length of a name that is not reported.
const LONGEST: usize = 100;

rule! {
    "naming/long-name", Note, Entry(check);
    summary: "a name is longer than a line of text",
    checks: "Whether each name has at most 100 characters. The limit of CiA 306-1, 241, applies to the line and has its own rule.",
    why: "Tools show names in columns and truncate them, identifiers made from them lose their end, and often the text is a description.",
    example: "A `ParameterName` of two sentences",
    remedy: "Shorten the name; move explanations to a comment or the manual.",
    source: "Not in a standard",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // another rule reports a line that is too long
    if name.len() <= LONGEST || name.len() > 241 {
        return;
    }
    let length = name.chars().count();
    if length > LONGEST {
        let message = say!("the name has {} characters", length);
        let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterName), message);
        findings.push(finding.help("shorten the name, and move the description to a comment or the manual"));
    }
}

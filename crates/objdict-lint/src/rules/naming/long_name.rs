use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::Field;
use crate::{EntryAt, rule};

/// Characters of the longest name that is not remarkable.
const LONGEST: usize = 100;

rule! {
    "naming/long-name", Note, Entry(check);
    summary: "a name is longer than a line of text",
    checks: "Whether each name has at most 100 characters. The limit of CiA 306-1, 241, is that of the line and has a rule of its own.",
    why: "Tools show names in columns and cut them off, identifiers made of them lose their end, and often what stands there is a description.",
    example: "A `ParameterName` of two sentences",
    remedy: "Shorten it; what it explains goes into a comment or the manual.",
    source: "Not in a standard",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let name = &at.entry.name;
    // a line that is too long is reported as that
    if name.len() <= LONGEST || name.len() > 241 {
        return;
    }
    let length = name.chars().count();
    if length > LONGEST {
        let message = say!("a name of {} characters", length);
        let finding = Diagnostic::new(&RULE.info, at.field(Field::ParameterName), message);
        findings.push(finding.help("shorten it, and put the description elsewhere"));
    }
}

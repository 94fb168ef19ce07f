//! Changes as tables in Markdown.

use std::io::{self, Write};

use super::{ComparedDescriptions, address};
use crate::stdout::Output;
use objdict_lint::changes::{Audience, ChangeVerdict};
use objdict_model::diagnostic::one_line;

pub(super) fn write(comparison: &ComparedDescriptions, out: &mut Output) -> io::Result<()> {
    let names = [&comparison.old, &comparison.new].map(|side| escaped(&side.name()));
    writeln!(out, "# {} → {}\n\n{}", names[0], names[1], comparison.summary())?;
    for verdict in ChangeVerdict::ALL.into_iter().rev() {
        let changes = comparison.changes.iter().filter(|change| change.verdict() == verdict);
        let mut is_first = true;
        for change in changes {
            if is_first {
                writeln!(out, "\n## {verdict}\n\n| where | change | for | rule |\n|---|---|---|---|")?;
                is_first = false;
            }
            let audiences: Vec<&str> = change.audiences(verdict).map(Audience::title).collect();
            let message = escaped(&change.message.shown());
            let rule = change.rule.info.name();
            writeln!(out, "| {} | {message} | {} | `{rule}` |", address(change), audiences.join(", "))?;
        }
    }
    Ok(())
}

/// A text in one line of a table, without effect on it: only the marks of code that messages have stay.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len() + 8);
    let mut is_code = false;
    for character in one_line(text).chars() {
        is_code ^= character == '`';
        match character {
            '|' => escaped.push_str("\\|"),
            '\\' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '&' | '~' | '@' | '$' if !is_code => {
                escaped.push('\\');
                escaped.push(character);
            }
            _ => escaped.push(character),
        }
    }
    escaped
}

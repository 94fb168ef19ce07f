//! Findings and errors as lines, if the library is built without excerpts: for errors of build scripts.

use std::io;

use super::Subject;
use objdict_model::diagnostic::Findings;
use objdict_model::diagnostic::one_line;
#[cfg(any(test, feature = "lint"))]
use objdict_model::source::{SourceFile, Span};

/// Findings, a line each, with their advice below.
pub fn listed(subject: Subject<'_>, findings: &Findings) -> io::Result<String> {
    let mut text = String::new();
    let name = one_line(subject.source().name());
    for finding in findings.listed() {
        text.push_str(&finding.line(subject.source(), |at| subject.span_of(at)));
        text.push('\n');
        if let Some(help) = &finding.help {
            text.push_str(&format!("  help: {}\n", one_line(&help.shown())));
        }
    }
    for (rule, count) in findings.unlisted() {
        text.push_str(&format!("{name}: {count} more findings of {rule} are not shown\n"));
    }
    Ok(text)
}

/// A problem in a file of objdict (a profile, a configuration).
#[cfg(any(test, feature = "lint"))]
pub fn problem(source: &SourceFile, span: Span, message: &str, help: Option<&str>) -> String {
    let (name, start) = (one_line(source.name()), source.line_column(span.start));
    let mut text = format!("{name}:{}:{}: error: {}\n", start.line, start.column, one_line(message));
    if let Some(help) = help {
        text.push_str(&format!("  help: {}\n", one_line(help)));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::Format;

    #[test]
    fn a_finding_has_its_advice_below() {
        let text = "[2000]\nParameterName=x\nObjectType=7\nDataType=5\nDefaultValue=300\u{1B}\n";
        let description = format::read(SourceFile::from_text("a.eds", text), Format::Eds);
        let text = listed((&description).into(), &crate::check(&description)).unwrap();
        let line = "a.eds:5:14: error cia306/invalid-value: `300\u{FFFD}` is not a number";
        assert!(text.contains(line), "{text}");
        assert!(text.contains("\n  help: "), "{text}");
    }

    #[test]
    fn a_problem_has_its_place() {
        let source = SourceFile::from_text("custom.toml", "a = 1\nb = 2\n");
        let text = problem(&source, Span::new(10, 11), "no `2`", Some("write `3`"));
        assert_eq!(text, "custom.toml:2:5: error: no `2`\n  help: write `3`\n");
    }
}

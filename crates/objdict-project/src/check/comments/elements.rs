//! The comments between elements.

use super::{Directive, KEYWORD, leading};
use objdict_model::source::Span;
use objdict_xdd::xml::{Tree, comments};

/// A comment applies to the next element, or before the root to the whole file.
pub(super) fn directives(tree: &Tree) -> Vec<Directive> {
    let text = tree.text();
    let directive = |comment: Span| {
        let inner = comment.of(text);
        let inner = inner.strip_prefix("<!--").unwrap_or(inner);
        let length = inner.strip_suffix("-->").unwrap_or(inner).len() as u32;
        let inner = Span::new(comment.start + 4, comment.start + 4 + length);
        let mut directive = Directive::parse(text, line_around(text, comment), inner)?;
        directive.scope = match tree.next_element(comment.end) {
            Some(element) if element.parent().is_none() => None,
            Some(element) => Some(element.span()),
            None => Some(Span::empty(comment.end)),
        };
        Some(directive)
    };
    comments(text).filter_map(directive).collect()
}

/// The line of a comment with its line end if it contains nothing else; otherwise the comment.
fn line_around(text: &str, comment: Span) -> Span {
    let (before, behind) = (&text[..comment.start as usize], &text[comment.end as usize..]);
    let line_start = before.trim_end_matches([' ', '\t']).len();
    let blanks = leading(behind, |c| matches!(c, ' ' | '\t')) as usize;
    let line_end = match &behind.as_bytes()[blanks..] {
        [b'\r', b'\n', ..] => 2,
        [b'\r' | b'\n', ..] => 1,
        _ => return comment,
    };
    if !before[..line_start].ends_with(['\r', '\n']) {
        return comment;
    }
    Span::new(line_start as u32, comment.end + (blanks + line_end) as u32)
}

/// The position and text of a new comment that allows a rule for the element around an offset.
pub(super) fn insertion(text: &str, offset: u32, rule: &str) -> Option<(Span, String)> {
    let before = text.get(..offset as usize)?;
    let at = before.rfind('<')?;
    let is_element = text[at + 1..].starts_with(|c: char| c.is_alphabetic() || c == '_');
    let line = &before[before[..at].rfind(['\n', '\r']).map_or(0, |end| end + 1)..at];
    let indent = if line.trim().is_empty() { line } else { "" };
    let line_end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    is_element.then(|| (Span::empty(at as u32), format!("<!-- {KEYWORD} allow {rule} -->{line_end}{indent}")))
}

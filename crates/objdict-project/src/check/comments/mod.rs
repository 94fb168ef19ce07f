//! Comments that suppress findings: `; objdict: allow cia306/file-name -- named by the customer`.

#[cfg(feature = "xdd")]
mod elements;

use objdict_eds::ini::{Document, LineKind};
use objdict_format::Description;
use objdict_model::source::Span;

/// The start of such a comment, after the comment character.
const KEYWORD: &str = "objdict:";

/// The separator between the rules and the reason.
const REASON: &str = "--";

/// A comment for this program.
#[derive(Debug)]
pub(super) struct Directive {
    /// The text that is removed with the comment: its line if it contains nothing else.
    pub(super) removed: Span,
    /// From the keyword to the end of the comment.
    pub(super) text: Span,
    /// The instruction; empty if it is missing.
    pub(super) verb: Span,
    /// The words after it, up to the reason.
    pub(super) rules: Vec<Span>,
    /// The scope; `None` for the whole file.
    pub(super) scope: Option<Span>,
}

impl Directive {
    /// The parts of a comment whose text, without its delimiters, is `inner`; `None` for an ordinary comment.
    fn parse(text: &str, removed: Span, inner: Span) -> Option<Self> {
        let is_mark = |c: char| matches!(c, ';' | '#' | '/') || is_blank(c);
        let start = inner.start + leading(inner.of(text), is_mark);
        let end = inner.start + inner.of(text).trim_end_matches(is_blank).len() as u32;
        let whole = Span::new(start.min(end), end);
        let keyword = whole.of(text).get(..KEYWORD.len())?;
        if !keyword.eq_ignore_ascii_case(KEYWORD) {
            return None;
        }
        let behind = Span::new(whole.start + KEYWORD.len() as u32, end);
        let mut words =
            words(behind.of(text)).map(|word| Span::new(behind.start + word.start, behind.start + word.end));
        let verb = words.next().unwrap_or(Span::empty(end));
        let rules = words.take_while(|word| word.of(text) != REASON).collect();
        Some(Self { removed, text: whole, verb, rules, scope: None })
    }
}

/// The directives of a text, in their order.
pub(super) fn directives(description: &Description) -> Vec<Directive> {
    let text = description.source().text();
    // few files have one
    let mut places = memchr::memchr_iter(b':', text.as_bytes());
    let is_keyword = |end: usize| {
        let start = (end + 1).saturating_sub(KEYWORD.len());
        text.as_bytes()[start..=end].eq_ignore_ascii_case(KEYWORD.as_bytes())
    };
    if !places.any(is_keyword) {
        return Vec::new();
    }
    #[cfg(feature = "xdd")]
    if let Some(tree) = description.tree() {
        return elements::directives(tree);
    }
    description.document().map_or_else(Vec::new, in_lines)
}

/// The position and text of a new comment that allows a rule for the section or element around an offset; `None` in a
/// format without such comments.
pub fn insertion(description: &Description, offset: u32, rule: &str) -> Option<(Span, String)> {
    let text = description.source().text();
    text.get(..offset as usize)?;
    if let Some(document) = description.document() {
        let headers = document.lines().filter(|line| matches!(line.kind, LineKind::Section { .. }));
        let header = headers.take_while(|line| line.span.start <= offset).last();
        let at = header.map_or(0, |header| header.span.start);
        return Some((Span::empty(at), format!("; {KEYWORD} allow {rule}{}", document.line_end())));
    }
    #[cfg(feature = "xdd")]
    if description.tree().is_some() {
        return elements::insertion(text, offset, rule);
    }
    None
}

/// A comment applies to the next section, or before the first section to the whole file.
fn in_lines(document: &Document) -> Vec<Directive> {
    let text = document.text();
    let mut directives: Vec<Directive> = Vec::new();
    // the first directive whose section has not started, and the first whose section has not ended
    let (mut waiting, mut open) = (0, 0);
    let mut is_first = true;
    for line in document.lines() {
        match line.kind {
            LineKind::Comment => {
                directives.extend(Directive::parse(text, Span::new(line.span.start, line.next), line.span));
            }
            LineKind::Section { .. } => {
                end_at(&mut directives[open..waiting], line.span.start);
                let scope = if is_first { None } else { Some(Span::empty(line.span.start)) };
                directives[waiting..].iter_mut().for_each(|directive| directive.scope = scope);
                (open, waiting, is_first) = (waiting, directives.len(), false);
            }
            _ => {}
        }
    }
    let end = text.len() as u32;
    // a finding at the end of the text is in the last section
    end_at(&mut directives[open..waiting], end.saturating_add(1));
    if !is_first {
        directives[waiting..].iter_mut().for_each(|directive| directive.scope = Some(Span::empty(end)));
    }
    directives
}

fn end_at(directives: &mut [Directive], end: u32) {
    for scope in directives.iter_mut().filter_map(|directive| directive.scope.as_mut()) {
        scope.end = end;
    }
}

/// The words of a text, separated by commas and spaces.
fn words(text: &str) -> impl Iterator<Item = Span> {
    let mut at = 0;
    let is_between = |c: char| c == ',' || is_blank(c);
    std::iter::from_fn(move || {
        let start = at + leading(&text[at as usize..], is_between);
        let rest = &text[start as usize..];
        at = start + rest.find(is_between).unwrap_or(rest.len()) as u32;
        (at > start).then_some(Span::new(start, at))
    })
}

fn leading(text: &str, is_left: impl Fn(char) -> bool) -> u32 {
    (text.len() - text.trim_start_matches(is_left).len()) as u32
}

/// Whitespace, line ends, and the end-of-file character of DOS.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\0' | '\u{1A}')
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_format as format;
    use objdict_format::Format;
    use objdict_model::source::SourceFile;

    /// Each directive as its rules, its scope, and the text that is removed with it.
    fn found(text: &str, format: Format) -> Vec<(Vec<String>, String, String)> {
        let description = format::read(SourceFile::from_text("test", text), format);
        let padded = format!("{text} ");
        let show = |directive: Directive| {
            let rules = directive.rules.iter().map(|rule| rule.of(text).to_owned()).collect();
            let scope = directive.scope.map_or("file".to_owned(), |scope| scope.of(&padded).to_owned());
            (rules, scope, directive.removed.of(text).to_owned())
        };
        directives(&description).into_iter().map(show).collect()
    }

    fn words(words: &[&str]) -> Vec<String> {
        words.iter().map(|&word| word.to_owned()).collect()
    }

    #[test]
    fn a_comment_holds_for_the_next_section_or_for_the_file() {
        let text = "; objdict: allow a, b/c -- d e\n[A]\nk=1\n;objdict:allow x y\n; people\n[B]\n# OBJDICT: allow z\n[C]";
        assert_eq!(
            found(text, Format::Eds),
            [
                (words(&["a", "b/c"]), "file".to_owned(), "; objdict: allow a, b/c -- d e\n".to_owned()),
                (
                    words(&["x", "y"]),
                    "[B]\n# OBJDICT: allow z\n".to_owned(),
                    ";objdict:allow x y\n".to_owned()
                ),
                (words(&["z"]), "[C] ".to_owned(), "# OBJDICT: allow z\n".to_owned()),
            ]
        );
    }

    #[test]
    fn a_comment_without_a_section_holds_for_nothing() {
        let text = "[A]\n; objdict: allow a";
        assert_eq!(
            found(text, Format::Eds),
            [(words(&["a"]), String::new(), "; objdict: allow a".to_owned())]
        );
        let text = "; objdict: allow a";
        assert_eq!(found(text, Format::Eds)[0].1, "file");
    }

    #[test]
    fn a_comment_holds_for_the_next_element_or_for_the_document() {
        let text = "<!-- objdict: allow a -->\n<r>\n  <!-- objdict: allow b -- why -->\n  <x><y/></x> <!--objdict: allow c--><z/>\n</r>";
        assert_eq!(
            found(text, Format::Xdd),
            [
                (words(&["a"]), "file".to_owned(), "<!-- objdict: allow a -->".to_owned()),
                (words(&["b"]), "<x><y/></x>".to_owned(), "  <!-- objdict: allow b -- why -->\n".to_owned()),
                (words(&["c"]), "<z/>".to_owned(), "<!--objdict: allow c-->".to_owned()),
            ]
        );
    }
}

//! What the words of an EDS or DCF are, for their colours.
//!
//! There is no Tree-sitter grammar: the server knows more about a value than a grammar can express.

use super::file::CheckedFile;
use super::protocol::SemanticTokens;
use objdict_eds::ini::LineKind;
use objdict_model::source::Span;

/// The kinds of words; a token names one by its position.
pub(super) const KINDS: [&str; 6] = ["comment", "namespace", "property", "number", "string", "macro"];
const COMMENT: u32 = 0;
const SECTION: u32 = 1;
const KEY: u32 = 2;
const NUMBER: u32 = 3;
const TEXT: u32 = 4;
const FORMULA: u32 = 5;

/// The tokens of a text, each relative to the one before.
pub(super) fn tokens(file: &CheckedFile) -> Option<SemanticTokens> {
    let document = file.description()?.document()?;
    let text = document.text();
    let mut data = Vec::new();
    let mut last = (0, 0);
    let mut push = |span: Span, kind: u32| {
        let range = file.positions().range(span);
        let (line, start) = (range.start.line, range.start.character);
        let delta_start = if line == last.0 { start - last.1 } else { start };
        let length = range.end.character - start;
        if length > 0 {
            // without modifiers
            data.extend([line - last.0, delta_start, length, kind, 0]);
            last = (line, start);
        }
    };
    for line in document.lines() {
        match line.kind {
            LineKind::Comment => push(line.span, COMMENT),
            LineKind::Section { name } => push(name, SECTION),
            LineKind::Entry { key, value } => {
                push(key, KEY);
                push(value, kind_of(value.of(text)));
            }
            LineKind::Blank | LineKind::Junk => {}
        }
    }
    Some(SemanticTokens { data })
}

fn kind_of(value: &str) -> u32 {
    let lower = value.to_ascii_lowercase();
    let digits = lower.strip_prefix("0x").unwrap_or(&lower);
    let is_number = !digits.is_empty()
        && (digits.len() < lower.len() && digits.bytes().all(|byte| byte.is_ascii_hexdigit())
            || digits.trim_start_matches('-').bytes().all(|byte| byte.is_ascii_digit()));
    match () {
        () if lower.contains("$nodeid") => FORMULA,
        () if is_number => NUMBER,
        () => TEXT,
    }
}

//! Escaping of description texts. Any text of a file appears unchanged and never as markup.
//!
//! Control characters and bidirectional control characters, including NUL, become U+FFFD everywhere
//! ([`visible`](crate::diagnostic::visible)); every line end becomes one line feed. askama.toml assigns an
//! escaper to each file extension, so a template cannot omit it.

mod csv;
pub(crate) mod filters;
mod html;
mod markdown;

pub use csv::field;
pub(crate) use html::{Html, address};
pub(crate) use markdown::{Markdown, code};

use crate::diagnostic::visible;

/// The character to write: `\r\n` and `\r` become one `\n`, so the first of the two yields nothing.
fn shown(character: char, next: Option<char>) -> Option<char> {
    match character {
        '\n' => Some('\n'),
        '\r' if next == Some('\n') => None,
        '\r' => Some('\n'),
        _ => Some(visible(character)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A text as displayed in every output format.
    pub(super) fn text_of(text: &str) -> String {
        let nexts = text.chars().skip(1).map(Some).chain([None]);
        text.chars().zip(nexts).filter_map(|(character, next)| shown(character, next)).collect()
    }

    #[test]
    fn line_ends_are_one_and_what_steers_is_seen() {
        assert_eq!(
            text_of("a\r\nb\rc\nd\0\u{202E}\u{9B}\u{61C}\t."),
            "a\nb\nc\nd\u{FFFD}\u{FFFD}\u{FFFD}\u{FFFD}\t."
        );
    }
}

//! Texts of a description in the places of a page: whatever stands in a file, it stays a text, and it is the text that is read.
//!
//! Characters that steer a terminal or the direction of a text, NUL among them, are U+FFFD everywhere
//! ([`visible`](crate::diagnostic::visible)); line ends are one line feed. askama.toml says which file has which escaper, so no
//! template can forget it.

mod csv;
mod html;
mod markdown;

pub(crate) use csv::field;
pub(crate) use html::Html;
pub(crate) use markdown::{Markdown, code};

use crate::diagnostic::visible;

/// A character as it is written: `\r\n` and `\r` are one `\n`, so the first of the two is nothing.
fn shown(character: char, next: Option<char>) -> Option<char> {
    match character {
        '\n' => Some('\n'),
        '\r' if next == Some('\n') => None,
        '\r' => Some('\n'),
        _ => Some(visible(character)),
    }
}

/// The same for templates.
#[allow(unreachable_pub)] // what the attribute writes is `pub`
pub(crate) mod filters {
    use askama::filters::Safe;
    use askama::{Result, Values};

    /// A text as code in Markdown: names that tools read, formulas, numbers.
    #[askama::filter_fn]
    pub(crate) fn code(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::code(text.as_ref())))
    }

    /// A value in Markdown: formulas and texts that are no value as code, anything else as it is.
    #[askama::filter_fn]
    pub(crate) fn shown_value(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        let text = text.as_ref();
        Ok(Safe(if text.contains('$') { super::code(text) } else { super::markdown::quoting(text) }))
    }

    /// What a finding says in Markdown, with what it quotes as code.
    #[askama::filter_fn]
    pub(crate) fn quoting(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::markdown::quoting(text.as_ref())))
    }

    /// A sentence in Markdown, with the formulas in it as code.
    #[askama::filter_fn]
    pub(crate) fn worded(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::markdown::worded(text.as_ref())))
    }

    /// A text in an element of Markdown that is HTML with all that it has in it.
    #[askama::filter_fn]
    pub(crate) fn html(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::html::one_line(text.as_ref())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A text as it comes out of every form.
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

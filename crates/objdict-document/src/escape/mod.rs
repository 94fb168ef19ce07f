//! Escaping of description texts. Any text of a file appears as that text and never as markup.
//!
//! Control characters and bidirectional control characters, including NUL, become U+FFFD everywhere
//! ([`visible`](crate::diagnostic::visible)); every line end becomes one line feed. askama.toml assigns an
//! escaper to each file extension, so a template cannot omit it.

mod css;
mod csv;
mod html;
mod markdown;
mod url;

pub use csv::field;
pub(crate) use html::Html;
pub(crate) use markdown::{Markdown, code};
pub(crate) use url::address;

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

/// The same as template filters.
#[allow(unreachable_pub, reason = "the attribute generates `pub` items")]
pub(crate) mod filters {
    use askama::filters::Safe;
    use askama::{Result, Values};

    /// A text as Markdown code: keys, formulas, numbers.
    #[askama::filter_fn]
    pub(crate) fn code(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::code(text.as_ref())))
    }

    /// A value in Markdown: formulas and invalid values as code, other values as text.
    #[askama::filter_fn]
    pub(crate) fn shown_value(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        let text = text.as_ref();
        Ok(Safe(if text.contains('$') { super::code(text) } else { super::markdown::quoting(text) }))
    }

    /// The message of a finding in Markdown, with quoted text as code.
    #[askama::filter_fn]
    pub(crate) fn quoting(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::markdown::quoting(text.as_ref())))
    }

    /// A sentence in Markdown, with formulas as code.
    #[askama::filter_fn]
    pub(crate) fn worded(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::markdown::worded(text.as_ref())))
    }

    /// A text in a string of a style sheet.
    #[askama::filter_fn]
    pub(crate) fn css(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::css::string(text.as_ref())))
    }

    /// A text inside a Markdown element that contains only HTML.
    #[askama::filter_fn]
    pub(crate) fn html(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
        Ok(Safe(super::html::one_line(text.as_ref())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A text as every output form shows it.
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

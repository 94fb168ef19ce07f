//! Escaping as template filters.
#![allow(unreachable_pub, reason = "the attribute generates `pub` items")]

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

/// A text for a string in a style sheet.
#[askama::filter_fn]
pub(crate) fn css(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
    Ok(Safe(super::html::string(text.as_ref())))
}

/// A text inside a Markdown element that contains only HTML.
#[askama::filter_fn]
pub(crate) fn html(text: impl AsRef<str>, _: &dyn Values) -> Result<Safe<String>> {
    Ok(Safe(super::html::one_line(text.as_ref())))
}

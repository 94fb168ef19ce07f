//! The rules about XML itself, reported while the tree is built because only the text shows the errors.

mod names;
mod structure;

pub(super) use names::*;
pub(super) use structure::*;

use std::borrow::Cow;

use crate::diagnostic::RuleInfo;

/// Every rule of this module.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    structure::RULES.iter().chain(names::RULES).copied()
}

/// The help of a finding: the remedy from the page of the rule.
pub(super) fn advice(rule: &RuleInfo) -> String {
    let advice = rule.remedy.trim_end_matches('.');
    let mut letters = advice.chars();
    letters.next().map(|first| first.to_ascii_lowercase()).into_iter().chain(letters).collect()
}

/// A piece of the file for a message, shortened if it is long.
pub(super) fn shown(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(40) {
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

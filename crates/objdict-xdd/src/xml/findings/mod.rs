//! The rules about XML itself. Only the text can show them, so they are raised by the builder of the tree.

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

/// A piece of the file for a message: its start, where it is long.
pub(super) fn shown(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(40) {
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

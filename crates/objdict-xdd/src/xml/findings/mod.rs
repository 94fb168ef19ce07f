//! The rules about XML itself. Only the text can show them, so they are raised by the builder of the tree.

mod names;
mod structure;

pub(super) use names::*;
pub(super) use structure::*;

use std::borrow::Cow;

use crate::diagnostic::RuleInfo;

/// Every rule of this module.
pub static RULES: &[&RuleInfo] = &[
    &UNCLOSED_ELEMENT,
    &STRAY_END_TAG,
    &NO_ROOT,
    &SECOND_ROOT,
    &TEXT_OUTSIDE_ROOT,
    &UNCLOSED_TAG,
    &UNCLOSED_MARKUP,
    &UNKNOWN_MARKUP,
    &LONE_LESS_THAN,
    &DOUBLE_HYPHEN,
    &CDATA_END_IN_TEXT,
    &MISPLACED_DECLARATION,
    &BAD_DECLARATION,
    &BAD_TARGET,
    &DOCUMENT_TYPE,
    &ENCODING,
    &LIMIT,
    &FORBIDDEN_CHARACTER,
    &BAD_REFERENCE,
    &UNKNOWN_ENTITY,
    &BAD_NAME,
    &UNBOUND_PREFIX,
    &BAD_NAMESPACE,
    &DUPLICATE_ATTRIBUTE,
    &MISSING_BLANK,
    &MISSING_VALUE,
    &UNQUOTED_VALUE,
    &UNCLOSED_VALUE,
    &LESS_THAN_IN_VALUE,
    &JUNK_IN_TAG,
];

/// A piece of the file for a message: its start, where it is long.
pub(super) fn shown(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(40) {
        Some((end, _)) => Cow::Owned(format!("{}…", &text[..end])),
        None => Cow::Borrowed(text),
    }
}

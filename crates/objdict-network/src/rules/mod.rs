//! The rules about networks.

mod links;
mod nodes;

pub(crate) use links::*;
pub(crate) use nodes::*;

use crate::diagnostic::RuleInfo;

/// The rules about networks.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    nodes::RULES.iter().copied()
}

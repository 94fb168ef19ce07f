//! The rules about networks.

mod bus;
mod links;
mod nodes;

pub(crate) use bus::*;
pub(crate) use links::*;
pub(crate) use nodes::*;

use crate::diagnostic::RuleInfo;

/// The rules about networks.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    links::RULES.iter().chain(nodes::RULES).chain(bus::RULES).copied()
}

//! Selection of rules by name.

use super::RuleInfo;

/// The rules selected by a name: one rule, or all rules of a group.
#[derive(Clone, Copy, Debug)]
pub enum Selection {
    /// The rules of a group, such as `cia306`.
    Group(&'static str),
    /// One rule.
    Rule(&'static RuleInfo),
}

impl Selection {
    /// Whether a rule is selected.
    pub fn contains(self, rule: &RuleInfo) -> bool {
        match self {
            Self::Group(group) => rule.group() == group,
            Self::Rule(one) => rule.id == one.id,
        }
    }

    /// The name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Group(group) => group,
            Self::Rule(rule) => rule.id,
        }
    }
}

crate::messages! { Selection: { selection => "{}", selection.name(); } }

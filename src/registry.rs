//! Every rule there is: those that the readers of the formats raise, and those of the linter. `explain`, severities,
//! suppression and the documentation know no difference.

use crate::diagnostic::RuleInfo;
use crate::{format, lint};

/// All rules, sorted by id.
pub fn rules() -> Vec<&'static RuleInfo> {
    let mut rules: Vec<_> = format::rules().chain(lint::RULES.iter().map(|rule| &rule.info)).collect();
    rules.sort_by_key(|rule| rule.id);
    rules
}

/// The rule of an id.
pub fn rule(id: &str) -> Option<&'static RuleInfo> {
    rules().into_iter().find(|rule| rule.id == id)
}

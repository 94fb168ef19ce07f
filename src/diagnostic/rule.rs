//! What a rule is: its name, its severity and its page.

use super::Severity;

/// The facts about a rule that every report and the documentation need.
#[derive(Debug)]
pub struct RuleInfo {
    /// Group and name, such as `cia306/duplicate-section`. An id is never used again for something else.
    pub id: &'static str,
    /// The severity of its findings.
    pub severity: Severity,
    /// The rule's page in Markdown: a first line that names the defect, then the headings of [`HEADINGS`].
    pub docs: &'static str,
}

/// The headings that every rule's page has, in this order.
pub const HEADINGS: [&str; 5] =
    ["## What it checks", "## Why it matters", "## Example", "## How to mend", "## Source"];

impl RuleInfo {
    /// The group: `cia306` of `cia306/duplicate-section`.
    pub fn group(&self) -> &'static str {
        self.id.split_once('/').map_or("", |(group, _)| group)
    }

    /// The name inside the group: `duplicate-section` of `cia306/duplicate-section`.
    pub fn name(&self) -> &'static str {
        self.id.split_once('/').map_or(self.id, |(_, name)| name)
    }

    /// The first line of the page: the defect in one sentence.
    pub fn summary(&self) -> &'static str {
        self.docs.lines().next().unwrap_or_default().trim()
    }
}

/// Declares a rule that the reader of a format raises: a `static` [`RuleInfo`] whose page is its doc comment.
macro_rules! text_rule {
    ($(#[doc = $doc:literal])+ $NAME:ident = $id:literal, $severity:ident) => {
        $(#[doc = $doc])+
        pub(crate) static $NAME: $crate::diagnostic::RuleInfo = $crate::diagnostic::RuleInfo {
            id: $id,
            severity: $crate::diagnostic::Severity::$severity,
            docs: concat!($($doc, "\n"),+),
        };
    };
}
pub(crate) use text_rule;

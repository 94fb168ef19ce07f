//! What a rule is: its name, its severity and its page.

use super::{Applicability, Severity};

/// The facts about a rule that every report and the documentation need.
#[derive(Debug)]
pub struct RuleInfo {
    /// Group and name, such as `cia306/duplicate-section`. An id is never used again for something else.
    pub id: &'static str,
    /// The severity of its findings.
    pub severity: Severity,
    /// Whether its findings can have a [fix](super::Fix), and the least safe that it can be.
    pub fix: Option<Applicability>,
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

    /// The documents that the rule comes from: the text under the heading "Source".
    pub fn source(&self) -> &'static str {
        self.docs.split_once("## Source").map_or("", |(_, source)| source).trim()
    }

    /// The page as Markdown, without the blank that a doc comment puts before each line.
    pub fn page(&self) -> String {
        let lines = self.docs.lines().map(|line| line.strip_prefix(' ').unwrap_or(line));
        lines.fold(String::new(), |page, line| page + line + "\n")
    }

    /// The text under a heading of the page, such as `## What it checks`; empty where the page has it not.
    pub fn section(&self, heading: &str) -> String {
        let page = self.page();
        let behind = page.split_once(&format!("\n{heading}\n")).map_or("", |(_, behind)| behind);
        behind.split("\n## ").next().unwrap_or_default().trim().to_owned()
    }

    /// The first line of the page: the defect in one sentence.
    pub fn summary(&self) -> &'static str {
        self.docs.lines().next().unwrap_or_default().trim()
    }
}

/// Declares a rule that the reader of a format raises: a `static` [`RuleInfo`] whose page is its doc comment.
///
/// `text_rule! { /// page … NAME = "cia306/name", Error, fix Safe }`; without the last part for a rule that mends nothing.
#[macro_export]
macro_rules! text_rule {
    ($(#[doc = $doc:literal])+ $NAME:ident = $id:literal, $severity:ident $(, fix $safety:ident)?) => {
        $(#[doc = $doc])+
        pub(crate) static $NAME: $crate::diagnostic::RuleInfo = $crate::diagnostic::RuleInfo {
            id: $id,
            severity: $crate::diagnostic::Severity::$severity,
            fix: $crate::fix_of!($($safety)?),
            docs: concat!($($doc, "\n"),+),
        };
    };
}

/// Declares the rules of a module as [`text_rule!`](crate::text_rule) does, each with `;` behind it, and `RULES`, the list of them.
#[macro_export]
macro_rules! text_rules {
    ($($(#[doc = $doc:literal])+ $NAME:ident = $id:literal, $severity:ident $(, fix $safety:ident)?;)+) => {
        /// Every rule of this module.
        pub(crate) static RULES: &[&$crate::diagnostic::RuleInfo] = &[$(&$NAME),+];

        $($crate::text_rule! { $(#[doc = $doc])+ $NAME = $id, $severity $(, fix $safety)? })+
    };
}

/// What a rule says of its fixes: nothing, `Safe` or `Unsafe`.
#[macro_export]
macro_rules! fix_of {
    () => {
        None
    };
    ($safety:ident) => {
        Some($crate::diagnostic::Applicability::$safety)
    };
}

//! The rules about what is said to objdict itself, in `objdict.toml` and in comments. They stand beside the list of all rules,
//! for the names of rules are what they are about.

use super::nearest_selection;
use crate::diagnostic::{Diagnostic, RuleInfo, Text, say, text_rule};
use crate::source::Span;

/// Every rule of this module.
pub(super) static RULES: &[&RuleInfo] = &[
    &INVALID_SETTING,
    &INVALID_SUPPRESSION,
    &INVALID_TOML,
    &UNKNOWN_RULE,
    &UNKNOWN_SETTING,
    &UNUSED_SUPPRESSION,
];

text_rule! {
    /// the configuration is no TOML
    ///
    /// ## What it checks
    /// Whether `objdict.toml` can be read at all. While it cannot, the files that it holds for are not checked, and the exit code is 2.
    ///
    /// ## Why it matters
    /// A check without its configuration reports what nobody wants to know and passes over what was asked for.
    ///
    /// ## Example
    /// `cia306/file-name = "off"`: the id of a rule has a `/` in it, so it must stand in quotes
    ///
    /// ## How to mend
    /// Correct the line that is shown.
    ///
    /// ## Source
    /// objdict, docs/config.md; TOML 1.1
    INVALID_TOML = "objdict/invalid-toml", Error
}

text_rule! {
    /// the configuration has a setting that there is not
    ///
    /// ## What it checks
    /// Whether `objdict.toml` knows each key of the top level.
    ///
    /// ## Why it matters
    /// Most likely it is misspelled, and what it should say does not hold.
    ///
    /// ## Example
    /// `node_id = 5` instead of `node-id = 5`
    ///
    /// ## How to mend
    /// Correct the name or remove the setting.
    ///
    /// ## Source
    /// objdict, docs/config.md
    UNKNOWN_SETTING = "objdict/unknown-setting", Warning
}

text_rule! {
    /// a setting has a value that it cannot have
    ///
    /// ## What it checks
    /// Whether each setting of `objdict.toml` has a value of its type and, where there are only some, one of them.
    ///
    /// ## Why it matters
    /// The setting does not hold, and the check does something else than was meant.
    ///
    /// ## Example
    /// `node-id = 128`
    ///
    /// ## How to mend
    /// Write a value that the setting can have.
    ///
    /// ## Source
    /// objdict, docs/config.md
    INVALID_SETTING = "objdict/invalid-setting", Error
}

text_rule! {
    /// a rule or group is named that there is not
    ///
    /// ## What it checks
    /// Whether each name of a rule in `objdict.toml` and in comments `objdict: allow` is the id of a rule, such as `cia306/file-name`, or a group, such as `cia306`.
    ///
    /// ## Why it matters
    /// What is said of it holds for no rule.
    ///
    /// ## Example
    /// `; objdict: allow cia306/filename`
    ///
    /// ## How to mend
    /// Correct the name; `objdict rules` lists all.
    ///
    /// ## Source
    /// objdict, docs/config.md
    UNKNOWN_RULE = "objdict/unknown-rule", Warning
}

text_rule! {
    /// a comment to objdict says nothing that it understands
    ///
    /// ## What it checks
    /// Whether a comment that starts with `objdict:` goes on with `allow` and the ids of rules, or names of groups, with blanks or commas between them.
    ///
    /// ## Why it matters
    /// Whoever wrote the comment expects that something is not reported, and it is.
    ///
    /// ## Example
    /// `; objdict: ignore cia306/file-name`
    ///
    /// ## How to mend
    /// Write `; objdict: allow cia306/file-name`; a reason may follow behind ` -- `.
    ///
    /// ## Source
    /// objdict, docs/config.md
    INVALID_SUPPRESSION = "objdict/invalid-suppression", Warning
}

text_rule! {
    /// a comment allows what is not there
    ///
    /// ## What it checks
    /// Whether each rule that a comment `objdict: allow` names finds something in the section or element that follows, or in the file when the comment stands before the first one. Rules that are off, and those about tools and profiles of a house that the check was not told of, are not looked at.
    ///
    /// ## Why it matters
    /// What was allowed is mended or has moved; the comment would hide the same mistake when somebody makes it again.
    ///
    /// ## Example
    /// `; objdict: allow cia306/file-name` in a file whose `FileName` is right
    ///
    /// ## How to mend
    /// Remove the comment, or the rule from it; or move it before the section that it is meant for.
    ///
    /// ## Source
    /// objdict, docs/config.md
    UNUSED_SUPPRESSION = "objdict/unused-suppression", Warning, fix Safe
}

/// A setting with a value that it cannot have.
pub(crate) fn invalid_setting(span: Span, message: impl Into<Text>) -> Diagnostic {
    Diagnostic::new(&INVALID_SETTING, span, message)
}

/// A name that is no rule and no group.
pub(crate) fn unknown_rule(span: Span, name: &str) -> Diagnostic {
    let finding = Diagnostic::new(&UNKNOWN_RULE, span, say!("there is no rule or group `{}`", name));
    match nearest_selection(name) {
        Some(meant) => finding.help(say!("did you mean `{}`?", meant)),
        None => finding.help("`objdict rules` lists all rules"),
    }
}

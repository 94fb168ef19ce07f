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
    INVALID_TOML = "objdict/invalid-toml", Error;
    summary: "the configuration is no TOML",
    checks: "Whether `objdict.toml` can be read at all. While it cannot, the files that it holds for are not checked, and the exit code is 2.",
    why: "A check without its configuration reports what nobody wants to know and passes over what was asked for.",
    example: r#"`cia306/file-name = "off"`: the id of a rule has a `/` in it, so it must stand in quotes"#,
    remedy: "Correct the line that is shown.",
    source: "objdict, docs/config.md; TOML 1.1",
}

text_rule! {
    UNKNOWN_SETTING = "objdict/unknown-setting", Warning;
    summary: "the configuration has a setting that there is not",
    checks: "Whether `objdict.toml` knows each key of the top level.",
    why: "Most likely it is misspelled, and what it should say does not hold.",
    example: "`node_id = 5` instead of `node-id = 5`",
    remedy: "Correct the name or remove the setting.",
    source: "objdict, docs/config.md",
}

text_rule! {
    INVALID_SETTING = "objdict/invalid-setting", Error;
    summary: "a setting has a value that it cannot have",
    checks: "Whether each setting of `objdict.toml` has a value of its type and, where there are only some, one of them.",
    why: "The setting does not hold, and the check does something else than was meant.",
    example: "`node-id = 128`",
    remedy: "Write a value that the setting can have.",
    source: "objdict, docs/config.md",
}

text_rule! {
    UNKNOWN_RULE = "objdict/unknown-rule", Warning;
    summary: "a rule or group is named that there is not",
    checks: "Whether each name of a rule in `objdict.toml` and in comments `objdict: allow` is the id of a rule, such as `cia306/file-name`, or a group, such as `cia306`.",
    why: "What is said of it holds for no rule.",
    example: "`; objdict: allow cia306/filename`",
    remedy: "Correct the name; `objdict rules` lists all.",
    source: "objdict, docs/config.md",
}

text_rule! {
    INVALID_SUPPRESSION = "objdict/invalid-suppression", Warning;
    summary: "a comment to objdict says nothing that it understands",
    checks: "Whether a comment that starts with `objdict:` goes on with `allow` and the ids of rules, or names of groups, with blanks or commas between them.",
    why: "Whoever wrote the comment expects that something is not reported, and it is.",
    example: "`; objdict: ignore cia306/file-name`",
    remedy: "Write `; objdict: allow cia306/file-name`; a reason may follow behind ` -- `.",
    source: "objdict, docs/config.md",
}

text_rule! {
    UNUSED_SUPPRESSION = "objdict/unused-suppression", Warning, fix Safe;
    summary: "a comment allows what is not there",
    checks: "Whether each rule that a comment `objdict: allow` names finds something in the section or element that follows, or in the file when the comment stands before the first one. Rules that are off, and those about tools and profiles of a house that the check was not told of, are not looked at.",
    why: "What was allowed is mended or has moved; the comment would hide the same mistake when somebody makes it again.",
    example: "`; objdict: allow cia306/file-name` in a file whose `FileName` is right",
    remedy: "Remove the comment, or the rule from it; or move it before the section that it is meant for.",
    source: "objdict, docs/config.md",
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

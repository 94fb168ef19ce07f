//! The rules about instructions to objdict itself, in `objdict.toml` and in comments. They are next to the list of all rules
//! because they check the names of rules.

use super::nearest_selection;
use objdict_model::diagnostic::{Diagnostic, Text, say, text_rules};
use objdict_model::source::Span;

text_rules! {
    source: "objdict, docs/reference/config.md";

    "objdict/invalid-toml" = INVALID_TOML, Error;
    summary: "the configuration is not valid TOML",
    checks: "`objdict.toml` must be valid TOML. Otherwise the files that it applies to are not checked, and the exit code is 2.",
    why: "A check without its configuration reports unwanted findings and misses wanted ones.",
    example: r#"`cia306/file-name = "off"`: the id of a rule contains a `/` and must be quoted"#,
    remedy: "Correct the reported line.",
    source: "objdict, docs/reference/config.md; TOML 1.1",

    "objdict/unknown-setting" = UNKNOWN_SETTING, Warning;
    summary: "the configuration contains an unknown setting",
    checks: "Each top-level key of `objdict.toml` must be a known setting.",
    why: "The name is probably misspelled, and the setting has no effect.",
    example: "`node_id = 5` instead of `node-id = 5`",
    remedy: "Correct the name or remove the setting.",

    "objdict/invalid-setting" = INVALID_SETTING, Error;
    summary: "a setting has an invalid value",
    checks: "Each setting of `objdict.toml` must have a value of its type. If only fixed values are allowed, it must be one of them.",
    why: "The setting has no effect, and the check differs from the intended one.",
    example: "`node-id = 128`",
    remedy: "Write a valid value.",

    "objdict/unknown-rule" = UNKNOWN_RULE, Warning;
    summary: "a rule or group is unknown",
    checks: "Each rule name in `objdict.toml` and in comments `objdict: allow` must be a rule id, such as `cia306/file-name`, or a group, such as `cia306`.",
    why: "The setting or comment has no effect.",
    example: "`; objdict: allow cia306/filename`",
    remedy: "Correct the name; `objdict rules` lists all rules.",

    "objdict/invalid-suppression" = INVALID_SUPPRESSION, Warning;
    summary: "a comment contains an invalid objdict instruction",
    checks: "In a comment that starts with `objdict:`, `allow` must follow, then rule ids or group names, separated by spaces or commas.",
    why: "The author expects the comment to suppress a finding, but it is reported.",
    example: "`; objdict: ignore cia306/file-name`",
    remedy: "Write `; objdict: allow cia306/file-name`; a reason may follow after ` -- `.",

    "objdict/unused-suppression" = UNUSED_SUPPRESSION, Warning, fix Safe;
    summary: "a comment allows a rule without findings",
    checks: "Each rule in a comment `objdict: allow` must have a finding in the following section or element. For a comment before the first one, it must have a finding in the file. Rules that are off are not checked. Neither are rules about tools or custom profiles that are not selected.",
    why: "The allowed problem was fixed or moved. The comment would hide the same problem if it occurs again.",
    example: "`; objdict: allow cia306/file-name` in a file whose `FileName` is right",
    remedy: "Remove the comment or the rule from it, or move the comment before the intended section.",
}

/// A setting with an invalid value.
pub fn invalid_setting(span: Span, message: impl Into<Text>) -> Diagnostic {
    Diagnostic::new(&INVALID_SETTING, span, message)
}

/// A name that is neither a rule nor a group.
pub fn unknown_rule(span: Span, name: &str) -> Diagnostic {
    let finding = Diagnostic::new(&UNKNOWN_RULE, span, say!("unknown rule or group `{}`", name));
    match nearest_selection(name) {
        Some(meant) => finding.help(say!("did you mean `{}`?", meant)),
        None => finding.help("run `objdict rules` to list all rules"),
    }
}

//! All rules: those of the format readers, those of the linter, and those about the configuration and suppression of
//! rules. `explain`, severities, suppression and the documentation treat them alike.
//!
//! The registry is in this crate because `objdict-lint` does not depend on formats.

mod groups;
#[doc(hidden)] // for the configuration
pub mod own;

use std::borrow::Cow;
use std::collections::BTreeSet;

use objdict_format as format;
use objdict_lint as lint;
use objdict_model::diagnostic::{RuleInfo, Selection, nearest};

pub use self::groups::{GROUPS, RuleGroup};

/// All rules, sorted by id.
pub fn rules() -> Vec<&'static RuleInfo> {
    let of_linter = lint::rules().map(|rule| &rule.info);
    let mut rules: Vec<_> = format::rules().chain(of_linter).chain(own::RULES.iter().copied()).collect();
    #[cfg(feature = "lint")]
    rules.extend(lint::changes::rules().map(|rule| &rule.info));
    #[cfg(feature = "network")]
    rules.extend(
        objdict_network_file::rules()
            .chain(lint::recorded::probe::RULES.iter().copied())
            .chain(lint::recorded::traffic::RULES.iter().copied()),
    );
    rules.sort_by_key(|rule| rule.id);
    rules
}

/// Former names of rules and groups, which configurations and `allow` comments may still contain.
const RENAMED: [(&str, &str); 19] = [
    ("cia301/error-by-default", "cia301/default-error-register"),
    ("cia301/half-set-life-guarding", "cia301/incomplete-life-guarding"),
    ("cia301/half-valid-sdo", "cia301/partly-valid-sdo"),
    ("cia301/mapping-without-switch", "cia301/mapping-without-valid-bit"),
    ("cia302/half-set-guarding", "cia302/incomplete-guarding"),
    ("cia306/decorated-bytes", "cia306/hex-prefix-in-bytes"),
    ("cia306/manager-that-is-no-master", "cia306/manager-without-nmt-master"),
    ("cia306/value-of-refused-entry", "cia306/value-of-no-download"),
    ("cia402/half-touch-probe", "cia402/incomplete-touch-probe"),
    ("cia404/half-scaling", "cia404/incomplete-scaling"),
    ("house", "custom"),
    ("naming/broken-numbering", "naming/unordered-numbering"),
    ("network/invalid-toml", "keys/invalid-toml"),
    ("network/key-defined-twice", "keys/key-defined-twice"),
    ("network/missing-key", "keys/missing-key"),
    ("network/out-of-range", "keys/out-of-range"),
    ("network/unknown-key", "keys/unknown-key"),
    ("network/wrong-type", "keys/wrong-type"),
    ("objdict/stale-carried-data", "objdict/stale-embedded-data"),
];

/// The present name of a rule or group.
fn current(name: &str) -> Cow<'_, str> {
    let renamed = |name: &str| RENAMED.iter().find(|(former, _)| *former == name).map(|(_, now)| *now);
    match (renamed(name), name.split_once('/')) {
        (Some(now), _) => Cow::Borrowed(now),
        (None, Some((group, rule))) => {
            renamed(group).map_or(name.into(), |group| format!("{group}/{rule}").into())
        }
        (None, None) => name.into(),
    }
}

/// The rule of an id, also of a former one.
pub fn rule(id: &str) -> Option<&'static RuleInfo> {
    let id = current(id);
    rules().into_iter().find(|rule| rule.id == id)
}

/// The groups of rules, sorted.
pub fn groups() -> BTreeSet<&'static str> {
    rules().into_iter().map(RuleInfo::group).collect()
}

/// The rules that a name selects: the id of a rule, or a group; also former names.
pub fn select(name: &str) -> Option<Selection> {
    let name = &*current(name);
    match name.contains('/') {
        true => rule(name).map(Selection::Rule),
        false => groups().into_iter().find(|group| *group == name).map(Selection::Group),
    }
}

/// The probable rule or group for an unknown name.
pub fn nearest_selection(name: &str) -> Option<Selection> {
    let group = if name.contains('/') { None } else { nearest(name, groups()) };
    group.map(Selection::Group).or_else(|| nearest_rule(name).map(Selection::Rule))
}

/// The probable rule for an unknown id or name.
pub fn nearest_rule(name: &str) -> Option<&'static RuleInfo> {
    let lower = name.to_ascii_lowercase();
    let wanted = lower.rsplit('/').next().unwrap_or(&lower);
    let rules = rules();
    let near = nearest(wanted, rules.iter().map(|rule| rule.name()));
    let find = |is_meant: &dyn Fn(&RuleInfo) -> bool| rules.iter().copied().find(|rule| is_meant(rule));
    near.and_then(|name| find(&|rule| rule.name() == name))
        .or_else(|| find(&|rule| !wanted.is_empty() && rule.name().contains(wanted)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn former_names_still_select() {
        for (former, now) in RENAMED {
            assert_eq!(select(former).map(Selection::name), Some(now), "{former}");
        }
        assert_eq!(rule("house/wrong-value").map(|rule| rule.id), Some("custom/wrong-value"));
    }

    #[test]
    fn names_mean_rules_and_groups() {
        let name = |selection: Option<Selection>| selection.map(Selection::name);
        assert_eq!(name(select("cia306/file-name")), Some("cia306/file-name"));
        assert_eq!(name(select("cia306")), Some("cia306"));
        assert_eq!(name(select("file-name")), None);
        assert_eq!(name(nearest_selection("cia3066")), Some("cia306"));
        assert_eq!(name(nearest_selection("cia306/filename")), Some("cia306/file-name"));
        assert_eq!(name(nearest_selection("duplicate-kei")), Some("cia306/duplicate-key"));
        assert_eq!(name(nearest_selection("")), None);
    }
}

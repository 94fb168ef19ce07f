//! `objdict rules` and `objdict explain`.

use std::io::Write;

use serde::Serialize;

use super::args::{ExplainArgs, RulesArgs, RulesFormat};
use super::ending::{Failure, Outcome};
use super::stdout::Output;
use super::table::TextTable;
use objdict_model::diagnostic::{FixSafety, RuleInfo, Severity, listing, nearest};
use objdict_model::json::Version;
use objdict_model::model::Address;
use objdict_project::registry;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct RulesJson {
    /// The version of the document.
    version: Version<1>,
    /// The rules.
    rules: Vec<RuleJson>,
}

/// A rule.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Rule"))]
struct RuleJson {
    /// The id, such as `cia306/duplicate-key`.
    id: &'static str,
    /// The group, which is in front of the slash.
    group: &'static str,
    /// The severity of its findings, unless a configuration changes it.
    severity: Severity,
    /// The safety of its fixes; absent for a rule without a fix.
    #[serde(skip_serializing_if = "Option::is_none")]
    fix: Option<FixSafety>,
    /// The document that demands it.
    source: &'static str,
    /// What it finds.
    summary: &'static str,
    /// Its page in Markdown.
    docs: String,
}

/// The rules, or those of some groups, a line each.
pub(super) fn list(args: &RulesArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let groups = args.group.iter().map(|name| group(name)).collect::<Result<Vec<_>, _>>()?;
    let is_meant = |rule: &&RuleInfo| groups.is_empty() || groups.contains(&rule.group());
    let rules = registry::rules().into_iter().filter(is_meant);
    match args.format {
        RulesFormat::Text => {
            let mut table = TextTable::new(["Rule", "Severity", "Fix", "Finds", "Source"], usize::MAX);
            for rule in rules {
                let fix = rule.fix.map_or_else(|| "–".to_owned(), |safety| safety.to_string());
                let [id, finds] = [rule.id, rule.summary].map(str::to_owned);
                table.row([id, rule.severity.to_string(), fix, finds, rule.source.to_owned()]);
            }
            table.write(out)?;
        }
        RulesFormat::Json => {
            let rule = |rule: &RuleInfo| RuleJson {
                id: rule.id,
                group: rule.group(),
                severity: rule.severity,
                fix: rule.fix,
                source: rule.source,
                summary: rule.summary,
                docs: rule.page(),
            };
            let document = RulesJson { version: Version, rules: rules.map(rule).collect() };
            out.pretty_json(&document)?;
        }
    }
    Ok(Outcome::Clean)
}

/// The group of a name, in upper or lower case.
fn group(name: &str) -> Result<&'static str, Failure> {
    let groups = registry::groups();
    let found = groups.iter().copied().find(|group| group.eq_ignore_ascii_case(name));
    found.ok_or_else(|| {
        let failure = Failure::new(format_args!("unknown rule group `{name}`"));
        failure.help(format!("the groups are {}", listing(groups)))
    })
}

/// The page of one rule, or of one object.
pub(super) fn explain(args: &ExplainArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let name = &args.subject;
    let Some(rule) = find(name) else {
        return match name.parse::<Address>() {
            Ok(address) => super::profile::explain(address.index, out).map(|()| Outcome::Clean),
            Err(_) => Err(unknown(name)),
        };
    };
    let fix = match rule.fix {
        None => "none",
        Some(FixSafety::Safe) => "safe, applied by `objdict check --fix`",
        Some(FixSafety::Unsafe) => "unsafe, applied by `objdict check --fix --unsafe-fixes`",
        Some(FixSafety::Mixed) => {
            "mixed: `objdict check --fix` applies the safe ones, `--unsafe-fixes` also the others"
        }
    };
    writeln!(out, "# {}\n\nSeverity: {}\nFix: {fix}\n", rule.id, rule.severity)?;
    out.write_all(rule.page().as_bytes())?;
    Ok(Outcome::Clean)
}

/// The rule of an id, or of a name where only one group has it.
fn find(name: &str) -> Option<&'static RuleInfo> {
    let name = name.to_ascii_lowercase();
    registry::rule(&name).or_else(|| {
        let mut rules = registry::rules().into_iter().filter(|rule| rule.name() == name);
        rules.next().filter(|_| rules.next().is_none())
    })
}

fn unknown(name: &str) -> Failure {
    let failure = Failure::new(format_args!("unknown rule `{name}`"));
    let lower = name.to_ascii_lowercase();
    if let Some(group) = registry::groups().into_iter().find(|group| lower.trim_end_matches('/') == *group) {
        return failure.help(format!("that is a group; `objdict rules --group {group}` lists its rules"));
    }
    match similar(&lower)[..] {
        [] => failure.help("`objdict rules` lists all"),
        ref rules => failure.help(format!("did you mean {}? `objdict rules` lists all", alternatives(rules))),
    }
}

/// The rules that are most likely meant by a name, at most three: those of the nearest name, in whatever group, else those
/// that have it in their name.
fn similar(name: &str) -> Vec<&'static RuleInfo> {
    let wanted = name.rsplit('/').next().unwrap_or(name);
    let rules = registry::rules();
    let near = nearest(wanted, rules.iter().map(|rule| rule.name()));
    let is_meant = |rule: &&RuleInfo| match near {
        Some(near) => rule.name() == near,
        None => wanted.len() > 2 && rule.name().contains(wanted),
    };
    rules.into_iter().filter(is_meant).take(3).collect()
}

/// "`a`, `b` or `c`".
fn alternatives(rules: &[&RuleInfo]) -> String {
    let mut names: Vec<String> = rules.iter().map(|rule| format!("`{}`", rule.id)).collect();
    match names.pop() {
        Some(last) if !names.is_empty() => format!("{} or {last}", names.join(", ")),
        last => last.unwrap_or_default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_without_its_group_is_enough() {
        assert_eq!(find("Duplicate-Key").map(|rule| rule.id), Some("cia306/duplicate-key"));
        assert!(find("no-such-rule").is_none());
        assert!(
            unknown("cia306/duplicat-key").help.is_some_and(|help| help.contains("cia306/duplicate-key"))
        );
        assert!(unknown("CiA306").help.is_some_and(|help| help.contains("`objdict rules --group cia306`")));
        assert!(unknown("").help.is_some_and(|help| !help.contains("did you mean")));
    }
}

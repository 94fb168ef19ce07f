//! `objdict rules` and `objdict explain`.

use std::io::Write;

use serde::Serialize;

use super::args::{ExplainArgs, RulesArgs, RulesFormat};
use super::output::Output;
use super::table::Table;
use super::{Failure, Outcome};
use crate::diagnostic::{RuleInfo, Severity};
use crate::registry;

/// The version of the JSON document. It changes when a field is removed or means something else.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Document {
    version: u32,
    rules: Vec<Rule>,
}

#[derive(Serialize)]
struct Rule {
    id: &'static str,
    severity: Severity,
    summary: &'static str,
    docs: String,
}

/// All rules, a line each.
pub(super) fn list(args: &RulesArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let rules = registry::rules();
    match args.format {
        RulesFormat::Text => {
            let mut table = Table::new(["Rule", "Severity", "Finds"], usize::MAX);
            for rule in rules {
                table.row([rule.id.to_owned(), rule.severity.to_string(), rule.summary().to_owned()]);
            }
            table.write(out)?;
        }
        RulesFormat::Json => {
            let rule = |rule: &RuleInfo| Rule {
                id: rule.id,
                severity: rule.severity,
                summary: rule.summary(),
                docs: rule.page(),
            };
            let document = Document { version: VERSION, rules: rules.into_iter().map(rule).collect() };
            serde_json::to_writer_pretty(&mut *out, &document).map_err(std::io::Error::from)?;
            out.write_all(b"\n")?;
        }
    }
    Ok(Outcome::Clean)
}

/// The page of one rule.
pub(super) fn explain(args: &ExplainArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let Some(rule) = find(&args.rule) else { return Err(unknown(&args.rule)) };
    writeln!(out, "# {} ({})\n", rule.id, rule.severity)?;
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
    let failure = Failure::new(format_args!("there is no rule `{name}`"));
    match registry::nearest_rule(name) {
        Some(rule) => failure.help(format!("did you mean `{}`? `objdict rules` lists all", rule.id)),
        None => failure.help("`objdict rules` lists all"),
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
    }
}

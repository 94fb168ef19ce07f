//! docs/rules.md, out of the pages of the rules, and docs/portability.md, out of what is known of other tools.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::compat::REACTIONS;
use objdict::diagnostic::RuleInfo;
use objdict::registry;

use crate::shares::{self, Shares};

/// The columns of the tables of rules.
const HEADINGS: &str = "| rule | severity | fix | share | defect |\n";

/// Writes the generated pages, or with `check` fails when one is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let rules = rules_page(&shares::read(&folder.join("rules-shares.tsv"))?);
    for (name, text) in [("rules.md", rules), ("portability.md", portability_page())] {
        let (path, shown) = (folder.join(name), format!("docs/{name}"));
        if check {
            let current =
                fs::read_to_string(&path).map_err(|error| format!("cannot read {shown}: {error}"))?;
            if current != text {
                return Err(format!("{shown} is stale: run `cargo xtask docs`"));
            }
        } else {
            fs::write(&path, text).map_err(|error| format!("cannot write {shown}: {error}"))?;
        }
    }
    Ok(())
}

/// What stands above the table of docs/portability.md.
const PORTABILITY: &str = include_str!("portability.md");

fn portability_page() -> String {
    let mut page = String::from(PORTABILITY);
    let causes: BTreeSet<&str> = REACTIONS.iter().map(|reaction| reaction.rule).collect();
    let _ = writeln!(page, "{} causes.\n", causes.len());
    page.push_str("| rule | what is found | tools | effect | what happens |\n|---|---|---|---|---|\n");
    for reaction in REACTIONS {
        let summary = registry::rule(reaction.rule).map_or("", |rule| rule.summary());
        let tools: Vec<&str> = reaction.tools.iter().map(|tool| tool.name()).collect();
        let when = reaction.when.map_or(String::new(), |when| format!(" ({})", when.text));
        let _ = writeln!(
            page,
            "| [`{}`](rules.md#{}) | {summary}{when} | {} | {} | {} |",
            reaction.rule,
            reaction.rule.replace('/', ""),
            tools.join(", "),
            reaction.effect.name(),
            reaction.what
        );
    }
    page
}

fn rules_page(shares: &Shares) -> String {
    let rules = registry::rules();
    let mut page = String::from(
        "# Rules\n\nGenerated from the sources by `cargo xtask docs`; `objdict explain RULE` shows the same pages.\n\n",
    );
    let fixes = rules.iter().filter(|rule| rule.fix.is_some()).count();
    let _ = writeln!(
        page,
        "{} rules, {fixes} of them with a fix. A safe fix keeps the meaning for every tool; an unsafe one is the most likely \
         intention, and somebody should look at it. The share is that of the files of a corpus of published descriptions in \
         which a rule finds something; it was not counted for those with a dash.\n",
        rules.len()
    );
    for group in rules.chunk_by(|a, b| a.group() == b.group()) {
        let name = group[0].group();
        let _ = writeln!(page, "* [{name}](#{name}): {}", group.len());
    }
    for group in rules.chunk_by(|a, b| a.group() == b.group()) {
        let _ = writeln!(page, "\n## {}\n\n{}|---|---|---|---|---|", group[0].group(), HEADINGS);
        for rule in group {
            let anchor = rule.id.replace('/', "");
            let fix = rule.fix.map_or_else(|| "–".to_owned(), |safety| safety.to_string());
            let share = shares::shown(shares.get(rule.id));
            let _ = writeln!(
                page,
                "| [`{}`](#{anchor}) | {} | {fix} | {share} | {} |",
                rule.id,
                rule.severity,
                rule.summary()
            );
        }
    }
    rules.iter().for_each(|rule| describe(rule, &mut page));
    page
}

fn describe(rule: &RuleInfo, page: &mut String) {
    let fix = rule.fix.map_or_else(String::new, |safety| format!(", {safety} fix"));
    let _ = writeln!(page, "\n## {}\n\n**{}**{fix}: {}.", rule.id, rule.severity, rule.summary());
    let text = rule.page();
    let body = text.split_once('\n').map_or("", |(_, body)| body);
    for line in body.trim_end().lines() {
        let level = if line.starts_with("## ") { "#" } else { "" };
        let _ = writeln!(page, "{level}{line}");
    }
}

#[test]
fn the_generated_pages_are_those_of_the_rules() {
    assert_eq!(run(true), Ok(()));
}

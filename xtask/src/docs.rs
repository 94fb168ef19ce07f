//! docs/rules.md, out of the pages of the rules, and docs/portability.md, out of what is known of other tools.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::compat::REACTIONS;
use objdict::registry;

/// Writes the generated pages, or with `check` fails when one is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    for (shown, text) in [("docs/rules.md", rules_page()), ("docs/portability.md", portability_page())] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(shown);
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

fn rules_page() -> String {
    let rules = registry::rules();
    let mut page = String::from(
        "# Rules\n\nGenerated from the sources by `cargo xtask docs`; `objdict explain RULE` shows the same pages.\n\n",
    );
    let _ = writeln!(page, "{} rules.\n\n| rule | severity | defect |\n|---|---|---|", rules.len());
    for rule in &rules {
        let anchor = rule.id.replace('/', "");
        let _ = writeln!(page, "| [`{}`](#{anchor}) | {} | {} |", rule.id, rule.severity, rule.summary());
    }
    for rule in &rules {
        let body: String = rule.docs.lines().skip(1).map(|line| line.strip_prefix(' ').unwrap_or(line)).fold(
            String::new(),
            |mut body, line| {
                if line.starts_with("## ") {
                    body.push('#');
                }
                body.push_str(line);
                body.push('\n');
                body
            },
        );
        let _ = write!(
            page,
            "\n## {}\n\n**{}**: {}.\n{}",
            rule.id,
            rule.severity,
            rule.summary(),
            body.trim_end()
        );
        page.push('\n');
    }
    page
}

//! docs/rules, a page for each group of rules, docs/reference/portability.md, out of what is known of other tools, and tables in other pages.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::cli::{CommandReference, CommandTables};
use objdict::compat::{MESSAGES, REACTIONS};
use objdict::diagnostic::RuleInfo;
use objdict::format::input::FileKind;
use objdict::lint::changes::Audience;
use objdict::registry;

use crate::examples;
use crate::shares::{self, Shares};

/// Writes the generated pages, or with `check` fails when one is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let mut pages = rule_pages(&shares::read(&folder.join("rules-shares.tsv"))?)?;
    pages.insert("reference/portability.md".to_owned(), portability_page());
    let generated = [
        ("reference/verdicts.md", "verdicts", verdicts()),
        ("reference/formats.md", "formats", FileKind::table()),
    ];
    for (page, mark, table) in generated {
        pages.insert(page.to_owned(), with_table(&text_of(&folder, page)?, page, mark, &table)?);
    }
    command_pages(&folder, &mut pages)?;
    for (name, text) in &pages {
        let (path, shown) = (folder.join(name), format!("docs/{name}"));
        if check {
            let current =
                fs::read_to_string(&path).map_err(|error| format!("cannot read {shown}: {error}"))?;
            if current != *text {
                return Err(format!("{shown} is stale: run `cargo xtask docs`"));
            }
        } else {
            fs::write(&path, text).map_err(|error| format!("cannot write {shown}: {error}"))?;
        }
    }
    remove_leftovers(&folder.join("rules"), &pages, check)
}

/// Removes the pages of groups that are gone, or with `check` fails when there is one.
fn remove_leftovers(folder: &Path, pages: &BTreeMap<String, String>, check: bool) -> Result<(), String> {
    let files = fs::read_dir(folder).map_err(|error| format!("cannot read docs/rules: {error}"))?;
    for file in files {
        let file = file.map_err(|error| error.to_string())?;
        let name = format!("rules/{}", file.file_name().to_string_lossy());
        if pages.contains_key(&name) {
            continue;
        }
        if check {
            return Err(format!("docs/{name} belongs to no group: run `cargo xtask docs`"));
        }
        fs::remove_file(file.path()).map_err(|error| format!("cannot remove docs/{name}: {error}"))?;
    }
    Ok(())
}

/// The reference of each command above what its page explains, and the tables of all commands.
fn command_pages(folder: &Path, pages: &mut BTreeMap<String, String>) -> Result<(), String> {
    let CommandTables { commands, input, common } = objdict::cli::reference();
    let mut table = String::from("| Command | |\n|---|---|\n");
    for CommandReference { name, summary, text } in &commands {
        let _ = writeln!(table, "| [`{name}`](commands/{name}.md) | {summary} |");
        let page = format!("reference/commands/{name}.md");
        let written =
            with_table(&text_of(folder, &page)?, &page, "reference", &format!("{summary}.\n\n{text}"))?;
        pages.insert(page, written);
    }
    let page = "reference/cli.md";
    let mut text = text_of(folder, page)?;
    for (mark, table) in [("commands", table), ("common", common), ("input", input)] {
        text = with_table(&text, page, mark, &table)?;
    }
    pages.insert(page.to_owned(), text);
    Ok(())
}

fn text_of(folder: &Path, page: &str) -> Result<String, String> {
    fs::read_to_string(folder.join(page)).map_err(|error| format!("cannot read docs/{page}: {error}"))
}

/// A page of docs with a table between its marks: `<!-- verdicts -->`.
fn with_table(text: &str, page: &str, mark: &str, table: &str) -> Result<String, String> {
    let marks = [format!("<!-- {mark} -->\n"), format!("<!-- end of {mark} -->")];
    let parts =
        text.split_once(&marks[0]).and_then(|(before, rest)| Some((before, rest.split_once(&marks[1])?.1)));
    let (before, behind) = parts.ok_or_else(|| format!("docs/{page} has no marks around its {mark}"))?;
    Ok(format!("{before}{}{table}{}{behind}", marks[0], marks[1]))
}

/// The kinds of changes and their verdicts for each audience.
fn verdicts() -> String {
    let titles = Audience::ALL.map(Audience::title).join(" | ");
    let mut table = format!("| change | {titles} |\n|---|{}\n", "---|".repeat(Audience::ALL.len()));
    for rule in objdict::lint::changes::rules() {
        let verdict = |audience: Audience| {
            let effect = rule.effects.iter().find(|effect| effect.audience == audience);
            effect.map_or("–", |effect| effect.verdict.name())
        };
        let verdicts = Audience::ALL.map(verdict).join(" | ");
        let info = &rule.info;
        let _ = writeln!(table, "| [{}]({}) | {verdicts} |", info.summary, address(info.id));
    }
    table
}

/// The address of a rule's page, from a page in a folder of `docs`.
fn address(rule: &str) -> String {
    let (group, name) = rule.split_once('/').unwrap_or((rule, ""));
    format!("../rules/{group}.md#{name}")
}

/// The text above the table of docs/reference/portability.md.
const PORTABILITY: &str = include_str!("portability.md");

/// The text between the tables of docs/reference/portability.md.
const CANCHKEDS: &str = include_str!("canchkeds.md");

/// The text above the tables of docs/rules/index.md.
const INDEX: &str = include_str!("rules.md");

/// The line at the top of the page of a group.
const GENERATED: &str =
    "Generated from the sources by `cargo xtask docs`; `objdict explain RULE` prints the same text.";

/// The columns of the tables of rules.
const HEADINGS: &str = "| rule | severity | fix | share | problem |\n|---|---|---|---|---|";

fn portability_page() -> String {
    let mut page = String::from(PORTABILITY);
    let causes: BTreeSet<&str> = REACTIONS.iter().map(|reaction| reaction.rule).collect();
    let _ = writeln!(page, "{} causes.\n", causes.len());
    page.push_str("| rule | what is found | tools | effect | what happens |\n|---|---|---|---|---|\n");
    for reaction in REACTIONS {
        let summary = registry::rule(reaction.rule).map_or("", |rule| rule.summary);
        let tools: Vec<&str> = reaction.tools.iter().map(|tool| tool.name()).collect();
        let when = reaction.when.map_or(String::new(), |when| format!(" ({})", when.text));
        let _ = writeln!(
            page,
            "| [`{}`]({}) | {summary}{when} | {} | {} | {} |",
            reaction.rule,
            address(reaction.rule),
            tools.join(", "),
            reaction.effect.name(),
            reaction.what
        );
    }
    page.push_str(CANCHKEDS);
    for message in MESSAGES {
        let summary = registry::rule(message.rule).map_or("", |rule| rule.summary);
        let when = message.when.map_or(String::new(), |when| format!(" ({})", when.text));
        let _ = writeln!(
            page,
            "| [`{}`]({}) | {summary}{when} | {} |",
            message.rule,
            address(message.rule),
            message.what
        );
    }
    page
}

/// The index of the rules and the page of each group, by their paths in `docs`.
fn rule_pages(shares: &Shares) -> Result<BTreeMap<String, String>, String> {
    let rules = registry::rules();
    let mut index = String::from(INDEX);
    let fixes = rules.iter().filter(|rule| rule.fix.is_some()).count();
    let _ = writeln!(index, "{} rules, {fixes} of them with a fix.\n", rules.len());
    index.push_str("| group | rules | about | needs |\n|---|---|---|---|\n");
    let mut pages = BTreeMap::new();
    let mut tables = String::new();
    for group in rules.chunk_by(|a, b| a.group() == b.group()) {
        let name = group[0].group();
        let row = registry::GROUPS.iter().find(|group| group.name == name);
        let registry::RuleGroup { about, needs, .. } =
            row.ok_or_else(|| format!("crates/objdict-project/src/registry/groups.rs lacks `{name}`"))?;
        let needs = needs.unwrap_or("–");
        let _ = writeln!(index, "| [`{name}`](#{name}) | {} | {about} | {needs} |", group.len());
        let _ = writeln!(tables, "\n## {name}\n\n{HEADINGS}");
        group.iter().for_each(|rule| list(rule, shares, &mut tables));
        let mut page = format!("# {name}: {about}\n\n{GENERATED}\n");
        group.iter().for_each(|rule| describe(rule, shares, &mut page));
        pages.insert(format!("rules/{name}.md"), page);
    }
    pages.insert("rules/index.md".to_owned(), index + &tables);
    Ok(pages)
}

/// A row in the table of a group.
fn list(rule: &RuleInfo, shares: &Shares, tables: &mut String) {
    let address = address(rule.id);
    let address = address.trim_start_matches("../rules/");
    let fix = rule.fix.map_or_else(|| "–".to_owned(), |safety| safety.to_string());
    let share = shares::shown(shares.get(rule.id));
    let (name, severity, summary) = (rule.name(), rule.severity, rule.summary);
    let _ = writeln!(tables, "| [`{name}`]({address}) | {severity} | {fix} | {share} | {summary} |");
}

fn describe(rule: &RuleInfo, shares: &Shares, page: &mut String) {
    let share =
        shares.get(rule.id).map_or_else(String::new, |(files, total)| format!(" · {files} of {total} files"));
    let fix = rule.fix.map_or_else(String::new, |safety| format!(", {safety} fix"));
    let _ = writeln!(
        page,
        "\n## {}\n\n`{}` · **{}**{fix}{share}: {}.",
        rule.name(),
        rule.id,
        rule.severity,
        rule.summary
    );
    let text = rule.page();
    let body = text.split_once('\n').map_or("", |(_, body)| body);
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures");
    for line in body.trim_end().lines() {
        if line == "## How to fix" {
            // the blank line before the heading comes after the example
            page.truncate(page.trim_end().len());
            page.push('\n');
            page.push_str(&examples::of_rule(&fixtures, rule.id).unwrap_or_default());
            page.push('\n');
        }
        let level = if line.starts_with("## ") { "#" } else { "" };
        let _ = writeln!(page, "{level}{line}");
    }
}

#[test]
fn the_generated_pages_are_those_of_the_rules() {
    assert_eq!(run(true), Ok(()));
}

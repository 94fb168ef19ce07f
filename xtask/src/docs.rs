//! Generated pages: docs/rules, docs/reference/portability.md, and tables in other pages.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::cli::{CommandReference, CommandTables};
use objdict::compat::{MESSAGES, REACTIONS};
use objdict::format::input::FileKind;
use objdict::lint::changes::Audience;
use objdict::registry;

use crate::{json_pages, rule_pages, shares};

/// The generated pages by their paths in `docs`.
pub(crate) type Pages = BTreeMap<String, String>;

/// Writes the generated pages, or with `check` fails when one is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs");
    let mut pages = Pages::new();
    rule_pages::add(&shares::read(&folder.join("rules-shares.tsv"))?, &mut pages)?;
    pages.insert("reference/portability.md".to_owned(), portability_page());
    let generated = [
        ("reference/verdicts.md", "verdicts", verdicts()),
        ("reference/formats.md", "formats", FileKind::table()),
    ];
    for (page, mark, table) in generated {
        pages.insert(page.to_owned(), with_table(&text_of(&folder, page)?, page, mark, &table)?);
    }
    let summary =
        with_table(&text_of(&folder, "SUMMARY.md")?, "SUMMARY.md", "rules", &rule_pages::contents())?;
    let summary = with_table(&summary, "SUMMARY.md", "documents", &json_pages::contents(&folder)?)?;
    pages.insert("SUMMARY.md".to_owned(), summary);
    json_pages::add(&folder, &mut pages)?;
    command_pages(&folder, &mut pages)?;
    for (name, text) in &pages {
        store(&folder.join(name), &format!("docs/{name}"), text, check)?;
    }
    store(&folder.join("../src/rule_pages.rs"), "src/rule_pages.rs", &rule_pages::modules(), check)?;
    remove_leftovers(&folder, "rules", &pages, check)?;
    remove_leftovers(&folder, "reference/json", &pages, check)
}

/// Writes a file, or with `check` fails if it has a different text.
fn store(path: &Path, shown: &str, text: &str, check: bool) -> Result<(), String> {
    let current = fs::read_to_string(path);
    if current.is_ok_and(|current| current == text) {
        return Ok(());
    }
    if check {
        return Err(format!("{shown} is missing or stale: run `cargo xtask docs`"));
    }
    let folder = path.parent().unwrap_or(Path::new("."));
    fs::create_dir_all(folder)
        .and_then(|()| fs::write(path, text))
        .map_err(|error| format!("cannot write {shown}: {error}"))
}

/// Removes the pages of rules, groups and documents that are gone, or with `check` fails when there is one.
fn remove_leftovers(docs: &Path, folder: &str, pages: &Pages, check: bool) -> Result<(), String> {
    let failed = |error: std::io::Error| format!("cannot tidy docs/{folder}: {error}");
    for file in fs::read_dir(docs.join(folder)).map_err(failed)? {
        let file = file.map_err(failed)?;
        let name = format!("{folder}/{}", file.file_name().to_string_lossy());
        if file.path().is_dir() {
            remove_leftovers(docs, &name, pages, check)?;
        } else if check && !pages.contains_key(&name) {
            return Err(format!("docs/{name} is not generated: run `cargo xtask docs`"));
        } else if !pages.contains_key(&name) {
            fs::remove_file(file.path()).map_err(failed)?;
        }
    }
    Ok(())
}

/// The reference of each command above what its page explains, and the tables of all commands.
fn command_pages(folder: &Path, pages: &mut Pages) -> Result<(), String> {
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

pub(crate) fn text_of(folder: &Path, page: &str) -> Result<String, String> {
    fs::read_to_string(folder.join(page)).map_err(|error| format!("cannot read docs/{page}: {error}"))
}

/// A page of docs with a table between its marks: `<!-- verdicts -->`.
pub(crate) fn with_table(text: &str, page: &str, mark: &str, table: &str) -> Result<String, String> {
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
        let _ = writeln!(table, "| [{}]({}) | {verdicts} |", info.summary, rule_pages::address(info.id));
    }
    table
}

/// The text above the table of docs/reference/portability.md.
const PORTABILITY: &str = include_str!("portability.md");

/// The text between the tables of docs/reference/portability.md.
const CANCHKEDS: &str = include_str!("canchkeds.md");

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
            rule_pages::address(reaction.rule),
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
            rule_pages::address(message.rule),
            message.what
        );
    }
    page
}

#[test]
fn the_generated_pages_are_those_of_the_rules() {
    assert_eq!(run(true), Ok(()));
}

//! docs/rules.md, out of the pages of the rules.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::registry;

/// Writes docs/rules.md, or with `check` fails when it is not what it would write.
pub(crate) fn run(check: bool) -> Result<(), String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/rules.md");
    let text = rules_page();
    let shown = "docs/rules.md";
    if check {
        let current = fs::read_to_string(&path).map_err(|error| format!("cannot read {shown}: {error}"))?;
        return if current == text {
            Ok(())
        } else {
            Err(format!("{shown} is stale: run `cargo xtask docs`"))
        };
    }
    fs::write(&path, text).map_err(|error| format!("cannot write {shown}: {error}"))
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

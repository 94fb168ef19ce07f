//! The fixtures of the rules: each bad one shows its rule and no other, each good one none.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use super::{check, rules};
use crate::diagnostic::{At, Findings};
use crate::format::xml::Tree;
use crate::source::{SourceFile, SourceOptions};

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/rules/cia311")
}

fn paths(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    paths
}

fn name(path: &Path) -> &str {
    path.file_name().and_then(|name| name.to_str()).unwrap_or_default()
}

/// What is found in a file, a line each, and the rules that found it.
fn findings(path: &Path) -> (String, BTreeSet<&'static str>) {
    let source = SourceFile::open(path, &SourceOptions::default())
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut findings = Findings::new();
    let tree = Tree::new(source, &mut findings);
    check(&tree, &mut findings);
    let mut report = String::new();
    for finding in &findings {
        let at = finding.labels.first().map(|label| &label.at);
        let Some(At::Span(span)) = at else { panic!("{}: {} has no place", path.display(), finding.rule.id) };
        let at = tree.source().line_column(span.start);
        let shown = span.of(tree.text());
        let help = finding.help.as_deref().unwrap_or("-");
        let (severity, rule, message) = (finding.severity, finding.rule.id, &finding.message);
        report.push_str(&format!(
            "{}:{} {severity} {rule} `{shown}`: {message} ({help})\n",
            at.line, at.column
        ));
    }
    (report, findings.iter().map(|finding| finding.rule.id).collect())
}

#[test]
fn a_bad_fixture_shows_its_rule_and_a_good_one_none() {
    let mut errors = String::new();
    for folder in paths(&fixtures()) {
        for path in paths(&folder) {
            let (report, fired) = findings(&path);
            let id = format!("cia311/{}", name(&folder));
            let expected: BTreeSet<&str> =
                if name(&path).starts_with("bad") { [id.as_str()].into() } else { [].into() };
            if fired != expected {
                errors.push_str(&format!("{}:\n{report}\n", path.display()));
            }
        }
    }
    assert!(errors.is_empty(), "{errors}");
}

#[test]
fn every_rule_has_fixtures() {
    let folders: BTreeSet<String> = paths(&fixtures()).iter().map(|path| name(path).to_owned()).collect();
    let rules: BTreeSet<String> = rules().map(|rule| rule.name().to_owned()).collect();
    assert_eq!(folders, rules);
}

//! docs/rules-shares.tsv: on how many of the files of a corpus each rule fires. The files themselves are not ours to show.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use objdict::registry;

/// The number of files that each rule fires on, and of files in all.
pub(crate) type Shares = BTreeMap<String, (usize, usize)>;

/// Whether a description alone can raise the rules of the group, as those of a corpus are checked.
fn is_counted(group: &str) -> bool {
    registry::GROUPS.iter().any(|known| known.name == group && known.needs.is_none())
}

/// Writes a row for each rule: its id, the files that it fires on, the files in all. `fired` has a rule once for each file.
pub(crate) fn write<'a>(
    file: &Path,
    fired: impl Iterator<Item = &'a str>,
    total: usize,
) -> Result<(), String> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for rule in fired {
        *counts.entry(rule).or_default() += 1;
    }
    let mut text = String::from("rule\tfiles\tin all\n");
    for rule in registry::rules().iter().filter(|rule| is_counted(rule.group())) {
        let _ = writeln!(text, "{}\t{}\t{total}", rule.id, counts.get(rule.id).copied().unwrap_or_default());
    }
    fs::write(file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))
}

/// Reads what was written; nothing where there is no file yet.
pub(crate) fn read(file: &Path) -> Result<Shares, String> {
    let Ok(text) = fs::read_to_string(file) else { return Ok(Shares::new()) };
    let row = |line: &str| -> Option<(String, (usize, usize))> {
        let mut cells = line.split('\t');
        let rule = cells.next()?.to_owned();
        Some((rule, (cells.next()?.parse().ok()?, cells.next()?.parse().ok()?)))
    };
    text.lines()
        .skip(1)
        .map(|line| row(line).ok_or_else(|| format!("{}: `{line}` is no row", file.display())))
        .collect()
}

#[test]
fn shares_are_those_of_rules_that_a_description_can_raise() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/rules-shares.tsv");
    let shares = read(&file).unwrap();
    let counted = |id: &String| registry::rule(id).is_some_and(|rule| is_counted(rule.group()));
    let others: Vec<_> = shares.keys().filter(|id| !counted(id)).collect();
    assert_eq!(others, [""; 0], "docs/rules-shares.tsv");
}

//! Mistakes as people make them, planted in healthy fixtures: `fixtures/planted.txt` and, by somebody who had read no rule,
//! `fixtures/planted-blind.txt` have each with the rule that finds it.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use objdict::diagnostic::Findings;
use objdict::format::network::NetworkFile;
use objdict::lint::Options;

use crate::rules::open;
use crate::support;

/// The share of the mistakes that must be found, in percent.
const FOUND: usize = 90;

/// A mistake: `old` behind `at` is `new`.
pub(crate) struct Mistake<'a> {
    pub(crate) file: &'a str,
    /// The rule that finds it; `None` for a mistake that no rule finds.
    rule: Option<&'a str>,
    what: &'a str,
    at: String,
    old: String,
    new: String,
}

/// All lines of the tables.
pub(crate) fn table() -> String {
    let names = ["planted.txt", "planted-blind.txt"];
    names.map(|name| fs::read_to_string(support::fixtures().join(name)).unwrap()).concat()
}

pub(crate) fn mistakes(table: &str) -> Vec<Mistake<'_>> {
    let (mut file, mut found) = ("", Vec::new());
    for line in table.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        if let Some(name) = line.strip_prefix("== ") {
            file = name;
            continue;
        }
        let mut parts = line.split(" | ");
        let [rule, what, at, old] =
            [(); 4].map(|()| parts.next().unwrap_or_else(|| panic!("a part is missing: {line}")));
        // nothing is what a removed text leaves
        let [at, old, new] =
            [at, old, parts.next().unwrap_or_default()].map(|text| text.replace("\\n", "\n"));
        let rule = Some(rule).filter(|rule| *rule != "not found");
        found.push(Mistake { file, rule, what, at, old, new });
    }
    found
}

impl Mistake<'_> {
    pub(crate) fn plant(&self, text: &str) -> String {
        plant(text, self.what, &self.at, &self.old, &self.new)
    }
}

/// A text with `new` in the place of the first `old` behind `at`.
pub(crate) fn plant(text: &str, what: &str, at: &str, old: &str, new: &str) -> String {
    let start = text.find(at).unwrap_or_else(|| panic!("{what}: {at:?} is not there"));
    let found = text[start..].find(old).map(|found| start + found);
    let found = found.unwrap_or_else(|| panic!("{what}: {old:?} is not there"));
    format!("{}{new}{}", &text[..found], &text[found + old.len()..])
}

/// The rules with a finding in a file: a device, or a network with all its devices.
fn rules_of(path: &Path) -> BTreeSet<&'static str> {
    let is_network = path.extension().is_some_and(|ending| ending == "toml" || ending == "yml");
    let findings: Findings = if is_network {
        NetworkFile::open(path, &Default::default()).unwrap().check()
    } else {
        objdict::check_with(&open(path), &Options::default())
    };
    findings.iter().map(|finding| finding.rule.id).collect()
}

#[test]
fn nine_of_ten_planted_mistakes_are_found() {
    let table = table();
    let mistakes = mistakes(&table);
    assert!(mistakes.len() >= 240, "{} mistakes", mistakes.len());
    // files beside the fixtures that name each other as those do
    let folder = support::fixtures().join("../planted");
    let folders = ["bases", "eds", "dcf", "xdd", "xdc", "network"].into_iter();
    for path in
        folders.flat_map(|name| support::files(name, &["eds", "dcf", "xdd", "xdc", "toml", "yml", "bin"]))
    {
        let copy = folder.join(path.strip_prefix(support::fixtures()).unwrap());
        fs::create_dir_all(copy.parent().unwrap()).unwrap();
        fs::copy(path, copy).unwrap();
    }
    let mut wrong = Vec::new();
    for mistake in &mistakes {
        let path = folder.join(mistake.file);
        let text = fs::read_to_string(&path).unwrap();
        let healthy = rules_of(&path);
        let planted = mistake.plant(&text.replace("\r\n", "\n"));
        let planted = if text.contains("\r\n") { planted.replace('\n', "\r\n") } else { planted };
        fs::write(&path, planted).unwrap();
        let found: BTreeSet<_> = rules_of(&path).difference(&healthy).copied().collect();
        fs::write(&path, text).unwrap();
        let is_right = mistake.rule.map_or(found.is_empty(), |rule| found.contains(rule));
        if !is_right {
            wrong.push(format!("{}: {}: {:?} finds {found:?}", mistake.file, mistake.what, mistake.rule));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let found = mistakes.iter().filter(|mistake| mistake.rule.is_some()).count();
    assert!(found * 100 >= mistakes.len() * FOUND, "{found} of {} mistakes are found", mistakes.len());
}

//! Laws of findings at places, over generated edits: what CI, baselines and editors rely on to tell a new mistake from a
//! known one.

use std::collections::BTreeSet;
use std::env;
use std::path::{Path, PathBuf};

use objdict::baseline::Baseline;
use objdict::diagnostic::Findings;
use objdict::format::{self, Description, Format};
use objdict::report::{
    Fingerprint, Gitlab, Json, Report, Sarif, TextReport, by_place, fingerprints, grouped,
};
use objdict::source::{SourceFile, SourceOptions};
use serde_json::Value;

use crate::support;
use crate::support::skips::sample;

/// A key, and a value that is wrong in each entry that has the key.
const MISTAKES: [(&str, &str); 7] = [
    ("AccessType", "rq"),
    ("DataType", "0x00G7"),
    ("ObjectType", "0x5F"),
    ("PDOMapping", "7"),
    ("DefaultValue", "zz"),
    ("LowLimit", "1x"),
    ("SubNumber", "many"),
];

/// So many places of a mistake are tried in a file.
const PLACES: usize = 4;

fn files() -> Vec<PathBuf> {
    let mut files = support::files("eds", &["eds"]);
    files.extend(support::files("dcf", &["dcf"]));
    if let Some(corpus) = env::var_os("OBJDICT_CORPUS_DIR") {
        files.extend(support::files_below(Path::new(&corpus), &["eds", "dcf"]));
    }
    files
}

fn read(path: &Path, text: &str) -> Description {
    let format =
        if path.extension().is_some_and(|ending| ending == "dcf") { Format::Dcf } else { Format::Eds };
    format::read(SourceFile::from_text(path.display().to_string(), text), format)
}

fn checked(description: &Description) -> Findings {
    by_place(description, objdict::check(description))
}

fn prints(path: &Path, text: &str) -> BTreeSet<Fingerprint> {
    let description = read(path, text);
    fingerprints(&description, &checked(&description)).into_iter().collect()
}

/// The lines that state a key, some of them.
fn lines_of(text: &str, key: &str) -> Vec<usize> {
    let is_key = |line: &str| line.split_once('=').is_some_and(|(name, _)| name.trim() == key);
    let all: Vec<usize> =
        text.lines().enumerate().filter(|(_, line)| is_key(line)).map(|(at, _)| at).collect();
    let step = all.len().div_ceil(PLACES).max(1);
    all.into_iter().step_by(step).collect()
}

fn with_mistake(text: &str, at: usize, (key, value): (&str, &str)) -> String {
    let lines = text.lines().enumerate();
    lines
        .map(|(line, old)| if line == at { format!("{key}={value}\n") } else { format!("{old}\n") })
        .collect()
}

/// Each text of a file with mistakes at one place, at another one, and at both.
fn each_pair(mut take: impl FnMut(&Path, usize, [&str; 3])) {
    let mut tried = 0;
    for path in sample(files()) {
        let Ok(description) = format::open(&path, &SourceOptions::default()) else { continue };
        let text = description.source().text();
        let none = prints(&path, text);
        for mistake in MISTAKES {
            for pair in lines_of(text, mistake.0).windows(2) {
                let [first, second] =
                    [with_mistake(text, pair[0], mistake), with_mistake(text, pair[1], mistake)];
                // `zz` is a text
                if [&first, &second].iter().any(|text| prints(&path, text).is_subset(&none)) {
                    continue;
                }
                let both = with_mistake(&first, pair[1], mistake);
                take(&path, pair[1], [&first, &second, &both]);
                tried += 1;
            }
        }
    }
    assert!(tried > 20, "{tried}");
}

#[test]
fn a_new_mistake_of_a_known_kind_is_reported() {
    each_pair(|path, line, [first, _, both]| {
        let (known, new) = (read(path, first), read(path, both));
        let mut baseline = Baseline::default();
        baseline.add("a", &known, &checked(&known));
        let mut findings = checked(&new);
        baseline.suppress("a", &new, &mut findings, |_| false);
        let number = line + 1;
        assert!(!findings.is_empty(), "{}: nothing is reported of line {number}", path.display());
    });
}

#[test]
fn a_mistake_that_is_gone_takes_its_results_along() {
    each_pair(|path, line, [first, second, both]| {
        let [first, second, both] = [first, second, both].map(|text| prints(path, text));
        let gone: Vec<_> = both.difference(&first).collect();
        assert!(!gone.is_empty(), "{}:{}", path.display(), line + 1);
        let is_of_one = |print: &&Fingerprint| first.contains(*print) || second.contains(*print);
        let of_both: Vec<_> = both.iter().filter(|print| !is_of_one(print)).collect();
        assert!(of_both.is_empty(), "{}:{}: {of_both:?}", path.display(), line + 1);
    });
}

#[test]
fn lines_that_move_change_no_fingerprint() {
    for path in sample(files()) {
        let Ok(description) = format::open(&path, &SourceOptions::default()) else { continue };
        let text: String = description.source().text().lines().map(|line| format!("{line}\n")).collect();
        let moved = text.replace("\n[", "\n; moved\n; moved\n\n[");
        assert_eq!(prints(&path, &text), prints(&path, &moved), "{}", path.display());
    }
}

fn document(mut write: impl FnMut(&mut Vec<u8>)) -> String {
    let mut out = Vec::new();
    write(&mut out);
    String::from_utf8(out).unwrap()
}

fn written(report: &mut impl Report, description: &Description, findings: &Findings) {
    report.file(description.into(), findings).unwrap();
    report.finish().unwrap();
}

/// The number of places in the last line of a report for people: all findings, if none are joined.
fn places_of_text(text: &str, findings: usize) -> usize {
    let Some((_, rest)) = text.rsplit_once(" at ") else { return findings };
    rest.split(' ').next().and_then(|number| number.parse().ok()).unwrap_or(findings)
}

#[test]
fn every_form_counts_the_same_places() {
    for path in sample(files()) {
        let Ok(description) = format::open(&path, &SourceOptions::default()) else { continue };
        let findings = checked(&description);
        let count = findings.listed().count();
        let parsed = |text: &str| serde_json::from_str::<Value>(text).unwrap();
        let length = |value: &Value| value.as_array().unwrap().len();
        let json = document(|out| written(&mut Json::new(out), &description, &findings));
        assert_eq!(length(&parsed(&json)["findings"]), count, "{}", path.display());
        let sarif = document(|out| written(&mut Sarif::new(out), &description, &findings));
        assert_eq!(length(&parsed(&sarif)["runs"][0]["results"]), count, "{}", path.display());
        let gitlab = document(|out| written(&mut Gitlab::new(out), &description, &findings));
        let gitlab = parsed(&gitlab);
        assert_eq!(length(&gitlab), count, "{}", path.display());
        let distinct: BTreeSet<_> =
            gitlab.as_array().unwrap().iter().map(|issue| issue["fingerprint"].as_str()).collect();
        assert_eq!(distinct.len(), count, "{}", path.display());
        let mut baseline = Baseline::default();
        baseline.add("a", &description, &findings);
        assert_eq!(baseline.len(), findings.len(), "{}", path.display());
        let joined = grouped(&description, objdict::check(&description));
        let text = document(|out| written(&mut TextReport::new(out, false), &description, &joined));
        let summary = text.lines().rfind(|line| line.contains(" in 1 file")).unwrap();
        assert_eq!(places_of_text(summary, joined.len()), findings.len(), "{}: {summary}", path.display());
    }
}

//! What findings say: in the words of the syntax of their file, and never endless.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use objdict::format::{self, Format};
use objdict::lint;
use objdict::model::Field;
use objdict::source::SourceFile;
use objdict_model::diagnostic::{Diagnostic, MAX_QUOTED, Notion, WORDS};
use objdict_xdd::xdd::wording::words;

use crate::rules::{devices, open, options, rule_folders};

/// The bad fixtures of all rules that are descriptions.
fn bad_devices() -> impl Iterator<Item = PathBuf> {
    let all = rule_folders().into_iter().flat_map(|(_, folder)| devices(&folder, "bad"));
    all.filter(|path| path.extension().is_some_and(|ending| ending == "eds" || ending == "dcf"))
}

/// All sentences of a finding.
fn sentences(finding: &Diagnostic) -> Vec<String> {
    let labels = finding.labels.iter().map(|label| &label.text);
    let fix = finding.fix.iter().map(|fix| &fix.title);
    let all = labels.chain(fix).chain(&finding.help).chain([&finding.message]);
    all.map(ToString::to_string).collect()
}

#[test]
fn no_finding_about_the_model_speaks_of_an_eds_to_who_has_an_xdd() {
    let keys: Vec<&str> = Field::NAMED
        .iter()
        .map(|(name, _)| *name)
        .filter(|name| words(&Notion::Key(name)).is_some_and(|word| word != *name))
        .collect();
    assert!(keys.len() > 30);
    let names = Field::NAMED.iter().map(|(name, _)| name).chain(WORDS);
    let marks: Vec<String> = names.map(|name| format!("{{{name}")).chain(["{[".to_owned()]).collect();
    let mut leaks = BTreeSet::new();
    for path in bad_devices() {
        for finding in &lint::check(open(&path).device(), &options(&path)) {
            if finding.rule.group() == lint::PORTABILITY {
                continue;
            }
            for sentence in sentences(&finding.clone().in_words(words)) {
                let is_key = |key: &&&str| {
                    sentence.contains(&format!("`{key}`")) || sentence.contains(&format!("`{key}="))
                };
                let has_word =
                    [" section", "sections ", "the key", "a DCF"].iter().any(|word| sentence.contains(word));
                if has_word
                    || marks.iter().any(|mark| sentence.contains(mark))
                    || keys.iter().find(is_key).is_some()
                {
                    leaks.insert(format!("{}: {sentence}", finding.rule.id));
                }
            }
        }
    }
    assert!(leaks.is_empty(), "{leaks:#?}");
}

/// The longest sentence about a description.
fn longest(name: &Path, text: String) -> String {
    let source = SourceFile::from_text(name.display().to_string(), text);
    let format =
        if name.extension().is_some_and(|ending| ending == "dcf") { Format::Dcf } else { Format::Eds };
    let findings = objdict::check_with(&format::read(source, format), &options(name));
    let all = findings.iter().flat_map(sentences);
    all.max_by_key(String::len).unwrap_or_default()
}

#[test]
fn what_is_quoted_is_cut() {
    let long = |length: usize| "F".repeat(length);
    for path in bad_devices() {
        let description = open(&path);
        let text = description.source().text();
        let findings = objdict::check_with(&description, &options(&path));
        for finding in &findings {
            let spans = finding.labels.iter().map(|label| description.span_of(&label.at));
            for span in spans.filter(|span| !span.is_empty()) {
                let (before, behind) = (&text[..span.start as usize], &text[span.end as usize..]);
                let sentence = longest(&path, format!("{before}{}{}{behind}", span.of(text), long(20_000)));
                assert!(sentence.len() < 2_000, "{}: {} bytes: {sentence}", path.display(), sentence.len());
            }
        }
    }
}

#[test]
fn a_line_without_end_is_cut_too() {
    let text = "[1000]\nParameterName=Device type\nObjectType=";
    let line = format!("{text}{}\nDefaultValue=0x\nDataType=7\n", "7".repeat(1_000_000));
    let sentence = longest(Path::new("long.eds"), line);
    assert!(sentence.contains(&"7".repeat(MAX_QUOTED)) && sentence.contains('…'), "{sentence}");
    assert!(sentence.len() < 2_000);
}

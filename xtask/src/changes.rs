//! What `check --fix` and `fmt` make of a file: no new finding, and the same device.

use std::collections::BTreeMap;

use objdict::diagnostic::{Applicability, Findings};
use objdict::format::{self, Description};
use objdict::source::{SourceFile, SourceOptions};
use objdict::{check, fix};

/// What went wrong with the file when it was fixed and put in order.
pub(crate) fn problems(description: Description, findings: &Findings) -> Vec<String> {
    if description.source().is_read_only() {
        return Vec::new();
    }
    let mut problems = Vec::new();
    arranged(&description, &mut problems);
    fixed(description, &counts(findings), &mut problems);
    problems
}

fn arranged(description: &Description, problems: &mut Vec<String>) {
    let bytes = match description.arranged() {
        Ok(bytes) => bytes,
        Err(error) => return problems.push(error.to_string()),
    };
    let arranged = read(description, bytes.clone());
    if !matches!(arranged.arranged(), Ok(again) if again == bytes) {
        problems.push("put in order again, it changes again".to_owned());
    }
}

fn fixed(description: Description, before: &BTreeMap<&str, usize>, problems: &mut Vec<String>) {
    let fixed = fix(description, Applicability::Unsafe, check);
    let after = counts(&fixed.findings);
    for (rule, count) in &after {
        if Some(count) > before.get(rule) {
            problems.push(format!("{rule} finds more when the file is fixed"));
        }
    }
    for repair in &fixed.applied {
        if after.get(repair.rule) >= before.get(repair.rule) && before.contains_key(repair.rule) {
            problems.push(format!("{} is fixed and still there: {}", repair.rule, repair.message));
        }
    }
    let bytes = fixed.bytes();
    let again = read(&fixed.description, bytes);
    if again.device() != fixed.description.device() {
        problems.push("what is fixed is not read the same".to_owned());
    }
}

fn read(like: &Description, bytes: Vec<u8>) -> Description {
    let mut options = SourceOptions::default();
    options.encoding = Some(like.source().encoding());
    let name = like.source().name();
    match SourceFile::from_bytes(name, bytes, &options) {
        Ok(source) => format::read(source, like.format()),
        Err(_) => format::read(SourceFile::from_text(name, ""), like.format()),
    }
}

/// The findings of each rule, those that were only counted among them.
fn counts(findings: &Findings) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for finding in findings {
        *counts.entry(finding.rule.id).or_default() += 1;
    }
    for (rule, omitted) in findings.omitted() {
        *counts.entry(rule).or_default() += omitted as usize;
    }
    counts
}

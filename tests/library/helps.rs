//! What a help tells to write, written: the finding is gone. The helps are those of the fixtures of all rules.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use objdict::check_with;
use objdict::diagnostic::{Diagnostic, Findings};
use objdict::format::{self, Description, Format, Syntax};
use objdict::source::{SourceFile, SourceOptions};

use crate::fix::folders;
use crate::rules::{devices, options, rule_folders};

/// So many findings of a rule are tried in a file.
const PER_RULE: usize = 4;

const ENDINGS: [&str; 4] = ["eds", "dcf", "xdd", "xdc"];

/// The text that a help quotes first, where it begins with `write`.
fn quoted(help: &str) -> Option<&str> {
    help.strip_prefix("write `")?.split_once('`').map(|(quoted, _)| quoted)
}

/// The text with `quoted` at the place of a finding: a setting in its section or element, a value for the value. `None` if it is neither.
fn written(description: &Description, finding: &Diagnostic, quoted: &str) -> Option<String> {
    let text = description.source().text();
    let span = description.span_of(&finding.labels[0].at);
    let (low, high) = (span.start as usize, span.end as usize);
    let start = text[..low].rfind('\n').map_or(0, |at| at + 1);
    let range = match (description.format().syntax(), quoted.split_once('=')) {
        (Syntax::Ini, Some((key, value))) if !value.is_empty() => return Some(set(text, start, key, quoted)),
        (Syntax::Xml, Some((name, value))) if value.starts_with('"') => {
            let near = text[..high].rfind(&format!("{name}=\""))?;
            let value = near + name.len() + 2;
            near..value + text[value..].find('"')? + 1
        }
        // behind `=`
        (_, None) if text[start..low].contains('=') => low..high,
        _ => return None,
    };
    Some([&text[..range.start], quoted, &text[range.end..]].concat())
}

/// The text of an INI file with a setting in the section of the line at `start`.
fn set(text: &str, start: usize, key: &str, setting: &str) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let line = text[..start].matches('\n').count();
    let is_header = |line: &&str| line.trim_start().starts_with('[');
    let header = lines[..=line].iter().rposition(is_header).unwrap_or_default();
    let end = lines[header + 1..].iter().position(is_header).map_or(lines.len(), |at| header + 1 + at);
    let has_key =
        |line: &str| line.split_once('=').is_some_and(|(found, _)| found.trim().eq_ignore_ascii_case(key));
    let near = if has_key(lines[line]) { Some(line) } else { (header..end).find(|&at| has_key(lines[at])) };
    let (at, rest) = near.map_or((header + 1, header + 1), |at| (at, at + 1));
    [&lines[..at].concat(), setting, "\r\n", &lines[rest..].concat()].concat()
}

fn count(findings: &Findings, of: &Diagnostic) -> usize {
    findings.iter().filter(|finding| finding.rule.id == of.rule.id).count()
}

/// Rules whose help names another place than the finding, or a pattern.
const ELSEWHERE: [&str; 12] = [
    "cia301/mapped-object-not-mappable",
    "cia304/object-not-safe",
    "cia306/array-of-mixed-access",
    "cia306/array-of-mixed-types",
    "cia306/blank-before-equals",
    "cia306/command-without-flag",
    "cia306/duplicate-key",
    "cia306/missing-section",
    "cia306/module-numbering",
    "cia306/sub-of-var",
    "cia311/invalid-dummy",
    "portability/unclear-direction",
];

/// The findings of a description that stay when their help is followed.
fn stubborn(path: &Path, tried: &mut usize) -> Vec<String> {
    let Ok(description) = format::open(path, &SourceOptions::default()) else { return Vec::new() };
    let mut found = Vec::new();
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    let findings = check_with(&description, &options(path));
    for finding in &findings {
        let help = finding.help.as_ref().map(ToString::to_string).unwrap_or_default();
        let asked = quoted(&help).filter(|_| {
            !ELSEWHERE.contains(&finding.rule.id) && !help.contains(" at each ") && !help.contains('…')
        });
        let Some(text) = asked.and_then(|quoted| written(&description, finding, quoted)) else { continue };
        let seen = counts.entry(finding.rule.id).or_default();
        *seen += 1;
        if *seen > PER_RULE {
            continue;
        }
        let mut options_of_source = SourceOptions::default();
        options_of_source.encoding = Some(description.source().encoding());
        let name = description.source().name();
        let source = SourceFile::from_bytes(name, text.into_bytes(), &options_of_source).unwrap();
        let after = check_with(&format::read(source, description.format()), &options(path));
        *tried += 1;
        if count(&after, finding) >= count(&findings, finding) {
            found.push(format!("{}: {}: {} {help}", path.display(), finding.rule.id, finding.message));
        }
    }
    found
}

/// Over the fixtures of the rules and, with `OBJDICT_CORPUS_DIR`, the files below that folder.
#[test]
fn what_a_help_says_fixes_the_finding() {
    let mut paths: Vec<PathBuf> =
        rule_folders().into_iter().flat_map(|(_, folder)| devices(&folder, "bad")).collect();
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        folders(Path::new(&folder), &mut paths);
    }
    let is_description =
        |path: &PathBuf| path.extension().is_some_and(|ending| ENDINGS.iter().any(|known| ending == *known));
    let mut tried = 0;
    let found: Vec<String> = paths
        .iter()
        .filter(|path| is_description(path))
        .flat_map(|path| stubborn(path, &mut tried))
        .collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
    assert!(tried > 120, "{tried}");
}

/// The access and the data type of an entry may be those of its parameter.
#[test]
fn the_attribute_is_that_of_the_place() {
    let text = std::fs::read_to_string(crate::support::fixtures().join("xdd/all-types.xdd")).unwrap();
    let text = text
        .replace(r#"uniqueID="UID_OBJ_1014" access="readWrite""#, r#"uniqueID="UID_OBJ_1014" access="write""#)
        .replace(
            r#"name="COB-ID EMCY" objectType="7" dataType="0007" accessType="rw""#,
            r#"name="COB-ID EMCY" objectType="7" dataType="0007""#,
        );
    let (name, parameter) =
        (r#"heartbeat time" objectType="7" dataType="0006""#, "heartbeat time</label>\n            <UINT />");
    let text = text.replace("\r\n", "\n").replace(name, r#"heartbeat time" objectType="7""#);
    let text = text.replace(parameter, "heartbeat time</label>\n            <UDINT />");
    let description = format::read(SourceFile::from_text("all-types.xdd", &text), Format::Xdd);
    let findings = objdict::check(&description);
    let help = |rule: &str| {
        let finding = findings.iter().find(|finding| finding.rule.id == rule).unwrap();
        finding.help.as_ref().unwrap().to_string()
    };
    assert_eq!(help("cia301/wrong-access"), r#"write `access="readWrite"`"#);
    assert_eq!(help("cia301/wrong-data-type"), "write `<UINT />`");

    let text = std::fs::read_to_string(crate::support::fixtures().join("xdd/io-401.xdd")).unwrap();
    let text = text.replacen(r#"minValue value="0x00000000""#, r#"minValue value="0x00800000""#, 1);
    let findings = objdict::check(&format::read(SourceFile::from_text("io-401.xdd", &text), Format::Xdd));
    let finding = findings.iter().find(|finding| finding.rule.id == "cia306/low-limit-above-high").unwrap();
    assert_eq!(finding.message, "`minValue` is 8388608, but `maxValue` is 8388607");
}

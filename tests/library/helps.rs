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

/// What a help tells to do with a text of lines, as far as a program can follow it.
#[derive(Debug)]
enum Step {
    /// Writes settings into a section, or into that of the finding.
    Set(Option<String>, Vec<(String, String)>),
    /// Writes a value or an attribute at the finding.
    Value(String),
    /// Removes the keys of the finding's section, or its line.
    RemoveKeys(Vec<String>),
    RemoveSection,
    /// Adds a section with its settings.
    Add(String, Vec<(String, String)>),
}

/// What is in the backticks at the start of a text, listed with commas and `and`, and the rest.
fn quoted(text: &str) -> (Vec<&str>, &str) {
    let (mut items, mut rest) = (Vec::new(), text);
    while let Some((item, behind)) = rest.strip_prefix('`').and_then(|rest| rest.split_once('`')) {
        items.push(item);
        let next = [", ", " and "]
            .iter()
            .find_map(|word| behind.strip_prefix(word).filter(|rest| rest.starts_with('`')));
        match next {
            Some(next) => rest = next,
            None => return (items, behind),
        }
    }
    (items, rest)
}

fn settings(items: &[&str]) -> Option<Vec<(String, String)>> {
    let setting = |item: &&str| {
        let (key, value) = item.split_once('=').filter(|(_, value)| !value.is_empty())?;
        Some((key.to_owned(), value.to_owned()))
    };
    items.iter().map(setting).collect()
}

/// The steps of a help that begins with `write`, `remove` or `add`; `None` if it asks for what only the author knows.
fn steps(help: &str, message: &str, syntax: Syntax) -> Option<Vec<Step>> {
    let (verb, rest) = help.split_once(' ')?;
    let section =
        |name: &str| name.strip_prefix('[').and_then(|name| name.strip_suffix(']')).map(str::to_owned);
    let (items, behind) = quoted(rest);
    let of_author = [
        "…",
        " such as ",
        " as in ",
        " to both",
        " in both ",
        " for ",
        "` first",
        "` and the ",
        "the sections",
        "` followed by",
    ];
    let is_vague = of_author.iter().any(|word| help.contains(word));
    match verb {
        _ if is_vague => None,
        "write" | "add" if !items.is_empty() && section(items[0]).is_none() => {
            if syntax == Syntax::Xml || !items[0].contains('=') {
                return (verb == "write").then(|| vec![Step::Value(items[0].to_owned())]);
            }
            let settings = settings(&items)?;
            let Some(places) = behind.strip_prefix(" in ") else {
                let is_elsewhere =
                    behind.starts_with(" in") || behind.starts_with(" at") || behind.starts_with(" below");
                return (!is_elsewhere).then(|| vec![Step::Set(None, settings)]);
            };
            let sections: Option<Vec<String>> = quoted(places).0.iter().map(|name| section(name)).collect();
            let sections = sections.filter(|sections| !sections.is_empty())?;
            Some(sections.into_iter().map(|section| Step::Set(Some(section), settings.clone())).collect())
        }
        "add" if items.len() == 1 => {
            let (with, _) = quoted(behind.strip_prefix(" with ")?);
            Some(vec![Step::Add(section(items[0])?, settings(&with)?)])
        }
        "remove" if syntax == Syntax::Ini => {
            let lines = ["the line", "one of the two lines", "the second entry", "it from", "the comment"];
            match rest {
                _ if lines.iter().any(|start| rest.starts_with(start)) => {
                    Some(vec![Step::RemoveKeys(Vec::new())])
                }
                _ if rest.starts_with("the keys") => {
                    let quoted = message.split('`').skip(1).step_by(2);
                    Some(vec![Step::RemoveKeys(quoted.map(str::to_owned).collect())])
                }
                _ if rest.starts_with("the key") => Some(vec![Step::RemoveKeys(Vec::new())]),
                _ if rest.starts_with("the section") => Some(vec![Step::RemoveSection]),
                _ if !items.is_empty()
                    && items.iter().all(|item| item.chars().all(char::is_alphanumeric)) =>
                {
                    Some(vec![Step::RemoveKeys(items.into_iter().map(str::to_owned).collect())])
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// The lines of an INI file while steps change them, with what was changed.
struct Lines {
    lines: Vec<String>,
    /// The sections that a step changed, by their names.
    changed: Vec<String>,
}

impl Lines {
    fn is_header(line: &str) -> bool {
        line.trim_start().starts_with('[')
    }

    /// The header above a line, and the end of the section.
    fn around(&self, line: usize) -> (usize, usize) {
        let header = self.lines[..=line].iter().rposition(|line| Self::is_header(line)).unwrap_or_default();
        let next = self.lines[header + 1..].iter().position(|line| Self::is_header(line));
        (header, next.map_or(self.lines.len(), |at| header + 1 + at))
    }

    fn named(&self, name: &str) -> Option<usize> {
        let header = format!("[{name}]");
        self.lines.iter().position(|line| line.trim().eq_ignore_ascii_case(&header))
    }

    fn has_key(line: &str, key: &str) -> bool {
        line.split_once('=').is_some_and(|(found, _)| found.trim().eq_ignore_ascii_case(key))
    }

    /// Makes a step; `false` if its place is not there.
    fn step(&mut self, step: &Step, line: usize) -> bool {
        let end = if self.lines[line].ends_with("\r\n") { "\r\n" } else { "\n" };
        match step {
            Step::Set(section, settings) => {
                let Some(place) = section.as_ref().map_or(Some(line), |name| self.named(name)) else {
                    return false;
                };
                let (header, last) = self.around(place);
                self.changed.push(self.lines[header].trim().to_owned());
                for (key, value) in settings {
                    let here = Some(place).filter(|&at| Self::has_key(&self.lines[at], key));
                    let at = here.or_else(|| (header..last).find(|&at| Self::has_key(&self.lines[at], key)));
                    let text = format!("{key}={value}{end}");
                    match at {
                        Some(at) => self.lines[at] = text,
                        None => self.lines.insert(header + 1, text),
                    }
                }
            }
            Step::RemoveKeys(keys) => {
                let (header, last) = self.around(line);
                self.changed.push(self.lines[header].trim().to_owned());
                let is_key =
                    |at: usize, lines: &[String]| keys.iter().any(|key| Self::has_key(&lines[at], key));
                let gone: Vec<usize> = (header + 1..last).filter(|&at| is_key(at, &self.lines)).collect();
                let gone = if keys.is_empty() { vec![line] } else { gone };
                gone.iter().rev().for_each(|&at| drop(self.lines.remove(at)));
                return !gone.is_empty() && !Self::is_header(&self.lines[line.min(self.lines.len() - 1)])
                    || !keys.is_empty();
            }
            Step::RemoveSection => {
                let (header, last) = self.around(line);
                self.changed.push(self.lines[header].trim().to_owned());
                self.lines.drain(header..last);
            }
            Step::Add(section, settings) => {
                let lines = settings.iter().map(|(key, value)| format!("{key}={value}{end}"));
                self.lines.push(format!("{end}[{section}]{end}{}", lines.collect::<String>()));
                self.changed.push(format!("[{section}]"));
            }
            Step::Value(_) => return false,
        }
        true
    }
}

/// The text after the help of a finding, and the sections or the value that it changes; `None` if no program can follow it.
fn followed(description: &Description, finding: &Diagnostic, help: &str) -> Option<(String, Vec<String>)> {
    let text = description.source().text();
    let span = description.span_of(&finding.labels[0].at);
    let (low, high) = (span.start as usize, span.end as usize);
    let start = text[..low].rfind('\n').map_or(0, |at| at + 1);
    let syntax = description.format().syntax();
    let steps = steps(help, &finding.message.to_string(), syntax)?;
    if let [Step::Value(new)] = &steps[..] {
        let range = match (syntax, new.split_once('=')) {
            (Syntax::Xml, Some((name, value))) if value.starts_with('"') => {
                let near = text[..high].rfind(&format!("{name}=\""))?;
                let value = near + name.len() + 2;
                near..value + text[value..].find('"')? + 1
            }
            // behind `=`
            (_, None) if text[start..low].contains('=') => low..high,
            _ => return None,
        };
        let changed = text[..start].lines().rev().find(|line| Lines::is_header(line));
        let changed = changed.map(|header| header.trim().to_owned()).into_iter().collect();
        return Some(([&text[..range.start], new, &text[range.end..]].concat(), changed));
    }
    let lines = text.split_inclusive('\n').map(str::to_owned).collect();
    let mut lines = Lines { lines, changed: Vec::new() };
    let line = text[..start].matches('\n').count();
    let is_done = steps.iter().all(|step| lines.step(step, line));
    is_done.then(|| (lines.lines.concat(), lines.changed))
}

/// Findings by rule, message and section.
fn places(description: &Description, findings: &Findings) -> BTreeMap<(&'static str, String, String), usize> {
    let text = description.source().text();
    let mut places = BTreeMap::new();
    for finding in findings {
        let at = finding.labels.first().map_or(0, |label| description.span_of(&label.at).start as usize);
        let line = text[at..].find('\n').map_or(text.len(), |end| at + end);
        let section =
            text[..line].lines().rev().find(|line| Lines::is_header(line)).unwrap_or_default().trim();
        // a count of lines is another one when a section is gone
        let message = finding.message.to_string();
        let message = if finding.rule.id == "cia306/comment-style" { String::new() } else { message };
        *places.entry((finding.rule.id, message, section.to_owned())).or_default() += 1;
    }
    places
}

/// Helps of a rule: those that say to write, remove or add something, and those that a program followed.
type Tried = BTreeMap<&'static str, [usize; 2]>;

/// So many findings of a rule are followed one after the other.
const MOST_STEPS: usize = 40;

/// What a help leads to elsewhere, because other data depend on what it writes: the author has to go on there.
const FOLLOWS: [(&str, &str); 11] = [
    ("cia301/cob-id-not-predefined", "cia301/cob-id-collision"),
    ("cia301/fixed-node-id", "cia301/cob-id-collision"),
    ("cia301/granularity-against-access", "cia306/dummy-below-granularity"),
    ("cia306/missing-device-info-key", "cia306/dummy-below-granularity"),
    ("cia306/sub-0-type", "cia306/object-without-entries"),
    ("cia306/unsupported-key", "cia306/stray-compact-section"),
    ("cia401/channels-not-in-device-type", "cia401/missing-object"),
    ("cia401/wrong-access", "cia401/wrong-default-mapping"),
    ("cia401/wrong-mapping", "cia301/mapped-object-not-mappable"),
    ("cia402/wrong-object-type", "cia306/array-of-mixed-access"),
    ("/wrong-data-type", "cia301/wrong-mapping-length"),
];

/// New findings outside of the sections, or for added or removed ones the objects, that a help changes.
fn consequences(
    before: &BTreeMap<(&'static str, String, String), usize>,
    after: &BTreeMap<(&'static str, String, String), usize>,
    rule: &str,
    changed: &[String],
) -> Vec<String> {
    let object =
        |section: &str| section.split("sub").next().unwrap_or_default().trim_matches(['[', ']']).to_owned();
    let is_changed = |section: &String| {
        changed.contains(section)
            || changed.iter().any(|other| other.contains("sub") && object(other) == object(section))
    };
    let is_new = |((other, message, section), count): &(&(&'static str, String, String), &usize)| {
        let follows = FOLLOWS.iter().any(|(cause, effect)| rule.ends_with(cause) && other == effect);
        let known =
            before.iter().any(|((id, known, _), times)| id == other && known == message && times >= *count);
        !known && *other != rule && !follows && !is_changed(section)
    };
    let new = after.iter().filter(is_new);
    new.map(|((rule, message, section), _)| format!("causes {section} {rule}: {message}")).collect()
}

fn read_again(description: &Description, text: String) -> Description {
    let mut options = SourceOptions::default();
    options.encoding = Some(description.source().encoding());
    let bytes = description.source().encoding().encode(&text).unwrap_or_else(|_| text.into_bytes());
    let source = SourceFile::from_bytes(description.source().name(), bytes, &options).unwrap();
    format::read(source, description.format())
}

/// The findings of a description that stay when their help is followed, or cause others elsewhere.
fn stubborn(path: &Path, tried: &mut Tried) -> Vec<String> {
    let Ok(description) = format::open(path, &SourceOptions::default()) else { return Vec::new() };
    let mut found = Vec::new();
    let findings = check_with(&description, &options(path));
    let before = places(&description, &findings);
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for finding in &findings {
        let help = finding.help.as_ref().map(ToString::to_string).unwrap_or_default();
        let is_asked = ["write ", "remove ", "add "].iter().any(|verb| help.starts_with(verb));
        if !is_asked || finding.labels.is_empty() {
            continue;
        }
        let seen = counts.entry(finding.rule.id).or_default();
        *seen += 1;
        if *seen > PER_RULE {
            continue;
        }
        let tried = tried.entry(finding.rule.id).or_default();
        tried[0] += 1;
        let Some(first) = followed(&description, finding, &help) else { continue };
        tried[1] += 1;
        // the other elements of an ARRAY have the same finding, and its help is followed too
        let (mut text, mut changed) = first;
        let mut last = Vec::new();
        let count =
            |findings: &Findings| findings.iter().filter(|other| other.rule.id == finding.rule.id).count();
        let mut left = count(&findings);
        for _ in 0..MOST_STEPS {
            let read = read_again(&description, text);
            let findings_after = check_with(&read, &options(path));
            last = consequences(&before, &places(&read, &findings_after), finding.rule.id, &changed);
            let now = count(&findings_after);
            if now >= left {
                last.push("stays".to_owned());
            }
            left = now;
            let is_it = |other: &&Diagnostic| other.rule.id == finding.rule.id && !other.labels.is_empty();
            let next = findings_after.iter().filter(is_it).find_map(|other| {
                let help = other.help.as_ref()?.to_string();
                followed(&read, other, &help)
            });
            let Some((next, more)) = next.filter(|_| !last.is_empty() && now > 0) else { break };
            text = next;
            changed.extend(more);
        }
        let what = |what: String| {
            format!("{}: {}: {} | {help} | {what}", path.display(), finding.rule.id, finding.message)
        };
        found.extend(last.into_iter().map(what));
    }
    found
}

/// Over the fixtures of the rules and, with `OBJDICT_CORPUS_DIR`, the files below that folder: what the help says is done, the
/// finding is gone, and none is new but in the section that was changed.
#[test]
fn what_a_help_says_fixes_the_finding() {
    let mut paths: Vec<PathBuf> =
        rule_folders().into_iter().flat_map(|(_, folder)| devices(&folder, "bad")).collect();
    let is_description =
        |path: &PathBuf| path.extension().is_some_and(|ending| ENDINGS.iter().any(|known| ending == *known));
    let mut tried = Tried::new();
    let follow = |paths: &[PathBuf], tried: &mut Tried| -> Vec<String> {
        paths.iter().filter(|path| is_description(path)).flat_map(|path| stubborn(path, tried)).collect()
    };
    let mut found = follow(&paths, &mut tried);
    let shown = tried.iter().map(|(rule, [asked, followed])| format!("{rule}: {followed} of {asked}\n"));
    let shown: String = shown.collect();
    paths.clear();
    if let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") {
        folders(Path::new(&folder), &mut paths);
        found.extend(follow(&paths, &mut Tried::new()));
    }
    assert!(found.is_empty(), "{}:\n{}", found.len(), found.join("\n"));
    insta::assert_snapshot!("helps", shown);
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

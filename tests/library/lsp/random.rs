//! After each of many edits, the server has found what a check of the same text finds.

use std::path::Path;

use objdict::format::input::Reading;
use objdict::format::{Format, WriteOptions};
use objdict::report::{Location, by_place};
use objdict::source::SourceFile;
use serde_json::{Value, json};

use super::client::{Client, fixture};

/// In each of four syntaxes.
const EDITS: usize = 500;

/// An XDD that is as short as the EDS that it is made of: the time of a check is that of its text.
fn small_xdd() -> String {
    let small = SourceFile::from_text("a.eds", fixture("eds/minimal.eds"));
    let description = objdict::format::read(small, Format::Eds);
    let xdd = objdict::format::write(description.device(), Format::Xdd, &WriteOptions::default()).unwrap();
    String::from_utf8(xdd.bytes).unwrap()
}

const WORDS: [&str; 16] = [
    "=",
    "\r\n",
    "[1000]",
    "[1018sub1]",
    "0x",
    "$NODEID+",
    "<",
    ">",
    "\"",
    "]",
    "ro",
    "DataType=0x0007\n",
    "\u{1F600}",
    "; objdict: allow cia306\n",
    "1A00",
    "\u{e9}",
];

/// Numbers that are the same in each run.
pub(super) struct Numbers(u64);

/// Lines that change how others are read.
const LINES: [&str; 8] = [
    "; objdict-embed: /objects/0x1018/name=1",
    ";StorageLocation=RAM",
    ";CO_disabled=true",
    "[DeviceComissioning]",
    "[2000Value]",
    "<<<<<<< ours",
    "ObjectType=0x8",
    "[1018sub1]",
];

impl Numbers {
    pub(super) const fn new(start: u64) -> Self {
        Self(start)
    }

    /// The text with one of its lines, or all lines of a section, changed, removed, repeated or moved.
    pub(super) fn edit_of_lines(&mut self, text: &str) -> String {
        let mut lines: Vec<String> = text.split_inclusive('\n').map(str::to_owned).collect();
        let at = self.below(lines.len());
        let to = self.below(lines.len());
        let is_header = |line: &&String| line.starts_with('[');
        let section = |lines: &[String], at: usize| {
            let start = at - lines[..=at].iter().rev().position(|line| is_header(&line)).unwrap_or(at);
            let length = lines[at + 1..].iter().position(|line| is_header(&line));
            (start, length.map_or(lines.len(), |length| at + 1 + length))
        };
        match self.below(9) {
            _ if lines.is_empty() => lines.push("[1000]\r\n".to_owned()),
            0 => lines[at] = format!("{}\r\n", LINES[self.below(LINES.len())]),
            1 => lines.insert(at, format!("{}\n", LINES[self.below(LINES.len())])),
            2 => _ = lines.remove(at),
            3 => lines.insert(to, lines[at].clone()),
            4 => lines.swap(at, to),
            5 => lines[at] = lines[at].replace("\r\n", ["\n", "\r", ""][self.below(3)]),
            6 => {
                let (start, end) = section(&lines, at);
                let copied = lines[start..end].to_vec();
                let (to, _) = section(&lines, to);
                lines.splice(to..to, copied);
            }
            7 => _ = lines.drain(at.min(to)..at.max(to).min(at.min(to) + 12)),
            _ => {
                let value = WORDS[self.below(WORDS.len())];
                let key = lines[at].split('=').next().unwrap_or_default().trim_end().to_owned();
                lines[at] = format!("{key}={value}\r\n");
            }
        }
        lines.concat()
    }

    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % limit.max(1)
    }

    /// A place between two characters.
    fn place(&mut self, text: &str) -> usize {
        let at = self.below(text.len() + 1);
        (at..=text.len()).find(|&at| text.is_char_boundary(at)).unwrap()
    }

    pub(super) fn edit(&mut self, text: &str) -> String {
        let start = self.place(text);
        let end = match self.below(3) {
            0 => start,
            _ => {
                let length = self.below(20);
                (start + length..=text.len()).find(|&at| text.is_char_boundary(at)).unwrap_or(text.len())
            }
        };
        let new = if self.below(2) == 0 { "" } else { WORDS[self.below(WORDS.len())] };
        format!("{}{new}{}", &text[..start], &text[end..])
    }
}

/// What a check finds: where, by which rule, how severe and what.
fn checked(path: &Path, text: &str) -> Option<Vec<Value>> {
    let name = path.display().to_string();
    let (kind, source) = Reading::default().recognised(&name, text.as_bytes().to_vec()).ok()?;
    let description = objdict::format::read(source, kind.format()?);
    let findings = by_place(&description, objdict::check(&description));
    let found = findings.listed().map(|finding| {
        let at = Location::start_of((&description).into(), finding);
        let message = finding.message.shown().into_owned();
        json!([at.line - 1, finding.rule.id, finding.severity as u8, message])
    });
    Some(found.collect())
}

fn published(found: &Value) -> Vec<Value> {
    let found = found.as_array().unwrap().iter().map(|found| {
        let message = found["message"].as_str().unwrap();
        let message = message.rsplit_once("\nhelp: ").map_or(message, |(message, _)| message);
        let severity = 3 - found["severity"].as_u64().unwrap();
        json!([found["range"]["start"]["line"], found["code"], severity, message])
    });
    found.collect()
}

/// Edits a text of a syntax, from its start anew after each fifty edits.
fn findings_are_those_of_a_check(ending: &str, original: &str) {
    let mut client = Client::start();
    let mut numbers = Numbers(35);
    let name = format!("a.{ending}");
    client.open(&name, original);
    let mut text = original.to_owned();
    for edit in 0..EDITS {
        if edit % 50 == 0 {
            text = original.to_owned();
        }
        text = if edit % 2 == 0 { numbers.edit(&text) } else { numbers.edit_of_lines(&text) };
        let found = client.change(&name, &text);
        if let Some(expected) = checked(&client.path(&name), &text) {
            assert_eq!(published(&found), expected, "{name}, edit {edit}:\n{text}");
        }
    }
}

#[test]
fn of_an_eds() {
    findings_are_those_of_a_check("eds", &fixture("eds/minimal.eds"));
}

#[test]
fn of_a_dcf() {
    findings_are_those_of_a_check("dcf", include_str!("../../support/small.dcf"));
}

#[test]
fn of_an_xdd() {
    findings_are_those_of_a_check("xdd", &small_xdd());
}

#[test]
fn of_a_device_toml() {
    findings_are_those_of_a_check("toml", &fixture("toml/io.toml"));
}

/// Edits of each file below the folder `OBJDICT_CORPUS_DIR`, which are files of vendors.
const EDITS_OF_A_FILE: usize = 5;

/// Files that a debug build checks in a moment.
const SMALL: usize = 60_000;

#[test]
fn of_the_files_of_vendors() {
    let Some(corpus) = std::env::var_os("OBJDICT_CORPUS_DIR") else {
        crate::support::skips::skip("`OBJDICT_CORPUS_DIR` names no folder");
        return;
    };
    let mut client = Client::start();
    let mut numbers = Numbers(36);
    let mut edits = 0;
    for path in crate::support::files_below(Path::new(&corpus), &["eds", "dcf", "xdd", "xdc"]) {
        let Ok(mut text) = std::fs::read_to_string(&path) else { continue };
        if text.len() > SMALL {
            continue;
        }
        let name = format!("a.{}", path.extension().unwrap().to_string_lossy().to_lowercase());
        client.open(&name, &text);
        for _ in 0..EDITS_OF_A_FILE {
            text = numbers.edit(&text);
            let found = client.change(&name, &text);
            if let Some(expected) = checked(&client.path(&name), &text) {
                assert_eq!(published(&found), expected, "{}:\n{text}", path.display());
                edits += 1;
            }
        }
        client.note("textDocument/didClose", json!({ "textDocument": client.document(&name) }));
        client.findings(&name);
    }
    assert!(edits > 0, "no descriptions below `OBJDICT_CORPUS_DIR`");
}

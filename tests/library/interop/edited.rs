//! The reader of a source and its JSON Schema agree: what the schema rejects has a finding of the reader, and what has an error
//! of the reader is rejected, but for rules that no schema can say. The documents are one of each format with each of its keys
//! removed and misspelled, and with each key of its schema, also one that it lacks, as each kind of value.

use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Stdio};

use objdict::diagnostic::{Diagnostic, Findings, Severity};
use objdict::format::network::{NetworkFile, schema};
use objdict::format::patch::{self, Patch};
use objdict::format::{self, Format};
use objdict::source::SourceFile;
use serde_json::{Map, Value, json};

use super::environment;
use crate::network::path;
use crate::support;

/// Errors of readers that no schema can say: the rule, a part of the message, and the reason.
const UNSAYABLE: [(&str, &str, &str); 17] = [
    ("patch/invalid-change", "unknown field", "the keys of CiA 306 may have any case"),
    ("patch/invalid-change", "is not JSON", "a pattern has no nested brackets"),
    (
        "keys/out-of-range",
        ", but must be ",
        "a pattern does not compare numbers: the range or the unit of a time",
    ),
    ("keys/wrong-type", "`70000s`, neither a factor nor a time", "a pattern does not compare numbers"),
    ("keys/missing-key", "has no key `file`", "the type that a node uses may have it"),
    ("keys/missing-key", "`sync` needs a manager", "the manager may be a node"),
    ("keys/wrong-type", "cannot be mapped", "the entries of the device decide"),
    ("keys/wrong-type", "cannot be removed", "the objects of the profile decide"),
    ("keys/wrong-type", "which is not a value of", "the data type of the entry decides"),
    ("keys/wrong-type", "` has no `", "the number and the type of the elements decide"),
    ("keys/wrong-type", " values for ", "the number of elements decides"),
    ("keys/wrong-type", "is not a value that a missing key implies", "the part decides"),
    ("keys/wrong-type", "must be a list of these", "the profile decides"),
    ("keys/wrong-type", "the location of", "the folder of the file decides"),
    ("keys/wrong-type", "the JSON of a device has no such value", "the device decides"),
    ("keys/wrong-type", "is not valid: ", "the number of days of a month"),
    ("keys/unknown-profile", "", "the profiles that objdict has decide, and their features"),
];

/// Texts in the notations of keys, right and wrong.
const NOTATIONS: [&str; 34] = [
    "10ms",
    "1.5 s",
    "70000s",
    "1.5x",
    "0x",
    " 2e1 x",
    "sync/240",
    "SYNC/241",
    "Event",
    "0x1F",
    "256",
    "6000:1-5",
    "0x6041 sub 1",
    "60410",
    "servo.6041",
    "servo.70000",
    "servo.Statusword",
    ".6041",
    "u16",
    "[u8; 2]",
    "[u8; 255]",
    "string(4)",
    "0x0007",
    "2000-2001 2000",
    "only u8 !bool",
    "$NODEID+0x180",
    "0x180 + $nodeid",
    "off",
    "2026-05-30",
    "2026-13-30",
    "14:40",
    "24:00",
    "4-7",
    "64",
];

/// What else a value may be.
fn others() -> Vec<Value> {
    let numbers = [json!(-1), json!(0), json!(1), json!(1.5), json!(70_000), json!(4_294_967_296_u64)];
    let texts = [json!(""), json!("xq"), json!("5")];
    let lists = [json!([]), json!(["xq"]), json!([1, true]), json!([{}])];
    let maps =
        [json!({}), json!({ "xq": 1 }), json!({ "1": {} }), json!({ "999": 1 }), json!({ "2000": [1] })];
    std::iter::once(json!(true)).chain(numbers).chain(texts).chain(lists).chain(maps).collect()
}

/// The schema of what a key of a map has.
fn below<'s>(schema: &'s Value, key: &str) -> Option<&'s Value> {
    let known = schema["properties"].get(key);
    let pattern = schema["patternProperties"].as_object().and_then(|patterns| patterns.values().next());
    known.or(pattern).or_else(|| schema.get("additionalProperties").filter(|schema| schema.is_object()))
}

/// A name for each thing that a schema allows in a map.
fn names(schema: &Value) -> Vec<String> {
    let known = schema["properties"].as_object().into_iter().flat_map(Map::keys).cloned();
    let pattern = schema["patternProperties"].as_object().and_then(|patterns| patterns.keys().next());
    let numbered = pattern.map(|pattern| match pattern {
        hex if hex.contains("{4}") => "2100".to_owned(),
        _ if pattern == "^/" => "/device/kind".to_owned(),
        _ => "7".to_owned(),
    });
    let free = schema["additionalProperties"].is_object().then(|| "free".to_owned());
    known.chain(numbered).chain(free).collect()
}

/// A document with an edit, and the edit in words.
struct Edited {
    document: Value,
    edit: String,
}

/// Calls `keep` with each edit of a value and what it is called. Keys that are missing are added in so many tables below each other.
fn edits(value: &Value, schema: &Value, depth: usize, keep: &mut dyn FnMut(Value, String)) {
    let of_schema = schema.to_string();
    let is_spelled = of_schema.contains("\"pattern\"") && !of_schema.contains("\"properties\"");
    let notations = NOTATIONS.iter().filter(|_| is_spelled);
    let notations = notations.flat_map(|text| [json!(text), json!({ *text: "xq" })]);
    for other in others().into_iter().chain(notations).filter(|other| other != value) {
        let edit = format!(" = {other}");
        keep(other, edit);
    }
    match value {
        Value::Object(fields) => {
            let with = |name: &str, field: Option<Value>| {
                let mut fields = fields.clone();
                fields.remove(name);
                fields.extend(field.map(|field| (name.to_owned(), field)));
                Value::Object(fields)
            };
            for (name, field) in fields {
                keep(with(name, None), format!("/{name} removed"));
                let Value::Object(mut renamed) = with(name, None) else { continue };
                renamed.insert(format!("{name}xq"), field.clone());
                keep(Value::Object(renamed), format!("/{name} misspelled"));
            }
            for name in fields.keys().chain(&names(schema)) {
                let of_field = below(schema, name).unwrap_or(&Value::Null);
                let (field, depth) = match fields.get(name) {
                    Some(field) => (field.clone(), depth),
                    None if depth == 0 => continue,
                    None => (if of_field["type"] == "array" { json!([{}]) } else { json!({}) }, depth - 1),
                };
                edits(&field, of_field, depth, &mut |field, edit| {
                    keep(with(name, Some(field)), format!("/{name}{edit}"));
                });
            }
        }
        Value::Array(items) => {
            for (at, item) in items.iter().enumerate() {
                edits(item, &schema["items"], depth, &mut |item, edit| {
                    let mut items = items.clone();
                    items[at] = item;
                    keep(Value::Array(items), format!("/{at}{edit}"));
                });
            }
        }
        _ => {}
    }
}

/// A value of TOML or, with `: ` between key and value, of YAML.
fn inline(value: &Value, between: &str) -> String {
    match value {
        Value::Object(fields) => {
            let items: Vec<String> = fields.iter().map(|(key, value)| pair(key, value, between)).collect();
            format!("{{{}}}", items.join(", "))
        }
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(|item| inline(item, between)).collect();
            format!("[{}]", items.join(", "))
        }
        value => value.to_string(),
    }
}

fn pair(key: &str, value: &Value, between: &str) -> String {
    let is_number = !key.is_empty() && key.bytes().all(|byte| byte.is_ascii_digit());
    let key = if is_number { key.to_owned() } else { json!(key).to_string() };
    format!("{key}{between}{}", inline(value, between))
}

fn toml_of(document: &Value) -> String {
    let fields = document.as_object().into_iter().flatten();
    fields.map(|(key, value)| pair(key, value, " = ") + "\n").collect()
}

fn network_toml(document: &Value) -> Findings {
    let source = SourceFile::from_text("network.toml", toml_of(document));
    NetworkFile::read(source, &path(""), &Default::default()).check()
}

fn bus_yml(document: &Value) -> Findings {
    let source = SourceFile::from_text("bus.yml", inline(document, ": "));
    NetworkFile::read(source, &path(""), &Default::default()).check()
}

fn device_toml(document: &Value) -> Findings {
    let description = format::read(SourceFile::from_text("device.toml", toml_of(document)), Format::Toml);
    let mut findings = description.findings().clone();
    for variant in (1..).map_while(|number| description.sibling(number)) {
        findings.append(variant.findings().clone());
    }
    findings
}

fn patch_toml(document: &Value) -> Findings {
    Patch::read(SourceFile::from_text("a.patch.toml", toml_of(document))).findings().clone()
}

/// The numbers of the documents that a schema rejects, each with the reason.
fn rejected(schema: &Value, documents: &[Edited], programs: &Path) -> BTreeMap<usize, String> {
    let script = "import json, sys, jsonschema_rs\n\
        schema = jsonschema_rs.Draft202012Validator(json.loads(sys.stdin.readline()))\n\
        for number, line in enumerate(sys.stdin):\n \
        for error in schema.iter_errors(json.loads(line)):\n  \
        print(number, error.message.replace(chr(10), ' ')[:300]); break";
    let mut python = Command::new(programs.join("python"))
        .args(["-c", script])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = python.stdin.take().unwrap();
    let values = std::iter::once(schema).chain(documents.iter().map(|edited| &edited.document));
    let lines: String = values.map(|value| format!("{value}\n")).collect();
    let writer = std::thread::spawn(move || input.write_all(lines.as_bytes()).unwrap());
    let output = python.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(output.status.success());
    let lines = String::from_utf8(output.stdout).unwrap();
    lines
        .lines()
        .filter_map(|line| line.split_once(' '))
        .map(|(number, reason)| (number.parse().unwrap(), reason.to_owned()))
        .collect()
}

/// The rule and the message of the first finding of a reader that is as severe, but for errors that no schema can say.
fn first(findings: &Findings, least: Severity) -> Option<String> {
    let is_unsayable = |finding: &Diagnostic, message: &str| {
        let is = |(rule, part, _): &(&str, &str, &str)| finding.rule.id == *rule && message.contains(part);
        least == Severity::Error && UNSAYABLE.iter().any(is)
    };
    findings.iter().find_map(|finding| {
        // the others are about the devices and the network that were read
        let is_of_reader = matches!(finding.rule.group(), "keys" | "patch") && finding.severity >= least;
        let message = finding.message.to_string();
        (is_of_reader && !is_unsayable(finding, &message)).then(|| format!("{}: {message}", finding.rule.id))
    })
}

fn agree(schema: &Value, base: &Value, depth: usize, read: fn(&Value) -> Findings) {
    let Some(programs) = environment() else { return };
    assert_eq!(first(&read(base), Severity::Warning), None, "{base}");
    let mut documents = Vec::new();
    edits(base, schema, depth, &mut |document, edit| documents.push(Edited { document, edit }));
    documents.retain(|edited| edited.document.is_object());
    let documents = support::skips::sample(documents);
    let rejected = rejected(schema, &documents, programs);
    assert!(rejected.len() > documents.len() / 4, "{} of {}", rejected.len(), documents.len());
    let mut differences = Vec::new();
    for (number, Edited { document, edit }) in documents.iter().enumerate() {
        let findings = read(document);
        match (rejected.get(&number), first(&findings, Severity::Error)) {
            (Some(reason), _) if first(&findings, Severity::Warning).is_none() => {
                differences.push(format!("{edit} is read, and rejected: {reason}"));
            }
            (None, Some(message)) => differences.push(format!("{edit} is valid, but {message}")),
            _ => {}
        }
    }
    differences.sort_by_key(String::len);
    let count = differences.len();
    assert_eq!(
        count,
        0,
        "of {}, the shortest:\n{}",
        documents.len(),
        differences[..count.min(20)].join("\n")
    );
}

#[test]
fn network_toml_agrees_with_its_schema() {
    let base = json!({
        "bus": { "manager": "plc", "sync": "10ms" },
        "manager": { "id": 1 },
        "type": { "drive": { "file": "servo.eds", "watch": "2x" } },
        "node": { "servo": { "use": "drive", "id": 11, "set": { "1017": 100 } } },
        "link": [{ "from": "servo.6041", "to": "plc" }],
    });
    agree(&schema::network_toml(), &base, 2, network_toml);
}

#[test]
fn bus_yml_agrees_with_its_schema() {
    let base = json!({
        "options": { "dcf_path": "" },
        "master": { "node_id": 1, "baudrate": 500, "error_behavior": { "1": 1 } },
        "drive": {
            "dcf": "servo.eds",
            "node_id": 11,
            "rpdo": { "1": { "cob_id": "auto", "mapping": [{ "index": 0x6040 }] } },
            "sdo": [{ "index": 0x6060, "value": -3 }],
        },
    });
    agree(&schema::bus_yml(), &base, 2, bus_yml);
}

#[test]
fn patches_agree_with_their_schema() {
    let base = json!({
        "format": "objdict-patch/1",
        "change": [{ "at": "6401:1", "expect": { "type": "i16" }, "set": { "type": "u16" } }, { "at": "6402", "add": {} }],
        "raw": [{ "path": "/kind", "set": "1" }],
    });
    agree(&patch::schema::patch(), &base, 1, patch_toml);
}

#[test]
fn device_toml_agrees_with_its_schema() {
    let base = json!({
        "format": "objdict-device/1",
        "features": { "rpdos": 1 },
        "file": { "file-name": "lamp.eds" },
        "device": { "product-name": "Lamp", "bit-rates": [125, "auto"] },
        "node": { "node-id": 5 },
        "defaults": { "access": "rw", "sub0": { "access": "const" } },
        "lists": { "optional": "1017" },
        "rpdo": { "1": { "map": ["2000"], "event-timer": "1s" } },
        "object": {
            "2000": { "name": "Brightness", "type": "u8", "default": 5, "enum": { "0": "off" } },
            "2001": { "name": "Lamps", "type": "[u8; 2]", "names": ["left", "right"] },
            "2002": { "name": "Times", "sub": { "1": { "name": "On", "type": "u16" } } },
        },
        "variant": { "dark": { "object": { "2000": { "default": 0 } } } },
    });
    agree(&format::device_schema(), &base, 1, device_toml);
}

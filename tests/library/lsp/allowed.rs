//! What the server offers to write is what the documents allow: no section, sub-index or value that is accepted is reported.

use std::collections::BTreeMap;

use objdict::format::{self, Format};
use objdict::source::SourceFile;
use serde_json::{Value, json};

use super::client::{Client, edited, fixture, position};

/// What an object or a value asks of others: the author has to go on there.
const OF_OTHERS: [&str; 37] = [
    "cia301/emergency-disabled",
    "cia301/incomplete-eds-storage",
    "cia301/incomplete-node-guarding",
    "cia301/rtr-only-pdo",
    "cia301/storage-without-function",
    "cia301/store-without-restore",
    "cia301/sync-object-without-sync",
    "cia301/sync-producer-without-period",
    "cia301/synchronous-pdo-without-sync",
    "cia301/timer-without-effect",
    "cia301/valid-pdo-without-mapping",
    "cia302/missing-object",
    "cia401/channels-not-in-device-type",
    "cia401/different-channel-count",
    "cia401/error-mode-without-value",
    "cia401/missing-object",
    "cia401/wrong-default-mapping",
    "cia401/wrong-transmission-type",
    "cia402/device-type-without-drive",
    "cia402/homing-method-not-supported",
    "cia402/incomplete-touch-probe",
    "cia402/interpolation-without-data",
    "cia402/missing-object",
    "cia402/mode-not-stated",
    "cia402/mode-outside-limits",
    "cia402/notation-without-dimension",
    "cia402/target-without-actual-value",
    "cia402/time-without-window",
    "cia402/value-beyond-support",
    "cia406/contradictory-copy",
    "cia406/cyclic-timer-mismatch",
    "cia406/different-measuring-range",
    "cia406/misplaced-object",
    "cia406/missing-object",
    "cia406/revolutions-of-single-turn",
    "cia406/wrong-transmission-type",
    "naming/duplicate-object-name",
];

/// The places whose values are in the snapshot.
const SHOWN: [&str; 9] =
    ["[1005]", "[1014]", "[1401sub1]", "[1802sub1]", "[1802sub2]", "[605A]", "[6060]", "[6098]", "[6502]"];

/// A mistake of the fixture may be gone, none is new.
fn counts(name: &str, text: &str) -> BTreeMap<String, usize> {
    let format = if name.ends_with("dcf") { Format::Dcf } else { Format::Eds };
    let description = format::read(SourceFile::from_text(name, text), format);
    let mut counts = BTreeMap::new();
    for finding in objdict::check(&description).iter().filter(|finding| !OF_OTHERS.contains(&finding.rule.id))
    {
        *counts.entry(format!("{}: {}", finding.rule.id, finding.message)).or_default() += 1;
    }
    counts
}

fn new_findings(name: &str, before: &BTreeMap<String, usize>, text: &str) -> Vec<String> {
    let after = counts(name, text).into_iter();
    after
        .filter(|(found, count)| before.get(found).is_none_or(|known| known < count))
        .map(|(found, _)| found)
        .collect()
}

/// Devices with sub-indexes of every kind.
const DEVICES: [&str; 5] =
    ["drive-402.eds", "io-401.eds", "encoder-406.eds", "compact.eds", "manager-302.eds"];

fn devices() -> impl Iterator<Item = (&'static str, String)> {
    DEVICES.into_iter().map(|name| (name, fixture(&format!("eds/{name}")).replace('\r', "")))
}

#[test]
fn sections_are_whole_and_allowed() {
    let mut client = Client::start();
    let mut wrong = Vec::new();
    let mut tried = 0;
    for (name, text) in devices() {
        let before = counts(name, &text);
        let text = format!("{text}\n[");
        client.open(name, &text);
        let params =
            json!({ "textDocument": client.document(name), "position": position(&text, text.len()) });
        let items = client.ask("textDocument/completion", params);
        for item in items.as_array().unwrap() {
            let item = client.ask("completionItem/resolve", item.clone());
            let mut edits = item["additionalTextEdits"].as_array().cloned().unwrap_or_default();
            edits.push(item["textEdit"].clone());
            tried += 1;
            let found = new_findings(name, &before, &edited(&text, &Value::Array(edits)));
            wrong.extend(found.into_iter().map(|found| format!("{name}: {}: {found}", item["label"])));
        }
    }
    assert!(wrong.is_empty(), "{} of {tried}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(tried > 300, "{tried}");
}

#[test]
fn an_added_sub_index_is_allowed() {
    let mut client = Client::start();
    let mut wrong = Vec::new();
    let mut tried = 0;
    for (name, text) in devices() {
        let before = counts(name, &text);
        client.open(name, &text);
        for (start, header) in text.match_indices("\n[") {
            let start = position(&text, start + header.len());
            let params = json!({
                "textDocument": client.document(name),
                "range": { "start": start, "end": start },
                "context": { "diagnostics": [], "only": ["refactor"] },
            });
            for action in client.ask("textDocument/codeAction", params).as_array().unwrap() {
                let title = action["title"].as_str().unwrap();
                if title.starts_with("add sub-index") {
                    tried += 1;
                    let after = edited(&text, &action["edit"]["changes"][client.uri(name)]);
                    let found = new_findings(name, &before, &after);
                    wrong.extend(found.into_iter().map(|found| format!("{name}: {title}: {found}")));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {tried}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(tried > 50, "{tried}");
}

#[test]
fn values_have_their_meanings_and_are_allowed() {
    let mut client = Client::start();
    let mut wrong = Vec::new();
    let mut shown = String::new();
    let mut tried = 0;
    for (name, text) in devices() {
        let before = counts(name, &text);
        client.open(name, &text);
        for (at, key) in text.match_indices("\nDefaultValue=") {
            let at = at + key.len();
            let params = json!({ "textDocument": client.document(name), "position": position(&text, at) });
            let header = &text[text[..at].rfind("\n[").unwrap() + 1..];
            let header = header.lines().next().unwrap();
            if ["[16", "[1A"].iter().any(|mapping| header.starts_with(mapping)) {
                continue;
            }
            for item in client.ask("textDocument/completion", params).as_array().unwrap() {
                let label = item["label"].as_str().unwrap();
                tried += 1;
                if name == DEVICES[0] && SHOWN.contains(&header) {
                    shown += &format!("{header} {label}\n");
                }
                let after = edited(&text, &json!([item["textEdit"]]));
                let found = new_findings(name, &before, &after);
                wrong.extend(found.into_iter().map(|found| format!("{name}: {header} {label}: {found}")));
            }
        }
    }
    insta::assert_snapshot!("documented_values", shown);
    assert!(wrong.is_empty(), "{} of {tried}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(tried > 200, "{tried}");
}

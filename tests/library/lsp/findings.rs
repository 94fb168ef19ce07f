//! Findings as the user types.

use lsp_server::{Connection, Message, Notification, Request, RequestId};
use serde_json::{Value, json};

use super::client::{Client, fixture, position_of};

fn codes(found: &Value) -> Vec<&str> {
    found.as_array().unwrap().iter().filter_map(|found| found["code"].as_str()).collect()
}

#[test]
fn a_finding_has_its_rule_its_page_and_its_help() {
    let mut client = Client::start();
    let text = fixture("eds/minimal.eds").replace("minimal.eds", "a.eds");
    assert_eq!(client.open("a.eds", &text), json!([]));
    let text = text.replacen("DataType=0x0007", "DataType=0x00FF", 1);
    let found = client.change("a.eds", &text);
    insta::assert_json_snapshot!(client.plain(&found));
    client.note("textDocument/didClose", json!({ "textDocument": client.document("a.eds") }));
    assert_eq!(client.findings("a.eds"), json!([]));
}

#[test]
fn columns_are_those_of_the_client() {
    let text = fixture("eds/minimal.eds").replace("minimal.eds", "a.eds");
    let text = text.replace("DefaultValue=0x00000000", "DefaultValue=\u{1F600}\u{1F600}x").replace('\r', "");
    let start = |client: &mut Client| {
        let found = client.open("a.eds", &text);
        let of = found.as_array().unwrap().iter().find(|found| found["code"] == "cia306/invalid-value");
        of.unwrap()["range"].clone()
    };
    let utf16 = start(&mut Client::start());
    let mut client = Client::start_with(&json!({ "general": { "positionEncodings": ["utf-8", "utf-16"] } }));
    assert_eq!(client.offered["capabilities"]["positionEncoding"], "utf-8");
    let utf8 = start(&mut client);
    assert_eq!(utf16["start"], position_of(&text, "\u{1F600}"));
    assert_eq!(utf16["start"], utf8["start"]);
    let length = |range: &Value| {
        range["end"]["character"].as_u64().unwrap() - range["start"]["character"].as_u64().unwrap()
    };
    assert_eq!((length(&utf16), length(&utf8)), (5, 9));
}

#[test]
fn what_another_buffer_says_counts() {
    let mut client = Client::start();
    let island = fixture("network/island.eds");
    client.write("island.eds", &island);
    let network = "[node.a]\nfile = \"island.eds\"\nid = 2\n\n[node.a.set]\n\"1017\" = 500\n";
    let before = client.open("network.toml", network);
    client.open("island.eds", &island);
    assert_eq!(client.findings("network.toml"), before);
    // the entry is gone in the buffer alone
    let without = island.replace("[1017]", "[2FFF]");
    client.send_change("island.eds", &without);
    let found = client.findings("network.toml");
    assert!(codes(&found).len() > codes(&before).len(), "{found}");
    client.send_change("island.eds", &island);
    assert_eq!(client.findings("network.toml"), before);
}

#[test]
fn a_configuration_counts_as_it_is_typed() {
    let mut client = Client::start();
    let text = fixture("eds/minimal.eds");
    assert_eq!(codes(&client.open("a.eds", &text)), ["cia306/file-name"]);
    client.write("objdict.toml", "");
    let found =
        client.open("objdict.toml", "[rules]\n\"cia306/file-name\" = \"off\"\n\"cia306/x\" = \"off\"\n");
    assert!(!codes(&found).is_empty());
    client.send_change("objdict.toml", "[rules]\n\"cia306/file-name\" = \"off\"\n");
    assert_eq!(client.findings("a.eds"), json!([]));
    assert_eq!(client.findings("objdict.toml"), json!([]));
}

#[test]
fn a_cancelled_request_is_answered_with_an_error() {
    // all is in the queue before the server looks into it
    let (client, other) = Connection::memory();
    let request = |id: i32, method: &str, params: Value| {
        client.sender.send(Request::new(id.into(), method.to_owned(), params).into()).unwrap();
    };
    let note = |method: &str, params: Value| {
        client.sender.send(Notification::new(method.to_owned(), params).into()).unwrap();
    };
    let document = json!({ "uri": "file:///nowhere/a.eds" });
    let text = fixture("eds/minimal.eds");
    request(1, "initialize", json!({ "capabilities": {} }));
    note("initialized", json!({}));
    let opened = json!({ "uri": document["uri"], "languageId": "eds", "version": 0, "text": text });
    note("textDocument/didOpen", json!({ "textDocument": opened }));
    request(2, "textDocument/documentSymbol", json!({ "textDocument": document }));
    request(3, "textDocument/documentSymbol", json!({ "textDocument": document }));
    note("$/cancelRequest", json!({ "id": 2 }));
    request(4, "shutdown", Value::Null);
    note("exit", Value::Null);
    objdict_lsp::serve(&other).unwrap();
    let answers: Vec<(RequestId, Option<i32>)> = client
        .receiver
        .try_iter()
        .filter_map(|message| match message {
            Message::Response(answer) => {
                Some((answer.id, answer.response_result.err().map(|error| error.code)))
            }
            _ => None,
        })
        .collect();
    let mut codes: Vec<_> = answers.into_iter().map(|(id, code)| (id.to_string(), code)).collect();
    codes.sort();
    let expected = [("1", None), ("2", Some(-32800)), ("3", None), ("4", None)];
    assert_eq!(codes, expected.map(|(id, code)| (id.to_owned(), code)));
}

#[test]
fn other_files_have_findings_of_their_own() {
    let mut client = Client::start();
    let profile = fixture("profiles/misspelled.toml");
    let found = client.open("drives.toml", &profile);
    assert_eq!(found.as_array().unwrap().len(), 1, "{found}");
    assert!(client.open("notes.toml", "[package]\nname = \"x\"\n").as_array().unwrap().is_empty());
    let patch = fixture("patches/io-401.patch.toml");
    assert_eq!(client.open("io-401.patch.toml", &patch), json!([]));
    let found = client.open("a.eds", "no description at all");
    assert_eq!(found[0]["severity"], 1);
}

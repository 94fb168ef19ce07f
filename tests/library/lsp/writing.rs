//! Completions, fixes and other changes.

use serde_json::{Value, json};

use super::client::{Client, edited, fixture, marked, position_of};

fn labels(items: &Value) -> Vec<&str> {
    items.as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap()).collect()
}

fn complete(client: &mut Client, name: &str, text: &str) -> (String, Value) {
    let (text, position) = marked(text);
    client.open(name, &text);
    let params = json!({ "textDocument": client.document(name), "position": position });
    let items = client.ask("textDocument/completion", params);
    (text, items)
}

#[test]
fn keys_and_values_of_the_section() {
    let mut client = Client::start();
    let head = fixture("eds/minimal.eds").replace('\r', "");
    let (_, items) = complete(&mut client, "a.eds", &format!("{head}\n[1017]\nParameterName=x\n‸\n"));
    let found = labels(&items);
    assert!(found.contains(&"DataType") && !found.contains(&"ParameterName"), "{found:?}");
    let data_type = items.as_array().unwrap().iter().find(|item| item["label"] == "DataType").unwrap();
    assert_eq!(data_type["textEdit"]["newText"], "DataType=0x0006");
    let (_, items) = complete(&mut client, "a.eds", &format!("{head}\n[2000]\nDataType=‸\n"));
    assert!(labels(&items).contains(&"0x0007 UNSIGNED32"));
    let (_, items) = complete(&mut client, "a.eds", &format!("{head}\n[2000]\nAccessType=r‸\n"));
    assert_eq!(labels(&items), ["ro", "wo", "rw", "rwr", "rww", "const"]);
    let (_, items) = complete(&mut client, "a.eds", &format!("; objdict: allow cia‸\n{head}"));
    assert!(labels(&items).contains(&"cia306/file-name"));
}

#[test]
fn a_mapping_takes_what_fits_its_direction() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace('\r', "");
    let (_, items) = complete(&mut client, "a.eds", &text.replacen("=0x60410010", "=‸", 1));
    let found = labels(&items);
    assert!(found.contains(&"0x60410010 Statusword"), "{found:?}");
    assert!(!found.contains(&"0x60400010 Controlword"), "a TPDO");
}

#[test]
fn an_object_of_a_profile_is_a_section_and_a_line_of_its_list() {
    let mut client = Client::start();
    let head = fixture("eds/minimal.eds").replace('\r', "").replace("minimal.eds", "a.eds");
    let (text, items) = complete(&mut client, "a.eds", &format!("{head}\n[‸"));
    let items = items.as_array().unwrap();
    let item = items.iter().find(|item| item["label"].as_str().unwrap().starts_with("[1016]")).unwrap();
    let item = client.ask("completionItem/resolve", item.clone());
    let mut edits = item["additionalTextEdits"].as_array().unwrap().clone();
    edits.push(item["textEdit"].clone());
    let text = edited(&text, &Value::Array(edits));
    insta::assert_snapshot!("object_of_profile", &text[head.len()..]);
    assert_eq!(client.change("a.eds", &text), json!([]));
}

#[test]
fn an_empty_file_becomes_a_device() {
    let mut client = Client::start();
    assert_eq!(client.open("new.eds", ""), json!([]));
    let (_, items) = complete(&mut client, "new.eds", "‸");
    let items = items.as_array().unwrap();
    let item = items.iter().find(|item| item["label"] == "[FileInfo] a device of CiA 401").unwrap();
    let text = item["textEdit"]["newText"].as_str().unwrap().to_owned();
    let found = client.change("new.eds", &text);
    let codes: Vec<&Value> = found.as_array().unwrap().iter().map(|found| &found["code"]).collect();
    insta::assert_json_snapshot!("device_of_empty_file", codes);
}

#[test]
fn the_ends_of_a_link_are_nodes_and_entries() {
    let mut client = Client::start();
    client.write("island.eds", fixture("network/island.eds"));
    let head = "[node.a]\nfile = \"island.eds\"\nid = 2\n\n[[link]]\n";
    let (_, items) =
        complete(&mut client, "network.toml", &format!("{head}from = \"‸\"\nto = \"a.6200:1\"\n"));
    assert_eq!(labels(&items), ["a"]);
    let (_, items) =
        complete(&mut client, "network.toml", &format!("{head}from = \"a.‸\"\nto = \"a.6200:1\"\n"));
    let found = labels(&items);
    assert!(found.contains(&"a.6000:1") && !found.contains(&"a.6200:1"), "{found:?}");
}

/// The actions at the start of a part of a text.
fn actions(client: &mut Client, name: &str, text: &str, part: &str, only: Option<&str>) -> Vec<Value> {
    let position = position_of(text, part);
    let range = json!({ "start": position, "end": position });
    let context =
        only.map_or(json!({ "diagnostics": [] }), |only| json!({ "diagnostics": [], "only": [only] }));
    let params = json!({ "textDocument": client.document(name), "range": range, "context": context });
    client.ask("textDocument/codeAction", params).as_array().unwrap().clone()
}

/// The text after the action whose title begins so.
fn done(client: &mut Client, name: &str, text: &str, actions: &[Value], title: &str) -> String {
    let action = actions.iter().find(|action| action["title"].as_str().unwrap().starts_with(title));
    let titles: Vec<&Value> = actions.iter().map(|action| &action["title"]).collect();
    let mut action = action.unwrap_or_else(|| panic!("no `{title}` in {titles:?}")).clone();
    if action["edit"].is_null() {
        action = client.ask("codeAction/resolve", action);
    }
    edited(text, &action["edit"]["changes"][client.uri(name)])
}

#[test]
fn findings_are_fixed_one_by_one_or_together() {
    let mut client = Client::start();
    let good = fixture("eds/minimal.eds").replace('\r', "").replace("minimal.eds", "a.eds");
    let bad = good.replace("AccessType=ro", "AccessType = ro");
    let found = client.open("a.eds", &bad);
    assert_eq!(found[0]["code"], "cia306/blank-before-equals");
    let offered = actions(&mut client, "a.eds", &bad, "AccessType = ro", None);
    let first = offered.iter().find(|action| action["isPreferred"] == true).unwrap();
    assert_eq!(first["kind"], "quickfix");
    let on_save = actions(&mut client, "a.eds", &bad, "AccessType = ro", Some("source.fixAll"));
    assert_eq!(on_save.len(), 1, "unsafe fixes are not made when a file is saved: {on_save:?}");
    let title = first["title"].as_str().unwrap().to_owned();
    let once = done(&mut client, "a.eds", &bad, &offered, &title);
    assert!(once.len() < bad.len());
    let all = done(&mut client, "a.eds", &bad, &offered, "fix all findings of cia306/blank-before-equals");
    assert!(!all.contains("AccessType =") && all.contains("AccessType= ro"), "one rule alone");
    let all = done(&mut client, "a.eds", &bad, &offered, "fix all findings that have a safe fix");
    assert_eq!(client.change("a.eds", &all), json!([]));
    let short = fixture("torture/20_pdo_map_wrong_len.eds");
    client.open("b.eds", &short);
    let offered = actions(&mut client, "b.eds", &short, "0x20000010", Some("quickfix"));
    let has = |title: &str| offered.iter().any(|action| action["title"] == title);
    assert!(has("write `0x20000008` (unsafe)"), "{offered:?}");
    assert!(has("fix all findings of cia301/wrong-mapping-length (unsafe)"), "{offered:?}");
}

#[test]
fn a_comment_suppresses_a_finding() {
    for (name, text) in [("a.eds", fixture("eds/minimal.eds")), ("b.xdd", fixture("xdd/valve.xdd"))] {
        let mut client = Client::start();
        let text = text.replace('\r', "");
        let found = client.open(name, &text);
        let code = found[0]["code"].as_str().unwrap_or_else(|| panic!("{name}: {found}")).to_owned();
        let line = found[0]["range"]["start"]["line"].as_u64().unwrap() as usize;
        let column = found[0]["range"]["start"]["character"].as_u64().unwrap() as usize;
        let part = &text.lines().nth(line).unwrap()[column..];
        let offered = actions(&mut client, name, &text, part, Some("quickfix"));
        let allowed = done(&mut client, name, &text, &offered, &format!("allow {code} here"));
        let after = client.change(name, &allowed);
        assert!(after.as_array().unwrap().iter().all(|found| found["code"] != *code), "{after}");
    }
}

#[test]
fn parts_are_added() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace('\r', "");
    client.open("a.eds", &text);
    let offered = actions(&mut client, "a.eds", &text, "[6061]", Some("refactor"));
    let titles: Vec<&Value> = offered.iter().map(|action| &action["title"]).collect();
    assert!(titles.iter().any(|title| title.as_str().unwrap().starts_with("map into TPDO")), "{titles:?}");
    let mapped = done(&mut client, "a.eds", &text, &offered, "map into TPDO");
    assert!(mapped.contains("0x60610008"));
    let offered = actions(&mut client, "a.eds", &text, "[1018]", Some("refactor"));
    assert!(offered.iter().all(|action| !action["title"].as_str().unwrap().starts_with("map")));
    let offered = actions(&mut client, "a.eds", &text, "[OptionalObjects]", Some("refactor"));
    assert_eq!(offered, [] as [Value; 0], "the list is in order");
    let swapped = text.replacen("1=0x1002", "1=0x1003", 1).replacen("2=0x1003", "2=0x1002", 1);
    client.change("a.eds", &swapped);
    let offered = actions(&mut client, "a.eds", &swapped, "[OptionalObjects]", Some("refactor"));
    assert_eq!(done(&mut client, "a.eds", &swapped, &offered, "renumber OptionalObjects"), text);
}

#[test]
fn a_sub_index_is_added_with_the_count() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace('\r', "");
    client.open("a.eds", &text);
    let offered = actions(&mut client, "a.eds", &text, "[2002]", Some("refactor"));
    let added = done(&mut client, "a.eds", &text, &offered, "add sub-index");
    assert!(added.len() > text.len());
    let before = client.change("a.eds", &text);
    let after = client.change("a.eds", &added);
    let codes = |found: &Value| {
        let found = found.as_array().unwrap().iter();
        found.map(|found| found["message"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(codes(&before), codes(&after), "no finding comes");
}

#[test]
fn entries_are_written_out_and_stored_compactly_again() {
    let mut client = Client::start();
    let read = |text: &str| {
        let source = objdict::source::SourceFile::from_text("a.eds", text);
        objdict::format::read(source, objdict::format::Format::Eds)
    };
    for (name, text) in
        [("a.eds", fixture("eds/compact.eds")), ("b.eds", fixture("torture/04_compact_names_values.eds"))]
    {
        client.open(name, &text);
        let objects = read(&text);
        let compact = objects.device().objects.iter().filter(|(_, object)| object.compact.is_some());
        let compact: Vec<_> = compact.map(|(index, object)| (*index, object.clone())).collect();
        assert!(!compact.is_empty());
        for (index, object) in compact {
            let header = format!("[{index:X}]");
            let offered = actions(&mut client, name, &text, &header, Some("refactor"));
            let title = format!("describe the {} sub-indexes", object.compact.as_ref().unwrap().count);
            let written = done(&mut client, name, &text, &offered, &title);
            let after = read(&written);
            assert_eq!(
                after.device().object(index).unwrap().stated().count(),
                object.entries().count(),
                "{written}"
            );
            assert!(object.entries().eq(after.device().object(index).unwrap().entries()), "{written}");
            client.change(name, &written);
            let offered = actions(&mut client, name, &written, &header, Some("refactor"));
            let stored =
                done(&mut client, name, &written, &offered, &format!("store {index:04X}h compactly"));
            let stored = read(&stored);
            assert!(object.entries().eq(stored.device().object(index).unwrap().entries()));
            assert!(stored.device().object(index).unwrap().subs.is_empty());
            client.change(name, &text);
        }
    }
}

#[test]
fn the_order_is_that_of_fmt() {
    let mut client = Client::start();
    let text = fixture("eds/minimal.eds").replace("DataType=", "datatype=");
    client.open("a.eds", &text);
    let params = json!({ "textDocument": client.document("a.eds"), "options": { "tabSize": 4, "insertSpaces": true } });
    let edits = client.ask("textDocument/formatting", params);
    let formatted = edited(&text, &edits);
    let description = objdict::format::read(
        objdict::source::SourceFile::from_text("a.eds", text),
        objdict::format::Format::Eds,
    );
    assert_eq!(formatted.into_bytes(), description.arranged().unwrap());
}

/// Neovim needs a millisecond for each edit of a text.
#[test]
fn many_changes_are_few_edits() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace("ObjectType=", "objecttype=");
    client.open("a.eds", &text);
    let params = json!({ "textDocument": client.document("a.eds"), "options": { "tabSize": 4, "insertSpaces": true } });
    let edits = client.ask("textDocument/formatting", params);
    assert_eq!(edited(&text, &edits), fixture("eds/drive-402.eds"));
    let (count, lines) = (edits.as_array().unwrap().len(), text.matches("objecttype=").count());
    assert!(lines > 200 && count < lines / 20, "{count} edits for {lines} lines");
}

//! What is said of a place, and where it leads.

use serde_json::{Value, json};

use super::client::{Client, edited, fixture, marked, position_of};

fn at(client: &Client, name: &str, position: &Value) -> Value {
    json!({ "textDocument": client.document(name), "position": position })
}

/// The text of the hover at the start of a part, in a part that is before it.
fn hover(client: &mut Client, name: &str, text: &str, section: &str, part: &str) -> String {
    let start = text.find(section).unwrap_or_else(|| panic!("no {section}"));
    let offset = start + text[start..].find(part).unwrap_or_else(|| panic!("no {part}"));
    let params = at(client, name, &super::client::position(text, offset));
    client.ask("textDocument/hover", params)["contents"]["value"].as_str().unwrap_or("nothing").to_owned()
}

#[test]
fn words_about_what_is_under_the_cursor() {
    let mut client = Client::start();
    let text = fixture("dcf/drive-402-node8.dcf");
    client.open("drive.dcf", &text);
    let text = format!("; objdict: allow cia306/file-name\r\n{text}");
    client.change("drive.dcf", &text);
    let mut said = String::new();
    for (section, part) in [
        (";", "cia306/file-name"),
        ("[1A00sub1]", "0x6041"),
        ("[1800sub1]", "NODEID"),
        ("[6040]", "6040"),
        ("[1000]", "0x00020192"),
        ("[OptionalObjects]", "0x1017"),
        ("[1018sub1]", "0x0007"),
    ] {
        let words = hover(&mut client, "drive.dcf", &text, section, part);
        said += &format!("### {section} {part}\n{words}\n");
    }
    insta::assert_snapshot!(said);
}

#[test]
fn a_mapping_and_a_list_lead_to_the_object() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace('\r', "");
    client.open("drive.eds", &text);
    let line = |answer: &Value| {
        let line = answer["range"]["start"]["line"].as_u64().unwrap() as usize;
        text.lines().nth(line).unwrap().to_owned()
    };
    let params = at(&client, "drive.eds", &position_of(&text, "0x60410010"));
    assert_eq!(line(&client.ask("textDocument/definition", params)), "[6041]");
    let params = at(&client, "drive.eds", &position_of(&text, "0x6041\n"));
    assert_eq!(line(&client.ask("textDocument/definition", params.clone())), "[6041]");
    let found =
        client.ask("textDocument/references", with(params, "context", json!({ "includeDeclaration": true })));
    let lines: Vec<String> = found.as_array().unwrap().iter().map(line).collect();
    assert!(lines.len() >= 3 && lines.contains(&"[6041]".to_owned()), "{lines:?}");
}

fn with(mut params: Value, key: &str, value: Value) -> Value {
    params[key] = value;
    params
}

#[test]
fn an_object_gets_another_index_everywhere() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace('\r', "");
    client.open("drive.eds", &text);
    let params = at(&client, "drive.eds", &position_of(&text, "6041]"));
    let offered = client.ask("textDocument/prepareRename", params.clone());
    assert_eq!(offered["placeholder"], "6041");
    let answer = client.ask("textDocument/rename", with(params.clone(), "newName", json!("2041")));
    let edits = &answer["changes"][client.uri("drive.eds")];
    let renamed = edited(&text, edits);
    assert!(!renamed.contains("6041") && renamed.contains("0x20410010") && renamed.contains("[2041]"));
    assert_eq!(renamed, text.replace("6041", "2041"));
    let id = client.send_request("textDocument/rename", with(params, "newName", json!("6040")));
    let error = client.answer_to(&id).response_result.unwrap_err();
    assert_eq!(error.message, "object 6040h already exists");
}

#[test]
fn a_network_leads_to_its_descriptions() {
    let mut client = Client::start();
    client.write("island.eds", fixture("network/island.eds"));
    let text = "[node.a]\nfile = \"island.eds\"\nid = 2\n\n[node.b]\nfile = \"island.eds\"\nid = 3\n\n\
                [[link]]\nfrom = \"a.6000:1\"\nto = \"b.6200:1\"\n";
    client.open("network.toml", text);
    let params = at(&client, "network.toml", &position_of(text, "a.6000:1"));
    let found = client.ask("textDocument/definition", params.clone());
    assert_eq!(found["uri"], client.uri("island.eds"));
    assert!(found["range"]["start"]["line"].as_u64().unwrap() > 0, "{found}");
    let said = client.ask("textDocument/hover", params);
    assert!(said["contents"]["value"].as_str().unwrap().starts_with("node a\n\n**6000h:01**"), "{said}");
    let links =
        client.ask("textDocument/documentLink", json!({ "textDocument": client.document("network.toml") }));
    assert_eq!(links.as_array().unwrap().len(), 2);
    let outline =
        client.ask("textDocument/documentSymbol", json!({ "textDocument": client.document("network.toml") }));
    assert_eq!(outline[1]["detail"], "node-ID 3");
}

#[test]
fn the_outline_has_areas_objects_and_sub_indexes() {
    let mut client = Client::start();
    for name in ["minimal.eds", "valve.xdd"] {
        let folder = if name.ends_with("eds") { "eds" } else { "xdd" };
        client.open(name, &fixture(&format!("{folder}/{name}")));
        let params = json!({ "textDocument": client.document(name) });
        let outline = client.ask("textDocument/documentSymbol", params.clone());
        let mut lines = String::new();
        let mut rest: Vec<(usize, &Value)> =
            outline.as_array().unwrap().iter().rev().map(|one| (0, one)).collect();
        while let Some((depth, one)) = rest.pop() {
            lines += &format!("{}{} {}\n", "  ".repeat(depth), one["name"], one["detail"]);
            let children = one["children"].as_array().into_iter().flatten().rev();
            rest.extend(children.map(|child| (depth + 1, child)));
        }
        insta::assert_snapshot!(format!("outline_{name}"), lines);
        let folds = client.ask("textDocument/foldingRange", params);
        let starts = folds.as_array().unwrap().iter().map(|fold| fold["startLine"].as_u64().unwrap());
        let starts: Vec<u64> = starts.collect();
        assert!(!starts.is_empty() && starts.is_sorted_by(|a, b| a < b), "two fold at a line: {starts:?}");
    }
    let found = client.ask("workspace/symbol", json!({ "query": "1018" }));
    let names: Vec<&str> =
        found.as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["1018 Identity object", "1018 Identity object"]);
}

#[test]
fn symbols_are_those_of_all_folders() {
    let mut client = Client::start();
    for folder in ["a", "b", "c"] {
        std::fs::create_dir(client.path(folder)).unwrap();
        client.write(&format!("{folder}/lamp.eds"), fixture("eds/minimal.eds"));
    }
    assert_eq!(client.offered["capabilities"]["workspace"]["workspaceFolders"]["changeNotifications"], true);
    let folder = |client: &Client, name: &str| json!({ "uri": client.uri(name), "name": name });
    let files = |client: &mut Client| {
        let found = client.ask("workspace/symbol", json!({ "query": "1018" }));
        let uris =
            found.as_array().unwrap().iter().map(|one| one["location"]["uri"].as_str().unwrap().to_owned());
        let start = client.uri("");
        uris.map(|uri| uri.strip_prefix(&start).unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(files(&mut client), ["a/lamp.eds", "b/lamp.eds", "c/lamp.eds"]);
    let event =
        json!({ "added": [folder(&client, "a"), folder(&client, "c")], "removed": [folder(&client, "")] });
    client.note("workspace/didChangeWorkspaceFolders", json!({ "event": event }));
    assert_eq!(files(&mut client), ["a/lamp.eds", "c/lamp.eds"]);
    let event = json!({ "added": [], "removed": [folder(&client, "a")] });
    client.note("workspace/didChangeWorkspaceFolders", json!({ "event": event }));
    assert_eq!(files(&mut client), ["c/lamp.eds"]);
}

#[test]
fn ranges_around_a_place_are_in_each_other() {
    let mut client = Client::start();
    let text = fixture("eds/minimal.eds");
    client.open("a.eds", &text);
    let positions = json!([position_of(&text, "0x00000000")]);
    let params = json!({ "textDocument": client.document("a.eds"), "positions": positions });
    let answer = client.ask("textDocument/selectionRange", params);
    let mut count = 0;
    let mut range = &answer[0];
    while range.is_object() {
        count += 1;
        range = &range["parent"];
    }
    assert!(count >= 4, "{answer}");
}

#[test]
fn hints_and_lenses_of_pdos() {
    let mut client = Client::start();
    let text = fixture("dcf/drive-402-node8.dcf").replace('\r', "");
    client.open("drive.dcf", &text);
    let range = json!({ "start": { "line": 0, "character": 0 }, "end": { "line": 99999, "character": 0 } });
    let params = json!({ "textDocument": client.document("drive.dcf"), "range": range });
    let hints = client.ask("textDocument/inlayHint", params);
    let shown = hints.as_array().unwrap().iter().map(|hint| {
        let line = text.lines().nth(hint["position"]["line"].as_u64().unwrap() as usize).unwrap();
        format!("{line} ‹{}›\n", hint["label"].as_str().unwrap())
    });
    insta::assert_snapshot!("hints", shown.collect::<String>());
    let lenses = client.ask("textDocument/codeLens", json!({ "textDocument": client.document("drive.dcf") }));
    let titles = lenses.as_array().unwrap().iter().map(|lens| lens["command"]["title"].as_str().unwrap());
    insta::assert_snapshot!("lenses", titles.collect::<Vec<_>>().join("\n"));
    let tokens = client
        .ask("textDocument/semanticTokens/full", json!({ "textDocument": client.document("drive.dcf") }));
    let data = tokens["data"].as_array().unwrap();
    assert!(data.len() > 1000 && data.len().is_multiple_of(5));
}

#[test]
fn nothing_is_said_where_nothing_is() {
    let mut client = Client::start();
    let (text, position) = marked("[FileInfo]\nFile‸Name=a.eds\n");
    client.open("a.eds", &text);
    let params = at(&client, "a.eds", &position);
    assert_eq!(client.ask("textDocument/hover", params.clone()), Value::Null);
    assert_eq!(client.ask("textDocument/definition", params), Value::Null);
    let id = client.send_request("textDocument/noSuch", json!({}));
    assert_eq!(client.answer_to(&id).response_result.unwrap_err().code, -32601);
}

#[test]
fn a_section_with_another_spelling_is_its_object() {
    let mut client = Client::start();
    let plain = fixture("eds/drive-402.eds").replace('\r', "");
    let odd = plain.replace("[6041]", "[6041h]").replace("[1018sub1]", "[$1018.1]");
    client.open("drive.eds", &odd);
    let params = at(&client, "drive.eds", &position_of(&odd, "0x60410010"));
    let found = client.ask("textDocument/definition", params);
    let line = found["range"]["start"]["line"].as_u64().unwrap() as usize;
    assert_eq!(odd.lines().nth(line), Some("[6041h]"));
    let said = ["6041", "[1018", "0x6041"].map(|part| hover(&mut client, "drive.eds", &odd, "[", part));
    let outline = |client: &mut Client, text: &str| {
        client.change("drive.eds", text);
        let symbols = client
            .ask("textDocument/documentSymbol", json!({ "textDocument": client.document("drive.eds") }));
        let names = symbols.to_string();
        names
            .split("\"name\":")
            .map(|rest| rest.split(',').next().unwrap_or_default().to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(outline(&mut client, &odd), outline(&mut client, &plain));
    assert_eq!(
        said,
        ["6041", "[1018", "0x6041"].map(|part| hover(&mut client, "drive.eds", &plain, "[", part))
    );
}

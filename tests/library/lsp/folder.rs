//! What concerns several files of a folder: new numbers, references, new files, the baseline.

use serde_json::{Value, json};

use super::client::{Client, edited, fixture, position_of};

const NETWORK: &str = "[node.a]\nfile = \"island.eds\"\nid = 2\n\n[node.a.set]\n\"1017\" = 500\n\n[node.a.tpdo.1]\n\
                       map = [\"6000:1\"]\n\n[node.b]\nfile = \"island.eds\"\nid = 3\n\n[[link]]\nfrom = \"a.6000:2\"\n\
                       to = \"b.6200:1\"\n";

fn at(client: &Client, name: &str, text: &str, part: &str) -> Value {
    json!({ "textDocument": client.document(name), "position": position_of(text, part) })
}

fn rename(client: &mut Client, name: &str, text: &str, part: &str, new: &str) -> Result<Value, String> {
    let mut params = at(client, name, text, part);
    params["newName"] = json!(new);
    let id = client.send_request("textDocument/rename", params);
    client.answer_to(&id).response_result.map_err(|error| error.message)
}

/// A client that can create files, and has a folder with a device and its network.
fn with_network() -> (Client, String) {
    let edit = json!({ "documentChanges": true, "resourceOperations": ["create"] });
    let capabilities =
        json!({ "workspace": { "workspaceEdit": edit }, "window": { "showDocument": { "support": true } } });
    let client = Client::start_with(&capabilities);
    let island = fixture("network/island.eds").replace('\r', "");
    client.write("island.eds", &island);
    client.write("network.toml", NETWORK);
    (client, island)
}

#[test]
fn an_object_gets_another_index_in_networks_too() {
    let (mut client, island) = with_network();
    client.open("island.eds", &island);
    let answer = rename(&mut client, "island.eds", &island, "6000]", "2600").unwrap();
    let changed = edited(&island, &answer["changes"][client.uri("island.eds")]);
    assert!(changed.contains("[2600]") && changed.contains("=0x2600\n") && changed.contains("0x26000108"));
    assert!(!changed.contains("[6000") && !changed.contains("0x6000"), "{changed}");
    let network = edited(NETWORK, &answer["changes"][client.uri("network.toml")]);
    assert_eq!(network, NETWORK.replace("6000", "2600"));
    assert_eq!(
        rename(&mut client, "island.eds", &island, "6000]", "6200"),
        Err("object 6200h already exists".to_owned())
    );
}

#[test]
fn a_network_gives_its_description_another_index() {
    let (mut client, island) = with_network();
    client.open("network.toml", NETWORK);
    let params = at(&client, "network.toml", NETWORK, "6000:2");
    let offered = client.ask("textDocument/prepareRename", params);
    assert_eq!(offered["placeholder"], "6000");
    let answer = rename(&mut client, "network.toml", NETWORK, "1017", "2017").unwrap();
    assert_eq!(
        edited(NETWORK, &answer["changes"][client.uri("network.toml")]),
        NETWORK.replace("1017", "2017")
    );
    let changed = edited(&island, &answer["changes"][client.uri("island.eds")]);
    assert_eq!(changed, island.replace("1017", "2017"));
    let id = client.send_request("textDocument/prepareRename", at(&client, "network.toml", NETWORK, "file"));
    let error = client.answer_to(&id).response_result.unwrap_err();
    assert_eq!(error.message, "put the cursor on the index or sub-index of an object");
}

#[test]
fn an_entry_gets_another_sub_index() {
    let mut client = Client::start();
    let text = fixture("eds/drive-402.eds").replace('\r', "");
    client.open("drive.eds", &text);
    // behind the last sub-index one is free
    let last = (1..=254).rev().find(|sub| text.contains(&format!("[2002sub{sub:X}]"))).unwrap();
    let (old, new) = (format!("[2002sub{last:X}]"), format!("[2002sub{:X}]", last + 1));
    let at = text.find(&old).unwrap() + "[2002sub".len();
    let position = super::client::position(&text, at);
    let new_name = format!("{:X}", last + 1);
    let params =
        json!({ "textDocument": client.document("drive.eds"), "position": position, "newName": new_name });
    let answer = client.ask("textDocument/rename", params);
    let changed = edited(&text, &answer["changes"][client.uri("drive.eds")]);
    assert!(changed.contains(&new) && !changed.contains(&old), "{changed}");
    assert_eq!(changed.matches("[2002").count(), text.matches("[2002").count());
}

#[test]
fn xdd_and_device_toml_get_another_index() {
    for (name, folder, old) in [("drive-402.xdd", "xdd", "6041"), ("io.toml", "toml", "2001")] {
        let mut client = Client::start();
        let text = fixture(&format!("{folder}/{name}")).replace('\r', "");
        client.open(name, &text);
        let part = if folder == "xdd" { "6041\" name" } else { "2001 = " };
        let answer = rename(&mut client, name, &text, part, "2FA1").unwrap();
        let changed = edited(&text, &answer["changes"][client.uri(name)]);
        let format =
            if folder == "xdd" { objdict::format::Format::Xdd } else { objdict::format::Format::Toml };
        let read =
            |text: String| objdict::format::read(objdict::source::SourceFile::from_text(name, text), format);
        let (before, after) = (read(text.clone()), read(changed.clone()));
        let index = u16::from_str_radix(old, 16).unwrap();
        assert!(
            after.device().object(0x2FA1).is_some() && after.device().object(index).is_none(),
            "{changed}"
        );
        let mapped = |device: &objdict::model::Device| {
            device
                .pdos()
                .flat_map(|pdo| pdo.slots)
                .filter(|slot| slot.object.is_some_and(|mapped| mapped.index == 0x2FA1))
                .count()
        };
        assert!(mapped(after.device()) > 0, "the mappings follow");
        assert_eq!(before.device().objects.len(), after.device().objects.len());
        let found = client.ask("textDocument/references", {
            let mut params = at(&client, name, &text, part);
            params["context"] = json!({ "includeDeclaration": true });
            params
        });
        assert!(found.as_array().unwrap().len() >= 2, "{found}");
    }
}

#[test]
fn references_are_found_in_networks() {
    let (mut client, island) = with_network();
    client.open("island.eds", &island);
    let mut params = at(&client, "island.eds", &island, "6000]");
    params["context"] = json!({ "includeDeclaration": true });
    let found = client.ask("textDocument/references", params);
    let uris: Vec<&str> =
        found.as_array().unwrap().iter().map(|found| found["uri"].as_str().unwrap()).collect();
    assert!(uris.contains(&&*client.uri("network.toml")), "{uris:?}");
}

fn actions(client: &mut Client, name: &str, text: &str, part: &str) -> Vec<Value> {
    let start = position_of(text, part);
    let params = json!({ "textDocument": client.document(name), "range": { "start": start, "end": start }, "context": { "diagnostics": [] } });
    client.ask("textDocument/codeAction", params).as_array().unwrap().clone()
}

fn chosen(client: &mut Client, actions: &[Value], title: &str) -> Value {
    let action = actions.iter().find(|action| action["title"].as_str().unwrap().starts_with(title));
    let titles: Vec<&Value> = actions.iter().map(|action| &action["title"]).collect();
    let action = action.unwrap_or_else(|| panic!("no `{title}` in {titles:?}")).clone();
    if action["edit"].is_null() { client.ask("codeAction/resolve", action) } else { action }
}

#[test]
fn a_description_is_converted_into_a_new_file() {
    let (mut client, island) = with_network();
    client.open("island.eds", &island);
    let offered = actions(&mut client, "island.eds", &island, "[FileInfo]");
    let action = chosen(&mut client, &offered, "convert to XDD in `island.xdd`");
    let changes = action["edit"]["documentChanges"].as_array().unwrap();
    assert_eq!(changes[0]["kind"], "create");
    assert_eq!(changes[0]["options"], json!({ "overwrite": false, "ignoreIfExists": false }));
    let xdd = changes[1]["edits"][0]["newText"].as_str().unwrap();
    let read = |name: &str, text: &str, format| {
        objdict::format::read(objdict::source::SourceFile::from_text(name, text), format)
    };
    let (before, after) = (
        read("island.eds", &island, objdict::format::Format::Eds),
        read("island.xdd", xdd, objdict::format::Format::Xdd),
    );
    assert_eq!(before.device().objects.len(), after.device().objects.len());
    client.write("island.xdd", xdd);
    let offered = actions(&mut client, "island.eds", &island, "[FileInfo]");
    assert!(
        offered.iter().all(|action| !action["title"].as_str().unwrap().contains("island.xdd")),
        "it is there"
    );
    let mut plain = Client::start();
    plain.open("island.eds", &island);
    let offered = actions(&mut plain, "island.eds", &island, "[FileInfo]");
    assert!(offered.iter().all(|action| !action["title"].as_str().unwrap().starts_with("convert")));
}

#[test]
fn a_node_is_added_to_the_network() {
    let (mut client, _) = with_network();
    let dcf = fixture("dcf/drive-402-node8.dcf").replace('\r', "");
    client.write("drive.dcf", &dcf);
    client.open("drive.dcf", &dcf);
    let offered = actions(&mut client, "drive.dcf", &dcf, "[FileInfo]");
    let action = chosen(&mut client, &offered, "add the node to the network");
    let text = edited(NETWORK, &action["edit"]["changes"][client.uri("network.toml")]);
    assert!(text.starts_with(NETWORK), "{text}");
    insta::assert_snapshot!("added_node", &text[NETWORK.len()..]);
}

#[test]
fn the_page_is_that_of_the_unsaved_text() {
    let (mut client, island) = with_network();
    client.open("island.eds", &island);
    let name = island.lines().find_map(|line| line.strip_prefix("ProductName=")).unwrap();
    client.change("island.eds", &island.replace(name, "Quite another name"));
    let params = json!({ "command": "objdict.documentation", "arguments": [client.uri("island.eds")] });
    let page = client.ask("workspace/executeCommand", params);
    let page = page.as_str().unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") || page.starts_with("<!doctype html>"), "{}", &page[..40]);
    assert!(page.contains("Quite another name"));
    let offered = actions(&mut client, "island.eds", &island, "[FileInfo]");
    let action = offered.iter().find(|action| action["title"] == "show the documentation").unwrap();
    let command = &action["command"];
    let params = json!({ "command": command["command"], "arguments": command["arguments"] });
    client.ask("workspace/executeCommand", params);
    let shown = client.request("window/showDocument");
    assert_eq!(shown["external"], true);
    let path = shown["uri"].as_str().unwrap().strip_prefix("file://").unwrap().to_owned();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), page);
    drop(client);
    assert!(!std::path::Path::new(&path).exists(), "the server removes its pages");
}

#[test]
fn findings_are_added_to_the_baseline_of_the_editor() {
    let edit = json!({ "documentChanges": true, "resourceOperations": ["create"] });
    let options = json!({ "baseline": "known.json" });
    let mut client = Client::start_as(&json!({ "workspace": { "workspaceEdit": edit } }), &options);
    let text = fixture("eds/minimal.eds").replace('\r', "");
    assert_eq!(client.open("a.eds", &text)[0]["code"], "cia306/file-name");
    let offered = actions(&mut client, "a.eds", &text, "minimal.eds");
    let action =
        chosen(&mut client, &offered, "add the findings of cia306/file-name in this file to `known.json`");
    let baseline = action["edit"]["documentChanges"][1]["edits"][0]["newText"].as_str().unwrap().to_owned();
    let read = objdict::baseline::Baseline::read(&baseline).unwrap();
    assert_eq!(read.files().collect::<Vec<_>>(), [("a.eds", 1)]);
    client.write("known.json", &baseline);
    client.note("workspace/didChangeWatchedFiles", json!({ "changes": [] }));
    assert_eq!(client.findings("a.eds"), json!([]));
    client.write("known.json", "{}");
    client.note("workspace/didChangeWatchedFiles", json!({ "changes": [] }));
    let found = client.findings("a.eds");
    let message = found[0]["message"].as_str().unwrap();
    assert!(message.contains("known.json` is not a baseline: "), "{message}");
    assert_eq!(found[1]["code"], "cia306/file-name");
}

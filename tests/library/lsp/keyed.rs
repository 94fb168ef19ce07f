//! What can be written in files of keys and in XDD.

use serde_json::{Value, json};

use super::client::{Client, fixture, marked, position_of};

fn complete(client: &mut Client, name: &str, text: &str) -> Vec<Value> {
    let (text, position) = marked(text);
    client.open(name, &text);
    let params = json!({ "textDocument": client.document(name), "position": position });
    client.ask("textDocument/completion", params).as_array().unwrap().clone()
}

fn labels(client: &mut Client, name: &str, text: &str) -> Vec<String> {
    let items = complete(client, name, text);
    items.iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect()
}

fn has(found: &[String], wanted: &[&str]) {
    for wanted in wanted {
        assert!(found.iter().any(|found| found == wanted), "no `{wanted}` in {found:?}");
    }
}

const NODE: &str = "[node.a]\nfile = \"island.eds\"\nid = 2\n";

fn client() -> Client {
    let client = Client::start();
    client.write("island.eds", fixture("network/island.eds"));
    client
}

#[test]
fn keys_of_a_network() {
    let mut client = client();
    let items = complete(&mut client, "network.toml", &format!("{NODE}‸\n"));
    let heartbeat = items.iter().find(|item| item["label"] == "heartbeat").unwrap();
    assert_eq!(heartbeat["textEdit"]["newText"], "heartbeat = ");
    assert!(heartbeat["detail"].as_str().unwrap().starts_with("The producer heartbeat time"));
    assert!(items.iter().all(|item| item["label"] != "file"), "it has that");
    has(&labels(&mut client, "network.toml", &format!("{NODE}\n[[link]]\n‸\n")), &["from", "to", "can-id"]);
    has(&labels(&mut client, "network.toml", &format!("{NODE}\n[‸")), &["[bus]", "[[link]]", "[node]"]);
    has(&labels(&mut client, "network.toml", &format!("{NODE}unused-pdos = \"‸\"\n")), &["keep", "off"]);
    has(&labels(&mut client, "network.toml", &format!("{NODE}boot = ‸\n")), &["true", "false"]);
}

#[test]
fn files_nodes_and_entries_of_a_network() {
    let mut client = client();
    // the value has no end yet, so the file is not TOML
    has(&labels(&mut client, "network.toml", &format!("{NODE}\n[node.b]\nfile = \"‸\n")), &["island.eds"]);
    has(&labels(&mut client, "network.toml", &format!("{NODE}\n[[link]]\nfrom = \"‸\n")), &["a"]);
    has(&labels(&mut client, "network.toml", &format!("{NODE}\n[node.a.set]\n\"‸\n")), &["1017"]);
    let island = fixture("network/island.eds").replace("[1017]", "[2FFF]");
    client.open("island.eds", &island);
    let found = labels(&mut client, "network.toml", &format!("{NODE}\n[node.a.set]\n\"‸\n"));
    assert!(found.contains(&"2FFF".to_owned()) && !found.contains(&"1017".to_owned()), "the buffer counts");
}

#[test]
fn values_in_a_device_with_their_meanings() {
    let mut client = client();
    let mut of = |lines: &str| {
        let text = format!(
            "format = \"objdict-device/1\"\nprofile = \"402@1\"\n[features]\nmodes = [\"pp\", \"hm\"]\n{lines}"
        );
        labels(&mut client, "device.toml", &text)
    };
    let modes = ["1 profile position", "6 homing"];
    has(&of("[object]\n6060.default = ‸\n"), &modes);
    has(&of("[object]\n6060 = { default = ‸ }\n"), &modes);
    has(&of("[object.6060]\ndefault = ‸\n"), &modes);
    has(&of("[variant.a.object.6060]\nvalue = ‸\n"), &modes);
    let own = "[object]\n2000 = { name = \"A\", type = \"u8\", enum = { 1 = \"on\" }, default = ‸0 }\n";
    has(&of(own), &["1 on"]);
    has(&of("[tpdo.1]\ntransmission = ‸\n"), &["sync/1 synchronous, every nth SYNC"]);
    has(&of("[tpdo.1]\nmap = [\"‸\"]\n"), &["6041 Statusword"]);
    let rpdo = of("[rpdo.1]\nmap = [\"‸\"]\n");
    has(&rpdo, &["6040 Controlword"]);
    assert!(!rpdo.contains(&"6041 Statusword".to_owned()), "{rpdo:?}");
    // a formula is a text: between the quotes, or with its own
    has(&of("[object]\n1014.default = \"‸\"\n"), &["$NODEID+0x80 usual"]);
    assert!(of("[object]\n6060.default = \"‸\"\n").is_empty(), "numbers have no quotes");
}

#[test]
fn a_former_key_is_not_offered() {
    let mut client = client();
    let found = labels(&mut client, "network.toml", &format!("{NODE}tpdo.1.‸\n"));
    assert!(found.contains(&"transmission".to_owned()) && !found.contains(&"type".to_owned()), "{found:?}");
}

#[test]
fn keys_of_bus_yml() {
    let mut client = client();
    let head = "master:\n  node_id: 1\nservo:\n  dcf: island.eds\n";
    let found = labels(&mut client, "bus.yml", &format!("{head}  ‸\n"));
    has(&found, &["heartbeat_producer", "tpdo"]);
    assert!(!found.contains(&"dcf".to_owned()));
    has(
        &labels(&mut client, "bus.yml", &format!("{head}  sdo:\n    - index: 0x1017\n      ‸\n")),
        &["sub_index", "value"],
    );
    has(&labels(&mut client, "bus.yml", &format!("{head}  mandatory: ‸\n")), &["true", "false"]);
}

#[test]
fn keys_and_words_of_a_device() {
    let mut client = Client::start();
    let text = fixture("toml/io.toml");
    has(
        &labels(&mut client, "io.toml", &format!("{text}2010 = {{ name = \"x\", ‸ }}\n")),
        &["type", "access", "map"],
    );
    has(
        &labels(&mut client, "io.toml", &format!("{text}2010 = {{ name = \"x\", access = \"‸\" }}\n")),
        &["ro", "const"],
    );
    has(
        &labels(&mut client, "io.toml", &format!("{text}2010 = {{ name = \"x\", type = \"‸\" }}\n")),
        &["u16", "string"],
    );
    has(&labels(&mut client, "io.toml", &text.replace("[features]\n", "[features]\n‸\n")), &["lss", "emcy"]);
}

#[test]
fn settings_of_a_project() {
    let mut client = Client::start();
    has(&labels(&mut client, "objdict.toml", "‸"), &["rules", "exclude", "node-id"]);
    has(&labels(&mut client, "objdict.toml", "[rules]\n\"cia306/‸\""), &["cia306/file-name"]);
}

#[test]
fn words_of_attributes() {
    let mut client = Client::start();
    let text = fixture("xdd/valve.xdd");
    let marked = |name: &str| {
        let at = text.find(&format!(" {name}=\"")).unwrap() + name.len() + 3;
        format!("{}‸{}", &text[..at], &text[at..])
    };
    has(&labels(&mut client, "valve.xdd", &marked("accessType")), &["ro", "rw", "const"]);
    has(&labels(&mut client, "valve.xdd", &marked("PDOmapping")), &["TPDO", "no"]);
    has(&labels(&mut client, "valve.xdd", &marked("dataType")), &["0007 UNSIGNED32"]);
    let (emcy, value) =
        (r#"index="1014" name="COB-ID EMCY" objectType="7" dataType="0007""#, r#"defaultValue=""#);
    let text =
        text.replace(r#"index="1017" name="Producer heartbeat time" objectType="7" dataType="0006""#, emcy);
    let at = text.find(emcy).unwrap();
    let at = at + text[at..].find(value).unwrap() + value.len();
    let marked = format!("{}‸{}", &text[..at], &text[at..]);
    has(&labels(&mut client, "valve.xdd", &marked), &["$NODEID+0x80 usual"]);
}

#[test]
fn a_misspelled_key_is_replaced() {
    let mut client = client();
    let text = format!("{NODE}hartbeat = 500\n");
    client.open("network.toml", &text);
    let start = position_of(&text, "hartbeat");
    let params = json!({
        "textDocument": client.document("network.toml"),
        "range": { "start": start, "end": start },
        "context": { "diagnostics": [] },
    });
    let offered = client.ask("textDocument/codeAction", params);
    let action = &offered[0];
    assert_eq!(action["title"], "replace it with `heartbeat`");
    let changed = super::client::edited(&text, &action["edit"]["changes"][client.uri("network.toml")]);
    assert_eq!(changed, text.replace("hartbeat", "heartbeat"));
}

#[test]
fn objects_of_the_documents_in_device_toml() {
    let mut client = client();
    let text = fixture("toml/family.toml");
    let before = client.open("device.toml", &text);
    for defaults in ["", "[defaults]\naccess = \"ro\"\n\n"] {
        let start = text.replacen("[object]\n", &format!("{defaults}[object]\n‸\n"), 1);
        let items = complete(&mut client, "device.toml", &start);
        let item = items.iter().find(|item| item["label"].as_str().unwrap().starts_with("1012 ")).unwrap();
        assert_eq!(item["detail"], "CiA 301");
        assert!(
            items.iter().all(|item| !item["label"].as_str().unwrap().starts_with("1018 ")),
            "it has that"
        );
        let line = item["textEdit"]["newText"].as_str().unwrap();
        let after = start.replace('‸', line);
        let source = objdict::source::SourceFile::from_text("device.toml", after.clone());
        let description = objdict::format::read(source, objdict::format::Format::Toml);
        let object = description.device().object(0x1012).unwrap();
        assert_eq!(object.main.access, Some(objdict::model::Access::Rw), "{line}");
        if defaults.is_empty() {
            assert_eq!(client.change("device.toml", &after), before, "{line}");
        }
    }
}

//! The engine of the workbench as a page calls it.

use std::fs;
use std::path::{Path, PathBuf};

use objdict_wasm::Workbench;
use serde_json::{Value, json};

/// An engine with a fixture open as document 0.
fn with(fixture: &str) -> Workbench {
    let mut workbench = Workbench::new();
    let path = fixtures().join(fixture);
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{fixture}: {error}"));
    let opened = workbench.call(&json!({ "do": "open", "name": name }).to_string(), bytes);
    assert!(opened.starts_with(r#"{"ok":"#), "{opened}");
    workbench
}

fn fixtures() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures")
}

fn ask(workbench: &mut Workbench, request: Value) -> Value {
    let answer = workbench.call(&request.to_string(), Vec::new());
    serde_json::from_str(&answer).unwrap_or_else(|error| panic!("{error}: {answer}"))
}

/// The data of an answer.
fn ok(workbench: &mut Workbench, request: Value) -> Value {
    let mut answer = ask(workbench, request);
    assert!(answer.get("ok").is_some(), "{answer}");
    answer["ok"].take()
}

/// The text of document 0.
fn text(workbench: &mut Workbench) -> String {
    let state = ok(workbench, json!({ "do": "state", "document": 0 }));
    state["text"].as_str().unwrap_or_default().to_owned()
}

/// The bytes of document 0 as a file.
fn saved(workbench: &mut Workbench, name: &str) -> Vec<u8> {
    ok(workbench, json!({ "do": "save", "document": 0, "name": name, "node_id": 5, "bit_rate": 250 }));
    workbench.take(0)
}

#[test]
fn a_file_is_saved_in_place_as_it_is() {
    for fixture in ["dcf/drive-402-node8.dcf", "eds/drive-402.eds", "xdd/io-401.xdd"] {
        let mut workbench = with(fixture);
        ok(&mut workbench, json!({ "do": "bytes", "document": 0 }));
        assert_eq!(workbench.take(0), fs::read(fixtures().join(fixture)).unwrap_or_default(), "{fixture}");
    }
}

#[test]
fn a_variant_repeats_no_finding_of_its_device() {
    let text = "format = \"objdict-device/1\"\nprofile = \"301@1\"\n[device]\nvendor-number = 1\n\
                [object.2000]\nname = \"Level\"\ntype = \"u8\"\n[variant.bright.object.2000]\ndefault = 300\n";
    let mut workbench = Workbench::new();
    workbench.call(&json!({ "do": "open", "name": "lamp.toml" }).to_string(), text.into());
    let report = ok(&mut workbench, json!({ "do": "check", "document": 0 }));
    let findings = report["findings"].as_array().cloned().unwrap_or_default();
    let count = |rule: &str| findings.iter().filter(|finding| finding["rule"] == rule).count();
    assert_eq!((count("cia306/missing-device-info-key"), count("keys/wrong-type")), (1, 1), "{report}");
    assert_eq!(report["summary"]["files"], 1);
}

/// The lines that differ.
fn changed(before: &str, after: &str) -> Vec<String> {
    let (before, after): (Vec<_>, Vec<_>) = (before.lines().collect(), after.lines().collect());
    assert_eq!(before.len(), after.len());
    before.iter().zip(&after).filter(|(old, new)| old != new).map(|(_, new)| (*new).to_owned()).collect()
}

#[test]
fn a_field_is_one_line_and_undo_restores_the_bytes() {
    let mut workbench = with("eds/drive-402.eds");
    let original = fs::read(fixtures().join("eds/drive-402.eds")).unwrap_or_default();
    let before = text(&mut workbench);
    let set = json!({ "do": "change", "document": 0, "changes": [
        { "change": "set", "at": "0x1017 / DefaultValue", "value": "1234" }
    ] });
    ok(&mut workbench, set.clone());
    let after = text(&mut workbench);
    assert_eq!(changed(&before, &after), ["DefaultValue=1234"]);
    // the same again changes nothing, and there is nothing more to undo
    ok(&mut workbench, set);
    let state = ok(&mut workbench, json!({ "do": "undo", "document": 0 }));
    assert_eq!(state["can_undo"], false);
    assert_eq!(saved(&mut workbench, "drive-402.eds"), original);
    ok(&mut workbench, json!({ "do": "redo", "document": 0 }));
    assert_eq!(text(&mut workbench), after);
}

#[test]
fn edits_have_lines_and_columns_of_characters() {
    let mut workbench = with("eds/minimal.eds");
    let before = text(&mut workbench);
    let edit = |revision: u32, column: u32, end_column: u32, text: &str| {
        json!({ "do": "edit", "document": 0, "revision": revision, "edits": [
            { "line": 1, "column": column, "end_line": 1, "end_column": end_column, "text": text }
        ] })
    };
    ok(&mut workbench, edit(0, 1, 1, "; \u{e4}\u{1f600}\n"));
    ok(&mut workbench, edit(1, 4, 5, "b"));
    assert_eq!(text(&mut workbench), format!("; \u{e4}b\n{before}"));
    let refused = ask(
        &mut workbench,
        json!({ "do": "edit", "document": 0, "revision": 2, "edits": [
        { "line": 100_000, "column": 1, "end_line": 1, "end_column": 1, "text": "" }
    ] }),
    );
    assert_eq!(refused["error"]["message"], "the text has no line 100000, column 1");
    // an edit for a former text would go to another place
    let refused = ask(&mut workbench, edit(1, 1, 1, "; "));
    assert_eq!(refused["error"]["message"], "the text was changed meanwhile");
    assert_eq!(text(&mut workbench), format!("; \u{e4}b\n{before}"));
    for expected in [format!("; \u{e4}\u{1f600}\n{before}"), before.clone(), before] {
        ok(&mut workbench, json!({ "do": "undo", "document": 0 }));
        assert_eq!(text(&mut workbench), expected);
    }
}

#[test]
fn a_mapping_grows_by_an_entry() {
    let mut workbench = with("eds/io-401.eds");
    let pdos =
        |workbench: &mut Workbench| ok(workbench, json!({ "do": "outline", "document": 0 }))["pdos"].clone();
    let before = pdos(&mut workbench);
    let tpdo = before
        .as_array()
        .and_then(|pdos| pdos.iter().position(|pdo| pdo["kind"] == "TPDO"))
        .unwrap_or_default();
    let mapping = before[tpdo]["mapping"].as_u64().unwrap_or_default();
    let next = before[tpdo]["slots"].as_array().map_or(0, Vec::len) + 1;
    let at = format!("0x{mapping:04X}sub{next:X}");
    let fields = json!([
        ["ParameterName", "Mapped object"],
        ["ObjectType", "0x7"],
        ["DataType", "0x0007"],
        ["AccessType", "rw"],
        ["DefaultValue", "0x60000108"],
        ["PDOMapping", "0"]
    ]);
    let count = format!("0x{mapping:04X}sub0 / DefaultValue");
    ok(
        &mut workbench,
        json!({ "do": "change", "document": 0, "changes": [
        { "change": "add", "at": at, "fields": fields },
        { "change": "set", "at": count, "value": next.to_string() },
    ] }),
    );
    let after = pdos(&mut workbench);
    let added = json!({ "sub": next, "number": 0x6000_0108 });
    assert_eq!(after[tpdo]["slots"][next - 1], added);
    assert_eq!(after[tpdo]["mapped_count"], next);
}

#[test]
fn objects_come_from_profiles_and_patches() {
    let mut workbench = with("eds/drive-402.eds");
    let rows = ok(&mut workbench, json!({ "do": "profile-objects", "document": 0, "profile": 402 }));
    let missing = rows.as_array().and_then(|rows| rows.iter().rev().find(|row| row["has"] == false)).cloned();
    let index = missing.unwrap_or_default()["index"].clone();
    ok(&mut workbench, json!({ "do": "add-objects", "document": 0, "profile": 402, "indexes": [index] }));
    let form = ok(&mut workbench, json!({ "do": "form", "document": 0, "index": index }));
    assert_ne!(form["parts"][0]["fields"][0]["text"], Value::Null);

    let patch = "format = \"objdict-patch/1\"\n[[change]]\nat = \"2FFF\"\nadd = { name = \"Own\", object-type = \"var\", type = \"u8\", access = \"rw\" }\n";
    ok(&mut workbench, json!({ "do": "patch", "document": 0, "patch": patch }));
    assert!(text(&mut workbench).contains("[2FFF]"));
}

#[test]
fn a_new_device_has_no_errors() {
    let mut workbench = Workbench::new();
    for (number, profile) in [301, 401, 402, 404, 406].into_iter().enumerate() {
        let new = json!({ "do": "new", "name": "new.eds", "profile": profile, "vendor": "Example", "vendor_id": 1,
            "product": "Device", "product_code": 2, "date": [2026, 11, 26], "features": { "store": 1, "lss": true } });
        assert_eq!(ok(&mut workbench, new)["document"], number);
        let report = ok(&mut workbench, json!({ "do": "check", "document": number }));
        assert_eq!(report["summary"]["errors"], 0, "{profile}: {report}");
    }
}

/// Opens a fixture beside what is open; its number.
fn beside(workbench: &mut Workbench, fixture: &str) -> u64 {
    let bytes = fs::read(fixtures().join(fixture)).unwrap_or_else(|error| panic!("{fixture}: {error}"));
    let name = Path::new(fixture).file_name().map(|name| name.to_string_lossy().into_owned());
    let answer = workbench.call(&json!({ "do": "open", "name": name }).to_string(), bytes);
    let answer: Value = serde_json::from_str(&answer).unwrap_or_default();
    answer["ok"]["document"].as_u64().unwrap_or_else(|| panic!("{fixture}: {answer}"))
}

#[test]
fn a_network_is_read_with_the_open_descriptions() {
    let mut workbench = with("network/line.toml");
    let network = |workbench: &mut Workbench| ok(workbench, json!({ "do": "network", "document": 0 }));
    let alone = network(&mut workbench);
    let unread = alone["report"]["findings"].as_array().map_or(0, |findings| {
        findings.iter().filter(|finding| finding["rule"] == "network/unreadable-node").count()
    });
    // two nodes share one of the two descriptions
    assert_eq!(unread, 2, "{alone}");
    assert_eq!(alone["missing"].as_array().map(Vec::len), Some(3), "{alone}");
    assert_eq!(alone["timing"], Value::Null, "there is no verdict without all nodes");
    beside(&mut workbench, "network/island.eds");
    beside(&mut workbench, "network/servo.eds");
    let view = network(&mut workbench);
    assert_eq!(view["report"]["summary"]["errors"], 0, "{view}");
    assert_eq!(view["overview"]["nodes"].as_array().map(Vec::len), Some(4));
    assert_eq!(view["links"][1]["to"], json!(["left.6200:1-2", "right.6200:1"]));
    assert!(view["picture"].as_str().is_some_and(|picture| picture.starts_with("<svg")));
    assert_eq!(view["timing"]["bit_rate"], 250);

    // a description that is edited counts as it is now: a link has lost its entry
    let remove =
        json!({ "do": "change", "document": 2, "changes": [{ "change": "remove", "at": "0x6041" }] });
    ok(&mut workbench, remove);
    assert_ne!(network(&mut workbench)["report"]["summary"]["errors"], 0);
}

#[test]
fn links_are_edits_of_the_text() {
    let mut workbench = with("network/line.toml");
    beside(&mut workbench, "network/island.eds");
    beside(&mut workbench, "network/servo.eds");
    let before = text(&mut workbench);
    let link = |workbench: &mut Workbench, link: Value| {
        ok(workbench, json!({ "do": "link", "document": 0, "link": link }));
        text(workbench)
    };
    let added = link(&mut workbench, json!({ "change": "add", "from": "left.6000:6", "to": "right.6200:2" }));
    assert_eq!(added, format!("{before}\n[[link]]\nfrom = \"left.6000:6\"\nto = \"right.6200:2\"\n"));
    let moved = link(&mut workbench, json!({ "change": "move", "link": 1, "end": 2, "to": "right.6200:3" }));
    assert_eq!(changed(&added, &moved), ["to = [\"left.6200:1-2\", \"right.6200:3\"]"]);
    let removed = link(&mut workbench, json!({ "change": "remove", "link": 0 }));
    let table = "[[link]]\nfrom = \"left.6000:1-5\"\nto = \"plc\"\ntransmission = \"sync/1\"\n\n";
    assert_eq!(removed, moved.replace(table, ""));
    for _ in 0..3 {
        ok(&mut workbench, json!({ "do": "undo", "document": 0 }));
    }
    assert_eq!(text(&mut workbench), before);

    // a comment above the next table stays, and a text without a place for links is refused
    let mut workbench = Workbench::new();
    let text_with_comment = "[bus]\nmanager = \"a\"\n[[link]]\nfrom = \"a.6000\"\n\nto = \"b\"\n# of b\n[node.b]\nfile = \"b.eds\"\n";
    workbench.call(r#"{"do":"open","name":"network.toml"}"#, text_with_comment.as_bytes().to_vec());
    let removed = link(&mut workbench, json!({ "change": "remove", "link": 0 }));
    assert_eq!(removed, "[bus]\nmanager = \"a\"\n# of b\n[node.b]\nfile = \"b.eds\"\n");
    for (name, text) in [
        ("bus.yml", "master:\n  node_id: 1\n"),
        ("network.toml", "link = [{ from = \"a.6000\", to = \"b\" }]\n"),
    ] {
        let mut workbench = Workbench::new();
        workbench.call(&json!({ "do": "open", "name": name }).to_string(), text.as_bytes().to_vec());
        let link = json!({ "change": "add", "from": "a.6000", "to": "b.6200" });
        let refused = ask(&mut workbench, json!({ "do": "link", "document": 0, "link": link }));
        assert_eq!(refused["error"]["message"], "the text has no place for this link", "{name}");
    }
}

#[test]
fn a_network_of_descriptions_is_built() {
    let mut workbench = with("network/line.toml");
    beside(&mut workbench, "network/island.eds");
    beside(&mut workbench, "network/servo.eds");
    let made = ok(&mut workbench, json!({ "do": "build", "document": 0 }));
    let files: Vec<&str> = made["files"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for name in [
        "lely/master.dcf",
        "concise/left.cdcf",
        "dcf/servo.dcf",
        "busyml/bus.yml",
        "cpj/nodelist.cpj",
        "network.svg",
    ] {
        assert!(files.contains(&name), "{name}: {files:?}");
    }
    let opened = ok(&mut workbench, json!({ "do": "new-network" }));
    assert_eq!(opened["state"]["kind"], "network");
    assert!(
        opened["state"]["text"].as_str().is_some_and(|text| text.contains("file = \"island.eds\"")),
        "{opened}"
    );
    let number = opened["document"].clone();
    let view = ok(&mut workbench, json!({ "do": "network", "document": number }));
    assert_eq!(view["overview"]["nodes"].as_array().map(Vec::len), Some(2));
}

#[test]
fn a_log_is_read_in_words() {
    for (log, frames) in [
        ("drive.asc", None),
        ("short.blf", None),
        ("short.csv", None),
        ("short.pcap", None),
        ("short.trc", None),
        ("cell.log", None),
        ("broken.log", Some(2)),
    ] {
        let mut workbench = with("eds/drive-402.eds");
        let number = beside(&mut workbench, &format!("logs/{log}"));
        let summary = ok(&mut workbench, json!({ "do": "decode", "document": number, "with": [0] }));
        let rows = summary["rows"].as_u64().unwrap_or_default();
        assert!(rows > 0 && frames.is_none_or(|frames| frames == rows), "{log}: {summary}");
        let all = ok(&mut workbench, json!({ "do": "frames", "document": number, "count": 1000 }));
        assert_eq!(all["total"], rows);
    }
    // with a network, and with filters
    let mut workbench = with("network/line.toml");
    beside(&mut workbench, "network/island.eds");
    beside(&mut workbench, "network/servo.eds");
    let log = "(0.1) can0 70B#05\n(0.2) can0 70C#05\nnoise\n(0.3) can0 18D#3702\n";
    let opened = workbench.call(r#"{"do":"open","name":"pasted.log"}"#, log.as_bytes().to_vec());
    assert!(opened.contains(r#""kind":"log""#), "{opened}");
    let summary = ok(&mut workbench, json!({ "do": "decode", "document": 3, "with": [0] }));
    assert_eq!((&summary["rows"], &summary["bad_lines"][0][0]), (&json!(3), &json!(3)));
    let frames = |workbench: &mut Workbench, filter: Value| {
        ok(workbench, json!({ "do": "frames", "document": 3, "filter": filter, "count": 10 }))
    };
    let heartbeats = frames(&mut workbench, json!({ "kinds": ["heartbeat"], "nodes": [11] }));
    assert_eq!(heartbeats["total"], 1);
    assert!(
        heartbeats["rows"][0]["cells"][4].as_str().is_some_and(|words| words == "left: operational"),
        "{heartbeats}"
    );
    assert_eq!(frames(&mut workbench, json!({ "text": "70c" }))["rows"][0]["line"], 2);
    let later = ok(&mut workbench, json!({ "do": "frames", "document": 3, "count": 10, "line": 3 }));
    assert_eq!((&later["first"], &later["rows"][0]["line"]), (&json!(2), &json!(4)));
    // read again with other descriptions, the rows of a filter are new
    let left = json!({ "text": "left" });
    assert_eq!(frames(&mut workbench, left.clone())["total"], 1);
    ok(&mut workbench, json!({ "do": "decode", "document": 3, "with": [] }));
    assert_eq!(frames(&mut workbench, left)["total"], 0);
}

#[test]
fn a_node_is_configured() {
    let mut workbench = with("eds/io-401.eds");
    let node = json!({ "name": "door.dcf", "node_id": 5, "bit_rate": 250, "settings": ["1017=250"] });
    let opened = ok(&mut workbench, json!({ "do": "configure", "document": 0, "node": node }));
    let text = opened["state"]["text"].as_str().unwrap_or_default();
    assert!(text.contains("NodeID=5") && text.contains("ParameterValue=250"), "{text}");
    let wrong = json!({ "name": "door.dcf", "node_id": 5, "settings": ["1017=70000"] });
    assert!(
        ask(&mut workbench, json!({ "do": "configure", "document": 0, "node": wrong }))["error"].is_object()
    );

    let coupler = beside(&mut workbench, "eds/coupler-modular.eds");
    let modules = ok(&mut workbench, json!({ "do": "modules", "document": coupler }));
    let first = modules["supported"][0]["number"].clone();
    let node = json!({ "name": "rack.dcf", "node_id": 6, "modules": [first, first] });
    let opened = ok(&mut workbench, json!({ "do": "configure", "document": coupler, "node": node }));
    let plugged = ok(&mut workbench, json!({ "do": "modules", "document": opened["document"] }));
    assert_eq!(plugged["connected"], json!([first, first]));
}

#[test]
fn refusals_are_answers() {
    let mut workbench = with("eds/minimal.eds");
    let bytes: [&[u8]; 4] = [b"", b"\0\xFF\xFE", b"<script>alert(1)</script>", b"{\"version\": 1}"];
    for bytes in bytes {
        let answer = workbench.call(r#"{"do":"open","name":"x.eds"}"#, bytes.to_vec());
        assert!(answer.starts_with("{\"ok\"") || answer.starts_with("{\"error\""), "{answer}");
    }
    for request in [
        "",
        "{}",
        r#"{"do":"fly"}"#,
        r#"{"do":"state","document":99}"#,
        r#"{"do":"generate","document":0,"target":"x"}"#,
    ] {
        let answer = workbench.call(request, Vec::new());
        assert!(answer.starts_with(r#"{"error":{"message":"#), "{request}: {answer}");
    }
    assert!(workbench.take(7).is_empty());
}

/// Every fixture is opened, described, checked and saved, or refused in words.
#[test]
fn every_fixture_is_answered() {
    let mut files = Vec::new();
    collect(&fixtures(), &mut files);
    let mut opened = 0;
    for path in &files {
        // large ones are for tests of speed
        let Some(bytes) = fs::read(path).ok().filter(|bytes| bytes.len() < 10_000) else { continue };
        let mut workbench = Workbench::new();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
        let answer = workbench.call(&json!({ "do": "open", "name": name }).to_string(), bytes.clone());
        if answer.contains(r#""kind":"network""#) {
            ok(&mut workbench, json!({ "do": "network", "document": 0 }));
            ask(&mut workbench, json!({ "do": "build", "document": 0 }));
            continue;
        }
        if answer.contains(r#""kind":"log""#) {
            ok(&mut workbench, json!({ "do": "decode", "document": 0, "with": [] }));
            continue;
        }
        if !answer.starts_with("{\"ok\"") {
            continue;
        }
        opened += 1;
        let outline = ok(&mut workbench, json!({ "do": "outline", "document": 0 }));
        for object in outline["objects"].as_array().into_iter().flatten().take(20) {
            ok(&mut workbench, json!({ "do": "form", "document": 0, "index": object["index"] }));
        }
        ask(&mut workbench, json!({ "do": "fix-all", "document": 0 }));
        for name in ["a.eds", "a.dcf", "a.xdd", "a.xdc", "a.toml"] {
            ask(&mut workbench, json!({ "do": "save", "document": 0, "name": name, "node_id": 5 }));
        }
    }
    assert!(opened > 50, "{opened} of {}", files.len());
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.filter_map(Result::ok).map(|entry| entry.path()) {
        match path.is_dir() {
            // what rules are about is in patches of bases
            true if path.ends_with("rules") => {}
            true => collect(&path, files),
            false => files.push(path),
        }
    }
}

#[test]
fn objects_are_inserted_and_copied_into_the_text_and_its_list() {
    let mut workbench = with("eds/drive-402.eds");
    let entry = json!({ "name": "Lower", "object_type": "VAR", "data_type": "UNSIGNED8", "access": "rw", "pdo_mapping": "optional" });
    let object =
        json!({ "name": "Zone", "object_type": "RECORD", "sub_number": 1, "subs": { "0x01": entry } });
    let insert = json!({ "do": "insert", "document": 0, "objects": [[0x2F00, object]] });
    ok(&mut workbench, insert.clone());
    let now = text(&mut workbench);
    assert!(now.contains("SupportedObjects=19") && now.contains("=0x2F00"), "{now}");
    assert!(!now.contains("objdict-embed"), "{now}");
    assert_eq!(ask(&mut workbench, insert)["error"]["message"], "the device has 2F00h already");
    for fixture in ["eds/io-401.eds", "xdd/io-401.xdd"] {
        let other = beside(&mut workbench, fixture);
        ok(&mut workbench, json!({ "do": "copy", "document": other, "from": 0, "indexes": [0x2F00] }));
        let form = ok(&mut workbench, json!({ "do": "form", "document": other, "index": 0x2F00 }));
        assert_eq!(form["parts"][1]["name"], "Lower", "{fixture}: {form}");
    }
}

#[test]
fn facts_and_settings_are_those_of_the_file() {
    let mut workbench = with("dcf/drive-402-node8.dcf");
    let facts = ok(&mut workbench, json!({ "do": "facts", "document": 0 }));
    let field = |part: usize, name: &str| {
        let fields = facts[part]["fields"].as_array().cloned().unwrap_or_default();
        fields.into_iter().find(|field| field["name"] == name).map(|field| field["text"].clone())
    };
    assert_eq!(field(0, "FileName"), Some(json!("drive-402-node8.dcf")));
    assert_eq!(field(1, "BaudRate_125"), Some(json!("1")));
    assert_eq!(field(2, "NodeID"), Some(json!("8")));
    let settings = ok(&mut workbench, json!({ "do": "settings", "document": 0 }));
    let indexes = settings.as_array().into_iter().flatten().map(|row| row["index"].as_u64());
    let indexes: Vec<Option<u64>> = indexes.collect();
    assert!(indexes.contains(&Some(0x1017)) && !indexes.contains(&Some(0x1000)), "{settings}");
}

#[test]
fn the_text_is_explained_as_by_the_language_server() {
    let mut workbench = with("eds/drive-402.eds");
    let at = text(&mut workbench).lines().position(|line| line.starts_with("AccessType="));
    let about = |ask: &str| json!({ "do": "language", "document": 0, "about": { "ask": ask, "line": at, "character": 11 } });
    let items = ok(&mut workbench, about("completion"));
    let labels =
        items.as_array().into_iter().flatten().map(|item| item["label"].as_str().unwrap_or_default());
    assert!(labels.collect::<Vec<_>>().contains(&"const"), "{items}");
    let hover = ok(&mut workbench, about("hover"));
    assert!(hover["contents"]["value"].as_str().is_some_and(|text| text.contains("1000h")), "{hover}");
    let tokens = ok(&mut workbench, json!({ "do": "language", "document": 0, "about": { "ask": "tokens" } }));
    assert!(tokens["tokens"]["data"].as_array().is_some_and(|data| data.len() > 1000));
    // the text as it is now
    ok(
        &mut workbench,
        json!({ "do": "change", "document": 0, "changes": [{ "change": "set", "at": "0x1000 / ParameterName", "value": "Kind of drive" }] }),
    );
    let hover = ok(&mut workbench, about("hover"));
    assert!(
        hover["contents"]["value"].as_str().is_some_and(|text| text.contains("Kind of drive")),
        "{hover}"
    );
}

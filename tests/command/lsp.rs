//! `objdict lsp` over standard input and output: a recorded session, message by message.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

/// What time it is for the programs, in seconds.
const EPOCH: &str = "1790000000";

struct Session {
    server: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    /// What was said, a line each.
    log: String,
}

impl Session {
    fn start() -> Self {
        let mut command = Command::new(crate::program());
        let command = command.env("SOURCE_DATE_EPOCH", EPOCH);
        let mut server = command.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let input = server.stdin.take().unwrap();
        let output = BufReader::new(server.stdout.take().unwrap());
        Self { server, input, output, log: String::new() }
    }

    fn send(&mut self, message: &Value) {
        self.log += &format!("→ {}\n", brief(message));
        let text = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
        self.input.flush().unwrap();
    }

    /// Takes the next message.
    fn receive(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            assert!(self.output.read_line(&mut line).unwrap() > 0, "the server is gone:\n{}", self.log);
            match line.trim().strip_prefix("Content-Length: ") {
                Some(digits) => length = digits.parse().unwrap(),
                None if line.trim().is_empty() => break,
                None => {}
            }
        }
        let mut text = vec![0; length];
        self.output.read_exact(&mut text).unwrap();
        let message: Value = serde_json::from_slice(&text).unwrap();
        self.log += &format!("← {}\n", brief(&message));
        message
    }

    /// Sends a request and takes its answer.
    fn ask(&mut self, id: u32, method: &str, params: &Value) -> Value {
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        self.receive()
    }

    fn note(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }
}

/// A message, with long texts cut.
fn brief(message: &Value) -> String {
    let mut shown = message.clone();
    shown.as_object_mut().unwrap().remove("jsonrpc");
    if let Some(info) = shown.pointer_mut("/result/serverInfo/version") {
        *info = json!("VERSION");
    }
    cut(&mut shown);
    shown.to_string()
}

fn cut(value: &mut Value) {
    match value {
        Value::String(text) if text.chars().count() > 120 => {
            *text = text.chars().take(120).chain(['…']).collect();
        }
        Value::Array(items) => items.iter_mut().for_each(cut),
        Value::Object(fields) => fields.values_mut().for_each(cut),
        _ => {}
    }
}

#[test]
fn a_session_over_standard_input_and_output() {
    let mut session = Session::start();
    let document = json!({ "uri": "file:///nowhere/lamp.eds" });
    let text = "[2000]\nParameterName=Brightness\nObjectType=0x7\nDataType=0x0005\nAccessType=rw\nDefaultValue=300\nPDOMapping=0\n";
    session.ask(1, "initialize", &json!({ "capabilities": {}, "processId": null, "rootUri": null }));
    session.note("initialized", &json!({}));
    let opened =
        json!({ "uri": "file:///nowhere/lamp.eds", "languageId": "eds", "version": 1, "text": text });
    session.note("textDocument/didOpen", &json!({ "textDocument": opened }));
    session.receive();
    let at = |line: u32, character: u32| json!({ "textDocument": document, "position": { "line": line, "character": character } });
    session.ask(2, "textDocument/hover", &at(3, 10));
    session.ask(3, "textDocument/completion", &at(4, 11));
    session.ask(4, "textDocument/documentSymbol", &json!({ "textDocument": document }));
    let text = text.replace("300", "30");
    let changed = json!({ "uri": "file:///nowhere/lamp.eds", "version": 2 });
    session.note(
        "textDocument/didChange",
        &json!({ "textDocument": changed, "contentChanges": [{ "text": text }] }),
    );
    session.receive();
    session.ask(5, "shutdown", &Value::Null);
    session.note("exit", &Value::Null);
    assert!(session.server.wait().unwrap().success());
    insta::assert_snapshot!(session.log);
}

#[test]
fn a_new_file_begins_as_objdict_new_writes_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(crate::program());
    let command = command.args(["new", "--profile", "301", "-o", "new.eds"]).current_dir(folder.path());
    assert!(command.env("SOURCE_DATE_EPOCH", EPOCH).output().unwrap().status.success());
    let mut session = Session::start();
    let uri = "file:///nowhere/new.eds";
    session.ask(1, "initialize", &json!({ "capabilities": {}, "processId": null, "rootUri": null }));
    session.note("initialized", &json!({}));
    let opened = json!({ "uri": uri, "languageId": "eds", "version": 1, "text": "" });
    session.note("textDocument/didOpen", &json!({ "textDocument": opened }));
    session.receive();
    let start = json!({ "line": 0, "character": 0 });
    let items = session.ask(
        2,
        "textDocument/completion",
        &json!({ "textDocument": { "uri": uri }, "position": start }),
    );
    let items = items["result"].as_array().unwrap();
    let item = items.iter().find(|item| item["label"] == "[FileInfo] a device of CiA 301").unwrap();
    let written = std::fs::read_to_string(folder.path().join("new.eds")).unwrap();
    assert_eq!(item["textEdit"]["newText"].as_str().unwrap().replace('\r', ""), written.replace('\r', ""));
    session.ask(3, "shutdown", &Value::Null);
    session.note("exit", &Value::Null);
    assert!(session.server.wait().unwrap().success());
}

#[test]
fn a_client_that_is_gone_ends_the_server() {
    let output = Command::new(crate::program()).arg("lsp").stdin(Stdio::null()).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.stdout.is_empty() && said.starts_with("error: "), "{said}");
}

#[test]
fn what_is_no_message_is_refused_and_the_next_one_is_answered() {
    let mut session = Session::start();
    session.ask(1, "initialize", &json!({ "capabilities": {}, "processId": null, "rootUri": null }));
    session.note("initialized", &json!({}));
    let deep =
        format!(r#"{{"jsonrpc":"2.0","id":5,"method":"x","params":{}{}}}"#, "[".repeat(200), "]".repeat(200));
    let deep = format!("Content-Length: {}\r\n\r\n{deep}", deep.len());
    let damaged = [
        (deep.as_str(), -32700),
        ("Content-Length: x\r\n\r\n{}", -32700),
        ("Content-Length: 99999999999999999\r\n\r\n{}", -32700),
        ("Content-Length: 10\r\n\r\n{\"id\": 7, \"method\": \"too short\"}", -32700),
        ("Content-Length: 2\r\n\r\n{}", -32600),
        ("no header\r\nContent-Length: 1\r\n\r\n\u{7}", -32700),
    ];
    for (number, (text, code)) in damaged.into_iter().enumerate() {
        session.input.write_all(text.as_bytes()).unwrap();
        let refused = session.receive();
        assert_eq!(
            (&refused["id"], &refused["error"]["code"]),
            (&Value::Null, &json!(code)),
            "{text}: {refused}"
        );
        let answer = session.ask(number as u32 + 10, "workspace/symbol", &json!({ "query": "" }));
        assert_eq!(answer["id"], json!(number + 10), "{answer}");
    }
}

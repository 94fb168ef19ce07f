//! An editor that changes a file again and again: the server keeps its newest text and what was found in it, and nothing of those
//! before.

use std::env;
use std::fmt::Write as _;
use std::process::Command;
use std::time::Duration;

use lsp_server::{Connection, Message, Notification, Request};
use serde_json::{Value, json};

use super::{ALLOCATOR, bombs};

/// The edits that are measured, after as many that are not; `OBJDICT_EDITS` names another number, such as 1000.
const EDITS: usize = 8;

/// The size of the text that is edited.
const TEXT: usize = 500_000;

/// What the heap may differ by after each edit: far less than a text, a finding and its place take.
const PER_EDIT: usize = 1_000;

/// What a process is asked to do: the number of edits, and `leak` for a client that keeps each text.
const SESSION: &str = "OBJDICT_MEMORY_SESSION";

#[test]
fn edits_leave_nothing_behind() {
    let edits = env::var("OBJDICT_EDITS").ok().and_then(|edits| edits.parse().ok()).unwrap_or(EDITS);
    let grown = growth(edits, "");
    assert!(grown < edits * PER_EDIT, "{grown} bytes more after {edits} edits");
    // what is left behind is seen
    let grown = growth(2, "leak");
    assert!(grown >= 2 * TEXT, "{grown} bytes");
}

/// How much larger the heap of a process is after edits.
fn growth(edits: usize, fault: &str) -> usize {
    let mut command = Command::new(env::current_exe().unwrap());
    command.args(["--exact", "editing::session", "--nocapture", "--test-threads=1"]);
    let output = command.env(SESSION, format!("{edits} {fault}")).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    println!("{edits} edits {fault}: {text}");
    text.lines().find_map(|line| line.split_once("grown: ")).unwrap().1.parse().unwrap()
}

/// What the process does; without a session nothing.
#[test]
fn session() {
    let Ok(session) = env::var(SESSION) else { return };
    let (edits, fault) = session.split_once(' ').unwrap();
    let edits: usize = edits.parse().unwrap();
    let (client, other) = Connection::memory();
    let server = std::thread::spawn(move || objdict_lsp::serve(&other).unwrap());
    let request = |id: i32, method: &str, params: Value| {
        client.sender.send(Request::new(id.into(), method.to_owned(), params).into()).unwrap();
    };
    let note = |method: &str, params: Value| {
        client.sender.send(Notification::new(method.to_owned(), params).into()).unwrap();
    };
    let next = || client.receiver.recv_timeout(Duration::from_secs(120)).unwrap();
    request(1, "initialize", json!({ "capabilities": {} }));
    next();
    note("initialized", json!({}));
    let text = large();
    let uri = "file:///nowhere/large.eds";
    let opened = json!({ "uri": uri, "languageId": "eds", "version": 0, "text": text });
    note("textDocument/didOpen", json!({ "textDocument": opened }));
    next();
    let edit = |number: usize| {
        let document = json!({ "uri": uri, "version": number });
        let change = json!({ "text": format!("{text}; edit {number:6}\n") });
        note("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
        assert!(matches!(next(), Message::Notification(_)));
        // an answer to a question about the text comes when all of it is done
        let number = i32::try_from(number).unwrap() + 10;
        request(number, "textDocument/foldingRange", json!({ "textDocument": { "uri": uri } }));
        next();
    };
    (1..=edits.min(EDITS)).for_each(edit);
    let before = ALLOCATOR.allocated();
    for number in 1..=edits {
        edit(edits + number);
        if fault == "leak" {
            Box::leak(text.clone().into_boxed_str());
        }
    }
    println!("grown: {}", ALLOCATOR.allocated().saturating_sub(before));
    request(2, "shutdown", Value::Null);
    next();
    note("exit", Value::Null);
    server.join().unwrap();
}

/// A device of records of the vendor.
fn large() -> String {
    let mut text =
        std::fs::read_to_string(bombs::fixtures().join("eds/minimal.eds")).unwrap().replace('\r', "");
    let mut index = 0x2000;
    while text.len() < TEXT {
        let _ = write!(text, "\n[{index:X}]\nParameterName=Axis {index:X}\nObjectType=0x9\nSubNumber=9\n");
        for sub in 0..9 {
            let (data_type, access) = if sub == 0 { (5, "const") } else { (7, "rw") };
            let _ = write!(
                text,
                "\n[{index:X}sub{sub}]\nParameterName=Gain {sub}\nObjectType=0x7\nDataType=0x{data_type:04X}\n\
                 AccessType={access}\nDefaultValue=8\nPDOMapping=0\n"
            );
        }
        index += 1;
    }
    text
}

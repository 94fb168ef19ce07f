//! An editor at the other end of the server, in this process.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::thread::JoinHandle;
use std::time::Duration;

use lsp_server::{Connection, Message, Notification, Request, RequestId, Response};
use serde_json::{Value, json};

/// A client with a folder of files.
pub(crate) struct Client {
    connection: Connection,
    server: Option<JoinHandle<()>>,
    folder: tempfile::TempDir,
    next: i32,
    /// The texts of the open files.
    texts: BTreeMap<String, String>,
    /// The findings of each file that were published last.
    published: BTreeMap<String, Value>,
    /// What the server asked last, by method.
    requested: BTreeMap<String, Value>,
    /// What the server said that it offers.
    pub(crate) offered: Value,
}

impl Client {
    pub(crate) fn start() -> Self {
        Self::start_with(&json!({ "workspace": { "symbol": {} } }))
    }

    /// A client with these capabilities.
    pub(crate) fn start_with(capabilities: &Value) -> Self {
        Self::start_as(capabilities, &Value::Null)
    }

    /// A client with these capabilities and options of the server.
    pub(crate) fn start_as(capabilities: &Value, options: &Value) -> Self {
        let (connection, other) = Connection::memory();
        let server = std::thread::spawn(move || objdict_lsp::serve(&other).unwrap());
        let folder = tempfile::tempdir().unwrap();
        let server = Some(server);
        let mut client = Self {
            connection,
            server,
            folder,
            next: 0,
            texts: BTreeMap::new(),
            published: BTreeMap::new(),
            requested: BTreeMap::new(),
            offered: Value::Null,
        };
        let root = json!({ "uri": client.uri(""), "name": "folder" });
        let params = json!({ "capabilities": capabilities, "workspaceFolders": [root], "initializationOptions": options });
        client.offered = client.ask("initialize", params);
        client.note("initialized", json!({}));
        client
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().canonicalize().unwrap().join(name)
    }

    /// Writes a file to the disk.
    pub(crate) fn write(&self, name: &str, text: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), text).unwrap();
    }

    pub(crate) fn uri(&self, name: &str) -> String {
        format!("file://{}", self.path(name).display())
    }

    pub(crate) fn document(&self, name: &str) -> Value {
        json!({ "uri": self.uri(name) })
    }

    pub(crate) fn note(&self, method: &str, params: Value) {
        self.connection.sender.send(Notification::new(method.to_owned(), params).into()).unwrap();
    }

    /// Opens a file, and returns its findings.
    pub(crate) fn open(&mut self, name: &str, text: &str) -> Value {
        let document = json!({ "uri": self.uri(name), "languageId": "x", "version": 0, "text": text });
        self.note("textDocument/didOpen", json!({ "textDocument": document }));
        self.texts.insert(name.to_owned(), text.to_owned());
        self.findings(name)
    }

    /// Sends what a new text of an open file has of its own, as editors do.
    pub(crate) fn send_change(&mut self, name: &str, text: &str) {
        self.next += 1;
        let document = json!({ "uri": self.uri(name), "version": self.next });
        let unit = self.offered["capabilities"]["positionEncoding"].as_str().unwrap();
        let old = self.texts.insert(name.to_owned(), text.to_owned()).unwrap();
        let change = difference(&old, text, unit == "utf-8");
        self.note("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
    }

    /// Changes an open file, and returns its findings.
    pub(crate) fn change(&mut self, name: &str, text: &str) -> Value {
        self.send_change(name, text);
        self.findings(name)
    }

    /// The findings that are published next for a file.
    pub(crate) fn findings(&mut self, name: &str) -> Value {
        let uri = self.uri(name);
        self.published.remove(&uri);
        loop {
            if let Some(found) = self.published.get(&uri) {
                return found.clone();
            }
            let other = self.receive();
            assert!(other.is_none(), "nothing was asked: {other:?}");
        }
    }

    pub(crate) fn send_request(&mut self, method: &str, params: Value) -> RequestId {
        self.next += 1;
        let id = RequestId::from(self.next);
        self.connection.sender.send(Request::new(id.clone(), method.to_owned(), params).into()).unwrap();
        id
    }

    /// The answer to a request.
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> Value {
        let id = self.send_request(method, params);
        self.answer_to(&id).response_result.unwrap_or_else(|error| panic!("{method}: {error:?}"))
    }

    pub(crate) fn answer_to(&mut self, id: &RequestId) -> Response {
        loop {
            match self.receive() {
                Some(response) if response.id == *id => return response,
                Some(other) => panic!("an answer to another request: {other:?}"),
                None => {}
            }
        }
    }

    /// Takes the next message; returns an answer.
    fn receive(&mut self) -> Option<Response> {
        match self.connection.receiver.recv_timeout(Duration::from_secs(60)).unwrap() {
            Message::Response(response) => return Some(response),
            Message::Notification(note) if note.method == "textDocument/publishDiagnostics" => {
                let uri = note.params["uri"].as_str().unwrap().to_owned();
                self.published.insert(uri, note.params["diagnostics"].clone());
            }
            Message::Notification(_) => {}
            Message::Request(request) => {
                self.requested.insert(request.method, request.params);
                let _ = self.connection.sender.send(Response::new_ok(request.id, ()).into());
            }
        }
        None
    }

    /// What the server asks next by a method.
    pub(crate) fn request(&mut self, method: &str) -> Value {
        loop {
            if let Some(params) = self.requested.remove(method) {
                return params;
            }
            let other = self.receive();
            assert!(other.is_none(), "nothing was asked: {other:?}");
        }
    }

    /// An answer without the folder of this run.
    pub(crate) fn plain(&self, answer: &Value) -> Value {
        let text = answer.to_string().replace(&self.uri(""), "file:///folder/");
        let text = text.replace(&self.path("").display().to_string(), "/folder/");
        serde_json::from_str(&text).unwrap()
    }
}

impl Drop for Client {
    fn drop(&mut self) {
        if std::thread::panicking() {
            return;
        }
        self.ask("shutdown", Value::Null);
        self.note("exit", Value::Null);
        self.server.take().unwrap().join().unwrap();
    }
}

/// A text without its mark `‸`, and the position of the mark.
pub(crate) fn marked(text: &str) -> (String, Value) {
    let at = text.find('‸').expect("a mark");
    (text.replacen('‸', "", 1), position(text, at))
}

/// The position of a byte.
pub(crate) fn position(text: &str, at: usize) -> Value {
    let before = &text[..at];
    let line = before.matches('\n').count();
    let column: usize = before.rsplit('\n').next().unwrap().chars().map(char::len_utf16).sum();
    json!({ "line": line, "character": column })
}

/// The position of the start of a part of a text.
pub(crate) fn position_of(text: &str, part: &str) -> Value {
    position(text, text.find(part).unwrap_or_else(|| panic!("no `{part}`")))
}

/// A text after edits.
pub(crate) fn edited(text: &str, edits: &Value) -> String {
    let offset = |position: &Value| {
        let (line, column) = (position["line"].as_u64().unwrap(), position["character"].as_u64().unwrap());
        let mut at = 0;
        for _ in 0..line {
            at += text[at..].find('\n').map_or(text.len() - at, |end| end + 1);
        }
        let mut left = column as usize;
        for c in text[at..].chars().take_while(|&c| c != '\n') {
            if left == 0 {
                break;
            }
            left -= c.len_utf16();
            at += c.len_utf8();
        }
        at
    };
    let mut edits: Vec<(usize, usize, &str)> = edits
        .as_array()
        .unwrap()
        .iter()
        .map(|edit| {
            let range = &edit["range"];
            (offset(&range["start"]), offset(&range["end"]), edit["newText"].as_str().unwrap())
        })
        .collect();
    edits.sort_by_key(|(start, end, _)| (*start, *end));
    let mut edited = String::new();
    let mut at = 0;
    for (start, end, new) in edits {
        edited += &text[at..start];
        edited += new;
        at = end;
    }
    edited + &text[at..]
}

/// A fixture, as an editor shows it.
pub(crate) fn fixture(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name);
    std::fs::read_to_string(path).unwrap()
}

/// The change between two texts, without what both have before it and behind it.
fn difference(old: &str, new: &str, counts_bytes: bool) -> Value {
    let is_border = |text: &str, at: usize| {
        text.is_char_boundary(at) && !(text[..at].ends_with('\r') && text[at..].starts_with('\n'))
    };
    let common = old.bytes().zip(new.bytes()).take_while(|(a, b)| a == b).count();
    let start = (0..=common).rev().find(|&at| is_border(old, at) && is_border(new, at)).unwrap();
    let ends = old[start..].bytes().rev().zip(new[start..].bytes().rev());
    let common = ends.take_while(|(a, b)| a == b).count();
    let both = |kept: usize| is_border(old, old.len() - kept) && is_border(new, new.len() - kept);
    let kept = (0..=common).rev().find(|&kept| both(kept)).unwrap();
    let position = |at: usize| {
        let mut lines = old[..at].replace("\r\n", "\n").replace('\r', "\n");
        let last = lines.split_off(lines.rfind('\n').map_or(0, |at| at + 1));
        let character = if counts_bytes { last.len() } else { last.encode_utf16().count() };
        json!({ "line": lines.matches('\n').count(), "character": character })
    };
    let range = json!({ "start": position(start), "end": position(old.len() - kept) });
    json!({ "range": range, "text": new[start..new.len() - kept] })
}

//! An editor that opens a file, edits it and asks at any position, behind the end of the text too.

use std::thread;

use lsp_server::{Connection, Message, Notification, Request, Response};
use serde_json::{Value, json};

use objdict::diagnostic::Findings;
use objdict::format::{self, Format};
use objdict::lint::{KnownObjects, Options};
use objdict::source::SourceFile;
use objdict::workspace::{findings, findings_after};

const FILE: &str = "file:///nowhere/fuzzed";

/// What editors ask, each with a position and a range.
const REQUESTS: [&str; 14] = [
    "textDocument/hover",
    "textDocument/completion",
    "textDocument/definition",
    "textDocument/references",
    "textDocument/prepareRename",
    "textDocument/rename",
    "textDocument/selectionRange",
    "textDocument/inlayHint",
    "textDocument/documentSymbol",
    "textDocument/foldingRange",
    "textDocument/documentLink",
    "textDocument/semanticTokens/full",
    "textDocument/codeAction",
    "textDocument/formatting",
];

/// Numbers that follow from the bytes of an input.
struct Numbers<'a> {
    state: u64,
    bytes: &'a [u8],
}

impl Numbers<'_> {
    fn below(&mut self, end: usize) -> usize {
        let byte = self.bytes.split_off_first().copied().unwrap_or_default();
        self.state = self.state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(u64::from(byte) + 1);
        usize::try_from((self.state >> 33) % (end.max(1) as u64)).unwrap_or_default()
    }

    /// A position in a text of so many lines, behind a line, or behind all lines.
    fn position(&mut self, lines: usize) -> Value {
        let line =
            if self.below(10) == 0 { u32::MAX as usize - self.below(2) } else { self.below(lines + 2) };
        let character = if self.below(10) == 0 { u32::MAX as usize } else { self.below(40) };
        json!({ "line": line, "character": character })
    }
}

/// Fails when what is read and found after an edit is not what a fresh start gives.
fn edited(format: Format, text: &str, numbers: &mut Numbers<'_>) {
    let source = |text: &str| SourceFile::from_text("fuzzed", text);
    let shown = |found: &[Findings]| {
        let found = found.iter().flatten();
        let shown =
            found.map(|one| format!("{} {} {:?} {:?}", one.rule.id, one.message, one.labels, one.fix));
        shown.collect::<Vec<_>>()
    };
    let (mut text, mut known, options) = (text.to_owned(), KnownObjects::default(), Options::default());
    let mut before = format::read(source(&text), format);
    findings_after(&before, &options, &mut known);
    for _ in 0..3 {
        let place = |at: usize| (at..text.len()).find(|&at| text.is_char_boundary(at)).unwrap_or(text.len());
        let start = place(numbers.below(text.len()));
        let end = place(start + numbers.below(100));
        let copied = place(numbers.below(text.len()));
        let new: String = text[copied..].chars().take(numbers.below(60)).collect();
        text.replace_range(start..end, &new);
        let fresh = format::read(source(&text), format);
        before = format::read_after(source(&text), format, Some(&before));
        assert!(before.described() == fresh.described(), "the device is the one that is read at once");
        let found = findings_after(&before, &options, &mut known);
        assert_eq!(shown(&found), shown(&findings(&fresh, &options)), "a check finds the same");
    }
}

/// Fails when the server ends early, or answers a request twice or never, or an edit is read otherwise than the text after it.
pub(super) fn run(format: Format, bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    edited(format, &text, &mut Numbers { state: bytes.len() as u64, bytes });
    let lines = text.matches('\n').count();
    let mut numbers = Numbers { state: bytes.len() as u64, bytes };
    let (client, server) = Connection::memory();
    thread::scope(|scope| {
        let served = scope.spawn(move || objdict_lsp::serve(&server));
        let send = |message: Message| client.sender.send(message).expect("the server listens");
        let note = |method: &str, params: Value| send(Notification::new(method.to_owned(), params).into());
        let mut asked = 0;
        let mut ask = |method: &str, params: Value| {
            asked += 1;
            send(Request::new(asked.into(), method.to_owned(), params).into());
        };
        let uri = format!("{FILE}.{}", format.name().to_ascii_lowercase());
        let document = json!({ "uri": uri });
        ask("initialize", json!({ "capabilities": {} }));
        note("initialized", json!({}));
        let opened = json!({ "uri": uri, "languageId": "x", "version": 0, "text": text });
        note("textDocument/didOpen", json!({ "textDocument": opened }));
        for version in 1..4 {
            let method = REQUESTS[numbers.below(REQUESTS.len())];
            let range = json!({ "start": numbers.position(lines), "end": numbers.position(lines) });
            let context = json!({ "includeDeclaration": true, "diagnostics": [] });
            let at = numbers.position(lines);
            ask(
                method,
                json!({
                    "textDocument": document, "position": at, "positions": [at], "range": range, "context": context,
                    "newName": "2001", "options": { "tabSize": 2, "insertSpaces": true },
                }),
            );
            let start = numbers.below(text.len());
            let new: String = text.chars().skip(start).take(numbers.below(60)).collect();
            let range = json!({ "start": numbers.position(lines), "end": numbers.position(lines) });
            let change = json!({ "range": range, "text": new });
            let changed = json!({ "uri": uri, "version": version });
            note("textDocument/didChange", json!({ "textDocument": changed, "contentChanges": [change] }));
        }
        ask("shutdown", Value::Null);
        note("exit", Value::Null);
        let answered: Vec<i32> = client.receiver.iter().filter_map(|message| answered(&message)).collect();
        assert_eq!(answered, Vec::from_iter(1..=asked), "each request has an answer");
        assert!(served.join().is_ok_and(|ending| ending.is_ok()), "the server ends when it is told to");
    });
}

/// The number of the request that a message answers.
fn answered(message: &Message) -> Option<i32> {
    let Message::Response(Response { id, .. }) = message else { return None };
    id.to_string().parse().ok()
}

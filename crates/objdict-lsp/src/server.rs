//! What the server offers, and its messages: requests are answered in their order, and findings are published when no newer text waits.

use std::collections::VecDeque;

use super::answers::answer;
use super::position::ColumnUnit;
use super::protocol::{
    Diagnostic, DidChange, DidChangeFolders, DidOpen, FIX_ALL, InFile, QUICKFIX, REFACTOR, WorkspaceFolder,
};
use super::uri::path_of;
use super::workspace::{ClientFeatures, EditorWorkspace};
use super::{actions, diagnostics, documentation, hints};
use lsp_server::{Connection, ErrorCode, Message, Notification, ProtocolError, Request, RequestId, Response};
use objdict_model::source::absolute;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

/// The files that findings depend on.
const FILES: &str = "**/*.{eds,dcf,xdd,xdc,nxdd,nxdc,toml,yml,yaml,cpj,json}";

/// Methods of messages without an answer.
const CANCEL: &str = "$/cancelRequest";
const CHANGED: &str = "textDocument/didChange";
const WATCHED: &str = "workspace/didChangeWatchedFiles";

/// Serves a client until it leaves.
///
/// # Errors
/// When the client does not follow the protocol.
pub fn serve(connection: &Connection) -> Result<(), ProtocolError> {
    let (id, params) = connection.initialize_start()?;
    let mut workspace = EditorWorkspace::default();
    workspace.unit = unit_of(&params);
    let folders = params["workspaceFolders"].as_array().into_iter().flatten();
    workspace.folders = folders.filter_map(|folder| path_of(folder["uri"].as_str()?)).collect();
    workspace.client = features_of(&params);
    let baseline = params["initializationOptions"]["baseline"].as_str();
    workspace.baseline =
        baseline.zip(workspace.folders.first()).map(|(name, folder)| absolute(&folder.join(name)));
    let info = json!({ "name": "objdict", "version": env!("CARGO_PKG_VERSION") });
    let answer = json!({ "capabilities": capabilities(workspace.unit), "serverInfo": info });
    connection.initialize_finish(id, answer)?;
    let mut server = Server { connection, workspace, is_shut_down: false };
    if can(&params, "workspace/didChangeWatchedFiles/dynamicRegistration") {
        server.watch();
    }
    server.run();
    if let Some(folder) = &server.workspace.pages {
        // pages that stay lie among temporary files
        let _ = std::fs::remove_dir_all(folder);
    }
    Ok(())
}

fn unit_of(params: &Value) -> ColumnUnit {
    let offered = params["capabilities"]["general"]["positionEncodings"].as_array();
    ColumnUnit::of(offered.into_iter().flatten().filter_map(Value::as_str))
}

fn features_of(params: &Value) -> ClientFeatures {
    let edit = &params["capabilities"]["workspace"]["workspaceEdit"];
    let creates = edit["resourceOperations"].as_array().is_some_and(|kinds| kinds.contains(&json!("create")));
    ClientFeatures {
        expands_snippets: can(params, "textDocument/completion/completionItem/snippetSupport"),
        creates_files: creates && can(params, "workspace/workspaceEdit/documentChanges"),
        shows_documents: can(params, "window/showDocument/support"),
    }
}

/// Whether a client has a capability.
fn can(params: &Value, path: &str) -> bool {
    params.pointer(&format!("/capabilities/{path}")) == Some(&Value::Bool(true))
}

struct Server<'a> {
    connection: &'a Connection,
    workspace: EditorWorkspace,
    is_shut_down: bool,
}

impl Server<'_> {
    fn run(&mut self) {
        let mut queue = VecDeque::new();
        loop {
            if queue.is_empty() {
                let Ok(message) = self.connection.receiver.recv() else { return };
                queue.push_back(message);
            }
            queue.extend(self.connection.receiver.try_iter());
            self.drop_cancelled(&mut queue);
            match queue.pop_front() {
                Some(Message::Notification(note)) if note.method == "exit" => return,
                Some(Message::Notification(note)) => self.take(note),
                Some(Message::Request(request)) => self.answer(request),
                Some(Message::Response(_)) | None => {}
            }
            // with a newer text, the findings of this one are of no use
            if !queue.iter().any(is_change) {
                self.publish();
            }
        }
    }

    /// Answers the waiting requests that the client has cancelled.
    fn drop_cancelled(&self, queue: &mut VecDeque<Message>) {
        let id = |message: &Message| match message {
            Message::Notification(note) if note.method == CANCEL => {
                serde_json::from_value(note.params.get("id")?.clone()).ok()
            }
            _ => None,
        };
        let cancelled: Vec<RequestId> = queue.iter().filter_map(id).collect();
        if cancelled.is_empty() {
            return;
        }
        queue.retain(|message| match message {
            Message::Request(request) if cancelled.contains(&request.id) => {
                let code = ErrorCode::RequestCanceled as i32;
                self.send(Response::new_err(request.id.clone(), code, "cancelled".to_owned()));
                false
            }
            Message::Notification(note) => note.method != CANCEL,
            _ => true,
        });
    }

    fn send(&self, message: impl Into<Message>) {
        // a client that is gone reads no answer
        let _ = self.connection.sender.send(message.into());
    }

    /// Takes a message without an answer.
    fn take(&mut self, note: Notification) {
        match &*note.method {
            "textDocument/didOpen" => {
                if let Some(DidOpen { text_document: opened }) = read(note) {
                    self.workspace.open(opened.uri, opened.version, opened.text);
                }
            }
            CHANGED => {
                if let Some(DidChange { text_document: changed, content_changes }) = read(note) {
                    self.workspace.change(&changed.uri, changed.version, content_changes);
                }
            }
            "textDocument/didClose" => {
                if let Some(InFile { text_document: closed }) = read(note) {
                    self.workspace.close(&closed.uri);
                    self.show(&closed.uri, &[], None);
                }
            }
            WATCHED | "textDocument/didSave" => self.workspace.forget_all(),
            "workspace/didChangeWorkspaceFolders" => {
                if let Some(DidChangeFolders { event }) = read(note) {
                    let paths = |folders: &[WorkspaceFolder]| -> Vec<_> {
                        folders.iter().filter_map(|folder| path_of(&folder.uri)).collect()
                    };
                    let removed = paths(&event.removed);
                    self.workspace.folders.retain(|folder| !removed.contains(folder));
                    self.workspace.folders.extend(paths(&event.added));
                }
            }
            _ => {}
        }
    }

    fn answer(&mut self, request: Request) {
        if request.method == "shutdown" {
            self.is_shut_down = true;
            return self.send(Response::new_ok(request.id, ()));
        }
        if self.is_shut_down {
            let code = ErrorCode::InvalidRequest as i32;
            return self.send(Response::new_err(request.id, code, "the server is shut down".to_owned()));
        }
        if let Some(response) = answer(&mut self.workspace, request) {
            self.send(response);
        }
        for request in std::mem::take(&mut self.workspace.requests) {
            self.send(request);
        }
    }

    /// Sends the findings of the open files that were not sent yet.
    fn publish(&mut self) {
        for (path, uri, version) in self.workspace.unknown() {
            let Some(analysis) = self.workspace.analysis(&path) else { continue };
            let found = diagnostics::of(&analysis, &uri, self.workspace.unit);
            self.show(&uri, &found, Some(version));
        }
    }

    /// Shows findings in a file, in place of those before.
    fn show(&self, uri: &str, found: &[Diagnostic], version: Option<i32>) {
        let mut params = json!({ "uri": uri, "diagnostics": found });
        if let Some(version) = version {
            params["version"] = json!(version);
        }
        self.send(Notification { method: "textDocument/publishDiagnostics".to_owned(), params });
    }

    /// Asks the client to say when files of the disk change.
    fn watch(&self) {
        let options = json!({ "watchers": [{ "globPattern": FILES }] });
        let registration = json!({ "id": "watched", "method": WATCHED, "registerOptions": options });
        let params = json!({ "registrations": [registration] });
        let id = RequestId::from("watch".to_owned());
        self.send(Request::new(id, "client/registerCapability".to_owned(), params));
    }
}

fn is_change(message: &Message) -> bool {
    matches!(message, Message::Notification(note) if note.method == CHANGED)
}

/// The parameters of a notification; `None` where they are not those of its method.
fn read<T: DeserializeOwned>(note: Notification) -> Option<T> {
    serde_json::from_value(note.params).ok()
}

pub(super) fn capabilities(unit: ColumnUnit) -> Value {
    json!({
        "positionEncoding": unit.name(),
        // 2: of a text, what changes
        "textDocumentSync": { "openClose": true, "change": 2, "save": {} },
        "hoverProvider": true,
        "completionProvider": { "resolveProvider": true, "triggerCharacters": ["[", "=", "/", ".", "\""] },
        "definitionProvider": true,
        "referencesProvider": true,
        "renameProvider": { "prepareProvider": true },
        "documentSymbolProvider": true,
        "workspaceSymbolProvider": true,
        "documentFormattingProvider": true,
        "foldingRangeProvider": true,
        "selectionRangeProvider": true,
        "documentLinkProvider": {},
        "codeLensProvider": {},
        "inlayHintProvider": true,
        "codeActionProvider": {
            "codeActionKinds": [QUICKFIX, REFACTOR, FIX_ALL, actions::FIX_ALL_UNSAFE, documentation::KIND],
            "resolveProvider": true,
        },
        "executeCommandProvider": { "commands": [documentation::PAGE, documentation::SHOW] },
        "semanticTokensProvider": {
            "legend": { "tokenTypes": hints::KINDS, "tokenModifiers": [] },
            "full": true,
        },
        "workspace": { "workspaceFolders": { "supported": true, "changeNotifications": true } },
    })
}

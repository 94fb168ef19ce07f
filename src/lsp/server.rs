//! Messages: requests are answered in their order, and findings are published when no newer text waits.

use std::collections::VecDeque;

use lsp_server::{Connection, ErrorCode, Message, Notification, ProtocolError, Request, RequestId, Response};
use lsp_types::notification::{
    Cancel, DidChangeTextDocument, DidChangeWatchedFiles, DidChangeWorkspaceFolders, DidCloseTextDocument,
    DidOpenTextDocument, DidSaveTextDocument, Exit, Notification as _, PublishDiagnostics,
};
use lsp_types::request::{RegisterCapability, Request as _, Shutdown};
use lsp_types::{
    CancelParams, DidChangeWatchedFilesRegistrationOptions, FileSystemWatcher, GlobPattern, InitializeParams,
    NumberOrString, PublishDiagnosticsParams, Registration, RegistrationParams, ResourceOperationKind,
};
use serde::de::DeserializeOwned;
use serde_json::json;

use super::answers::answer;
use super::capabilities::capabilities;
use super::diagnostics;
use super::position::ColumnUnit;
use super::uri::path_of;
use super::workspace::{ClientFeatures, Workspace};
use crate::source::absolute;

/// The files that findings depend on.
const WATCHED: &str = "**/*.{eds,dcf,xdd,xdc,nxdd,nxdc,toml,yml,yaml,cpj,json}";

/// Serves a client until it leaves.
///
/// # Errors
/// When the client does not follow the protocol.
pub fn serve(connection: &Connection) -> Result<(), ProtocolError> {
    let (id, params) = connection.initialize_start()?;
    let params: InitializeParams = serde_json::from_value(params).unwrap_or_default();
    let mut workspace = Workspace::default();
    workspace.unit = unit_of(&params);
    let folders = params.workspace_folders.iter().flatten();
    workspace.folders = folders.filter_map(|folder| path_of(&folder.uri)).collect();
    workspace.client = features_of(&params);
    let baseline = params.initialization_options.as_ref().and_then(|options| options["baseline"].as_str());
    workspace.baseline =
        baseline.zip(workspace.folders.first()).map(|(name, folder)| absolute(&folder.join(name)));
    let info = json!({ "name": "objdict", "version": env!("CARGO_PKG_VERSION") });
    let answer = json!({ "capabilities": capabilities(workspace.unit), "serverInfo": info });
    connection.initialize_finish(id, answer)?;
    let mut server = Server { connection, workspace, is_shut_down: false };
    if can_watch(&params) {
        server.watch();
    }
    server.run();
    if let Some(folder) = &server.workspace.pages {
        // pages that stay lie among temporary files
        let _ = std::fs::remove_dir_all(folder);
    }
    Ok(())
}

fn unit_of(params: &InitializeParams) -> ColumnUnit {
    let general = params.capabilities.general.as_ref();
    let offered = general.and_then(|general| general.position_encodings.as_deref());
    ColumnUnit::of(offered.unwrap_or_default())
}

fn features_of(params: &InitializeParams) -> ClientFeatures {
    let workspace = params.capabilities.workspace.as_ref();
    let edit = workspace.and_then(|workspace| workspace.workspace_edit.as_ref());
    let operations = edit.and_then(|edit| edit.resource_operations.as_deref()).unwrap_or_default();
    let has_documents = edit.is_some_and(|edit| edit.document_changes == Some(true));
    let window = params.capabilities.window.as_ref();
    let show = window.and_then(|window| window.show_document.as_ref());
    let text = params.capabilities.text_document.as_ref();
    let completion = text.and_then(|text| text.completion.as_ref());
    let item = completion.and_then(|completion| completion.completion_item.as_ref());
    ClientFeatures {
        expands_snippets: item.is_some_and(|item| item.snippet_support == Some(true)),
        creates_files: has_documents && operations.contains(&ResourceOperationKind::Create),
        shows_documents: show.is_some_and(|show| show.support),
    }
}

fn can_watch(params: &InitializeParams) -> bool {
    let workspace = params.capabilities.workspace.as_ref();
    let watching = workspace.and_then(|workspace| workspace.did_change_watched_files.as_ref());
    watching.is_some_and(|watching| watching.dynamic_registration == Some(true))
}

struct Server<'a> {
    connection: &'a Connection,
    workspace: Workspace,
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
                Some(Message::Notification(note)) if note.method == Exit::METHOD => return,
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
            Message::Notification(note) if note.method == Cancel::METHOD => {
                let params: CancelParams = serde_json::from_value(note.params.clone()).ok()?;
                Some(match params.id {
                    NumberOrString::Number(number) => RequestId::from(number),
                    NumberOrString::String(text) => RequestId::from(text),
                })
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
            Message::Notification(note) => note.method != Cancel::METHOD,
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
            DidOpenTextDocument::METHOD => {
                if let Some(params) = read::<DidOpenTextDocument>(note) {
                    let opened = params.text_document;
                    self.workspace.open(opened.uri, opened.version, opened.text);
                }
            }
            DidChangeTextDocument::METHOD => {
                if let Some(params) = read::<DidChangeTextDocument>(note) {
                    let changed = params.text_document;
                    self.workspace.change(&changed.uri, changed.version, params.content_changes);
                }
            }
            DidCloseTextDocument::METHOD => {
                if let Some(params) = read::<DidCloseTextDocument>(note) {
                    let uri = params.text_document.uri;
                    self.workspace.close(&uri);
                    self.notify::<PublishDiagnostics>(PublishDiagnosticsParams::new(uri, Vec::new(), None));
                }
            }
            DidChangeWatchedFiles::METHOD | DidSaveTextDocument::METHOD => self.workspace.forget_all(),
            DidChangeWorkspaceFolders::METHOD => {
                if let Some(params) = read::<DidChangeWorkspaceFolders>(note) {
                    let removed: Vec<_> =
                        params.event.removed.iter().filter_map(|folder| path_of(&folder.uri)).collect();
                    let added = params.event.added.iter().filter_map(|folder| path_of(&folder.uri));
                    self.workspace.folders.retain(|folder| !removed.contains(folder));
                    self.workspace.folders.extend(added);
                }
            }
            _ => {}
        }
    }

    fn answer(&mut self, request: Request) {
        if request.method == Shutdown::METHOD {
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
            self.notify::<PublishDiagnostics>(PublishDiagnosticsParams::new(uri, found, Some(version)));
        }
    }

    fn notify<N: lsp_types::notification::Notification>(&self, params: N::Params) {
        self.send(Notification::new(N::METHOD.to_owned(), params));
    }

    /// Asks the client to say when files of the disk change.
    fn watch(&self) {
        let watcher = FileSystemWatcher { glob_pattern: GlobPattern::String(WATCHED.to_owned()), kind: None };
        let options = DidChangeWatchedFilesRegistrationOptions { watchers: vec![watcher] };
        let registration = Registration {
            id: "watched".to_owned(),
            method: DidChangeWatchedFiles::METHOD.to_owned(),
            register_options: serde_json::to_value(options).ok(),
        };
        let params = RegistrationParams { registrations: vec![registration] };
        let id = RequestId::from("watch".to_owned());
        self.send(Request::new(id, RegisterCapability::METHOD.to_owned(), params));
    }
}

fn is_change(message: &Message) -> bool {
    matches!(message, Message::Notification(note) if note.method == DidChangeTextDocument::METHOD)
}

/// The parameters of a notification; `None` where they are not those of its method.
fn read<N>(note: Notification) -> Option<N::Params>
where
    N: lsp_types::notification::Notification,
    N::Params: DeserializeOwned,
{
    serde_json::from_value(note.params).ok()
}

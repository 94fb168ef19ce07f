//! Which function answers which request, and the one answer that each gets.

use super::file::CheckedFile;
use super::protocol::{
    AtPosition, AtPositions, CommandCall, InContext, InFile, InRange, NewName, Position, Query, TextDocument,
};
use super::workspace::EditorWorkspace;
use super::{actions, completion, documentation, edits, hints, hover, navigation, rename, sections, symbols};
use lsp_server::{ErrorCode, Request, Response};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

/// What is said of a file that is neither open nor on the disk.
const NOT_OPEN: &str = "the file is not open";

/// The answer to a request.
pub(super) fn answer(workspace: &mut EditorWorkspace, request: Request) -> Option<Response> {
    let call = Call::new(request);
    let call = about_places(workspace, call);
    let call = about_files(workspace, call);
    with_edits(workspace, call).answer()
}

/// A file and the offset in it that a request is about.
fn at(
    workspace: &mut EditorWorkspace,
    document: &TextDocument,
    position: Position,
) -> Option<(CheckedFile, u32)> {
    let file = workspace.file(&document.uri)?;
    let offset = file.offset(position);
    Some((file, offset))
}

fn about_places(workspace: &mut EditorWorkspace, call: Call) -> Call {
    call.on("textDocument/hover", |params: AtPosition| {
        let (file, offset) = at(workspace, &params.text_document, params.position)?;
        hover::hover(&file, offset)
    })
    .on("textDocument/completion", |params: AtPosition| {
        let (file, offset) = at(workspace, &params.text_document, params.position)?;
        let expands_snippets = workspace.client.expands_snippets;
        Some(workspace.reading(|| completion::completion(&file, offset, expands_snippets)))
    })
    .on("completionItem/resolve", |mut item: SentItem| {
        let edits = wanted::<sections::WantedItem>(&item).and_then(|wanted| {
            let file = workspace.file(&wanted.uri)?;
            sections::resolve(&file, &wanted)
        });
        item.extend(edits.map(|edits| ("additionalTextEdits".to_owned(), json!(edits))));
        item
    })
    .on("textDocument/definition", |params: AtPosition| {
        let (file, offset) = at(workspace, &params.text_document, params.position)?;
        navigation::definition(&file, offset)
    })
    .on("textDocument/references", |params: AtPosition| {
        let (file, offset) = at(workspace, &params.text_document, params.position)?;
        Some(navigation::references(&file, workspace, offset))
    })
    .try_on("textDocument/prepareRename", |params: AtPosition| {
        let at = at(workspace, &params.text_document, params.position);
        let (file, offset) = at.ok_or_else(|| NOT_OPEN.to_owned())?;
        rename::prepare(&file, offset)
    })
    .on("textDocument/selectionRange", |params: AtPositions| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(
            params.positions.into_iter().map(|position| symbols::around(&file, position)).collect::<Vec<_>>(),
        )
    })
    .on("textDocument/inlayHint", |params: InRange| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(hints::hints(&file, params.range))
    })
}

fn about_files(workspace: &mut EditorWorkspace, call: Call) -> Call {
    call.on("textDocument/documentSymbol", |params: InFile| {
        Some(symbols::outline(&workspace.file(&params.text_document.uri)?))
    })
    .on("textDocument/foldingRange", |params: InFile| {
        Some(symbols::folds(&workspace.file(&params.text_document.uri)?))
    })
    .on("textDocument/documentLink", |params: InFile| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(workspace.reading(|| navigation::links(&file)))
    })
    .on("textDocument/codeLens", |params: InFile| {
        Some(hints::lenses(&workspace.file(&params.text_document.uri)?))
    })
    .on("textDocument/semanticTokens/full", |params: InFile| {
        hints::tokens(&workspace.file(&params.text_document.uri)?)
    })
    .on("workspace/symbol", |params: Query| {
        let files = workspace.descriptions();
        files.iter().flat_map(|file| symbols::found(file, &params.query)).collect::<Vec<_>>()
    })
}

fn with_edits(workspace: &mut EditorWorkspace, call: Call) -> Call {
    call.on("textDocument/formatting", |params: InFile| {
        edits::formatted(&workspace.file(&params.text_document.uri)?)
    })
    .try_on("textDocument/rename", |params: NewName| {
        let at = at(workspace, &params.text_document, params.position);
        let (file, offset) = at.ok_or_else(|| NOT_OPEN.to_owned())?;
        rename::rename(&file, workspace, offset, &params.new_name)
    })
    .try_on("workspace/executeCommand", |params: CommandCall| {
        let uri = params.arguments.as_ref().and_then(|arguments| arguments.first()?.as_str());
        let file = workspace.file(uri.unwrap_or_default()).ok_or_else(|| NOT_OPEN.to_owned())?;
        match &*params.command {
            documentation::PAGE => documentation::page(&file).map(Some),
            documentation::SHOW => documentation::show(&file, workspace).map(|()| None),
            other => Err(format!("unknown command `{other}`")),
        }
    })
    .on("textDocument/codeAction", |params: InContext| {
        let file = workspace.file(&params.text_document.uri)?;
        let span = file.positions().span(params.range);
        let only = params.context.only.as_deref();
        Some(workspace.reading(|| actions::actions(&file, workspace, span, only)))
    })
    .on("codeAction/resolve", |mut action: SentItem| {
        let edit = wanted::<actions::WantedAction>(&action).and_then(|wanted| {
            let file = workspace.file(&wanted.uri)?;
            actions::resolve(&file, workspace, &wanted)
        });
        action.extend(edit.map(|edit| ("edit".to_owned(), json!(edit))));
        action
    })
}

/// An item that the server sent before, and completes when the user chooses it.
type SentItem = Map<String, Value>;

/// What the server needs to complete an item.
fn wanted<T: DeserializeOwned>(item: &SentItem) -> Option<T> {
    serde_json::from_value(item.get("data")?.clone()).ok()
}

/// A request that is answered by the first handler of its method.
pub(super) struct Call {
    request: Option<Request>,
    response: Option<Response>,
}

impl Call {
    pub(super) fn new(request: Request) -> Self {
        Self { request: Some(request), response: None }
    }

    /// Answers the request if it is of this method.
    pub(super) fn on<P: DeserializeOwned, R: Serialize>(
        self,
        method: &str,
        answer: impl FnOnce(P) -> R,
    ) -> Self {
        self.try_on(method, |params| Ok(answer(params)))
    }

    /// The same where the answer may be an error, in words for the user.
    pub(super) fn try_on<P: DeserializeOwned, R: Serialize>(
        mut self,
        method: &str,
        answer: impl FnOnce(P) -> Result<R, String>,
    ) -> Self {
        if let Some(request) = self.request.take_if(|request| request.method == method) {
            let (id, failed) = (request.id, |id, code, text| Response::new_err(id, code as i32, text));
            self.response = Some(match serde_json::from_value(request.params).map(answer) {
                Ok(Ok(result)) => Response::new_ok(id, result),
                Ok(Err(reason)) => failed(id, ErrorCode::RequestFailed, reason),
                Err(error) => failed(id, ErrorCode::InvalidParams, error.to_string()),
            });
        }
        self
    }

    /// The answer; an error for a method that nothing handles.
    pub(super) fn answer(self) -> Option<Response> {
        self.response.or_else(|| {
            let request = self.request?;
            let message = format!("`{}` is not supported", request.method);
            Some(Response::new_err(request.id, ErrorCode::MethodNotFound as i32, message))
        })
    }
}

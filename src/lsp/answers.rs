//! Which function answers which request.

use lsp_server::{Request, Response};
use lsp_types::request::{
    CodeActionRequest, CodeActionResolveRequest, CodeLensRequest, Completion, DocumentLinkRequest,
    DocumentSymbolRequest, ExecuteCommand, FoldingRangeRequest, Formatting, GotoDefinition, HoverRequest,
    InlayHintRequest, PrepareRenameRequest, References, Rename, ResolveCompletionItem, SelectionRangeRequest,
    SemanticTokensFullRequest, WorkspaceSymbolRequest,
};
use lsp_types::{
    CodeActionParams, CompletionResponse, DocumentSymbolResponse, SemanticTokensResult,
    TextDocumentPositionParams, Uri, WorkspaceSymbolResponse,
};
use serde_json::Value;

use super::call::Call;
use super::file::File;
use super::workspace::Workspace;
use super::{
    actions, completion, documentation, edits, hints, hover, navigation, rename, sections, symbols, tokens,
};

/// What is said of a file that is neither open nor on the disk.
const NOT_OPEN: &str = "the file is not open";

/// The answer to a request.
pub(super) fn answer(workspace: &mut Workspace, request: Request) -> Option<Response> {
    let call = Call::new(request);
    let call = about_places(workspace, call);
    let call = about_files(workspace, call);
    with_edits(workspace, call).answer()
}

/// A file and the offset in it that a request is about.
fn at(workspace: &mut Workspace, params: &TextDocumentPositionParams) -> Option<(File, u32)> {
    let file = workspace.file(&params.text_document.uri)?;
    let offset = file.offset(params.position);
    Some((file, offset))
}

fn about_places(workspace: &mut Workspace, call: Call) -> Call {
    call.on::<HoverRequest>(|params| {
        let (file, offset) = at(workspace, &params.text_document_position_params)?;
        hover::hover(&file, offset)
    })
    .on::<Completion>(|params| {
        let (file, offset) = at(workspace, &params.text_document_position)?;
        let expands_snippets = workspace.client.expands_snippets;
        let items = workspace.reading(|| completion::completion(&file, offset, expands_snippets));
        Some(CompletionResponse::Array(items))
    })
    .on::<ResolveCompletionItem>(|mut item| {
        let wanted = item.data.clone().and_then(|data| serde_json::from_value::<sections::Wanted>(data).ok());
        if let Some(wanted) = wanted
            && let Some(file) = file_of(workspace, &wanted.uri)
        {
            item.additional_text_edits = sections::resolve(&file, &wanted);
        }
        item
    })
    .on::<GotoDefinition>(|params| {
        let (file, offset) = at(workspace, &params.text_document_position_params)?;
        navigation::definition(&file, offset)
    })
    .on::<References>(|params| {
        let (file, offset) = at(workspace, &params.text_document_position)?;
        Some(navigation::references(&file, workspace, offset))
    })
    .try_on::<PrepareRenameRequest>(|params| {
        let (file, offset) = at(workspace, &params).ok_or_else(|| NOT_OPEN.to_owned())?;
        rename::prepare(&file, offset).map(Some)
    })
    .on::<SelectionRangeRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(params.positions.into_iter().map(|position| symbols::around(&file, position)).collect())
    })
    .on::<InlayHintRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(hints::hints(&file, params.range))
    })
}

fn about_files(workspace: &mut Workspace, call: Call) -> Call {
    call.on::<DocumentSymbolRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(DocumentSymbolResponse::Nested(symbols::outline(&file)))
    })
    .on::<FoldingRangeRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(symbols::folds(&file))
    })
    .on::<DocumentLinkRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(workspace.reading(|| navigation::links(&file)))
    })
    .on::<CodeLensRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        Some(hints::lenses(&file))
    })
    .on::<SemanticTokensFullRequest>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        tokens::tokens(&file).map(SemanticTokensResult::Tokens)
    })
    .on::<WorkspaceSymbolRequest>(|params| {
        let files = workspace.descriptions();
        let found = files.iter().flat_map(|file| symbols::found(file, &params.query));
        Some(WorkspaceSymbolResponse::Flat(found.collect()))
    })
}

fn with_edits(workspace: &mut Workspace, call: Call) -> Call {
    call.on::<Formatting>(|params| {
        let file = workspace.file(&params.text_document.uri)?;
        edits::formatted(&file)
    })
    .try_on::<Rename>(|params| {
        let (file, offset) =
            at(workspace, &params.text_document_position).ok_or_else(|| NOT_OPEN.to_owned())?;
        rename::rename(&file, workspace, offset, &params.new_name).map(Some)
    })
    .try_on::<ExecuteCommand>(|params| {
        let uri = params.arguments.first().and_then(Value::as_str).unwrap_or_default();
        let file = file_of(workspace, uri).ok_or_else(|| NOT_OPEN.to_owned())?;
        match &*params.command {
            documentation::PAGE => documentation::page(&file).map(|page| Some(Value::from(page))),
            documentation::SHOW => documentation::show(&file, workspace).map(|()| None),
            other => Err(format!("there is no command `{other}`")),
        }
    })
    .on::<CodeActionRequest>(|params| {
        let CodeActionParams { text_document, range, context, .. } = params;
        let file = workspace.file(&text_document.uri)?;
        let span = file.positions().span(range);
        Some(workspace.reading(|| actions::actions(&file, workspace, span, context.only.as_deref())))
    })
    .on::<CodeActionResolveRequest>(|action| {
        let wanted =
            action.data.clone().and_then(|data| serde_json::from_value::<actions::Wanted>(data).ok());
        let Some(wanted) = wanted else { return action };
        match file_of(workspace, &wanted.uri) {
            Some(file) => actions::resolve(&file, workspace, action, &wanted),
            None => action,
        }
    })
}

/// A file by its address in the data of an item.
fn file_of(workspace: &mut Workspace, uri: &str) -> Option<File> {
    let uri: Uri = uri.parse().ok()?;
    workspace.file(&uri)
}

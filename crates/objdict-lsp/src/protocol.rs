//! The messages of the Language Server Protocol 3.17, with the fields that the server reads and writes.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// The address of a file.
pub(super) type Uri = String;

/// A line and a column, from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub(super) struct Position {
    pub(super) line: u32,
    pub(super) character: u32,
}

impl Position {
    pub(super) const fn new(line: u32, character: u32) -> Self {
        Self { line, character }
    }
}

/// The text between two positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Range {
    pub(super) start: Position,
    pub(super) end: Position,
}

impl Range {
    pub(super) const fn new(start: Position, end: Position) -> Self {
        Self { start, end }
    }
}

/// Types of what a client sends.
macro_rules! received {
    ($($name:ident { $($field:ident: $type:ty),* })*) => { $(
        #[derive(Deserialize)]
        #[serde(rename_all = "camelCase")]
        pub(super) struct $name { $(pub(super) $field: $type),* }
    )* };
}

received! {
    TextDocument { uri: Uri }
    TextDocumentItem { uri: Uri, version: i32, text: String }
    VersionedTextDocument { uri: Uri, version: i32 }
    DidOpen { text_document: TextDocumentItem }
    DidChange { text_document: VersionedTextDocument, content_changes: Vec<ContentChange> }
    ContentChange { range: Option<Range>, text: String }
    WorkspaceFolder { uri: Uri }
    DidChangeFolders { event: FolderChanges }
    FolderChanges { added: Vec<WorkspaceFolder>, removed: Vec<WorkspaceFolder> }

    InFile { text_document: TextDocument }
    AtPosition { text_document: TextDocument, position: Position }
    AtPositions { text_document: TextDocument, positions: Vec<Position> }
    InRange { text_document: TextDocument, range: Range }
    NewName { text_document: TextDocument, position: Position, new_name: String }
    InContext { text_document: TextDocument, range: Range, context: ActionContext }
    ActionContext { only: Option<Vec<String>> }
    CommandCall { command: String, arguments: Option<Vec<Value>> }
    Query { query: String }
}

/// Types of what the server sends: fields that are always there, then those that may be missing.
macro_rules! sent {
    ($($name:ident { $($field:ident: $type:ty),* $(; $($optional:ident: $of:ty),*)? })*) => { $(
        #[derive(Clone, Default, Serialize)]
        #[serde(rename_all = "camelCase")]
        pub(super) struct $name {
            $(pub(super) $field: $type,)*
            $($(#[serde(skip_serializing_if = "Option::is_none")] pub(super) $optional: Option<$of>,)*)?
        }
    )* };
}

sent! {
    Location { uri: Uri, range: Range }
    TextEdit { range: Range, new_text: String }
    WorkspaceEdit { ; changes: BTreeMap<Uri, Vec<TextEdit>>, document_changes: Value }
    Diagnostic {
        range: Range, severity: u8, source: &'static str, message: String;
        code: &'static str, code_description: CodeDescription, related_information: Vec<RelatedInformation>
    }
    CodeDescription { href: Uri }
    RelatedInformation { location: Location, message: String }
    CodeAction {
        title: String, kind: &'static str;
        diagnostics: Vec<Diagnostic>, edit: WorkspaceEdit, command: Command, is_preferred: bool, data: Value
    }
    Command { title: String, command: &'static str; arguments: Value }
    CodeLens { range: Range, command: Command }
    CompletionItem {
        label: String, kind: CompletionItemKind;
        detail: String, documentation: Markdown, sort_text: String, filter_text: String,
        insert_text_format: u8, text_edit: TextEdit, data: Value
    }
    Hover { contents: Markdown, range: Range }
    Markdown { kind: &'static str, value: String }
    InlayHint { position: Position, label: String, padding_left: bool }
    DocumentLink { range: Range; target: Uri }
    DocumentSymbol {
        name: String, kind: SymbolKind, range: Range, selection_range: Range;
        detail: String, children: Vec<DocumentSymbol>
    }
    SymbolInformation { name: String, kind: SymbolKind, location: Location, container_name: &'static str }
    FoldingRange { start_line: u32, end_line: u32, kind: &'static str }
    SelectionRange { range: Range; parent: Box<SelectionRange> }
    SemanticTokens { data: Vec<u32> }
    Renamed { range: Range, placeholder: String }
}

impl Location {
    pub(super) const fn new(uri: Uri, range: Range) -> Self {
        Self { uri, range }
    }
}

impl WorkspaceEdit {
    pub(super) fn new(changes: BTreeMap<Uri, Vec<TextEdit>>) -> Self {
        Self { changes: Some(changes), document_changes: None }
    }
}

impl Markdown {
    pub(super) const fn new(value: String) -> Self {
        Self { kind: "markdown", value }
    }
}

/// `Snippet` of `InsertTextFormat`.
pub(super) const SNIPPET: u8 = 2;

/// The kinds of code actions; one asks for those that follow it and a `.` too.
pub(super) const QUICKFIX: &str = "quickfix";
pub(super) const REFACTOR: &str = "refactor";
pub(super) const FIX_ALL: &str = "source.fixAll";

/// Kinds that the protocol numbers.
macro_rules! numbered {
    ($name:ident { $($kind:ident = $number:literal),* }) => {
        #[derive(Clone, Copy, Default, PartialEq, Eq, Serialize)]
        pub(super) struct $name(u8);
        impl $name { $(pub(super) const $kind: Self = Self($number);)* }
    };
}

numbered! { CompletionItemKind {
    FIELD = 5, CLASS = 7, MODULE = 9, PROPERTY = 10, VALUE = 12, REFERENCE = 18, CONSTANT = 21, STRUCT = 22
} }
numbered! { SymbolKind { FILE = 1, MODULE = 2, NAMESPACE = 3, FIELD = 8, ARRAY = 18, OBJECT = 19, STRUCT = 23 } }

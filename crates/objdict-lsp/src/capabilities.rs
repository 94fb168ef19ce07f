//! What the server offers.

use serde_json::{Value, json};

use super::position::ColumnUnit;
use super::protocol::{FIX_ALL, QUICKFIX, REFACTOR};
use super::{actions, documentation, tokens};

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
            "legend": { "tokenTypes": tokens::KINDS, "tokenModifiers": [] },
            "full": true,
        },
        "workspace": { "workspaceFolders": { "supported": true, "changeNotifications": true } },
    })
}

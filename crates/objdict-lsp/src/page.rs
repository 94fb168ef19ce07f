//! Answers for a page: a text that is edited in a browser, where there is neither a client nor a disk.

use std::collections::BTreeSet;

use super::completion::completion;
use super::hints::{KINDS, tokens};
use super::hover::hover;
use super::position::ColumnUnit;
use super::protocol::Position;
use super::uri::{of_path, path_of};
use super::workspace::EditorWorkspace;
use serde::Deserialize;
use serde_json::{Value, json};

/// What is asked about a text; lines and columns are counted from 0, columns in UTF-16.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(tag = "ask", rename_all = "kebab-case", deny_unknown_fields)]
pub enum LanguageQuestion {
    /// What is under a position.
    Hover {
        /// The line.
        line: u32,
        /// The column.
        character: u32,
    },
    /// What can be written at a position.
    Completion {
        /// The line.
        line: u32,
        /// The column.
        character: u32,
    },
    /// The kinds of the words.
    Tokens,
}

/// The texts of a page, and what is known of them.
#[derive(Default)]
pub struct PageLanguage {
    workspace: EditorWorkspace,
    known: BTreeSet<String>,
}

impl std::fmt::Debug for PageLanguage {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("PageLanguage").field("known", &self.known).finish_non_exhaustive()
    }
}

impl PageLanguage {
    /// The answer about one of the texts that are open, as the Language Server Protocol has it; `null` without one.
    pub fn answer(&mut self, name: &str, texts: Vec<(String, String)>, question: &LanguageQuestion) -> Value {
        self.workspace.unit = ColumnUnit::Utf16;
        let mut open = BTreeSet::new();
        for (name, text) in texts {
            let Some(uri) = uri_of(&name) else { continue };
            if !self.workspace.has(&uri, &text) {
                self.workspace.close(&uri);
                self.workspace.open(uri.clone(), 0, text);
            }
            open.insert(uri);
        }
        for closed in self.known.difference(&open) {
            self.workspace.close(closed);
        }
        self.known = open;
        let Some(file) = uri_of(name).and_then(|uri| self.workspace.file(&uri)) else { return Value::Null };
        match *question {
            LanguageQuestion::Hover { line, character } => {
                json!(hover(&file, file.offset(Position::new(line, character))))
            }
            LanguageQuestion::Completion { line, character } => {
                let offset = file.offset(Position::new(line, character));
                json!(self.workspace.reading(|| completion(&file, offset, false)))
            }
            LanguageQuestion::Tokens => json!({ "kinds": KINDS, "tokens": tokens(&file) }),
        }
    }
}

/// The address of a text that has only a name.
fn uri_of(name: &str) -> Option<String> {
    let uri = of_path(std::path::Path::new(&format!("/{name}")))?;
    path_of(&uri).map(|_| uri)
}

//! The engine of the workbench (`web`): objdict as it runs in the browser. The page sends requests as JSON and gets answers as
//! JSON; bytes of files go beside them. An error is an answer too.
//!
//! The page knows no format: it asks the engine for everything that it shows. Findings are the document of `check
//! --format json`, so fixes and typed text are edits by line and column. State of the device in the page, or a
//! framework, would be a second model next to that of objdict.

mod answer;
mod document;
mod files;
mod form;
mod log;
mod network;
mod node;
mod outline;
mod place;
mod profiles;
mod request;

use objdict_lsp::PageLanguage;
use wasm_bindgen::prelude::wasm_bindgen;

use self::document::EditedDocument;
use self::files::PageFile;
use self::log::Log;

/// What is open: a text that is edited, or a log.
#[derive(Debug)]
enum Open {
    Text(Box<EditedDocument>),
    Log(Box<Log>),
}

/// All that a page has open.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Workbench {
    /// By their numbers; `None` where one was closed.
    documents: Vec<Option<Open>>,
    language: PageLanguage,
    /// What the last answer names.
    files: Vec<PageFile>,
}

#[wasm_bindgen]
impl Workbench {
    /// With nothing open.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Answers a request: `{"ok": …}`, or `{"error": {"message", "help"}}`. `bytes` are those of the file that it opens.
    pub fn call(&mut self, request: &str, bytes: Vec<u8>) -> String {
        self.files.clear();
        answer::of(self.answer(request, bytes))
    }

    /// The bytes of a file that the last answer lists, once; empty where there is no such file.
    pub fn take(&mut self, number: usize) -> Vec<u8> {
        self.files.get_mut(number).map(|file| std::mem::take(&mut file.bytes)).unwrap_or_default()
    }
}

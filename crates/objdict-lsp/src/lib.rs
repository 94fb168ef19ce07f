//! `objdict lsp`: a language server for descriptions, networks and what belongs to them.
//!
//! The text is the truth: what is found after an edit is what a check of the whole text finds, and tests compare the two. Objects of
//! an EDS or DCF of which no section changed are neither read nor checked again by the rules that look at nothing else; all else is.
//! Answers are made of what the readers of the library give: places of the model and spans of the text.

mod actions;
mod analysis;
mod answers;
mod baseline;
mod baseline_addition;
mod beside;
mod completion;
mod completion_item;
mod cursor;
mod diagnostics;
mod documentation;
mod edits;
mod file;
mod hints;
mod hover;
mod keyed;
mod mentions;
mod navigation;
mod page;
mod position;
mod protocol;
mod rename;
mod schema;
mod sections;
mod server;
mod symbols;
mod uri;
mod values;
mod words;
mod workspace;

pub use self::page::{LanguageQuestion, PageLanguage};
pub use self::server::serve;

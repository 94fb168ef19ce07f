//! `objdict lsp`: a language server for descriptions, networks and what belongs to them.
//!
//! No result is updated in place, so tests can compare its findings with those of a check.
//!
//! The text is the truth: each change brings the whole text of a file, which is read and checked again. Answers are made of what
//! the readers of the library give: places of the model and spans of the text.

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

pub use self::server::serve;

//! The INI layer under EDS, DCF and node lists: preserves all bytes, with a span for everything. Reading
//! never fails.

mod document;
mod edit;
mod edited;
pub mod findings;
mod scan;
mod tidy;

pub use document::{Document, Header, IniEntry, Section};
pub use edit::IniEditor;
pub use edited::EditedSpan;
pub(crate) use scan::headers;
pub use scan::{Line, LineKind, Lines};
pub(crate) use tidy::tidy;

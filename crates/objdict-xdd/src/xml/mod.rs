//! The XML layer under XDD and XDC: a tree with a span for everything. Reading never fails.

mod attributes;
mod build;
mod chars;
mod comments;
mod content;
mod edit;
mod expand;
pub mod findings;
mod markup;
mod names;
mod namespaces;
mod parts;
mod prolog;
mod tag;
mod tree;
mod write;

pub(crate) use chars::{is_name, is_name_char};
pub use comments::comments;
pub use edit::XmlEditor;
pub use names::{Name, n};
pub use tree::{Attribute, Called, Element, ElementId, Tree};
pub use write::XmlWriter;
pub(crate) use write::{WriterMark, escaped_value};

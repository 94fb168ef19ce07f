//! Concise DCF, the stream that a CANopen manager keeps in 1F22h for each node (CiA 302-3), as texts: a table to look at,
//! a text to review and to edit, and the spellings in which a stream gets into a program.
//!
//! The stream itself is written and parsed by [`crate::download::ConciseDcf`].

mod spelling;
mod table;
mod text;

pub use spelling::{BlobSpelling, of_hex};
pub use table::table;
pub use text::looks_like;
pub use text::{Annotation, TextError, TextErrors, parse, print};

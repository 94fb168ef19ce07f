//! The text and source code formats of a concise DCF, the stream that a CANopen manager stores in 1F22h
//! for each node (CiA 302-3).
//!
//! The stream itself is written and parsed by [`crate::download::ConciseDcf`].

mod spelling;
mod text;

pub use spelling::{BlobSpelling, of_hex, table};
pub use text::{Annotation, TextError, TextErrors, looks_like, parse, print, spelled};

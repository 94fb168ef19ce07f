//! Text and source-code forms of a concise DCF, the stream that a CANopen manager stores in 1F22h for each
//! node (CiA 302-3).
//!
//! The stream itself is written and parsed by [`crate::download::ConciseDcf`].

mod spelling;
mod table;
mod text;

pub use spelling::{BlobSpelling, of_hex};
pub use table::table;
pub use text::looks_like;
pub use text::{Annotation, TextError, TextErrors, parse, print, spelled};

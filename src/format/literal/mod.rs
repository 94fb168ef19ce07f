//! How values are spelled in description files: CiA 306-1 §4.3, and what real files make of it.

mod parse;
mod print;
mod respell;

pub use parse::{Quirk, Quirks, integer, strip_comment, value};
pub use print::{RealSpelling, Spelling, print};
pub(crate) use respell::{respell, trailing_comment};

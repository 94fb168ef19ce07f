//! The code that serves the generated table of an object dictionary.

mod abort;

pub use abort::Abort;

//! EDS and DCF (CiA 306-1).

#[cfg(feature = "write")]
mod additions;
mod configure;
pub mod file_name;
pub mod findings;
mod fix;
#[cfg(feature = "write")]
pub mod fmt;
mod item;
mod keys;
mod locate;
mod misspelt;
mod names;
mod order;
pub mod portability;
mod read;
mod section;
#[cfg(feature = "write")]
mod style;
#[cfg(feature = "write")]
pub mod write;

#[cfg(feature = "write")]
pub use additions::{additions, stated, stored};
pub use configure::{to_dcf, to_eds};
pub use fix::edits;
pub use keys::{is_key, is_meaning_key};
pub use locate::{SectionLocator, objects};
pub use misspelt::is_key_of;
pub use read::{BeforeEdit, ReadDocument, SectionStarts, comments, read, read_after, read_first};
pub use section::SectionName;
#[cfg(feature = "write")]
pub use style::Style;
#[cfg(feature = "write")]
pub use write::write;

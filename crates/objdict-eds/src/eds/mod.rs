//! EDS and DCF (CiA 306-1).

#[cfg(feature = "write")]
mod additions;
#[cfg(feature = "write")]
pub mod arrange;
mod configure;
pub mod file_name;
pub mod findings;
mod keys;
mod locate;
mod mend;
mod misspelt;
mod order;
pub mod portability;
mod read;
mod section;
#[cfg(feature = "write")]
mod style;
#[cfg(feature = "write")]
pub mod write;

#[cfg(feature = "write")]
pub use additions::additions;
pub use configure::{to_dcf, to_eds};
pub use locate::Locator;
pub use mend::edits;
pub use read::read;
pub use section::SectionName;
#[cfg(feature = "write")]
pub use style::Style;
#[cfg(feature = "write")]
pub use write::write;

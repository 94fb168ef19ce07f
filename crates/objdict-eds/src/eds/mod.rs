//! EDS and DCF (CiA 306-1).

mod additions;
pub mod arrange;
mod configure;
pub mod file_name;
pub mod findings;
mod keys;
mod locate;
mod mend;
mod order;
pub mod portability;
mod read;
mod section;
mod style;
pub mod write;

pub use additions::additions;
pub use configure::{to_dcf, to_eds};
pub use locate::Locator;
pub use mend::edits;
pub use read::read;
pub use section::SectionName;
pub use style::Style;
pub use write::write;

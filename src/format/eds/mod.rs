//! EDS and DCF (CiA 306-1).

mod additions;
pub(crate) mod arrange;
mod configure;
pub(crate) mod file_name;
pub(crate) mod findings;
mod keys;
mod locate;
mod mend;
mod order;
pub(crate) mod portability;
mod quirks;
mod read;
mod section;
mod write;

pub(crate) use additions::additions;
pub(crate) use configure::{to_dcf, to_eds};
pub(crate) use locate::Locator;
pub(crate) use mend::edits;
pub(crate) use quirks::spelling;
pub(crate) use read::read;
pub(crate) use section::SectionName;
pub(crate) use write::write;

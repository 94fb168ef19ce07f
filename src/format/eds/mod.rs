//! EDS and DCF (CiA 306-1).

mod configure;
pub(crate) mod file_name;
pub(crate) mod findings;
mod keys;
mod locate;
mod read;
mod section;

pub(crate) use configure::{to_dcf, to_eds};
pub(crate) use locate::Locator;
pub(crate) use read::read;
pub(crate) use section::section_name;

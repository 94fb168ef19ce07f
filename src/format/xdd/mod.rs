//! XDD and XDC: device descriptions and configurations in XML (CiA 311).

mod configure;
mod defaults;
pub(crate) mod findings;
mod layout;
mod leftovers;
mod locate;
mod markup;
mod mend;
mod read;
pub(crate) mod schema;
#[macro_use]
mod shape;
mod types;
mod version;
pub(crate) mod wording;
mod write;

pub(crate) use self::configure::{to_xdc, to_xdd};
pub(crate) use self::layout::containers;
pub(crate) use self::locate::Locator;
pub(crate) use self::mend::edits;
pub(crate) use self::read::read;
pub use self::version::XddVersion;
pub(crate) use self::write::write;

//! XDD and XDC: device descriptions and configurations in XML (CiA 311).

mod configure;
mod defaults;
mod element;
mod fact;
pub mod findings;
mod fix;
mod fmt;
mod layout;
mod leftovers;
mod locate;
mod profile_class;
mod read;
pub(crate) mod schema;
mod shape;
mod types;
mod version;
pub mod wording;
pub mod write;
mod xdd_writer;

pub use self::configure::{to_xdc, to_xdd, with_objects};
pub use self::fact::{read_value, stated_text};
pub use self::fix::edits;
pub use self::fmt::arrange;
pub use self::layout::{containers, is_network, is_project};
#[doc(hidden)] // for readers of other XML
pub use self::leftovers::Leftovers;
pub use self::locate::ElementLocator;
pub use self::read::{read, read_literally};
pub use self::schema::{words_of, xsd};
pub use self::version::XddVersion;
pub use self::write::{print_value, write};

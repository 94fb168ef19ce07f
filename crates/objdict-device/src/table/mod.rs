//! Code for the object dictionary tables that `objdict generate --target rust` writes: SDO access by index and
//! sub-index, typed handles, storage groups, hooks, and PDO packing. It is the same for every device.

mod abort;
mod codes;
mod data;
mod entry;
mod handle;
mod hooks;
mod images;
mod pdo;
mod stored;
mod value;
#[cfg(feature = "defmt")]
mod with_defmt;
#[cfg(feature = "serde")]
mod with_serde;

pub use abort::Abort;
pub use codes::*;
pub use data::{Configured, Data};
pub use entry::{Entry, Table};
pub use handle::{Array, Const, Elsewhere, Handle, NodeConst, Ro, Rw, Variable, Wo};
pub use hooks::{Change, Hooked, Hooks};
pub use images::AnyGroup;
pub use pdo::{first, pack, unpack};
pub use stored::{Group, ImageError};
pub use value::{Time, Typed};

use data::copy;
use entry::{number, part};

//! Requirements of CiA documents as data: one TOML file per document (`data/`), from which `cargo xtask
//! profiles` generates constants (`constants/`), and custom profiles in the same format. Rules, generators
//! and the command query these tables and contain none of their own.
//!
//! It is a separate crate because rules, pages, setting units, names in generated code and new devices need
//! these facts and are independent of each other.
//!
//! `docs/reference/profile.md` describes the format.

mod block;
mod condition;
mod constants;
mod decode;
pub mod default_mapping;
mod facts;
#[cfg(feature = "toml")]
mod load;
mod machine;
mod need;
#[cfg(feature = "toml")]
mod open;
mod profile;
pub mod standard;
#[doc(hidden)]
pub mod tables;

pub use block::{MAX_BLOCKS, device_type_index, index_in, number_of};
pub use condition::{Condition, ConditionError};
pub use decode::Values;
pub use decode::{bits, entry, meaning, of_object};
pub use facts::{BitFieldFacts, EntryFacts, ObjectFacts};
#[cfg(feature = "toml")]
pub use load::ProfileError;
pub use machine::{StateMachine, Transition};
pub use need::{Confidence, Mapping, Need};
#[cfg(feature = "toml")]
pub use open::{OpenError, open};
pub use profile::Profile;
pub use standard::{access, data_type, for_all, named, obsolete, of_device, of_number, standard};

use objdict_model::model;
#[cfg(feature = "toml")]
use objdict_model::{diagnostic, source};

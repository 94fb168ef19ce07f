//! Files that users write as keys and values: a tree with the position of each value, and tables of the allowed keys.
//! Part of `objdict`, which is the crate to depend on.

pub mod notation;
pub mod rules;
pub mod schema;
pub mod section;
pub mod toml;
pub mod tree;
pub mod types;
#[cfg(feature = "yaml")]
pub mod yaml;

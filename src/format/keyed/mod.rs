//! Files that people write as keys and values: a tree with the place of each value, and tables of the keys that a file may have.

#[cfg(feature = "patch")]
pub(super) mod fields;
pub(super) mod rules;
pub(super) mod schema;
pub(super) mod section;
pub(super) mod toml;
pub(super) mod tree;
pub(super) mod types;
#[cfg(feature = "patch")]
pub(super) mod words;

//! The text of [`table`](crate::table), which the generator writes into files without dependencies.
//!
//! They name items of `core` in full and derive traits of other crates by `#[cfg_attr(feature = "…",
//! derive(…))]`, so the generated file needs neither imports nor dependencies.
//!
//! The files import each other only by `use super::…;`, so that their texts can be joined without these lines. They
//! are also valid in edition 2021.

/// Required by every table.
pub const TABLE: &[&str] = &[
    include_str!("table/abort.rs"),
    include_str!("table/codes.rs"),
    include_str!("table/entry.rs"),
    include_str!("table/handle.rs"),
    include_str!("table/value.rs"),
    include_str!("table/data.rs"),
];

/// Storage groups.
pub const STORED: &str = include_str!("table/stored.rs");

/// Hooks.
pub const HOOKS: &str = include_str!("table/hooks.rs");

/// The bits of PDOs.
pub const PDO: &str = include_str!("table/pdo.rs");

/// The traits of defmt for values.
pub const DEFMT: &str = include_str!("table/with_defmt.rs");

/// The traits of serde for values.
pub const SERDE: &str = include_str!("table/with_serde.rs");

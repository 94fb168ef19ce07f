//! Tables that a project has already, beside those that are generated.

use crate::{Generated, Target};

/// Where two tables differ.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TableDifference {
    /// Who notices it.
    pub aspect: TableAspect,
    /// The variable, macro, storage group, object or entry.
    pub place: String,
    /// What the existing tables have; `None` if they do not have it.
    pub old: Option<String>,
    /// What the generated tables have; `None` if they do not have it.
    pub new: Option<String>,
}

/// Who notices a difference of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum TableAspect {
    /// The application: names and types of variables and macros.
    Names,
    /// The values in non-volatile memory: their places in a storage group.
    Layout,
    /// The stack and the bus: objects, entries, access, lengths.
    Objects,
    /// The device: the values that it starts with.
    Values,
}

impl TableAspect {
    /// All of them, in the order of reports.
    pub const ALL: [Self; 4] = [Self::Names, Self::Layout, Self::Objects, Self::Values];
}

/// Compares tables that a project has already, a C header and its source, with generated ones. `None` if they are no tables of
/// the target, or the target has no comparison.
pub fn compare_tables(
    target: Target,
    header: &str,
    source: &str,
    generated: &Generated,
) -> Option<Vec<TableDifference>> {
    target.0.compare?(header, source, &generated.files)
}

impl Target {
    /// Whether existing tables can be [compared](compare_tables) with those of the target.
    pub fn is_compared(self) -> bool {
        self.0.compare.is_some()
    }
}

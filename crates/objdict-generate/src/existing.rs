//! Comparison of a project's existing tables with generated ones.

use crate::{Generated, Target};

/// A difference between two tables.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TableDifference {
    /// Who notices it.
    pub aspect: TableAspect,
    /// The variable, macro, storage group, object or entry.
    pub place: String,
    /// The property of the existing tables; `None` if missing.
    pub old: Option<String>,
    /// The property of the generated tables; `None` if missing.
    pub new: Option<String>,
}

/// Who notices a difference of tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "lowercase"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum TableAspect {
    /// The application: names and types of variables and macros.
    Names,
    /// The values in non-volatile memory: their locations in a storage group.
    Layout,
    /// The stack and the bus: objects, entries, access, lengths.
    Objects,
    /// The device: the values that it starts with.
    Values,
}

impl TableAspect {
    /// All aspects, in the order of reports.
    pub const ALL: [Self; 4] = [Self::Names, Self::Layout, Self::Objects, Self::Values];
}

/// Compares existing tables of a project, a C header and its source, with generated ones. `None` if they are not tables
/// of the target, or the target does not support comparison.
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

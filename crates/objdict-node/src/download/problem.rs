//! Problems that prevent a plan, and entries that a plan skips.

use std::fmt;

use crate::model::{DataType, Place, Value};

/// The reason why there is no plan; lists all problems.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlanError {
    /// The node-ID is not valid.
    NodeId(u8),
    /// Entries whose value cannot be written; at least one, in the order of the dictionary.
    Problems(Vec<Problem>),
}

/// An entry whose value cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The entry.
    pub place: Place,
    /// The reason.
    pub kind: ProblemKind,
}

/// Why a value cannot be written.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProblemKind {
    /// The value is a formula, and the node-ID is missing.
    NeedsNodeId(Value),
    /// The value does not fit the data type of the entry, possibly only with this node-ID.
    NotOfType {
        /// The value.
        value: Value,
        /// The data type.
        data_type: DataType,
    },
    /// The value is below `LowLimit`.
    BelowLimit {
        /// The value.
        value: Value,
        /// The limit.
        limit: Value,
    },
    /// The value is above `HighLimit`.
    AboveLimit {
        /// The value.
        value: Value,
        /// The limit.
        limit: Value,
    },
    /// The text in the description is not a valid value of the entry's data type.
    Unreadable(Box<str>),
    /// The data type is missing or its length is unknown, so the value cannot be encoded.
    UnknownType {
        /// The value.
        value: Value,
        /// The data type, if stated.
        data_type: Option<DataType>,
    },
    /// The PDO, SDO or other service must be disabled before it is changed, but the description does not
    /// state its COB-ID.
    NoCobId,
}

/// An entry with a value in the description that the plan does not write.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Skipped {
    /// The entry.
    pub place: Place,
    /// The reason why it is not written.
    pub reason: SkipReason,
}

/// The reason why a plan skips an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SkipReason {
    /// The access type allows no write.
    NotWritable,
    /// The description does not state whether the entry can be written.
    NoAccess,
    /// `ObjFlags` bit 0: the entry must not be written by a download.
    RefusesWrite,
    /// Writing starts an action, such as storing, and does not configure the node.
    Command,
    /// Writing 0 to 1003h sub-index 0 clears the error history.
    ClearsHistory,
    /// The object defines a data type or is NULL.
    Definition,
    /// A mapping entry of value 0 after the last mapped object.
    Unused,
    /// The number of mapped objects cannot be written, so the device has this mapping and no other.
    FixedMapping,
}

impl PlanError {
    /// How to fix it.
    pub fn help(&self) -> Option<&'static str> {
        match self {
            Self::NodeId(_) => Some("write a node-ID from 1 to 127"),
            Self::Problems(problems) => {
                let formula = |problem: &Problem| matches!(problem.kind, ProblemKind::NeedsNodeId(_));
                problems.iter().any(formula).then_some("state the node-ID with `--node-id`")
            }
        }
    }
}

impl std::error::Error for PlanError {}

/// One problem per line; entries that only need the node-ID share a line.
impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let problems = match self {
            Self::NodeId(node_id) => return write!(f, "`{node_id}` is not a node-ID"),
            Self::Problems(problems) => problems,
        };
        let (formulas, others): (Vec<_>, Vec<_>) =
            problems.iter().partition(|problem| matches!(problem.kind, ProblemKind::NeedsNodeId(_)));
        if !formulas.is_empty() {
            let places: Vec<String> = formulas.iter().map(|problem| format!("`{}`", problem.place)).collect();
            write!(f, "these values need the node-ID: {}", places.join(", "))?;
        }
        for (number, problem) in others.into_iter().enumerate() {
            if number > 0 || !formulas.is_empty() {
                f.write_str("\n")?;
            }
            write!(f, "{problem}")?;
        }
        Ok(())
    }
}

objdict_model::messages! {
    Problem: { Self { place, kind } => "`{place}`: {kind}"; }
    ProblemKind: {
        Self::NeedsNodeId(value) => "`{value}` needs the node-ID";
        Self::NotOfType { value, data_type } => "the value `{value}` does not fit {data_type}";
        Self::BelowLimit { value, limit } => "the value `{value}` is below the low limit `{limit}`";
        Self::AboveLimit { value, limit } => "the value `{value}` is above the high limit `{limit}`";
        Self::Unreadable(text) => "the string `{text}` is not valid for its data type";
        Self::UnknownType { value, data_type: Some(data_type) } =>
            "the bytes of `{value}` are unknown because the data type {data_type} is";
        Self::UnknownType { value, data_type: None } =>
            "the bytes of `{value}` are unknown because the entry has no data type";
        Self::NoCobId => "a change requires that the PDO is not valid, but its COB-ID is unknown";
    }
    Skipped: { Self { place, reason } => "`{place}` is not written: {reason}"; }
    SkipReason: {
        Self::NotWritable => "its access type does not allow a write";
        Self::NoAccess => "it has no access type";
        Self::RefusesWrite => "ObjFlags bit 0 forbids the download";
        Self::Command => "it is a command";
        Self::ClearsHistory => "a write clears the error history";
        Self::Definition => "it defines a data type";
        Self::Unused => "no object is mapped there";
        Self::FixedMapping => "the mapping is fixed: its sub-index 0 cannot be written";
    }
}

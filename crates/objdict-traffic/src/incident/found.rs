//! An incident as it is shown.

use serde::{Serialize, Serializer};

use crate::history::NodeEvent;
use crate::log::LogTime;
use objdict_lint::recorded::traffic::IncidentKind;

objdict_model::named! {
    /// What became of an incident. The order is the one in which incidents are listed.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum IncidentState {
        /// A problem that is not over at the end of the log.
        Unresolved = "unresolved",
        /// A problem that is over.
        Recovered = "recovered",
        /// Something to look at.
        Warning = "warning",
    }
}

/// Something that went wrong.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Incident {
    /// Its number in the list, from 1.
    pub number: usize,
    /// What it is known by in other logs: kind, channel, nodes and subject, but no time.
    pub fingerprint: String,
    /// The rule.
    #[serde(serialize_with = "id")]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub kind: &'static IncidentKind,
    /// What became of it: unresolved, recovered or warning.
    #[serde(serialize_with = "name")]
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub state: IncidentState,
    /// The name of the channel; absent if the log has none.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub channel: String,
    /// The nodes; empty for the bus.
    pub nodes: Vec<u8>,
    /// The axes of a drive, from 1; empty for other kinds.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub axes: Vec<u8>,
    /// When it began, in seconds with the digits of the log.
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub start: LogTime,
    /// When it was over; absent for what is not over.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "Option<String>"))]
    pub end: Option<LogTime>,
    /// What happened.
    pub text: String,
    /// How many events it has.
    pub events: u64,
    /// The first and the last of its frames.
    pub frames: Vec<NodeEvent>,
    /// The likely causes, the likeliest first.
    pub causes: &'static [&'static str],
    /// What to check, in this order.
    pub checks: &'static [&'static str],
    /// Why it matters.
    pub why: &'static str,
    /// What the rule needs, without which it would not have found it.
    pub needs: &'static str,
    #[serde(skip)]
    pub(super) about: u32,
}

fn id<S: Serializer>(kind: &&'static IncidentKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(kind.rule.id)
}

fn name<S: Serializer>(state: &IncidentState, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(state.name())
}

//! What went wrong on a bus: events of one kind and subject are an incident, and what it causes belongs to it.

mod book;
mod causes;
mod drive;

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

pub(crate) use self::book::{IncidentBook, Subject};
pub(crate) use self::drive::{Drives, words_in};
use crate::log::LogTime;
use crate::{BusReport, NodeEvent};
use objdict_lint::recorded::traffic::IncidentKind;
use objdict_model::source::Fnv;

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
    #[serde(skip)]
    about: u32,
}

fn id<S: Serializer>(kind: &&'static IncidentKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(kind.rule.id)
}

fn name<S: Serializer>(state: &IncidentState, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(state.name())
}

/// The incidents of all buses in their order, with numbers and fingerprints, which no time of the log decides.
pub fn incidents(reports: &mut [BusReport]) -> Vec<Incident> {
    let mut all: Vec<Incident> =
        reports.iter_mut().flat_map(|report| std::mem::take(&mut report.incidents)).collect();
    all.sort_by(|a, b| {
        let key = |of: &Incident| (of.state, of.start, of.kind.rule.id, of.about);
        key(a).cmp(&key(b)).then_with(|| a.nodes.cmp(&b.nodes))
    });
    let mut seen: BTreeMap<u64, u64> = BTreeMap::new();
    let mut in_time: Vec<&mut Incident> = all.iter_mut().collect();
    in_time.sort_by_key(|incident| incident.start);
    for incident in in_time {
        let mut hash = Fnv::new();
        let parts = [incident.kind.rule.id, &incident.channel];
        parts.iter().for_each(|part| hash.field(part.as_bytes()));
        [&incident.nodes, &incident.axes].iter().for_each(|part| hash.field(part));
        hash.field(&incident.about.to_le_bytes());
        let count = seen.entry(hash.0).or_default();
        *count += 1;
        hash.field(&count.to_le_bytes());
        incident.fingerprint = format!("{:016x}", hash.0);
    }
    all.iter_mut().zip(1..).for_each(|(incident, number)| incident.number = number);
    all
}

/// What a list of incidents says in one line.
pub fn verdict(incidents: &[Incident]) -> String {
    let counts = IncidentState::ALL.map(|state| {
        let count = incidents.iter().filter(|incident| incident.state == state).count();
        (state, count)
    });
    let word = match counts.map(|(_, count)| count > 0) {
        [true, ..] => "needs attention",
        [_, true, _] => "problems occurred, all recovered",
        [.., true] => "no problems, but warnings",
        _ => return "no incidents".to_owned(),
    };
    let counts = counts.iter().filter(|(_, count)| *count > 0);
    let counts: Vec<String> = counts
        .map(|(state, count)| {
            let plural = if *state == IncidentState::Warning && *count > 1 { "s" } else { "" };
            format!("{count} {}{plural}", state.name())
        })
        .collect();
    format!("{word}: {}", counts.join(", "))
}

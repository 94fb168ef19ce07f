//! What went wrong on a bus: events of one kind and subject are an incident, and what it causes belongs to it.

mod book;
mod causes;
mod drive;
mod found;

use std::collections::BTreeMap;

pub(crate) use self::book::{IncidentBook, Subject};
pub(crate) use self::drive::{Drives, words_in};
pub use self::found::{Incident, IncidentState};
use objdict_model::source::Fnv;

/// The incidents of a bus, each with its consequences.
pub(crate) fn with_consequences(book: &mut IncidentBook, channel: &str) -> Vec<Incident> {
    causes::incidents(book.take(), channel)
}

/// The incidents of all buses in their order, with numbers and fingerprints, which no time of the log decides.
pub(crate) fn numbered(mut all: Vec<Incident>) -> Vec<Incident> {
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

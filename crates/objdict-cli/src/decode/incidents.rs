//! What went wrong, as text: a verdict with a list, and one incident.

use std::io::{self, Write};

use super::super::ending::Failure;
use super::super::stdout::Output;
use super::super::table::fit;
use objdict_traffic::{Incident, IncidentState};

/// The most characters of a line.
pub(super) const LINE: usize = 200;

/// The most incidents of a state that the list shows.
const LISTED: usize = 100;

/// Writes the verdict and the list.
pub(super) fn write(verdict: &str, incidents: &[Incident], out: &mut dyn Write) -> io::Result<()> {
    let mut letters = verdict.chars();
    let first = letters.next().map(|first| first.to_ascii_uppercase());
    writeln!(out, "{}", first.into_iter().chain(letters).collect::<String>())?;
    for (state, title) in IncidentState::ALL.into_iter().zip(["Unresolved", "Recovered", "Warnings"]) {
        let of_state: Vec<&Incident> = incidents.iter().filter(|incident| incident.state == state).collect();
        if of_state.is_empty() {
            continue;
        }
        writeln!(out, "\n{title}:")?;
        for incident in of_state.iter().take(LISTED) {
            let Incident { number, start, text, kind, .. } = incident;
            writeln!(
                out,
                "  {number:>2}  {start}  {}{} [{}]",
                channel(incident),
                fit(text, LINE),
                kind.rule.id
            )?;
        }
        if of_state.len() > LISTED {
            writeln!(out, "  and {} more", of_state.len() - LISTED)?;
        }
    }
    Ok(())
}

/// Writes one incident: its frames, causes, and what to check.
pub(super) fn write_one(number: usize, incidents: &[Incident], out: &mut Output) -> Result<(), Failure> {
    let incident = one(number, incidents)?;
    let Incident { state, text, fingerprint, kind, frames, causes, checks, why, needs, .. } = incident;
    writeln!(out, "{number}  {}: {}{text}", state.name(), channel(incident))?;
    writeln!(out, "   {}, fingerprint {fingerprint}\n\n   Frames:", kind.rule.id)?;
    for event in frames {
        writeln!(out, "     {}  {}", event.moment.time, fit(&event.text, LINE))?;
        writeln!(out, "       line {}: {}", event.moment.line, fit(&event.moment.text, LINE))?;
    }
    for (title, lines) in [("Likely causes", causes), ("What to check", checks)] {
        writeln!(out, "\n   {title}:")?;
        for (line, at) in lines.iter().zip(1..) {
            writeln!(out, "     {at}. {line}")?;
        }
    }
    writeln!(out, "\n   Why it matters: {why}\n   What the rule needs: {needs}")?;
    Ok(())
}

/// The incident of a number.
pub(super) fn one(number: usize, incidents: &[Incident]) -> Result<&Incident, Failure> {
    incidents.iter().find(|incident| incident.number == number).ok_or_else(|| {
        let message = format!("there is no incident {number}: the log has {}", incidents.len());
        Failure::new(message).help("run `objdict decode LOG --summary` for the list")
    })
}

fn channel(incident: &Incident) -> String {
    if incident.channel.is_empty() { String::new() } else { format!("{}: ", incident.channel) }
}

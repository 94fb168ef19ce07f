//! What is not as the descriptions say, as findings in a log.

use super::{BusReport, NodeEvent};
use objdict_model::diagnostic::Findings;
use objdict_model::source::{SourceFile, Span};

/// What is against the rules in a log, in its order, and the lines of it: of a log of any length no others are kept.
pub fn findings(reports: &[BusReport], log: usize, name: String) -> (SourceFile, Findings) {
    let mut events: Vec<&NodeEvent> = reports.iter().flat_map(|bus| bus.against_rules(log)).collect();
    events.sort_by_key(|event| event.moment.line);
    let of_one_line = || events.chunk_by(|event, next| event.moment.line == next.moment.line);
    let lines = of_one_line().map(|events| (events[0].moment.line, events[0].moment.text.as_str()));
    let lines = SourceFile::from_lines(name, lines);
    let mut found = Findings::new();
    for (at, events) in of_one_line().enumerate() {
        let line = lines.lines().line_span(lines.text(), at);
        let line = Span::new(line.start, line.end.saturating_sub(1));
        events.iter().filter_map(|event| event.finding(line)).for_each(|finding| found.push(finding));
    }
    (lines, found)
}

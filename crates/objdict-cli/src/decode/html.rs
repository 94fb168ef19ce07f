//! A page of the traffic.

use std::path::Path;

use super::super::ending::{Failure, note};
use super::super::written_files::save;
use super::summary::{self, MESSAGES, NODES, TrafficSummaryJson};
use objdict_document::TrafficTable;
use objdict_model::diagnostic::plural;
use objdict_traffic::{BusReport, Buses, PageTexts, Recording};

/// Writes the page of a recording with the sums over the same frames.
pub(super) fn write(
    path: &Path,
    recording: &Recording,
    document: &TrafficSummaryJson,
    buses: &Buses<'_>,
) -> Result<(), Failure> {
    for text in recording.unused() {
        note(&format!("note: no value of `{text}` is in the frames that are shown\n"));
    }
    let reports = document.buses();
    let frames: u64 = reports.iter().map(|report| report.frames).sum();
    let frames = plural(usize::try_from(frames).unwrap_or(usize::MAX), "frame");
    let texts = PageTexts {
        title: document.logs().join(", "),
        summary: format!("{frames} on {}. {}", of_buses(reports.len()), document.verdict()),
        buses: reports
            .iter()
            .map(|report| (summary::title(report), tables(report), remarks(report)))
            .collect(),
    };
    save(path, recording.html(texts, reports, document.incidents(), buses).as_bytes())?;
    Ok(())
}

fn of_buses(count: usize) -> String {
    if count == 1 { "1 bus".to_owned() } else { format!("{count} buses") }
}

fn tables(report: &BusReport) -> Vec<TrafficTable> {
    let nodes = summary::node_rows(report).map(Vec::from).collect();
    let messages = summary::message_rows(report).map(Vec::from).collect();
    vec![
        TrafficTable { title: "Nodes", headings: NODES.into(), rows: nodes },
        TrafficTable { title: "Messages", headings: MESSAGES.into(), rows: messages },
    ]
}

fn remarks(report: &BusReport) -> Vec<String> {
    let further = (report.further_events > 0).then(|| {
        let count = usize::try_from(report.further_events).unwrap_or(usize::MAX);
        format!("{} that are not listed", plural(count, "further event"))
    });
    let kinds = std::iter::once(summary::kinds(report)).chain(further);
    let others = summary::remarks(report).flat_map(|(title, lines)| std::iter::once(title).chain(lines));
    kinds.chain(others).collect()
}

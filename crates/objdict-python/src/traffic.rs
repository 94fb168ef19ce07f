//! Logs of buses, read with descriptions of the nodes.
//!
//! A log reader borrows its descriptions, and a Python iterator cannot. A thread therefore owns both and sends
//! the lines of `objdict decode --format json` as far as they are requested.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use objdict::format::log::LogOptions;
use objdict::format::network::NetworkFile;
use objdict::traffic::{Buses, Descriptions, MergedLogs, NamedLog};
use pyo3::prelude::*;

use super::dictionary::NativeDictionary;
use super::network::opened;
use super::shared::SharedDescription;
use super::value::NodeId;
use super::{raised, unreadable};

/// So many frames pass to Python at once, and so many batches wait for it.
const BATCH: usize = 256;
const WAITING: usize = 4;

/// A log: its name, and its bytes if they are not in the file of this name.
type LogSource = (PathBuf, Option<Vec<u8>>);

/// What the reader of logs has to say.
enum LogMessage {
    /// Frames as lines of `objdict decode --format json`.
    Frames(Vec<String>),
    /// The logs are read to their ends, and these lines are not understood.
    End(Vec<String>),
    Failed(String),
}

/// The frames of logs, which a thread reads as long as they are asked for.
#[pyclass(frozen, module = "canopen_objdict._native")]
pub(crate) struct Frames(Mutex<Receiver<LogMessage>>);

#[pymethods]
impl Frames {
    /// Some frames as JSON, and whether that is all; then the lines are warnings.
    fn next(&self, py: Python<'_>) -> PyResult<(Vec<String>, bool)> {
        match py.detach(|| self.0.lock().unwrap_or_else(PoisonError::into_inner).recv()) {
            Ok(LogMessage::Frames(lines)) => Ok((lines, false)),
            Ok(LogMessage::End(warnings)) => Ok((warnings, true)),
            Ok(LogMessage::Failed(text)) => Err(raised(text)),
            Err(_) => Err(raised("the log was read to its end before, or its reader failed")),
        }
    }
}

/// Whether a file describes a network.
#[pyfunction]
pub(crate) fn is_network(path: PathBuf) -> PyResult<bool> {
    NetworkFile::is_network(&path).map_err(unreadable)
}

/// The frames of logs in the order of their times.
#[pyfunction]
pub(crate) fn decode(
    py: Python<'_>,
    logs: Vec<LogSource>,
    networks: Vec<PathBuf>,
    devices: Vec<(Option<NodeId>, PyRef<'_, NativeDictionary>)>,
) -> PyResult<Frames> {
    let devices: Vec<(Option<u8>, Arc<SharedDescription>)> =
        devices.iter().map(|(node_id, device)| (node_id.map(|node| node.0), device.now())).collect();
    let descriptions = py.detach(|| describe(&networks, &devices))?;
    let (sender, receiver) = sync_channel(WAITING);
    thread::spawn(move || {
        let last = match send(&logs, &descriptions, &sender) {
            Ok(warnings) => LogMessage::End(warnings),
            Err(text) => LogMessage::Failed(text),
        };
        // who asks no more has dropped the receiver
        sender.send(last).ok();
    });
    Ok(Frames(Mutex::new(receiver)))
}

fn describe(
    networks: &[PathBuf],
    devices: &[(Option<u8>, Arc<SharedDescription>)],
) -> PyResult<Descriptions> {
    let mut descriptions = Descriptions::default();
    for path in networks {
        descriptions.add_network(&opened(path)?);
    }
    for (node_id, shared) in devices {
        let name = shared.source().name();
        let path = shared.path.clone().unwrap_or_else(|| name.into());
        descriptions.add_device(shared.device().clone(), node_id.or(shared.node_id), &path, name.to_owned());
    }
    Ok(descriptions)
}

/// Reads logs as long as frames are asked for, and returns the lines that are not understood.
fn send(
    sources: &[LogSource],
    descriptions: &Descriptions,
    sender: &SyncSender<LogMessage>,
) -> Result<Vec<String>, String> {
    let failed = |error: io::Error| format!("cannot read the log: {error}");
    let mut buses = Buses::new(&[], descriptions);
    if buses.is_open() {
        buses.find(&mut open(sources)?).map_err(failed)?;
    }
    let mut logs = open(sources)?;
    let mut lines = Vec::with_capacity(BATCH);
    while let Some((log, frame)) = logs.next_frame().map_err(failed)? {
        let at = buses.of(log, &frame, &logs);
        let bus = &mut buses.all[at];
        let decoded = bus.decode(&frame);
        lines.push(bus.json(&decoded, &frame));
        if lines.len() == BATCH && sender.send(LogMessage::Frames(std::mem::take(&mut lines))).is_err() {
            return Ok(Vec::new());
        }
    }
    sender.send(LogMessage::Frames(lines)).ok();
    match logs.0.iter().find_map(NamedLog::problem) {
        Some(problem) => Err(problem),
        None => Ok(logs.0.iter().flat_map(NamedLog::warnings).collect()),
    }
}

fn open(sources: &[LogSource]) -> Result<MergedLogs<Box<dyn BufRead + '_>>, String> {
    sources.iter().map(opened_log).collect::<Result<_, _>>().map(MergedLogs)
}

fn opened_log((path, bytes): &LogSource) -> Result<NamedLog<Box<dyn BufRead + '_>>, String> {
    let name = path.display().to_string();
    let source: Box<dyn BufRead + '_> = match bytes {
        Some(bytes) => Box::new(bytes.as_slice()),
        None => {
            let file = File::open(path).map_err(|error| format!("cannot read `{name}`: {error}"))?;
            Box::new(BufReader::new(file))
        }
    };
    Ok(NamedLog::new(name, source, LogOptions::default()))
}

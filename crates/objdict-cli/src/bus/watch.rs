//! `objdict bus watch`.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::io::{self, BufReader, Read, Write};
use std::rc::Rc;

use objdict_can::{BusClient, ClientError, is_heartbeat_due};
use objdict_traffic::log::LogOptions;
use objdict_traffic::{DescribedNode, NamedLog};

use super::session::{BusSession, line};
use crate::args::BusWatchArgs;
use crate::decode;
use crate::ending::{Failure, Outcome, note, tell};
use crate::stdout::Output;

pub(super) fn run(args: &BusWatchArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let session = BusSession::open(&args.connect)?;
    let end = session.end(args.duration);
    note(&format!(
        "note: sends nothing; {}\n",
        if end.is_some() { "ends by itself" } else { "Ctrl-C ends it" }
    ));
    let BusSession { client, name, mut descriptions, .. } = session;
    descriptions.bit_rate = descriptions.bit_rate.or(client.bit_rate());
    let watched = Rc::new(RefCell::new(WatchEnd::default()));
    let frames = BusFrames { client, until: end.unwrap_or(u64::MAX), line: Vec::new(), end: watched.clone() };
    let log = NamedLog::new(name, Box::new(BufReader::new(frames)) as _, LogOptions::default());
    let outcome = decode::watch(args, &descriptions, log, out)?;
    let watched = watched.take();
    if let Some(error) = watched.failure {
        out.flush()?;
        return Err(error.into());
    }
    let silent: Vec<String> = descriptions.nodes.iter().filter_map(|node| watched.missing(node)).collect();
    silent.iter().for_each(|text| tell(&format!("warning: {text}\n")));
    Ok(if args.check && !silent.is_empty() { Outcome::Findings } else { outcome })
}

/// What is known when a bus was watched.
#[derive(Default)]
struct WatchEnd {
    failure: Option<ClientError>,
    /// The nodes that have sent a heartbeat.
    alive: BTreeSet<u8>,
    /// How long the bus was watched, in microseconds.
    time: u64,
}

impl WatchEnd {
    /// A configured node that should have sent its heartbeat twice, and has not.
    fn missing(&self, node: &DescribedNode) -> Option<String> {
        let node_id = node.node_id.filter(|node_id| node.is_configured && !self.alive.contains(node_id))?;
        let period = u64::try_from(node.device.value(0x1017, 0)?.as_integer()?).ok()?;
        is_heartbeat_due(period, self.time)
            .then(|| format!("{} (node {node_id}) sends no heartbeat, expected every {period} ms", node.name))
    }
}

/// The frames of a bus as the log that `candump -L` writes. It ends at a time, at an interrupt, or when the bus is lost.
struct BusFrames {
    client: BusClient,
    until: u64,
    line: Vec<u8>,
    end: Rc<RefCell<WatchEnd>>,
}

impl Read for BusFrames {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.line.is_empty() {
            let failure = match self.client.next_frame(self.until) {
                Ok(Some(frame)) => {
                    self.line = (line(&frame) + "\n").into_bytes();
                    None
                }
                Ok(None) | Err(ClientError::Interrupted) => None,
                Err(error) => Some(error),
            };
            if self.line.is_empty() {
                let states = self.client.states().iter();
                let alive =
                    states.filter(|(_, state)| state.is_some()).map(|(node_id, _)| *node_id).collect();
                *self.end.borrow_mut() = WatchEnd { failure, alive, time: self.client.now() };
            }
        }
        let count = self.line.len().min(buffer.len());
        buffer[..count].copy_from_slice(&self.line[..count]);
        self.line.drain(..count);
        Ok(count)
    }
}

//! `objdict bus watch`.

use std::cell::RefCell;
use std::io::{self, BufReader, Read, Write};
use std::rc::Rc;

use objdict_can::{BusClient, ClientError};
use objdict_traffic::NamedLog;
use objdict_traffic::log::LogOptions;

use super::session::{BusSession, line};
use crate::args::BusWatchArgs;
use crate::decode;
use crate::ending::{Failure, Outcome, note};
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
    let failure = Rc::new(RefCell::new(None));
    let frames =
        BusFrames { client, until: end.unwrap_or(u64::MAX), line: Vec::new(), failure: failure.clone() };
    let log = NamedLog::new(name, Box::new(BufReader::new(frames)) as _, LogOptions::default());
    let outcome = decode::watch(args, &descriptions, log, out)?;
    match failure.take() {
        Some(error) => {
            out.flush()?;
            Err(ClientError::into(error))
        }
        None => Ok(outcome),
    }
}

/// The frames of a bus as the log that `candump -L` writes. It ends at a time, at an interrupt, or when the bus is lost.
struct BusFrames {
    client: BusClient,
    until: u64,
    line: Vec<u8>,
    failure: Rc<RefCell<Option<ClientError>>>,
}

impl Read for BusFrames {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.line.is_empty() {
            match self.client.next_frame(self.until) {
                Ok(Some(frame)) => self.line = (line(&frame) + "\n").into_bytes(),
                Ok(None) | Err(ClientError::Interrupted) => {}
                Err(error) => *self.failure.borrow_mut() = Some(error),
            }
        }
        let count = self.line.len().min(buffer.len());
        buffer[..count].copy_from_slice(&self.line[..count]);
        self.line.drain(..count);
        Ok(count)
    }
}

//! The client of a bus: SDO transfers, NMT, and what is heard in between.

use std::collections::{BTreeMap, BTreeSet};

use objdict_bus::{Abort, BusFrame, Frame, SdoClient, SdoData, SdoStep};
use objdict_traffic::log::LoggedFrame;

use crate::sim::{data_frame, logged};
use crate::transport::{Transport, TransportError};

/// The most bytes of a value.
const LONGEST: usize = 1 << 24;

/// The length in bytes from which downloads are block transfers, if the server has them.
const BLOCK: usize = 64;

/// How often a waiting client looks whether it is interrupted, in microseconds.
const SLICE: u64 = 50_000;

/// The class of error frames of a controller that is bus off (`linux/can/error.h`).
const BUS_OFF: u32 = 0x40;

/// Why something could not be done on a bus.
#[derive(Debug)]
#[non_exhaustive]
pub enum ClientError {
    /// The adapter failed.
    Transport(TransportError),
    /// The user interrupts.
    Interrupted,
    /// The controller of the adapter left the bus after too many errors.
    BusOff,
    /// A node does not answer.
    Silent {
        /// The node.
        node_id: u8,
        /// Index and sub-index.
        entry: (u16, u8),
        /// How long the client waited, in milliseconds.
        waited: u64,
    },
    /// A node aborts a transfer.
    Refused {
        /// The node.
        node_id: u8,
        /// Index and sub-index.
        entry: (u16, u8),
        /// The reason.
        abort: Abort,
    },
    /// A value is no number: it has another length.
    NoNumber {
        /// The node.
        node_id: u8,
        /// Index and sub-index.
        entry: (u16, u8),
        /// The length in bytes.
        length: usize,
    },
    /// Another SDO client uses the channel of a node.
    OtherClient(u8),
    /// Other nodes are heard, which a broadcast would reach; without any, PDOs are.
    NotAlone(Vec<u8>),
}

objdict_model::error_messages! { ClientError:
    from TransportError as Transport
{
    Self::Transport(error) => "{error}";
    Self::Interrupted => "interrupted";
    Self::BusOff => "the adapter is bus off: it left the bus after too many errors";
    Self::Silent { node_id, entry: (index, sub), waited } =>
        "node {node_id} does not respond within {waited} ms ({index:04X}h sub-index {sub})";
    Self::Refused { node_id, entry: (index, sub), abort } =>
        "node {node_id} refuses {index:04X}h sub-index {sub}: {abort}";
    Self::NoNumber { node_id, entry: (index, sub), length } =>
        "{index:04X}h sub-index {sub} of node {node_id} is not a number: it has {length} bytes";
    Self::OtherClient(node_id) => "another SDO client sends requests to node {node_id}";
    Self::NotAlone(nodes) => "the frame would reach other nodes too: {}", list(nodes);
} }

fn list(nodes: &[u8]) -> String {
    if nodes.is_empty() {
        return "senders of PDOs".to_owned();
    }
    nodes.iter().map(u8::to_string).collect::<Vec<_>>().join(", ")
}

impl ClientError {
    /// What to do about it.
    pub const fn help(&self) -> &'static str {
        match self {
            Self::Transport(error) => error.help(),
            Self::Interrupted => "start the command again when you are ready",
            Self::BusOff => "check bit rate, wiring and termination, then restart the interface",
            Self::Silent { .. } => "check node-ID, supply and bit rate; `--timeout` waits longer",
            Self::Refused { .. } | Self::NoNumber { .. } => {
                "compare with the description: `objdict show FILE INDEX`"
            }
            Self::OtherClient(_) => "stop it, or pass `--shared` if both may use the channel",
            Self::NotAlone(_) => "disconnect them, or pass `--alone` if nothing else may be disturbed",
        }
    }

    /// The reason of the node; `None` if the transfer did not reach its end.
    pub const fn abort(&self) -> Option<Abort> {
        match self {
            Self::Refused { abort, .. } => Some(*abort),
            _ => None,
        }
    }
}

/// The result of a transfer; `None` if the node refuses it.
pub(crate) fn unless_refused<T>(result: Result<T, ClientError>) -> Result<Option<T>, ClientError> {
    match result {
        Ok(value) => Ok(Some(value)),
        Err(ClientError::Refused { .. }) => Ok(None),
        Err(error) => Err(error),
    }
}

/// The bytes of a transfer.
#[derive(Default)]
struct TransferValue(Vec<u8>);

impl SdoData for TransferValue {
    fn read(&mut self, offset: usize, buffer: &mut [u8]) -> Result<(), Abort> {
        self.0.as_slice().read(offset, buffer)
    }

    fn write(&mut self, _: usize, bytes: &[u8]) -> Result<(), Abort> {
        if self.0.len() + bytes.len() > LONGEST {
            return Err(Abort::OutOfMemory);
        }
        self.0.extend(bytes);
        Ok(())
    }
}

/// What takes each frame that is sent or received.
pub type FrameObserver = Box<dyn FnMut(&LoggedFrame)>;

/// A client on a bus.
pub struct BusClient {
    transport: Box<dyn Transport>,
    observer: Option<FrameObserver>,
    is_stopped: fn() -> bool,
    /// How long an answer may take, in microseconds.
    timeout: u64,
    is_shared: bool,
    /// The states that nodes have sent; `None` of a node that was heard without one.
    states: BTreeMap<u8, Option<u8>>,
    /// The nodes that others send SDO requests to.
    asked: BTreeSet<u8>,
    /// Whether another NMT or LSS master was heard.
    has_master: bool,
    /// Whether any frame was heard, and whether a PDO was, which does not show the node that sends it.
    is_heard: bool,
    has_pdos: bool,
}

impl BusClient {
    /// A client, which waits half a second for answers.
    pub fn new(transport: Box<dyn Transport>) -> Self {
        Self {
            transport,
            observer: None,
            is_stopped: || false,
            timeout: SdoClient::TIMEOUT,
            is_shared: false,
            states: BTreeMap::new(),
            asked: BTreeSet::new(),
            has_master: false,
            is_heard: false,
            has_pdos: false,
        }
    }

    /// Waits so many milliseconds for answers.
    #[must_use]
    pub fn with_timeout(mut self, milliseconds: u32) -> Self {
        self.timeout = u64::from(milliseconds.max(1)) * 1000;
        self
    }

    /// Shows each frame to an observer.
    #[must_use]
    pub fn with_observer(mut self, observer: FrameObserver) -> Self {
        self.observer = Some(observer);
        self
    }

    /// Interrupts the current operation as soon as this function returns true.
    #[must_use]
    pub fn with_stop(mut self, is_stopped: fn() -> bool) -> Self {
        self.is_stopped = is_stopped;
        self
    }

    /// Allows other clients on the same SDO channels.
    #[must_use]
    pub fn shared(mut self, is_shared: bool) -> Self {
        self.is_shared = is_shared;
        self
    }

    /// The time in microseconds.
    pub fn now(&self) -> u64 {
        self.transport.now()
    }

    /// The bit rate in kbit/s, where the adapter knows it.
    pub fn bit_rate(&self) -> Option<u16> {
        self.transport.bit_rate()
    }

    /// The bit rate of the bus in kbit/s. A silent bus does not show it.
    pub fn heard_bit_rate(&self) -> Option<u16> {
        self.bit_rate().filter(|_| self.is_heard)
    }

    /// No longer receives PDOs, if the adapter has filters. Who else is on the bus must be known by then.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn drop_pdos(&mut self) -> Result<(), ClientError> {
        Ok(self.transport.drop_pdos()?)
    }

    /// Whether the adapter can change its bit rate, so that the one of a device can be tested.
    pub fn has_bit_rates(&self) -> bool {
        self.transport.has_bit_rates()
    }

    /// Changes the bit rate of the adapter.
    pub(crate) fn set_bit_rate(&mut self, bit_rate: u16) -> Result<(), ClientError> {
        Ok(self.transport.set_bit_rate(bit_rate)?)
    }

    /// Whether a log is replayed.
    pub fn is_replay(&self) -> bool {
        self.transport.is_replay()
    }

    /// The nodes that were heard, with the last state that each has sent.
    pub const fn states(&self) -> &BTreeMap<u8, Option<u8>> {
        &self.states
    }

    /// Whether another master of NMT or LSS was heard.
    pub const fn has_master(&self) -> bool {
        self.has_master
    }

    /// Listens for so many milliseconds, to a log until its end.
    ///
    /// # Errors
    /// When the adapter is lost or the user interrupts.
    pub fn listen(&mut self, milliseconds: u64) -> Result<(), ClientError> {
        let until = if self.is_replay() { u64::MAX } else { self.now().saturating_add(milliseconds * 1000) };
        while self.next_frame(until)?.is_some() {}
        Ok(())
    }

    /// Refuses a node whose SDO channel another client uses.
    ///
    /// # Errors
    /// [`ClientError::OtherClient`].
    pub fn require_own(&self, node_id: u8) -> Result<(), ClientError> {
        if self.asked.contains(&node_id) && !self.is_shared {
            return Err(ClientError::OtherClient(node_id));
        }
        Ok(())
    }

    /// Refuses a broadcast if PDOs or other nodes than these were heard.
    ///
    /// # Errors
    /// [`ClientError::NotAlone`].
    pub fn require_alone(&self, but: &[u8]) -> Result<(), ClientError> {
        let others: Vec<u8> = self.states.keys().copied().filter(|id| !but.contains(id)).collect();
        if others.is_empty() && !self.has_pdos { Ok(()) } else { Err(ClientError::NotAlone(others)) }
    }

    /// Sends a frame.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn send(&mut self, frame: &BusFrame) -> Result<(), ClientError> {
        self.transport.send(frame)?;
        if let Some(observer) = &mut self.observer {
            let mut frame = logged(frame, self.transport.now());
            frame.is_sent = Some(true);
            observer(&frame);
        }
        Ok(())
    }

    /// The next frame; `None` if none came until a time in microseconds.
    ///
    /// # Errors
    /// When the adapter is lost or bus off, or the user interrupts.
    pub fn next_frame(&mut self, until: u64) -> Result<Option<LoggedFrame>, ClientError> {
        loop {
            if (self.is_stopped)() {
                return Err(ClientError::Interrupted);
            }
            let slice = if self.is_replay() { until } else { until.min(self.now().saturating_add(SLICE)) };
            match self.transport.receive(slice)? {
                Some(frame) => {
                    self.note(&frame);
                    let is_off = frame.is_error && frame.can_id & BUS_OFF != 0;
                    return if is_off { Err(ClientError::BusOff) } else { Ok(Some(frame)) };
                }
                None if self.now() >= until => return Ok(None),
                None => {}
            }
        }
    }

    /// Records the nodes and other clients that a frame reveals.
    fn note(&mut self, frame: &LoggedFrame) {
        if let Some(observer) = &mut self.observer {
            observer(frame);
        }
        if frame.is_extended || frame.is_error || frame.is_remote {
            return;
        }
        self.is_heard = true;
        let node_id = (frame.can_id & 0x7F) as u8;
        match (frame.can_id, frame.data()) {
            (0 | 0x7E5, _) => self.has_master = true,
            (0x181..=0x57F, _) => self.has_pdos = true,
            (0x601..=0x67F, _) => _ = self.asked.insert(node_id),
            // a boot-up message is of a node that becomes pre-operational
            (0x701..=0x77F, &[state]) => {
                let state = if state == 0 { 0x7F } else { state & 0x7F };
                self.states.insert(node_id, Some(state));
            }
            (0x581..=0x5FF | 0x081..=0x0FF, _) => _ = self.states.entry(node_id).or_insert(None),
            _ => {}
        }
    }

    /// Reads an entry.
    ///
    /// # Errors
    /// When the node aborts or does not answer, another client interferes, or the adapter is lost.
    pub fn upload(&mut self, node_id: u8, index: u16, sub: u8) -> Result<Vec<u8>, ClientError> {
        self.transfer(node_id, (index, sub), TransferValue::default(), |client, _, now| {
            client.upload(index, sub, now)
        })
    }

    /// Reads an entry of one to eight bytes as a number.
    ///
    /// # Errors
    /// As [`upload`](Self::upload), and [`ClientError::NoNumber`].
    pub fn number(&mut self, node_id: u8, index: u16, sub: u8) -> Result<u64, ClientError> {
        let bytes = self.upload(node_id, index, sub)?;
        if !(1..=8).contains(&bytes.len()) {
            return Err(ClientError::NoNumber { node_id, entry: (index, sub), length: bytes.len() });
        }
        Ok(bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte)))
    }

    /// Writes an entry; a long value by a block transfer if the node has those.
    ///
    /// # Errors
    /// As [`upload`](Self::upload).
    pub fn download(&mut self, node_id: u8, index: u16, sub: u8, data: &[u8]) -> Result<(), ClientError> {
        let (entry, length) = ((index, sub), data.len());
        if length > BLOCK {
            let value = TransferValue(data.to_vec());
            let begin = |client: &mut SdoClient, _: &mut TransferValue, now| {
                client.download_block(index, sub, length, now)
            };
            match self.transfer(node_id, entry, value, begin) {
                Err(ClientError::Refused { abort: Abort::UnknownCommand, .. }) => {}
                result => return result.map(drop),
            }
        }
        let begin = |client: &mut SdoClient, value: &mut TransferValue, now| {
            client.download(value, index, sub, length, now)
        };
        self.transfer(node_id, entry, TransferValue(data.to_vec()), begin).map(drop)
    }

    fn transfer(
        &mut self,
        node_id: u8,
        entry: (u16, u8),
        mut value: TransferValue,
        begin: impl FnOnce(&mut SdoClient, &mut TransferValue, u64) -> SdoStep,
    ) -> Result<Vec<u8>, ClientError> {
        self.require_own(node_id)?;
        let mut client = SdoClient::new(node_id).with_timeout(self.timeout);
        let mut step = begin(&mut client, &mut value, self.now());
        let mut is_late = false;
        loop {
            if let Some(frame) = step.frame {
                self.send(&frame.into())?;
            }
            match step.end {
                Some(Ok(_)) => return Ok(value.0),
                Some(Err(Abort::Timeout)) if is_late => {
                    return Err(ClientError::Silent { node_id, entry, waited: self.timeout / 1000 });
                }
                Some(Err(abort)) => return Err(ClientError::Refused { node_id, entry, abort }),
                None => {}
            }
            let due = client.next().unwrap_or_default();
            let frame = match self.next_frame(due).and_then(|frame| self.require_own(node_id).map(|()| frame))
            {
                Ok(frame) => frame,
                Err(error) => {
                    let end = client.abort(Abort::General);
                    // the adapter may be gone, which is the error then
                    end.frame.map(|frame| self.send(&frame.into()).ok());
                    return Err(error);
                }
            };
            let now = self.now();
            let answer = frame.as_ref().and_then(data_frame);
            step = answer.map_or_else(SdoStep::default, |frame| client.receive(&mut value, &frame, now));
            // frames of others must not hold up a time-out
            if step == SdoStep::default() {
                is_late = now >= due;
                step = client.poll(&mut value, now);
            }
        }
    }

    /// Sends an NMT command to a node, or to all with the node-ID 0.
    ///
    /// # Errors
    /// When the adapter is lost.
    pub fn command(&mut self, command: u8, node_id: u8) -> Result<(), ClientError> {
        match Frame::new(0, &[command, node_id]) {
            Some(frame) => self.send(&frame.into()),
            None => Ok(()),
        }
    }

    /// Waits up to so many milliseconds until a node sends this state; whether it did.
    ///
    /// # Errors
    /// When the adapter is lost or the user interrupts.
    pub fn wait_for(&mut self, node_id: u8, state: u8, milliseconds: u64) -> Result<bool, ClientError> {
        let until = self.now().saturating_add(milliseconds * 1000);
        self.states.insert(node_id, None);
        while self.states.get(&node_id) != Some(&Some(state)) {
            if self.next_frame(until)?.is_none() {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

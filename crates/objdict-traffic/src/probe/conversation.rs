//! Recorded frames as exchanges: the SDO channels of one node (CiA 301 §7.2.4.3), and its resets.

use super::exchange::{Exchange, NodeReset, SdoAnswer, SdoRequest};
use objdict_bus::Abort;
use objdict_document::describe::frames::{SdoTransfer, TransferStep};
use objdict_model::model::{CobId, Device, SdoChannel, predefined};

/// The frames of the SDO channels of a node, taken in their order.
#[derive(Clone, Debug)]
pub struct Conversation {
    node_id: u8,
    channels: Vec<Channel>,
    /// The reset since the last exchange.
    reset: Option<NodeReset>,
    /// Whether a reset was commanded whose boot-up message has not come yet.
    awaits_boot_up: bool,
    exchanges: Vec<Exchange>,
}

/// A server of the node, and what it is asked.
#[derive(Clone, Debug)]
struct Channel {
    request: CobId,
    response: CobId,
    transfer: SdoTransfer,
    asked: Option<Asked>,
}

/// A request that awaits its response.
#[derive(Clone, Copy, Debug)]
struct Asked {
    index: u16,
    sub: u8,
    is_download: bool,
    /// The size that the sender of the value states.
    size: Option<u32>,
    /// Whether the server has answered.
    is_answered: bool,
}

/// The most bytes of a value that is refused before it is transferred.
const LONGEST: usize = 1 << 16;

impl Conversation {
    /// The conversation with a node on its default channel.
    pub fn new(node_id: u8) -> Self {
        let default = Channel::new(
            predefined::per_node(predefined::SDO_REQUEST),
            predefined::per_node(predefined::SDO_RESPONSE),
        );
        Self { node_id, channels: vec![default], reset: None, awaits_boot_up: false, exchanges: Vec::new() }
    }

    /// The conversation with a node on its default channel and those that its description has besides (1201h to 127Fh).
    pub fn with(device: &Device, node_id: u8) -> Self {
        let mut conversation = Self::new(node_id);
        for SdoChannel { number, request, response, .. } in device.services().sdo_servers {
            let valid = request.zip(response).filter(|ids| ids.0.is_valid() && ids.1.is_valid());
            if let (2.., Some((request, response))) = (number, valid) {
                conversation.channels.push(Channel::new(request, response));
            }
        }
        conversation
    }

    /// Takes a frame; others than those of the channels, NMT commands and boot-up messages are skipped.
    pub fn take(&mut self, can_id: u32, is_extended: bool, data: &[u8]) {
        match (can_id, data) {
            (0, &[command @ (0x81 | 0x82), whom, ..])
                if !is_extended && [0, self.node_id].contains(&whom) =>
            {
                self.awaits_boot_up = true;
                self.restart(if command == 0x81 { NodeReset::All } else { NodeReset::Communication });
            }
            (_, [0, ..]) if !is_extended && can_id == 0x700 + u32::from(self.node_id) => {
                // without a command, the node was switched on
                if !std::mem::take(&mut self.awaits_boot_up) {
                    self.restart(NodeReset::All);
                }
            }
            _ => self.transfer(can_id, is_extended, data),
        }
    }

    /// What was asked and answered.
    pub fn into_exchanges(mut self) -> Vec<Exchange> {
        self.give_up();
        self.exchanges
    }

    fn transfer(&mut self, can_id: u32, is_extended: bool, data: &[u8]) {
        let node_id = self.node_id;
        let is_of = |cob_id: CobId| (cob_id.can_id(node_id), cob_id.is_extended()) == (can_id, is_extended);
        let mut ended = Vec::new();
        for channel in &mut self.channels {
            if is_of(channel.request) {
                ended.extend(channel.request(data));
            } else if is_of(channel.response) {
                ended.extend(channel.response(data));
            }
        }
        self.add(ended);
    }

    fn add(&mut self, ended: Vec<Exchange>) {
        for exchange in ended {
            let reset = self.reset.take();
            self.exchanges.push(Exchange { reset, ..exchange });
        }
    }

    fn restart(&mut self, reset: NodeReset) {
        self.give_up();
        self.reset = self.reset.max(Some(reset));
    }

    /// What is under way is not brought to its end.
    fn give_up(&mut self) {
        let ended = self.channels.iter_mut().filter_map(Channel::give_up).collect();
        self.add(ended);
    }
}

impl Channel {
    fn new(request: CobId, response: CobId) -> Self {
        Self { request, response, transfer: SdoTransfer::default(), asked: None }
    }

    /// Processes a request, and returns the exchange that it ends.
    fn request(&mut self, data: &[u8]) -> Option<Exchange> {
        // a new transfer clears the data of the previous one
        let before = if self.transfer.is_begun_by(data) { self.give_up() } else { None };
        let step = self.transfer.frame(data, true);
        let size = match step {
            TransferStep::WriteStart(size) => size,
            TransferStep::Read | TransferStep::BlockRead | TransferStep::Write => None,
            // the client needs only the beginning, or timed out
            TransferStep::Abort(_) => return self.give_up(),
            _ => return before,
        };
        let is_download = self.transfer.is_download();
        let asked = |(index, sub)| Asked { index, sub, is_download, size, is_answered: false };
        self.asked = self.transfer.entry().map(asked);
        before
    }

    /// Processes a response, and returns the exchange that it ends.
    fn response(&mut self, data: &[u8]) -> Option<Exchange> {
        let asked = self.asked.as_mut()?;
        // a late response to an aborted upload does not answer the download
        if asked.is_download && matches!(data.first()? >> 5, 0 | 2) {
            return None;
        }
        let step = self.transfer.frame(data, false);
        asked.is_answered |= step != TransferStep::Malformed;
        let is_of_entry = self.transfer.entry() == Some((asked.index, asked.sub));
        let answer = match step {
            TransferStep::Abort(code) => SdoAnswer::Abort(Abort::from(code)),
            TransferStep::Value | TransferStep::ValueStart(_) if !is_of_entry => return None,
            TransferStep::Value | TransferStep::LastSegment | TransferStep::BlockEnd => self.value(),
            TransferStep::Written if self.transfer.is_complete() => SdoAnswer::Done,
            TransferStep::ValueStart(size) => {
                asked.size = size;
                return None;
            }
            _ => return None,
        };
        self.end(answer)
    }

    /// The value that the server sent.
    fn value(&self) -> SdoAnswer {
        let bytes = self.transfer.data();
        match <[u8; 4]>::try_from(bytes) {
            Ok(bytes) if self.transfer.is_padded() => SdoAnswer::Unsized(bytes),
            _ => SdoAnswer::Bytes(bytes.to_vec()),
        }
    }

    fn end(&mut self, answer: SdoAnswer) -> Option<Exchange> {
        let Asked { index, sub, is_download, size, .. } = self.asked.take()?;
        let request = if is_download {
            let mut data = self.transfer.data().to_vec();
            // bytes that were not transferred are zeros: a server may refuse the length
            let length = length_of(size).unwrap_or(0).clamp(data.len(), data.len().max(LONGEST));
            data.resize(length, 0);
            SdoRequest::Download(data)
        } else {
            SdoRequest::Upload
        };
        Some(Exchange { reset: None, index, sub, request, answer })
    }

    /// The end of a transfer that was not brought to its end.
    fn give_up(&mut self) -> Option<Exchange> {
        let asked = self.asked?;
        match (asked.is_answered, asked.is_download) {
            (true, false) => self.end(SdoAnswer::Length(length_of(asked.size))),
            // part of a value was written: nothing is known of the rest
            (true, true) => {
                self.asked = None;
                None
            }
            (false, _) => self.end(SdoAnswer::Silence),
        }
    }
}

fn length_of(size: Option<u32>) -> Option<usize> {
    size.and_then(|size| usize::try_from(size).ok())
}

//! Recorded frames as exchanges: the SDO channels of one node (CiA 301 §7.2.4.3), and its resets.

use super::exchange::{Exchange, NodeReset, SdoAnswer, SdoRequest};
use objdict_bus::Abort;
use objdict_document::describe::frames::whole_sdo;
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
    current: Option<Transfer>,
}

/// A transfer that is under way.
#[derive(Clone, Debug)]
struct Transfer {
    index: u16,
    sub: u8,
    is_download: bool,
    data: Vec<u8>,
    /// The length that the sender of the value states.
    length: Option<usize>,
    /// Whether the server has answered.
    is_answered: bool,
    /// Whether the value is complete.
    is_complete: bool,
    /// Of a block transfer: the bytes that are confirmed, and the number of the last segment.
    block: Option<(usize, u8)>,
}

const ABORT: u8 = 4;

/// The most bytes of a value that is refused before it is transferred.
const LONGEST: usize = 1 << 16;

impl Conversation {
    /// The conversation with a node on its default channel.
    pub fn new(node_id: u8) -> Self {
        let channel = |request, response| Channel { request, response, current: None };
        let default = channel(
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
                conversation.channels.push(Channel { request, response, current: None });
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
            let is_request = is_of(channel.request);
            let Some(bytes) = whole_sdo(data, is_request) else { continue };
            if is_request {
                ended.extend(channel.request(bytes));
            } else if is_of(channel.response) {
                ended.extend(channel.response(bytes));
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
    /// Takes a request; the transfer that ends with it, or is given up for it.
    fn request(&mut self, bytes: [u8; 8]) -> Option<Exchange> {
        let [command, segment @ ..] = bytes;
        if let Some(transfer) = self.current.as_mut().filter(|transfer| transfer.is_in_block(true)) {
            transfer.block_segment(command, &segment);
            return None;
        }
        match (command >> 5, &mut self.current) {
            (1 | 2, _) | (5, _) if command >> 5 != 5 || command & 3 == 0 => return self.begin(bytes),
            (6, _) if command & 1 == 0 => return self.begin(bytes),
            (0, Some(transfer)) if transfer.is_download => transfer.segment(command, &segment),
            // the end of a block download, with the number of bytes without data
            (6, Some(transfer)) if transfer.is_download => transfer.end_of_blocks(command),
            (5, Some(transfer)) if command & 3 == 2 => transfer.confirm(segment[0]),
            (5, Some(transfer)) if command & 3 == 3 => transfer.block = Some((0, 0)),
            // a client that wants no more than the beginning, or that waited in vain
            (ABORT, Some(transfer)) if transfer.is_answered && !transfer.is_download => {
                return self.end(|transfer| SdoAnswer::Length(transfer.length));
            }
            (ABORT, Some(_)) => return self.give_up(),
            _ => {}
        }
        None
    }

    /// Takes a response; the transfer that ends with it.
    fn response(&mut self, bytes: [u8; 8]) -> Option<Exchange> {
        let [command, segment @ ..] = bytes;
        let transfer = self.current.as_mut()?;
        if transfer.is_in_block(false) {
            transfer.block_segment(command, &segment);
            return None;
        }
        transfer.is_answered = true;
        let [low, high, sub, value @ ..] = segment;
        let is_of_entry = (u16::from_le_bytes([low, high]), sub) == (transfer.index, transfer.sub);
        match (command >> 5, transfer.is_download) {
            (ABORT, _) => {
                let abort = Abort::from(u32::from_le_bytes(value));
                return self.end(|_| SdoAnswer::Abort(abort));
            }
            (2, false) if command & 2 != 0 && is_of_entry => {
                let answer = match stated(command, value) {
                    Some(bytes) => SdoAnswer::Bytes(bytes),
                    None => SdoAnswer::Unsized(value),
                };
                return self.end(|_| answer);
            }
            (2, false) if is_of_entry => transfer.length = sized(command & 1 != 0, value),
            (6, false) if command & 1 == 0 => transfer.length = sized(command & 2 != 0, value),
            (0, false) => {
                transfer.segment(command, &segment);
                if transfer.is_complete {
                    return self.end(|transfer| SdoAnswer::Bytes(transfer.data));
                }
            }
            (6, false) => {
                transfer.end_of_blocks(command);
                return self.end(|transfer| SdoAnswer::Bytes(transfer.data));
            }
            (5, true) if command & 3 == 2 => transfer.confirm(segment[0]),
            (5, true) if command & 3 == 0 => transfer.block = Some((0, 0)),
            (1 | 3, true) | (5, true) if transfer.is_complete => return self.end(|_| SdoAnswer::Done),
            _ => {}
        }
        None
    }

    fn begin(&mut self, bytes: [u8; 8]) -> Option<Exchange> {
        let before = self.give_up();
        let [command, low, high, sub, value @ ..] = bytes;
        let is_download = matches!(command >> 5, 1 | 6);
        let is_expedited = command >> 5 == 1 && command & 2 != 0;
        let data = if is_expedited { stated(command, value).unwrap_or(value.to_vec()) } else { Vec::new() };
        self.current = Some(Transfer {
            index: u16::from_le_bytes([low, high]),
            sub,
            is_download,
            data,
            length: match command >> 5 {
                1 => sized(command & 3 == 1, value),
                6 => sized(command & 2 != 0, value),
                _ => None,
            },
            is_answered: false,
            is_complete: is_expedited,
            block: None,
        });
        before
    }

    fn end(&mut self, answer: impl FnOnce(Transfer) -> SdoAnswer) -> Option<Exchange> {
        let mut transfer = self.current.take()?;
        let (index, sub) = (transfer.index, transfer.sub);
        let request = match transfer.is_download {
            // bytes that were not transferred are zeros: a server may refuse the length
            true => {
                let (length, sent) = (transfer.length.unwrap_or(0), transfer.data.len());
                transfer.data.resize(length.clamp(sent, sent.max(LONGEST)), 0);
                SdoRequest::Download(std::mem::take(&mut transfer.data))
            }
            false => SdoRequest::Upload,
        };
        Some(Exchange { reset: None, index, sub, request, answer: answer(transfer) })
    }

    /// The end of a transfer that was not brought to its end.
    fn give_up(&mut self) -> Option<Exchange> {
        let transfer = self.current.as_ref()?;
        match (transfer.is_answered, transfer.is_download) {
            (true, false) => self.end(|transfer| SdoAnswer::Length(transfer.length)),
            // part of a value was written: nothing is known of the rest
            (true, true) => {
                self.current = None;
                None
            }
            (false, _) => self.end(|_| SdoAnswer::Silence),
        }
    }
}

impl Transfer {
    /// Whether segments of blocks come from the client (or the server).
    const fn is_in_block(&self, from_client: bool) -> bool {
        self.block.is_some() && !self.is_complete && self.is_download == from_client
    }

    fn segment(&mut self, command: u8, segment: &[u8; 7]) {
        let used = 7 - usize::from(command >> 1 & 7);
        self.data.extend(&segment[..used]);
        self.is_complete = command & 1 != 0;
    }

    fn block_segment(&mut self, command: u8, segment: &[u8; 7]) {
        let Some((_, last)) = &mut self.block else { return };
        // what comes after a lost segment is sent again
        if command & 0x7F == *last + 1 {
            *last += 1;
            self.data.extend(segment);
            self.is_complete = command & 0x80 != 0;
        }
    }

    /// The receiver has so many segments of the block.
    fn confirm(&mut self, segments: u8) {
        let Some((confirmed, last)) = &mut self.block else { return };
        let length = *confirmed + 7 * usize::from(segments);
        self.is_complete &= length >= self.data.len();
        self.data.truncate(length);
        (*confirmed, *last) = (self.data.len(), 0);
    }

    fn end_of_blocks(&mut self, command: u8) {
        let unused = usize::from(command >> 2 & 7);
        self.data.truncate(self.data.len().saturating_sub(unused));
    }
}

/// The bytes of an expedited transfer that states their number.
fn stated(command: u8, value: [u8; 4]) -> Option<Vec<u8>> {
    (command & 1 != 0).then(|| value[..4 - usize::from(command >> 2 & 3)].to_vec())
}

fn sized(is_stated: bool, value: [u8; 4]) -> Option<usize> {
    usize::try_from(u32::from_le_bytes(value)).ok().filter(|_| is_stated)
}

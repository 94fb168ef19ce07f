//! Recorded frames as exchanges: the SDO channel of one node (CiA 301 §7.2.4.3).

use super::exchange::{Exchange, SdoAnswer, SdoRequest};
use crate::bus::Abort;

/// The frames of the default SDO channel of a node, taken in their order.
#[derive(Clone, Debug)]
pub struct Conversation {
    node_id: u8,
    current: Option<Transfer>,
    exchanges: Vec<Exchange>,
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
    /// The conversation with a node.
    pub const fn new(node_id: u8) -> Self {
        Self { node_id, current: None, exchanges: Vec::new() }
    }

    /// Takes a frame with an 11-bit CAN-ID; others than those of the channel are skipped.
    pub fn take(&mut self, can_id: u32, data: &[u8]) {
        let Ok(bytes) = <[u8; 8]>::try_from(data) else { return };
        if can_id == 0x600 + u32::from(self.node_id) {
            self.request(bytes);
        } else if can_id == 0x580 + u32::from(self.node_id) {
            self.response(bytes);
        }
    }

    /// What was asked and answered.
    pub fn into_exchanges(mut self) -> Vec<Exchange> {
        self.give_up();
        self.exchanges
    }

    fn request(&mut self, bytes: [u8; 8]) {
        let [command, segment @ ..] = bytes;
        if let Some(transfer) = self.current.as_mut().filter(|transfer| transfer.is_in_block(true)) {
            return transfer.block_segment(command, &segment);
        }
        match (command >> 5, &mut self.current) {
            (1 | 2, _) | (5, _) if command >> 5 != 5 || command & 3 == 0 => self.begin(bytes),
            (6, _) if command & 1 == 0 => self.begin(bytes),
            (0, Some(transfer)) if transfer.is_download => transfer.segment(command, &segment),
            // the end of a block download, with the number of bytes without data
            (6, Some(transfer)) if transfer.is_download => transfer.end_of_blocks(command),
            (5, Some(transfer)) if command & 3 == 2 => transfer.confirm(segment[0]),
            (5, Some(transfer)) if command & 3 == 3 => transfer.block = Some((0, 0)),
            (ABORT, Some(transfer)) => {
                // a client that wants no more than the beginning, or that waited in vain
                if transfer.is_answered && !transfer.is_download {
                    self.end(|transfer| SdoAnswer::Length(transfer.length));
                } else {
                    self.give_up();
                }
            }
            _ => {}
        }
    }

    fn response(&mut self, bytes: [u8; 8]) {
        let [command, segment @ ..] = bytes;
        let Some(transfer) = &mut self.current else { return };
        if transfer.is_in_block(false) {
            return transfer.block_segment(command, &segment);
        }
        transfer.is_answered = true;
        let [low, high, sub, value @ ..] = segment;
        let is_of_entry = (u16::from_le_bytes([low, high]), sub) == (transfer.index, transfer.sub);
        match (command >> 5, transfer.is_download) {
            (ABORT, _) => {
                let abort = Abort::from(u32::from_le_bytes(value));
                self.end(|_| SdoAnswer::Abort(abort));
            }
            (2, false) if command & 2 != 0 && is_of_entry => {
                let answer = match stated(command, value) {
                    Some(bytes) => SdoAnswer::Bytes(bytes),
                    None => SdoAnswer::Unsized(value),
                };
                self.end(|_| answer);
            }
            (2, false) if is_of_entry => transfer.length = sized(command & 1 != 0, value),
            (6, false) if command & 1 == 0 => transfer.length = sized(command & 2 != 0, value),
            (0, false) => {
                transfer.segment(command, &segment);
                if transfer.is_complete {
                    self.end(|transfer| SdoAnswer::Bytes(transfer.data));
                }
            }
            (6, false) => {
                transfer.end_of_blocks(command);
                self.end(|transfer| SdoAnswer::Bytes(transfer.data));
            }
            (5, true) if command & 3 == 2 => transfer.confirm(segment[0]),
            (5, true) if command & 3 == 0 => transfer.block = Some((0, 0)),
            (1 | 3, true) | (5, true) if transfer.is_complete => self.end(|_| SdoAnswer::Done),
            _ => {}
        }
    }

    fn begin(&mut self, bytes: [u8; 8]) {
        self.give_up();
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
    }

    fn end(&mut self, answer: impl FnOnce(Transfer) -> SdoAnswer) {
        let Some(mut transfer) = self.current.take() else { return };
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
        self.exchanges.push(Exchange { index, sub, request, answer: answer(transfer) });
    }

    /// The end of a transfer that was not brought to its end.
    fn give_up(&mut self) {
        match &self.current {
            Some(transfer) if transfer.is_answered && !transfer.is_download => {
                self.end(|transfer| SdoAnswer::Length(transfer.length));
            }
            // part of a value was written: nothing is known of the rest
            Some(transfer) if transfer.is_answered => self.current = None,
            Some(_) => self.end(|_| SdoAnswer::Silence),
            None => {}
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

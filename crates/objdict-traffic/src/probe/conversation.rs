//! Recorded frames as exchanges: the SDO channels of one node (CiA 301 §7.2.4.3), and its resets.

use std::collections::BTreeMap;

use super::exchange::{Exchange, NodeReset, SdoAnswer, SdoRequest};
use crate::log::LoggedFrame;
use crate::observed;
use objdict_bus::Abort;
use objdict_document::describe::frames::{
    DecodedFrame, FrameKind, FrameReader, SdoFrame, SdoTransfer, Talker, TransferStep,
};
use objdict_model::model::Device;

/// The frames of the SDO channels of a node, taken in their order, as `objdict decode` reads them.
#[derive(Debug)]
pub struct Conversation<'d> {
    node_id: u8,
    reader: FrameReader<'d>,
    /// What awaits its answer, by the number of the channel.
    asked: BTreeMap<u16, Asked>,
    /// The reset since the last exchange.
    reset: Option<NodeReset>,
    /// Whether a reset was commanded whose boot-up message has not come yet.
    awaits_boot_up: bool,
    exchanges: Vec<Exchange>,
}

/// A request that awaits its response.
#[derive(Clone, Debug)]
struct Asked {
    index: u16,
    sub: u8,
    is_download: bool,
    /// The bytes of the value that came with the request.
    sent: Vec<u8>,
    /// The size that the sender of the value states.
    size: Option<u32>,
    /// Whether the server has answered.
    is_answered: bool,
}

/// The most bytes of a value that is refused before it is transferred.
const LONGEST: usize = 1 << 16;

impl<'d> Conversation<'d> {
    /// The conversation with a node on its default channel.
    pub fn new(node_id: u8) -> Self {
        Self::of(FrameReader::of_bus(Vec::new()), node_id)
    }

    /// The conversation with a node on its default channel and those that its description has besides (1201h to 127Fh).
    pub fn with(device: &'d Device, node_id: u8) -> Self {
        Self::of(
            FrameReader::of_bus(vec![Talker { name: "", node_id, device, is_counterpart: false }]),
            node_id,
        )
    }

    fn of(reader: FrameReader<'d>, node_id: u8) -> Self {
        let (asked, exchanges) = Default::default();
        Self { node_id, reader, asked, reset: None, awaits_boot_up: false, exchanges }
    }

    /// Takes a frame; others than those of the channels, NMT commands and boot-up messages are skipped.
    pub fn take(&mut self, frame: &LoggedFrame) {
        let Some(frame) = observed(frame) else { return };
        let decoded = self.reader.decode(&frame);
        match (decoded.kind, frame.data) {
            (FrameKind::Nmt, &[command @ (0x81 | 0x82), whom, ..]) if [0, self.node_id].contains(&whom) => {
                self.awaits_boot_up = true;
                self.restart(if command == 0x81 { NodeReset::All } else { NodeReset::Communication });
            }
            (FrameKind::BootUp, _) if decoded.node_id == Some(self.node_id) => {
                // without a command, the node was switched on
                let was_switched_on = !std::mem::take(&mut self.awaits_boot_up);
                if was_switched_on {
                    self.restart(NodeReset::All);
                }
            }
            (FrameKind::Sdo, _) if decoded.node_id == Some(self.node_id) => self.transfer(&decoded),
            _ => {}
        }
    }

    /// What was asked and answered.
    pub fn into_exchanges(mut self) -> Vec<Exchange> {
        self.give_up();
        self.exchanges
    }

    fn transfer(&mut self, decoded: &DecodedFrame) {
        let Some((sdo, transfer)) = decoded.sdo.zip(self.reader.transfer(decoded)) else { return };
        let ended = match sdo.is_request {
            true => {
                let (before, asked) = Asked::request(&sdo, transfer, self.asked.remove(&sdo.channel));
                asked.map(|asked| self.asked.insert(sdo.channel, asked));
                before
            }
            false => {
                let (answered, asked) = Asked::response(&sdo, transfer, self.asked.remove(&sdo.channel));
                asked.map(|asked| self.asked.insert(sdo.channel, asked));
                answered
            }
        };
        self.add(ended);
    }

    fn add(&mut self, ended: impl IntoIterator<Item = Exchange>) {
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
        let ended: Vec<Exchange> =
            std::mem::take(&mut self.asked).into_values().filter_map(Asked::give_up).collect();
        self.add(ended);
    }
}

impl Asked {
    /// What a request ends, and what awaits its answer after it.
    fn request(
        sdo: &SdoFrame,
        transfer: &SdoTransfer,
        before: Option<Self>,
    ) -> (Option<Exchange>, Option<Self>) {
        let size = match sdo.step {
            TransferStep::WriteStart(size) => size,
            TransferStep::Read | TransferStep::BlockRead | TransferStep::Write => None,
            // the client needs only the beginning, or timed out
            TransferStep::Abort(_) => return (before.and_then(Self::give_up), None),
            _ => return (None, before),
        };
        let asked = sdo.entry.map(|(index, sub)| Self {
            index,
            sub,
            is_download: transfer.is_download(),
            sent: transfer.data().to_vec(),
            size,
            is_answered: false,
        });
        (before.and_then(Self::give_up), asked)
    }

    /// What a response ends, and what still awaits its answer.
    fn response(
        sdo: &SdoFrame,
        transfer: &SdoTransfer,
        asked: Option<Self>,
    ) -> (Option<Exchange>, Option<Self>) {
        let mut asked = match asked {
            Some(asked) if asked.is_answered_by(sdo, transfer) => asked,
            // a value whose request the log does not have, or that the client did not wait for
            asked => {
                let value = sdo.entry.filter(|_| sdo.step.has_value());
                let (reset, request) = (None, SdoRequest::Upload);
                let read = value.map(|(index, sub)| {
                    let answer = value_of(transfer);
                    Exchange { reset, index, sub, request, answer }
                });
                return (read, asked);
            }
        };
        let answer = match sdo.step {
            TransferStep::Abort(code) => Some(SdoAnswer::Abort(Abort::from(code))),
            step if step.has_value() => Some(value_of(transfer)),
            TransferStep::Written if transfer.is_complete() => Some(SdoAnswer::Done),
            TransferStep::ValueStart(size) => {
                asked.size = size;
                None
            }
            _ => None,
        };
        asked.is_answered = true;
        match answer {
            Some(answer) => {
                asked.sent = transfer.data().to_vec();
                (Some(asked.end(answer)), None)
            }
            None => (None, Some(asked)),
        }
    }

    /// A late response to a transfer that the client gave up does not answer the next one.
    fn is_answered_by(&self, sdo: &SdoFrame, transfer: &SdoTransfer) -> bool {
        match sdo.step {
            TransferStep::Abort(_) => true,
            TransferStep::Malformed => false,
            _ if self.is_download => transfer.is_download(),
            _ => !transfer.is_download() && sdo.entry == Some((self.index, self.sub)),
        }
    }

    fn end(self, answer: SdoAnswer) -> Exchange {
        let Self { index, sub, is_download, sent: mut data, size, .. } = self;
        let request = if is_download {
            // bytes that were not transferred are zeros: a server may refuse the length
            let length = length_of(size).unwrap_or(0).clamp(data.len(), data.len().max(LONGEST));
            data.resize(length, 0);
            SdoRequest::Download(data)
        } else {
            SdoRequest::Upload
        };
        Exchange { reset: None, index, sub, request, answer }
    }

    /// The end of a transfer that was not brought to its end.
    fn give_up(self) -> Option<Exchange> {
        match (self.is_answered, self.is_download) {
            (true, false) => {
                let length = length_of(self.size);
                Some(self.end(SdoAnswer::Length(length)))
            }
            // part of a value was written: nothing is known of the rest
            (true, true) => None,
            (false, _) => Some(self.end(SdoAnswer::Silence)),
        }
    }
}

/// The value that the server sent.
fn value_of(transfer: &SdoTransfer) -> SdoAnswer {
    let bytes = transfer.data();
    match <[u8; 4]>::try_from(bytes) {
        Ok(bytes) if transfer.is_padded() => SdoAnswer::Unsized(bytes),
        _ => SdoAnswer::Bytes(bytes.to_vec()),
    }
}

fn length_of(size: Option<u32>) -> Option<usize> {
    size.and_then(|size| usize::try_from(size).ok())
}

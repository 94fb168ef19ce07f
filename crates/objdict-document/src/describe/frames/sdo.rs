//! SDO transfers: written and read values (CiA 301 §7.2.4.3).

use std::collections::BTreeMap;

use super::decoded::{SdoFrame, TransferStep};

/// The maximum number of stored bytes of a value.
const LONGEST: usize = 1 << 24;

/// The maximum number of displayed bytes of a value.
const SHOWN: usize = 1 << 16;

/// The present transfer of one channel, as its frames show it.
#[derive(Clone, Debug, Default)]
pub struct SdoTransfer {
    entry: Option<(u16, u8)>,
    is_download: bool,
    /// The known part of the value, which remains after an abort.
    data: Vec<u8>,
    is_padded: bool,
    is_complete: bool,
    is_aborted: bool,
    /// Whether a download was asked for and has not ended.
    is_open: bool,
    /// The download that a late response to an earlier upload interrupted.
    interrupted: Option<Box<SdoTransfer>>,
    blocks: Option<Blocks>,
}

/// The state of a block transfer.
#[derive(Clone, Copy, Debug, Default)]
struct Blocks {
    /// Whether segments are sent now.
    is_open: bool,
    /// The bytes of the blocks that were accepted.
    accepted: usize,
    /// The number of the last segment of this block that arrived in order.
    last: u8,
    /// Whether the segment that ends the value is among them.
    has_end: bool,
}

/// The transfers by node-ID of the server and number of the channel, and whether the server has answered.
#[derive(Debug, Default)]
pub(super) struct Transfers(BTreeMap<(u8, u16), (SdoTransfer, bool)>);

impl Transfers {
    pub(super) fn frame(&mut self, channel: (u8, u16), data: &[u8], is_request: bool) -> SdoFrame {
        let (transfer, is_answered) = self.0.entry(channel).or_default();
        *is_answered |= !is_request;
        let step = transfer.frame(data, is_request);
        SdoFrame { entry: transfer.entry, step, channel: channel.1, is_request }
    }

    /// The known value of a transfer, with `length` bytes if the transfer does not state its length.
    pub(super) fn value(&self, channel: (u8, u16), length: impl FnOnce() -> Option<u8>) -> &[u8] {
        let Some(transfer) = self.get(channel) else { return &[] };
        let length = if transfer.is_padded { length() } else { None };
        let shown = length.map_or(SHOWN, usize::from).min(transfer.data.len());
        &transfer.data[..shown]
    }

    /// The entry that was written to a server of which the log has no answer at all.
    pub(super) fn unanswered_write(&self, channel: (u8, u16)) -> Option<(u16, u8)> {
        let (transfer, _) = self.0.get(&channel).filter(|(_, is_answered)| !is_answered)?;
        transfer.entry.filter(|_| transfer.is_open && transfer.is_complete)
    }

    /// The transfer of a channel.
    pub(super) fn get(&self, channel: (u8, u16)) -> Option<&SdoTransfer> {
        self.0.get(&channel).map(|(transfer, _)| transfer)
    }
}

/// The eight bytes of an SDO frame; `None` if significant bytes are missing. Hand-made requests often lack
/// insignificant bytes at the end, and nodes respond to them.
fn whole(data: &[u8], is_request: bool) -> Option<[u8; 8]> {
    let mut bytes = [0; 8];
    bytes.get_mut(..data.len())?.copy_from_slice(data);
    let [command, _, _, _, value @ ..] = bytes;
    let needed = match command >> 5 {
        2 if is_request => 4,
        1 if is_request => 4 + expedited(command, value).map_or(4, Iterator::count),
        _ => 8,
    };
    (data.len() >= needed).then_some(bytes)
}

impl SdoTransfer {
    /// Processes a frame from the client (a request) or the server, and returns the resulting step.
    pub fn frame(&mut self, data: &[u8], is_request: bool) -> TransferStep {
        let whole = whole(data, is_request);
        if let Some(bytes) = whole {
            self.resume(bytes, is_request);
        }
        match whole {
            Some(bytes) if self.has_segment(is_request, bytes[0]) => self.block_segment(bytes),
            Some(bytes) if is_request => self.request(bytes),
            Some(bytes) => self.response(bytes),
            None => TransferStep::Malformed,
        }
    }

    /// Resumes an interrupted download when its client or its server continues.
    fn resume(&mut self, bytes: [u8; 8], is_request: bool) {
        let goes_on = |download: &mut Box<Self>| match bytes[0] >> 5 {
            1 | 3 | 5 => true,
            4 => download.entry == Some(entry_of(bytes)),
            _ => is_request,
        };
        if let Some(download) = self.interrupted.take_if(goes_on) {
            *self = *download;
        }
    }

    /// Index and sub-index; `None` before the first transfer.
    pub const fn entry(&self) -> Option<(u16, u8)> {
        self.entry
    }

    /// Whether the client writes.
    pub const fn is_download(&self) -> bool {
        self.is_download
    }

    /// The bytes of the value that were sent.
    pub fn data(&self) -> &[u8] {
        &self.data
    }

    /// Whether these are the four bytes of an expedited transfer that does not state the length of the value.
    pub const fn is_padded(&self) -> bool {
        self.is_padded
    }

    /// Whether all bytes of the value were sent.
    pub const fn is_complete(&self) -> bool {
        self.is_complete
    }

    fn request(&mut self, bytes: [u8; 8]) -> TransferStep {
        let [command, _, _, _, value @ ..] = bytes;
        match command >> 5 {
            1 => match expedited(command, value) {
                Some(value) => {
                    self.begin(bytes, true);
                    self.data.extend(value);
                    self.is_padded = command & 1 == 0;
                    self.is_complete = true;
                    TransferStep::Write
                }
                None => {
                    self.begin(bytes, true);
                    TransferStep::WriteStart(stated_size(command & 1 != 0, value))
                }
            },
            2 => {
                self.begin(bytes, false);
                TransferStep::Read
            }
            0 => self.segment(bytes, true),
            3 if self.is_aborted => TransferStep::Stray,
            3 => TransferStep::NextSegment,
            4 => self.abort(bytes),
            5 => self.block_upload(bytes),
            6 if command & 1 == 0 => {
                self.begin(bytes, true);
                self.blocks = Some(Blocks::default());
                TransferStep::WriteStart(stated_size(command & 2 != 0, value))
            }
            6 => self.end_of_blocks(command),
            _ => TransferStep::Unknown(command),
        }
    }

    fn response(&mut self, bytes: [u8; 8]) -> TransferStep {
        let [command, _, _, _, value @ ..] = bytes;
        match command >> 5 {
            3 => {
                self.entry = Some(entry_of(bytes));
                if self.is_complete && self.is_download { self.written() } else { TransferStep::Expected }
            }
            2 => {
                self.answer(bytes);
                let Some(value) = expedited(command, value) else {
                    return TransferStep::ValueStart(stated_size(command & 1 != 0, value));
                };
                self.data.extend(value);
                self.is_padded = command & 1 == 0;
                self.is_complete = true;
                TransferStep::Value
            }
            1 if self.is_complete && self.is_download => self.written(),
            1 => TransferStep::Accepted,
            0 => self.segment(bytes, false),
            4 => self.abort(bytes),
            5 => self.block_download(bytes),
            6 if command & 1 == 0 => {
                self.answer(bytes);
                self.blocks = Some(Blocks::default());
                TransferStep::ValueStart(stated_size(command & 2 != 0, value))
            }
            6 => self.end_of_blocks(command),
            _ => TransferStep::Unknown(command),
        }
    }

    fn begin(&mut self, bytes: [u8; 8], is_download: bool) {
        let mut data = std::mem::take(&mut self.data);
        data.clear();
        let (entry, is_open) = (Some(entry_of(bytes)), is_download);
        *self = Self { entry, is_download, is_open, data, ..Self::default() };
    }

    /// A response of the server to an upload: during a download, to one that the client has abandoned.
    fn answer(&mut self, bytes: [u8; 8]) {
        let interrupted = self.is_open.then(|| Box::new(std::mem::take(self)));
        self.begin(bytes, false);
        self.interrupted = interrupted;
    }

    const fn written(&mut self) -> TransferStep {
        self.is_open = false;
        TransferStep::Written
    }

    fn abort(&mut self, bytes: [u8; 8]) -> TransferStep {
        let [_, _, _, _, code @ ..] = bytes;
        let (data, is_download) = (std::mem::take(&mut self.data), self.is_download);
        // a client that gives up may not name the entry again
        let entry = Some(entry_of(bytes)).filter(|entry| *entry != (0, 0)).or(self.entry);
        *self =
            Self { entry: entry.or(Some((0, 0))), is_download, is_aborted: true, data, ..Self::default() };
        TransferStep::Abort(u32::from_le_bytes(code))
    }

    fn extend(&mut self, bytes: &[u8]) {
        if self.data.len() < LONGEST {
            self.data.extend(bytes);
        }
    }

    /// A segment of a value; the last one completes the value.
    fn segment(&mut self, bytes: [u8; 8], is_download: bool) -> TransferStep {
        if self.entry.is_none() || self.is_download != is_download || self.is_complete || self.is_aborted {
            return TransferStep::Stray;
        }
        let [command, segment @ ..] = bytes;
        let used = 7 - (command >> 1 & 7);
        self.extend(&segment[..usize::from(used)]);
        if command & 1 == 0 {
            return TransferStep::Segment(used);
        }
        self.is_complete = true;
        TransferStep::LastSegment
    }

    /// Whether a frame is a segment of a block: its first byte is a number from 1 to 127, not a command.
    fn has_segment(&self, is_request: bool, first: u8) -> bool {
        self.is_download == is_request
            && first & 0x7F != 0
            && self.blocks.is_some_and(|blocks| blocks.is_open)
    }

    fn block_segment(&mut self, bytes: [u8; 8]) -> TransferStep {
        let [first, segment @ ..] = bytes;
        let (number, is_end) = (first & 0x7F, first & 0x80 != 0);
        if let Some(blocks) = &mut self.blocks {
            // segments after a lost one are sent again
            if number == blocks.last + 1 {
                blocks.last = number;
                blocks.has_end |= is_end;
                self.extend(&segment);
            }
        }
        TransferStep::BlockSegment(number, is_end)
    }

    /// The receiver has this many segments of a block.
    fn block_accepted(&mut self, number: u8) -> TransferStep {
        if let Some(blocks) = &mut self.blocks {
            let is_whole = number >= blocks.last;
            blocks.accepted = blocks.accepted.saturating_add(7 * usize::from(number.min(blocks.last)));
            blocks.last = 0;
            blocks.has_end &= is_whole;
            blocks.is_open = !blocks.has_end;
            self.data.truncate(blocks.accepted);
        }
        TransferStep::BlockAccepted(number)
    }

    /// Responses of a server to blocks of the client.
    fn block_download(&mut self, bytes: [u8; 8]) -> TransferStep {
        let [command, number, ..] = bytes;
        match command & 3 {
            0 => {
                self.entry = Some(entry_of(bytes));
                self.open();
                TransferStep::Expected
            }
            1 => self.written(),
            2 => self.block_accepted(number),
            _ => TransferStep::Unknown(command),
        }
    }

    /// Requests of a client that reads blocks.
    fn block_upload(&mut self, bytes: [u8; 8]) -> TransferStep {
        let [command, number, ..] = bytes;
        match command & 3 {
            0 => {
                self.begin(bytes, false);
                TransferStep::BlockRead
            }
            1 => TransferStep::BlockDone,
            2 => self.block_accepted(number),
            _ => {
                self.open();
                TransferStep::BlockStart
            }
        }
    }

    fn open(&mut self) {
        if let Some(blocks) = &mut self.blocks {
            blocks.is_open = true;
        }
    }

    /// The sender states how many bytes of the last segment do not belong to the value.
    fn end_of_blocks(&mut self, command: u8) -> TransferStep {
        if self.blocks.take().is_none() {
            return TransferStep::Stray;
        }
        let unused = usize::from(command >> 2 & 7);
        self.data.truncate(self.data.len().saturating_sub(unused));
        self.is_complete = true;
        TransferStep::BlockEnd
    }
}

fn entry_of([_, low, high, sub, ..]: [u8; 8]) -> (u16, u8) {
    (u16::from_le_bytes([low, high]), sub)
}

/// The bytes of an expedited transfer.
fn expedited(command: u8, value: [u8; 4]) -> Option<impl Iterator<Item = u8>> {
    let length = if command & 1 == 0 { 4 } else { 4 - usize::from(command >> 2 & 3) };
    (command & 2 != 0).then(|| value.into_iter().take(length))
}

/// The size of a value that is sent in segments.
fn stated_size(is_stated: bool, size: [u8; 4]) -> Option<u32> {
    is_stated.then(|| u32::from_le_bytes(size))
}

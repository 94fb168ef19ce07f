//! SDO servers: one channel each.

mod block;
mod client;
pub(crate) mod crc;

use crate::frame::{EXTENDED, NOT_VALID, can_id};
use crate::{Abort, Dictionary, Frame};

use block::Block;

pub use client::{SdoClient, SdoData, SdoStep};

/// The server of one SDO channel (CiA 301 §7.2.4): expedited, segmented and block transfers of values of at most `BUFFER` bytes.
///
/// It is independent of drivers and clocks: [`SdoServer::receive`] processes a frame, [`SdoServer::poll`] the time, and
/// each returns at most one frame to send.
#[derive(Clone, Debug)]
pub struct SdoServer<const BUFFER: usize> {
    object: u16,
    node_id: u8,
    timeout: u64,
    transfer: ServerState,
    /// The entry of the transfer as in a frame: index and sub-index.
    entry: [u8; 3],
    /// The time of the last frame in either direction.
    since: u64,
    /// Bytes of the value that were transferred.
    done: usize,
    /// Bytes of the value; for a download, as far as the client states it.
    length: Option<usize>,
    /// Whether the dictionary transfers the value in pieces; otherwise it is in the buffer.
    in_pieces: bool,
    buffer: [u8; BUFFER],
}

/// The frame that the server waits for.
#[derive(Clone, Copy, Debug)]
enum ServerState {
    None,
    /// A segment with this toggle bit.
    Download {
        toggle: u8,
    },
    /// The request of a segment with this toggle bit.
    Upload {
        toggle: u8,
    },
    BlockDownload(Block),
    BlockDownloadEnd(Block),
    BlockUploadStart(Block),
    BlockUpload(Block),
    BlockUploadEnd(Block),
}

/// The first byte and the last four bytes of a response; the entry is in between.
type AnswerBytes = (u8, [u8; 4]);

impl<const BUFFER: usize> SdoServer<BUFFER> {
    /// Default timeout for [`SdoServer::with_timeout`], in microseconds: time without a frame after which a
    /// transfer is aborted.
    pub const TIMEOUT: u64 = 500_000;

    /// The server of the channel with this number: 0 for the default channel, whose COB-IDs no device can change, `n` for the channel
    /// of object 1200h + `n`.
    #[must_use]
    pub const fn new(number: u8, node_id: u8) -> Self {
        Self {
            object: 0x1200 | (number & 0x7F) as u16,
            node_id,
            timeout: Self::TIMEOUT,
            transfer: ServerState::None,
            entry: [0; 3],
            since: 0,
            done: 0,
            length: None,
            in_pieces: false,
            buffer: [0; BUFFER],
        }
    }

    /// Sets the timeout in microseconds after which a transfer without a frame is aborted. After half of it the server
    /// acknowledges the received part of a sub-block, so that the client repeats a lost last segment.
    #[must_use]
    pub const fn with_timeout(mut self, timeout: u64) -> Self {
        self.timeout = timeout;
        self
    }

    /// Whether a transfer is pending.
    #[must_use]
    pub const fn is_busy(&self) -> bool {
        !matches!(self.transfer, ServerState::None)
    }

    /// Abandons a pending transfer without a response, as when the node stops or resets.
    pub const fn reset(&mut self) {
        self.transfer = ServerState::None;
    }

    /// Processes a frame received at `now`, in microseconds, and returns the response. Frames for other
    /// channels are ignored.
    pub fn receive<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        frame: &Frame,
        now: u64,
    ) -> Option<Frame> {
        let (request, response) = self.cob_ids(dictionary)?;
        if frame.id() != can_id(request) || frame.data().len() != 8 {
            return None;
        }
        self.since = now;
        let bytes = frame.bytes();
        let answer = match self.transfer {
            ServerState::BlockDownload(block) if bytes[0] != 0x80 => {
                self.take_segment(dictionary, block, bytes)
            }
            _ => self.answer(dictionary, bytes),
        };
        self.send(response, answer)
    }

    /// Returns a frame that is due at `now`, in microseconds: the next segment of a block upload, or an abort after a
    /// timeout. Call it until it returns `None`.
    pub fn poll<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, now: u64) -> Option<Frame> {
        if !self.is_busy() {
            return None;
        }
        let (_, response) = self.cob_ids(dictionary)?;
        let waited = now.saturating_sub(self.since);
        let due = match &mut self.transfer {
            _ if waited >= self.timeout => Err(Abort::Timeout),
            ServerState::BlockUpload(block) if block.is_sending() => {
                self.since = now;
                self.next_segment(dictionary)
            }
            ServerState::BlockDownload(block)
                if waited >= self.timeout / 2 && block.may_be_late(self.length.is_some(), self.done) =>
            {
                Ok(Some(block.acknowledge_late()))
            }
            _ => Ok(None),
        };
        self.send(response, due)
    }

    /// The time at which [`SdoServer::poll`] has a frame to send if none arrives.
    #[must_use]
    pub fn next(&self, now: u64) -> Option<u64> {
        let after = |time| Some(self.since.saturating_add(time));
        match &self.transfer {
            ServerState::None => None,
            ServerState::BlockUpload(block) if block.is_sending() => Some(now),
            ServerState::BlockDownload(block) if block.may_be_late(self.length.is_some(), self.done) => {
                after(self.timeout / 2)
            }
            _ => after(self.timeout),
        }
    }

    /// The COB-IDs of request and response; `None` while the channel is not valid.
    fn cob_ids<D: Dictionary + ?Sized>(&self, dictionary: &mut D) -> Option<(u32, u32)> {
        if self.object == 0x1200 {
            let node_id = u32::from(self.node_id);
            return Some((0x600 + node_id, 0x580 + node_id));
        }
        if !dictionary.objects().has(0x1201) {
            return None;
        }
        let mut cob_id = |sub| dictionary.number(self.object, sub).map(|number| number as u32);
        let (request, response) = (cob_id(1).ok()?, cob_id(2).ok()?);
        ((request | response) & (NOT_VALID | EXTENDED) == 0).then_some((request, response))
    }

    fn send(&mut self, response: u32, answer: Result<Option<[u8; 8]>, Abort>) -> Option<Frame> {
        let bytes = answer.unwrap_or_else(|abort| {
            self.transfer = ServerState::None;
            Some(self.with_entry((0x80, abort.code().to_le_bytes())))
        });
        Some(Frame::full(response, bytes?))
    }

    /// Whether the dictionary transfers the value in pieces; a table without programs never does.
    #[inline(always)]
    fn is_in_pieces<D: Dictionary + ?Sized>(&self, dictionary: &D) -> bool {
        dictionary.objects().has(0x1F50) && self.in_pieces
    }

    const fn with_entry(&self, (command, [a, b, c, d]): AnswerBytes) -> [u8; 8] {
        let [low, high, sub] = self.entry;
        [command, low, high, sub, a, b, c, d]
    }

    /// Index and sub-index of the transfer.
    const fn address(&self) -> (u16, u8) {
        let [low, high, sub] = self.entry;
        (u16::from_le_bytes([low, high]), sub)
    }

    /// Responds to a request outside of sub-blocks, by its command specifier. A new transfer replaces an
    /// abandoned one.
    fn answer<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        bytes: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        let [command, entry @ .., a, b, c, d] = bytes;
        let data = [a, b, c, d];
        let transfer = self.transfer;
        let starts =
            matches!(command >> 5, 1 | 2) || matches!(command & 0xE1, 0xC0) || matches!(command & 0xE3, 0xA0);
        if starts || !self.is_busy() {
            self.transfer = ServerState::None;
            self.entry = entry;
        }
        match (command >> 5, transfer) {
            (1, _) => self.start_download(dictionary, command, data).map(Some),
            (2, _) => self.start_upload(dictionary).map(Some),
            (5, _) if starts => self.start_block_upload(dictionary, command, data).map(Some),
            (6, _) if starts => self.start_block_download(dictionary, command, data).map(Some),
            (0, ServerState::Download { toggle }) => {
                self.download_segment(dictionary, toggle, bytes).map(Some)
            }
            (3, ServerState::Upload { toggle }) => self.upload_segment(dictionary, toggle, command).map(Some),
            (4, _) => {
                self.transfer = ServerState::None;
                Ok(None)
            }
            (5, _) => self.go_on_with_upload(transfer, bytes),
            (6, ServerState::BlockDownloadEnd(block)) if command & 1 == 1 => {
                self.end_block_download(dictionary, block, bytes).map(Some)
            }
            _ => Err(Abort::UnknownCommand),
        }
    }

    fn start_download<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        command: u8,
        data: [u8; 4],
    ) -> Result<[u8; 8], Abort> {
        const EXPEDITED: u8 = 2;
        const SIZE: u8 = 1;
        if command & EXPEDITED == 0 {
            let length = (command & SIZE != 0).then(|| u32::from_le_bytes(data));
            self.expect(dictionary, length)?;
            self.transfer = ServerState::Download { toggle: 0 };
        } else {
            let (index, sub) = self.address();
            let length = match command & SIZE {
                0 => dictionary.attributes(index, sub)?.size.min(4),
                _ => 4 - usize::from(command >> 2 & 3),
            };
            self.expect(dictionary, Some(length as u32))?;
            let value = data.get(..length).unwrap_or(&data);
            if self.is_in_pieces(dictionary) {
                self.keep(dictionary, value)?;
                self.finish_download(dictionary)?;
            } else {
                dictionary.write(index, sub, value)?;
            }
        }
        Ok(self.with_entry((0x60, [0; 4])))
    }

    /// Checks the conditions that are known before the data arrive: access, length, and available space.
    fn expect<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        length: Option<u32>,
    ) -> Result<(), Abort> {
        let (index, sub) = self.address();
        let attributes = dictionary.attributes(index, sub)?;
        if !attributes.writable {
            return Err(Abort::ReadOnly);
        }
        let length = length.map(|length| usize::try_from(length).unwrap_or(usize::MAX));
        self.in_pieces = dictionary.begin_write(index, sub, length)?;
        if !self.is_in_pieces(dictionary) {
            if attributes.size == 0 {
                return Err(Abort::CannotStore);
            }
            // a number has a fixed length, which is known even if the client does not state it
            let known = length.or((!attributes.has_length()).then_some(attributes.size));
            match known {
                Some(known) if known > attributes.size => return Err(Abort::TooLong),
                Some(known) if known > BUFFER.max(4) => return Err(Abort::OutOfMemory),
                _ => {}
            }
        }
        (self.done, self.length) = (0, length);
        Ok(())
    }

    fn download_segment<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        toggle: u8,
        bytes: [u8; 8],
    ) -> Result<[u8; 8], Abort> {
        const TOGGLE: u8 = 0x10;
        let [command, segment @ ..] = bytes;
        if command & TOGGLE != toggle {
            return Err(Abort::ToggleBit);
        }
        let used = 7 - usize::from(command >> 1 & 7);
        self.keep(dictionary, segment.get(..used).unwrap_or(&segment))?;
        self.transfer = ServerState::Download { toggle: toggle ^ TOGGLE };
        if command & 1 != 0 {
            self.finish_download(dictionary)?;
        }
        Ok([0x20 | toggle, 0, 0, 0, 0, 0, 0, 0])
    }

    /// Appends to the value.
    fn keep<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D, bytes: &[u8]) -> Result<(), Abort> {
        let end = self.done + bytes.len();
        if self.length.is_some_and(|length| end > length) {
            return Err(Abort::TooLong);
        }
        if self.is_in_pieces(dictionary) {
            let (index, sub) = self.address();
            dictionary.write_piece(index, sub, self.done, bytes)?;
        } else {
            let room = self.buffer.get_mut(self.done..end).ok_or(Abort::OutOfMemory)?;
            room.iter_mut().zip(bytes).for_each(|(place, &byte)| *place = byte);
        }
        self.done = end;
        Ok(())
    }

    fn finish_download<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) -> Result<(), Abort> {
        if self.length.is_some_and(|length| self.done < length) {
            return Err(Abort::TooShort);
        }
        let (index, sub) = self.address();
        self.transfer = ServerState::None;
        if self.is_in_pieces(dictionary) {
            return dictionary.end_write(index, sub, self.done);
        }
        let value = self.buffer.get(..self.done).ok_or(Abort::OutOfMemory)?;
        dictionary.write(index, sub, value)
    }

    /// Begins an upload. A value in the buffer does not change during the transfer.
    fn load<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) -> Result<usize, Abort> {
        let (index, sub) = self.address();
        let length = dictionary.begin_read(index, sub)?;
        self.in_pieces = length.is_some();
        let length = match length {
            Some(_) if !dictionary.attributes(index, sub)?.readable => return Err(Abort::WriteOnly),
            Some(length) => length,
            None => dictionary.read(index, sub, &mut self.buffer)?,
        };
        (self.done, self.length) = (0, Some(length));
        Ok(length)
    }

    fn start_upload<D: Dictionary + ?Sized>(&mut self, dictionary: &mut D) -> Result<[u8; 8], Abort> {
        let length = self.load(dictionary)?;
        if !(1..=4).contains(&length) {
            self.transfer = ServerState::Upload { toggle: 0 };
            return Ok(self.with_entry((0x41, (length as u32).to_le_bytes())));
        }
        let ([a, b, c, d, ..], ..) = self.segment(dictionary, 0)?;
        let unused = 4 - length as u8;
        Ok(self.with_entry((0x43 | unused << 2, [a, b, c, d])))
    }

    fn upload_segment<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        toggle: u8,
        command: u8,
    ) -> Result<[u8; 8], Abort> {
        if command & 0x10 != toggle {
            return Err(Abort::ToggleBit);
        }
        let (bytes, used, is_last) = self.segment(dictionary, self.done)?;
        self.done += usize::from(used);
        self.transfer =
            if is_last { ServerState::None } else { ServerState::Upload { toggle: toggle ^ 0x10 } };
        Ok(with_command(toggle | (7 - used) << 1 | u8::from(is_last), bytes))
    }

    /// The segment at the current position, the number of bytes used, and whether it is the last one.
    fn segment<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        start: usize,
    ) -> Result<([u8; 7], u8, bool), Abort> {
        let rest = self.length.unwrap_or(0).saturating_sub(start);
        let used = rest.min(7);
        let mut bytes = [0; 7];
        let piece = bytes.get_mut(..used).unwrap_or_default();
        if self.is_in_pieces(dictionary) {
            let (index, sub) = self.address();
            dictionary.read_piece(index, sub, start, piece)?;
        } else {
            let value = self.buffer.get(start..).unwrap_or_default();
            piece.iter_mut().zip(value).for_each(|(place, &byte)| *place = byte);
        }
        Ok((bytes, used as u8, rest <= 7))
    }
}

const fn with_command(command: u8, [a, b, c, d, e, f, g]: [u8; 7]) -> [u8; 8] {
    [command, a, b, c, d, e, f, g]
}

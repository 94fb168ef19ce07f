//! SDO clients: one channel each.

mod block;

use super::with_command;
use crate::frame::can_id;
use crate::{Abort, Frame};

use block::ClientBlock;

const TOGGLE: u8 = 0x10;

/// The client of one SDO channel (CiA 301 §7.2.4): expedited, segmented and block transfers of values of any length,
/// stored in an [`SdoData`].
///
/// It is independent of drivers and clocks: [`SdoClient::receive`] processes a frame, [`SdoClient::poll`] the time.
/// Pass the same data to each call of a transfer; each returns the next step. A new transfer replaces a pending one.
///
/// ```
/// use objdict_device::{Frame, SdoClient};
///
/// let (mut client, mut value) = (SdoClient::new(5), [0; 8]);
/// let step = client.upload(0x1000, 0, 0);
/// assert_eq!(step.frame, Frame::new(0x605, &[0x40, 0x00, 0x10, 0x00, 0, 0, 0, 0]));
///
/// let answer = Frame::new(0x585, &[0x43, 0x00, 0x10, 0x00, 0x91, 0x01, 0x02, 0x00]).unwrap();
/// let step = client.receive(&mut value[..], &answer, 1_000);
/// assert_eq!((step.frame, step.end), (None, Some(Ok(4))));
/// assert_eq!(value[..4], [0x91, 0x01, 0x02, 0x00]);
/// ```
#[derive(Clone, Debug)]
pub struct SdoClient {
    request: u16,
    response: u16,
    timeout: u64,
    /// Segments in a sub-block of an upload.
    block_size: u8,
    transfer: ClientState,
    /// The entry of the transfer as in a frame: index and sub-index.
    entry: [u8; 3],
    /// The time of the last frame in either direction.
    since: u64,
    /// Bytes of the value that were transferred.
    done: usize,
    /// Bytes of the value; for an upload, as far as the server states it.
    length: Option<usize>,
}

/// The frame that the client waits for.
#[derive(Clone, Copy, Debug)]
enum ClientState {
    None,
    Download,
    /// The response to a segment with this toggle bit.
    DownloadSegment(u8),
    Upload,
    /// A segment with this toggle bit.
    UploadSegment(u8),
    BlockDownload,
    BlockDownloadSegments(ClientBlock),
    BlockDownloadEnd,
    BlockUpload,
    BlockUploadSegments(ClientBlock),
    BlockUploadEnd(ClientBlock),
}

/// The bytes of a value: the source of a download and the destination of an upload. A slice is both; for a value that
/// exceeds the memory, or of unknown length, the application implements one of the two.
pub trait SdoData {
    /// Fills a buffer with the bytes at an offset. They are always available, because the length of a download is
    /// known. A block download reads lost bytes again.
    ///
    /// # Errors
    /// The code to abort the download with.
    fn read(&mut self, offset: usize, buffer: &mut [u8]) -> Result<(), Abort> {
        let _ = (offset, buffer);
        Err(Abort::NoData)
    }

    /// Stores the bytes at an offset, in order and each once, including those before a failure of the transfer, such as
    /// a wrong CRC at its end.
    ///
    /// # Errors
    /// The code to abort the upload with.
    fn write(&mut self, offset: usize, bytes: &[u8]) -> Result<(), Abort> {
        let _ = (offset, bytes);
        Err(Abort::CannotStore)
    }
}

impl SdoData for &[u8] {
    fn read(&mut self, offset: usize, buffer: &mut [u8]) -> Result<(), Abort> {
        let rest = self.get(offset..).filter(|rest| rest.len() >= buffer.len()).ok_or(Abort::NoData)?;
        buffer.iter_mut().zip(rest).for_each(|(to, from)| *to = *from);
        Ok(())
    }
}

/// [`Abort::OutOfMemory`] for a value that is longer than the slice.
impl SdoData for [u8] {
    fn read(&mut self, offset: usize, buffer: &mut [u8]) -> Result<(), Abort> {
        (&*self).read(offset, buffer)
    }

    fn write(&mut self, offset: usize, bytes: &[u8]) -> Result<(), Abort> {
        let room = self.get_mut(offset..).filter(|room| room.len() >= bytes.len());
        room.ok_or(Abort::OutOfMemory)?.iter_mut().zip(bytes).for_each(|(to, from)| *to = *from);
        Ok(())
    }
}

/// The next step of a transfer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SdoStep {
    /// The frame to send.
    pub frame: Option<Frame>,
    /// The result if the transfer has ended: the length of the value, or the reason of the server or the
    /// client.
    pub end: Option<Result<usize, Abort>>,
}

impl SdoClient {
    /// Default timeout for [`SdoClient::with_timeout`], in microseconds: time without a frame after which a
    /// transfer is aborted.
    pub const TIMEOUT: u64 = 500_000;

    /// The client of the default channel of a node.
    #[must_use]
    pub const fn new(node_id: u8) -> Self {
        let node_id = node_id as u16;
        Self::with_can_ids(0x600 + node_id, 0x580 + node_id)
    }

    /// The client of a channel with these CAN-IDs for requests and responses, as in 1280h.
    #[must_use]
    pub const fn with_can_ids(request: u16, response: u16) -> Self {
        Self {
            request: can_id(request as u32),
            response: can_id(response as u32),
            timeout: Self::TIMEOUT,
            block_size: 127,
            transfer: ClientState::None,
            entry: [0; 3],
            since: 0,
            done: 0,
            length: None,
        }
    }

    /// Sets the timeout in microseconds after which a transfer without a frame is aborted. After half of it the client
    /// acknowledges the received part of a sub-block, so that the server repeats a lost last segment.
    #[must_use]
    pub const fn with_timeout(mut self, timeout: u64) -> Self {
        self.timeout = timeout;
        self
    }

    /// Sets the number of segments per sub-block of a block upload, 1 to 127 (default: 127): as many as the
    /// driver can buffer.
    #[must_use]
    pub const fn with_block_size(mut self, segments: u8) -> Self {
        self.block_size = if block::is_size(segments) { segments } else { 127 };
        self
    }

    /// Whether a transfer is pending.
    #[must_use]
    pub const fn is_busy(&self) -> bool {
        !matches!(self.transfer, ClientState::None)
    }

    /// Begins to write a value of this length, 1 to 4 bytes expedited and others in segments, at a time in microseconds.
    pub fn download<D: SdoData + ?Sized>(
        &mut self,
        data: &mut D,
        index: u16,
        sub: u8,
        length: usize,
        now: u64,
    ) -> SdoStep {
        self.start(ClientState::Download, index, sub, Some(length), now);
        let request = self.request_download(data, length);
        self.conclude(request)
    }

    /// Begins to read a value.
    pub fn upload(&mut self, index: u16, sub: u8, now: u64) -> SdoStep {
        self.start(ClientState::Upload, index, sub, None, now);
        self.conclude(Ok(Some(self.with_entry(0x40, [0; 4]))))
    }

    /// Begins to write a value of this length by a block transfer, with a CRC if the server supports it. A server
    /// without block transfers responds with [`Abort::UnknownCommand`].
    pub fn download_block(&mut self, index: u16, sub: u8, length: usize, now: u64) -> SdoStep {
        self.start(ClientState::BlockDownload, index, sub, Some(length), now);
        self.conclude(Ok(Some(self.with_entry(0xC6, (length as u32).to_le_bytes()))))
    }

    /// Begins to read a value by a block transfer, with a CRC if the server supports it. A server may respond
    /// with a different protocol.
    pub fn upload_block(&mut self, index: u16, sub: u8, now: u64) -> SdoStep {
        self.start(ClientState::BlockUpload, index, sub, None, now);
        self.conclude(Ok(Some(self.with_entry(0xA4, [self.block_size, 0, 0, 0]))))
    }

    /// Aborts a transfer; the frame notifies the server. Does nothing if there is none.
    pub fn abort(&mut self, reason: Abort) -> SdoStep {
        if self.is_busy() { self.conclude(Err(reason)) } else { SdoStep::default() }
    }

    /// Processes a frame received at `now`, in microseconds. Frames that do not belong to this transfer are
    /// ignored.
    pub fn receive<D: SdoData + ?Sized>(&mut self, data: &mut D, frame: &Frame, now: u64) -> SdoStep {
        let is_of_channel = frame.id() == self.response && frame.data().len() == 8;
        let bytes = frame.bytes();
        let is_segment = matches!(self.transfer, ClientState::BlockUploadSegments(_)) && bytes[0] != 0x80;
        if !self.is_busy() || !is_of_channel || !is_segment && self.is_of_another_entry(bytes) {
            return SdoStep::default();
        }
        self.since = now;
        let [command, .., a, b, c, d] = bytes;
        if command == 0x80 {
            self.transfer = ClientState::None;
            let abort = Abort::from(u32::from_le_bytes([a, b, c, d]));
            return SdoStep { frame: None, end: Some(Err(abort)) };
        }
        let request = self.go_on(data, bytes);
        self.conclude(request)
    }

    /// Returns the frame that is due at `now`, in microseconds: the next segment of a block download, or an abort after
    /// a timeout. Call it until it returns no frame.
    pub fn poll<D: SdoData + ?Sized>(&mut self, data: &mut D, now: u64) -> SdoStep {
        let waited = now.saturating_sub(self.since);
        let request = match &mut self.transfer {
            ClientState::None => return SdoStep::default(),
            _ if waited >= self.timeout => Err(Abort::Timeout),
            ClientState::BlockDownloadSegments(block) if block.is_sending() => {
                let block = *block;
                self.since = now;
                self.next_block_segment(block, data).map(Some)
            }
            ClientState::BlockUploadSegments(block)
                if block.is_incomplete() && waited >= self.timeout / 2 =>
            {
                Ok(Some(block.acknowledge()))
            }
            _ => return SdoStep::default(),
        };
        self.conclude(request)
    }

    /// The time at which [`SdoClient::poll`] must be called.
    #[must_use]
    pub const fn next(&self) -> Option<u64> {
        let wait = match &self.transfer {
            ClientState::None => return None,
            ClientState::BlockDownloadSegments(block) if block.is_sending() => 0,
            ClientState::BlockUploadSegments(block) if block.is_incomplete() => self.timeout / 2,
            _ => self.timeout,
        };
        Some(self.since.saturating_add(wait))
    }

    const fn start(&mut self, transfer: ClientState, index: u16, sub: u8, length: Option<usize>, now: u64) {
        let [low, high] = index.to_le_bytes();
        self.entry = [low, high, sub];
        (self.transfer, self.length, self.done, self.since) = (transfer, length, 0, now);
    }

    fn conclude(&mut self, request: Result<Option<[u8; 8]>, Abort>) -> SdoStep {
        let (bytes, end) = match request {
            Ok(bytes) => (bytes, (!self.is_busy()).then_some(Ok(self.done))),
            Err(abort) => {
                self.transfer = ClientState::None;
                (Some(self.with_entry(0x80, abort.code().to_le_bytes())), Some(Err(abort)))
            }
        };
        SdoStep { frame: bytes.map(|bytes| Frame::full(self.request.into(), bytes)), end }
    }

    const fn with_entry(&self, command: u8, [a, b, c, d]: [u8; 4]) -> [u8; 8] {
        let [low, high, sub] = self.entry;
        [command, low, high, sub, a, b, c, d]
    }

    /// Whether a response that names an entry belongs to an earlier transfer.
    fn is_of_another_entry(&self, [command, low, high, sub, ..]: [u8; 8]) -> bool {
        let names_entry =
            matches!(command >> 5, 2..=4) || matches!(command & 0xE3, 0xA0) || matches!(command & 0xE1, 0xC0);
        names_entry && self.entry != [low, high, sub]
    }

    /// Processes a response by its command specifier, and returns the next request; none at the end of the
    /// transfer.
    fn go_on<D: SdoData + ?Sized>(&mut self, data: &mut D, bytes: [u8; 8]) -> Result<Option<[u8; 8]>, Abort> {
        let [command, ..] = bytes;
        match (command >> 5, self.transfer) {
            (_, ClientState::BlockUploadSegments(block)) => self.take_block_segment(block, data, bytes),
            (3, ClientState::Download) => self.first_segment(data),
            (1, ClientState::DownloadSegment(toggle)) => self.segment_taken(data, toggle, command),
            (2, ClientState::Upload | ClientState::BlockUpload) => self.begin_upload(data, bytes),
            (0, ClientState::UploadSegment(toggle)) => self.take_segment(data, toggle, bytes),
            (5, ClientState::BlockDownload) => self.begin_block_download(bytes),
            (5, ClientState::BlockDownloadSegments(block)) if command & 3 == 2 => {
                self.acknowledged(block, bytes)
            }
            (5, ClientState::BlockDownloadEnd) if command & 3 == 1 => {
                self.transfer = ClientState::None;
                Ok(None)
            }
            (6, ClientState::BlockUpload) if command & 1 == 0 => Ok(Some(self.begin_block_upload(bytes))),
            (6, ClientState::BlockUploadEnd(block)) if command & 1 == 1 => {
                self.end_block_upload(block, data, bytes).map(Some)
            }
            _ => Err(Abort::UnknownCommand),
        }
    }

    fn request_download<D: SdoData + ?Sized>(
        &mut self,
        data: &mut D,
        length: usize,
    ) -> Result<Option<[u8; 8]>, Abort> {
        let mut bytes = [0; 4];
        let (command, bytes) = match (length, bytes.get_mut(..length)) {
            (1..=4, Some(value)) => {
                data.read(0, value)?;
                (0x23 | (4 - length as u8) << 2, bytes)
            }
            _ => (0x21, (length as u32).to_le_bytes()),
        };
        Ok(Some(self.with_entry(command, bytes)))
    }

    /// Sends the first segment after the server accepts the download; an expedited value is already complete.
    fn first_segment<D: SdoData + ?Sized>(&mut self, data: &mut D) -> Result<Option<[u8; 8]>, Abort> {
        match self.length {
            Some(length @ 1..=4) => {
                (self.transfer, self.done) = (ClientState::None, length);
                Ok(None)
            }
            _ => self.next_segment(data, 0).map(Some),
        }
    }

    fn segment_taken<D: SdoData + ?Sized>(
        &mut self,
        data: &mut D,
        toggle: u8,
        command: u8,
    ) -> Result<Option<[u8; 8]>, Abort> {
        if command & TOGGLE != toggle {
            return Err(Abort::ToggleBit);
        }
        if self.length.is_none_or(|length| self.done >= length) {
            self.transfer = ClientState::None;
            return Ok(None);
        }
        self.next_segment(data, toggle ^ TOGGLE).map(Some)
    }

    fn next_segment<D: SdoData + ?Sized>(&mut self, data: &mut D, toggle: u8) -> Result<[u8; 8], Abort> {
        let (bytes, used, is_last) = self.segment(data, self.done)?;
        self.done += usize::from(used);
        self.transfer = ClientState::DownloadSegment(toggle);
        Ok(with_command(toggle | (7 - used) << 1 | u8::from(is_last), bytes))
    }

    /// The segment at the current position, the number of bytes used, and whether it is the last one.
    fn segment<D: SdoData + ?Sized>(&self, data: &mut D, start: usize) -> Result<([u8; 7], u8, bool), Abort> {
        let rest = self.length.unwrap_or(0).saturating_sub(start);
        let mut bytes = [0; 7];
        data.read(start, bytes.get_mut(..rest.min(7)).unwrap_or_default())?;
        Ok((bytes, rest.min(7) as u8, rest <= 7))
    }

    fn begin_upload<D: SdoData + ?Sized>(
        &mut self,
        data: &mut D,
        bytes: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        const EXPEDITED: u8 = 2;
        const SIZE: u8 = 1;
        let [command, _, _, _, value @ ..] = bytes;
        let states_length = command & SIZE != 0;
        if command & EXPEDITED != 0 {
            let used = if states_length { 4 - (command >> 2 & 3) } else { 4 };
            self.transfer = ClientState::None;
            self.keep(data, value.get(..usize::from(used)).unwrap_or(&value))?;
            return Ok(None);
        }
        self.length = states_length.then(|| length_of(value));
        Ok(Some(self.request_segment(0)))
    }

    const fn request_segment(&mut self, toggle: u8) -> [u8; 8] {
        self.transfer = ClientState::UploadSegment(toggle);
        [0x60 | toggle, 0, 0, 0, 0, 0, 0, 0]
    }

    fn take_segment<D: SdoData + ?Sized>(
        &mut self,
        data: &mut D,
        toggle: u8,
        [command, segment @ ..]: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        if command & TOGGLE != toggle {
            return Err(Abort::ToggleBit);
        }
        let used = 7 - usize::from(command >> 1 & 7);
        self.keep(data, segment.get(..used).unwrap_or(&segment))?;
        if command & 1 == 0 {
            return Ok(Some(self.request_segment(toggle ^ TOGGLE)));
        }
        self.finish_upload()?;
        Ok(None)
    }

    /// Passes on received bytes of the value.
    fn keep<D: SdoData + ?Sized>(&mut self, data: &mut D, bytes: &[u8]) -> Result<(), Abort> {
        let end = self.done.saturating_add(bytes.len());
        if self.length.is_some_and(|length| end > length) {
            return Err(Abort::LengthMismatch);
        }
        data.write(self.done, bytes)?;
        self.done = end;
        Ok(())
    }

    fn finish_upload(&mut self) -> Result<(), Abort> {
        if self.length.is_some_and(|length| self.done != length) {
            return Err(Abort::LengthMismatch);
        }
        self.transfer = ClientState::None;
        Ok(())
    }
}

/// The length that a server states; more than the memory can have is more than any value has.
fn length_of(bytes: [u8; 4]) -> usize {
    usize::try_from(u32::from_le_bytes(bytes)).unwrap_or(usize::MAX)
}

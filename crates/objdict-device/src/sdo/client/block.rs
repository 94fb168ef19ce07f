//! Block transfers (CiA 301 §7.2.4.3.9 to §7.2.4.3.15).

use super::{ClientState, SdoClient, SdoData, length_of, with_command};
use crate::Abort;
use crate::sdo::crc::crc;

/// Bit of a sequence number: the last segment of the transfer.
const LAST: u8 = 0x80;

/// The state of a block transfer.
#[derive(Clone, Copy, Debug)]
pub(super) struct ClientBlock {
    /// Whether the server has a CRC.
    has_crc: bool,
    /// The CRC of the bytes up to [`ClientBlock::counted`].
    crc: u16,
    /// For a download: the end of the segments sent so far, some of which may have to be repeated.
    counted: usize,
    /// Segments in a sub-block.
    size: u8,
    /// The sequence number of the last segment that was sent or arrived in order; 0 at the start of a
    /// sub-block.
    sequence: u8,
    /// Whether that was the last segment of the value.
    is_last: bool,
    /// For an upload: the last received segment. Only the end of the transfer states how many of its bytes
    /// are used.
    held: Option<[u8; 7]>,
}

impl ClientBlock {
    const fn new(has_crc: bool, size: u8) -> Self {
        Self { has_crc, crc: 0, counted: 0, size, sequence: 0, is_last: false, held: None }
    }

    /// Whether segments of a download are to be sent before the server acknowledges them.
    pub(super) const fn is_sending(&self) -> bool {
        self.sequence < self.size && !self.is_last
    }

    /// Whether a segment of an upload may be missing. Before the first one of a sub-block, the server may not have
    /// received the last request, and would treat a repetition as a request for everything from there on.
    pub(super) const fn is_incomplete(&self) -> bool {
        self.sequence > 0
    }

    /// Acknowledges the received segments, so that the server continues after them.
    pub(super) const fn acknowledge(&mut self) -> [u8; 8] {
        let sequence = self.sequence;
        self.sequence = 0;
        [0xA2, sequence, self.size, 0, 0, 0, 0, 0]
    }
}

impl SdoClient {
    pub(super) fn begin_block_download(&mut self, bytes: [u8; 8]) -> Result<Option<[u8; 8]>, Abort> {
        let [command, _, _, _, size, ..] = bytes;
        let block = ClientBlock::new(command & 4 != 0, accepted(size)?);
        self.transfer = ClientState::BlockDownloadSegments(block);
        Ok(None)
    }

    pub(super) fn next_block_segment<D: SdoData + ?Sized>(
        &mut self,
        mut block: ClientBlock,
        data: &mut D,
    ) -> Result<[u8; 8], Abort> {
        let start = self.done + 7 * usize::from(block.sequence);
        let (bytes, used, is_last) = self.segment(data, start)?;
        if start == block.counted {
            let value = bytes.get(..usize::from(used)).unwrap_or(&bytes);
            block.crc = crc(block.crc, value);
            block.counted += value.len();
        }
        block.sequence += 1;
        block.is_last = is_last;
        self.transfer = ClientState::BlockDownloadSegments(block);
        Ok(with_command(block.sequence | if is_last { LAST } else { 0 }, bytes))
    }

    /// Continues after the segments that the server acknowledged.
    pub(super) fn acknowledged(
        &mut self,
        mut block: ClientBlock,
        [_, sequence, size, ..]: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        if sequence > block.sequence {
            return Err(Abort::SequenceNumber);
        }
        let is_complete = block.is_last && sequence == block.sequence;
        if !is_complete {
            self.done += 7 * usize::from(sequence);
            (block.sequence, block.is_last, block.size) = (0, false, accepted(size)?);
            self.transfer = ClientState::BlockDownloadSegments(block);
            return Ok(None);
        }
        let length = self.length.unwrap_or(0);
        // an empty value has one segment too
        let unused = match length % 7 {
            0 if length > 0 => 0,
            used => 7 - used as u8,
        };
        self.done = length;
        self.transfer = ClientState::BlockDownloadEnd;
        let [low, high] = if block.has_crc { block.crc.to_le_bytes() } else { [0; 2] };
        Ok(Some([0xC1 | unused << 2, low, high, 0, 0, 0, 0, 0]))
    }

    pub(super) fn begin_block_upload(&mut self, [command, _, _, _, length @ ..]: [u8; 8]) -> [u8; 8] {
        self.length = (command & 2 != 0).then(|| length_of(length));
        self.transfer = ClientState::BlockUploadSegments(ClientBlock::new(command & 4 != 0, self.block_size));
        [0xA3, 0, 0, 0, 0, 0, 0, 0]
    }

    /// Processes a segment of an upload. A segment out of order is ignored until the end of its sub-block: the server
    /// repeats unacknowledged ones.
    pub(super) fn take_block_segment<D: SdoData + ?Sized>(
        &mut self,
        mut block: ClientBlock,
        data: &mut D,
        [command, segment @ ..]: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        let (sequence, is_last) = (command & !LAST, command & LAST != 0);
        if sequence == 0 {
            return Err(Abort::SequenceNumber);
        }
        let in_order = sequence == block.sequence + 1;
        if in_order {
            if let Some(held) = block.held.replace(segment) {
                self.keep_segment(&mut block, data, &held)?;
            }
            block.sequence = sequence;
        }
        let request = (is_last || sequence >= block.size).then(|| block.acknowledge());
        self.transfer = if is_last && in_order {
            ClientState::BlockUploadEnd(block)
        } else {
            ClientState::BlockUploadSegments(block)
        };
        Ok(request)
    }

    fn keep_segment<D: SdoData + ?Sized>(
        &mut self,
        block: &mut ClientBlock,
        data: &mut D,
        bytes: &[u8],
    ) -> Result<(), Abort> {
        block.crc = crc(block.crc, bytes);
        self.keep(data, bytes)
    }

    pub(super) fn end_block_upload<D: SdoData + ?Sized>(
        &mut self,
        mut block: ClientBlock,
        data: &mut D,
        [command, low, high, ..]: [u8; 8],
    ) -> Result<[u8; 8], Abort> {
        let used = 7 - usize::from(command >> 2 & 7);
        let held = block.held.unwrap_or_default();
        self.keep_segment(&mut block, data, held.get(..used).unwrap_or(&held))?;
        if block.has_crc && block.crc != u16::from_le_bytes([low, high]) {
            return Err(Abort::Crc);
        }
        self.finish_upload()?;
        Ok([0xA1, 0, 0, 0, 0, 0, 0, 0])
    }
}

pub(super) const fn is_size(size: u8) -> bool {
    matches!(size, 1..=127)
}

fn accepted(size: u8) -> Result<u8, Abort> {
    if is_size(size) { Ok(size) } else { Err(Abort::BlockSize) }
}

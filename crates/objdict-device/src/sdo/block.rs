//! Block transfers (CiA 301 §7.2.4.3.9 to §7.2.4.3.15).

use super::crc::crc;
use super::{SdoServer, ServerState, with_command};
use crate::{Abort, Dictionary};

/// Segments in a sub-block of a download: the maximum, because the buffer has space for all.
const SEGMENTS: u8 = 127;

/// Bit of a sequence number: the last segment of the transfer.
const LAST: u8 = 0x80;

/// The state of a block transfer. Without the feature none exists, so the compiler omits the code that
/// handles one.
#[cfg(feature = "block-transfer")]
pub(super) type Block = BlockState;

#[cfg(not(feature = "block-transfer"))]
#[derive(Clone, Copy, Debug)]
pub(super) enum Block {}

#[cfg(not(feature = "block-transfer"))]
impl core::ops::Deref for Block {
    type Target = BlockState;

    fn deref(&self) -> &BlockState {
        match *self {}
    }
}

#[cfg(not(feature = "block-transfer"))]
impl core::ops::DerefMut for Block {
    fn deref_mut(&mut self) -> &mut BlockState {
        match *self {}
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct BlockState {
    /// The CRC of the bytes so far, if the client requests one.
    crc: Option<u16>,
    /// Segments in a sub-block.
    size: u8,
    /// The sequence number of the last segment that was sent or arrived in order; 0 at the start of a
    /// sub-block.
    sequence: u8,
    /// For an upload: whether the last segment of the value was sent.
    is_last: bool,
    /// For a download: whether the segments were acknowledged because of a timeout.
    is_late: bool,
    /// For an upload: bytes included in the CRC, which must not include a segment twice.
    counted: usize,
    /// For a download: the last segment. Only the end of the transfer states how many of its bytes are used.
    last: [u8; 7],
}

/// Begins a transfer; a server without them does not know the command.
#[cfg(feature = "block-transfer")]
const fn begin(command: u8, size: u8) -> Result<Block, Abort> {
    let crc = if command & 4 == 0 { None } else { Some(0) };
    Ok(BlockState { crc, size, sequence: 0, is_last: false, is_late: false, counted: 0, last: [0; 7] })
}

#[cfg(not(feature = "block-transfer"))]
const fn begin(_: u8, _: u8) -> Result<Block, Abort> {
    Err(Abort::UnknownCommand)
}

impl BlockState {
    fn count(&mut self, bytes: &[u8]) {
        self.crc = self.crc.map(|so_far| crc(so_far, bytes));
        self.counted += bytes.len();
    }

    /// Whether segments of an upload are to be sent before the client acknowledges them.
    pub(super) const fn is_sending(&self) -> bool {
        self.sequence < self.size && !self.is_last
    }

    /// Whether the segments of a download are acknowledged after a timeout. If the last acknowledgement was lost,
    /// acknowledging no segment makes the client repeat received ones, which only a CRC or a stated length reveals.
    pub(super) const fn may_be_late(&self, has_length: bool, done: usize) -> bool {
        !self.is_late && (self.sequence > 0 || done == 0 || has_length || self.crc.is_some())
    }

    /// Acknowledges the received segments, so that the client continues after them.
    const fn acknowledge(&mut self) -> [u8; 8] {
        let sequence = self.sequence;
        self.sequence = 0;
        [0xA2, sequence, SEGMENTS, 0, 0, 0, 0, 0]
    }

    /// Acknowledges after a timeout, because the end of the sub-block was lost.
    pub(super) const fn acknowledge_late(&mut self) -> [u8; 8] {
        self.is_late = true;
        self.acknowledge()
    }
}

impl<const BUFFER: usize> SdoServer<BUFFER> {
    pub(super) fn start_block_download<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        command: u8,
        data: [u8; 4],
    ) -> Result<[u8; 8], Abort> {
        let block = begin(command, SEGMENTS)?;
        let length = (command & 2 != 0).then(|| u32::from_le_bytes(data));
        self.expect(dictionary, length)?;
        self.transfer = ServerState::BlockDownload(block);
        Ok(self.with_entry((0xA4, [SEGMENTS, 0, 0, 0])))
    }

    /// Processes a segment of a download. A segment out of order is ignored until the end of its sub-block: the client
    /// repeats unacknowledged ones.
    pub(super) fn take_segment<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        mut block: Block,
        bytes: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        let [command, segment @ ..] = bytes;
        let (sequence, is_last) = (command & !LAST, command & LAST != 0);
        if sequence == 0 {
            return Err(Abort::SequenceNumber);
        }
        block.is_late = false;
        let in_order = sequence == block.sequence + 1;
        if in_order {
            block.sequence = sequence;
            if is_last {
                block.last = segment;
            } else {
                block.count(&segment);
                self.keep(dictionary, &segment)?;
            }
        }
        let answer = (is_last || sequence >= block.size).then(|| block.acknowledge());
        self.transfer = if is_last && in_order {
            ServerState::BlockDownloadEnd(block)
        } else {
            ServerState::BlockDownload(block)
        };
        Ok(answer)
    }

    pub(super) fn end_block_download<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        mut block: Block,
        bytes: [u8; 8],
    ) -> Result<[u8; 8], Abort> {
        let [command, low, high, ..] = bytes;
        let used = 7_usize.saturating_sub(usize::from(command >> 2 & 7));
        let last = block.last;
        let last = last.get(..used).unwrap_or(&last);
        block.count(last);
        if block.crc.is_some_and(|crc| crc != u16::from_le_bytes([low, high])) {
            return Err(Abort::Crc);
        }
        self.keep(dictionary, last)?;
        self.finish_download(dictionary)?;
        Ok([0xA1, 0, 0, 0, 0, 0, 0, 0])
    }

    /// The threshold for switching to a different protocol, in the fifth byte, is ignored, as CiA 301 allows.
    pub(super) fn start_block_upload<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
        command: u8,
        [size, ..]: [u8; 4],
    ) -> Result<[u8; 8], Abort> {
        let block = begin(command, block_size(size)?)?;
        let length = self.load(dictionary)?;
        self.transfer = ServerState::BlockUploadStart(block);
        Ok(self.with_entry((0xC6, (length as u32).to_le_bytes())))
    }

    /// Processes a client frame of a block upload: start, acknowledged segments, or end.
    pub(super) fn go_on_with_upload(
        &mut self,
        transfer: ServerState,
        bytes: [u8; 8],
    ) -> Result<Option<[u8; 8]>, Abort> {
        let [command, sequence, size, ..] = bytes;
        match (command & 3, transfer) {
            (3, ServerState::BlockUploadStart(block)) => {
                self.transfer = ServerState::BlockUpload(block);
                Ok(None)
            }
            (2, ServerState::BlockUpload(block)) => self.acknowledged(block, sequence, size),
            (1, ServerState::BlockUploadEnd(block)) if block.is_last => {
                self.transfer = ServerState::None;
                Ok(None)
            }
            _ => Err(Abort::UnknownCommand),
        }
    }

    /// Continues after the segments that the client acknowledged; it may request the rest before the
    /// sub-block is complete.
    fn acknowledged(&mut self, mut block: Block, sequence: u8, size: u8) -> Result<Option<[u8; 8]>, Abort> {
        if sequence > block.sequence {
            return Err(Abort::SequenceNumber);
        }
        if block.is_last && sequence == block.sequence {
            self.transfer = ServerState::BlockUploadEnd(block);
            return Ok(Some(self.end_of_upload(block)));
        }
        self.done += 7 * usize::from(sequence);
        (block.size, block.sequence, block.is_last) = (block_size(size)?, 0, false);
        self.transfer = ServerState::BlockUpload(block);
        Ok(None)
    }

    fn end_of_upload(&self, block: Block) -> [u8; 8] {
        // an empty value has one segment too
        let unused = match self.length.unwrap_or(0) {
            0 => 7,
            length => (7 - length % 7) % 7,
        };
        let [low, high] = block.crc.unwrap_or(0).to_le_bytes();
        [0xC1 | (unused as u8) << 2, low, high, 0, 0, 0, 0, 0]
    }

    pub(super) fn next_segment<D: Dictionary + ?Sized>(
        &mut self,
        dictionary: &mut D,
    ) -> Result<Option<[u8; 8]>, Abort> {
        let ServerState::BlockUpload(mut block) = self.transfer else { return Ok(None) };
        let start = self.done + 7 * usize::from(block.sequence);
        let (bytes, used, is_last) = self.segment(dictionary, start)?;
        if start == block.counted {
            block.count(bytes.get(..usize::from(used)).unwrap_or(&bytes));
        }
        block.sequence += 1;
        block.is_last = is_last;
        self.transfer = ServerState::BlockUpload(block);
        Ok(Some(with_command(block.sequence | if is_last { LAST } else { 0 }, bytes)))
    }
}

fn block_size(size: u8) -> Result<u8, Abort> {
    if (1..=SEGMENTS).contains(&size) { Ok(size) } else { Err(Abort::BlockSize) }
}

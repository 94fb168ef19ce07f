//! BLF of Vector: objects in containers that zlib packs. There is no public document; the layout is the one of Toby Lorenz' Vector BLF and
//! of python-can.

use std::io::{self, BufRead, ErrorKind};

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit as inflate;

use super::pcap::fill;
use super::words::{BAD_ID, fits};
use super::{LogState, LogTime, LoggedFrame};

/// The most bytes of an object of the file, and of what a container unpacks to; tools write 128 KiB.
const MAX_CONTAINER: usize = 1 << 24;

/// The bytes that every object begins with: signature, size of the head, version of the head, size, type.
const HEAD: usize = 16;

/// So many bytes before an object are not padding.
const PADDING: usize = 8;

/// The type of a container, and the bytes before its content.
const CONTAINER: u32 = 10;
const CONTAINER_HEAD: usize = 32;

const BAD_OBJECT: &str = "the object is malformed";

/// A file of objects.
#[derive(Debug, Default)]
pub(super) struct Blf {
    block: Vec<u8>,
    /// Objects that were unpacked, and where the next one begins.
    unpacked: Vec<u8>,
    next: usize,
    is_started: bool,
    is_over: bool,
}

/// Whether a file begins like this.
pub(super) fn begins(start: &[u8]) -> bool {
    start.starts_with(b"LOGG")
}

impl Blf {
    pub(super) fn next_frame(
        &mut self,
        source: &mut impl BufRead,
        state: &mut LogState,
    ) -> io::Result<Option<LoggedFrame>> {
        loop {
            while let Some([from, to]) = self.object(state) {
                let frame = frame(ObjectBytes(&self.unpacked[from..to]), state);
                state.line += u64::from(!matches!(frame, Ok(None)));
                match frame {
                    Ok(None) => {}
                    Ok(Some(frame)) => return Ok(Some(frame)),
                    Err(reason) => state.bad(reason),
                }
            }
            if self.is_over {
                return Ok(None);
            }
            self.unpacked.drain(..self.next);
            self.next = 0;
            match self.read(source, state) {
                Ok(()) => {}
                Err(error) if error.kind() == ErrorKind::UnexpectedEof => {
                    self.is_over = true;
                    // a file that is cut off in an object; less than one at the end is padding
                    if self.block.len() >= HEAD || self.unpacked.len() >= HEAD {
                        state.line += 1;
                        state.bad("the file ends in an object");
                    }
                }
                Err(error) => return Err(error),
            }
        }
    }

    /// The place of the next object that was unpacked whole. Up to seven bytes before it are padding.
    fn object(&mut self, state: &mut LogState) -> Option<[usize; 2]> {
        let rest = self.unpacked.get(self.next..)?;
        let padding = rest.windows(4).take(PADDING).position(|start| start == b"LOBJ");
        let Some(padding) = padding else {
            if rest.len() >= HEAD {
                state.bad(BAD_OBJECT);
                self.next = self.unpacked.len();
            }
            return None;
        };
        let from = self.next + padding;
        let size = ObjectBytes(&self.unpacked[from..]).u32(8).ok()? as usize;
        if !(HEAD..=MAX_CONTAINER).contains(&size) {
            state.bad(BAD_OBJECT);
            self.next = self.unpacked.len();
            return None;
        }
        let to = from + size;
        (to <= self.unpacked.len()).then(|| {
            self.next = to;
            [from, to]
        })
    }

    /// Reads an object of the file: a container is unpacked, another one counts as it is.
    fn read(&mut self, source: &mut impl BufRead, state: &mut LogState) -> io::Result<()> {
        self.block.clear();
        if !std::mem::replace(&mut self.is_started, true) {
            fill(&mut self.block, source, 8, HEAD)?;
            let size = ObjectBytes(&self.block).u32(4).unwrap_or_default() as usize;
            fill(&mut self.block, source, size.saturating_sub(8), 1024)?;
            self.block.clear();
        }
        // a few bytes between objects are padding
        let mut passed = 0;
        while !self.block.starts_with(b"LOBJ") {
            if self.block.len() >= 4 {
                self.block.remove(0);
                passed += 1;
            }
            if passed == PADDING {
                state.line += 1;
                state.bad(BAD_OBJECT);
            }
            let missing = 4 - self.block.len();
            fill(&mut self.block, source, missing, HEAD)?;
        }
        fill(&mut self.block, source, HEAD - 4, HEAD)?;
        let [size, kind] = [8, 12].map(|at| ObjectBytes(&self.block).u32(at).unwrap_or_default());
        let size = (size as usize).max(HEAD);
        if size > MAX_CONTAINER {
            state.bad("the object is too large");
            return fill(&mut self.block, source, size - HEAD, 0);
        }
        fill(&mut self.block, source, size - HEAD, MAX_CONTAINER)?;
        if kind != CONTAINER {
            self.unpacked.extend(&self.block);
            return Ok(());
        }
        let method = ObjectBytes(&self.block).u16(HEAD).unwrap_or_default();
        let content = self.block.get(CONTAINER_HEAD..).unwrap_or_default();
        match method {
            0 => self.unpacked.extend(content),
            2 => match inflate(content, MAX_CONTAINER) {
                Ok(content) => self.unpacked.extend(content),
                Err(_) => state.bad("the container cannot be unpacked"),
            },
            _ => state.bad("the container is not packed with zlib"),
        }
        Ok(())
    }
}

/// Numbers in bytes, the lowest byte first.
#[derive(Clone, Copy)]
struct ObjectBytes<'a>(&'a [u8]);

impl ObjectBytes<'_> {
    fn array<const N: usize>(&self, at: usize) -> Result<[u8; N], &'static str> {
        self.0.get(at..).and_then(|bytes| bytes.first_chunk()).copied().ok_or(BAD_OBJECT)
    }

    fn u8(&self, at: usize) -> Result<u8, &'static str> {
        self.array(at).map(|[byte]| byte)
    }

    fn u16(&self, at: usize) -> Result<u16, &'static str> {
        self.array(at).map(u16::from_le_bytes)
    }

    fn u32(&self, at: usize) -> Result<u32, &'static str> {
        self.array(at).map(u32::from_le_bytes)
    }
}

/// The frame in an object; most other objects are events of tools.
fn frame(object: ObjectBytes<'_>, state: &mut LogState) -> Result<Option<LoggedFrame>, &'static str> {
    let kind = object.u32(12)?;
    if !matches!(kind, 1 | 2 | 73 | 86 | 100 | 101) {
        return Ok(None);
    }
    // tens of microseconds, or nanoseconds
    let (unit, decimals) = if object.u32(16)? == 1 { (10_000, 5) } else { (1, 9) };
    let time = u64::from_le_bytes(object.array(24)?).checked_mul(unit);
    let time = time.and_then(|time| i64::try_from(time).ok()).ok_or("the time is out of range")?;
    let head = usize::from(object.u16(4)?);
    let body = ObjectBytes(object.0.get(head..).ok_or(BAD_OBJECT)?);
    let channel = if kind == 101 { body.u8(0)?.into() } else { body.u16(0)? };
    let (time, channel) =
        (LogTime::new(time, decimals), state.channels.number(channel.to_string().as_bytes()));
    if matches!(kind, 2 | 73) {
        return Ok(Some(LoggedFrame { is_error: true, ..LoggedFrame::new(time, channel, 0, false) }));
    }
    let id = body.u32(4)?;
    let (can_id, is_extended) = (id & 0x1FFF_FFFF, id >> 31 == 1);
    if !fits(can_id, is_extended) {
        return Err(BAD_ID);
    }
    let (is_sent, is_remote, is_fd, start, length) = match kind {
        1 | 86 => {
            let flags = body.u8(2)?;
            (flags & 1 == 1, flags & 0x80 != 0, false, 8, body.u8(3)?.min(8))
        }
        100 => {
            let flags = body.u8(2)?;
            (flags & 1 == 1, flags & 0x80 != 0, body.u8(13)? & 1 == 1, 20, body.u8(14)?)
        }
        _ => {
            let flags = body.u32(12)?;
            (body.u8(34)? != 0, flags & 0x10 != 0, flags & 0x1000 != 0, 40, body.u8(2)?)
        }
    };
    let length = if is_remote { 0 } else { usize::from(length) };
    let data = body.0.get(start..start + length).ok_or(BAD_OBJECT)?;
    let frame = LoggedFrame::new(time, channel, can_id, is_extended).with_data(data);
    Ok(Some(LoggedFrame { is_sent: Some(is_sent), is_remote, is_fd, ..frame }))
}

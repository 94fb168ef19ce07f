//! The blocks of a file.

use std::borrow::Cow;
use std::cell::Cell;

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit as inflate;

use super::{MAX_FILE, TOO_LARGE};

/// The most blocks that are looked at.
const MAX_BLOCKS: usize = 1 << 20;

/// The longest name.
const MAX_NAME: usize = 256;

/// The bytes that every block begins with: its kind, its length and the number of its links.
const HEAD: usize = 24;

const BAD_BLOCK: &str = "the block is malformed";
const TOO_MANY: &str = "the file has too many blocks";

/// The bytes of a file, and what of it was read.
pub(super) struct MdfFile<'a> {
    pub(super) bytes: &'a [u8],
    /// The number of blocks, some of which may be the same.
    blocks: Cell<usize>,
    /// The bytes of records and values.
    unpacked: Cell<usize>,
    /// Whether the file ends where a block or record does not.
    pub(super) is_cut: Cell<bool>,
}

/// A block.
#[derive(Clone, Copy)]
pub(super) struct MdfBlock<'a> {
    pub(super) address: u64,
    pub(super) kind: [u8; 2],
    links: &'a [u8],
    pub(super) data: &'a [u8],
}

impl MdfBlock<'_> {
    /// The address that a link has; 0 is none.
    pub(super) fn link(&self, number: usize) -> u64 {
        number_at(self.links, number * 8, 8)
    }
}

/// A number of so many bytes, the lowest first; 0 where there are no bytes.
pub(super) fn number_at(bytes: &[u8], at: usize, count: usize) -> u64 {
    let bytes = bytes.get(at..).and_then(|bytes| bytes.get(..count)).unwrap_or_default();
    bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte))
}

impl<'a> MdfFile<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let (blocks, unpacked, is_cut) = Default::default();
        Self { bytes, blocks, unpacked, is_cut }
    }

    /// Whether the logger has not completed it, as at a loss of power: counts and lengths at its end are missing.
    pub(super) fn is_unfinished(&self) -> bool {
        self.bytes.starts_with(b"UnFin")
    }

    /// Whether places of values in records were not written (flag 5 of an unfinished file).
    pub(super) fn has_no_places(&self) -> bool {
        self.is_unfinished() && number_at(self.bytes, 60, 2) >> 5 & 1 == 1
    }

    pub(super) fn block(&self, address: u64) -> Result<MdfBlock<'a>, &'static str> {
        self.blocks.set(self.blocks.get() + 1);
        let block = usize::try_from(address).ok().and_then(|at| self.bytes.get(at..));
        let block = block.filter(|block| block.len() >= HEAD && block.starts_with(b"##")).ok_or(BAD_BLOCK)?;
        if self.blocks.get() > MAX_BLOCKS {
            return Err(TOO_MANY);
        }
        let [length, links] =
            [8, 16].map(|at| usize::try_from(number_at(block, at, 8)).unwrap_or(usize::MAX));
        let kind = [block[2], block[3]];
        // the records of an unfinished file take its rest
        let is_open = self.is_unfinished() && &kind == b"DT" && length <= HEAD;
        self.is_cut.set(self.is_cut.get() || length > block.len());
        let length = if is_open { block.len() } else { length.min(block.len()) };
        let start = links.checked_mul(8).and_then(|links| links.checked_add(HEAD)).ok_or(BAD_BLOCK)?;
        let data = block.get(start..length).ok_or(BAD_BLOCK)?;
        Ok(MdfBlock { address, kind, links: &block[HEAD..start], data })
    }

    /// The blocks of a list, each of which links the next one first.
    pub(super) fn list(&self, mut address: u64) -> Result<Vec<MdfBlock<'a>>, &'static str> {
        let mut list = Vec::new();
        while address != 0 {
            let block = self.block(address)?;
            address = block.link(0);
            list.push(block);
        }
        Ok(list)
    }

    pub(super) fn name(&self, address: u64) -> Cow<'a, str> {
        let text = if address == 0 { None } else { self.block(address).ok() };
        let text = text.map_or(&[][..], |block| &block.data[..block.data.len().min(MAX_NAME)]);
        String::from_utf8_lossy(text.split(|byte| *byte == 0).next().unwrap_or_default())
    }

    /// The bytes of records or values, which may be packed and in several blocks.
    pub(super) fn data(&self, address: u64) -> Result<Cow<'a, [u8]>, &'static str> {
        let (mut open, mut data) = (vec![address], Cow::Borrowed(&[][..]));
        while let Some(address) = open.pop() {
            if address == 0 {
                continue;
            }
            let block = self.block(address)?;
            let part = match &block.kind {
                b"DT" | b"SD" | b"DV" => Cow::Borrowed(block.data),
                b"DZ" => Cow::Owned(unpacked(block.data)?),
                b"DL" => {
                    open.push(block.link(0));
                    open.extend((1..block.links.len() / 8).rev().map(|number| block.link(number)));
                    if open.len() > MAX_BLOCKS {
                        return Err(TOO_MANY);
                    }
                    continue;
                }
                b"HL" => {
                    open.push(block.link(0));
                    continue;
                }
                _ => return Err("the records are stored by columns, which is not supported"),
            };
            self.unpacked.set(self.unpacked.get() + part.len());
            if self.unpacked.get() > MAX_FILE {
                return Err(TOO_LARGE);
            }
            if data.is_empty() {
                data = part;
            } else {
                data.to_mut().extend_from_slice(&part);
            }
        }
        Ok(data)
    }
}

/// What a DZ block has packed: as it is, or by columns, which zlib packs better.
fn unpacked(data: &[u8]) -> Result<Vec<u8>, &'static str> {
    let length = usize::try_from(number_at(data, 8, 8)).unwrap_or(usize::MAX).min(MAX_FILE);
    let packed = data.get(HEAD..).ok_or(BAD_BLOCK)?;
    let bytes = inflate(packed, length).map_err(|_| "the block cannot be unpacked")?;
    let columns = number_at(data, 4, 4) as usize;
    match (number_at(data, 2, 1), bytes.len().checked_div(columns)) {
        (0, _) => Ok(bytes),
        (1, Some(rows)) => {
            let (table, rest) = bytes.split_at(rows * columns);
            let cells = (0..rows * columns).map(|at| table[at % columns * rows + at / columns]);
            Ok(cells.chain(rest.iter().copied()).collect())
        }
        _ => Err("the block is not packed with zlib"),
    }
}

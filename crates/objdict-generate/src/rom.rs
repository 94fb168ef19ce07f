//! Data in flash: defaults and limits of all entries without duplicates.

use std::collections::HashMap;

/// Length of the prefix, with most small values, that is searched for any position of new bytes; beyond it
/// only equal blocks are found. This keeps the run time linear.
const SEARCHED: usize = 2048;

/// Blocks of bytes with their offsets; equal blocks share an offset.
#[derive(Debug, Default)]
pub(crate) struct Rom {
    bytes: Vec<u8>,
    offsets: HashMap<Vec<u8>, usize>,
}

impl Rom {
    /// The offset of a block equal to `block`.
    pub(crate) fn place(&mut self, block: Vec<u8>) -> usize {
        if let Some(&offset) = self.offsets.get(&block) {
            return offset;
        }
        let searched = &self.bytes[..self.bytes.len().min(SEARCHED)];
        let offset = memchr::memmem::find(searched, &block).unwrap_or_else(|| {
            let offset = self.bytes.len();
            self.bytes.extend_from_slice(&block);
            offset
        });
        self.offsets.insert(block, offset);
        offset
    }

    /// All bytes; at least one, because C has no empty arrays.
    pub(crate) fn into_bytes(mut self) -> Vec<u8> {
        if self.bytes.is_empty() {
            self.bytes.push(0);
        }
        self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_bytes_are_kept_once() {
        let mut rom = Rom::default();
        let offsets =
            [vec![1, 2, 3, 4], vec![2, 3], vec![4, 5], vec![1, 2, 3, 4]].map(|block| rom.place(block));
        assert_eq!(offsets, [0, 1, 4, 0]);
        assert_eq!(rom.into_bytes(), [1, 2, 3, 4, 4, 5]);
    }

    #[test]
    fn there_is_always_a_byte() {
        let mut rom = Rom::default();
        assert_eq!(rom.place(Vec::new()), 0);
        assert_eq!(rom.into_bytes(), [0]);
    }
}

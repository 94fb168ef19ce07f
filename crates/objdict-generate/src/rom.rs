//! Data in flash: defaults and limits of all entries without duplicates.

use std::collections::{BTreeSet, HashMap};
use std::ops::Bound::{Included, Unbounded};

/// Length of the start that is searched for any position of a block; beyond it blocks overlap only with the
/// one before. This keeps the run time linear.
const SEARCHED: usize = 2048;

/// The longest overlap of two blocks: a number of eight bytes with two limits.
const OVERLAP: usize = 24;

/// All bytes of these blocks, and the offset of each. Blocks share bytes where they can: after each block comes
/// the one that continues it best, else the longest. At least one byte, because C has no empty arrays.
pub(crate) fn pack<'a>(blocks: impl IntoIterator<Item = &'a [u8]>) -> (Vec<u8>, HashMap<&'a [u8], usize>) {
    let mut left: BTreeSet<&[u8]> = blocks.into_iter().collect();
    let mut longest_first: Vec<&[u8]> = left.iter().copied().collect();
    longest_first.sort_by_key(|block| block.len()); // popped from the end
    let mut offsets = HashMap::with_capacity(left.len());
    let mut bytes = Vec::new();
    while let Some((block, shared)) = continuing(&left, &bytes).or_else(|| Some((longest_first.pop()?, 0))) {
        if !left.remove(block) {
            continue;
        }
        let searched = &bytes[..bytes.len().min(SEARCHED)];
        let offset = memchr::memmem::find(searched, block).unwrap_or_else(|| {
            let offset = bytes.len() - shared;
            bytes.extend_from_slice(&block[shared..]);
            offset
        });
        offsets.insert(block, offset);
    }
    if bytes.is_empty() {
        bytes.push(0);
    }
    (bytes, offsets)
}

/// The block that starts with the most of the last bytes, and how many these are.
fn continuing<'a>(left: &BTreeSet<&'a [u8]>, bytes: &[u8]) -> Option<(&'a [u8], usize)> {
    (1..=bytes.len().min(OVERLAP)).rev().find_map(|shared| {
        let end = &bytes[bytes.len() - shared..];
        let next = left.range::<[u8], _>((Included(end), Unbounded)).next()?;
        next.starts_with(end).then_some((*next, shared))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packed<const N: usize>(blocks: [&[u8]; N]) -> (Vec<u8>, [usize; N]) {
        let (bytes, offsets) = pack(blocks);
        let offsets = blocks.map(|block| offsets[block]);
        for (block, offset) in blocks.iter().zip(offsets) {
            assert_eq!(bytes[offset..][..block.len()], **block);
        }
        (bytes, offsets)
    }

    #[test]
    fn equal_bytes_are_kept_once() {
        let (bytes, offsets) = packed([&[2, 3], &[1, 2, 3, 4], &[9, 9], &[4, 5, 6], &[1, 2, 3, 4]]);
        assert_eq!(bytes, [1, 2, 3, 4, 5, 6, 9, 9]);
        assert_eq!(offsets, [1, 0, 6, 3, 0]);
    }

    #[test]
    fn there_is_always_a_byte() {
        assert_eq!(packed([&[]]), (vec![0], [0]));
        assert_eq!(packed([]), (vec![0], []));
    }
}

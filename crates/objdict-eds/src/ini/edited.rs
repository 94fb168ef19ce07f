//! The extent of an edit.

/// The bytes in which two texts differ: from `start` to a different end in each text.
#[derive(Clone, Copy, Debug)]
pub struct EditedSpan {
    /// The length of the common start.
    pub start: u32,
    /// The end in the old text; the rest is equal.
    pub old_end: u32,
    /// The end in the new text.
    pub new_end: u32,
}

/// The number of bytes compared at once.
const CHUNK: usize = 256;

impl EditedSpan {
    /// The difference between two texts.
    pub fn of(old: &str, new: &str) -> Self {
        let (old, new) = (old.as_bytes(), new.as_bytes());
        let chunks = old.chunks_exact(CHUNK).zip(new.chunks_exact(CHUNK));
        let same = chunks.take_while(|(old, new)| old == new).count() * CHUNK;
        let start = same + old[same..].iter().zip(&new[same..]).take_while(|(old, new)| old == new).count();
        let (old_rest, new_rest) = (&old[start..], &new[start..]);
        let chunks = old_rest.rchunks_exact(CHUNK).zip(new_rest.rchunks_exact(CHUNK));
        let same = chunks.take_while(|(old, new)| old == new).count() * CHUNK;
        let before = |rest: &[u8]| rest.len() - same;
        let bytes = old_rest[..before(old_rest)].iter().rev().zip(new_rest[..before(new_rest)].iter().rev());
        let end = same + bytes.take_while(|(old, new)| old == new).count();
        Self { start: start as u32, old_end: (old.len() - end) as u32, new_end: (new.len() - end) as u32 }
    }
}

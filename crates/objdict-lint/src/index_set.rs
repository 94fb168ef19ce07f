//! Sets of object indexes.

/// A set of indexes with one bit each, because a list in a hostile file may be long and lookups must be
/// fast. Most devices have objects in a few ranges, so only the pages of these are allocated.
pub(crate) struct IndexSet {
    /// For the high byte of an index, the page with the bits of its low byte.
    pages: [u16; 256],
    /// 256 bits each; the first page is always empty.
    bits: Vec<[u64; 4]>,
}

impl IndexSet {
    /// An empty set.
    pub(crate) fn new() -> Self {
        Self { pages: [0; 256], bits: vec![[0; 4]] }
    }

    /// Inserts an index; `false` if the set already contains it.
    pub(crate) fn insert(&mut self, index: u16) -> bool {
        let page = &mut self.pages[usize::from(index >> 8)];
        if *page == 0 {
            *page = self.bits.len() as u16;
            self.bits.push([0; 4]);
        }
        let (word, bit) = position(index);
        let word = &mut self.bits[usize::from(*page)][word];
        let is_new = *word & bit == 0;
        *word |= bit;
        is_new
    }

    /// Whether an index is in the set.
    pub(crate) fn contains(&self, index: u16) -> bool {
        let (word, bit) = position(index);
        self.bits[usize::from(self.pages[usize::from(index >> 8)])][word] & bit != 0
    }
}

/// The word and the bit of an index in its page.
fn position(index: u16) -> (usize, u64) {
    (usize::from(index >> 6) & 3, 1 << (index & 63))
}

impl FromIterator<u16> for IndexSet {
    fn from_iter<T: IntoIterator<Item = u16>>(indexes: T) -> Self {
        let mut set = Self::new();
        for index in indexes {
            set.insert(index);
        }
        set
    }
}

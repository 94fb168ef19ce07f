//! Sets of object indexes.

/// A set of indexes, a bit each: a list of a hostile file may be long, and asking it must not take time.
pub(crate) struct IndexSet(Vec<u64>);

impl IndexSet {
    /// No index.
    pub(crate) fn new() -> Self {
        Self(vec![0; 1 << 10])
    }

    /// Puts an index; false when it was there already.
    pub(crate) fn insert(&mut self, index: u16) -> bool {
        let (word, bit) = Self::position(index);
        let is_new = self.0[word] & bit == 0;
        self.0[word] |= bit;
        is_new
    }

    /// Whether an index is in the set.
    pub(crate) fn contains(&self, index: u16) -> bool {
        let (word, bit) = Self::position(index);
        self.0[word] & bit != 0
    }

    fn position(index: u16) -> (usize, u64) {
        (usize::from(index >> 6), 1 << (index & 63))
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edges_are_in_it() {
        let mut set: IndexSet = [0, 63, 0xFFFF].into_iter().collect();
        assert!(set.contains(0) && set.contains(63) && set.contains(0xFFFF));
        assert!(!set.contains(64) && !set.contains(0xFFFE));
        assert!(set.insert(64) && !set.insert(64));
    }
}

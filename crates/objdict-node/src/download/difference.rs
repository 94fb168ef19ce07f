//! Differences between two configurations, write by write.

use super::settings::EntryKey;
use super::{ConciseDcf, Download};

/// An entry that two configurations write differently.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Difference {
    /// Index of the object.
    pub index: u16,
    /// Sub-index of the entry.
    pub sub: u8,
    /// The writes of the first configuration, in order; empty if it does not write the entry.
    pub first: Vec<Vec<u8>>,
    /// The writes of the second configuration.
    pub second: Vec<Vec<u8>>,
}

/// The differences between two configurations.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Differences {
    /// The entries in ascending order.
    pub entries: Vec<Difference>,
    /// Whether the common downloads have a different order.
    pub is_reordered: bool,
}

impl Differences {
    /// Whether both streams are identical.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty() && !self.is_reordered
    }
}

impl ConciseDcf {
    /// Compares with `other`. An entry differs if its sequence of writes differs, because a COB-ID is
    /// written several times.
    pub fn differences(&self, other: &Self) -> Differences {
        let (first, second) = (self.by_entry(), other.by_entry());
        let mut keys: Vec<EntryKey> = first.iter().chain(&second).map(|download| download.entry()).collect();
        keys.sort_unstable();
        keys.dedup();
        keys.retain(|&key| !writes(&first, key).eq(writes(&second, key)));
        let owned = |all, key| writes(all, key).map(<[u8]>::to_vec).collect();
        let difference = |&(index, sub): &EntryKey| Difference {
            index,
            sub,
            first: owned(&first, (index, sub)),
            second: owned(&second, (index, sub)),
        };
        let is_same = |download: &&Download| keys.binary_search(&download.entry()).is_err();
        let is_reordered = !self.0.iter().filter(is_same).eq(other.0.iter().filter(is_same));
        Differences { entries: keys.iter().map(difference).collect(), is_reordered }
    }

    /// The downloads by entry, in their original order for each.
    fn by_entry(&self) -> Vec<&Download> {
        let mut downloads: Vec<&Download> = self.0.iter().collect();
        downloads.sort_by_key(|download| download.entry());
        downloads
    }
}

/// The data that sorted downloads write to an entry.
fn writes<'a>(sorted: &'a [&'a Download], entry: EntryKey) -> impl Iterator<Item = &'a [u8]> {
    let start = sorted.partition_point(|download| download.entry() < entry);
    sorted[start..]
        .iter()
        .take_while(move |download| download.entry() == entry)
        .map(|download| &*download.data)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(downloads: &[(u16, u8, &[u8])]) -> ConciseDcf {
        ConciseDcf(downloads.iter().map(|&(index, sub, data)| Download::new(index, sub, data)).collect())
    }

    #[test]
    fn entries_differ_by_all_that_is_written() {
        let first = of(&[(0x1800, 1, &[1]), (0x1800, 2, &[9]), (0x1800, 1, &[2]), (0x1017, 0, &[5])]);
        let second = of(&[(0x1800, 1, &[2]), (0x1800, 2, &[9]), (0x2000, 0, &[7])]);
        let differences = first.differences(&second);
        let keys: Vec<(u16, u8)> = differences.entries.iter().map(|entry| (entry.index, entry.sub)).collect();
        assert_eq!(keys, [(0x1017, 0), (0x1800, 1), (0x2000, 0)]);
        assert_eq!(differences.entries[1].first, [vec![1], vec![2]]);
        assert!(!differences.is_reordered && !differences.is_empty());
        assert!(first.differences(&first).is_empty());
    }

    #[test]
    fn another_order_is_reported() {
        let forth = of(&[(0x1017, 0, &[5]), (0x2000, 0, &[7])]);
        let back = of(&[(0x2000, 0, &[7]), (0x1017, 0, &[5])]);
        let differences = forth.differences(&back);
        assert!(differences.is_reordered && differences.entries.is_empty());
    }
}

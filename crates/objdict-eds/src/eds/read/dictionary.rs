//! The objects of a description during reading.
//!
//! Objects are appended to a list in the order of the file, and the map is built at the end.

use std::collections::BTreeMap;

use crate::model::{Object, Objects};

/// The objects in file order. A section usually belongs to the last object or to a new one and needs no
/// lookup, and a tree built at the end from sorted objects is faster and smaller than a growing one.
pub(super) struct DictionaryReader {
    objects: Vec<(u16, Object)>,
    /// The known indexes, one bit each.
    known: Box<[u64; 1 << 10]>,
    /// The positions of the objects, built at the first lookup of an object other than the last.
    positions: Option<BTreeMap<u16, usize>>,
}

impl DictionaryReader {
    /// An empty dictionary.
    pub(super) fn new() -> Self {
        Self { objects: Vec::new(), known: Box::new([0; 1 << 10]), positions: None }
    }

    /// The object at an index.
    pub(super) fn get_mut(&mut self, index: u16) -> Option<&mut Object> {
        let at = self.position(index)?;
        self.objects.get_mut(at).map(|(_, object)| object)
    }

    /// The object at an index; a missing one is added as an object without its own section.
    pub(super) fn get_or_insert(&mut self, index: u16) -> &mut Object {
        let at = self.position(index).unwrap_or_else(|| self.insert(index));
        &mut self.objects[at].1
    }

    /// All objects, by index, with `others`.
    pub(super) fn into_objects(self, mut others: Objects) -> Objects {
        if others.is_empty() {
            return self.objects.into_iter().collect();
        }
        others.extend(self.objects);
        others
    }

    fn position(&mut self, index: u16) -> Option<usize> {
        let objects = &self.objects;
        match objects.last() {
            Some((last, _)) if *last == index => Some(objects.len() - 1),
            _ if self.known[usize::from(index >> 6)] & bit(index) == 0 => None,
            _ => {
                let all = || (0..).zip(objects).map(|(at, (index, _))| (*index, at)).collect();
                self.positions.get_or_insert_with(all).get(&index).copied()
            }
        }
    }

    fn insert(&mut self, index: u16) -> usize {
        let at = self.objects.len();
        if let Some(positions) = &mut self.positions {
            positions.insert(index, at);
        }
        self.known[usize::from(index >> 6)] |= bit(index);
        self.objects.push((index, Object { orphan: true, ..Object::default() }));
        at
    }
}

const fn bit(index: u16) -> u64 {
    1 << (index & 63)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_in_any_order_are_found_and_sorted() {
        let mut dictionary = DictionaryReader::new();
        let order = [0x2000, 0x1000, 0x2000, 0xFFFF, 0x1000, 0, 0x2000, 0];
        for index in order {
            dictionary.get_or_insert(index).links.push(index);
        }
        assert!(dictionary.get_mut(0x1001).is_none());
        let times = dictionary
            .into_objects(Objects::default())
            .into_iter()
            .map(|(index, object)| (index, object.links.len()));
        assert_eq!(times.collect::<Vec<_>>(), [(0, 2), (0x1000, 2), (0x2000, 3), (0xFFFF, 1)]);
    }
}

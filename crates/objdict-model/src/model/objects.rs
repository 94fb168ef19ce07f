//! The objects of a device.

use std::collections::BTreeMap;
use std::ops::{Index, RangeBounds};
use std::sync::Arc;

use super::Object;

/// Objects by index, in ascending order.
///
/// Copies share their objects until one is changed: most nodes of a network are of the same few types.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Objects(BTreeMap<u16, Arc<Object>>);

impl Objects {
    /// Whether there are no objects.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The number of objects.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is an object at an index.
    pub fn contains_key(&self, index: &u16) -> bool {
        self.0.contains_key(index)
    }

    /// The object at an index.
    pub fn get(&self, index: &u16) -> Option<&Object> {
        self.0.get(index).map(|object| &**object)
    }

    /// Whether both share the object at an index, so that it is equal without a comparison.
    #[doc(hidden)] // for the crates that read and check again after an edit
    pub fn shares(&self, others: &Self, index: &u16) -> bool {
        let (one, other) = (self.0.get(index), others.0.get(index));
        one.zip(other).is_some_and(|(one, other)| Arc::ptr_eq(one, other))
    }

    /// The object at an index, to change it.
    pub fn get_mut(&mut self, index: &u16) -> Option<&mut Object> {
        self.0.get_mut(index).map(Arc::make_mut)
    }

    /// Mutable access to the object at an index, which is created if missing.
    pub fn get_or_insert_with(&mut self, index: u16, object: impl FnOnce() -> Object) -> &mut Object {
        Arc::make_mut(self.0.entry(index).or_insert_with(|| Arc::new(object())))
    }

    /// Adds an object, and returns the previous object at this index.
    pub fn insert(&mut self, index: u16, object: Object) -> Option<Object> {
        self.0.insert(index, Arc::new(object)).map(Arc::unwrap_or_clone)
    }

    /// Removes the object at an index.
    pub fn remove(&mut self, index: &u16) -> Option<Object> {
        self.0.remove(index).map(Arc::unwrap_or_clone)
    }

    /// Keeps only the objects for which `is_kept` returns `true`.
    pub fn retain(&mut self, mut is_kept: impl FnMut(&u16, &Object) -> bool) {
        self.0.retain(|index, object| is_kept(index, object));
    }

    /// The indexes.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &u16> + ExactSizeIterator + Clone {
        self.0.keys()
    }

    /// The objects without their indexes.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = &Object> + ExactSizeIterator + Clone {
        self.0.values().map(|object| &**object)
    }

    /// Mutable access to all objects.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut Object> {
        self.0.values_mut().map(Arc::make_mut)
    }

    /// Mutable access to the objects for which `is_meant` returns `true`; the others remain shared.
    pub fn values_mut_of(&mut self, is_meant: impl Fn(&Object) -> bool) -> impl Iterator<Item = &mut Object> {
        self.0.values_mut().filter(move |object| is_meant(object)).map(Arc::make_mut)
    }

    /// The objects with their indexes.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (&u16, &Object)> + ExactSizeIterator + Clone {
        self.0.iter().map(|(index, object)| (index, &**object))
    }

    /// Mutable access to all objects, with their indexes.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (&u16, &mut Object)> {
        self.0.iter_mut().map(|(index, object)| (index, Arc::make_mut(object)))
    }

    /// The objects in a range of indexes.
    pub fn range(
        &self,
        indexes: impl RangeBounds<u16>,
    ) -> impl DoubleEndedIterator<Item = (&u16, &Object)> + Clone {
        self.0.range(indexes).map(|(index, object)| (index, &**object))
    }
}

impl Index<&u16> for Objects {
    type Output = Object;

    fn index(&self, index: &u16) -> &Object {
        &self.0[index]
    }
}

impl FromIterator<(u16, Object)> for Objects {
    fn from_iter<I: IntoIterator<Item = (u16, Object)>>(objects: I) -> Self {
        Self(objects.into_iter().map(|(index, object)| (index, Arc::new(object))).collect())
    }
}

impl Extend<(u16, Object)> for Objects {
    fn extend<I: IntoIterator<Item = (u16, Object)>>(&mut self, objects: I) {
        self.0.extend(objects.into_iter().map(|(index, object)| (index, Arc::new(object))));
    }
}

impl IntoIterator for Objects {
    type Item = (u16, Object);
    type IntoIter = std::iter::Map<
        std::collections::btree_map::IntoIter<u16, Arc<Object>>,
        fn((u16, Arc<Object>)) -> Self::Item,
    >;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter().map(|(index, object)| (index, Arc::unwrap_or_clone(object)))
    }
}

impl<'a> IntoIterator for &'a Objects {
    type Item = (&'a u16, &'a Object);
    type IntoIter = std::iter::Map<
        std::collections::btree_map::Iter<'a, u16, Arc<Object>>,
        fn((&'a u16, &'a Arc<Object>)) -> Self::Item,
    >;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter().map(|(index, object)| (index, &**object))
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Objects {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        super::index_keys::serialize(self, serializer)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Objects {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        super::index_keys::deserialize(deserializer)
    }
}

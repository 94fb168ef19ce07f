//! What is described beside what a standard says of it.

use crate::model::{Entry, Object, Place};
use crate::profile::{EntryFacts, ObjectFacts, cia301};

/// A described entry with what CiA 301 says of it.
pub(crate) struct Expected<'a> {
    pub index: u16,
    /// The sub-index; `None` for the object's own section.
    pub sub: Option<u8>,
    pub entry: &'a Entry,
    pub facts: &'static EntryFacts,
}

/// The described entries of a communication object that CiA 301 defines; what the sub-indexes of a compactly stored one
/// share counts as one entry. None where the object has not the shape that the standard gives it.
pub(crate) fn expected(index: u16, object: &Object) -> impl Iterator<Item = Expected<'_>> {
    let facts = cia301::object(index).filter(|facts| has_shape_of(object, facts));
    let has_header = object.object_type().has_subs() && object.compact.is_none();
    let shared = u8::from(object.compact.is_some());
    let entries = facts.into_iter().flat_map(|facts| object.described().map(move |entry| (facts, entry)));
    entries.filter(move |(_, (sub, _))| sub.is_some() || !has_header).filter_map(
        move |(facts, (sub, entry))| {
            let facts = facts.entry(sub.unwrap_or(shared))?;
            Some(Expected { index, sub, entry, facts })
        },
    )
}

/// Whether an object has the shape that its facts speak of: sub-indexes, or a single value. What is said of one that has
/// not is the matter of the rules about object types.
pub(crate) fn has_shape_of(object: &Object, facts: &ObjectFacts) -> bool {
    !object.orphan && object.object_type().has_subs() == facts.object_type().has_subs()
}

impl Expected<'_> {
    pub(crate) fn place(&self) -> Place {
        self.sub.map_or(Place::object(self.index), |sub| Place::entry(self.index, sub))
    }
}

/// `1018h sub-index 1`.
impl std::fmt::Display for Expected<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.sub {
            Some(sub) => write!(f, "{:04X}h sub-index {sub}", self.index),
            None => write!(f, "{:04X}h", self.index),
        }
    }
}

//! Parts that fixes add: missing members of object lists (CiA 306-1 §4.6.3.1) and sub-index 0.

use crate::diagnostic::{Change, Fix, MAX_FIX_LINES};
use crate::model::{Field, Object, Part};

/// A list with additional members: in order if the list is sorted, otherwise at its end.
pub(crate) fn with_members(list: &[u16], others: impl IntoIterator<Item = u16>) -> Vec<u16> {
    let is_sorted = list.is_sorted();
    let mut members = list.to_vec();
    members.extend(others);
    if is_sorted {
        members.sort_unstable();
    }
    members
}

/// Sub-index 0 of an object with the usual attributes.
pub(crate) fn sub_0(index: u16, object: &Object) -> Change {
    let keys = [
        (Field::ParameterName, "Highest sub-index supported".to_owned()),
        (Field::ObjectType, "0x7".to_owned()),
        (Field::DataType, "0x0005".to_owned()),
        (Field::AccessType, "ro".to_owned()),
        (Field::DefaultValue, object.highest_sub().unwrap_or_default().to_string()),
        (Field::PdoMapping, "0".to_owned()),
    ];
    Change::Add(Part::Entry(index, 0), keys.to_vec())
}

/// The fixes of a rule that rewrite lists. Each fix changes as many lines as its list has, and a list in a
/// hostile file is long, so their total is limited.
pub(crate) struct ListFixes {
    lines: usize,
}

impl ListFixes {
    /// A counter for the fixes of one rule.
    pub(crate) fn new() -> Self {
        Self { lines: MAX_FIX_LINES }
    }

    /// The fix of the next finding, unless the limit is reached.
    pub(crate) fn next(&mut self, list: &[u16], fix: impl FnOnce() -> Fix) -> Option<Fix> {
        self.lines = self.lines.checked_sub(list.len().max(1))?;
        Some(fix())
    }
}

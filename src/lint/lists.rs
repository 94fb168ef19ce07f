//! The three lists of objects (CiA 306-1 §4.6.3.1): where an object belongs, and lists with what they lack.

use crate::model::ObjectList;

/// So many findings of a list carry the whole new list as their fix; the others go with them.
pub(crate) const MAX_LIST_FIXES: usize = 50;

/// The list that an object belongs to; none for the definition of a data type.
pub(crate) const fn list_of(index: u16) -> Option<ObjectList> {
    match index {
        0x1000 | 0x1001 | 0x1018 => Some(ObjectList::Mandatory),
        0x2000..=0x5FFF => Some(ObjectList::Manufacturer),
        0x1000.. => Some(ObjectList::Optional),
        _ => None,
    }
}

/// A list with other members: where they belong in a list that is sorted, else at its end.
pub(crate) fn with_members(list: &[u16], others: impl IntoIterator<Item = u16>) -> Vec<u16> {
    let is_sorted = list.is_sorted();
    let mut members = list.to_vec();
    members.extend(others);
    if is_sorted {
        members.sort_unstable();
    }
    members
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn members_come_where_they_belong() {
        assert_eq!(with_members(&[1, 5], [3]), [1, 3, 5]);
        assert_eq!(with_members(&[5, 1], [3]), [5, 1, 3]);
    }
}

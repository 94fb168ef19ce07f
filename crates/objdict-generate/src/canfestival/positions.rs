//! The order of the objects: the stack counts from the first object of a family, a PDO and its mapping alike.

use super::plan::PlannedObject;
use super::special::Family;

/// A place in the list of objects.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ListSlot {
    /// An object, by its number.
    Object(usize),
    /// No object: position 0 means that there is no family.
    Nothing,
    /// The parameters of a PDO that is not valid, for a mapping without parameters.
    NoPdo,
    /// A mapping of no objects, for a PDO without a mapping.
    NoMapping,
    /// The parameters of the SDO server, which a node also has without 1200h.
    Server,
}

/// The list, and the first and last position of each family; 0 without one.
pub(super) struct ListSlots {
    pub(super) list: Vec<ListSlot>,
    pub(super) first: [usize; 6],
    pub(super) last: [usize; 6],
}

impl ListSlots {
    pub(super) fn has(&self, slot: ListSlot) -> bool {
        self.list.contains(&slot)
    }

    /// The number of TPDOs; at least 1, because C has no empty arrays.
    pub(super) fn transmitted(&self) -> usize {
        let tpdo = Family::Tpdo as usize;
        if self.first[tpdo] == 0 { 1 } else { self.last[tpdo] - self.first[tpdo] + 1 }
    }
}

pub(super) fn slots(objects: &[PlannedObject]) -> ListSlots {
    let family = |object: &PlannedObject| Family::of(object.index).filter(|_| !object.misfit);
    let numbered = |wanted: Option<Family>, below: bool| {
        let objects = objects.iter().enumerate();
        objects.filter(move |(_, object)| family(object) == wanted && (object.index < 0x1200) == below)
    };
    let mut list: Vec<ListSlot> = numbered(None, true).map(|(number, _)| ListSlot::Object(number)).collect();
    if list.is_empty() {
        list.push(ListSlot::Nothing);
    }
    let (mut first, mut last) = ([0; 6], [0; 6]);
    for (at, of) in Family::ALL.into_iter().enumerate() {
        let start = list.len();
        let paired = match of {
            Family::Rpdo | Family::Tpdo => {
                Family::ALL.get(at + 1).map(|mapping| (*mapping, 0x200, ListSlot::NoPdo))
            }
            Family::RpdoMapping | Family::TpdoMapping => {
                at.checked_sub(1).and_then(|at| Some((*Family::ALL.get(at)?, -0x200, ListSlot::NoMapping)))
            }
            _ => None,
        };
        let mut found: Vec<(u16, ListSlot)> = numbered(Some(of), false)
            .map(|(number, object)| (object.index, ListSlot::Object(number)))
            .collect();
        if let Some((other, distance, instead)) = paired {
            for (_, object) in numbered(Some(other), false) {
                let index = object.index.wrapping_add_signed(-distance);
                if !found.iter().any(|(known, _)| *known == index) {
                    found.push((index, instead));
                }
            }
        }
        if of == Family::SdoServer && !found.iter().any(|(index, _)| *index == 0x1200) {
            found.push((0x1200, ListSlot::Server));
        }
        found.sort_by_key(|(index, _)| *index);
        list.extend(found.into_iter().map(|(_, slot)| slot));
        if list.len() > start {
            (first[at], last[at]) = (start, list.len() - 1);
        }
    }
    list.extend(numbered(None, false).map(|(number, _)| ListSlot::Object(number)));
    ListSlots { list, first, last }
}

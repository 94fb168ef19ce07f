//! The state that a build keeps from an earlier one. PLC programs depend on the CAN-IDs and on the objects of
//! the manager.

use std::collections::{BTreeMap, BTreeSet};

use crate::configure::PdoName;
use crate::model::{MappedObject, PdoKind};

/// The PDOs of an earlier build, by node and PDO.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NetworkLock(pub BTreeMap<(String, PdoName), LockedPdo>);

/// A PDO of an earlier build.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LockedPdo {
    /// Its CAN-ID.
    pub can_id: u32,
    /// Its content, in this order.
    pub mapping: Vec<MappedObject>,
    /// The number of the counterpart in a manager without a description.
    pub manager: Option<u16>,
}

impl NetworkLock {
    /// The locked state of a PDO.
    pub(crate) fn pdo(&self, node: &str, pdo: PdoName) -> Option<&LockedPdo> {
        // without a lock nothing is copied
        if self.0.is_empty() { None } else { self.0.get(&(node.to_owned(), pdo)) }
    }

    /// The PDO of a node that carried an entry, and the position of the entry in it.
    pub(crate) fn carrier(&self, node: &str, kind: PdoKind, entry: (u16, u8)) -> Option<(PdoName, usize)> {
        let mut pdos = self.0.iter().filter(|((name, pdo), _)| name == node && pdo.kind == kind);
        pdos.find_map(|((_, pdo), locked)| {
            let at = locked.mapping.iter().position(|mapped| mapped.entry() == entry)?;
            Some((*pdo, at))
        })
    }

    pub(crate) fn can_ids(&self) -> impl Iterator<Item = u32> {
        self.0.values().map(|locked| locked.can_id)
    }

    /// Whether a PDO of the manager was the counterpart of a PDO of this kind.
    pub(crate) fn has_manager_pdo(&self, kind: PdoKind, number: u16) -> bool {
        self.0.iter().any(|((_, pdo), locked)| pdo.kind == kind && locked.manager == Some(number))
    }

    /// Differences in a later build: sentences in lower case without a full stop.
    pub fn changes(&self, later: &Self) -> Vec<String> {
        let keys: BTreeSet<_> = self.0.keys().chain(later.0.keys()).collect();
        let change = |key: &(String, PdoName)| {
            let (node, PdoName { kind, number }) = key;
            let (old, new) = (self.0.get(key), later.0.get(key));
            let changes = match (old, new) {
                (Some(old), Some(new)) if old == new => return None,
                (Some(old), Some(new)) => differences(old, new).join(", "),
                (Some(_), None) => "is gone".to_owned(),
                (None, _) => "is new".to_owned(),
            };
            Some(format!("{kind} {number} of `{node}` {changes}"))
        };
        keys.into_iter().filter_map(change).collect()
    }
}

fn differences(old: &LockedPdo, new: &LockedPdo) -> Vec<String> {
    let mut differences = Vec::new();
    if old.can_id != new.can_id {
        differences.push(format!("has the CAN-ID {:X}h instead of {:X}h", new.can_id, old.can_id));
    }
    if old.mapping != new.mapping {
        differences.push("carries other entries".to_owned());
    }
    if old.manager != new.manager {
        let number = |number: Option<u16>| number.map_or("none".to_owned(), |number| number.to_string());
        let numbers = [new.manager, old.manager].map(number);
        differences.push(format!("is PDO {} of the manager instead of {}", numbers[0], numbers[1]));
    }
    differences
}

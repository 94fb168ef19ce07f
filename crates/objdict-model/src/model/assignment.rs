//! Values assigned to entries.

use super::{Device, Value};

/// An entry and its new value.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// The index of the object.
    pub index: u16,
    /// The sub-index of the entry.
    pub sub: u8,
    /// The value, as in `ParameterValue`.
    pub value: Value,
}

impl Device {
    /// Configures the values; assignments to missing entries are ignored.
    pub fn assign(&mut self, assignments: &[Assignment]) {
        for Assignment { index, sub, value } in assignments {
            let Some(object) = self.objects.get_mut(index) else { continue };
            if let Some(entry) = object.subs.get_mut(*sub) {
                entry.configured_mut().value = Some(value.clone());
                continue;
            }
            let has_subs = object.object_type().has_subs();
            match &mut object.compact {
                Some(compact) if (1..=compact.count).contains(sub) => {
                    compact.values.retain(|(other, _)| other != sub);
                    compact.values.push((*sub, value.clone()));
                    compact.values.sort_by_key(|(sub, _)| *sub);
                }
                Some(_) => {}
                None if *sub == 0 && !has_subs => {
                    object.main.configured_mut().value = Some(value.clone());
                }
                None => {}
            }
        }
    }

    /// The configured values of `other` that differ from `self`, for entries that both have.
    pub fn reconfigured(&self, other: &Self) -> Vec<Assignment> {
        let mut values = Vec::new();
        for (&index, object) in &other.objects {
            let Some(old) = self.object(index) else { continue };
            for (sub, entry) in object.entries() {
                let Some(value) = entry.configured_value() else { continue };
                let is_new = old.entry(sub).is_some_and(|old| old.configured_value() != Some(value));
                if is_new {
                    values.push(Assignment { index, sub, value: value.clone() });
                }
            }
        }
        values
    }
}

//! What assignments make of a device, and of its text.

use super::Assignment;
use crate::diagnostic::Change;
use crate::format::literal::{self, Spelling};
use crate::model::{Device, Field, Part, Place};

impl Assignment {
    /// The text of the value, spelled as `ParameterValue` holds it.
    pub fn text(&self) -> String {
        let is_communication = (0x1000..0x2000).contains(&self.index);
        literal::print(
            &self.value,
            Spelling { hex: is_communication && is_code(self.index, self.sub), ..Spelling::default() },
        )
    }
}

/// Whether people read the number in hex: COB-IDs, mapped objects, heartbeat consumers.
const fn is_code(index: u16, sub: u8) -> bool {
    match index {
        0x1005 | 0x1012 | 0x1014 => true,
        0x1016 | 0x1028 | 0x1600..=0x17FF | 0x1A00..=0x1BFF => sub > 0,
        0x1200..=0x12FF => matches!(sub, 1 | 2),
        0x1400..=0x15FF | 0x1800..=0x19FF => sub == 1,
        _ => false,
    }
}

impl Device {
    /// Puts configured values.
    pub fn assign(&mut self, assignments: &[Assignment]) {
        for Assignment { index, sub, value } in assignments {
            let Some(object) = self.objects.get_mut(index) else { continue };
            let is_compact = object.compact.as_ref().is_some_and(|compact| (1..=compact.count).contains(sub));
            if let Some(entry) = object.subs.get_mut(*sub) {
                entry.configured_mut().value = Some(value.clone());
            } else if let (true, Some(compact)) = (is_compact, &mut object.compact) {
                compact.values.retain(|(other, _)| other != sub);
                compact.values.push((*sub, value.clone()));
                compact.values.sort_by_key(|(sub, _)| *sub);
            } else if *sub == 0 {
                object.main.configured_mut().value = Some(value.clone());
            }
        }
    }
}

/// The changes of a text that put the values: `ParameterValue` of each entry, and for compactly stored ones a line in the
/// section with their values, which `has_values` says to be there or not.
pub(crate) fn changes(
    device: &Device,
    assignments: &[Assignment],
    has_values: impl Fn(u16) -> bool,
) -> Vec<Change> {
    let mut changes = Vec::new();
    let mut added: Vec<(u16, Vec<(Field, String)>)> = Vec::new();
    for assignment in assignments {
        let Assignment { index, sub, .. } = *assignment;
        let Some(object) = device.object(index) else { continue };
        let is_described = object.subs.get(sub).is_some();
        let is_compact = !is_described && object.compact.is_some() && sub > 0;
        if is_compact && !has_values(index) {
            let item = (Field::Item(sub.into()), assignment.text());
            match added.last_mut().filter(|(other, _)| *other == index) {
                Some((_, items)) => items.push(item),
                None => added.push((index, vec![item])),
            }
            continue;
        }
        let place = match is_described || is_compact {
            true => Place::entry(index, sub),
            false => Place::object(index),
        };
        changes.push(Change::Set(place.field(Field::ParameterValue), assignment.text()));
    }
    for (index, items) in added {
        let mut fields = vec![(Field::NrOfEntries, items.len().to_string())];
        fields.extend(items);
        changes.push(Change::Add(Part::CompactValues(index), fields));
    }
    changes
}

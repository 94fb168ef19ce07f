//! PDOs of a coupler whose default mapping names entries that no connected module provides.

use crate::model::{CobId, Device, Entry, Value};

/// Truncates each mapping at the first missing entry. A PDO without any mapped entry becomes not valid: bit
/// 31 of its COB-ID is set.
pub(super) fn shorten(device: &mut Device) {
    let mut shortened = Vec::new();
    for pdo in device.pdos() {
        let is_there = |slot: &crate::model::MappingSlot| {
            slot.object.is_some_and(|mapped| {
                mapped.is_unused() || mapped.is_dummy() || device.entry(mapped.index, mapped.sub).is_some()
            })
        };
        let there = pdo.used_slots().take_while(is_there).count();
        if there < pdo.used_slots().count() {
            shortened.push((pdo.communication_index(), pdo.mapping_index(), there as u8));
        }
    }
    for (communication, mapping, there) in shortened {
        configure(device, mapping, 0, |_| Some(Value::Unsigned(there.into())));
        if there == 0 {
            configure(device, communication, 1, |cob_id| {
                Some(CobId::from_value(cob_id?)?.disabled().to_value())
            });
        }
    }
}

/// Sets the value of an entry.
fn configure(device: &mut Device, index: u16, sub: u8, value: impl Fn(Option<&Value>) -> Option<Value>) {
    let entry = device.objects.get_mut(&index).and_then(|object| object.subs.get_mut(sub));
    let Some(entry) = entry else { return };
    if let Some(value) = value(Entry::value(entry)) {
        entry.configured_mut().value = Some(value);
    }
}

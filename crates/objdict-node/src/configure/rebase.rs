//! COB-IDs of a node whose node-ID changes.

use std::borrow::Cow;

use crate::model::{Access, Address, Assignment, CobId, Device, Entry, predefined};

/// COB-IDs with fixed numbers, relative to the node-ID for which they were created.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rebased {
    /// The COB-IDs that equalled the former node-ID plus a number of the predefined connection set, or plus
    /// the number in the formula of their default: each as a formula, in ascending order.
    pub assignments: Vec<Assignment>,
    /// The other valid COB-IDs, which do not depend on the node-ID.
    pub kept: Vec<(Address, CobId)>,
}

/// Separates fixed COB-IDs of PDOs, SDOs and EMCY by whether they depend on the node-ID: those based on
/// `former` become formulas, so that they are correct for any node-ID.
pub fn rebase(device: &Device, former: u8) -> Rebased {
    let mut rebased = Rebased::default();
    for (at, entry) in cob_ids(device) {
        let Some(cob_id) = entry.value().and_then(CobId::from_value).filter(|id| !id.depends_on_node_id())
        else {
            continue;
        };
        let is_changeable =
            entry.configured_value().is_some() || entry.access.is_some_and(Access::is_writable);
        match formula(at, &entry, cob_id, former).filter(|_| is_changeable) {
            Some(formula) => rebased.assignments.push(Assignment {
                index: at.index,
                sub: at.sub.unwrap_or_default(),
                value: formula.to_value(),
            }),
            None if cob_id.is_valid() => rebased.kept.push((at, cob_id)),
            None => {}
        }
    }
    rebased
}

/// The entries that have a COB-ID of a service between two nodes.
fn cob_ids(device: &Device) -> impl Iterator<Item = (Address, Cow<'_, Entry>)> {
    let ids = device.objects.keys().flat_map(|&index| {
        let subs: &[Option<u8>] = match index {
            0x1014 => &[None],
            0x1200..=0x12FF => &[Some(1), Some(2)],
            0x1400..=0x15FF | 0x1800..=0x19FF => &[Some(1)],
            _ => &[],
        };
        subs.iter().map(move |&sub| Address { index, sub })
    });
    ids.filter_map(|at| Some((at, device.entry(at.index, at.sub.unwrap_or_default())?)))
}

/// The formula that results in the COB-ID on the former node; `None` if there is none.
fn formula(at: Address, entry: &Entry, cob_id: CobId, former: u8) -> Option<CobId> {
    let default = entry.default.as_ref().and_then(CobId::from_value).filter(|id| id.depends_on_node_id());
    let base = cob_id.can_id(former).checked_sub(former.into())?;
    let is_default = default.is_some_and(|default| {
        default.can_id(former) == cob_id.can_id(former) && default.is_extended() == cob_id.is_extended()
    });
    let is_predefined = !cob_id.is_extended()
        && match at.index {
            0x1014 => base == u32::from(predefined::EMCY),
            0x1200..=0x12FF => {
                base == u32::from(predefined::SDO_REQUEST) || base == u32::from(predefined::SDO_RESPONSE)
            }
            _ => (0x180..=0x500).contains(&base) && base.is_multiple_of(0x80),
        };
    if !is_default && !is_predefined {
        return None;
    }
    CobId::per_node(cob_id.number() - u32::from(former))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::model::{DataType, Object, Value};

    /// A device whose TPDO 1 has this COB-ID.
    fn device(number: u32, default: Option<Value>) -> Device {
        let mut entry = Entry {
            data_type: Some(DataType::UNSIGNED32),
            access: Some(Access::Rw),
            default,
            ..Entry::default()
        };
        entry.configured_mut().value = Some(Value::Unsigned(number.into()));
        let mut object = Object::default();
        object.main.object_type = Some(crate::model::ObjectType::Record);
        object.subs.insert(1, entry);
        let mut device = Device::default();
        device.objects.insert(0x1800, object);
        device
    }

    #[test]
    fn the_formula_of_a_default_counts() {
        let own = device(0x1F3, Some(Value::NodeId(0x1F0)));
        assert_eq!(rebase(&own, 3).assignments[0].value, Value::NodeId(0x1F0));
        assert_eq!(rebase(&device(0x1F3, None), 3).kept.len(), 1);
    }

    proptest! {
        #[test]
        fn a_formula_gives_the_number_on_the_former_node(number in any::<u32>(), former in 1u8..=127) {
            let number = number & !0x0000_0780 | (number % 16) << 7;
            let Rebased { assignments, kept } = rebase(&device(number, None), former);
            prop_assert!(assignments.len() + kept.len() <= 1);
            for Assignment { value, .. } in assignments {
                prop_assert_eq!(value.integer_for(former), Some(i128::from(number)));
            }
            for (_, cob_id) in kept {
                prop_assert_eq!(cob_id.number(), number);
            }
        }
    }
}

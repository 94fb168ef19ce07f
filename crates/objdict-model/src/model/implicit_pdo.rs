//! PDOs that a description implies without describing their objects (CiA 306-1 §4.6.3.4.1, `CompactPDO`).
//!
//! The standard defines the number of implicit PDOs, the sub-indexes of their communication parameters, and
//! the default COB-IDs of the first four of each direction; it does not define transmission type and
//! mapping. The rest follows lely-core, so that both create the same dictionary: the COB-ID of PDO 5 and
//! above is 80000000h, values that the standard does not define have no default, the communication parameter
//! is writable except for sub-index 0, and the mapping has 64 writable entries. A DCF implies the same
//! objects as its EDS: the standard's statement that PDOs without values are disabled addresses the tool
//! that downloads the DCF.

use std::borrow::Cow;

use super::{
    Access, CobId, DataType, Device, Entry, Object, ObjectType, PdoKind, PdoMapping, Value, predefined,
};

impl Device {
    /// Direction and number of the PDOs that `CompactPDO` implies: as many as `NrOfRXPDO` and `NrOfTXPDO`
    /// have beyond the described ones, with the lowest free numbers.
    pub fn implicit_pdos(&self) -> Vec<(PdoKind, u16)> {
        let Some(info) = self.device_info.as_ref().filter(|info| info.compact_pdo.unwrap_or(0) != 0) else {
            return Vec::new();
        };
        let mut implicit = Vec::new();
        for kind in PdoKind::ALL {
            let count = match kind {
                PdoKind::Rpdo => info.rpdo_count,
                PdoKind::Tpdo => info.tpdo_count,
            };
            let described = self.pdo_numbers(kind);
            let missing = usize::from(count.unwrap_or(0)).saturating_sub(described.len());
            let free = (1..=PdoKind::MAX).filter(|number| !described.contains(number));
            implicit.extend(free.take(missing).map(|number| (kind, number)));
        }
        implicit
    }

    /// The device with the objects of the PDOs that `CompactPDO` implies; unchanged if it implies none.
    pub fn with_implicit_pdos(&self) -> Cow<'_, Device> {
        let implicit = self.implicit_pdos();
        if implicit.is_empty() {
            return Cow::Borrowed(self);
        }
        let mask = self.device_info.as_ref().and_then(|info| info.compact_pdo).unwrap_or(0);
        let mut device = self.clone();
        for (kind, number) in implicit {
            let objects = [
                (kind.communication_index(number), communication(kind, number, mask)),
                (kind.mapping_index(number), mapping(kind)),
            ];
            for (index, object) in objects {
                let Some(index) = index else { continue };
                device.objects.insert(index, object);
                device.lists.add(index);
            }
        }
        Cow::Owned(device)
    }
}

/// The communication parameter of an implicit PDO: one sub-index for each bit of `CompactPDO`.
fn communication(kind: PdoKind, number: u16, mask: u8) -> Object {
    let cob_id = match kind.predefined_can_id(number) {
        Some(base) => predefined::per_node(base),
        None => CobId::new(CobId::BIT_31),
    };
    let members = [
        ("COB-ID", DataType::UNSIGNED32, Some(cob_id.to_value())),
        ("Transmission type", DataType::UNSIGNED8, None),
        ("Inhibit time", DataType::UNSIGNED16, None),
        ("Reserved", DataType::UNSIGNED8, None),
        ("Event timer", DataType::UNSIGNED16, None),
        ("SYNC start value", DataType::UNSIGNED8, None),
    ];
    let there = (1u8..).zip(members).filter(|(sub, _)| mask >> (sub - 1) & 1 == 1);
    let subs: Vec<(u8, Entry)> = there
        .map(|(sub, (name, data_type, default))| (sub, entry(name, data_type, Access::Rw, default)))
        .collect();
    let highest = subs.last().map_or(0, |(sub, _)| *sub);
    let count = Some(Value::Unsigned(highest.into()));
    let sub_0 = entry("Highest sub-index supported", DataType::UNSIGNED8, Access::Const, count);
    record(format!("{kind} communication parameter"), std::iter::once((0, sub_0)).chain(subs))
}

fn mapping(kind: PdoKind) -> Object {
    let sub_0 = entry("Number of mapped application objects", DataType::UNSIGNED8, Access::Rw, None);
    let slot =
        |sub: u8| (sub, entry(&format!("Application object {sub}"), DataType::UNSIGNED32, Access::Rw, None));
    record(format!("{kind} mapping parameter"), std::iter::once((0, sub_0)).chain((1..=64).map(slot)))
}

fn record(name: String, subs: impl Iterator<Item = (u8, Entry)>) -> Object {
    let main = Entry { name: name.into(), object_type: Some(ObjectType::Record), ..Entry::default() };
    let mut object = Object { main, subs: subs.collect(), ..Object::default() };
    object.sub_number = u8::try_from(object.subs.len()).ok();
    object
}

fn entry(name: &str, data_type: DataType, access: Access, default: Option<Value>) -> Entry {
    Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(access),
        pdo_mapping: Some(PdoMapping::No),
        default,
        ..Entry::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::DeviceInfo;

    /// The example of the standard: five RPDOs, two of which are described: 1402h and 1403h.
    fn example() -> Device {
        let info = DeviceInfo {
            rpdo_count: Some(5),
            tpdo_count: Some(1),
            compact_pdo: Some(0x13),
            ..DeviceInfo::default()
        };
        let mut device = Device { device_info: Some(info), ..Device::default() };
        for index in [0x1402, 0x1602, 0x1403, 0x1603, 0x1800, 0x1A00] {
            device.objects.insert(index, Object::default());
        }
        device
    }

    #[test]
    fn the_lowest_free_numbers_are_implied() {
        let rpdo = |number| (PdoKind::Rpdo, number);
        assert_eq!(example().implicit_pdos(), [rpdo(1), rpdo(2), rpdo(5)]);
    }

    #[test]
    fn implied_pdos_have_both_objects() {
        let device = example();
        let full = device.with_implicit_pdos();
        let pdo = full.pdo(PdoKind::Rpdo, 2).unwrap();
        assert_eq!(pdo.cob_id, CobId::from_value(&Value::NodeId(0x300)));
        assert_eq!((pdo.transmission_type, pdo.mapped_count, pdo.slots.len()), (None, None, 64));
        let subs: Vec<u8> = full.object(0x1401).unwrap().subs.iter().map(|(sub, _)| sub).collect();
        assert_eq!(subs, [0, 1, 2, 5]);
        assert_eq!(full.pdo(PdoKind::Rpdo, 5).unwrap().is_valid(), Some(false));
        assert_eq!(
            full.lists.optional.as_deref(),
            Some(&[0x1400, 0x1401, 0x1404, 0x1600, 0x1601, 0x1604][..])
        );
        assert!(full.implicit_pdos().is_empty());
    }

    #[test]
    fn nothing_is_implied_without_the_key() {
        let mut device = example();
        device.device_info.as_mut().unwrap().compact_pdo = None;
        assert!(device.implicit_pdos().is_empty());
        assert!(matches!(device.with_implicit_pdos(), Cow::Borrowed(_)));
    }
}

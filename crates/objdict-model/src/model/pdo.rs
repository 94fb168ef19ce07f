//! PDOs: the communication parameter and the mapping parameter together (CiA 301 §7.5.2.35 to §7.5.2.38).

use std::collections::BTreeSet;

use super::{CobId, Device, Object, PdoKind, Value};

/// The content of a mapping entry: an entry of the dictionary and its number of bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MappedObject {
    /// Index.
    pub index: u16,
    /// Sub-index.
    pub sub: u8,
    /// Length in bits.
    pub bits: u8,
}

impl MappedObject {
    /// The object of the number in a mapping entry.
    pub const fn from_number(number: u32) -> Self {
        let [bits, sub, low, high] = number.to_le_bytes();
        Self { index: u16::from_le_bytes([low, high]), sub, bits }
    }

    /// The number of the mapping entry.
    pub const fn to_number(self) -> u32 {
        let [low, high] = self.index.to_le_bytes();
        u32::from_le_bytes([self.bits, self.sub, low, high])
    }

    /// Places mapped objects in the frame; `bits` is the length of one. Returns each with its lowest bit. The first
    /// object occupies the lowest bits, and the others follow without gaps (CiA 301 §7.2.2.2).
    pub fn placed<T>(
        objects: impl IntoIterator<Item = T>,
        bits: impl Fn(&T) -> u8,
    ) -> impl Iterator<Item = (u32, T)> {
        objects.into_iter().scan(0, move |next, object| {
            let first = *next;
            *next += u32::from(bits(&object));
            Some((first, object))
        })
    }

    /// The index and sub-index.
    pub const fn entry(self) -> (u16, u8) {
        (self.index, self.sub)
    }

    /// Whether the number is 0, so that nothing is mapped.
    pub const fn is_unused(self) -> bool {
        self.to_number() == 0
    }

    /// Whether a data type is mapped: a dummy entry of an RPDO (CiA 301 §7.4.7.1).
    pub const fn is_dummy(self) -> bool {
        self.index > 0 && self.index < 0x20
    }
}

// The usual notation: `6041h:00, 16 bits`.
crate::messages! { MappedObject: {
    Self { index, sub, bits: 1, .. } => "{index:04X}h:{sub:02X}, 1 bit";
    Self { index, sub, bits, .. } => "{index:04X}h:{sub:02X}, {bits} bits";
} }

/// A described sub-index 1 to 64 of a mapping parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MappingSlot {
    /// The sub-index of the mapping parameter.
    pub sub: u8,
    /// The mapped object; `None` if the mapping has no value.
    pub object: Option<MappedObject>,
}

/// A PDO: the values of its two objects after configuration ([`Entry::value`](super::Entry::value)). A field
/// is `None` if the description has no such sub-index, no value, or a value that is not valid.
#[derive(Clone, Debug)]
pub struct Pdo<'a> {
    /// Direction.
    pub kind: PdoKind,
    /// Number, 1 to 512.
    pub number: u16,
    /// The communication parameter.
    pub communication: Option<&'a Object>,
    /// The mapping parameter.
    pub mapping: Option<&'a Object>,
    /// COB-ID, sub-index 1.
    pub cob_id: Option<CobId>,
    /// Transmission type, sub-index 2.
    pub transmission_type: Option<u8>,
    /// Inhibit time in multiples of 100 µs, sub-index 3.
    pub inhibit_time: Option<u16>,
    /// Event timer in milliseconds, sub-index 5.
    pub event_timer: Option<u16>,
    /// SYNC start value, sub-index 6.
    pub sync_start_value: Option<u8>,
    /// The number of mapped objects, sub-index 0 of the mapping parameter.
    pub mapped_count: Option<u8>,
    /// The described sub-indexes 1 to 64 of the mapping parameter.
    pub slots: Vec<MappingSlot>,
}

impl<'a> Pdo<'a> {
    /// The bits of a classical CAN data field.
    pub const FRAME_BITS: u32 = 64;

    fn new(device: &'a Device, kind: PdoKind, number: u16) -> Self {
        let object = |index: Option<u16>| device.object(index?);
        let communication = object(kind.communication_index(number));
        let mapping = object(kind.mapping_index(number));
        Self {
            kind,
            number,
            communication,
            mapping,
            cob_id: communication.and_then(cob_id),
            transmission_type: number_in(communication, 2),
            inhibit_time: number_in(communication, 3),
            event_timer: number_in(communication, 5),
            sync_start_value: number_in(communication, 6),
            mapped_count: number_in(mapping, 0),
            slots: mapping.map(slots).unwrap_or_default(),
        }
    }

    /// The index of the communication parameter.
    pub fn communication_index(&self) -> u16 {
        self.kind.communication_index(self.number).unwrap_or(self.kind.first_communication())
    }

    /// The index of the mapping parameter.
    pub fn mapping_index(&self) -> u16 {
        self.communication_index() + 0x200
    }

    /// Whether the PDO is valid: bit 31 of its COB-ID is clear. `None` if the COB-ID is unknown.
    pub fn is_valid(&self) -> Option<bool> {
        self.cob_id.map(CobId::is_valid)
    }

    /// Whether SYNC triggers the PDO: transmission types 0 to 240, for a TPDO also 252.
    pub fn is_synchronous(&self) -> bool {
        match self.transmission_type {
            Some(0..=240) => true,
            Some(252) => self.kind == PdoKind::Tpdo,
            _ => false,
        }
    }

    /// Whether an event triggers the PDO: transmission types 254 and 255.
    pub fn is_event_driven(&self) -> bool {
        matches!(self.transmission_type, Some(254 | 255))
    }

    /// Whether the PDO is a multiplexed PDO, whose frames contain the index of the object (CiA 301
    /// §7.5.2.36).
    pub fn is_multiplexed(&self) -> bool {
        matches!(self.mapped_count, Some(0xFE | 0xFF))
    }

    /// The slots in use, in the order of the frame: up to the number of mapped objects.
    pub fn used_slots(&self) -> impl Iterator<Item = MappingSlot> + '_ {
        let count = self.mapped_count.filter(|&count| count <= 64).unwrap_or(0);
        self.slots.iter().copied().take_while(move |slot| slot.sub <= count)
    }

    /// The mapped objects with their sub-indexes, in the order of the frame.
    pub fn mapped_slots(&self) -> impl Iterator<Item = (u8, MappedObject)> + '_ {
        let slots = self.used_slots().filter_map(|slot| Some((slot.sub, slot.object?)));
        slots.filter(|(_, object)| !object.is_unused())
    }

    /// The mapped objects, in the order of the frame.
    pub fn mapped(&self) -> impl Iterator<Item = MappedObject> + '_ {
        self.mapped_slots().map(|(_, object)| object)
    }

    /// The total number of mapped bits.
    pub fn bit_length(&self) -> u32 {
        self.mapped().map(|object| u32::from(object.bits)).sum()
    }
}

// `RPDO 1`.
crate::messages! { Pdo<'_>: { Self { kind, number, .. } => "{kind} {number}"; } }

fn number_in<T: TryFrom<i128>>(object: Option<&Object>, sub: u8) -> Option<T> {
    object?.value(sub)?.as_integer().and_then(|number| T::try_from(number).ok())
}

fn cob_id(communication: &Object) -> Option<CobId> {
    CobId::from_value(communication.value(1)?.as_ref())
}

fn slots(mapping: &Object) -> Vec<MappingSlot> {
    let mapped = |value: &Value| {
        let number = u32::try_from(value.as_integer()?).ok()?;
        Some(MappedObject::from_number(number))
    };
    let values = mapping.values(64);
    values.map(|(sub, value)| MappingSlot { sub, object: value.and_then(|value| mapped(&value)) }).collect()
}

impl Device {
    /// The PDOs with described objects: first RPDOs, then TPDOs, by number. PDOs that `CompactPDO` implies
    /// are not included; see [`Device::with_implicit_pdos`].
    pub fn pdos(&self) -> impl Iterator<Item = Pdo<'_>> {
        PdoKind::ALL.into_iter().flat_map(move |kind| {
            self.pdo_numbers(kind).into_iter().map(move |number| Pdo::new(self, kind, number))
        })
    }

    /// The PDO with this number, if the description has an object for it.
    pub fn pdo(&self, kind: PdoKind, number: u16) -> Option<Pdo<'_>> {
        let described = |index: Option<u16>| index.is_some_and(|index| self.objects.contains_key(&index));
        let exists = described(kind.communication_index(number)) || described(kind.mapping_index(number));
        exists.then(|| Pdo::new(self, kind, number))
    }

    /// The COB-ID of a PDO, sub-index 1 of its communication parameter.
    pub fn pdo_cob_id(&self, kind: PdoKind, number: u16) -> Option<CobId> {
        self.object(kind.communication_index(number)?).and_then(cob_id)
    }

    /// The number of PDOs of a direction in [`pdos`](Self::pdos).
    pub fn pdo_count(&self, kind: PdoKind) -> usize {
        self.pdo_numbers(kind).len()
    }

    /// The numbers of the PDOs with a communication parameter or a mapping parameter.
    pub(super) fn pdo_numbers(&self, kind: PdoKind) -> BTreeSet<u16> {
        let first = kind.first_communication();
        let from = |first: u16| {
            self.objects.range(first..first + PdoKind::MAX).map(move |(&index, _)| index - first + 1)
        };
        from(first).chain(from(first + 0x200)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{DataType, Entry, ObjectType};

    fn record(values: &[(u8, u64)]) -> Object {
        let entry = |value| Entry {
            data_type: Some(DataType::UNSIGNED32),
            default: Some(Value::Unsigned(value)),
            ..Entry::default()
        };
        let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
        Object {
            main,
            subs: values.iter().map(|&(sub, value)| (sub, entry(value))).collect(),
            ..Object::default()
        }
    }

    #[test]
    fn indexes_and_numbers() {
        assert_eq!(PdoKind::Rpdo.communication_index(1), Some(0x1400));
        assert_eq!(PdoKind::Tpdo.mapping_index(512), Some(0x1BFF));
        assert_eq!(PdoKind::Tpdo.mapping_index(513), None);
        assert_eq!(PdoKind::of_mapping(0x1A02), Some((PdoKind::Tpdo, 3)));
        assert_eq!(PdoKind::of_mapping(0x1402), None);
        let ids =
            |kind: PdoKind| (1..=5).map(move |number| kind.predefined_can_id(number)).collect::<Vec<_>>();
        assert_eq!(ids(PdoKind::Rpdo), [Some(0x200), Some(0x300), Some(0x400), Some(0x500), None]);
        assert_eq!(ids(PdoKind::Tpdo), [Some(0x180), Some(0x280), Some(0x380), Some(0x480), None]);
    }

    #[test]
    fn both_objects_make_a_pdo() {
        let mut device = Device::default();
        device.objects.insert(0x1801, record(&[(0, 5), (1, 0x4000_0285), (2, 252), (3, 10), (5, 100)]));
        device
            .objects
            .insert(0x1A01, record(&[(0, 2), (1, 0x6000_0108), (2, 0x6401_0210), (3, 0x6401_0310)]));
        device.objects.insert(0x1A02, record(&[(0, 0xFF)]));
        let pdos: Vec<Pdo<'_>> = device.pdos().collect();
        assert_eq!(pdos.iter().map(ToString::to_string).collect::<Vec<_>>(), ["TPDO 2", "TPDO 3"]);
        let pdo = &pdos[0];
        assert_eq!((pdo.communication_index(), pdo.mapping_index()), (0x1801, 0x1A01));
        assert_eq!((pdo.inhibit_time, pdo.event_timer, pdo.sync_start_value), (Some(10), Some(100), None));
        assert!(pdo.is_valid() == Some(true) && pdo.is_synchronous() && !pdo.is_event_driven());
        let mapped: Vec<String> = pdo.mapped().map(|object| object.to_string()).collect();
        assert_eq!(mapped, ["6000h:01, 8 bits", "6401h:02, 16 bits"]);
        assert_eq!((pdo.slots.len(), pdo.bit_length()), (3, 24));
        assert!(pdos[1].communication.is_none() && pdos[1].is_multiplexed() && pdos[1].is_valid().is_none());
    }
}

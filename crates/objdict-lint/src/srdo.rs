//! SRDOs: the communication parameter and the mapping of each (EN 50325-5, formerly CiA 304).

use std::ops::RangeInclusive;

use crate::diagnostic::{Argument, Sayable, say};
use crate::model::{CobId, Device, MappedObject, MappingSlot, Object};

/// An SRDO: the configured values of its communication parameter and its mapping.
pub(crate) struct Srdo<'a> {
    /// The number, 1 to 64.
    pub number: u16,
    /// 1301h to 1340h.
    pub communication: Option<&'a Object>,
    /// 1381h to 13C0h.
    pub mapping: Option<&'a Object>,
    /// Sub-index 0 of the mapping.
    pub mapped_count: Option<u8>,
    /// The described sub-indexes 1 to 16 of the mapping.
    pub slots: Vec<MappingSlot>,
}

impl<'a> Srdo<'a> {
    /// The SRDOs with at least one described object, by number.
    pub(crate) fn all(device: &'a Device) -> Vec<Self> {
        if device.objects.range(0x1301..=0x13C0).next().is_none() {
            return Vec::new();
        }
        let srdos = (1..=64).map(|number| Self::new(device, number));
        srdos.filter(|srdo| srdo.communication.is_some() || srdo.mapping.is_some()).collect()
    }

    fn new(device: &'a Device, number: u16) -> Self {
        let communication = device.object(0x1300 + number);
        let mapping = device.object(0x1380 + number);
        let mapped_count = mapping.and_then(|object| u8::try_from(object.value(0)?.as_integer()?).ok());
        let slot = |object: &Object, sub| {
            let number = object.value(sub).and_then(|value| u32::try_from(value.as_integer()?).ok());
            MappingSlot { sub, object: number.map(MappedObject::from_number) }
        };
        let slots = mapping
            .map(|object| (1..=16).filter(|&sub| object.has(sub)).map(|sub| slot(object, sub)).collect());
        Self { number, communication, mapping, mapped_count, slots: slots.unwrap_or_default() }
    }

    /// The index of the communication parameter.
    pub(crate) fn communication_index(&self) -> u16 {
        0x1300 + self.number
    }

    /// The index of the mapping parameter.
    pub(crate) fn mapping_index(&self) -> u16 {
        0x1380 + self.number
    }

    /// The index of the first described object.
    pub(crate) fn first_index(&self) -> u16 {
        if self.communication.is_some() { self.communication_index() } else { self.mapping_index() }
    }

    /// The value of a sub-index of the communication parameter.
    pub(crate) fn number(&self, sub: u8) -> Option<i128> {
        self.communication?.value(sub)?.as_integer()
    }

    /// A COB-ID, sub-index 5 or 6, for the node of a DCF; `None` for a formula without a node-ID.
    pub(crate) fn cob_id(&self, node_ids: &RangeInclusive<u8>, sub: u8) -> Option<i128> {
        let cob_id = CobId::from_value(self.communication?.value(sub)?.as_ref())?;
        let is_known = !cob_id.depends_on_node_id() || node_ids.start() == node_ids.end();
        is_known.then(|| i128::from(cob_id.on_node(*node_ids.start())))
    }

    /// Whether the SRDO is active: sent or received.
    pub(crate) fn is_on(&self) -> bool {
        matches!(self.number(1), Some(1 | 2))
    }

    /// The mapping entries in use with their sub-indexes.
    pub(crate) fn mapped(&self) -> impl Iterator<Item = (u8, MappedObject)> {
        let count = self.mapped_count.filter(|&count| count <= 16).unwrap_or(0);
        let used = self.slots.iter().take_while(move |slot| slot.sub <= count);
        used.filter_map(|slot| Some((slot.sub, slot.object?))).filter(|(_, object)| !object.is_unused())
    }

    /// The mapping entries in use as pairs of the plain and the inverted one.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = ((u8, MappedObject), (u8, MappedObject))> {
        let inverted = |sub: u8| self.mapped().find(|(other, _)| *other == sub + 1);
        self.mapped()
            .filter(|(sub, _)| sub % 2 == 1)
            .filter_map(move |plain| Some((plain, inverted(plain.0)?)))
    }
}

/// `SRDO 1`.
impl Sayable for Srdo<'_> {
    fn argument(&self) -> Argument {
        say!("SRDO {}", self.number).argument()
    }
}

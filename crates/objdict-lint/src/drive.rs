//! An axis of a drive according to CiA 402, for the rules of that group: the objects of one logical device,
//! by the indexes of the document.

use super::Facts;
use super::demands::{Applied, is_there};
use crate::diagnostic::{Text, say};
use crate::model::{Device, Entry, Object, PdoKind, Place};
use crate::profile;

/// An axis.
#[derive(Clone, Copy)]
pub(crate) struct Drive<'a> {
    device: &'a Device,
    /// The logical device, counted from 0.
    block: u8,
}

/// A mode of operation.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Mode {
    /// The bit of the mode in 6502h.
    pub bit: u8,
    /// The number of the mode in 6060h.
    pub number: i128,
    pub name: &'static str,
}

/// The modes that CiA 402 defines.
pub(crate) const MODES: [Mode; 10] = [
    Mode { bit: 0, number: 1, name: "profile position" },
    Mode { bit: 1, number: 2, name: "velocity" },
    Mode { bit: 2, number: 3, name: "profile velocity" },
    Mode { bit: 3, number: 4, name: "torque profile" },
    Mode { bit: 5, number: 6, name: "homing" },
    Mode { bit: 6, number: 7, name: "interpolated position" },
    Mode { bit: 7, number: 8, name: "cyclic synchronous position" },
    Mode { bit: 8, number: 9, name: "cyclic synchronous velocity" },
    Mode { bit: 9, number: 10, name: "cyclic synchronous torque" },
    Mode { bit: 10, number: 11, name: "cyclic synchronous torque with commutation angle" },
];

impl<'a> Drive<'a> {
    pub(crate) fn new(facts: &Facts<'a>, applied: &Applied<'_>) -> Self {
        Self { device: facts.device, block: applied.block }
    }

    /// The index of an object of the document on this axis.
    pub(crate) const fn index(self, index: u16) -> u16 {
        profile::index_in(self.block, index)
    }

    /// The object in messages: `6040h`.
    pub(crate) fn name(self, index: u16) -> Text {
        say!("{:04X}h", self.index(index))
    }

    /// A described object.
    pub(crate) fn object(self, index: u16) -> Option<&'a Object> {
        self.device.object(self.index(index)).filter(|object| !object.orphan)
    }

    /// Whether an object is described.
    pub(crate) fn has(self, index: u16) -> bool {
        self.object(index).is_some()
    }

    /// Whether an object is neither described nor listed nor available from a module.
    pub(crate) fn lacks(self, index: u16) -> bool {
        !is_there(self.device, self.index(index))
    }

    /// The entry of a VAR.
    pub(crate) fn variable(self, index: u16) -> Option<&'a Entry> {
        let object = self.object(index)?;
        let is_single = !object.object_type().has_subs() && object.subs.is_empty();
        is_single.then_some(&object.main)
    }

    /// The configured or default number of an entry.
    pub(crate) fn value(self, index: u16, sub: u8) -> Option<i128> {
        self.object(index)?.value(sub)?.as_integer()
    }

    /// The place of the object.
    pub(crate) fn place(self, index: u16) -> Place {
        Place::object(self.index(index))
    }

    /// The place of the value of an entry.
    pub(crate) fn value_place(self, index: u16, sub: u8) -> Place {
        self.device.value_place(self.index(index), sub)
    }

    /// Whether a valid RPDO maps an entry.
    pub(crate) fn is_received(self, index: u16, sub: u8) -> bool {
        let mut pdos = self.device.pdos().filter(|pdo| pdo.kind == PdoKind::Rpdo);
        pdos.any(|pdo| {
            let is_mapped = || pdo.mapped().any(|object| object.entry() == (self.index(index), sub));
            pdo.is_valid() != Some(false) && is_mapped()
        })
    }

    /// The bits of the supported drive modes; `None` if the description does not state them.
    pub(crate) fn modes(self) -> Option<u32> {
        self.value(0x6502, 0).and_then(|modes| u32::try_from(modes).ok())
    }

    /// Whether a mode is supported.
    pub(crate) fn supports(self, bit: u8) -> Option<bool> {
        self.modes().map(|modes| modes >> bit & 1 == 1)
    }
}

//! The communication objects of a dictionary. For a table they are constants, so the compiler leaves out unused services.

use crate::table::Table;

/// The communication objects of a dictionary, for [`Dictionary::objects`](crate::Dictionary::objects). Code for objects
/// that are not included is not linked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectSet {
    present: u64,
    /// Objects with an entry that SDOs can write.
    writable: u64,
}

impl ObjectSet {
    /// No object.
    pub const NONE: Self = Self { present: 0, writable: 0 };

    /// All objects: the dictionary knows them only at run time.
    pub const ANY: Self = Self { present: u64::MAX, writable: u64::MAX };

    /// The objects of a table.
    #[must_use]
    pub const fn of<D: Table>() -> Self {
        let (mut objects, mut entries) = (Self::NONE, D::ENTRIES);
        while let [entry, rest @ ..] = entries {
            objects = objects.with(entry.index(), entry.is_writable());
            entries = rest;
        }
        objects
    }

    /// Adds the object of an entry, which SDOs may be able to write.
    #[must_use]
    pub const fn with(mut self, index: u16, is_writable: bool) -> Self {
        self.present |= bit(index);
        if is_writable {
            self.writable |= bit(index);
        }
        self
    }

    // always inline: omitted code must follow from constants

    /// Whether an object, or one of its kind, may exist.
    #[inline(always)]
    pub(crate) const fn has(self, index: u16) -> bool {
        self.present & bit(index) != 0
    }

    /// Whether SDOs may write an object, or one of its kind.
    #[inline(always)]
    pub(crate) const fn writes(self, index: u16) -> bool {
        self.writable & bit(index) != 0
    }
}

/// The bit of an object or of its kind; 0 for objects that no service uses.
#[inline(always)]
const fn bit(index: u16) -> u64 {
    match index {
        0x1000..=0x102F => 1 << (index & 0x3F),
        0x1200 => 1 << 48,
        0x1201..=0x127F => 1 << 49,
        0x1280..=0x12FF => 1 << 50,
        0x1400..=0x15FF | 0x1800..=0x19FF => 1 << 51,
        0x1600..=0x17FF | 0x1A00..=0x1BFF => 1 << 52,
        0x1F50 => 1 << 53,
        0x1F80 => 1 << 54,
        _ => 0,
    }
}

//! The directions of PDOs, and the indexes of their objects (CiA 301 §7.5.2.35 to §7.5.2.38).

named! {
    /// The direction of a PDO, from the view of the device.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum PdoKind {
        /// The device receives it.
        Rpdo = "RPDO",
        /// The device transmits it.
        Tpdo = "TPDO",
    }
}

impl PdoKind {
    /// The opposite direction.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Rpdo => Self::Tpdo,
            Self::Tpdo => Self::Rpdo,
        }
    }

    /// The maximum number of PDOs of a direction.
    pub const MAX: u16 = 512;

    /// The index of the communication parameter of PDO 1.
    pub(super) const fn first_communication(self) -> u16 {
        match self {
            Self::Rpdo => 0x1400,
            Self::Tpdo => 0x1800,
        }
    }

    /// The index of the communication parameter of a PDO; `None` if the number is not 1 to 512.
    pub const fn communication_index(self, number: u16) -> Option<u16> {
        if number == 0 || number > Self::MAX {
            return None;
        }
        Some(self.first_communication() + number - 1)
    }

    /// The index of the mapping parameter of a PDO; `None` if the number is not 1 to 512.
    pub const fn mapping_index(self, number: u16) -> Option<u16> {
        match self.communication_index(number) {
            Some(index) => Some(index + 0x200),
            None => None,
        }
    }

    /// The PDO of the communication parameter at this index.
    pub const fn of_communication(index: u16) -> Option<(Self, u16)> {
        match index {
            0x1400..=0x15FF => Some((Self::Rpdo, index - 0x1400 + 1)),
            0x1800..=0x19FF => Some((Self::Tpdo, index - 0x1800 + 1)),
            _ => None,
        }
    }

    /// The PDO of the mapping parameter at this index.
    pub const fn of_mapping(index: u16) -> Option<(Self, u16)> {
        match index {
            0x1600..=0x17FF | 0x1A00..=0x1BFF => Self::of_communication(index - 0x200),
            _ => None,
        }
    }

    /// The CAN-ID of PDO 1 to 4 in the predefined connection set, minus the node-ID (CiA 301 §7.3.5); `None`
    /// for other PDOs, which have none.
    pub const fn predefined_can_id(self, number: u16) -> Option<u16> {
        if number == 0 || number > 4 {
            return None;
        }
        Some(match self {
            Self::Rpdo => 0x100 + 0x100 * number,
            Self::Tpdo => 0x080 + 0x100 * number,
        })
    }
}

//! COB-IDs: a CAN-ID with flag bits (CiA 301 §7.5.2.5, §7.5.2.17, §7.5.2.33, §7.5.2.35), and the CAN-IDs
//! that CiA 301 assigns to its services (§7.3.3, §7.3.5).

use super::Value;

/// The COB-ID in a communication object: a number, or the node-ID plus a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CobId {
    /// The number, including flags.
    number: u32,
    /// Whether the node-ID is added.
    plus_node_id: bool,
}

impl CobId {
    /// Bit 31. PDO, SDO and EMCY: not valid. TIME: the device consumes it.
    pub const BIT_31: u32 = 1 << 31;
    /// Bit 30. TPDO: no RTR allowed. SYNC and TIME: the device produces it. SDO: assigned dynamically.
    pub const BIT_30: u32 = 1 << 30;
    /// Bit 29: the CAN-ID has 29 bits, otherwise 11.
    pub const FRAME: u32 = 1 << 29;

    /// A COB-ID with this number.
    pub const fn new(number: u32) -> Self {
        Self { number, plus_node_id: false }
    }

    /// The node-ID plus a number; `None` if the sum would reach the flag bits.
    pub const fn per_node(number: u32) -> Option<Self> {
        if (number & 0x1FFF_FFFF) + 127 > 0x1FFF_FFFF {
            return None;
        }
        Some(Self { number, plus_node_id: true })
    }

    /// The COB-ID of a value; `None` if the value is not a 32-bit number.
    pub fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::NodeId(offset) => Self::per_node(u32::try_from(*offset).ok()?),
            _ => Some(Self::new(u32::try_from(value.as_integer()?).ok()?)),
        }
    }

    /// The COB-ID as a value.
    pub fn to_value(self) -> Value {
        if self.plus_node_id {
            Value::NodeId(self.number.into())
        } else {
            Value::Unsigned(self.number.into())
        }
    }

    /// The number; the node-ID is added if [`depends_on_node_id`](Self::depends_on_node_id).
    pub const fn number(self) -> u32 {
        self.number
    }

    /// Whether the node-ID is added.
    pub const fn depends_on_node_id(self) -> bool {
        self.plus_node_id
    }

    /// The COB-ID on a node.
    pub const fn on_node(self, node_id: u8) -> u32 {
        if self.plus_node_id { self.number + node_id as u32 } else { self.number }
    }

    /// The CAN-ID on a node.
    pub const fn can_id(self, node_id: u8) -> u32 {
        self.on_node(node_id) & self.can_id_mask()
    }

    /// Whether bit 31 is clear: the PDO, SDO or EMCY is valid.
    pub const fn is_valid(self) -> bool {
        self.number & Self::BIT_31 == 0
    }

    /// Whether bit 30 is set.
    pub const fn bit_30(self) -> bool {
        self.number & Self::BIT_30 != 0
    }

    /// Whether the CAN-ID has 29 bits.
    pub const fn is_extended(self) -> bool {
        self.number & Self::FRAME != 0
    }

    /// The set bits above an 11-bit CAN-ID of a base frame, on any node.
    pub const fn stray_bits(self) -> u32 {
        if self.is_extended() { 0 } else { self.on_node(127) & 0x1FFF_F800 }
    }

    /// The same COB-ID with bit 31 set: the service is not valid.
    #[must_use]
    pub const fn disabled(self) -> Self {
        Self { number: self.number | Self::BIT_31, ..self }
    }

    /// The same COB-ID with bit 31 clear.
    #[must_use]
    pub const fn enabled(self) -> Self {
        Self { number: self.number & !Self::BIT_31, ..self }
    }

    /// The CAN-ID without the bits above it.
    #[must_use]
    pub const fn without_flags(self) -> Self {
        Self { number: self.number & self.can_id_mask(), ..self }
    }

    /// The bits of the CAN-ID.
    pub const fn can_id_mask(self) -> u32 {
        if self.is_extended() { 0x1FFF_FFFF } else { 0x7FF }
    }
}

// The spelling of an EDS: `0x80000000`, `$NODEID+0x180`.
crate::messages! { CobId: {
    Self { plus_node_id: true, number: 0, .. } => "$NODEID";
    Self { plus_node_id: true, number, .. } => "$NODEID+0x{number:X}";
    Self { number, .. } => "0x{number:X}";
} }

/// CAN-IDs of the predefined connection set (CiA 301 §7.3.5), which a device uses until it is configured.
pub mod predefined {
    use super::CobId;

    /// The CAN-ID of NMT commands.
    pub const NMT: u16 = 0x000;
    /// The CAN-ID of SYNC.
    pub const SYNC: u16 = 0x080;
    /// The CAN-ID of TIME.
    pub const TIME: u16 = 0x100;
    /// The CAN-ID of EMCY minus the node-ID.
    pub const EMCY: u16 = 0x080;
    /// The CAN-ID of the default SDO from server to client, minus the node-ID of the server.
    pub const SDO_RESPONSE: u16 = 0x580;
    /// The CAN-ID of the default SDO from client to server, minus the node-ID of the server.
    pub const SDO_REQUEST: u16 = 0x600;
    /// The CAN-ID of heartbeat, boot-up and guarding, minus the node-ID.
    pub const ERROR_CONTROL: u16 = 0x700;

    /// The COB-ID of a service whose CAN-ID is this base plus the node-ID.
    pub const fn per_node(base: u16) -> CobId {
        CobId { number: base as u32, plus_node_id: true }
    }
}

/// The owner of a CAN-ID that no configurable service may use (CiA 301 §7.3.5, table 40); `None` for any
/// other. Only base frames have restricted CAN-IDs.
pub const fn restricted(can_id: u32) -> Option<&'static str> {
    Some(match can_id {
        0x000 => "NMT",
        0x001..=0x07F => "reserved",
        0x101..=0x180 => "reserved",
        0x581..=0x5FF => "default SDO, server to client",
        0x601..=0x67F => "default SDO, client to server",
        0x6E0..=0x6FF => "reserved",
        0x701..=0x77F => "NMT error control",
        0x780..=0x7FF => "reserved",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_and_identifier_of_a_formula() {
        let cob_id = CobId::from_value(&Value::NodeId(0xC000_0180)).unwrap();
        assert!(!cob_id.is_valid() && cob_id.bit_30() && !cob_id.is_extended());
        assert_eq!((cob_id.can_id(5), cob_id.stray_bits()), (0x185, 0));
        assert_eq!(cob_id.to_string(), "$NODEID+0xC0000180");
        assert_eq!(cob_id.to_value(), Value::NodeId(0xC000_0180));
    }

    #[test]
    fn stray_bits_are_seen_on_the_highest_node_too() {
        assert_eq!(CobId::new(0x0800_0000).stray_bits(), 0x0800_0000);
        assert_eq!(CobId::new(0x2800_0000).stray_bits(), 0);
        assert_eq!(CobId::per_node(0x7F0).unwrap().stray_bits(), 0x800);
    }

    #[test]
    fn what_is_no_cob_id() {
        assert_eq!(CobId::from_value(&Value::Unsigned(1 << 32)), None);
        assert_eq!(CobId::from_value(&Value::Signed(-1)), None);
        assert_eq!(CobId::from_value(&Value::NodeId(0x1FFF_FFFF)), None);
        assert_eq!(CobId::from_value(&Value::NodeId(u64::MAX)), None);
    }

    #[test]
    fn restricted_identifiers() {
        let free: Vec<u32> = (0..0x800).filter(|&id| restricted(id).is_none()).collect();
        assert!(
            free.contains(&0x080) && free.contains(&0x100) && free.contains(&0x181) && free.contains(&0x6DF)
        );
        assert!(
            !free.contains(&0x000)
                && !free.contains(&0x180)
                && !free.contains(&0x581)
                && !free.contains(&0x7E5)
        );
    }
}

//! Data types (CiA 301 §7.4.7, table 44).

use std::fmt;

/// A data type, identified by the index of its definition in the object dictionary.
///
/// 0001h to 001Bh are the static types of CiA 301; 0020h to 0025h its predefined structures; devices and
/// profiles define types from 0040h on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DataType(pub u16);

/// The kind of values of a data type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypeKind {
    /// One bit in a PDO, one byte in an SDO.
    Boolean,
    /// Two's complement integer with this number of bits.
    Signed(u8),
    /// Integer with this number of bits.
    Unsigned(u8),
    /// IEEE 754 binary32.
    Real32,
    /// IEEE 754 binary64.
    Real64,
    /// ISO 646 string.
    VisibleString,
    /// Bytes.
    OctetString,
    /// UTF-16 string.
    UnicodeString,
    /// Milliseconds of the day and days since 1984-01-01, 48 bits.
    TimeOfDay,
    /// Milliseconds and days, 48 bits.
    TimeDifference,
    /// A block of data of any size.
    Domain,
    /// A structure defined by CiA 301 (0020h-0025h).
    Structure,
    /// Defined by the device, a profile or the vendor (0040h-025Fh).
    Defined,
    /// An index without a type.
    Reserved,
}

macro_rules! static_types {
    ($($NAME:ident = $index:literal, $kind:expr;)* {  $($STRUCTURE:ident = $at:literal;)* }) => {
        impl DataType {
            $(#[doc = concat!("The data type ", stringify!($NAME), ".")] pub const $NAME: Self = Self($index);)*

            /// The defined types from 0001h to 001Bh, in order of their indexes.
            pub const STATIC: &'static [Self] = &[$(Self::$NAME),*];

            /// The name in CiA 301; `None` for types without one.
            pub const fn name(self) -> Option<&'static str> {
                match self.0 {
                    $($index => Some(stringify!($NAME)),)*
                    $($at => Some(stringify!($STRUCTURE)),)*
                    _ => None,
                }
            }

            /// The type with this name in CiA 301.
            pub fn from_name(name: &str) -> Option<Self> {
                (1..=0x25).map(Self).find(|data_type| data_type.name() == Some(name))
            }

            /// The kind of values of this type.
            pub const fn kind(self) -> TypeKind {
                match self.0 {
                    $($index => $kind,)*
                    0x20..=0x25 => TypeKind::Structure,
                    0x40..=0x25F => TypeKind::Defined,
                    _ => TypeKind::Reserved,
                }
            }
        }
    };
}

static_types! {
    BOOLEAN = 0x01, TypeKind::Boolean;
    INTEGER8 = 0x02, TypeKind::Signed(8);
    INTEGER16 = 0x03, TypeKind::Signed(16);
    INTEGER32 = 0x04, TypeKind::Signed(32);
    UNSIGNED8 = 0x05, TypeKind::Unsigned(8);
    UNSIGNED16 = 0x06, TypeKind::Unsigned(16);
    UNSIGNED32 = 0x07, TypeKind::Unsigned(32);
    REAL32 = 0x08, TypeKind::Real32;
    VISIBLE_STRING = 0x09, TypeKind::VisibleString;
    OCTET_STRING = 0x0A, TypeKind::OctetString;
    UNICODE_STRING = 0x0B, TypeKind::UnicodeString;
    TIME_OF_DAY = 0x0C, TypeKind::TimeOfDay;
    TIME_DIFFERENCE = 0x0D, TypeKind::TimeDifference;
    DOMAIN = 0x0F, TypeKind::Domain;
    INTEGER24 = 0x10, TypeKind::Signed(24);
    REAL64 = 0x11, TypeKind::Real64;
    INTEGER40 = 0x12, TypeKind::Signed(40);
    INTEGER48 = 0x13, TypeKind::Signed(48);
    INTEGER56 = 0x14, TypeKind::Signed(56);
    INTEGER64 = 0x15, TypeKind::Signed(64);
    UNSIGNED24 = 0x16, TypeKind::Unsigned(24);
    UNSIGNED40 = 0x18, TypeKind::Unsigned(40);
    UNSIGNED48 = 0x19, TypeKind::Unsigned(48);
    UNSIGNED56 = 0x1A, TypeKind::Unsigned(56);
    UNSIGNED64 = 0x1B, TypeKind::Unsigned(64);
    {
        PDO_COMMUNICATION_PARAMETER = 0x20;
        PDO_MAPPING = 0x21;
        SDO_PARAMETER = 0x22;
        IDENTITY = 0x23;
        OS_DEBUG = 0x24;
        OS_COMMAND = 0x25;
    }
}

impl DataType {
    /// The type of sub-index 0 of an object with sub-indexes (CiA 301 §7.4.7.2); `None` for the obsolete 1004h, which has
    /// numbers of PDOs there.
    pub const fn of_sub_0(index: u16) -> Option<Self> {
        if index == 0x1004 { None } else { Some(Self::UNSIGNED8) }
    }

    /// The unsigned integer type of this size; `None` if there is none.
    pub const fn unsigned(bytes: usize) -> Option<Self> {
        Some(match bytes {
            1 => Self::UNSIGNED8,
            2 => Self::UNSIGNED16,
            3 => Self::UNSIGNED24,
            4 => Self::UNSIGNED32,
            5 => Self::UNSIGNED40,
            6 => Self::UNSIGNED48,
            7 => Self::UNSIGNED56,
            8 => Self::UNSIGNED64,
            _ => return None,
        })
    }

    /// The number of bits of a value in a PDO; `None` if the length varies or is unknown.
    pub const fn bit_length(self) -> Option<u8> {
        match self.kind() {
            TypeKind::Boolean => Some(1),
            TypeKind::Signed(bits) | TypeKind::Unsigned(bits) => Some(bits),
            TypeKind::Real32 => Some(32),
            TypeKind::Real64 => Some(64),
            TypeKind::TimeOfDay | TypeKind::TimeDifference => Some(48),
            _ => None,
        }
    }

    /// The number of bytes of a value in an SDO; `None` if the length varies or is unknown.
    pub const fn byte_length(self) -> Option<u8> {
        match self.bit_length() {
            Some(bits) => Some(bits.div_ceil(8)),
            None => None,
        }
    }

    /// Whether values are integers (BOOLEAN is not one).
    pub const fn is_integer(self) -> bool {
        matches!(self.kind(), TypeKind::Signed(_) | TypeKind::Unsigned(_))
    }

    /// Whether values can be compared with limits: integers, REAL and BOOLEAN.
    pub const fn is_numeric(self) -> bool {
        self.is_integer() || matches!(self.kind(), TypeKind::Boolean | TypeKind::Real32 | TypeKind::Real64)
    }

    /// The smallest and the largest value of an integer type or BOOLEAN.
    pub const fn integer_range(self) -> Option<(i128, i128)> {
        match self.kind() {
            TypeKind::Boolean => Some((0, 1)),
            TypeKind::Signed(bits) => Some((-(1 << (bits - 1)), (1 << (bits - 1)) - 1)),
            TypeKind::Unsigned(bits) => Some((0, (1 << bits) - 1)),
            _ => None,
        }
    }

    /// Whether the type can be a dummy entry in an RPDO mapping (CiA 301 §7.4.7.1).
    pub const fn is_dummy(self) -> bool {
        matches!(self.0, 0x01..=0x07 | 0x10 | 0x12..=0x16 | 0x18..=0x1B)
    }
}

impl fmt::Display for DataType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name() {
            Some(name) => f.write_str(name),
            None => write!(f, "{:04X}h", self.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for index in 0..=0x60 {
            let data_type = DataType(index);
            if let Some(name) = data_type.name() {
                assert_eq!(DataType::from_name(name), Some(data_type));
            }
            let json = serde_json::to_string(&data_type).unwrap();
            assert_eq!(serde_json::from_str::<DataType>(&json).unwrap(), data_type);
        }
        assert!(serde_json::from_str::<DataType>("\"UNSIGNED9\"").is_err());
    }
}

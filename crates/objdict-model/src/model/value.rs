//! Values of entries, typed by their data type.

use std::fmt;

use super::{DataType, TypeKind};

/// A value of an entry: a default, a limit, or the configured value of a DCF.
///
/// The data type of the entry determines the variant. A text that is not valid for the type is in the
/// [`InvalidValues`](super::InvalidValues) of the entry instead.
#[derive(Clone, Debug)]
pub enum Value {
    /// BOOLEAN.
    Boolean(bool),
    /// INTEGERn.
    Signed(i64),
    /// UNSIGNEDn.
    Unsigned(u64),
    /// REAL32.
    Real32(f32),
    /// REAL64.
    Real64(f64),
    /// VISIBLE_STRING and UNICODE_STRING.
    Text(Box<str>),
    /// OCTET_STRING and DOMAIN.
    Bytes(Box<[u8]>),
    /// TIME_OF_DAY and TIME_DIFFERENCE.
    Time(Time),
    /// The node-ID plus this number (CiA 306-1 §4.3: `$NODEID+n`), for integer types.
    NodeId(u64),
    /// A text with a non-static data type, as written.
    Raw(Box<str>),
}

/// A TIME_OF_DAY or TIME_DIFFERENCE (CiA 301 §7.1.6.5).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Time {
    /// Whole days; for TIME_OF_DAY since 1984-01-01.
    pub days: u16,
    /// Milliseconds after midnight, 28 bits.
    pub milliseconds: u32,
}

impl Time {
    /// The six bytes on the wire: milliseconds in the lower 28 bits of the first four, then the days.
    pub fn to_bytes(self) -> [u8; 6] {
        let [a, b, c, d] = self.milliseconds.to_le_bytes();
        let [e, f] = self.days.to_le_bytes();
        [a, b, c, d, e, f]
    }

    /// The time from six bytes on the wire; the four void bits are dropped.
    pub fn from_bytes([a, b, c, d, e, f]: [u8; 6]) -> Self {
        Self { days: u16::from_le_bytes([e, f]), milliseconds: u32::from_le_bytes([a, b, c, d & 0x0F]) }
    }
}

impl Value {
    /// The value as an integer; `None` for formulas, REAL and values that are not numbers.
    pub fn as_integer(&self) -> Option<i128> {
        match *self {
            Self::Boolean(value) => Some(i128::from(value)),
            Self::Signed(value) => Some(i128::from(value)),
            Self::Unsigned(value) => Some(i128::from(value)),
            _ => None,
        }
    }

    /// The value as a number, including REAL.
    pub fn as_real(&self) -> Option<f64> {
        match *self {
            Self::Real32(value) => Some(f64::from(value)),
            Self::Real64(value) => Some(value),
            _ => self.as_integer().map(|value| value as f64),
        }
    }

    /// The value as an integer on the node `node_id`, with formulas evaluated.
    pub fn integer_for(&self, node_id: u8) -> Option<i128> {
        match *self {
            Self::NodeId(offset) => Some(i128::from(offset) + i128::from(node_id)),
            _ => self.as_integer(),
        }
    }

    /// The value on the node `node_id`: a formula becomes a number, any other value is unchanged. `None` if
    /// the number does not fit `data_type`.
    pub fn resolve(&self, data_type: DataType, node_id: u8) -> Option<Value> {
        match self {
            Self::NodeId(_) => Self::from_integer(self.integer_for(node_id)?, data_type),
            _ => Some(self.clone()),
        }
    }

    /// The value of an integer type or BOOLEAN from a number; `None` if it is out of range.
    pub fn from_integer(number: i128, data_type: DataType) -> Option<Value> {
        let (low, high) = data_type.integer_range()?;
        if number < low || number > high {
            return None;
        }
        match data_type.kind() {
            TypeKind::Boolean => Some(Self::Boolean(number == 1)),
            TypeKind::Signed(_) => i64::try_from(number).ok().map(Self::Signed),
            TypeKind::Unsigned(_) => u64::try_from(number).ok().map(Self::Unsigned),
            _ => None,
        }
    }

    /// Whether this is a value of `data_type`. Any value is accepted for a non-static or unknown type.
    pub fn is_of(&self, data_type: Option<DataType>) -> bool {
        let Some(data_type) = data_type else { return true };
        match (self, data_type.kind()) {
            (_, TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved) => true,
            (Self::NodeId(_), _) => data_type.is_integer(),
            (Self::Time(time), TypeKind::TimeOfDay | TypeKind::TimeDifference) => {
                time.milliseconds >> 28 == 0
            }
            (Self::Boolean(_) | Self::Signed(_) | Self::Unsigned(_), _) => {
                let number = self.as_integer().and_then(|number| Self::from_integer(number, data_type));
                number.as_ref() == Some(self)
            }
            _ => self.to_bytes(data_type).is_some(),
        }
    }

    /// The value as an SDO transfers it: little-endian, strings without terminator, UNICODE_STRING as UTF-16.
    ///
    /// `None` for a formula (see [`Value::resolve`]), for [`Value::Raw`], and if the value is not one of
    /// `data_type`.
    pub fn to_bytes(&self, data_type: DataType) -> Option<Vec<u8>> {
        match (self, data_type.kind()) {
            (Self::Boolean(value), TypeKind::Boolean) => Some(vec![u8::from(*value)]),
            (Self::Signed(value), TypeKind::Signed(bits)) => {
                Some(value.to_le_bytes()[..usize::from(bits / 8)].to_vec())
            }
            (Self::Unsigned(value), TypeKind::Unsigned(bits)) => {
                Some(value.to_le_bytes()[..usize::from(bits / 8)].to_vec())
            }
            (Self::Real32(value), TypeKind::Real32) => Some(value.to_le_bytes().to_vec()),
            (Self::Real64(value), TypeKind::Real64) => Some(value.to_le_bytes().to_vec()),
            (Self::Text(text), TypeKind::UnicodeString) => {
                Some(text.encode_utf16().flat_map(u16::to_le_bytes).collect())
            }
            (Self::Text(text), TypeKind::VisibleString) => Some(text.as_bytes().to_vec()),
            (Self::Bytes(bytes), TypeKind::OctetString | TypeKind::Domain) => Some(bytes.to_vec()),
            (Self::Time(time), TypeKind::TimeOfDay | TypeKind::TimeDifference) => {
                Some(time.to_bytes().to_vec())
            }
            _ => None,
        }
    }

    /// The value of `data_type` from the bytes of an SDO transfer; `None` if their length does not match.
    pub fn from_bytes(bytes: &[u8], data_type: DataType) -> Option<Value> {
        if data_type.byte_length().is_some_and(|length| usize::from(length) != bytes.len()) {
            return None;
        }
        let unsigned = || bytes.iter().rev().fold(0u64, |value, &byte| value << 8 | u64::from(byte));
        Some(match data_type.kind() {
            TypeKind::Boolean => Self::Boolean(match bytes {
                [0] => false,
                [1] => true,
                _ => return None,
            }),
            TypeKind::Unsigned(_) => Self::Unsigned(unsigned()),
            TypeKind::Signed(bits) => {
                let shift = 64 - u32::from(bits);
                Self::Signed((unsigned() << shift) as i64 >> shift)
            }
            TypeKind::Real32 => Self::Real32(f32::from_le_bytes(bytes.try_into().ok()?)),
            TypeKind::Real64 => Self::Real64(f64::from_le_bytes(bytes.try_into().ok()?)),
            TypeKind::VisibleString => Self::Text(std::str::from_utf8(bytes).ok()?.into()),
            TypeKind::UnicodeString => {
                let units: Vec<u16> = bytes
                    .chunks(2)
                    .map(|pair| pair.try_into().map(u16::from_le_bytes))
                    .collect::<Result<_, _>>()
                    .ok()?;
                Self::Text(String::from_utf16(&units).ok()?.into())
            }
            TypeKind::OctetString | TypeKind::Domain => Self::Bytes(bytes.into()),
            TypeKind::TimeOfDay | TypeKind::TimeDifference => {
                Self::Time(Time::from_bytes(bytes.try_into().ok()?))
            }
            TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved => return None,
        })
    }
}

/// Compares REAL bit by bit: a NaN equals itself, and 0.0 does not equal -0.0. So a value remains equal
/// when it is written and read back.
impl PartialEq for Value {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Boolean(a), Self::Boolean(b)) => a == b,
            (Self::Signed(a), Self::Signed(b)) => a == b,
            (Self::Unsigned(a), Self::Unsigned(b)) => a == b,
            (Self::Real32(a), Self::Real32(b)) => a.to_bits() == b.to_bits(),
            (Self::Real64(a), Self::Real64(b)) => a.to_bits() == b.to_bits(),
            (Self::Text(a), Self::Text(b)) | (Self::Raw(a), Self::Raw(b)) => a == b,
            (Self::Bytes(a), Self::Bytes(b)) => a == b,
            (Self::Time(a), Self::Time(b)) => a == b,
            (Self::NodeId(a), Self::NodeId(b)) => a == b,
            _ => false,
        }
    }
}

impl Eq for Value {}

/// For users and messages: numbers in decimal, bytes in hex, `$NODEID+0x180`.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Boolean(value) => write!(f, "{}", u8::from(*value)),
            Self::Signed(value) => write!(f, "{value}"),
            Self::Unsigned(value) => write!(f, "{value}"),
            Self::Real32(value) => write!(f, "{value:?}"),
            Self::Real64(value) => write!(f, "{value:?}"),
            Self::Text(text) | Self::Raw(text) => f.write_str(text),
            Self::Bytes(bytes) => bytes.iter().try_for_each(|byte| write!(f, "{byte:02X}")),
            Self::Time(time) => write!(f, "{} d {} ms", time.days, time.milliseconds),
            Self::NodeId(0) => f.write_str("$NODEID"),
            Self::NodeId(offset) => write!(f, "$NODEID+0x{offset:X}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn odd_integers_have_their_own_length() {
        let bytes = Value::Signed(-2).to_bytes(DataType::INTEGER24);
        assert_eq!(bytes.as_deref(), Some(&[0xFE, 0xFF, 0xFF][..]));
        assert_eq!(Value::from_bytes(&[0xFE, 0xFF, 0xFF], DataType::INTEGER24), Some(Value::Signed(-2)));
        assert_eq!(Value::from_bytes(&[1, 2], DataType::UNSIGNED24), None);
    }

    #[test]
    fn numbers_never_wrap() {
        assert_eq!(Value::from_integer(256, DataType::UNSIGNED8), None);
        assert_eq!(Value::from_integer(-1, DataType::UNSIGNED64), None);
        assert_eq!(Value::from_integer(-(1 << 63), DataType::INTEGER64), Some(Value::Signed(i64::MIN)));
        assert_eq!(Value::NodeId(0x90).resolve(DataType::UNSIGNED8, 127), None);
        assert_eq!(Value::NodeId(u64::MAX).resolve(DataType::UNSIGNED64, 1), None);
    }

    #[test]
    fn real_values_compare_by_bits() {
        assert_eq!(Value::Real32(f32::NAN), Value::Real32(f32::NAN));
        assert_ne!(Value::Real64(0.0), Value::Real64(-0.0));
    }
}

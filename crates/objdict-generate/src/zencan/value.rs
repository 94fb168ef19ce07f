//! Data types and defaults in the TOML syntax of zencan.

use super::answers::Held;
use crate::escape::toml_string;
use crate::model::{Access, DataType, TypeKind};
use crate::resolve::{Encoded, EntryPlan, ValueShape};

/// The representation of an entry in zencan.
pub(super) struct Kept {
    /// Such as `uint16`.
    pub(super) data_type: String,
    /// A TOML literal; `None` if the default of zencan (zeros or empty) applies.
    pub(super) default: Option<String>,
    pub(super) held: Held,
    /// Maximum size in bytes.
    pub(super) size: usize,
    /// The deviation from the description.
    pub(super) loss: Option<String>,
}

/// The bytes as a string.
pub(super) fn text_of(bytes: &[u8]) -> Option<String> {
    String::from_utf8(bytes.to_vec()).ok()
}

impl Kept {
    /// An entry with its value for the node `node_id`.
    pub(super) fn of(resolved: &EntryPlan, node_id: Option<u8>) -> Self {
        let writable = resolved.access.is_writable();
        match (resolved.shape, &resolved.default) {
            (ValueShape::Word(data_type), datum) => {
                let word = match (datum, node_id) {
                    (Encoded::Formula(offset), Some(node_id)) => offset.wrapping_add(node_id.into()),
                    (Encoded::Word(word) | Encoded::Formula(word), _) => *word,
                    (Encoded::Bytes(_), _) => 0, // bytes have other shapes
                };
                Self::word(data_type, resolved.shape.size(), word, writable)
            }
            (ValueShape::Bytes(data_type, room), Encoded::Bytes(bytes)) => match data_type.kind() {
                TypeKind::Domain => Self::domain(bytes.len()),
                TypeKind::VisibleString => Self::string(bytes, room.into()),
                _ => {
                    let is_unicode = data_type == DataType::UNICODE_STRING;
                    let mut kept = Self::octets(bytes, room.into(), resolved.access);
                    let becomes =
                        is_unicode.then(|| format!("UNICODE_STRING becomes `{}` in zencan", kept.data_type));
                    let fixed = writable.then(|| "an octet string has a fixed length in zencan".to_owned());
                    kept.loss = becomes.or(fixed);
                    kept
                }
            },
            (ValueShape::Block(length), Encoded::Bytes(bytes)) => {
                let mut kept = Self::octets(bytes, length.into(), Access::Const);
                kept.loss = Some(format!("a device-specific type becomes `{}` in zencan", kept.data_type));
                kept
            }
            (shape, _) => Self::octets(&[], shape.size(), resolved.access), // only words have numbers
        }
    }

    fn word(data_type: DataType, size: usize, word: u64, writable: bool) -> Self {
        let bytes: Vec<u8> = word.to_le_bytes().into_iter().take(size).collect();
        let signed = word as i64; // same bits; zencan casts them back
        let kind = data_type.kind();
        let (name, default) = match kind {
            TypeKind::Boolean => ("uint8".to_owned(), Some(word.to_string())),
            TypeKind::Signed(bits @ (8 | 16 | 24 | 32 | 64)) => {
                (format!("int{bits}"), Some(signed.to_string()))
            }
            TypeKind::Unsigned(bits @ (8 | 16 | 24 | 32 | 64)) => {
                (format!("uint{bits}"), Some(signed.to_string()))
            }
            TypeKind::Real32 => ("real32".to_owned(), real32(f32::from_bits(word as u32))),
            TypeKind::Real64 => ("real64".to_owned(), real64(f64::from_bits(word))),
            TypeKind::TimeOfDay => ("timeofday".to_owned(), None),
            TypeKind::TimeDifference => ("timedifference".to_owned(), None),
            _ => {
                let mut kept = Self::octets(&bytes, size, Access::Const);
                let fewer = if writable { ", of which an SDO may write fewer bytes" } else { "" };
                kept.loss = Some(format!("{data_type} becomes `{}` in zencan{fewer}", kept.data_type));
                return kept;
            }
        };
        let loss = (kind == TypeKind::Boolean).then(|| {
            "BOOLEAN becomes `uint8` because zencan 0.0.5 aborts the upload of its own `boolean`".to_owned()
        });
        let held = if default.is_some() { bytes } else { vec![0; size] };
        Self { data_type: name, default, held: Held::Bytes(held), size, loss }
    }

    fn domain(length: usize) -> Self {
        let default = if length > 0 { format!(", its default of {length} bytes too") } else { String::new() };
        Self {
            data_type: "domain".to_owned(),
            default: None,
            held: Held::Served,
            size: 0,
            loss: Some(format!("the application serves the DOMAIN{default}")),
        }
    }

    /// A string that ends at its first zero byte.
    fn string(bytes: &[u8], room: usize) -> Self {
        let text = text_of(bytes).filter(|text| !text.contains('\0')).unwrap_or_default();
        Self {
            data_type: format!("visiblestring({room})"),
            default: (!text.is_empty()).then(|| toml_string(&text)),
            held: Held::Bytes(text.into_bytes()),
            size: room,
            loss: None,
        }
    }

    /// Bytes of fixed length: as long as the default, if there is one.
    fn octets(bytes: &[u8], room: usize, access: Access) -> Self {
        let size = if bytes.is_empty() && access != Access::Const { room } else { bytes.len() };
        let text = text_of(bytes).unwrap_or_default();
        let mut held = text.clone().into_bytes();
        held.resize(size, 0);
        let is_zero = text.bytes().all(|byte| byte == 0);
        Self {
            data_type: format!("octetstring({size})"),
            default: (!is_zero).then(|| toml_string(&text)),
            held: Held::Bytes(held),
            size,
            loss: None,
        }
    }
}

/// zencan parses 64-bit numbers and rounds them: the shortest digits that result in the same number.
fn real32(number: f32) -> Option<String> {
    let short = format!("{number:?}");
    let comes_back = short.parse::<f64>().is_ok_and(|wide| (wide as f32).to_bits() == number.to_bits());
    if comes_back { number.is_finite().then_some(short) } else { real64(number.into()) }
}

/// zencan-build does not support infinity and NaN.
fn real64(number: f64) -> Option<String> {
    number.is_finite().then(|| format!("{number:?}"))
}

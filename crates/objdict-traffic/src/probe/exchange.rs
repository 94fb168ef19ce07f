//! What a client asked of a device, and what came back.

use objdict_model::literal::{self, Quirks};

use objdict_bus::Abort;
use objdict_model::model::{DataType, TypeKind};

/// An SDO transfer, from its request to its answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exchange {
    /// The reset of the node since the exchange before; of several the one that resets most.
    pub reset: Option<NodeReset>,
    /// The index.
    pub index: u16,
    /// The sub-index.
    pub sub: u8,
    /// What was asked.
    pub request: SdoRequest,
    /// What came back.
    pub answer: SdoAnswer,
}

/// After what a node has other values (CiA 301 §7.3.2.2.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum NodeReset {
    /// Of the communication objects, 1000h to 1FFFh: NMT command 82h.
    Communication,
    /// Of all objects: NMT command 81h, or power.
    All,
}

impl NodeReset {
    /// Whether the object has the value after it that it is switched on with.
    pub(super) fn concerns(self, index: u16) -> bool {
        self == Self::All || (0x1000..0x2000).contains(&index)
    }
}

/// What a client asks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SdoRequest {
    /// To read the entry.
    Upload,
    /// To write these bytes.
    Download(Vec<u8>),
}

/// What a server answers.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SdoAnswer {
    /// The value, as it was transferred.
    Bytes(Vec<u8>),
    /// Four bytes, of which the server does not say how many are the value.
    Unsized([u8; 4]),
    /// The value as a text: a number or a string, as a bench dumps it.
    Text(String),
    /// There is a value; only its length is known, if that.
    Length(Option<usize>),
    /// It is written.
    Done,
    /// It is refused.
    Abort(Abort),
    /// Nothing came.
    Silence,
}

impl SdoAnswer {
    /// The bytes of the value, as one of this type; `None` if they are not known, or for a text that is not a value of the type.
    pub fn bytes(&self, data_type: Option<DataType>) -> Option<Vec<u8>> {
        match self {
            Self::Bytes(bytes) => Some(bytes.clone()),
            Self::Unsized(bytes) => {
                let length = data_type.and_then(DataType::byte_length).map_or(4, usize::from);
                bytes.get(..length).map(<[u8]>::to_vec)
            }
            Self::Text(text) => of_text(text, data_type),
            _ => None,
        }
    }

    /// Whether the entry has a value.
    pub const fn is_value(&self) -> bool {
        matches!(self, Self::Bytes(_) | Self::Unsized(_) | Self::Text(_) | Self::Length(_))
    }
}

fn of_text(text: &str, data_type: Option<DataType>) -> Option<Vec<u8>> {
    let Some(data_type) = data_type else { return guessed(text) };
    if data_type.kind() == TypeKind::VisibleString {
        return Some(text.as_bytes().to_vec());
    }
    literal::value(text, Some(data_type), &mut Quirks::default()).ok()?.to_bytes(data_type)
}

/// A value without a type: the shortest unsigned integer for a number, else the text.
fn guessed(text: &str) -> Option<Vec<u8>> {
    let Ok(number) = literal::integer(text, 0, u64::MAX, &mut Quirks::default()) else {
        return Some(text.as_bytes().to_vec());
    };
    let number = u64::try_from(number).ok()?;
    let length = match number {
        0..=0xFF => 1,
        0x100..=0xFFFF => 2,
        0x1_0000..=0xFFFF_FFFF => 4,
        _ => 8,
    };
    Some(number.to_le_bytes()[..length].to_vec())
}

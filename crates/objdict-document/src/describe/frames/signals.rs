//! The values in a PDO.

use std::borrow::Cow;
use std::cell::OnceCell;

use super::talker::TalkingNode;
use crate::dbc::Scaled;
use crate::layout::{FieldKind, FrameLayout};
use crate::model::{DataType, Pdo, Value};

/// A value in a PDO.
#[derive(Clone, Debug, PartialEq)]
pub struct PdoSignal<'r> {
    /// The node of the entry.
    pub node_id: u8,
    /// The index of the object.
    pub index: u16,
    /// The sub-index of the entry.
    pub sub: u8,
    /// The name of the entry; empty if no description has it.
    pub name: Cow<'r, str>,
    /// The length in bits.
    pub bits: u32,
    /// The number in its bits; `None` if the frame is too short.
    pub raw: Option<u64>,
    /// The value in its type; `None` if the type is unknown or the frame is too short.
    pub value: Option<Value>,
    /// The number in its unit, if different.
    pub scaled: Option<String>,
    /// The unit; empty if there is none.
    pub unit: Cow<'r, str>,
    /// The value as text.
    pub text: String,
}

/// The representation of a value in a plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SignalReading {
    /// The number in its unit; `None` for a string.
    pub number: Option<f64>,
    /// The name of the value, if it is a state, a mode, a command or similar.
    pub word: Option<String>,
    /// The unit; empty if there is none.
    pub unit: String,
}

/// The position of a value in the frames of a PDO, and its properties.
#[derive(Debug)]
pub(super) struct SignalPlace {
    index: u16,
    sub: u8,
    name: String,
    start: u32,
    end: u32,
    data_type: Option<DataType>,
    /// Its scale and unit, once one of its values becomes text.
    scaled: OnceCell<Option<Scaled>>,
}

/// The content of a PDO.
#[derive(Debug, Default)]
pub(super) struct PdoContent {
    pub(super) places: Vec<SignalPlace>,
    /// Whether its frames name the object that they carry.
    pub(super) is_multiplexed: bool,
    /// The length of its frames in bytes; `None` if the description does not state it.
    pub(super) bytes: Option<usize>,
}

/// The first byte of a multiplexed PDO, which defines the meaning of its node-ID (CiA 301 §7.2.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Multiplexer {
    /// The value is for this node, or for all (0): destination address mode.
    To(u8),
    /// The value is of this node: source address mode.
    Of(u8),
}

impl Multiplexer {
    pub(super) const fn node_id(self) -> u8 {
        let (Self::To(node_id) | Self::Of(node_id)) = self;
        node_id
    }
}

/// The content of a multiplexed PDO: the addressed entry, and its bytes; `None` if it is too short.
pub(super) fn multiplexed(data: &[u8]) -> Option<(Multiplexer, (u16, u8), [u8; 4])> {
    let &[address, low, high, sub, a, b, c, d] = data else { return None };
    let node_id = address & 0x7F;
    let node = if address & 0x80 == 0 { Multiplexer::Of(node_id) } else { Multiplexer::To(node_id) };
    Some((node, (u16::from_le_bytes([low, high]), sub), [a, b, c, d]))
}

fn mapped_bytes(pdo: &Pdo<'_>) -> Option<usize> {
    if pdo.is_multiplexed() {
        return Some(8);
    }
    let bits = pdo.used_slots().map(|slot| Some(u32::from(slot.object?.bits))).sum::<Option<u32>>()?;
    let is_whole = pdo.mapped_count.map(usize::from) == Some(pdo.used_slots().count());
    (is_whole && (1..=64).contains(&bits)).then(|| bits.div_ceil(8) as usize)
}

impl PdoContent {
    pub(super) fn new(node: &TalkingNode<'_>, pdo: &Pdo<'_>) -> Self {
        let layout = FrameLayout::new(&node.device, pdo, &|entry| entry.name.to_string());
        let fields = layout.shown().filter(|(field, _)| field.kind != FieldKind::Dummy);
        let places = fields.map(|(field, span)| {
            let (index, sub) = field.object.map_or((0, 0), |object| (object.index, object.sub));
            SignalPlace {
                index,
                sub,
                name: field.name.clone(),
                start: span.start,
                end: span.end,
                data_type: field.data_type,
                scaled: OnceCell::new(),
            }
        });
        Self { places: places.collect(), is_multiplexed: pdo.is_multiplexed(), bytes: mapped_bytes(pdo) }
    }

    /// The values in a frame.
    pub(super) fn signals<'r>(
        &'r self,
        node: &'r TalkingNode<'_>,
        data: &'r [u8],
    ) -> impl Iterator<Item = PdoSignal<'r>> {
        let parts = self.parts(data);
        parts.map(move |(place, frame)| place.signal(node, frame))
    }

    /// The content as entries and their values; without a type the bits are a number. Values beyond the end
    /// of the frame are omitted.
    pub(super) fn values(&self, data: &[u8]) -> impl Iterator<Item = ((u16, u8), Value)> {
        self.parts(data).filter_map(|(place, frame)| Some((place.entry(), place.number(frame?))))
    }

    /// The positions, each with the frame if it is long enough.
    fn parts(&self, data: &[u8]) -> impl Iterator<Item = (&SignalPlace, Option<u64>)> + use<'_> {
        let frame = data.iter().take(8).rev().fold(0, |frame, &byte| frame << 8 | u64::from(byte));
        let length = 8 * data.len() as u32;
        self.places.iter().map(move |place| (place, Some(frame).filter(|_| place.end <= length)))
    }
}

impl SignalPlace {
    /// The value in a multiplexed PDO for an entry of `node`; without a type it has all four bytes.
    pub(super) fn multiplexed(node: &TalkingNode<'_>, (index, sub): (u16, u8)) -> Self {
        let data_type = node.data_type((index, sub));
        let bits =
            data_type.and_then(DataType::bit_length).map(u32::from).filter(|bits| (1..=32).contains(bits));
        Self {
            index,
            sub,
            name: node.entry_name((index, sub)).into_owned(),
            start: 0,
            end: bits.unwrap_or(32),
            data_type: data_type.filter(|_| bits.is_some()),
            scaled: OnceCell::new(),
        }
    }

    pub(super) const fn entry(&self) -> (u16, u8) {
        (self.index, self.sub)
    }

    /// The bits in a frame.
    const fn raw(&self, frame: u64) -> u64 {
        frame >> self.start & u64::MAX >> (64 - (self.end - self.start))
    }

    /// The value of these bits in the type; `None` if the type is unknown.
    fn typed(&self, raw: u64) -> Option<Value> {
        of_bits(raw, self.end - self.start, self.data_type?)
    }

    /// The value in a frame, as a number if the type is unknown.
    pub(super) fn number(&self, frame: u64) -> Value {
        let raw = self.raw(frame);
        self.typed(raw).unwrap_or(Value::Unsigned(raw))
    }

    pub(super) fn signal<'r>(&'r self, node: &TalkingNode<'_>, frame: Option<u64>) -> PdoSignal<'r> {
        let in_unit = self.scaled.get_or_init(|| node.scaling(&node.meanings(), self.entry())).as_ref();
        let bits = self.end - self.start;
        let raw = frame.map(|frame| self.raw(frame));
        let value = raw.and_then(|raw| self.typed(raw));
        let scaled = in_unit.zip(value.as_ref()).and_then(|(scaled, value)| scaled.number(value));
        let text = match (&value, raw) {
            (Some(value), _) => node.words_in(self.entry(), value, self.data_type, || in_unit.cloned()),
            (None, Some(raw)) => format!("{raw:X}h"),
            (None, None) => String::new(),
        };
        PdoSignal {
            node_id: node.node_id,
            index: self.index,
            sub: self.sub,
            name: Cow::Borrowed(&self.name),
            bits,
            raw,
            value,
            scaled,
            unit: Cow::Borrowed(in_unit.map_or("", |scaled| &scaled.unit)),
            text,
        }
    }
}

impl PdoSignal<'_> {
    /// The same signal without its borrowed source.
    pub(super) fn into_owned(self) -> PdoSignal<'static> {
        let (name, unit) = (self.name.into_owned().into(), self.unit.into_owned().into());
        PdoSignal { name, unit, ..self }
    }
}

/// A value in the bits of a PDO; signed ones may be cut.
fn of_bits(bits: u64, count: u32, data_type: DataType) -> Option<Value> {
    let Some((low, _)) = data_type.integer_range() else {
        let length = usize::from(data_type.byte_length()?);
        return Value::from_bytes(bits.to_le_bytes().get(..length)?, data_type);
    };
    let shift = 64 - count;
    let number = if low < 0 { i128::from((bits << shift) as i64 >> shift) } else { bits.into() };
    Value::from_integer(number, data_type)
}

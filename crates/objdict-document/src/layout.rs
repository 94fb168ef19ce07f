//! The assignment of frame bits to the mapped objects of a PDO.
//!
//! Bit n is bit n modulo 8 of byte n / 8.

use super::anchor::Anchor;
use crate::model::{DataType, Device, Entry, MappedObject, Pdo};

pub(crate) const FRAME_BITS: u32 = Pdo::FRAME_BITS;

/// The layout of a PDO frame.
pub(crate) struct FrameLayout {
    pub(crate) content: FrameContent,
    /// In frame order.
    pub(crate) fields: Vec<LayoutField>,
}

/// The content according to the number of mapped objects.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FrameContent {
    /// This number of mapped objects.
    Objects,
    /// Empty: the number is 0.
    Nothing,
    /// A multiplexed PDO that contains the source multiplexer (FEh: SAM-MPDO).
    SourceMultiplexed,
    /// A multiplexed PDO that contains the destination multiplexer (FFh: DAM-MPDO).
    DestinationMultiplexed,
    /// A reserved number.
    Reserved(u8),
    /// The number is not stated. The fields are the mapped objects that are described.
    Unstated,
}

/// A mapped object in the frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct LayoutField {
    /// The sub-index of the mapping parameter.
    pub(crate) slot: u8,
    /// Its lowest bit; `None` after an unknown mapped object.
    pub(crate) first: Option<u32>,
    /// Length in bits, even if it exceeds the frame.
    pub(crate) bits: u32,
    pub(crate) kind: FieldKind,
    /// `None` if the description does not state a mapped object.
    pub(crate) object: Option<MappedObject>,
    /// The name of the entry; empty if it does not exist.
    pub(crate) name: String,
    /// The data type of the entry, or of the dummy entry.
    pub(crate) data_type: Option<DataType>,
}

/// The kind of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FieldKind {
    /// An entry of the dictionary.
    Object,
    /// A dummy entry.
    Dummy,
    /// An entry missing in the description.
    Missing,
    /// A mapping entry without an object.
    Gap,
}

impl FrameLayout {
    /// Computes the layout of a PDO; `name` supplies the names of entries.
    pub(crate) fn new(device: &Device, pdo: &Pdo<'_>, name: &dyn Fn(&Entry) -> String) -> Self {
        let (content, count) = match pdo.mapped_count {
            None => (FrameContent::Unstated, stated_objects(pdo)),
            Some(0) => (FrameContent::Nothing, 0),
            Some(count @ 1..=64) => (FrameContent::Objects, count),
            Some(0xFE) => (FrameContent::SourceMultiplexed, 0),
            Some(0xFF) => (FrameContent::DestinationMultiplexed, 0),
            Some(count) => (FrameContent::Reserved(count), 0),
        };
        let objects = (1..=count).map(|slot| pdo.slots.iter().find(|found| found.sub == slot)?.object);
        let placed = MappedObject::placed(objects, |object| object.map_or(0, |object| object.bits));
        // the position after an unknown object is unknown
        let mut is_known = true;
        let fields = (1..).zip(placed).map(|(slot, (first, object))| {
            let first = is_known.then_some(first);
            is_known &= object.is_some();
            LayoutField { first, ..field(device, slot, object, name) }
        });
        Self { content, fields: fields.collect() }
    }

    /// The number of mapped bits, even if it exceeds a frame; `None` if unknown.
    pub(crate) fn bits(&self) -> Option<u32> {
        let is_known = self.fields.iter().all(|field| field.object.is_some());
        is_known.then(|| self.fields.iter().map(|field| field.bits).sum())
    }

    /// The fields with bits in the frame.
    pub(crate) fn shown(&self) -> impl Iterator<Item = (&LayoutField, BitSpan)> {
        self.fields.iter().filter_map(|field| Some((field, field.span()?)))
    }

    /// The number of bytes in the frame; the maximum if the length is unknown.
    pub(crate) fn bytes(&self) -> u32 {
        self.bits().map_or(FRAME_BITS, |bits| bits.min(FRAME_BITS)).div_ceil(8)
    }

    /// The unused bits of the frame.
    pub(crate) fn rest(&self) -> Option<BitSpan> {
        let used = self.shown().map(|(_, span)| span.end).max().unwrap_or(0);
        let end = 8 * self.bytes();
        (used < end).then_some(BitSpan { start: used, end })
    }
}

/// The number of consecutive mapped objects from sub-index 1 on, used if sub-index 0 is not stated.
fn stated_objects(pdo: &Pdo<'_>) -> u8 {
    let objects = (1..=64)
        .zip(&pdo.slots)
        .take_while(|(sub, slot)| slot.sub == *sub && slot.object.is_some_and(|object| !object.is_unused()));
    objects.map(|(sub, _)| sub).last().unwrap_or(0)
}

fn field(
    device: &Device,
    slot: u8,
    object: Option<MappedObject>,
    name: &dyn Fn(&Entry) -> String,
) -> LayoutField {
    let mut field = LayoutField {
        slot,
        first: None,
        bits: object.map_or(0, |object| object.bits.into()),
        kind: FieldKind::Gap,
        object,
        name: String::new(),
        data_type: None,
    };
    let Some(object) = object.filter(|object| !object.is_unused()) else { return field };
    if object.is_dummy() {
        field.kind = FieldKind::Dummy;
        field.data_type = Some(DataType(object.index));
        return field;
    }
    match device.entry(object.index, object.sub) {
        Some(entry) => {
            field.kind = FieldKind::Object;
            field.name = name(&entry);
            field.data_type = entry.data_type;
        }
        None => field.kind = FieldKind::Missing,
    }
    field
}

impl LayoutField {
    /// Its bits in the frame; `None` if it is outside of it.
    pub(crate) fn span(&self) -> Option<BitSpan> {
        let start = self.first?;
        let end = (start + self.bits).min(FRAME_BITS);
        (start < end).then_some(BitSpan { start, end })
    }

    /// Whether it exceeds the frame.
    pub(crate) fn is_cut(&self) -> bool {
        self.first.is_some_and(|first| first + self.bits > FRAME_BITS)
    }

    /// The mapped entry, if the description has it.
    pub(crate) fn anchor(&self) -> Option<Anchor> {
        let object = self.object.filter(|_| self.kind == FieldKind::Object)?;
        Some(Anchor::entry(object.index, object.sub))
    }
}

/// A range of frame bits; the end is exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BitSpan {
    pub(crate) start: u32,
    pub(crate) end: u32,
}

impl BitSpan {
    /// Its parts per byte: byte, lowest bit, and bit after the highest.
    pub(crate) fn rows(self) -> impl Iterator<Item = (u32, u32, u32)> {
        (self.start / 8..self.end.div_ceil(8)).map(move |byte| {
            let first = byte * 8;
            (byte, self.start.max(first) - first, self.end.min(first + 8) - first)
        })
    }
}

/// `0.4–1.7`: from bit 4 of byte 0 to bit 7 of byte 1.
impl std::fmt::Display for BitSpan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let last = self.end.saturating_sub(1);
        write!(f, "{}.{}", self.start / 8, self.start % 8)?;
        if last > self.start {
            write!(f, "–{}.{}", last / 8, last % 8)?;
        }
        Ok(())
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::model::{Object, ObjectType, PdoKind, Value};

    /// An object with entries of these values.
    pub(crate) fn record(values: &[(u8, Option<u64>)]) -> Object {
        let entry = |value: Option<u64>| Entry { default: value.map(Value::Unsigned), ..Entry::default() };
        let main = Entry { object_type: Some(ObjectType::Record), ..Entry::default() };
        let subs = values.iter().map(|&(sub, value)| (sub, entry(value))).collect();
        Object { main, subs, ..Object::default() }
    }

    /// A device with entries 6000h:00 to 6000h:3Fh and TPDO 1 with this number of mapped objects and these
    /// objects.
    pub(crate) fn device(count: Option<u64>, mapped: &[Option<u64>]) -> Device {
        let mut device = Device::default();
        let mut values = vec![(0, count)];
        values.extend((1..).zip(mapped.iter().copied()));
        device.objects.insert(0x1A00, record(&values));
        let mut inputs = record(&(0..64).map(|sub| (sub, None)).collect::<Vec<_>>());
        for (sub, entry) in inputs.subs.iter_mut() {
            entry.name = format!("Input {sub}").into();
            entry.data_type = Some(DataType::UNSIGNED8);
        }
        device.objects.insert(0x6000, inputs);
        device
    }

    fn layout(count: Option<u64>, mapped: &[u64]) -> FrameLayout {
        let mapped: Vec<Option<u64>> = mapped.iter().copied().map(Some).collect();
        layout_of(&device(count, &mapped))
    }

    fn layout_of(device: &Device) -> FrameLayout {
        let pdo = device.pdo(PdoKind::Tpdo, 1).unwrap();
        FrameLayout::new(device, &pdo, &|entry| entry.name.to_string())
    }

    fn spans(layout: &FrameLayout) -> Vec<String> {
        layout.shown().map(|(_, span)| span.to_string()).collect()
    }

    #[test]
    fn objects_follow_each_other_bit_by_bit() {
        let layout = layout(Some(4), &[0x6000_0101, 0x0005_0003, 0x6000_020C, 0x6000_0310]);
        assert_eq!(spans(&layout), ["0.0", "0.1–0.3", "0.4–1.7", "2.0–3.7"]);
        let kinds: Vec<FieldKind> = layout.fields.iter().map(|field| field.kind).collect();
        assert_eq!(kinds, [FieldKind::Object, FieldKind::Dummy, FieldKind::Object, FieldKind::Object]);
        assert_eq!((layout.bits(), layout.rest()), (Some(32), None));
        let rows: Vec<_> = BitSpan { start: 4, end: 18 }.rows().collect();
        assert_eq!(rows, [(0, 4, 8), (1, 0, 8), (2, 0, 2)]);
        assert_eq!(layout.fields[2].anchor().map(|anchor| anchor.to_string()).as_deref(), Some("6000sub2"));
        let short = super::tests::layout(Some(1), &[0x6000_010C]);
        assert_eq!((short.bytes(), short.rest()), (2, Some(BitSpan { start: 12, end: 16 })));
    }

    #[test]
    fn sixty_four_bits_and_eight_bytes() {
        let bits: Vec<u64> = (0..64).map(|sub| 0x6000_0001 | sub << 8).collect();
        let layout = layout(Some(64), &bits);
        assert_eq!((layout.shown().count(), layout.bits(), layout.rest()), (64, Some(64), None));
        assert_eq!(spans(&layout)[63], "7.7");
        assert_eq!(spans(&super::tests::layout(Some(1), &[0x6000_0140])), ["0.0–7.7"]);
    }

    #[test]
    fn what_does_not_fit_is_cut() {
        let layout = layout(Some(3), &[0x6000_0130, 0x6000_0220, 0x6000_0308]);
        assert_eq!(spans(&layout), ["0.0–5.7", "6.0–7.7"]);
        let cut: Vec<bool> = layout.fields.iter().map(LayoutField::is_cut).collect();
        assert_eq!((cut.as_slice(), layout.bits()), (&[false, true, true][..], Some(88)));
    }

    #[test]
    fn numbers_that_are_no_count() {
        let content = |count| layout(count, &[0x6000_0108, 0x6000_0208, 0]).content;
        assert_eq!(content(Some(0)), FrameContent::Nothing);
        assert_eq!(content(Some(0xFE)), FrameContent::SourceMultiplexed);
        assert_eq!(content(Some(0xFF)), FrameContent::DestinationMultiplexed);
        assert_eq!(content(Some(65)), FrameContent::Reserved(65));
        let layout = layout(None, &[0x6000_0108, 0x6000_0208, 0]);
        assert_eq!((layout.content, layout.bits()), (FrameContent::Unstated, Some(16)));
    }

    #[test]
    fn behind_an_unknown_object_nothing_has_a_place() {
        let mapped = [Some(0x6000_0108), None, Some(0x6000_0208)];
        let layout = layout_of(&device(Some(5), &mapped));
        assert_eq!(spans(&layout), ["0.0–0.7"]);
        let places: Vec<_> = layout.fields.iter().map(|field| (field.first, field.kind)).collect();
        assert_eq!(
            places,
            [
                (Some(0), FieldKind::Object),
                (Some(8), FieldKind::Gap),
                (None, FieldKind::Object),
                (None, FieldKind::Gap),
                (None, FieldKind::Gap)
            ]
        );
        assert_eq!(layout.bits(), None);
    }

    #[test]
    fn entries_that_nobody_describes() {
        let layout = layout(Some(3), &[0x7000_0108, 0, 0x6000_4010]);
        let kinds: Vec<_> = layout.fields.iter().map(|field| (field.kind, field.span())).collect();
        let span = |start, end| Some(BitSpan { start, end });
        assert_eq!(
            kinds,
            [(FieldKind::Missing, span(0, 8)), (FieldKind::Gap, None), (FieldKind::Missing, span(8, 24))]
        );
    }
}

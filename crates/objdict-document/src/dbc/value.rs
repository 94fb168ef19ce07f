//! Signals of an entry: the number in its bits, and the meaning of the number.

use super::decimal::Decimal;
use super::signal::{DbcSignal, NumberFormat, Scale};
use super::{LANGUAGE, Station};
use crate::model::{DataType, Device, Entry, Meaning, Meanings, ObjectType, Scaling, TypeKind, Value};
use crate::profile::{self, EntryFacts, ObjectFacts};

/// The largest range of values that get their common name each.
const LARGEST_RANGE: u64 = 16;

/// An entry of a node.
pub(super) struct DbcEntry<'a> {
    pub(super) station: &'a Station<'a>,
    pub(super) index: u16,
    pub(super) sub: u8,
    /// `None` if it is missing in the description.
    pub(super) entry: Option<&'a Entry>,
}

/// A part of a value with a name.
struct ValuePart<'a> {
    first: u32,
    bits: u32,
    name: &'a str,
    is_signed: bool,
    values: Vec<(i128, &'a str)>,
    scaling: Scaling<'a>,
}

impl<'a> DbcEntry<'a> {
    /// The signals of a value of this many bits, which begins at bit 0: one, or with `split` one for each named bit field.
    ///
    /// # Errors
    /// The reason why a signal cannot represent it.
    pub(super) fn signals(&self, bits: u32, split: bool) -> Result<Vec<DbcSignal>, &'static str> {
        let Some(entry) = self.entry else {
            let words = format!("x{:04X}_{:02X}", self.index, self.sub);
            let comment = format!("{}, not in the description", self.place());
            return Ok(vec![DbcSignal { comment, ..DbcSignal::new(words, 0, bits) }]);
        };
        if bits == 0 {
            return Err("no bits are mapped");
        }
        let kind = entry.data_type.map(DataType::kind);
        let (number, size) = match kind {
            None if entry.object_type == Some(ObjectType::Domain) => return Err(NO_NUMBER),
            Some(TypeKind::VisibleString | TypeKind::UnicodeString) => return Err(NO_NUMBER),
            Some(TypeKind::OctetString | TypeKind::Domain) => return Err(NO_NUMBER),
            Some(TypeKind::TimeOfDay | TypeKind::TimeDifference) => return self.time(entry, bits),
            Some(TypeKind::Real32 | TypeKind::Real64) if kind_bits(kind) > bits => {
                return Err("a part of a REAL is not a number");
            }
            Some(TypeKind::Real32) => (NumberFormat::Real32, 32),
            Some(TypeKind::Real64) => (NumberFormat::Real64, 64),
            Some(TypeKind::Boolean) => (NumberFormat::Unsigned, 1),
            Some(TypeKind::Unsigned(size)) => (NumberFormat::Unsigned, size.into()),
            Some(TypeKind::Signed(size)) => (NumberFormat::Signed, size.into()),
            None | Some(TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved) => {
                (NumberFormat::Unsigned, 64)
            }
        };
        let signal = DbcSignal { number, ..self.named(entry, "", 0, bits.min(size)) };
        Ok(self.described(entry, signal, split))
    }

    /// A signal with the name of the entry.
    fn named(&self, entry: &Entry, part: &str, first: u32, bits: u32) -> DbcSignal {
        let words = self.station.signal_words(self.index, self.sub, entry);
        let words = if part.is_empty() { words } else { format!("{words}_{part}") };
        let suffix = format!("{:04X}_{:02X}", self.index, self.sub);
        DbcSignal { suffix, comment: self.comment(entry), ..DbcSignal::new(words, first, bits) }
    }

    /// `6041h:00`.
    fn place(&self) -> String {
        format!("{:04X}h:{:02X}", self.index, self.sub)
    }

    fn comment(&self, entry: &Entry) -> String {
        let name = self.station.name_of(entry);
        let parameter = entry.parameter.as_deref();
        let text = parameter.and_then(|parameter| parameter.labels.description_in(LANGUAGE));
        let mut comment = self.place();
        if !name.is_empty() {
            comment.push_str(&format!(" {name}"));
        }
        if let Some(text) = text.map(str::trim).filter(|text| !text.is_empty()) {
            comment.push_str(&format!(": {text}"));
        }
        comment
    }

    /// Milliseconds and days.
    fn time(&self, entry: &Entry, bits: u32) -> Result<Vec<DbcSignal>, &'static str> {
        if bits < 48 {
            return Err("a part of a time is not a number");
        }
        let milliseconds = self.named(entry, "ms", 0, 28).in_unit("ms");
        Ok(vec![milliseconds, self.named(entry, "days", 32, 16).in_unit("d")])
    }

    /// The signal with scale, unit, limits and names, or the signals of its parts.
    fn described(&self, entry: &'a Entry, mut signal: DbcSignal, split: bool) -> Vec<DbcSignal> {
        let documents: Vec<_> =
            profile::of_object(self.station.device, self.index).map(|(_, facts)| facts).collect();
        let (scale, unit) = self.scale(entry, &documents);
        let parts = self.parts(&documents);
        (signal.scale, signal.unit) = (scale, unit);
        signal.limits = self.limits(entry, &signal, &documents, parts.is_empty());
        match parts.as_slice() {
            [] => vec![signal],
            [whole] if whole.first == 0 && whole.bits >= signal.bits => {
                let bits = signal.bits;
                let is_signed = signal.number == NumberFormat::Signed;
                // documents name the bits of negative numbers
                let negative = |number: i128| is_signed && number >> (bits - 1) == 1;
                let own = |number| if negative(number) { number - (1 << bits) } else { number };
                let values = whole.values.iter().map(|&(number, name)| (own(number), name));
                vec![signal.with_values(values)]
            }
            parts if split => self.split(entry, &signal, parts),
            parts => {
                let mut names: Vec<_> = parts.iter().filter(|part| !part.name.is_empty()).collect();
                names.sort_by_key(|part| part.first);
                let names: Vec<_> = names.iter().map(|part| part.in_words()).collect();
                signal.comment.push_str(&format!("; bits: {}", names.join(", ")));
                vec![signal]
            }
        }
    }

    /// A signal for each part; of overlapping parts, the one with fewer bits.
    fn split(&self, entry: &Entry, word: &DbcSignal, parts: &[ValuePart<'_>]) -> Vec<DbcSignal> {
        let mut parts: Vec<_> = parts.iter().filter(|part| part.first + part.bits <= word.bits).collect();
        parts.sort_by_key(|part| (part.bits, part.first));
        let mut signals: Vec<DbcSignal> = Vec::new();
        for part in parts {
            let end = part.first + part.bits;
            if signals.iter().all(|other| other.end() <= part.first || end <= other.first) {
                let name = super::identifier::words(part.name);
                let mut signal = self.named(entry, &name, part.first, part.bits);
                signal.number = if part.is_signed { NumberFormat::Signed } else { NumberFormat::Unsigned };
                signal.suffix = part.first.to_string();
                (signal.scale, signal.unit) = of_description(part.scaling);
                signal.comment.push_str(&format!("; bits: {}", part.in_words()));
                signals.push(signal.with_values(part.values.iter().copied()));
            }
        }
        signals.sort_by_key(|signal| signal.first);
        signals
    }

    /// Named parts of the value, from the description, otherwise from documents. An enumeration is one part.
    fn parts(&self, documents: &[ObjectFacts<'static>]) -> Vec<ValuePart<'a>> {
        match self.station.meanings.of(self.index, self.sub) {
            Some(Meaning::Enumeration(found)) => {
                let values = found.values.iter().map(|value| (value.number, value.name)).collect();
                vec![ValuePart {
                    first: 0,
                    bits: 64,
                    name: "",
                    is_signed: false,
                    values,
                    scaling: Scaling::default(),
                }]
            }
            Some(Meaning::BitStruct(word)) => word.fields.iter().map(ValuePart::of_description).collect(),
            None => profile::bits(documents.iter().copied(), self.sub)
                .iter()
                .map(ValuePart::of_document)
                .collect(),
        }
    }

    /// The scale of the value, and its unit.
    fn scale(&self, entry: &'a Entry, documents: &[ObjectFacts<'_>]) -> (Scale, String) {
        scale(&self.station.meanings, entry, self.sub, documents)
    }

    /// The limits of the description, otherwise the values that a document allows.
    fn limits(
        &self,
        entry: &Entry,
        signal: &DbcSignal,
        documents: &[ObjectFacts<'_>],
        may_ask: bool,
    ) -> Option<[Decimal; 2]> {
        let (low, high) = match signal.number {
            NumberFormat::Real32 | NumberFormat::Real64 => {
                let real =
                    |value: &Option<Value>| Decimal::parse(&format!("{:e}", value.as_ref()?.as_real()?));
                (real(&entry.low_limit)?, real(&entry.high_limit)?)
            }
            NumberFormat::Unsigned | NumberFormat::Signed => {
                let (first, last) = signal.range();
                let limit = |value: &Option<Value>| value.as_ref()?.integer_for(self.station.node_id);
                let (low, high) = match (limit(&entry.low_limit), limit(&entry.high_limit)) {
                    (None, None) if may_ask => self.allowed(documents)?,
                    (None, None) => return None,
                    (low, high) => (low.unwrap_or(first), high.unwrap_or(last)),
                };
                if low > high {
                    return None;
                }
                (Decimal::integer(low.max(first)), Decimal::integer(high.min(last)))
            }
        };
        let (low, high) = (signal.scale.apply(low)?, signal.scale.apply(high)?);
        Some(if signal.scale.factor.is_negative() { [high, low] } else { [low, high] })
    }

    fn allowed(&self, documents: &[ObjectFacts<'_>]) -> Option<(i128, i128)> {
        let is_count = |facts: &EntryFacts<'_>| self.sub == 0 && !facts.name.is_empty();
        let mut facts = documents.iter().filter_map(|facts| facts.entry(self.sub));
        let facts = facts.find(|facts| !facts.values.is_empty() && !is_count(facts))?;
        let low = facts.values.iter().map(|range| *range.start()).min()?;
        let high = facts.values.iter().map(|range| *range.end()).max()?;
        Some((low, high))
    }
}

const NO_NUMBER: &str = "a signal holds a number, but this is a string or bytes";

/// The length of a REAL.
const fn kind_bits(kind: Option<TypeKind>) -> u32 {
    match kind {
        Some(TypeKind::Real64) => 64,
        _ => 32,
    }
}

/// The scale of a value, and its unit, from the description, otherwise from documents.
fn scale<'a>(
    meanings: &Meanings<'a>,
    entry: &'a Entry,
    sub: u8,
    documents: &[ObjectFacts<'_>],
) -> (Scale, String) {
    let scaling = meanings.scaling_of(entry);
    if !scaling.is_empty() {
        return of_description(scaling);
    }
    let unit = documents.iter().filter_map(|facts| facts.entry(sub)).find_map(|facts| facts.unit);
    of_document(unit.unwrap_or_default())
}

/// The scale, the unit and the named values of an entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Scaled {
    scale: Scale,
    pub(crate) unit: String,
    /// Names of values that the description states.
    names: Vec<(i128, String)>,
}

/// The scale and the unit of an entry; `None` if it has neither.
pub(crate) fn scaling_of<'a>(
    device: &'a Device,
    meanings: &Meanings<'a>,
    (index, sub): (u16, u8),
) -> Option<Scaled> {
    let object = device.object(index)?;
    let entry = object.subs.get(sub).unwrap_or(&object.main);
    let documents: Vec<_> = profile::of_object(device, index).map(|(_, facts)| facts).collect();
    let (scale, unit) = scale(meanings, entry, sub, &documents);
    let names = match meanings.of(index, sub) {
        Some(Meaning::Enumeration(found)) => {
            found.values.iter().map(|value| (value.number, value.name.to_owned())).collect()
        }
        _ => Vec::new(),
    };
    let scaled = Scaled { scale, unit, names };
    (scaled != Scaled { scale: Scale::NONE, unit: String::new(), names: Vec::new() }).then_some(scaled)
}

impl Scaled {
    /// A value in the unit, or its name: `120 mm`.
    pub(crate) fn of(&self, value: &Value) -> Option<String> {
        if let Some(name) = value.as_integer().and_then(|number| self.name(number)) {
            return Some(name.to_owned());
        }
        let number = self.number(value)?;
        Some(if self.unit.is_empty() { number } else { format!("{number} {}", self.unit) })
    }

    /// The name of a number in the description.
    pub(crate) fn name(&self, number: i128) -> Option<&str> {
        self.names.iter().find(|(known, _)| *known == number).map(|(_, name)| name.as_str())
    }

    /// The number of a value in the unit.
    pub(crate) fn number(&self, value: &Value) -> Option<String> {
        let number = match value.as_integer() {
            Some(number) => Decimal::integer(number),
            None => Decimal::parse(&format!("{:e}", value.as_real()?))?,
        };
        Some(self.scale.apply(number)?.to_string())
    }
}

/// The scale and the unit that a description states.
fn of_description(scaling: Scaling<'_>) -> (Scale, String) {
    let number = |text: Option<&str>| text.and_then(Decimal::parse);
    let factor = number(scaling.multiplier).filter(|factor| !factor.is_zero()).unwrap_or(Decimal::ONE);
    let offset = number(scaling.offset).unwrap_or(Decimal::ZERO).times(factor);
    let unit = scaling.unit.and_then(|unit| unit.labels.name_in(LANGUAGE)).unwrap_or_default();
    (Scale { factor, offset: offset.unwrap_or(Decimal::ZERO) }, unit.trim().to_owned())
}

/// A unit of a document, such as `0.1 % of the rated torque`.
fn of_document(unit: &str) -> (Scale, String) {
    match unit.split_once(' ').and_then(|(number, unit)| Some((Decimal::parse(number)?, unit))) {
        Some((factor, unit)) => (Scale { factor, ..Scale::NONE }, unit.to_owned()),
        None => (Scale::NONE, unit.to_owned()),
    }
}

impl<'a> ValuePart<'a> {
    /// `7 warning`, `4-6 of the mode`.
    fn in_words(&self) -> String {
        match self.bits {
            1 => format!("{} {}", self.first, self.name),
            bits => format!("{}-{} {}", self.first, self.first + bits - 1, self.name),
        }
    }

    fn of_description(field: &crate::model::BitField<'a>) -> Self {
        let values = field.values.iter().flat_map(|values| &values.values);
        Self {
            first: field.first.into(),
            bits: field.bits.into(),
            name: field.name,
            is_signed: field.is_signed,
            values: values.map(|value| (value.number, value.name)).collect(),
            scaling: field.scaling,
        }
    }

    fn of_document(field: &profile::BitFieldFacts<'a>) -> Self {
        let is_small = |first: u64, last: u64| last.saturating_sub(first) < LARGEST_RANGE;
        let ranges = field.meanings().map(|(range, name)| (*range.start(), *range.end(), name));
        let values = ranges
            .filter(|(first, last, _)| is_small(*first, *last))
            .flat_map(|(first, last, name)| (first..=last).map(move |number| (i128::from(number), name)));
        Self {
            first: field.first.into(),
            bits: u32::from(field.last - field.first) + 1,
            name: field.name,
            is_signed: false,
            values: values.collect(),
            scaling: Scaling::default(),
        }
    }
}

//! Messages, the frames of a CAN-ID, and their signals: numbers in the bits of a frame.

use std::collections::BTreeSet;

use super::decimal::Decimal;
use super::identifier::{DbcName, DbcNames};

/// A signal.
#[derive(Clone, Debug)]
pub(super) struct DbcSignal {
    /// The words of its name.
    pub(super) words: String,
    /// The suffix of the name if several signals have the same: `6041_00`.
    pub(super) suffix: String,
    pub(super) mux: Mux,
    /// The lowest bit.
    pub(super) first: u32,
    /// Length in bits, 1 to 64.
    pub(super) bits: u32,
    pub(super) number: NumberFormat,
    pub(super) scale: Scale,
    /// The smallest and the largest value, scaled.
    pub(super) limits: Option<[Decimal; 2]>,
    pub(super) unit: String,
    /// The nodes that receive it.
    pub(super) receivers: BTreeSet<usize>,
    /// Names of values.
    pub(super) values: Vec<(i128, String)>,
    pub(super) comment: String,
}

/// How a signal is multiplexed. One in every frame that selects no others has the default.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Mux {
    /// Whether it selects others.
    pub(super) selects: bool,
    /// The signal that selects it, by its position in the message, and the selector values for which the
    /// frame contains it.
    pub(super) within: Option<(usize, Vec<[u32; 2]>)>,
}

impl Mux {
    /// A signal in the frames for which the selector has a value in these ranges.
    pub(super) fn within(selector: usize, ranges: &[[u32; 2]]) -> Self {
        Self { selects: false, within: Some((selector, ranges.to_vec())) }
    }
}

/// How bits are a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum NumberFormat {
    Unsigned,
    Signed,
    Real32,
    Real64,
}

/// The value of a number in its unit: number times factor plus offset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Scale {
    pub(super) factor: Decimal,
    pub(super) offset: Decimal,
}

impl Scale {
    /// The number itself.
    pub(super) const NONE: Self = Self { factor: Decimal::ONE, offset: Decimal::ZERO };

    pub(super) fn apply(self, number: Decimal) -> Option<Decimal> {
        number.times(self.factor)?.plus(self.offset)
    }
}

impl DbcSignal {
    /// A number without further meaning.
    pub(super) fn new(words: impl Into<String>, first: u32, bits: u32) -> Self {
        Self {
            words: words.into(),
            suffix: first.to_string(),
            mux: Mux::default(),
            first,
            bits,
            number: NumberFormat::Unsigned,
            scale: Scale::NONE,
            limits: None,
            unit: String::new(),
            receivers: BTreeSet::new(),
            values: Vec::new(),
            comment: String::new(),
        }
    }

    /// Adds a unit.
    #[must_use]
    pub(super) fn in_unit(self, unit: &str) -> Self {
        Self { unit: unit.to_owned(), ..self }
    }

    /// Adds names of values. Of two names of a value the first is used, and numbers that exceed the bits are omitted.
    #[must_use]
    pub(super) fn with_values(mut self, values: impl IntoIterator<Item = (i128, impl Into<String>)>) -> Self {
        let (low, high) = self.range();
        for (number, name) in values {
            let is_known = self.values.iter().any(|(known, _)| *known == number);
            let name = name.into();
            if (low..=high).contains(&number) && !is_known && !name.trim().is_empty() {
                self.values.push((number, name));
            }
        }
        self
    }

    /// The smallest and the largest integer.
    pub(super) fn range(&self) -> (i128, i128) {
        match self.number {
            NumberFormat::Unsigned => (0, (1 << self.bits) - 1),
            NumberFormat::Signed => (-(1 << (self.bits - 1)), (1 << (self.bits - 1)) - 1),
            NumberFormat::Real32 | NumberFormat::Real64 => (0, -1),
        }
    }

    /// The bit after the highest.
    pub(super) fn end(&self) -> u32 {
        self.first + self.bits
    }
}

/// A message.
#[derive(Clone, Debug)]
pub(super) struct DbcMessage {
    pub(super) id: DbcCanId,
    pub(super) name: DbcName,
    /// Length in bytes.
    pub(super) length: u32,
    /// The nodes that send it.
    pub(super) senders: Vec<usize>,
    /// In frame order, with their names.
    pub(super) signals: Vec<(DbcName, DbcSignal)>,
    pub(super) comment: String,
    /// The time between two frames in milliseconds, if it is stated.
    pub(super) cycle: Option<u32>,
    names: DbcNames,
}

/// A CAN-ID: base frames first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct DbcCanId {
    pub(super) is_extended: bool,
    pub(super) number: u32,
}

impl DbcCanId {
    /// A CAN-ID of 11 bits.
    pub(super) const fn base(number: u32) -> Self {
        Self { is_extended: false, number }
    }

    /// The number in the file, where bit 31 marks an extended frame.
    pub(super) const fn in_file(self) -> u32 {
        if self.is_extended { self.number | 1 << 31 } else { self.number }
    }
}

impl DbcMessage {
    pub(super) fn new(id: DbcCanId, name: DbcName, length: u32, comment: impl Into<String>) -> Self {
        Self {
            id,
            name,
            length,
            senders: Vec::new(),
            signals: Vec::new(),
            comment: comment.into(),
            cycle: None,
            names: DbcNames::default(),
        }
    }

    /// Adds a signal.
    pub(super) fn push(&mut self, signal: DbcSignal) {
        let name = self.names.claim(&signal.words, &signal.suffix);
        self.signals.push((name, signal));
    }

    /// Adds a node that receives all signals.
    pub(super) fn received_by(&mut self, node: usize) {
        for (_, signal) in &mut self.signals {
            signal.receivers.insert(node);
        }
    }
}

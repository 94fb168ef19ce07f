//! Values by their meaning.

use std::cmp::Ordering;

use crate::model::{DataType, Entry, Value};

/// The order of two numbers; `None` if one is not a number. Formulas are compared only with formulas.
fn order(a: &Value, b: &Value) -> Option<Ordering> {
    match (a, b) {
        (Value::NodeId(a), Value::NodeId(b)) => return Some(a.cmp(b)),
        (Value::NodeId(_), _) | (_, Value::NodeId(_)) => return None,
        _ => {}
    }
    match (a.as_integer(), b.as_integer()) {
        (Some(a), Some(b)) => Some(a.cmp(&b)),
        _ => a.as_real()?.partial_cmp(&b.as_real()?),
    }
}

/// Whether two values are equal, with formulas evaluated for a node if it is known.
pub(super) fn is_same(a: Option<&Value>, b: Option<&Value>, node_id: Option<u8>) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => {
            let number = |value: &Value| value.integer_for(node_id?);
            a == b
                || order(a, b) == Some(Ordering::Equal)
                || matches!((number(a), number(b)), (Some(a), Some(b)) if a == b)
        }
        (None, None) => true,
        _ => false,
    }
}

/// Whether a value equals that of an entry without one: 0 or empty.
pub(super) fn is_null(value: &Value) -> bool {
    match value {
        Value::Text(text) => text.is_empty(),
        Value::Bytes(bytes) => bytes.is_empty(),
        _ => value.as_integer() == Some(0) || value.as_real() == Some(0.0),
    }
}

/// A value in short.
pub(super) fn shown(value: &Value) -> String {
    match value {
        Value::Unsigned(number) if *number > 0xFFFF => format!("0x{number:X}"),
        Value::Text(text) => format!("\"{text}\""),
        value => value.to_string(),
    }
}

/// The allowed values of an entry: from a minimum to a maximum.
pub(super) struct AllowedRange<'a> {
    low: RangeEnd<'a>,
    high: RangeEnd<'a>,
}

/// One end of a range.
enum RangeEnd<'a> {
    Stated(&'a Value),
    /// From the data type.
    Implied(i128),
    /// Unknown.
    Open,
}

impl RangeEnd<'_> {
    fn order(&self, other: &Self) -> Option<Ordering> {
        let number = |limit: &Self| match limit {
            Self::Stated(value) => value.as_integer(),
            Self::Implied(number) => Some(*number),
            Self::Open => None,
        };
        match (self, other) {
            (Self::Open, Self::Open) => Some(Ordering::Equal),
            (Self::Stated(a), Self::Stated(b)) => order(a, b),
            _ => Some(number(self)?.cmp(&number(other)?)),
        }
    }

    fn shown(&self) -> Option<String> {
        match self {
            Self::Stated(value) => Some(shown(value)),
            _ => None,
        }
    }
}

impl<'a> AllowedRange<'a> {
    pub(super) fn of(entry: &'a Entry) -> Self {
        let implied = entry.data_type.and_then(DataType::integer_range);
        let limit = |stated: Option<&'a Value>, implied: Option<i128>| match (stated, implied) {
            (Some(value), _) => RangeEnd::Stated(value),
            (None, Some(number)) => RangeEnd::Implied(number),
            (None, None) => RangeEnd::Open,
        };
        Self {
            low: limit(entry.low_limit.as_ref(), implied.map(|(low, _)| low)),
            high: limit(entry.high_limit.as_ref(), implied.map(|(_, high)| high)),
        }
    }

    /// Equal if it allows the same values as the other, less if it lacks one of the other's values, otherwise
    /// greater.
    pub(super) fn against(&self, old: &Self) -> Ordering {
        let narrower = |end: Option<Ordering>, inwards: Ordering, is_open: bool| match end {
            Some(Ordering::Equal) => Ordering::Equal,
            Some(end) if end == inwards => Ordering::Less,
            Some(_) => Ordering::Greater,
            // a limit that cannot be compared may exclude anything, unless it no longer exists
            None if is_open => Ordering::Greater,
            None => Ordering::Less,
        };
        let low = narrower(self.low.order(&old.low), Ordering::Greater, matches!(self.low, RangeEnd::Open));
        let high = narrower(self.high.order(&old.high), Ordering::Less, matches!(self.high, RangeEnd::Open));
        match (low, high) {
            (Ordering::Less, _) | (_, Ordering::Less) => Ordering::Less,
            (Ordering::Equal, end) | (end, _) => end,
        }
    }

    /// The stated limits; `None` without any.
    pub(super) fn shown(&self) -> Option<String> {
        match (self.low.shown(), self.high.shown()) {
            (Some(low), Some(high)) => Some(format!("{low} to {high}")),
            (Some(low), None) => Some(format!("from {low}")),
            (None, Some(high)) => Some(format!("up to {high}")),
            (None, None) => None,
        }
    }
}

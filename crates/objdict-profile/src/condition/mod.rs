//! Conditions of profiles, which decide whether an object is mandatory: a notation for authors, and its
//! evaluation.
//!
//! Conditions are three-valued: if the description does not state a value, the condition is undecided and the
//! requirement does not apply.
//!
//! ```text
//! 6040h                      the object is described
//! 1A00h:2                    the sub-index is described
//! 1000h[16]                  the bit of its value is set
//! 1000h[16..31] in 1..5, 10  the value of the bits is one of these numbers
//! 6401h:0 > 4                the value is greater
//! 6206h and not 6207h        both; also `or` and brackets
//! ```

mod words;

use std::borrow::Cow;
use std::ops::RangeInclusive;

use super::{device_type_index, index_in};
use crate::model::{Device, Value};

/// A condition.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    text: Cow<'static, str>,
    terms: Cow<'static, [Term]>,
}

/// A term of a condition; its operands follow it.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Term {
    /// This number of terms are all true.
    All(u32),
    /// At least one of this many terms is true.
    OneOf(u32),
    /// A term is false.
    Not,
    /// The object or sub-index is described.
    Described(u16, Option<u8>),
    /// The value of the bits, from the lowest to the highest, is in one of this number of ranges.
    BitsIn(u16, u8, [u8; 2], u32),
    /// The value is in one of this number of ranges.
    ValueIn(u16, u8, u32),
    /// A range of numbers, both limits included.
    Range(i128, i128),
}

/// The reason why a text is not a valid condition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConditionError {
    expected: &'static str,
    found: String,
}

objdict_model::error_messages! { ConditionError: {
    Self { expected, found } => "expected {expected} {}", match found.as_str() {
        "" => "at the end of the condition".to_owned(),
        found => format!("at `{found}`"),
    };
} }

/// Maximum nesting depth of brackets and `not`.
const MAX_DEPTH: u8 = 16;

impl Condition {
    /// A condition parsed at build time.
    #[doc(hidden)]
    pub const fn constant(text: &'static str, terms: &'static [Term]) -> Self {
        Self { text: Cow::Borrowed(text), terms: Cow::Borrowed(terms) }
    }

    /// The parsed terms.
    #[doc(hidden)]
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// Whether the condition is true for a logical device, numbered from 0; `None` if the description does
    /// not determine it. 1000h represents the device type of the logical device.
    pub fn holds(&self, device: &Device, block: u8) -> Option<bool> {
        Terms { rest: &self.terms, device, block }.next()
    }

    /// Whether the condition only tests this bit of a value.
    pub fn tests_bit(&self, index: u16, bit: u8) -> bool {
        self.terms
            .iter()
            .any(|term| matches!(*term, Term::BitsIn(of, 0, bits, _) if of == index && bits == [bit, bit]))
    }

    /// The described objects in the condition, in its order; with the sub-index if it refers to a value.
    pub fn causes(&self, device: &Device, block: u8) -> impl Iterator<Item = (u16, Option<u8>)> {
        let named = self.terms.iter().filter_map(|term| match *term {
            Term::Described(index, sub) => Some((index, sub)),
            Term::BitsIn(index, sub, ..) | Term::ValueIn(index, sub, _) => Some((index, Some(sub))),
            Term::All(_) | Term::OneOf(_) | Term::Not | Term::Range(..) => None,
        });
        let named = named.map(move |(index, sub)| (place_of(index, device, block), sub));
        named.filter(|(index, _)| device.object(*index).is_some_and(|object| !object.orphan))
    }
}

impl std::str::FromStr for Condition {
    type Err = ConditionError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut parser = ConditionParser { rest: text.trim_start(), depth: 0, terms: Vec::new() };
        parser.any()?;
        match parser.rest {
            "" => Ok(Self { text: text.trim().to_owned().into(), terms: parser.terms.into() }),
            _ => Err(parser.error("`and`, `or` or the end")),
        }
    }
}

objdict_model::messages! { Condition: { Self { text, .. } => "{text}"; } }

/// The index that a condition refers to in a logical device: 1000h is its device type.
fn place_of(index: u16, device: &Device, block: u8) -> u16 {
    match index {
        0x1000 => device_type_index(device, block),
        _ => index_in(block, index),
    }
}

/// Terms, and the logical device for which they are evaluated.
struct Terms<'a> {
    rest: &'a [Term],
    device: &'a Device,
    block: u8,
}

impl Terms<'_> {
    /// Evaluates the next term and consumes it with its operands.
    fn next(&mut self) -> Option<bool> {
        let (term, rest) = self.rest.split_first()?;
        self.rest = rest;
        match *term {
            Term::All(count) => self.decided(count, false),
            Term::OneOf(count) => self.decided(count, true),
            Term::Not => self.next().map(|holds| !holds),
            Term::Described(index, sub) => {
                let object = self
                    .device
                    .object(place_of(index, self.device, self.block))
                    .filter(|object| !object.orphan);
                Some(object.is_some_and(|object| sub.is_none_or(|sub| object.has(sub))))
            }
            Term::BitsIn(index, sub, [first, last], count) => {
                let value = self.value_of(index, sub);
                let width = u32::from(last.saturating_sub(first)) + 1;
                self.is_in(count, value.map(|value| (value >> first) & ((1i128 << width) - 1)))
            }
            Term::ValueIn(index, sub, count) => {
                let value = self.value_of(index, sub);
                self.is_in(count, value)
            }
            Term::Range(..) => None,
        }
    }

    /// Returns `deciding` if one of the next terms has that value, otherwise the opposite if all are known.
    fn decided(&mut self, count: u32, deciding: bool) -> Option<bool> {
        let (mut known, mut decided) = (true, false);
        for _ in 0..count {
            let one = self.next();
            known &= one.is_some();
            decided |= one == Some(deciding);
        }
        if decided { Some(deciding) } else { known.then_some(!deciding) }
    }

    /// Whether a number is in one of the next ranges.
    fn is_in(&mut self, count: u32, number: Option<i128>) -> Option<bool> {
        let (ranges, rest) = self.rest.split_at_checked(count as usize)?;
        self.rest = rest;
        let number = number?;
        let is_in =
            |term: &Term| matches!(*term, Term::Range(first, last) if (first..=last).contains(&number));
        Some(ranges.iter().any(is_in))
    }

    fn value_of(&self, index: u16, sub: u8) -> Option<i128> {
        self.device
            .object(place_of(index, self.device, self.block))?
            .value(sub)
            .as_deref()
            .and_then(Value::as_integer)
    }
}

struct ConditionParser<'a> {
    rest: &'a str,
    depth: u8,
    terms: Vec<Term>,
}

impl ConditionParser<'_> {
    fn any(&mut self) -> Result<(), ConditionError> {
        self.joined("or", Term::OneOf, Self::all)
    }

    fn all(&mut self) -> Result<(), ConditionError> {
        self.joined("and", Term::All, Self::one)
    }

    /// One part, or several joined by a keyword.
    fn joined(
        &mut self,
        word: &str,
        join: fn(u32) -> Term,
        part: fn(&mut Self) -> Result<(), ConditionError>,
    ) -> Result<(), ConditionError> {
        let start = self.terms.len();
        let mut count = 1;
        part(self)?;
        while self.word(word) {
            part(self)?;
            count += 1;
        }
        if count > 1 {
            self.terms.insert(start, join(count));
        }
        Ok(())
    }

    fn one(&mut self) -> Result<(), ConditionError> {
        if self.depth == MAX_DEPTH {
            return Err(self.error("fewer brackets"));
        }
        self.depth += 1;
        if self.word("not") {
            self.terms.push(Term::Not);
            self.one()?;
        } else if self.symbol("(") {
            self.any()?;
            if !self.symbol(")") {
                return Err(self.error("`)`"));
            }
        } else {
            self.test()?;
        }
        self.depth -= 1;
        Ok(())
    }

    fn test(&mut self) -> Result<(), ConditionError> {
        let index = self.hex("an index such as `6040h`")?;
        let sub = match self.symbol(":") {
            true => Some(self.hex("a sub-index in hexadecimal")?),
            false => None,
        };
        let bits = if self.symbol("[") { Some(self.bits()?) } else { None };
        let ranges = self.comparison()?;
        let (term, ranges) = match (bits, ranges) {
            (None, None) => (Term::Described(index, sub), Vec::new()),
            (None, Some(ranges)) => (Term::ValueIn(index, sub.unwrap_or(0), count(&ranges)), ranges),
            (Some(bits), ranges) => {
                let ranges = ranges.unwrap_or_else(|| vec![1..=i128::MAX]);
                (Term::BitsIn(index, sub.unwrap_or(0), bits, count(&ranges)), ranges)
            }
        };
        self.terms.push(term);
        self.terms.extend(ranges.iter().map(|range| Term::Range(*range.start(), *range.end())));
        Ok(())
    }

    fn bits(&mut self) -> Result<[u8; 2], ConditionError> {
        let expected = "bits from 0 to 63, such as `16` or `16..31`";
        let range = self.range(expected)?;
        let bit = |number: i128| u8::try_from(number).ok().filter(|bit| *bit < 64);
        match (bit(*range.start()), bit(*range.end()), self.symbol("]")) {
            (Some(first), Some(last), true) if first <= last => Ok([first, last]),
            (_, _, false) => Err(self.error("`]`")),
            _ => Err(ConditionError { expected, found: format!("{}..{}", range.start(), range.end()) }),
        }
    }

    /// The numbers that a comparison accepts; `None` without a comparison.
    fn comparison(&mut self) -> Result<Option<Vec<RangeInclusive<i128>>>, ConditionError> {
        let number = "a number";
        Ok(Some(if self.symbol(">=") {
            vec![self.number(number)?..=i128::MAX]
        } else if self.symbol("<=") {
            vec![i128::MIN..=self.number(number)?]
        } else if self.symbol("!=") {
            let but = self.number(number)?;
            vec![i128::MIN..=but - 1, but + 1..=i128::MAX]
        } else if self.symbol(">") {
            vec![self.number(number)? + 1..=i128::MAX]
        } else if self.symbol("<") {
            vec![i128::MIN..=self.number(number)? - 1]
        } else if self.symbol("=") {
            let number = self.number(number)?;
            vec![number..=number]
        } else if self.word("in") {
            let mut numbers = vec![self.range("a number or a range such as `1..5`")?];
            while self.symbol(",") {
                numbers.push(self.range("a number or a range such as `1..5`")?);
            }
            numbers
        } else {
            return Ok(None);
        }))
    }

    fn range(&mut self, expected: &'static str) -> Result<RangeInclusive<i128>, ConditionError> {
        let first = self.number(expected)?;
        let last = if self.symbol("..") { self.number(expected)? } else { first };
        Ok(first..=last)
    }

    /// A decimal number, or a hexadecimal one after `0x`; at most 64 bits.
    fn number(&mut self, expected: &'static str) -> Result<i128, ConditionError> {
        let (negative, text) = match self.rest.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, self.rest),
        };
        let end = text.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(text.len());
        let (digits, rest) = text.split_at(end);
        let number = match digits.strip_prefix("0x") {
            Some(digits) => u64::from_str_radix(digits, 16),
            None => digits.parse(),
        };
        let Ok(number) = number else { return Err(self.error(expected)) };
        self.rest = rest.trim_start();
        Ok(if negative { -i128::from(number) } else { i128::from(number) })
    }

    /// A hexadecimal number, with or without the suffix `h`.
    fn hex<T: TryFrom<u32>>(&mut self, expected: &'static str) -> Result<T, ConditionError> {
        let end = self.rest.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        let number = u32::from_str_radix(digits.trim_end_matches('h'), 16).ok();
        let Some(number) = number.and_then(|number| T::try_from(number).ok()) else {
            return Err(self.error(expected));
        };
        self.rest = rest.trim_start();
        Ok(number)
    }

    fn symbol(&mut self, symbol: &str) -> bool {
        let rest = self.rest.strip_prefix(symbol);
        self.rest = rest.map_or(self.rest, str::trim_start);
        rest.is_some()
    }

    fn word(&mut self, word: &str) -> bool {
        let rest = self.rest.strip_prefix(word);
        let rest = rest.filter(|rest| !rest.starts_with(|c: char| c.is_ascii_alphanumeric()));
        self.rest = rest.map_or(self.rest, str::trim_start);
        rest.is_some()
    }

    fn error(&self, expected: &'static str) -> ConditionError {
        let found: String = self.rest.chars().take(20).collect();
        ConditionError { expected, found: found.trim_end().to_owned() }
    }
}

/// The number of ranges; a text cannot contain 2³² of them.
fn count(ranges: &[RangeInclusive<i128>]) -> u32 {
    u32::try_from(ranges.len()).unwrap_or(u32::MAX)
}

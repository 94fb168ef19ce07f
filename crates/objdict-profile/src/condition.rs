//! Conditions of profiles: when an object has to be there, as a text that people write and the program evaluates.
//!
//! ```text
//! 6040h                      the object is described
//! 1A00h:2                    the sub-index is
//! 1000h[16]                  the bit of its value is set
//! 1000h[16..31] in 1..5, 10  the bits make one of these numbers
//! 6401h:0 > 4                the value is greater
//! 6206h and not 6207h        both; `or`, and brackets
//! ```

use std::fmt;
use std::ops::RangeInclusive;

use super::{device_type_index, index_in};
use crate::model::{Device, Value};

/// When a demand holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    text: String,
    expression: Expression,
}

#[derive(Clone, Debug, PartialEq)]
enum Expression {
    All(Vec<Expression>),
    Any(Vec<Expression>),
    Not(Box<Expression>),
    /// The object or sub-index is described.
    Described(u16, Option<u8>),
    /// The bits of a value are one of these numbers.
    Bits(u16, u8, RangeInclusive<u8>, Vec<RangeInclusive<i128>>),
    /// The value is one of these numbers.
    Value(u16, u8, Vec<RangeInclusive<i128>>),
}

/// Why a text is no condition.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("expected {expected} {}", Found(.found))]
pub struct ConditionError {
    expected: &'static str,
    found: String,
}

struct Found<'a>(&'a str);

impl fmt::Display for Found<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            "" => f.write_str("at the end of the condition"),
            found => write!(f, "at `{found}`"),
        }
    }
}

/// Brackets and `not` may lie in each other so deep.
const MAX_DEPTH: u8 = 16;

impl Condition {
    /// Whether it holds for a logical device, counted from 0; `None` where the description does not say. 1000h stands for
    /// the device type of the logical device.
    pub fn holds(&self, device: &Device, block: u8) -> Option<bool> {
        self.expression.holds(device, block)
    }
}

impl std::str::FromStr for Condition {
    type Err = ConditionError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut parser = Parser { rest: text.trim_start(), depth: 0 };
        let expression = parser.any()?;
        match parser.rest {
            "" => Ok(Self { text: text.trim().to_owned(), expression }),
            _ => Err(parser.error("`and`, `or` or the end")),
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Expression {
    fn holds(&self, device: &Device, block: u8) -> Option<bool> {
        match self {
            Self::All(all) => decided(all.iter().map(|one| one.holds(device, block)), false),
            Self::Any(any) => decided(any.iter().map(|one| one.holds(device, block)), true),
            Self::Not(not) => not.holds(device, block).map(|holds| !holds),
            Self::Described(index, sub) => {
                let object = device.object(place_of(device, block, *index)).filter(|object| !object.orphan);
                Some(object.is_some_and(|object| sub.is_none_or(|sub| object.has(sub))))
            }
            Self::Bits(index, sub, bits, numbers) => {
                let value = value_of(device, block, *index, *sub)?;
                let width = u32::from(bits.end() - bits.start()) + 1;
                let part = (value >> bits.start()) & ((1i128 << width) - 1);
                Some(numbers.iter().any(|range| range.contains(&part)))
            }
            Self::Value(index, sub, numbers) => {
                let value = value_of(device, block, *index, *sub)?;
                Some(numbers.iter().any(|range| range.contains(&value)))
            }
        }
    }
}

/// `deciding` when one is it, else the opposite when all are known.
fn decided(all: impl Iterator<Item = Option<bool>>, deciding: bool) -> Option<bool> {
    let mut known = true;
    for one in all {
        match one {
            Some(holds) if holds == deciding => return Some(deciding),
            Some(_) => {}
            None => known = false,
        }
    }
    known.then_some(!deciding)
}

fn place_of(device: &Device, block: u8, index: u16) -> u16 {
    if index == 0x1000 { device_type_index(device, block) } else { index_in(block, index) }
}

fn value_of(device: &Device, block: u8, index: u16, sub: u8) -> Option<i128> {
    device.object(place_of(device, block, index))?.value(sub).as_deref().and_then(Value::as_integer)
}

struct Parser<'a> {
    rest: &'a str,
    depth: u8,
}

impl<'a> Parser<'a> {
    fn any(&mut self) -> Result<Expression, ConditionError> {
        let mut any = vec![self.all()?];
        while self.word("or") {
            any.push(self.all()?);
        }
        Ok(if any.len() == 1 { any.remove(0) } else { Expression::Any(any) })
    }

    fn all(&mut self) -> Result<Expression, ConditionError> {
        let mut all = vec![self.one()?];
        while self.word("and") {
            all.push(self.one()?);
        }
        Ok(if all.len() == 1 { all.remove(0) } else { Expression::All(all) })
    }

    fn one(&mut self) -> Result<Expression, ConditionError> {
        if self.depth == MAX_DEPTH {
            return Err(self.error("fewer brackets"));
        }
        self.depth += 1;
        let one = if self.word("not") {
            Expression::Not(Box::new(self.one()?))
        } else if self.symbol("(") {
            let any = self.any()?;
            if !self.symbol(")") {
                return Err(self.error("`)`"));
            }
            any
        } else {
            self.test()?
        };
        self.depth -= 1;
        Ok(one)
    }

    fn test(&mut self) -> Result<Expression, ConditionError> {
        let index = self.hex("an index such as `6040h`")?;
        let sub = match self.symbol(":") {
            true => Some(self.hex("a sub-index in hexadecimal")?),
            false => None,
        };
        if self.symbol("[") {
            let bits = self.bits()?;
            let numbers = self.comparison()?.unwrap_or_else(|| vec![1..=i128::MAX]);
            return Ok(Expression::Bits(index, sub.unwrap_or(0), bits, numbers));
        }
        Ok(match self.comparison()? {
            Some(numbers) => Expression::Value(index, sub.unwrap_or(0), numbers),
            None => Expression::Described(index, sub),
        })
    }

    fn bits(&mut self) -> Result<RangeInclusive<u8>, ConditionError> {
        let expected = "bits from 0 to 63, such as `16` or `16..31`";
        let range = self.range(expected)?;
        let bit = |number: i128| u8::try_from(number).ok().filter(|bit| *bit < 64);
        match (bit(*range.start()), bit(*range.end()), self.symbol("]")) {
            (Some(first), Some(last), true) if first <= last => Ok(first..=last),
            (_, _, false) => Err(self.error("`]`")),
            _ => Err(ConditionError { expected, found: format!("{}..{}", range.start(), range.end()) }),
        }
    }

    /// The numbers that a comparison accepts; `None` when there is none.
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

    /// A number in decimal or, behind `0x`, in hexadecimal; of at most 64 bits.
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

    /// A number in hexadecimal, with `h` behind it or without.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{DataType, Entry, Object};

    fn device() -> Device {
        let mut device = Device::default();
        for (index, value) in [(0x1000, 0x0003_0191), (0x6401, 6), (0x6000, 0)] {
            let value = Value::from_integer(value, DataType::UNSIGNED32);
            let main = Entry { default: value, ..Entry::default() };
            device.objects.insert(index, Object { main, ..Object::default() });
        }
        device
    }

    fn holds(text: &str) -> Option<bool> {
        text.parse::<Condition>().unwrap().holds(&device(), 0)
    }

    #[test]
    fn conditions_ask_the_description() {
        assert_eq!(holds("6000h"), Some(true));
        assert_eq!(holds("not 6000h or 6040h"), Some(false));
        assert_eq!(holds("1000h[16] and 1000h[17]"), Some(true));
        assert_eq!(holds("1000h[18]"), Some(false));
        assert_eq!(holds("1000h[16..31] in 1..2, 3"), Some(true));
        assert_eq!(holds("1000h[0..15] = 0x191"), Some(true));
        assert_eq!(holds("6401h:0 > 4"), Some(true));
        assert_eq!(holds("6401 != 6"), Some(false));
        assert_eq!(holds("6000h and (6040h or not 6041h)"), Some(true));
    }

    #[test]
    fn what_the_description_does_not_say_decides_nothing() {
        assert_eq!(holds("6502h[0]"), None);
        assert_eq!(holds("6502h[0] or 6000h"), Some(true));
        assert_eq!(holds("6502h[0] and 6040h"), Some(false));
        assert_eq!(holds("6502h[0] and 6000h"), None);
    }

    #[test]
    fn other_texts_are_no_conditions() {
        let error = |text: &str| text.parse::<Condition>().unwrap_err().to_string();
        assert_eq!(error("6040h and"), "expected an index such as `6040h` at the end of the condition");
        assert_eq!(error("6040h 6041h"), "expected `and`, `or` or the end at `6041h`");
        assert_eq!(error("(6040h"), "expected `)` at the end of the condition");
        assert_eq!(error("16040h"), "expected an index such as `6040h` at `16040h`");
        assert_eq!(error("1000h[70]"), "expected bits from 0 to 63, such as `16` or `16..31` at `70..70`");
        assert_eq!(error(&"not ".repeat(99)), "expected fewer brackets at `not not not not not`");
        assert_eq!(error("6000h > many"), "expected a number at `many`");
    }
}

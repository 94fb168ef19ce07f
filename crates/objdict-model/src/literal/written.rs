//! Texts that people write for objdict: arguments, settings, values of YAML and TOML.

use super::{Quirk, Quirks, integer, value};
use crate::model::{DataType, Reason, Value};

/// A text that is not a valid value of a data type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoValue {
    /// The reason: lower case, offending text in backticks, no full stop.
    pub message: String,
    /// The correct notation, unless that is obvious.
    pub help: Option<&'static str>,
}

/// Parses a value. Comments are not allowed, and octal numbers are rejected: readers of TOML and arguments expect
/// decimal, readers of CiA 306 octal.
///
/// # Errors
/// The reason why the text is not a valid value of the type.
pub fn written(text: &str, data_type: DataType) -> Result<Value, NoValue> {
    let mut quirks = Quirks::default();
    match value(text, Some(data_type), &mut quirks) {
        Ok(value) if !quirks.has(Quirk::Octal) => Ok(value),
        Ok(_) => Err(NoValue {
            message: format!("`{text}` is octal by CiA 306, but some tools read it as decimal"),
            help: Some("write it without the leading zero, or in hexadecimal with `0x`"),
        }),
        Err(reason) => Err(match iec_number(text, &reason) {
            Some(number) => NoValue {
                message: format!("`{text}` is not a valid {data_type}; in IEC 61131 it is `{number}`"),
                help: Some("write the number in decimal, or in hexadecimal with `0x`"),
            },
            None => NoValue { message: format!("`{text}` is not a valid {data_type}"), help: None },
        }),
    }
}

/// Parses a whole number like [`written`]; `None` if it exceeds `most`.
pub fn written_number(text: &str, most: u64) -> Option<u64> {
    let mut quirks = Quirks::default();
    let number = integer(text, 0, most, &mut quirks).ok().filter(|_| !quirks.has(Quirk::Octal))?;
    u64::try_from(number).ok()
}

/// The number or formula that an invalid text means, if `reason` rejects an IEC 61131-3 literal: `0x3E8` for `16#3E8`.
pub fn iec_number(text: &str, reason: &Reason) -> Option<String> {
    let (start, literal) = match text.rsplit_once('+') {
        Some((node_id, literal)) if *reason == Reason::NotAFormula => {
            let is_formula = node_id.trim_ascii().eq_ignore_ascii_case("$NODEID");
            ("$NODEID+", Some(literal.trim_ascii()).filter(|_| is_formula)?)
        }
        _ if *reason == Reason::NotANumber => ("", text),
        _ => return None,
    };
    let (base, digits) = literal.split_once('#')?;
    let base: u32 = base.parse().ok().filter(|base| (2..=16).contains(base))?;
    let is_number = digits.starts_with(|first: char| first.is_digit(base));
    let number = u64::from_str_radix(&digits.replace('_', ""), base).ok().filter(|_| is_number)?;
    Some(if base == 10 { format!("{start}{number}") } else { format!("{start}0x{number:X}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_literal_of_iec_61131_is_no_number_and_has_a_meaning() {
        for (text, meant) in [
            ("16#3E8", Some("0x3E8")),
            ("16#ff", Some("0xFF")),
            ("2#1111_0000", Some("0xF0")),
            ("8#17", Some("0xF")),
            ("10#20", Some("20")),
            ("$NODEID+16#200", Some("$NODEID+0x200")),
            ("$nodeid + 16#200", Some("$NODEID+0x200")),
            ("16#", None),
            ("16#+1", None),
            ("2#2", None),
            ("0x10#A", None),
            ("17#1", None),
            ("1;2", None),
            ("0x1234;0x5678", None),
            ("100//2", None),
            ("$SPEED+16#1", None),
        ] {
            let reason = value(text, Some(DataType::UNSIGNED32), &mut Quirks::default()).unwrap_err();
            assert_eq!(iec_number(text, &reason).as_deref(), meant, "{text}");
        }
    }

    #[test]
    fn octal_numbers_are_none() {
        let read = |text| (written(text, DataType::UNSIGNED8).ok(), written_number(text, 255));
        assert_eq!(read("010"), (None, None));
        assert_eq!(read("07"), (Some(Value::Unsigned(7)), Some(7)));
        assert_eq!(read("0x10"), (Some(Value::Unsigned(16)), Some(16)));
        assert_eq!(read("300"), (None, None));
        assert_eq!(read("5 # five"), (None, None));
    }
}

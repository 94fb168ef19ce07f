//! Filters for code generation in addition to those of Jinja.

use minijinja::{Environment, Error, ErrorKind, Value};

use crate::{escape, names};

/// Registers the filters.
pub(super) fn add(environment: &mut Environment<'_>) {
    environment.add_filter("hex", hex);
    environment.add_filter("number", number);
    environment.add_filter("words", |text: &str| names::words(text));
    environment.add_filter("c_comment", |text: &str| escape::c_comment(text));
    environment.add_filter("c_string", |text: &str| escape::c_string(text.as_bytes()));
    environment.add_filter("rust_comment", |text: &str| escape::code_span(text));
    environment.add_filter("rust_bytes", |text: &str| escape::byte_string(text.as_bytes()));
    environment.add_filter("toml_string", |text: &str| escape::toml_string(text));
}

/// A number in hexadecimal, zero-padded to a width: `4120|hex(8)` is `00001018`. A negative number is shown
/// as two's complement of that width.
fn hex(value: &Value, width: Option<usize>) -> Result<String, Error> {
    let number = integer(value)?;
    let width = width.unwrap_or(0).min(32);
    if number >= 0 {
        return Ok(format!("{number:0width$X}"));
    }
    match (width, i128::BITS.checked_sub(4 * width as u32)) {
        (1.., Some(unused)) if number >= (i128::MIN >> unused) => {
            let bits = (number as u128) << unused >> unused; // same bits, truncated to the width
            Ok(format!("{bits:0width$X}"))
        }
        _ => Err(wrong(format!("`{number}` is negative: `hex` needs a width with room for it"))),
    }
}

/// Parses a text such as `0x1018`, the form of indexes in the JSON.
fn number(value: &Value) -> Result<i128, Error> {
    integer(value)
}

fn integer(value: &Value) -> Result<i128, Error> {
    let text = match (i128::try_from(value.clone()), value.as_str()) {
        (Ok(number), _) => return Ok(number),
        (_, Some(text)) => text,
        _ => return Err(wrong(format!("`{value}` is not a number"))),
    };
    let parsed = match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) if !digits.starts_with(['+', '-']) => i128::from_str_radix(digits, 16).ok(),
        Some(_) => None,
        None => text.parse().ok(),
    };
    parsed.ok_or_else(|| wrong(format!("`{text}` is not a number")))
}

pub(super) fn wrong(message: String) -> Error {
    Error::new(ErrorKind::InvalidOperation, message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_hexadecimal() {
        let hex = |number: i64, width| hex(&Value::from(number), width).ok();
        assert_eq!(hex(0x1018, Some(8)).as_deref(), Some("00001018"));
        assert_eq!(hex(0, None).as_deref(), Some("0"));
        assert_eq!(hex(-1, Some(4)).as_deref(), Some("FFFF"));
        assert_eq!(hex(-0x8000, Some(4)).as_deref(), Some("8000"));
        assert_eq!(hex(-0x8001, Some(4)), None);
        assert_eq!(hex(-1, None), None);
        assert_eq!(hex(-1, Some(1000)).map(|text| text.len()), Some(32));
    }

    #[test]
    fn texts_with_numbers() {
        let number = |text: &str| number(&Value::from(text)).ok();
        assert_eq!(number("0x1018"), Some(0x1018));
        assert_eq!(number("12"), Some(12));
        for text in ["", "0x", "0x+1", "1e3", "x"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}

//! Filters for code generation in addition to those of Jinja, and limits for the engine's filters whose results can be
//! far larger than their arguments, because the step limit does not cover the work of a single filter.

use super::LONGEST;
use crate::{escape, names};
use minijinja::value::{Rest, ValueKind, ValueOrKwargs};
use minijinja::{Environment, Error, ErrorKind, State, Value, filters};

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

/// Parses a string such as `0x1018`, the notation of indexes in the JSON.
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

/// The maximum number of bytes that a filter generates from its arguments, the first of which is its input.
type Bound = fn(&[Value]) -> usize;

pub(super) fn bound(environment: &mut Environment<'_>) {
    let bounded: [(&str, Value, Bound); 6] = [
        ("batch", Value::from_function(filters::batch), rows),
        ("format", Value::from_function(filters::format), formatted),
        ("indent", Value::from_function(filters::indent), indented),
        ("join", Value::from_function(filters::join), joined),
        ("replace", Value::from_function(filters::replace), replaced),
        ("slice", Value::from_function(filters::slice), rows),
    ];
    for (name, filter, bound) in bounded {
        let limited =
            move |state: &mut State<'_, '_>, arguments: Rest<ValueOrKwargs>| -> Result<Value, Error> {
                let arguments: Vec<Value> = arguments.0.into_iter().map(Value::from).collect();
                if bound(&arguments) > LONGEST {
                    return Err(wrong(format!("`{name}` would produce more than {LONGEST} bytes")));
                }
                filter.call(state, &arguments)
            };
        environment.add_filter(name, limited);
    }
}

fn text(value: Option<&Value>) -> &str {
    value.and_then(Value::as_str).unwrap_or_default()
}

fn length(value: &Value) -> usize {
    value.as_str().map_or(32, str::len)
}

/// The largest number among arguments, named ones too.
fn largest(arguments: &[Value]) -> usize {
    let of = |value: &Value| value.as_usize().unwrap_or_default();
    let named = |value: &Value| {
        let keys = value.try_iter().into_iter().flatten();
        keys.filter_map(|key| value.get_item(&key).ok()).map(|value| of(&value)).max().unwrap_or_default()
    };
    let largest = |value: &Value| if value.kind() == ValueKind::Map { named(value) } else { of(value) };
    arguments.iter().skip(1).map(largest).max().unwrap_or_default()
}

fn rows(arguments: &[Value]) -> usize {
    largest(arguments).saturating_mul(size_of::<Value>())
}

/// Each field of the format can contain each argument, and the widths in the format or an argument.
fn formatted(arguments: &[Value]) -> usize {
    let format = text(arguments.first());
    let widths =
        format.split(|character: char| !character.is_ascii_digit()).filter(|width| !width.is_empty());
    let widths = widths.map(|width| width.parse().unwrap_or(usize::MAX)).fold(0, usize::saturating_add);
    let stated = if format.contains('*') { largest(arguments) } else { 0 };
    let given = arguments.iter().skip(1).map(length).fold(stated, usize::saturating_add);
    format.matches('%').count().saturating_mul(given).saturating_add(widths)
}

fn indented(arguments: &[Value]) -> usize {
    (text(arguments.first()).lines().count() + 1).saturating_mul(largest(arguments))
}

fn joined(arguments: &[Value]) -> usize {
    let between = text(arguments.get(1)).len();
    let items = arguments.first().and_then(|list| list.try_iter().ok());
    items.into_iter().flatten().map(|item| length(&item) + between).fold(0, usize::saturating_add)
}

fn replaced(arguments: &[Value]) -> usize {
    let (text, from, to) = (text(arguments.first()), text(arguments.get(1)), text(arguments.get(2)));
    text.matches(from).count().saturating_mul(to.len())
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

//! Texts that are not valid values of their field, but whose intended value is clear.

use crate::diagnostic::{Fix, say};
use crate::literal::{Intended, Spelling, iec_number, print, written};
use crate::model::{DataType, Field, InvalidValue, ObjectType, Place, Reason, Value};

/// The fix of an invalid value at `place`, if the intended value is clear.
pub(crate) fn respell(invalid: &InvalidValue, data_type: Option<DataType>, place: Place) -> Option<Fix> {
    let text = invalid.text.trim();
    let safe = |value: String| (Fix::safe(say!("write `{}`", value)), value);
    let risky = |value: String| (Fix::risky(say!("write `{}`", value)), value);
    // tools that stop at `#` read the base
    let literal = iec_number(text, &invalid.reason);
    if let Some(number) =
        literal.filter(|number| data_type.is_none_or(|data_type| written(number, data_type).is_ok()))
    {
        return Some(Fix::risky(say!("write `{}`", number)).set(place, number));
    }
    let (fix, value) = match (&invalid.field, &invalid.reason) {
        // `r` may be read-only or constant
        (Field::AccessType, _) if text.len() == 1 => risky(invalid.intended_access()?.name().to_owned()),
        (Field::AccessType, _) => safe(invalid.intended_access()?.name().to_owned()),
        (Field::CompactSubObj, _) if text == "255" => risky("254".to_owned()),
        (Field::ObjectType, _) => safe(format!("0x{:X}", object_type(text)?.code())),
        (Field::PdoMapping, _) => safe(flag(text)?.to_owned()),
        // a number with a digit 8 or 9 cannot be octal, so it is decimal
        (_, Reason::NotOctal) => safe(without_zeros(text)?),
        (_, Reason::NotANumber) if is_hex(text) && data_type.is_none() => risky(format!("0x{text}")),
        (field, _) => match invalid.intended(data_type?)? {
            // a BOOLEAN of 3 may be meant as a number
            Intended::Value(value @ Value::Boolean(_)) => risky(print(&value, Spelling::default())),
            Intended::Value(value) => safe(print(&value, Spelling::default())),
            Intended::Nothing => return Some(Fix::risky(say!("remove `{}`", field)).remove(place)),
        },
    };
    Some(fix.set(place, value))
}

fn object_type(text: &str) -> Option<ObjectType> {
    let code = (0..=9).filter_map(ObjectType::from_code);
    code.into_iter().find(|object_type| object_type.name().eq_ignore_ascii_case(text))
}

fn flag(text: &str) -> Option<&'static str> {
    match text.to_ascii_lowercase().as_str() {
        "true" | "yes" => Some("1"),
        "false" | "no" => Some("0"),
        _ => None,
    }
}

fn without_zeros(text: &str) -> Option<String> {
    let (sign, digits) = text.strip_prefix('-').map_or(("", text), |digits| ("-", digits));
    let is_decimal = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_decimal.then(|| format!("{sign}{}", digits.trim_start_matches('0')))
}

/// Whether a text is a hexadecimal number without `0x`.
fn is_hex(text: &str) -> bool {
    (1..=8).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

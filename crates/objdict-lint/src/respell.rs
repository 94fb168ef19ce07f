//! Fixes of invalid values with a clear intention, and of missing parts: members of object lists (CiA 306-1 §4.6.3.1)
//! and sub-index 0.

use crate::diagnostic::{Change, Fix, MAX_FIX_LINES, say};
use crate::literal::{Intended, Spelling, iec_number, print, written};
use crate::model::{DataType, Field, InvalidValue, Object, ObjectType, Part, Place, Reason, Value};

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
            // a BOOLEAN of 3 may be intended as a number
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

/// Whether a string is a hexadecimal number without `0x`.
fn is_hex(text: &str) -> bool {
    (1..=8).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// A list with additional members: in order if the list is sorted, otherwise at its end.
pub(crate) fn with_members(list: &[u16], others: impl IntoIterator<Item = u16>) -> Vec<u16> {
    let is_sorted = list.is_sorted();
    let mut members = list.to_vec();
    members.extend(others);
    if is_sorted {
        members.sort_unstable();
    }
    members
}

/// Sub-index 0 of an object with the usual attributes.
pub(crate) fn sub_0(index: u16, object: &Object) -> Change {
    let keys = [
        (Field::ParameterName, "Highest sub-index supported".to_owned()),
        (Field::ObjectType, "0x7".to_owned()),
        (Field::DataType, "0x0005".to_owned()),
        (Field::AccessType, "ro".to_owned()),
        (Field::DefaultValue, object.highest_sub().unwrap_or_default().to_string()),
        (Field::PdoMapping, "0".to_owned()),
    ];
    Change::Add(Part::Entry(index, 0), keys.to_vec())
}

/// The fixes of a rule that rewrite lists. Each fix changes as many lines as its list has, and a hostile
/// file may contain a long list, so their total is limited.
pub(crate) struct ListFixes {
    lines: usize,
}

impl ListFixes {
    /// A counter for the fixes of one rule.
    pub(crate) fn new() -> Self {
        Self { lines: MAX_FIX_LINES }
    }

    /// The fix of the next finding, unless the limit is reached.
    pub(crate) fn next(&mut self, list: &[u16], fix: impl FnOnce() -> Fix) -> Option<Fix> {
        self.lines = self.lines.checked_sub(list.len().max(1))?;
        Some(fix())
    }
}

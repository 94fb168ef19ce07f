//! Values in canonical spelling, if that certainly does not change their meaning.

use std::borrow::Cow;

use super::text::ArrangedKey;
use crate::literal::{self, Quirk, Quirks};
use crate::model::{Access, DataType, Device, Field, ModulePart, ObjectType, Part, TypeKind};

/// The value of a key in a part.
pub(super) fn value<'a>(device: &Device, part: &Part, key: &ArrangedKey<'a>) -> Cow<'a, str> {
    let spelled = match key.field {
        Some(Field::AccessType) => {
            let access = Access::from_name(key.value);
            return Cow::Borrowed(access.map_or(key.value, |access| access.name()));
        }
        Some(field) => of_field(device, part, field, key.value),
        None => of_item(device, part, key.name, key.value),
    };
    spelled.map_or(Cow::Borrowed(key.value), Cow::Owned)
}

fn of_field(device: &Device, part: &Part, field: &Field, text: &str) -> Option<String> {
    match field {
        Field::ObjectType if is_spelled(text, 1) => None,
        Field::ObjectType => {
            let code = u8::try_from(plain_number(text)?).ok()?;
            ObjectType::from_code(code).map(|_| format!("0x{code:X}"))
        }
        Field::DataType => index(text),
        Field::VendorNumber
        | Field::ProductNumber
        | Field::RevisionNumber
        | Field::ObjFlags
        | Field::CompactPdo
        | Field::InvertedSrad => plain_number(text).and_then(|_| hex(text)),
        Field::DefaultValue | Field::LowLimit | Field::HighLimit | Field::ParameterValue
            if has_spellings(text) =>
        {
            of_type(device.data_type_of(part, field)?, text)
        }
        _ => None,
    }
}

fn of_item(device: &Device, part: &Part, key: &str, text: &str) -> Option<String> {
    Field::item(key)?;
    match part {
        Part::List(_)
        | Part::Links(_)
        | Part::Module(_, ModulePart::FixedObjects | ModulePart::SubExtends) => index(text),
        Part::CompactValues(index) if has_spellings(text) => {
            of_type(device.object(*index)?.main.data_type?, text)
        }
        _ => None,
    }
}

/// Whether a number may have several spellings: only hexadecimal digits and `$NODEID` have.
fn has_spellings(text: &str) -> bool {
    text.contains(['x', 'X', '$'])
}

/// A number or a formula of an integer type.
fn of_type(data_type: DataType, text: &str) -> Option<String> {
    if !matches!(data_type.kind(), TypeKind::Signed(_) | TypeKind::Unsigned(_)) {
        return None;
    }
    let mut quirks = Quirks::default();
    literal::value_in_line(text, Some(data_type), &mut quirks).ok()?;
    if quirks.has(Quirk::TrailingComment) {
        return None;
    }
    let turned = [Quirk::NodeIdLast, Quirk::FormulaSpelling]
        .into_iter()
        .find(|quirk| quirks.has(*quirk))
        .and_then(|quirk| literal::respell(text, quirk, None));
    let text = turned.as_deref().unwrap_or(text);
    let terms: Vec<String> =
        text.split('+').map(|term| hex(term).unwrap_or_else(|| term.to_owned())).collect();
    Some(terms.join("+"))
}

/// Whether a text is already a hex number with so many digits, in canonical spelling.
fn is_spelled(text: &str, count: usize) -> bool {
    let is_digit = |byte: u8| matches!(byte, b'0'..=b'9' | b'A'..=b'F');
    let digits = text.strip_prefix("0x");
    digits.is_some_and(|digits| digits.len() == count && digits.bytes().all(is_digit))
}

/// An index with four digits.
fn index(text: &str) -> Option<String> {
    if is_spelled(text, 4) {
        return None;
    }
    let number = u16::try_from(plain_number(text)?).ok()?;
    Some(format!("0x{number:04X}"))
}

/// A number in a spelling of the standard that all readers accept.
fn plain_number(text: &str) -> Option<i128> {
    let mut quirks = Quirks::default();
    let number = literal::integer_in_line(text, 0, u64::from(u32::MAX), &mut quirks).ok()?;
    quirks.is_empty().then_some(number)
}

/// A hex number with `0x` and capital letters.
fn hex(text: &str) -> Option<String> {
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))?;
    let is_hex = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    is_hex.then(|| format!("0x{}", digits.to_ascii_uppercase()))
}

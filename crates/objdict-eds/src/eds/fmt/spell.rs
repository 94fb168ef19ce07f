//! Values in canonical spelling, if that certainly does not change their meaning.

use std::borrow::Cow;

use super::text::ArrangedKey;
use crate::literal::{self, Quirk, Quirks};
use crate::model::{Access, DataType, Device, Field, ModulePart, ObjectType, Part, TypeKind};

/// The value of a key in a part; the key belongs to a field unless the standard does not define it.
pub(super) fn value<'a>(
    device: &Device,
    part: &Part,
    field: Option<&Field>,
    key: &ArrangedKey<'a>,
) -> Cow<'a, str> {
    let spelled = match field {
        Some(field) => of_field(device, part, field, key.value),
        None => of_item(device, part, key.name, key.value),
    };
    spelled.map_or(Cow::Borrowed(key.value), Cow::Owned)
}

fn of_field(device: &Device, part: &Part, field: &Field, text: &str) -> Option<String> {
    match field {
        Field::AccessType => Access::from_name(text).map(|access| access.name().to_owned()),
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
        Field::DefaultValue | Field::LowLimit | Field::HighLimit | Field::ParameterValue => {
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
        Part::CompactValues(index) => of_type(device.object(*index)?.main.data_type?, text),
        _ => None,
    }
}

/// A number or a formula of an integer type.
fn of_type(data_type: DataType, text: &str) -> Option<String> {
    // only hexadecimal digits and `$NODEID` have several spellings
    if !text.contains(['x', 'X', '$']) {
        return None;
    }
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

/// An index with four digits.
fn index(text: &str) -> Option<String> {
    let is_digit = |byte: &u8| matches!(byte, b'0'..=b'9' | b'A'..=b'F');
    if text
        .strip_prefix("0x")
        .is_some_and(|digits| digits.len() == 4 && digits.bytes().all(|byte| is_digit(&byte)))
    {
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

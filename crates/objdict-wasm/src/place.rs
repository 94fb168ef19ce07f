//! Places of the model as findings spell them.

use objdict::model::{Field, Part, Place};

/// The place of such a text as `0x1018sub1 / DefaultValue`; `None` for parts that are not edited as fields.
pub(crate) fn place(text: &str) -> Option<Place> {
    let (part, field) = match text.split_once(" / ") {
        Some((part, field)) => (part, Some(Field::from_name(field))),
        None => (text, None),
    };
    let place = Place::of(self::part(part)?);
    Some(match field {
        Some(field) => place.field(field),
        None => place,
    })
}

fn part(text: &str) -> Option<Part> {
    let parts = [Part::FileInfo, Part::DeviceInfo, Part::Commissioning, Part::DummyUsage];
    let digits = |digits: &str| digits.bytes().all(|byte| byte.is_ascii_hexdigit());
    if let Some(part) = parts.into_iter().find(|part| part.to_string() == text) {
        return Some(part);
    }
    let (index, sub) = match text.strip_prefix("0x")?.split_once("sub") {
        Some((index, sub)) => (index, Some(sub)),
        None => (text.strip_prefix("0x")?, None),
    };
    let index = u16::from_str_radix(index, 16).ok().filter(|_| digits(index))?;
    Some(match sub {
        Some(sub) => Part::Entry(index, u8::from_str_radix(sub, 16).ok().filter(|_| digits(sub))?),
        None => Part::Object(index),
    })
}

#[cfg(test)]
mod tests {
    use super::place;

    #[test]
    fn places_are_read_as_they_are_written() {
        for text in ["0x1018sub1 / DefaultValue", "0x6041", "FileInfo / FileName", "0x1A00subA"] {
            assert_eq!(place(text).map(|place| place.to_string()).as_deref(), Some(text));
        }
        for text in ["", "0x", "0x+1", "0x12345", "0x1000sub", "Tools"] {
            assert_eq!(place(text), None, "{text}");
        }
    }
}

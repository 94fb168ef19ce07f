//! Values that an EDS has too: from attributes to fields of the model and back.

use std::borrow::Cow;

use super::defaults;
use super::element::SchemaAttribute;
use super::schema::TextKind;
use crate::diagnostic::Findings;
use crate::literal::{self, Quirks};
use crate::model::{
    Access, ClockTime, Commissioning, DataType, Date, DeviceClass, DeviceInfo, Entry, FileInfo,
    InvalidValues, ObjFlags, ObjectType, PdoMapping, Reason, Value,
};
use crate::source::Span;
use crate::xml::{self, Element};

/// A string with its position.
#[derive(Clone, Debug)]
pub(crate) struct PlacedText<'a> {
    /// For the text of an element: without surrounding whitespace.
    pub(crate) text: Cow<'a, str>,
    /// The position of the text.
    pub(crate) at: Span,
}

/// A part of the model with fields that an EDS has too.
pub(crate) trait SharedFields {
    /// The strings that are not valid in their fields.
    fn invalid_values(&self) -> &InvalidValues;

    /// Mutable access for reading.
    fn invalid_values_mut(&mut self) -> &mut InvalidValues;
}

macro_rules! facts {
    ($($Part:ty),+) => {$(
        impl SharedFields for $Part {
            fn invalid_values(&self) -> &InvalidValues {
                &self.invalid_values
            }

            fn invalid_values_mut(&mut self) -> &mut InvalidValues {
                &mut self.invalid_values
            }
        }
    )+};
}

facts! { Commissioning, DeviceInfo, Entry, FileInfo }

/// A field with one notation in CiA 311 and several in real files.
pub(crate) trait Fact {
    /// Reads a non-empty string.
    fn take(
        &mut self,
        text: &PlacedText<'_>,
        known: &SchemaAttribute,
        findings: &mut Findings,
    ) -> Result<(), Reason>;

    /// The string for the value; `None` without a value.
    fn text(&self, known: &SchemaAttribute) -> Option<String>;
}

impl<'a> PlacedText<'a> {
    /// The value of an attribute.
    pub(crate) fn of(attribute: xml::Attribute<'a>) -> Self {
        Self { text: attribute.value(), at: attribute.value_span() }
    }

    /// The text of an element, without surrounding whitespace.
    pub(crate) fn in_element(element: Element<'a>) -> Self {
        Self { text: trimmed(element.text()), at: element.text_span() }
    }

    /// The string without surrounding whitespace.
    pub(crate) fn trimmed(&self) -> &str {
        self.text.trim_ascii()
    }

    /// A whole number from 0 to `most`, in decimal or, with the prefix `0x`, in hex; `None` for an empty
    /// string.
    pub(crate) fn integer<T: TryFrom<i128>>(
        &self,
        most: u64,
        findings: &mut Findings,
    ) -> Result<Option<T>, Reason> {
        let text = self.trimmed();
        if text.is_empty() {
            return Ok(None);
        }
        let mut quirks = Quirks::default();
        let number = literal::integer(text, 0, most, &mut quirks)?;
        literal::spelling(text, self.at, quirks, None, findings);
        Ok(T::try_from(number).ok())
    }

    /// A keyword that `find` accepts; `None` for an empty string.
    pub(crate) fn word<T>(
        &self,
        find: impl FnOnce(&str) -> Option<T>,
        reason: Reason,
    ) -> Result<Option<T>, Reason> {
        match self.trimmed() {
            "" => Ok(None),
            text => find(text).map(Some).ok_or(reason),
        }
    }

    /// A number in hex, with or without `0x`, of at most `digits` digits.
    pub(crate) fn hex(&self, digits: usize) -> Result<Option<u32>, Reason> {
        self.word(|text| hex(text, digits), Reason::NotANumber)
    }

    /// A value of a data type; `None` for an empty string.
    pub(crate) fn value(
        &self,
        data_type: Option<DataType>,
        findings: &mut Findings,
    ) -> Result<Option<Value>, Reason> {
        self.value_as(data_type, |value, _| value, findings)
    }

    /// The high limit of an entry with these other values.
    pub(crate) fn high_limit(&self, entry: &Entry, findings: &mut Findings) -> Result<Option<Value>, Reason> {
        let meant = |value, quirks: &mut _| literal::high_limit(value, entry, quirks);
        self.value_as(entry.implied_type(), meant, findings)
    }

    fn value_as(
        &self,
        data_type: Option<DataType>,
        meant: impl FnOnce(Value, &mut Quirks) -> Value,
        findings: &mut Findings,
    ) -> Result<Option<Value>, Reason> {
        let Some(text) = stated_text(&self.text, data_type) else { return Ok(None) };
        let mut quirks = Quirks::default();
        let value = read_value(text, data_type, &mut quirks)?;
        let value = meant(value, &mut quirks);
        literal::spelling(text, self.at, quirks, Some(&value), findings);
        Ok(Some(value))
    }
}

/// A string without surrounding whitespace.
pub(crate) fn trimmed(text: Cow<'_, str>) -> Cow<'_, str> {
    match text {
        Cow::Borrowed(text) => Cow::Borrowed(text.trim_ascii()),
        Cow::Owned(text) => Cow::Owned(text.trim_ascii().to_owned()),
    }
}

/// Fields with a single keyword: how to read it, the reason if it is invalid, and how to write it.
macro_rules! words {
    ($($Value:ty: $reason:ident, $read:expr, $write:expr;)+) => {$(
        impl Fact for Option<$Value> {
            fn take(&mut self, text: &PlacedText<'_>, _: &SchemaAttribute, _: &mut Findings) -> Result<(), Reason> {
                *self = None;
                *self = text.word($read, Reason::$reason)?;
                Ok(())
            }

            fn text(&self, _: &SchemaAttribute) -> Option<String> {
                self.map($write)
            }
        }
    )+};
}

words! {
    bool: UnknownWord, boolean, |flag| flag.to_string();
    Date: NotADate, |text| literal::date(text).map(|(date, _)| date), Date::to_iso;
    ClockTime: NotAClockTime, literal::clock_time, |time| time.to_iso(true);
    DeviceClass: UnknownWord, DeviceClass::from_name, |class| class.name().to_owned();
    // editors for CANopenNode wrote `cons`
    Access: UnknownWord, |word| Access::from_name(if word == "cons" { "const" } else { word }), |access| attribute_access(access).to_owned();
    PdoMapping: UnknownWord, pdo_mapping, |mapping| mapping.name().to_owned();
    ObjFlags: NotANumber, |text| hex(text, 8).map(ObjFlags), |flags| match flags.0 {
        flags @ 0..=0xFFFF => format!("{flags:04X}"),
        flags => format!("{flags:08X}"),
    };
}

/// Two or four hex digits, or a name. Older versions of CANopenEditor write `0000` for a type that is not stated.
impl Fact for Option<DataType> {
    fn take(&mut self, text: &PlacedText<'_>, _: &SchemaAttribute, _: &mut Findings) -> Result<(), Reason> {
        *self = None;
        *self = text.word(data_type, Reason::NotANumber)?.filter(|data_type| data_type.0 != 0);
        Ok(())
    }

    fn text(&self, _: &SchemaAttribute) -> Option<String> {
        self.map(|data_type| format!("{:04X}", data_type.0))
    }
}

/// Numbers, and bit rates in kbit/s.
macro_rules! numbers {
    ($($Number:ty)+) => {$(
        impl Fact for Option<$Number> {
            fn take(&mut self, text: &PlacedText<'_>, known: &SchemaAttribute, findings: &mut Findings) -> Result<(), Reason> {
                *self = None;
                let most = known.most.unwrap_or(u64::from(<$Number>::MAX));
                *self = match known.kind {
                    // version 1.0 writes 0 for a node whose bit rate is unknown
                    TextKind::Rate => text
                        .word(|text| bit_rate(text)?.try_into().ok(), Reason::UnknownWord)?
                        .filter(|kbit| *kbit != 0),
                    _ => text.integer(most, findings)?,
                };
                Ok(())
            }

            fn text(&self, known: &SchemaAttribute) -> Option<String> {
                self.map(|number| if let TextKind::Rate = known.kind { format!("{number} Kbps") } else { number.to_string() })
            }
        }
    )+};
}

numbers! { u8 u16 u32 }

impl Fact for Option<String> {
    fn take(&mut self, text: &PlacedText<'_>, _: &SchemaAttribute, _: &mut Findings) -> Result<(), Reason> {
        *self = Some(text.trimmed().to_owned());
        Ok(())
    }

    fn text(&self, _: &SchemaAttribute) -> Option<String> {
        self.clone()
    }
}

/// Keywords separated by spaces.
impl Fact for Vec<Box<str>> {
    fn take(&mut self, text: &PlacedText<'_>, _: &SchemaAttribute, _: &mut Findings) -> Result<(), Reason> {
        *self = text.text.split_ascii_whitespace().map(Into::into).collect();
        Ok(())
    }

    fn text(&self, _: &SchemaAttribute) -> Option<String> {
        (!self.is_empty()).then(|| self.join(" "))
    }
}

/// `version.revision`, or only the version.
impl Fact for FileInfo {
    fn take(&mut self, text: &PlacedText<'_>, _: &SchemaAttribute, _: &mut Findings) -> Result<(), Reason> {
        // only numbers that are written back unchanged
        let plain = |text: &str| text.parse().ok().filter(|number: &u8| number.to_string() == text);
        let (version, revision) = text.trimmed().split_once('.').unwrap_or((text.trimmed(), ""));
        let has_revision = text.trimmed().contains('.');
        let (number, second) = (plain(version), plain(revision));
        if number.is_none() && !version.is_empty() || second.is_none() && has_revision {
            return Err(Reason::NotANumber);
        }
        (self.file_version, self.file_revision) = (number, second);
        Ok(())
    }

    fn text(&self, _: &SchemaAttribute) -> Option<String> {
        let version = self.file_version.map(|version| version.to_string());
        match self.file_revision {
            Some(revision) => Some(format!("{}.{revision}", version.unwrap_or_default())),
            None => version,
        }
    }
}

/// A decimal object code, or the name of an object type.
impl Fact for Option<ObjectType> {
    fn take(&mut self, text: &PlacedText<'_>, _: &SchemaAttribute, _: &mut Findings) -> Result<(), Reason> {
        let word = text.trimmed();
        if matches!(word, "" | defaults::ORPHAN) {
            return Ok(());
        }
        // `REC` is CANopenNode's name of RECORD
        let word = if word == "REC" { ObjectType::Record.name() } else { word };
        let named = |object_type: &ObjectType| object_type.name().eq_ignore_ascii_case(word);
        let code = || literal::integer(word, 0, 255, &mut Quirks::default());
        *self = match (0..=9).filter_map(ObjectType::from_code).find(named) {
            Some(named) => Some(named),
            None => u8::try_from(code()?).ok().and_then(ObjectType::from_code),
        };
        self.map(|_| ()).ok_or(Reason::UnknownWord)
    }

    fn text(&self, _: &SchemaAttribute) -> Option<String> {
        self.map(|object_type| object_type.code().to_string())
    }
}

fn data_type(word: &str) -> Option<DataType> {
    let index = hex(word, 4).and_then(|index| u16::try_from(index).ok());
    index.map(DataType).or_else(|| DataType::from_name(word))
}

/// The access type as an attribute: process inputs and outputs are only known to the parameter.
const fn attribute_access(access: Access) -> &'static str {
    match access {
        Access::Rwr | Access::Rww => Access::Rw.name(),
        access => access.name(),
    }
}

fn pdo_mapping(word: &str) -> Option<PdoMapping> {
    let known = PdoMapping::ALL.into_iter().find(|mapping| mapping.name().eq_ignore_ascii_case(word));
    // the flag of an EDS
    let flag = || boolean(word).map(|yes| if yes { PdoMapping::Optional } else { PdoMapping::No });
    known.or_else(flag)
}

/// The part of a string that is the value: surrounding whitespace is significant only in strings. `None`
/// for an empty string, and for the `0` that CANopenNode editors write for a DOMAIN, which has no value.
pub fn stated_text(text: &str, data_type: Option<DataType>) -> Option<&str> {
    let is_string = matches!(data_type, Some(DataType::VISIBLE_STRING | DataType::UNICODE_STRING));
    let text = if is_string { text } else { text.trim_ascii() };
    let is_filler = data_type == Some(DataType::DOMAIN) && text == "0";
    Some(text).filter(|text| !text.is_empty() && !is_filler)
}

/// The value of a string. Spaces between the bytes of an OCTET_STRING are not a quirk: without them CANopenEditor
/// reads a single byte.
pub fn read_value(text: &str, data_type: Option<DataType>, quirks: &mut Quirks) -> Result<Value, Reason> {
    let mut bytes = text.split_ascii_whitespace();
    let are_pairs = data_type == Some(DataType::OCTET_STRING) && bytes.all(|byte| byte.len() == 2);
    if are_pairs {
        let joined: String = text.split_ascii_whitespace().collect();
        return literal::value(&joined, data_type, quirks);
    }
    literal::value(text, data_type, quirks)
}

/// A number in hex, with or without `0x`, of at most `digits` digits after leading zeros: old editors write a
/// sub-index as `0001`.
pub(crate) fn hex(text: &str, digits: usize) -> Option<u32> {
    let text = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
    let is_short = text.trim_start_matches('0').len() <= digits;
    let is_hex = is_short && !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_hexdigit());
    if is_hex { u32::from_str_radix(text, 16).ok() } else { None }
}

/// A Boolean of XML Schema, in upper or lower case.
pub(crate) fn boolean(text: &str) -> Option<bool> {
    match () {
        () if text == "1" || text.eq_ignore_ascii_case("true") => Some(true),
        () if text == "0" || text.eq_ignore_ascii_case("false") => Some(false),
        () => None,
    }
}

/// A bit rate: `250 Kbps`, or a notation of other tools.
pub(crate) fn bit_rate(text: &str) -> Option<u16> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let unit = text[digits..].trim_ascii().to_ascii_lowercase();
    let number: u32 = text[..digits].parse().ok()?;
    let kbit = match unit.as_str() {
        "" | "kbps" | "kbit/s" | "kbits/s" | "kb/s" | "kbit" | "kbaud" | "k" => number,
        "mbps" | "mbit/s" => number.checked_mul(1000)?,
        "bps" | "bit/s" if number.is_multiple_of(1000) => number / 1000,
        _ => return None,
    };
    u16::try_from(kbit).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bit_rates_in_the_spellings_of_real_files() {
        for text in ["250 Kbps", "250 kbit/s", "250Kbps", "250", "250000 bit/s"] {
            assert_eq!(bit_rate(text), Some(250), "{text}");
        }
        assert_eq!(bit_rate("1 Mbit/s"), Some(1000));
        for text in ["", "fast", "250 rpm", "70000 Kbps", "-5 Kbps", "1.5 Mbps"] {
            assert_eq!(bit_rate(text), None, "{text}");
        }
    }

    #[test]
    fn hex_digits_with_and_without_a_prefix() {
        assert_eq!(hex("1018", 4), Some(0x1018));
        assert_eq!(hex("0x1a", 4), Some(0x1A));
        assert_eq!((hex("0001", 2), hex("00000", 2), hex("0100", 2)), (Some(1), Some(0), None));
        for text in ["", "0x", "1 8", "+18", "12345", "10G0"] {
            assert_eq!(hex(text, 4), None, "{text}");
        }
    }
}

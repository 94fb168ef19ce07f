//! Parses values.

use crate::model::{DataType, Entry, Reason, Time, TypeKind, Value, hex};

/// An accepted spelling that is not standard, or that other tools interpret differently.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u16)]
pub enum Quirk {
    /// A leading zero: octal in the standard, decimal in some tools.
    Octal = 1 << 0,
    /// A leading zero that does not change the number: `07`.
    LeadingZero = 1 << 1,
    /// `0x180+$NODEID` instead of `$NODEID+0x180`.
    NodeIdLast = 1 << 2,
    /// `$NODEID` with spaces around the `+` or in different case.
    FormulaSpelling = 1 << 3,
    /// A comment after a number or keyword.
    TrailingComment = 1 << 4,
    /// A suffix of the C language: `0x10LL`, `1.0f`.
    CSuffix = 1 << 5,
    /// A REAL as the hex digits of its bits.
    RealAsBits = 1 << 6,
    /// A negative number as hex digits of two's complement.
    TwosComplement = 1 << 7,
    /// A quoted string.
    Quoted = 1 << 8,
    /// `true` or `false` for 1 or 0.
    BooleanWord = 1 << 9,
    /// Bytes with a `0x` prefix or spaces between them.
    DecoratedBytes = 1 << 10,
    /// A high limit in hex digits that exceeds its signed type, and as two's complement is less than other
    /// values.
    AboveType = 1 << 11,
}

/// A set of [`Quirk`]s.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quirks(u16);

impl Quirks {
    /// Whether the set is empty.
    #[inline]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether a quirk is in the set.
    pub const fn has(self, quirk: Quirk) -> bool {
        self.0 & quirk as u16 != 0
    }

    fn add(&mut self, quirk: Quirk) {
        self.0 |= quirk as u16;
    }
}

/// The value of `text`, which is not empty, as `data_type`. Non-static types result in [`Value::Raw`].
///
/// # Errors
/// The reason why the text is not a valid value of the type.
pub fn value(text: &str, data_type: Option<DataType>, quirks: &mut Quirks) -> Result<Value, Reason> {
    let Some(data_type) = data_type else { return Ok(Value::Raw(text.into())) };
    match data_type.kind() {
        TypeKind::Signed(_) | TypeKind::Unsigned(_) => integer_value(text, data_type, quirks),
        TypeKind::Boolean => boolean(text, quirks),
        TypeKind::Real32 => real32(text, quirks),
        TypeKind::Real64 => real64(text, quirks),
        TypeKind::VisibleString | TypeKind::UnicodeString => Ok(Value::Text(unquote(text, quirks).into())),
        TypeKind::OctetString | TypeKind::Domain => bytes(text, quirks),
        TypeKind::TimeOfDay | TypeKind::TimeDifference => time(text, quirks),
        TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved => Ok(Value::Raw(text.into())),
    }
}

/// The high limit of an entry, read as [`value`] with these quirks. If its two's complement is less than the low limit,
/// the default or the configured value, or is -1 without a low limit, the digits mean a number above the type: the
/// limit is then the maximum of the type, as in Lely.
pub fn high_limit(read: Value, entry: &Entry, quirks: &mut Quirks) -> Value {
    let others = [entry.low_limit.as_ref(), entry.default.as_ref(), entry.configured_value()];
    let is_below = |other: &Value| other.as_integer() > read.as_integer();
    let is_lone = entry.low_limit.is_none() && read.as_integer() == Some(-1);
    if !quirks.has(Quirk::TwosComplement) || !(is_lone || others.into_iter().flatten().any(is_below)) {
        return read;
    }
    let data_type = entry.implied_type();
    let largest =
        data_type.and_then(|data_type| Value::from_integer(data_type.integer_range()?.1, data_type));
    quirks.0 &= !(Quirk::TwosComplement as u16);
    quirks.add(Quirk::AboveType);
    largest.unwrap_or(read)
}

/// A whole number in decimal, hex or octal, signed or not, within `low..=high`.
///
/// # Errors
/// The reason why the text is not such a number.
#[inline]
pub fn integer(text: &str, low: i64, high: u64, quirks: &mut Quirks) -> Result<i128, Reason> {
    match small_number(text.as_bytes()) {
        Some(number) if low <= i64::from(number) && u64::from(number) <= high => Ok(number.into()),
        _ => any_integer(text, low, high, quirks),
    }
}

fn any_integer(text: &str, low: i64, high: u64, quirks: &mut Quirks) -> Result<i128, Reason> {
    let number = number(text, quirks).map_err(|reason| match reason {
        Reason::OutOfRange { .. } => Reason::OutOfRange { low, high },
        other => other,
    })?;
    if number.value < i128::from(low) || number.value > i128::from(high) {
        return Err(Reason::OutOfRange { low, high });
    }
    Ok(number.value)
}

/// The part of a number or keyword before a trailing comment, without trailing spaces. The comment begins after a
/// space, so that no number is shortened; a `;` also begins one if it is followed by a space or ends the line.
pub fn strip_comment<'a>(text: &'a str, quirks: &mut Quirks) -> &'a str {
    let is_blank = |byte: Option<&u8>| byte.is_some_and(|byte| matches!(byte, b' ' | b'\t'));
    let bytes = text.as_bytes();
    let begins = |&at: &usize| {
        let is_mark = bytes[at] != b'/' || bytes.get(at + 1) == Some(&b'/');
        let next = bytes.get(at + 1);
        is_mark && (is_blank(bytes.get(at - 1)) || bytes[at] == b';' && (next.is_none() || is_blank(next)))
    };
    match memchr::memchr3_iter(b';', b'#', b'/', bytes).filter(|at| *at > 0).find(begins) {
        Some(at) => {
            quirks.add(Quirk::TrailingComment);
            text[..at].trim_ascii_end()
        }
        None => text,
    }
}

/// The result of `read` for a text in a line, or for the part before a comment.
fn in_line<T>(
    text: &str,
    quirks: &mut Quirks,
    read: impl Fn(&str, &mut Quirks) -> Result<T, Reason>,
) -> Result<T, Reason> {
    let mut whole = *quirks;
    let result = read(text, &mut whole);
    let core = if result.is_ok() { text } else { strip_comment(text, quirks) };
    if core.len() < text.len() {
        return read(core, quirks);
    }
    *quirks = whole;
    result
}

/// The [`value`] of a string in a line of an EDS or DCF, which a comment may follow.
///
/// # Errors
/// The reason why the text is not a valid value of the type.
pub fn value_in_line(text: &str, data_type: Option<DataType>, quirks: &mut Quirks) -> Result<Value, Reason> {
    in_line(text, quirks, |text, quirks| value(text, data_type, quirks))
}

/// The [`integer`] of a string in a line of an EDS or DCF, which a comment may follow.
///
/// # Errors
/// The reason why the text is not such a number.
#[inline]
pub fn integer_in_line(text: &str, low: i64, high: u64, quirks: &mut Quirks) -> Result<i128, Reason> {
    match small_number(text.as_bytes()) {
        Some(number) if low <= i64::from(number) && u64::from(number) <= high => Ok(number.into()),
        _ => in_line(text, quirks, |text, quirks| any_integer(text, low, high, quirks)),
    }
}

/// A number as written, because hex digits may be two's complement.
struct WrittenNumber {
    value: i128,
    hex: bool,
}

/// A short number in decimal without leading zero, or hex: the fast path for nearly all numbers. [`integer`]
/// accepts a superset.
#[inline]
pub fn small_number(text: &[u8]) -> Option<u32> {
    match text {
        [digit @ b'0'..=b'9'] => Some(u32::from(digit - b'0')),
        [b'0', b'x' | b'X', hex @ ..] if matches!(hex.len(), 1..=8) => {
            let digit = |byte: u8| (byte as char).to_digit(16);
            hex.iter().try_fold(0, |number, byte| Some(number << 4 | digit(*byte)?))
        }
        [b'1'..=b'9', ..] if text.len() < 10 => {
            let digit = |byte: u8| byte.is_ascii_digit().then(|| u32::from(byte - b'0'));
            text.iter().try_fold(0, |number, byte| Some(number * 10 + digit(*byte)?))
        }
        _ => None,
    }
}

/// The value of `text` as an integer of the given type, if it is a [small number](small_number) within the
/// range of the type in any spelling. [`value`] accepts a superset.
#[inline]
pub fn plain_value(text: &str, data_type: Option<DataType>) -> Option<Value> {
    let number = u64::from(small_number(text.as_bytes())?);
    match data_type?.kind() {
        TypeKind::Unsigned(bits) if number >> bits.min(63) == 0 => Some(Value::Unsigned(number)),
        TypeKind::Signed(bits) if number >> (bits - 1) == 0 => Some(Value::Signed(number as i64)),
        _ => None,
    }
}

/// Tries the common spellings first, and the others only if these fail.
fn number(text: &str, quirks: &mut Quirks) -> Result<WrittenNumber, Reason> {
    match plain_number(text) {
        Ok(number) => Ok(number),
        Err(_) => number_with_quirks(text, quirks),
    }
}

/// Decimal without leading zero, or hex; with or without a sign.
fn plain_number(text: &str) -> Result<WrittenNumber, Reason> {
    let (negative, digits) = match text.as_bytes() {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        all => (false, all),
    };
    let (radix, digits) = match digits {
        [b'0', b'x' | b'X', hex @ ..] => (16, hex),
        [b'0', _, ..] => return Err(Reason::NotANumber),
        _ => (10, digits),
    };
    let value = i128::from(magnitude(digits, radix)?);
    Ok(WrittenNumber { value: if negative { -value } else { value }, hex: radix == 16 })
}

fn magnitude(digits: &[u8], radix: u32) -> Result<u64, Reason> {
    let mut value = 0u64;
    for &byte in digits {
        let digit = char::from(byte).to_digit(radix).ok_or(Reason::NotANumber)?;
        let shifted =
            value.checked_mul(u64::from(radix)).and_then(|value| value.checked_add(u64::from(digit)));
        value = shifted.ok_or(Reason::OutOfRange { low: i64::MIN, high: u64::MAX })?;
    }
    if digits.is_empty() { Err(Reason::NotANumber) } else { Ok(value) }
}

fn number_with_quirks(text: &str, quirks: &mut Quirks) -> Result<WrittenNumber, Reason> {
    let too_large = match plain_number(text) {
        Err(reason @ Reason::OutOfRange { .. }) => return Err(reason),
        Err(reason) => reason,
        Ok(number) => return Ok(number),
    };
    let without_suffix = text.trim_end_matches(['u', 'U', 'l', 'L']);
    if without_suffix.len() < text.len()
        && let Ok(number) = plain_number(without_suffix)
    {
        quirks.add(Quirk::CSuffix);
        return Ok(number);
    }
    let (negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text),
    };
    if !digits.starts_with('0') || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(too_large);
    }
    let octal = magnitude(digits.as_bytes(), 8).map_err(|reason| match reason {
        Reason::NotANumber => Reason::NotOctal,
        other => other,
    })?;
    let same = magnitude(digits.as_bytes(), 10) == Ok(octal);
    quirks.add(if same { Quirk::LeadingZero } else { Quirk::Octal });
    let value = i128::from(octal);
    Ok(WrittenNumber { value: if negative { -value } else { value }, hex: false })
}

fn integer_value(text: &str, data_type: DataType, quirks: &mut Quirks) -> Result<Value, Reason> {
    if text.contains('$') {
        return formula(text, quirks).map(Value::NodeId);
    }
    let number = number(text, quirks).map_err(|reason| match reason {
        Reason::OutOfRange { .. } => out_of_range(data_type),
        other => other,
    })?;
    let wrapped = match data_type.kind() {
        TypeKind::Signed(bits)
            if number.hex && number.value >= 1 << (bits - 1) && number.value < 1 << bits =>
        {
            quirks.add(Quirk::TwosComplement);
            number.value - (1 << bits)
        }
        _ => number.value,
    };
    Value::from_integer(wrapped, data_type).ok_or_else(|| out_of_range(data_type))
}

fn out_of_range(data_type: DataType) -> Reason {
    let (low, high) = data_type.integer_range().unwrap_or_default();
    Reason::OutOfRange {
        low: i64::try_from(low).unwrap_or(i64::MIN),
        high: u64::try_from(high).unwrap_or(u64::MAX),
    }
}

const NODE_ID: &str = "$NODEID";

/// The number that a formula adds to the node-ID.
fn formula(text: &str, quirks: &mut Quirks) -> Result<u64, Reason> {
    let mut sum = 0u64;
    let mut node_ids = 0;
    for (position, term) in text.split('+').enumerate() {
        let trimmed = term.trim_ascii();
        if trimmed.len() < term.len() {
            quirks.add(Quirk::FormulaSpelling);
        }
        if trimmed.eq_ignore_ascii_case(NODE_ID) {
            node_ids += 1;
            if trimmed != NODE_ID {
                quirks.add(Quirk::FormulaSpelling);
            }
            if position > 0 {
                quirks.add(Quirk::NodeIdLast);
            }
            continue;
        }
        let number = number(trimmed, quirks).ok().and_then(|number| u64::try_from(number.value).ok());
        sum = number.and_then(|number| sum.checked_add(number)).ok_or(Reason::NotAFormula)?;
    }
    if node_ids == 1 { Ok(sum) } else { Err(Reason::NotAFormula) }
}

fn boolean(text: &str, quirks: &mut Quirks) -> Result<Value, Reason> {
    if text.contains('$') {
        return Err(Reason::FormulaForType);
    }
    for (word, value) in [("true", true), ("false", false)] {
        if text.eq_ignore_ascii_case(word) {
            quirks.add(Quirk::BooleanWord);
            return Ok(Value::Boolean(value));
        }
    }
    integer(text, 0, 1, quirks).map(|number| Value::Boolean(number == 1))
}

/// The bits of a hex literal, or the decimal text of a REAL without C suffix.
fn real_text<'a>(text: &'a str, quirks: &mut Quirks) -> Result<ParsedReal<'a>, Reason> {
    if text.contains('$') {
        return Err(Reason::FormulaForType);
    }
    if let Some(digits) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        quirks.add(Quirk::RealAsBits);
        return magnitude(digits.as_bytes(), 16).map(ParsedReal::Bits).map_err(|_| Reason::NotReal);
    }
    let decimal = match text.strip_suffix(['f', 'F']) {
        Some(without) => {
            quirks.add(Quirk::CSuffix);
            without
        }
        None => text,
    };
    let is_decimal =
        decimal.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'e' | b'E'));
    if is_decimal { Ok(ParsedReal::Decimal(decimal)) } else { Err(Reason::NotReal) }
}

enum ParsedReal<'a> {
    Bits(u64),
    Decimal(&'a str),
}

fn real32(text: &str, quirks: &mut Quirks) -> Result<Value, Reason> {
    let value = match real_text(text, quirks)? {
        ParsedReal::Bits(bits) => f32::from_bits(u32::try_from(bits).map_err(|_| Reason::NotReal)?),
        ParsedReal::Decimal(decimal) => {
            decimal.parse().ok().filter(|v: &f32| v.is_finite()).ok_or(Reason::NotReal)?
        }
    };
    Ok(Value::Real32(value))
}

fn real64(text: &str, quirks: &mut Quirks) -> Result<Value, Reason> {
    let value = match real_text(text, quirks)? {
        ParsedReal::Bits(bits) => f64::from_bits(bits),
        ParsedReal::Decimal(decimal) => {
            decimal.parse().ok().filter(|v: &f64| v.is_finite()).ok_or(Reason::NotReal)?
        }
    };
    Ok(Value::Real64(value))
}

fn unquote<'a>(text: &'a str, quirks: &mut Quirks) -> &'a str {
    match text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')) {
        Some(inner) => {
            quirks.add(Quirk::Quoted);
            inner
        }
        None => text,
    }
}

fn bytes(text: &str, quirks: &mut Quirks) -> Result<Value, Reason> {
    if let Some(bytes) = hex::parse(text) {
        return Ok(Value::Bytes(bytes));
    }
    let plain: String = text.split_ascii_whitespace().collect();
    let plain = plain.strip_prefix("0x").or_else(|| plain.strip_prefix("0X")).unwrap_or(&plain);
    let bytes = hex::parse(plain).ok_or(Reason::NotHexBytes)?;
    quirks.add(Quirk::DecoratedBytes);
    Ok(Value::Bytes(bytes))
}

/// `days milliseconds`, twelve hex digits (the bytes on the wire), or a 48-bit integer. CiA 306-1 defines
/// none of them; real files use all three.
fn time(text: &str, quirks: &mut Quirks) -> Result<Value, Reason> {
    let time = if let Some((days, milliseconds)) = text.split_once([' ', '\t']) {
        let days =
            integer(days, 0, u64::from(u16::MAX), quirks).ok().and_then(|days| u16::try_from(days).ok());
        let milliseconds = integer(milliseconds.trim_ascii(), 0, 0x0FFF_FFFF, quirks).ok();
        let milliseconds = milliseconds.and_then(|milliseconds| u32::try_from(milliseconds).ok());
        days.zip(milliseconds).map(|(days, milliseconds)| Time { days, milliseconds })
    } else if let Some(bytes) = hex::parse(text).filter(|bytes| bytes.len() == 6) {
        wire_time(&bytes)
    } else {
        let number =
            integer(text, 0, (1 << 48) - 1, quirks).ok().and_then(|number| u64::try_from(number).ok());
        number.and_then(|number| wire_time(&number.to_le_bytes()[..6]))
    };
    time.map(Value::Time).ok_or(Reason::NotATime)
}

/// The time of six bytes; `None` if void bits are set, which would be lost.
fn wire_time(bytes: &[u8]) -> Option<Time> {
    let bytes: [u8; 6] = bytes.try_into().ok()?;
    Some(Time::from_bytes(bytes)).filter(|time| time.to_bytes() == bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, data_type: DataType) -> (Result<Value, Reason>, Quirks) {
        let mut quirks = Quirks::default();
        (value(text, Some(data_type), &mut quirks), quirks)
    }

    fn clean(text: &str, data_type: DataType) -> Value {
        let (value, quirks) = read(text, data_type);
        assert!(quirks.is_empty(), "{text}: {quirks:?}");
        value.unwrap()
    }

    fn quirky(text: &str, data_type: DataType, quirk: Quirk) -> Value {
        let (value, quirks) = read(text, data_type);
        assert!(quirks.has(quirk), "{text}: {quirks:?}");
        value.unwrap()
    }

    #[test]
    fn integers_in_the_standard_spellings() {
        assert_eq!(clean("0x0A", DataType::UNSIGNED8), Value::Unsigned(10));
        assert_eq!(clean("-128", DataType::INTEGER8), Value::Signed(-128));
        assert_eq!(clean("18446744073709551615", DataType::UNSIGNED64), Value::Unsigned(u64::MAX));
        assert_eq!(clean("0", DataType::BOOLEAN), Value::Boolean(false));
    }

    #[test]
    fn what_does_not_fit_never_wraps() {
        let out = |low, high| Err(Reason::OutOfRange { low, high });
        assert_eq!(read("256", DataType::UNSIGNED8).0, out(0, 255));
        assert_eq!(read("-1", DataType::UNSIGNED8).0, out(0, 255));
        assert_eq!(read("0x1FF", DataType::INTEGER8).0, out(-128, 127));
        assert_eq!(read("18446744073709551616", DataType::UNSIGNED64).0, out(0, u64::MAX));
        assert_eq!(read("1e39", DataType::REAL32).0, Err(Reason::NotReal));
        assert_eq!(read("inf", DataType::REAL64).0, Err(Reason::NotReal));
    }

    #[test]
    fn other_spellings_are_understood() {
        assert_eq!(quirky("010", DataType::UNSIGNED8, Quirk::Octal), Value::Unsigned(8));
        assert_eq!(quirky("07", DataType::UNSIGNED8, Quirk::LeadingZero), Value::Unsigned(7));
        assert_eq!(quirky("0xFFFF", DataType::INTEGER16, Quirk::TwosComplement), Value::Signed(-1));
        assert_eq!(quirky("0x10LL", DataType::UNSIGNED64, Quirk::CSuffix), Value::Unsigned(16));
        assert_eq!(quirky("true", DataType::BOOLEAN, Quirk::BooleanWord), Value::Boolean(true));
        assert_eq!(read("018", DataType::UNSIGNED8).0, Err(Reason::NotOctal));
    }

    #[test]
    fn a_comment_begins_after_a_blank_and_in_lines_alone() {
        let line = |text| {
            let mut quirks = Quirks::default();
            (
                value_in_line(text, Some(DataType::UNSIGNED8), &mut quirks).ok(),
                quirks.has(Quirk::TrailingComment),
            )
        };
        for text in ["5 # five", "5 //", "5\t;five", "5; five", "5;", "5 ;# x"] {
            assert_eq!(line(text), (Some(Value::Unsigned(5)), true), "{text}");
            assert_eq!(read(text, DataType::UNSIGNED8).0, Err(Reason::NotANumber), "{text}");
        }
        for text in ["5#3", "5;3", "5//3", "5#", "5 /3", "5/ / 3", "; 5", "# 5", "16#5 # x"] {
            assert_eq!(line(text).0, None, "{text}");
        }
        assert_eq!(
            integer_in_line("5 # five", 0, 4, &mut Quirks::default()),
            Err(Reason::OutOfRange { low: 0, high: 4 })
        );
    }

    #[test]
    fn a_high_limit_is_not_below_the_low_limit_or_the_default() {
        let limit = |text: &str, low: Option<i64>, default: Option<i64>| {
            let value = |number: i64| Value::Signed(number);
            let entry = Entry {
                data_type: Some(DataType::INTEGER16),
                low_limit: low.map(value),
                default: default.map(value),
                ..Entry::default()
            };
            let (read, mut quirks) = read(text, DataType::INTEGER16);
            let limit = high_limit(read.unwrap(), &entry, &mut quirks);
            (limit.as_integer().unwrap(), quirks.has(Quirk::AboveType), quirks.has(Quirk::TwosComplement))
        };
        assert_eq!(limit("0xFFFF", Some(0), None), (32767, true, false));
        assert_eq!(limit("0xFFFF", None, Some(5)), (32767, true, false));
        assert_eq!(limit("0xFFF0", Some(-5), None), (32767, true, false));
        assert_eq!(limit("0xFFFF", None, None), (32767, true, false), "all bits are no limit");
        assert_eq!(limit("0xFFF0", None, Some(-20)), (-16, false, true));
        for (low, default) in [(Some(-5), None), (Some(-1), Some(-1)), (Some(-9), Some(-7))] {
            assert_eq!(limit("0xFFFF", low, default), (-1, false, true));
        }
        assert_eq!(limit("-1", Some(0), Some(0)), (-1, false, false), "a limit in decimal is what it is");
    }

    #[test]
    fn formulas_in_any_case_order_and_spacing() {
        assert_eq!(clean("$NODEID+0x180", DataType::UNSIGNED32), Value::NodeId(0x180));
        assert_eq!(clean("$NODEID", DataType::UNSIGNED8), Value::NodeId(0));
        assert_eq!(clean("$NODEID+0x80000000+0x180", DataType::UNSIGNED32), Value::NodeId(0x8000_0180));
        let spaced = quirky("$NodeId + 384", DataType::UNSIGNED32, Quirk::FormulaSpelling);
        assert_eq!(spaced, Value::NodeId(0x180));
        assert_eq!(quirky("0x180+$NODEID", DataType::UNSIGNED32, Quirk::NodeIdLast), Value::NodeId(0x180));
        for text in ["$NODEID-1", "$NODEID*2", "$MY_NODE_ID+1", "$NODEID+$NODEID", "$NODEID+", "+$NODEID"] {
            assert_eq!(read(text, DataType::UNSIGNED32).0, Err(Reason::NotAFormula), "{text}");
        }
        assert_eq!(read("$NODEID+1", DataType::REAL32).0, Err(Reason::FormulaForType));
        assert_eq!(clean("$NODEID+1", DataType::VISIBLE_STRING), Value::Text("$NODEID+1".into()));
    }

    #[test]
    fn real_numbers_and_their_bits() {
        assert_eq!(clean("12.345", DataType::REAL32), Value::Real32(12.345));
        assert_eq!(clean("-1e3", DataType::REAL64), Value::Real64(-1000.0));
        assert_eq!(quirky("0x3F800000", DataType::REAL32, Quirk::RealAsBits), Value::Real32(1.0));
        assert_eq!(quirky("0.5f", DataType::REAL32, Quirk::CSuffix), Value::Real32(0.5));
    }

    #[test]
    fn texts_keep_semicolon_and_hash() {
        assert_eq!(clean("Motor #1; left", DataType::VISIBLE_STRING), Value::Text("Motor #1; left".into()));
        assert_eq!(quirky("\"IOCB\"", DataType::VISIBLE_STRING, Quirk::Quoted), Value::Text("IOCB".into()));
    }

    #[test]
    fn bytes_and_times() {
        assert_eq!(clean("01a1FF", DataType::OCTET_STRING), Value::Bytes([1, 0xA1, 0xFF].into()));
        assert_eq!(
            quirky("0x01 A1", DataType::DOMAIN, Quirk::DecoratedBytes),
            Value::Bytes([1, 0xA1].into())
        );
        assert_eq!(read("123", DataType::OCTET_STRING).0, Err(Reason::NotHexBytes));
        let time = Value::Time(Time { days: 2, milliseconds: 1000 });
        assert_eq!(clean("2 1000", DataType::TIME_OF_DAY), time);
        assert_eq!(clean("E80300000200", DataType::TIME_OF_DAY), time);
        assert_eq!(clean("0x2000003E8", DataType::TIME_DIFFERENCE), time);
        assert_eq!(read("FFFFFFFF0000", DataType::TIME_OF_DAY).0, Err(Reason::NotATime));
    }
}

//! Rewrites values in the spelling of the standard.

use super::{Quirk, Quirks, Spelling, print, strip_comment};
use crate::model::Value;

/// `text` without one of its quirks, if the value can be spelled without it; `value` is the parsed value.
/// Other quirks are kept.
pub fn respell(text: &str, quirk: Quirk, value: Option<&Value>) -> Option<String> {
    let core = strip_comment(text, &mut Quirks::default());
    let tail = &text[core.len()..];
    let printed = || value.map(|value| print(value, Spelling::default()));
    let respelled = match quirk {
        Quirk::TrailingComment => core.to_owned(),
        Quirk::Octal | Quirk::LeadingZero => terms(core, |term| without_zero(term, quirk)) + tail,
        Quirk::CSuffix => terms(core, |term| Some(without_suffix(term))) + tail,
        Quirk::NodeIdLast | Quirk::FormulaSpelling => formula(core)? + tail,
        Quirk::RealAsBits | Quirk::TwosComplement | Quirk::DecoratedBytes | Quirk::AboveType => {
            printed()? + tail
        }
        Quirk::BooleanWord => printed()?,
        Quirk::Quoted => unquoted(text)?.to_owned(),
    };
    (respelled != text).then_some(respelled)
}

/// The comment after a value, without its mark.
pub fn trailing_comment(text: &str) -> Option<&str> {
    let core = strip_comment(text, &mut Quirks::default());
    let comment = text[core.len()..].trim_start_matches([' ', '\t', ';', '#', '/']).trim_ascii();
    (core.len() < text.len()).then_some(comment)
}

/// The quoted string without quotes, if it has the same value.
pub(crate) fn unquoted(text: &str) -> Option<&str> {
    let inner = text.strip_prefix('"')?.strip_suffix('"')?;
    let is_plain = !inner.is_empty() && inner.trim_ascii() == inner && !inner.starts_with('"');
    is_plain.then_some(inner)
}

/// A number or formula with some of its terms respelled.
fn terms(core: &str, respell: impl Fn(&str) -> Option<String>) -> String {
    let terms = core.split('+').map(|term| {
        let trimmed = term.trim_ascii();
        match respell(trimmed).filter(|_| !trimmed.is_empty()) {
            Some(respelled) => term.replace(trimmed, &respelled),
            None => term.to_owned(),
        }
    });
    terms.collect::<Vec<_>>().join("+")
}

/// An octal number in hex, which is unambiguous; a meaningless leading zero is removed.
fn without_zero(term: &str, quirk: Quirk) -> Option<String> {
    let (sign, digits) = term.strip_prefix('-').map_or(("", term), |digits| ("-", digits));
    let is_padded = digits.len() > 1 && digits.starts_with('0') && digits.bytes().all(|b| b.is_ascii_digit());
    let number = u64::from_str_radix(digits, 8).ok().filter(|_| is_padded)?;
    let is_octal = digits.parse() != Ok(number);
    match quirk {
        Quirk::Octal if is_octal && sign.is_empty() => Some(format!("0x{number:X}")),
        Quirk::Octal if is_octal => Some(format!("-{number}")),
        Quirk::LeadingZero if !is_octal => Some(format!("{sign}{number}")),
        _ => None,
    }
}

fn without_suffix(term: &str) -> String {
    let is_hex = term.get(..2).is_some_and(|start| start.eq_ignore_ascii_case("0x"));
    let suffix: &[char] = if is_hex { &['u', 'U', 'l', 'L'] } else { &['u', 'U', 'l', 'L', 'f', 'F'] };
    match term.trim_end_matches(suffix) {
        number if number.ends_with(|last: char| last.is_ascii_hexdigit() || last == '.') => number.to_owned(),
        _ => term.to_owned(),
    }
}

/// `$NODEID+` followed by the other terms in order.
fn formula(core: &str) -> Option<String> {
    let terms: Vec<&str> = core.split('+').map(str::trim_ascii).collect();
    let (node_ids, others): (Vec<&str>, Vec<&str>) =
        terms.into_iter().partition(|term| term.eq_ignore_ascii_case("$NODEID"));
    let rest: String = others.iter().map(|term| format!("+{term}")).collect();
    (node_ids.len() == 1).then(|| format!("$NODEID{rest}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::literal::value_in_line as value;
    use crate::model::DataType;

    #[test]
    fn the_value_stays() {
        let (u32, i16, real) = (DataType::UNSIGNED32, DataType::INTEGER16, DataType::REAL32);
        let (string, bytes, bool) = (DataType::VISIBLE_STRING, DataType::OCTET_STRING, DataType::BOOLEAN);
        for (text, data_type, quirk, expected) in [
            ("010", u32, Quirk::Octal, "0x8"),
            ("-010 ; eight", i16, Quirk::Octal, "-8 ; eight"),
            ("007", u32, Quirk::LeadingZero, "7"),
            ("$NODEID+0600", u32, Quirk::Octal, "$NODEID+0x180"),
            ("0x180 + $NodeId+1", u32, Quirk::NodeIdLast, "$NODEID+0x180+1"),
            ("$nodeid+ 0x180 # x", u32, Quirk::FormulaSpelling, "$NODEID+0x180 # x"),
            ("0x10UL", u32, Quirk::CSuffix, "0x10"),
            ("1.5f", real, Quirk::CSuffix, "1.5"),
            ("10 // ten", u32, Quirk::TrailingComment, "10"),
            ("0x3FC00000", real, Quirk::RealAsBits, "1.5"),
            ("0xFFFE", i16, Quirk::TwosComplement, "-2"),
            ("\"a b\"", string, Quirk::Quoted, "a b"),
            ("TRUE", bool, Quirk::BooleanWord, "1"),
            ("0x01 a2", bytes, Quirk::DecoratedBytes, "01A2"),
        ] {
            let mut quirks = Quirks::default();
            let read = value(text, Some(data_type), &mut quirks).unwrap();
            assert!(quirks.has(quirk), "{text}");
            assert_eq!(respell(text, quirk, Some(&read)).as_deref(), Some(expected), "{text}");
            let mut quirks = Quirks::default();
            assert_eq!(value(expected, Some(data_type), &mut quirks), Ok(read), "{text}");
            assert!(!quirks.has(quirk), "{text}");
        }
    }

    #[test]
    fn strings_that_need_their_quotes_keep_them() {
        for text in ["\"\"", "\" a\"", "\"\"a\"\""] {
            assert_eq!(respell(text, Quirk::Quoted, None), None, "{text}");
        }
    }

    #[test]
    fn comments_lose_their_marks() {
        assert_eq!(trailing_comment("5 ;; five"), Some("five"));
        assert_eq!(trailing_comment("5 // five"), Some("five"));
        assert_eq!(trailing_comment("5"), None);
    }
}

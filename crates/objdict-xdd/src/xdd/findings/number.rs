//! Values as numbers, as far as they can be compared without the data type.

use std::cmp::Ordering;

/// A number in decimal or hex, with or without a fraction, or relative to the node-ID.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Number {
    Integer(i128),
    /// `$NODEID+…`
    OfNode(i128),
    Real(f64),
}

impl Number {
    pub(super) fn parse(text: &str) -> Option<Self> {
        let text = text.trim_ascii();
        if let Some(rest) =
            text.get(..7).filter(|word| word.eq_ignore_ascii_case("$NODEID")).map(|_| &text[7..])
        {
            let rest = rest.trim_ascii_start();
            return match rest.strip_prefix('+') {
                Some(offset) => integer(offset.trim_ascii_start()).map(Self::OfNode),
                None => rest.is_empty().then_some(Self::OfNode(0)),
            };
        }
        let looks_like_number =
            text.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '+' | '-' | '.'));
        let real = || text.parse().ok().filter(|real: &f64| real.is_finite() && looks_like_number);
        integer(text).map(Self::Integer).or_else(|| real().map(Self::Real))
    }

    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.compare(other) == Some(Ordering::Equal)
    }

    /// `None` if the result depends on the node-ID.
    pub(super) fn compare(&self, other: &Self) -> Option<Ordering> {
        match (self, other) {
            (Self::Integer(a), Self::Integer(b)) | (Self::OfNode(a), Self::OfNode(b)) => Some(a.cmp(b)),
            (Self::OfNode(_), _) | (_, Self::OfNode(_)) => None,
            _ => self.as_real().partial_cmp(&other.as_real()),
        }
    }

    fn as_real(&self) -> f64 {
        match *self {
            Self::Integer(number) | Self::OfNode(number) => number as f64,
            Self::Real(number) => number,
        }
    }
}

fn integer(text: &str) -> Option<i128> {
    let (is_negative, digits) = match text.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let number = match digits.strip_prefix("0x").or_else(|| digits.strip_prefix("0X")) {
        Some(hex) if hex.bytes().all(|byte| byte.is_ascii_hexdigit()) => {
            i128::from_str_radix(hex, 16).ok()?
        }
        None if !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()) => {
            digits.parse().ok()?
        }
        _ => return None,
    };
    Some(if is_negative { -number } else { number })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_same(a: &str, b: &str) -> bool {
        Number::parse(a).unwrap_or(Number::Real(0.5)).is_same(&Number::parse(b).unwrap_or(Number::Real(0.25)))
    }

    #[test]
    fn spellings_of_a_number_are_the_same() {
        assert!(
            is_same("0x10", "16") && is_same("1.0", "1") && is_same("-0x1", "-1") && is_same("0X0a", "+10")
        );
        assert!(is_same("$NODEID+0x180", "$NodeId + 384") && is_same("$NODEID", "$NODEID+0"));
        assert!(!is_same("$NODEID+0x180", "0x180") && !is_same("1", "2") && !is_same("1.5", "1"));
        for text in ["", "-", "0x", "inf", "NaN", "abc", "$NODEID+x", "12 34", "é"] {
            assert_eq!(Number::parse(text), None, "{text}");
        }
    }
}

//! Decimal numbers without rounding: scales, offsets and limits.

use std::fmt;

/// `mantissa` times ten to the power of `exponent`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Decimal {
    mantissa: i128,
    exponent: i32,
}

impl Decimal {
    pub(super) const ZERO: Self = Self { mantissa: 0, exponent: 0 };
    pub(super) const ONE: Self = Self { mantissa: 1, exponent: 0 };
    /// Larger powers of ten are beyond any number of a device.
    const MAX_EXPONENT: i32 = 400;

    pub(super) fn integer(number: i128) -> Self {
        Self { mantissa: number, exponent: 0 }.reduced()
    }

    /// A number such as `-1.5`, `1E-6` or `0x10`; `None` if it is not one, or too long.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        if let Some(digits) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
            let plain = !digits.starts_with(['+', '-']);
            return i128::from_str_radix(digits, 16).ok().filter(|_| plain).map(Self::integer);
        }
        let (number, exponent) = match text.split_once(['e', 'E']) {
            Some((number, exponent)) => (number, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (whole, fraction) = number.split_once('.').unwrap_or((number, ""));
        let is_plain = fraction.bytes().all(|byte| byte.is_ascii_digit()) && number.len() <= 36;
        let mantissa = format!("{whole}{fraction}").parse().ok().filter(|_| is_plain)?;
        let exponent = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
        (exponent.abs() <= Self::MAX_EXPONENT).then(|| Self { mantissa, exponent }.reduced())
    }

    pub(super) fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    pub(super) fn is_negative(self) -> bool {
        self.mantissa < 0
    }

    /// The product; `None` if it has too many digits.
    pub(super) fn times(self, other: Self) -> Option<Self> {
        let mantissa = self.mantissa.checked_mul(other.mantissa)?;
        Some(Self { mantissa, exponent: self.exponent + other.exponent }.reduced())
    }

    /// The sum; `None` if it has too many digits.
    pub(super) fn plus(self, other: Self) -> Option<Self> {
        if self.is_zero() || other.is_zero() {
            return Some(if self.is_zero() { other } else { self });
        }
        let exponent = self.exponent.min(other.exponent);
        let aligned = |of: Self| {
            let shift = u32::try_from(of.exponent - exponent).ok()?;
            of.mantissa.checked_mul(10_i128.checked_pow(shift)?)
        };
        let mantissa = aligned(self)?.checked_add(aligned(other)?)?;
        Some(Self { mantissa, exponent }.reduced())
    }

    /// The same number without trailing zeros.
    fn reduced(mut self) -> Self {
        if self.mantissa == 0 {
            return Self::ZERO;
        }
        while self.mantissa % 10 == 0 {
            self.mantissa /= 10;
            self.exponent += 1;
        }
        self
    }
}

/// `0.001`, `250`; with an exponent if that is much shorter.
impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { mantissa, exponent } = *self;
        let digits = mantissa.unsigned_abs().to_string();
        let sign = if mantissa < 0 { "-" } else { "" };
        match usize::try_from(exponent.unsigned_abs()).unwrap_or(usize::MAX) {
            zeros if zeros > 12 => write!(f, "{sign}{digits}E{exponent}"),
            zeros if exponent >= 0 => write!(f, "{sign}{digits}{}", "0".repeat(zeros)),
            places if places >= digits.len() => write!(f, "{sign}0.{digits:0>places$}"),
            places => {
                let (whole, fraction) = digits.split_at(digits.len() - places);
                write!(f, "{sign}{whole}.{fraction}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_all_digits() {
        for (text, shown) in [
            ("0.1", "0.1"),
            ("-01.50", "-1.5"),
            ("1E-6", "0.000001"),
            ("2.5e3", "2500"),
            ("0x10", "16"),
            ("1e-30", "1E-30"),
            ("-0", "0"),
            ("18446744073709551615", "18446744073709551615"),
        ] {
            assert_eq!(
                Decimal::parse(text).map(|number| number.to_string()).as_deref(),
                Some(shown),
                "{text}"
            );
        }
        for text in ["", ".", "1.2.3", "1.-2", "0x-1", "1e9999", "mm", "NaN", "1e"] {
            assert_eq!(Decimal::parse(text), None, "{text}");
        }
    }

    #[test]
    fn products_and_sums_are_exact() {
        let number = |text| Decimal::parse(text).unwrap();
        assert_eq!(number("3").times(number("0.1")), Some(number("0.3")));
        assert_eq!(
            number("1e20").plus(number("-0.5")).map(|sum| sum.to_string()).as_deref(),
            Some("99999999999999999999.5")
        );
        assert_eq!(number("1e300").plus(number("1")), None);
    }
}

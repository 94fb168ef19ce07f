//! What lines of text are made of: words, numbers, bytes and CAN-IDs.

use super::LoggedFrame;

/// The words of a line, between blanks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words<'a>(pub(super) &'a [u8]);

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let text = self.0.trim_ascii_start();
        if text.is_empty() {
            return None;
        }
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        self.0 = &text[end..];
        Some(&text[..end])
    }
}

/// A hexadecimal number of at most 8 digits.
pub(super) fn hex(text: &[u8]) -> Option<u32> {
    if text.is_empty() || text.len() > 8 {
        return None;
    }
    text.iter().try_fold(0, |number, &byte| Some(number << 4 | u32::from(digit(byte)?)))
}

/// A decimal number.
pub(super) fn decimal(text: &[u8]) -> Option<u32> {
    let number = |text: &[u8]| {
        text.iter().try_fold(0_u32, |number, &byte| {
            number.checked_mul(10)?.checked_add(u32::from(byte.wrapping_sub(b'0')))
        })
    };
    let is_number = !text.is_empty() && text.iter().all(u8::is_ascii_digit);
    is_number.then(|| number(text))?
}

/// The value of a hexadecimal digit.
pub(super) fn digit(byte: u8) -> Option<u8> {
    Some(DIGITS[usize::from(byte)]).filter(|digit| *digit < 16)
}

/// The values of hexadecimal digits, and 16 of other bytes.
const DIGITS: [u8; 256] = {
    let mut digits = [16; 256];
    let mut digit = 0;
    while digit < 16 {
        digits[b"0123456789abcdef"[digit as usize] as usize] = digit;
        digits[b"0123456789ABCDEF"[digit as usize] as usize] = digit;
        digit += 1;
    }
    digits
};

/// Reads so many bytes, each a word in hex.
pub(super) fn bytes(frame: &mut LoggedFrame, words: &mut Words<'_>, count: u32) -> Result<(), &'static str> {
    for _ in 0..count {
        let byte = words.next().and_then(hex).and_then(|byte| u8::try_from(byte).ok());
        if !frame.push(byte.ok_or("a byte of the data is missing or not a number")?) {
            return Err(TOO_LONG);
        }
    }
    Ok(())
}

/// A frame with more data than CAN FD has.
pub(super) const TOO_LONG: &str = "there are more data than a frame has";

/// A CAN-ID beyond 11 or 29 bits.
pub(super) const BAD_ID: &str = "the CAN-ID is not valid";

/// Whether a CAN-ID fits its 11 or 29 bits.
pub(super) const fn fits(can_id: u32, is_extended: bool) -> bool {
    can_id <= if is_extended { 0x1FFF_FFFF } else { 0x7FF }
}

/// Whether a line is a comment in forms that have none of their own.
pub(super) fn is_comment(line: &[u8]) -> bool {
    matches!(line.trim_ascii_start(), [b'#' | b';', ..] | [b'/', b'/', ..])
}

/// The bytes of a frame of CAN FD by its DLC.
pub(super) fn fd_length(dlc: u32) -> u32 {
    const LENGTHS: [u32; 7] = [12, 16, 20, 24, 32, 48, 64];
    dlc.checked_sub(9).and_then(|at| LENGTHS.get(at as usize)).map_or(dlc, |length| *length)
}

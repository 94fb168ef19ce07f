//! The CRC of block transfers.

/// The CRC-16 of block transfers (CiA 301 §7.2.4.3.16) of the bytes so far and these: polynomial 1021h, initially 0.
pub fn crc(so_far: u16, bytes: &[u8]) -> u16 {
    bytes.iter().fold(so_far, |crc, &byte| {
        // by arithmetic rather than a table of 512 bytes
        let mut x = (crc >> 8) as u8 ^ byte;
        x ^= x >> 4;
        let x = u16::from(x);
        (crc << 8) ^ (x << 12) ^ (x << 5) ^ x
    })
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_check_value_is_that_of_the_standard() {
        assert_eq!(super::crc(super::crc(0, b"1234"), b"56789"), 0x31C3);
        assert_eq!(super::crc(0, b""), 0);
    }
}

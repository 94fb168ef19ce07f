//! A hash of bytes that is the same on every machine and in every version.

/// FNV-1a with 64 bits. It distinguishes files and findings, but does not resist deliberate collisions.
#[derive(Clone, Copy, Debug)]
pub struct Fnv(pub u64);

/// The hash of no bytes.
impl Default for Fnv {
    fn default() -> Self {
        Self::new()
    }
}

impl Fnv {
    /// The hash of no bytes.
    pub const fn new() -> Self {
        Self(0xCBF2_9CE4_8422_2325)
    }

    pub(crate) fn byte(&mut self, byte: u8) {
        self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01B3);
    }

    /// Adds bytes, followed by a separator that no text contains.
    pub fn field(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&byte| self.byte(byte));
        self.byte(0xFF);
    }

    /// Adds a string without its spaces.
    pub fn text(&mut self, text: &str) {
        text.bytes().filter(|byte| !byte.is_ascii_whitespace()).for_each(|byte| self.byte(byte));
        self.byte(0xFF);
    }
}

/// The hash of a file's bytes, 64-bit FNV-1a.
pub fn hash(bytes: &[u8]) -> u64 {
    let mut hash = Fnv::new();
    bytes.iter().for_each(|&byte| hash.byte(byte));
    hash.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_fnv_1a() {
        assert_eq!(hash(b"foobar"), 0x8594_4171_F739_67E8);
    }
}

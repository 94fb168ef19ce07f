//! Mutations of descriptions, the same for the same seed: what editors, transfers and mischief do to lines and bytes.

/// Values that numbers, texts and references of a description do not expect.
pub(crate) const VALUES: [&str; 24] = [
    "",
    "0",
    "-1",
    "0xFFFFFFFF",
    "0x10000000000000000",
    "18446744073709551616",
    "-9223372036854775809",
    "08",
    "0x",
    "$NODEID",
    "$NODEID+0xFFFFFFFF",
    "0x180+$NODEID",
    "1e999",
    "NaN",
    "254",
    "255",
    "256",
    "0x8",
    "0x1A00",
    "0x60000108",
    "0xFFFFFFFFFFFFFFFF",
    "true",
    "\u{FEFF}\u{202E}\0",
    "((((((((((((((((((((",
];

/// A source of mutations.
pub(crate) struct Mutator<'a> {
    state: u64,
    words: &'a [String],
}

impl<'a> Mutator<'a> {
    /// The same mutations for the same seed and words.
    pub(crate) fn new(seed: u64, words: &'a [String]) -> Self {
        // xorshift never leaves zero
        Self { state: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1, words }
    }

    /// A number below `end`; 0 where there is none.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        let number = (self.state >> 16) % (end.max(1) as u64);
        usize::try_from(number).unwrap_or(0)
    }

    /// `text` with some mutations, some of them taken from `other`.
    pub(crate) fn mutate(&mut self, text: &[u8], other: &[u8]) -> Vec<u8> {
        let mut bytes = text.to_vec();
        for _ in 0..=self.below(6) {
            match self.below(12) {
                0 => self.flip(&mut bytes),
                1 => self.insert(&mut bytes),
                2 => self.delete(&mut bytes),
                3 => self.repeat_line(&mut bytes),
                4 => self.drop_line(&mut bytes),
                5 => self.splice(&mut bytes, other),
                6 => self.insert_word(&mut bytes),
                7 => self.replace_word(&mut bytes),
                8 if self.below(4) == 0 => bytes.truncate(self.below(text.len())),
                _ => self.replace_value(&mut bytes),
            }
        }
        bytes
    }

    fn flip(&mut self, bytes: &mut [u8]) {
        let at = self.below(bytes.len());
        if let Some(byte) = bytes.get_mut(at) {
            *byte ^= 1 << self.below(8);
        }
    }

    fn insert(&mut self, bytes: &mut Vec<u8>) {
        let at = self.below(bytes.len() + 1);
        let byte = u8::try_from(self.below(256)).unwrap_or(0);
        bytes.insert(at, byte);
    }

    fn word(&mut self) -> &'a str {
        let number = self.below(self.words.len());
        self.words.get(number).map_or("", |word| word)
    }

    fn insert_word(&mut self, bytes: &mut Vec<u8>) {
        let at = self.below(bytes.len() + 1);
        bytes.splice(at..at, self.word().bytes());
    }

    /// A word for the letters and digits around a place: another name of a key, element or attribute.
    fn replace_word(&mut self, bytes: &mut Vec<u8>) {
        let at = self.below(bytes.len());
        let is_other = |byte: &u8| !byte.is_ascii_alphanumeric();
        let start = bytes[..at].iter().rposition(is_other).map_or(0, |found| found + 1);
        let end = bytes[at..].iter().position(is_other).map_or(bytes.len(), |found| at + found);
        let word = self.word().trim_matches(['\n', '[', ']', '=']);
        bytes.splice(start..end, word.bytes());
    }

    fn delete(&mut self, bytes: &mut Vec<u8>) {
        let start = self.below(bytes.len());
        let end = (start + self.below(40)).min(bytes.len());
        bytes.drain(start..end);
    }

    fn repeat_line(&mut self, bytes: &mut Vec<u8>) {
        let (start, end) = self.line(bytes);
        let line = bytes[start..end].to_vec();
        let at = self.line(bytes).0;
        bytes.splice(at..at, line);
    }

    fn drop_line(&mut self, bytes: &mut Vec<u8>) {
        let (start, end) = self.line(bytes);
        bytes.drain(start..end);
    }

    fn splice(&mut self, bytes: &mut Vec<u8>, other: &[u8]) {
        let start = self.line(other).0;
        let end = (start + self.below(600)).min(other.len());
        let at = self.line(bytes).0;
        bytes.splice(at..at, other[start..end].iter().copied());
    }

    /// Another value behind `=` of a line, or between the quotes behind it.
    fn replace_value(&mut self, bytes: &mut Vec<u8>) {
        let (start, end) = self.line(bytes);
        let line = &bytes[start..end];
        let Some(equals) = line.iter().position(|&byte| byte == b'=') else { return };
        let from = start + equals + 1;
        let is_quoted = bytes.get(from) == Some(&b'"');
        let (from, is_end): (usize, fn(u8) -> bool) = match is_quoted {
            true => (from + 1, |byte| byte == b'"'),
            false => (from, |byte| matches!(byte, b'\r' | b'\n')),
        };
        let length = bytes[from..end].iter().position(|&byte| is_end(byte)).unwrap_or(end - from);
        let value = VALUES[self.below(VALUES.len())];
        bytes.splice(from..from + length, value.bytes());
    }

    /// Start and end of a line, with its end.
    fn line(&mut self, bytes: &[u8]) -> (usize, usize) {
        let at = self.below(bytes.len());
        let start = bytes[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |found| found + 1);
        let end =
            bytes[at..].iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |found| at + found + 1);
        (start, end)
    }
}

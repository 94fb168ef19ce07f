//! Text encodings of description files: detected on reading and used again for writing.
//!
//! CiA 306-1 §4.2 requires ISO 646 (seven bits). Real files also use UTF-8, with and without byte order mark,
//! Windows-1252, UTF-16 and the DOS code page 850. All bytes of code page 850 are also Windows-1252 characters, so it
//! is recognised only by umlauts inside words.

use std::str::FromStr;

named! {
    /// The character encoding of a file.
    #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
    pub enum Encoding {
        /// UTF-8 without byte order mark; includes every ISO 646 file.
        #[default]
        Utf8 = "utf-8",
        /// UTF-8 after the byte order mark EF BB BF.
        Utf8Bom = "utf-8-bom",
        /// Windows-1252, the usual superset of Latin-1. All 256 bytes are characters.
        Windows1252 = "windows-1252",
        /// Code page 850 (DOS, Western Europe); detected if all characters beyond ISO 646 are umlauts inside words.
        Cp850 = "cp850",
        /// UTF-16, low byte first, after the byte order mark FF FE.
        Utf16Le = "utf-16le",
        /// UTF-16, high byte first, after the byte order mark FE FF.
        Utf16Be = "utf-16be",
    }
}

const UTF8_BOM: &[u8] = b"\xEF\xBB\xBF";
const UTF16LE_BOM: &[u8] = b"\xFF\xFE";
const UTF16BE_BOM: &[u8] = b"\xFE\xFF";

impl Encoding {
    /// The names accepted by [`Encoding::from_str`], one per encoding.
    pub const NAMES: [&'static str; 6] =
        ["utf-8", "utf-8-bom", "windows-1252", "cp850", "utf-16le", "utf-16be"];

    /// Detects the encoding of `bytes`: by the byte order mark; otherwise UTF-8 if valid, code page 850 if Windows-1252
    /// would show quotes and control characters inside words, or else Windows-1252.
    pub fn detect(bytes: &[u8]) -> Self {
        if bytes.starts_with(UTF16LE_BOM) {
            Self::Utf16Le
        } else if bytes.starts_with(UTF16BE_BOM) {
            Self::Utf16Be
        } else if std::str::from_utf8(bytes).is_err() {
            if has_dos_umlauts(bytes) { Self::Cp850 } else { Self::Windows1252 }
        } else if bytes.starts_with(UTF8_BOM) {
            Self::Utf8Bom
        } else {
            Self::Utf8
        }
    }

    /// The text of `bytes`, without a byte order mark. Invalid bytes become U+FFFD.
    pub fn decode(self, bytes: Vec<u8>) -> String {
        match self {
            Self::Utf8 => String::from_utf8(bytes)
                .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned()),
            Self::Utf8Bom => {
                let body = bytes.strip_prefix(UTF8_BOM).unwrap_or(&bytes);
                String::from_utf8_lossy(body).into_owned()
            }
            Self::Windows1252 => decode_bytes(&bytes, windows_1252_char),
            Self::Cp850 => decode_bytes(&bytes, cp850_char),
            Self::Utf16Le => decode_utf16(&bytes, UTF16LE_BOM, u16::from_le_bytes),
            Self::Utf16Be => decode_utf16(&bytes, UTF16BE_BOM, u16::from_be_bytes),
        }
    }

    /// The bytes of `text` in this encoding, including its byte order mark.
    ///
    /// # Errors
    /// The first character that the encoding lacks.
    pub fn encode(self, text: &str) -> Result<Vec<u8>, Unencodable> {
        match self {
            Self::Utf8 => Ok(text.as_bytes().to_vec()),
            Self::Utf8Bom => Ok([UTF8_BOM, text.as_bytes()].concat()),
            Self::Windows1252 => self.encode_bytes(text, windows_1252_byte),
            Self::Cp850 => self.encode_bytes(text, cp850_byte),
            Self::Utf16Le => Ok(encode_utf16(text, UTF16LE_BOM, u16::to_le_bytes)),
            Self::Utf16Be => Ok(encode_utf16(text, UTF16BE_BOM, u16::to_be_bytes)),
        }
    }

    fn encode_bytes(self, text: &str, byte_of: impl Fn(char) -> Option<u8>) -> Result<Vec<u8>, Unencodable> {
        text.chars()
            .map(|character| {
                if character.is_ascii() {
                    return Ok(character as u8);
                }
                byte_of(character).ok_or(Unencodable { character, encoding: self })
            })
            .collect()
    }
}

impl FromStr for Encoding {
    type Err = UnknownEncoding;

    fn from_str(name: &str) -> Result<Self, UnknownEncoding> {
        match name.to_ascii_lowercase().as_str() {
            "utf-8" | "utf8" | "ascii" => Ok(Self::Utf8),
            "utf-8-bom" => Ok(Self::Utf8Bom),
            "windows-1252" | "cp1252" | "latin1" | "latin-1" | "iso-8859-1" => Ok(Self::Windows1252),
            "cp850" | "ibm850" => Ok(Self::Cp850),
            "utf-16le" => Ok(Self::Utf16Le),
            "utf-16be" => Ok(Self::Utf16Be),
            _ => Err(UnknownEncoding { name: name.to_owned() }),
        }
    }
}

/// An unknown [`Encoding`] name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownEncoding {
    name: String,
}

crate::error_messages! { UnknownEncoding: {
    Self { name } => "unknown encoding `{name}`, expected one of {}", Encoding::NAMES.join(", ");
} }

/// A character that an [`Encoding`] lacks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unencodable {
    /// The character.
    pub character: char,
    /// The requested encoding.
    pub encoding: Encoding,
}

crate::error_messages! { Unencodable: {
    Self { character, encoding } => "the encoding {encoding} has no character `{character}`";
} }

/// Whether all bytes beyond ISO 646 are German letters of code page 850 in words. One of them must be `ä`, `ö` or `ü`,
/// which are a quote or a control character in Windows-1252; the others are letters in both.
fn has_dos_umlauts(bytes: &[u8]) -> bool {
    let is_letter = |at: usize| {
        bytes
            .get(at)
            .is_some_and(|byte| byte.is_ascii_alphabetic() || matches!(byte, 0x81 | 0x84 | 0x94 | 0xE1))
    };
    let mut others = bytes.iter().enumerate().filter(|(_, byte)| !byte.is_ascii()).peekable();
    let mut is_certain = false;
    others.peek().is_some()
        && others.all(|(at, &byte)| {
            let is_inside = at > 0 && is_letter(at - 1) && is_letter(at + 1);
            is_certain |= is_inside && matches!(byte, 0x81 | 0x84 | 0x94);
            match byte {
                0x81 | 0x84 | 0x94 => is_inside,
                0x8E | 0x99 | 0x9A => is_letter(at + 1),
                0xE1 => at > 0 && is_letter(at - 1),
                _ => false,
            }
        })
        && is_certain
}

/// most of a text is ISO 646, which is copied in runs
fn decode_bytes(bytes: &[u8], char_of: fn(u8) -> char) -> String {
    let mut text = String::with_capacity(bytes.len());
    for run in bytes.chunk_by(|one, next| one.is_ascii() == next.is_ascii()) {
        match std::str::from_utf8(run) {
            Ok(run) if run.is_ascii() => text.push_str(run),
            _ => text.extend(run.iter().map(|&byte| char_of(byte))),
        }
    }
    text
}

fn decode_utf16(bytes: &[u8], bom: &[u8], from_bytes: fn([u8; 2]) -> u16) -> String {
    let (units, rest) = bytes.strip_prefix(bom).unwrap_or(bytes).as_chunks();
    let mut units: Vec<u16> = units.iter().map(|&unit| from_bytes(unit)).collect();
    // an odd byte at the end becomes one U+FFFD, together with an unpaired surrogate before it
    if !rest.is_empty() && !matches!(units.last(), Some(0xD800..=0xDBFF)) {
        units.push(0xDC00);
    }
    String::from_utf16_lossy(&units)
}

fn encode_utf16(text: &str, bom: &[u8], to_bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
    let mut bytes = bom.to_vec();
    bytes.extend(text.encode_utf16().flat_map(to_bytes));
    bytes
}

/// The bytes from 80h on, where Windows-1252 differs from Latin-1; undefined ones are control characters.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8D}', 'Ž', '\u{8F}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9D}', 'ž', 'Ÿ',
];

fn windows_1252_char(byte: u8) -> char {
    match byte {
        0x80..=0x9F => WINDOWS_1252[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

fn windows_1252_byte(character: char) -> Option<u8> {
    match u8::try_from(character) {
        Ok(byte) if windows_1252_char(byte) == character => Some(byte),
        _ => position_behind_80(&WINDOWS_1252, character),
    }
}

/// The upper half of code page 850; its lower half is ISO 646.
const CP850: [char; 128] = [
    'Ç', 'ü', 'é', 'â', 'ä', 'à', 'å', 'ç', 'ê', 'ë', 'è', 'ï', 'î', 'ì', 'Ä', 'Å', 'É', 'æ', 'Æ', 'ô', 'ö',
    'ò', 'û', 'ù', 'ÿ', 'Ö', 'Ü', 'ø', '£', 'Ø', '×', 'ƒ', 'á', 'í', 'ó', 'ú', 'ñ', 'Ñ', 'ª', 'º', '¿', '®',
    '¬', '½', '¼', '¡', '«', '»', '░', '▒', '▓', '│', '┤', 'Á', 'Â', 'À', '©', '╣', '║', '╗', '╝', '¢', '¥',
    '┐', '└', '┴', '┬', '├', '─', '┼', 'ã', 'Ã', '╚', '╔', '╩', '╦', '╠', '═', '╬', '¤', 'ð', 'Ð', 'Ê', 'Ë',
    'È', 'ı', 'Í', 'Î', 'Ï', '┘', '┌', '█', '▄', '¦', 'Ì', '▀', 'Ó', 'ß', 'Ô', 'Ò', 'õ', 'Õ', 'µ', 'þ', 'Þ',
    'Ú', 'Û', 'Ù', 'ý', 'Ý', '¯', '´', '\u{AD}', '±', '‗', '¾', '¶', '§', '÷', '¸', '°', '¨', '·', '¹', '³',
    '²', '■', '\u{A0}',
];

fn cp850_char(byte: u8) -> char {
    match byte {
        0..=0x7F => char::from(byte),
        _ => CP850[usize::from(byte - 0x80)],
    }
}

fn cp850_byte(character: char) -> Option<u8> {
    position_behind_80(&CP850, character)
}

fn position_behind_80(characters: &[char], character: char) -> Option<u8> {
    let position = characters.iter().position(|&c| c == character)?;
    u8::try_from(position + 0x80).ok()
}

/// The ISO 646 transliteration of a character; `None` if there is none.
pub const fn transliterate(c: char) -> Option<&'static str> {
    Some(match c {
        'ä' => "ae",
        'ö' => "oe",
        'ü' => "ue",
        'Ä' => "Ae",
        'Ö' => "Oe",
        'Ü' => "Ue",
        'ß' => "ss",
        'à' | 'á' | 'â' | 'ã' | 'å' => "a",
        'ç' => "c",
        'è' | 'é' | 'ê' | 'ë' => "e",
        'ì' | 'í' | 'î' | 'ï' => "i",
        'ñ' => "n",
        'ò' | 'ó' | 'ô' | 'õ' => "o",
        'ù' | 'ú' | 'û' => "u",
        'µ' | 'μ' => "u",
        '°' => "deg",
        'Ω' => "Ohm",
        '²' => "2",
        '³' => "3",
        '±' => "+-",
        '×' => "x",
        '–' | '—' | '‑' | '−' => "-",
        '‘' | '’' => "'",
        '“' | '”' | '„' => "\"",
        '…' => "...",
        '®' => "(R)",
        '©' => "(C)",
        '™' => "(TM)",
        '\u{A0}' => " ",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_byte_encodings_restore_every_byte() {
        let bytes: Vec<u8> = (0..=255).collect();
        for encoding in [Encoding::Windows1252, Encoding::Cp850] {
            assert_eq!(encoding.encode(&encoding.decode(bytes.clone())), Ok(bytes.clone()), "{encoding}");
        }
    }

    #[test]
    fn byte_order_marks_decide() {
        assert_eq!(Encoding::detect(b"\xEF\xBB\xBF[A]"), Encoding::Utf8Bom);
        assert_eq!(Encoding::detect(b"\xFF\xFE[\0"), Encoding::Utf16Le);
        assert_eq!(Encoding::detect(b"\xFE\xFF\0["), Encoding::Utf16Be);
        assert_eq!(Encoding::detect("°".as_bytes()), Encoding::Utf8);
        assert_eq!(Encoding::detect(b"\xB0"), Encoding::Windows1252);
    }

    #[test]
    fn umlauts_of_dos_are_recognised_inside_words() {
        for text in [&b"Sch\x94naich"[..], b"\x9Aberlast, Gr\x94\xE1e", b"f\x81r"] {
            assert_eq!(Encoding::detect(text), Encoding::Cp850, "{}", Encoding::Cp850.decode(text.to_vec()));
        }
        // quotes, signs and letters of Windows-1252
        for text in
            [&b"\x84so\x94"[..], b"O\x9Aet\xF8en\xED", b"Stra\xDFe", b"5\x94 x", b"a\x94b \xB0C", b"A\x99"]
        {
            assert_eq!(Encoding::detect(text), Encoding::Windows1252, "{text:?}");
        }
    }

    #[test]
    fn names_read_back() {
        for name in Encoding::NAMES {
            assert_eq!(name.parse::<Encoding>().map(|e| e.to_string()), Ok(name.to_owned()));
        }
        assert!("ebcdic".parse::<Encoding>().is_err());
    }

    #[test]
    fn what_an_encoding_lacks_is_an_error() {
        assert_eq!(
            Encoding::Cp850.encode("a€"),
            Err(Unencodable { character: '€', encoding: Encoding::Cp850 })
        );
    }
}

//! ISO 646, the 7-bit characters that CiA 306-1 §4.2 allows, and transliterations of other characters.

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

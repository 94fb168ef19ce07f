//! ISO 646, the seven bits that CiA 306-1 §4.2 allows, and what stands in it for other characters.

/// What stands in ISO 646 for a character that it lacks; `None` where nothing does.
pub const fn stand_in(c: char) -> Option<&'static str> {
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

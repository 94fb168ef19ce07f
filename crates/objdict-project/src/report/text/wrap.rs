//! Wraps texts between words, and inside words that are longer than a line.

use unicode_width::UnicodeWidthChar;

/// The width of a character in columns.
pub(super) fn columns(character: char) -> usize {
    if character.is_ascii_graphic() { 1 } else { character.width().unwrap_or(0) }
}

/// The lines of a text with a maximum width in columns.
pub(super) fn lines(text: &str, width: usize) -> Vec<&str> {
    // no character has more columns than bytes
    if text.len() <= width {
        return vec![text.trim_end_matches(' ')];
    }
    let mut lines = Vec::new();
    // the start of the line and of its last word, and the widths of both
    let (mut start, mut word, mut taken, mut of_word) = (0, 0, 0, 0);
    for (at, character) in text.char_indices() {
        let more = columns(character);
        if character == ' ' {
            (word, of_word) = (at + 1, 0);
        } else if taken + more > width {
            let end = if word > start { word } else { at };
            lines.push(text[start..end].trim_end_matches(' '));
            taken = if word > start { of_word } else { 0 };
            start = end;
        }
        taken += more;
        if character != ' ' {
            of_word = (of_word + more).min(taken);
        }
    }
    lines.push(text[start..].trim_end_matches(' '));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_ends_where_words_do() {
        let text = "`a/b.eds` says CiA-306 (or 301-1), 漢字 and 5 °C…";
        assert_eq!(lines(text, 12), ["`a/b.eds`", "says CiA-306", "(or 301-1),", "漢字 and 5", "°C…"]);
        assert_eq!(lines("abcdefghijk  lm ", 5), ["abcde", "fghij", "k  lm"]);
        assert_eq!(lines("a abcdefgh", 5), ["a", "abcde", "fgh"]);
    }
}

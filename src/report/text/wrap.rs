//! Where a text goes on in the next line.

use unicode_width::UnicodeWidthChar;

use self::Class::*;

/// What a character is to a line break: the classes of Unicode's annex 14 that messages and the values in them have.
#[derive(Clone, Copy, PartialEq)]
enum Class {
    Space,
    Bar,
    Hyphen,
    Slash,
    Exclamation,
    Comma,
    Opening,
    Brace,
    Closing,
    Quotation,
    Prefix,
    Postfix,
    Ellipsis,
    Glue,
    Digit,
    Ideograph,
    Letter,
}

fn class(character: char) -> Class {
    match character {
        ' ' => Space,
        '0'..='9' => Digit,
        '\t' | '|' | '–' => Bar,
        '-' => Hyphen,
        '/' => Slash,
        '!' | '?' => Exclamation,
        ',' | '.' | ':' | ';' => Comma,
        '(' | '[' | '{' | '¡' | '¿' => Opening,
        '}' => Brace,
        ')' | ']' => Closing,
        '"' | '\'' | '«' | '»' | '‘' | '’' | '“' | '”' => Quotation,
        '$' | '+' | '\\' | '£' | '¤' | '¥' | '±' | '€' | '−' => Prefix,
        '%' | '¢' | '°' | '‰' => Postfix,
        '…' => Ellipsis,
        '\u{A0}' => Glue,
        _ if columns(character) == 2 => Ideograph,
        _ => Letter,
    }
}

/// What a line may begin with where it ends behind such a character.
fn next_lines(before: Class) -> &'static [Class] {
    match before {
        Bar => &[Opening, Postfix, Prefix, Letter, Digit, Ideograph, Glue],
        Exclamation | Ellipsis => &[Opening, Postfix, Prefix, Letter, Digit, Ideograph],
        Slash => &[Opening, Postfix, Prefix, Letter, Ideograph],
        Comma => &[Opening, Postfix, Prefix, Ideograph],
        Brace => &[Opening, Letter, Digit, Ideograph],
        Closing => &[Opening, Ideograph],
        Postfix => &[Postfix, Prefix, Ideograph],
        Prefix => &[Postfix, Prefix],
        Letter | Digit => &[Ideograph],
        Ideograph => &[Opening, Prefix, Letter, Digit, Ideograph],
        Space | Hyphen | Opening | Quotation | Glue => &[],
    }
}

/// Where a line may end, and the end of the text.
fn word_ends(text: &str) -> impl Iterator<Item = usize> {
    // the last character that is no space, the one before it, and whether a space is behind it
    let (mut last, mut second, mut spaced) = (' ', ' ', false);
    let ends = text.char_indices().filter_map(move |(at, character)| {
        let (before, after) = (class(last), class(character));
        if after == Space {
            spaced = true;
            return None;
        }
        let may_end = match (before, after) {
            (Opening, _) | (_, Slash | Exclamation | Comma | Brace | Closing) => false,
            (Hyphen, _) if !spaced => second.is_alphanumeric() && character.is_alphanumeric(),
            _ => spaced || next_lines(before).contains(&after),
        };
        second = if spaced { ' ' } else { last };
        (last, spaced) = (character, false);
        may_end.then_some(at)
    });
    ends.chain([text.len()])
}

/// The columns that a character takes.
pub(super) fn columns(character: char) -> usize {
    if character.is_ascii_graphic() { 1 } else { character.width().unwrap_or(0) }
}

/// The start of a word that fits so many columns, in bytes, and the columns that it takes.
fn fitting(word: &str, width: usize) -> (usize, usize) {
    let mut taken = 0;
    for (at, character) in word.char_indices() {
        let more = columns(character);
        if taken > 0 && taken + more > width {
            return (at, taken);
        }
        taken += more;
    }
    (word.len(), taken)
}

/// The lines of a text, of at most so many columns.
pub(super) fn lines(text: &str, width: usize) -> Vec<&str> {
    let mut lines = Vec::new();
    // where the line begins, the columns that it takes so far, and where the next word begins
    let (mut start, mut taken, mut at) = (0, 0, 0);
    // no character takes more columns than bytes
    let ends = (text.len() > width).then(|| word_ends(text));
    for end in ends.into_iter().flatten() {
        let mut word = text[at..end].trim_end_matches(' ');
        while !word.is_empty() {
            let (length, columns) = fitting(word, width);
            if taken + columns > width && at > start {
                lines.push(text[start..at].trim_end_matches(' '));
                (start, taken) = (at, 0);
            }
            (taken, at, word) = (taken + columns, at + length, &word[length..]);
        }
        (taken, at) = (taken + end - at, end);
    }
    lines.push(text[start..].trim_end_matches(' '));
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_ends_where_words_do() {
        let text = "`a/b.eds` says CiA-306 (or 301-1), --fix, 漢字 and 5 °C…";
        assert_eq!(lines(text, 12), ["`a/b.eds`", "says CiA-306", "(or 301-1),", "--fix, 漢字", "and 5 °C…"]);
        assert_eq!(lines("CiA-306-1 x|y a/b", 5), ["CiA-", "306-1", "x|y", "a/b"]);
        assert_eq!(lines("abcdefgh  ij ", 5), ["abcde", "fgh", "ij"]);
    }
}

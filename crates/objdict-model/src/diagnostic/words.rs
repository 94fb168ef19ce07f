//! Words for messages.

/// "1 entry", "2 entries".
pub fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// A sub-index for messages: decimal if below 10, else hex with `h`.
pub fn sub_index(sub: u8) -> String {
    if sub < 10 { sub.to_string() } else { format!("{sub:X}h") }
}

/// The known word closest to `wanted`; `None` if none is similar.
pub fn nearest<'a>(wanted: &str, words: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = wanted.to_ascii_lowercase();
    let most = wanted.chars().count() / 3 + 1;
    let distance = |word: &str| edits(&wanted, &word.to_ascii_lowercase());
    let words = words.into_iter().map(|word| (distance(word), word));
    words
        .filter(|&(distance, _)| distance <= most)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, word)| word)
}

/// The number of letters to change, add or remove to turn one word into the other (Levenshtein).
fn edits(from: &str, to: &str) -> usize {
    let mut row: Vec<usize> = (0..=to.chars().count()).collect();
    for (number, a) in from.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], number + 1);
        for (column, b) in to.chars().enumerate() {
            let replaced = diagonal + usize::from(a != b);
            diagonal = row[column + 1];
            row[column + 1] = replaced.min(row[column] + 1).min(diagonal + 1);
        }
    }
    row.last().copied().unwrap_or_default()
}

/// A character, or U+FFFD for a control character of the terminal or the text direction.
pub fn visible(character: char) -> char {
    match character {
        '\t' => character,
        '\u{061C}'
        | '\u{200B}'..='\u{200F}'
        | '\u{2028}'..='\u{202E}'
        | '\u{2060}'..='\u{2069}'
        | '\u{FEFF}' => char::REPLACEMENT_CHARACTER,
        _ if character.is_control() => char::REPLACEMENT_CHARACTER,
        _ => character,
    }
}

/// A text as one line without terminal control characters, because it may quote any text of a file.
pub fn one_line(text: &str) -> String {
    text.chars().map(|character| if character == '\t' { ' ' } else { visible(character) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edits_are_counted() {
        assert_eq!(edits("duplicate-key", "duplicate-key"), 0);
        assert_eq!(edits("duplcate-keys", "duplicate-key"), 2);
        assert_eq!(edits("", "abc"), 3);
    }

    #[test]
    fn the_nearest_word_is_one_that_is_near() {
        assert_eq!(nearest("Waring", ["note", "warning", "error"]), Some("warning"));
        assert_eq!(nearest("x", ["note", "warning", "error"]), None);
    }

    #[test]
    fn things_are_counted_as_people_write_them() {
        assert_eq!(counted(1, "entry", "entries"), "1 entry");
    }
}

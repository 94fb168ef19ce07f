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
    closest(wanted, words, wanted.chars().count() / 3 + 1)
}

/// The known word that `wanted` is plainly meant for: at most two letters differ, and at most a third of them.
pub fn misspelled<'a>(wanted: &str, words: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    closest(wanted, words, (wanted.chars().count() / 3).min(2))
}

fn closest<'a>(wanted: &str, words: impl IntoIterator<Item = &'a str>, most: usize) -> Option<&'a str> {
    let wanted = wanted.to_ascii_lowercase();
    let distance = |word: &str| edits(&wanted, &word.to_ascii_lowercase());
    let words = words.into_iter().map(|word| (distance(word), word));
    words
        .filter(|&(distance, _)| distance <= most)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, word)| word)
}

/// The number of letters to change, add, remove or exchange with their neighbours to turn one word into the other (optimal
/// string alignment).
fn edits(from: &str, to: &str) -> usize {
    let (from, to): (Vec<char>, Vec<char>) = (from.chars().collect(), to.chars().collect());
    let mut before = Vec::new();
    let mut row: Vec<usize> = (0..=to.len()).collect();
    for (number, a) in from.iter().enumerate() {
        let mut next = vec![number + 1];
        for (column, b) in to.iter().enumerate() {
            let replaced = row[column] + usize::from(a != b);
            let mut least = replaced.min(row[column + 1] + 1).min(next[column] + 1);
            let is_exchanged = number > 0 && column > 0 && *a == to[column - 1] && from[number - 1] == *b;
            if is_exchanged {
                least = least.min(before[column - 1] + 1);
            }
            next.push(least);
        }
        before = std::mem::replace(&mut row, next);
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
        assert_eq!(edits("pcl", "plc"), 1);
        assert_eq!(edits("heartbeat_prodcuer", "heartbeat_producer"), 1);
    }

    #[test]
    fn the_nearest_word_is_one_that_is_near() {
        assert_eq!(nearest("Waring", ["note", "warning", "error"]), Some("warning"));
        assert_eq!(nearest("x", ["note", "warning", "error"]), None);
    }

    #[test]
    fn a_misspelled_word_is_nearly_the_known_one() {
        let words = ["plc", "transmission", "offset_pos_to_dev"];
        assert_eq!(misspelled("pcl", words), Some("plc"));
        assert_eq!(misspelled("transmision", words), Some("transmission"));
        assert_eq!(misspelled("PLC", words), Some("plc"));
        assert_eq!(misspelled("hmi", words), None);
        assert_eq!(misspelled("offset_vel_to_dev", words), None);
    }

    #[test]
    fn things_are_counted_as_people_write_them() {
        assert_eq!(counted(1, "entry", "entries"), "1 entry");
    }
}

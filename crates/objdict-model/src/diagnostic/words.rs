//! Helpers for the wording of messages.

use std::borrow::Cow;

/// "1 entry", "2 entries".
pub fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// "1 bit", "8 bits".
pub fn counted_bits(bits: u8) -> String {
    counted(bits.into(), "bit", "bits")
}

/// A sub-index for messages: decimal if below 10, otherwise hex with `h`.
pub fn sub_index(sub: u8) -> String {
    if sub < 10 { sub.to_string() } else { format!("{sub:X}h") }
}

/// The known word closest to `wanted`; `None` if none is similar.
pub fn nearest<'a>(wanted: &str, words: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    closest(wanted, words, wanted.chars().count() / 3 + 1)
}

/// The known word that `wanted` obviously means: at most two letters differ, and at most a third of them.
pub fn misspelled<'a>(wanted: &str, words: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    closest(wanted, words, (wanted.chars().count() / 3).min(2))
}

fn closest<'a>(wanted: &str, words: impl IntoIterator<Item = &'a str>, most: usize) -> Option<&'a str> {
    let wanted = wanted.to_ascii_lowercase();
    let length = wanted.chars().count();
    let distance = |word: &str| edits(&wanted, &word.to_ascii_lowercase());
    // at least this many letters are added or removed; a hostile file may contain a word of a million letters
    let words = words.into_iter().filter(|word| word.chars().count().abs_diff(length) <= most);
    words
        .map(|word| (distance(word), word))
        .filter(|&(distance, _)| distance <= most)
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, word)| word)
}

/// The number of letters to change, add, remove or swap to turn one word into the other (optimal string alignment).
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

/// A character, or U+FFFD for a control character of the terminal or of the text direction.
pub fn visible(character: char) -> char {
    match character {
        '\t' => character,
        '\u{061C}'
        | '\u{200B}'..='\u{200F}'
        | '\u{2028}'..='\u{202E}'
        | '\u{2060}'..='\u{206F}'
        | '\u{FEFF}'
        | '\u{FFF9}'..='\u{FFFB}' => char::REPLACEMENT_CHARACTER,
        _ if character.is_control() => char::REPLACEMENT_CHARACTER,
        _ => character,
    }
}

/// A text as one line, because it may quote any text of a file: [`printable`], with tabs replaced by spaces.
pub fn one_line(text: &str) -> String {
    printable(text).replace('\t', " ")
}

/// Lines for output, each [`printable`].
pub fn printable_lines(text: &str) -> String {
    text.split('\n').map(printable).collect::<Vec<_>>().join("\n")
}

/// A line that is safe to print. Each character is [`visible`], and nothing is a command to a CI service that reads the
/// output: `::error::…` at the start of a line (GitHub), `##[…]`, `##vso[…]` and `##teamcity[…]` anywhere (GitHub,
/// Azure Pipelines, TeamCity). U+FFFD replaces the first character of such a command.
pub fn printable(line: &str) -> Cow<'_, str> {
    const MARKS: [&str; 3] = ["##[", "##vso[", "##teamcity["];
    // without an early exit, the compiler vectorises the loop
    let is_plain = line.bytes().fold(true, |plain, byte| plain & matches!(byte, b'\t' | b' '..=b'~'));
    let is_command = || line.trim_start().starts_with("::");
    let has_mark = || line.as_bytes().contains(&b'#') && MARKS.iter().any(|mark| line.contains(mark));
    if is_plain && !is_command() && !has_mark() {
        return Cow::Borrowed(line);
    }
    let mut text: String = line.chars().map(visible).collect();
    for mark in MARKS {
        text = text.replace(mark, &mark.replacen('#', "\u{FFFD}", 1));
    }
    if text.trim_start().starts_with("::") {
        text = text.replacen(':', "\u{FFFD}", 1);
    }
    Cow::Owned(text)
}

/// A number with its noun: `1 file`, `2 files`.
pub fn plural(count: usize, word: &str) -> String {
    if count == 1 { format!("1 {word}") } else { format!("{count} {word}s") }
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
        assert_eq!(nearest(&"n".repeat(100_000_000), ["note", "warning", "error"]), None);
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
    fn nothing_steers_a_terminal_or_a_ci_service() {
        for (text, expected) in [
            ("plain: a::b #[c] \t~", "plain: a::b #[c] \t~"),
            ("größer ↓", "größer ↓"),
            ("a\u{1B}[31m\r\u{7F}\u{9B}b", "a\u{FFFD}[31m\u{FFFD}\u{FFFD}\u{FFFD}b"),
            ("\u{202E}cba\u{2066}", "\u{FFFD}cba\u{FFFD}"),
            ("::error::x", "\u{FFFD}:error::x"),
            (" \t::error::x", " \t\u{FFFD}:error::x"),
            ("a ##[error]b", "a \u{FFFD}#[error]b"),
            ("##vso[x] ##teamcity[y]", "\u{FFFD}#vso[x] \u{FFFD}#teamcity[y]"),
        ] {
            assert_eq!(printable(text), expected);
            assert_eq!(printable(expected), expected, "twice is once");
        }
        assert_eq!(one_line("a\tb\n::c"), "a b\u{FFFD}::c");
        assert_eq!(printable_lines("a\n::b\n"), "a\n\u{FFFD}:b\n");
    }

    #[test]
    fn things_are_counted_as_people_write_them() {
        assert_eq!(counted(1, "entry", "entries"), "1 entry");
    }
}

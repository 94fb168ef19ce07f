//! Estimated width of a text: the reader's font is unknown.

/// The width of a text in a sans-serif font, rounded up.
fn width(text: &str, size: f64) -> f64 {
    text.chars().map(of).sum::<f64>() * size
}

/// The width of a character relative to the font size.
fn of(character: char) -> f64 {
    match character {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '|' | '!' | '\'' | '`' => 0.29,
        ' ' | 'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '/' | '\\' | '-' | '"' => 0.39,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | '…' => 0.93,
        'A'..='Z' | '&' | '+' | '=' | '<' | '>' | '_' | '#' | '~' => 0.70,
        '\u{0}'..='\u{2FF}' => 0.58,
        // Greek, Cyrillic and similar; then full-width characters
        '\u{300}'..='\u{10FF}' => 0.66,
        _ => 1.05,
    }
}

/// Shortens a text with an ellipsis in the middle if there is not enough room, because names of a series
/// differ at the end.
pub(super) fn fit(text: &str, room: f64, size: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let characters: Vec<char> = text.chars().collect();
    let mut left = room - width("…", size);
    let (mut head, mut tail) = (0, 0);
    while head + tail < characters.len() {
        // two characters of the start for each one of the end
        let is_tail = head > 2 * tail;
        let next = if is_tail { characters[characters.len() - 1 - tail] } else { characters[head] };
        left -= of(next) * size;
        if left < 0.0 {
            break;
        }
        if is_tail { tail += 1 } else { head += 1 }
    }
    // drop a partial word at the start of the tail
    let end = &characters[characters.len() - tail..];
    let end = end.iter().position(|&character| character == ' ').map_or(end, |space| &end[space + 1..]);
    let text = |part: &[char]| part.iter().collect::<String>();
    format!("{}…{}", text(&characters[..head]).trim_end(), text(end))
}

/// Breaks the text between words into one or two lines; `None` if they do not suffice.
pub(super) fn wrap(text: &str, room: f64, size: f64) -> Option<(String, Option<String>)> {
    if width(text, size) <= room {
        return Some((text.to_owned(), None));
    }
    let breaks = text.match_indices([' ', '_', '-']).map(|(at, mark)| {
        let (first, second) = text.split_at(at + mark.len());
        (first.trim_end(), second)
    });
    let longest = |(first, second): &(&str, &str)| width(first, size).max(width(second, size));
    let best = breaks.min_by(|a, b| longest(a).total_cmp(&longest(b)))?;
    (longest(&best) <= room).then(|| (best.0.to_owned(), Some(best.1.to_owned())))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn beginning_and_end_are_kept() {
        assert_eq!(fit("Digital input 13", 200.0, 10.0), "Digital input 13");
        assert_eq!(fit("Digital input 13", 60.0, 10.0), "Digital…13");
        assert_eq!(fit("Digital input 13", 0.0, 10.0), "…");
        assert_eq!(fit("", 0.0, 10.0), "");
    }

    #[test]
    fn lines_break_between_words() {
        let wrap = |text| wrap(text, 60.0, 10.0);
        assert_eq!(wrap("Input 1"), Some(("Input 1".into(), None)));
        assert_eq!(wrap("Digital input 13"), Some(("Digital".into(), Some("input 13".into()))));
        assert_eq!(wrap("motor_speed"), Some(("motor_".into(), Some("speed".into()))));
        assert_eq!(wrap("Geschwindigkeitsregelung"), None);
    }
}

//! Texts in a string of a style sheet.

use std::fmt::Write;

use super::shown;

/// The text between the quotes of a string on one line. All but letters, digits and blanks is escaped, so it ends neither the string nor the
/// `<style>` that has it.
pub(super) fn string(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        match shown(character, characters.peek().copied()) {
            None => {}
            Some('\n') => written.push(' '),
            Some(plain) if plain.is_ascii_alphanumeric() || plain == ' ' => written.push(plain),
            Some(other) => {
                let _ = write!(written, "\\{:06X}", u32::from(other)); // writing to a String cannot fail
            }
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::string;

    #[test]
    fn nothing_ends_the_string() {
        assert_eq!(string("Servo 5"), "Servo 5");
        assert_eq!(
            string("a\"}</style>\\\r\n\u{202E}"),
            "a\\000022\\00007D\\00003C\\00002Fstyle\\00003E\\00005C \\00FFFD"
        );
    }
}

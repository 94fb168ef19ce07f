//! Escaping for HTML and SVG: in text, in quoted attributes, in strings of style sheets, and in URLs.

use std::fmt::{self, Write};

use super::shown;
use askama::filters::Escaper;

/// The escaper of `.html` and `.svg` templates.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Html;

impl Escaper for Html {
    fn write_escaped_str<W: fmt::Write>(&self, mut dest: W, text: &str) -> fmt::Result {
        // fast path: most texts are names and numbers, and a page of a large device contains a hundred
        // thousand of them
        if text.bytes().all(is_plain) && !text.trim_start().starts_with("::") {
            return dest.write_str(text);
        }
        let mut written = 0;
        // whether only whitespace precedes in the line
        let mut starts_line = true;
        let mut characters = text.char_indices().peekable();
        while let Some((at, character)) = characters.next() {
            let next = characters.peek().map(|(_, next)| *next);
            let was_start = starts_line;
            starts_line = is_blank(character, was_start);
            let reference = match character {
                // a printed page must not contain commands for CI services, see `diagnostic::printable`
                '#' if next == Some('#') => "&#35;",
                ':' if was_start && next == Some(':') => "&#58;",
                '&' => "&amp;",
                '<' => "&lt;",
                '>' => "&gt;",
                '"' => "&quot;",
                '\'' => "&#39;",
                ' '..='~' => continue,
                _ => match shown(character, next) {
                    Some(same) if same == character => continue,
                    Some('\n') => "\n",
                    Some(_) => "\u{FFFD}",
                    None => "",
                },
            };
            dest.write_str(&text[written..at])?;
            dest.write_str(reference)?;
            written = at + character.len_utf8();
        }
        dest.write_str(&text[written..])
    }
}

/// Whether a character needs no escaping.
const fn is_plain(byte: u8) -> bool {
    matches!(byte, b' '..=b'~') && !matches!(byte, b'&' | b'<' | b'>' | b'"' | b'\'' | b'#')
}

/// Whether a line contains only whitespace up to and including a character.
fn is_blank(character: char, starts_line: bool) -> bool {
    matches!(character, '\n' | '\r') || (starts_line && character.is_whitespace())
}

/// A text as HTML on one line.
pub(super) fn one_line(text: &str) -> String {
    let mut written = String::with_capacity(text.len() + 8);
    let _ = Html.write_escaped_str(&mut written, text); // writing to a String cannot fail
    written.replace('\n', "<br>")
}

/// The text between the quotes of a string on one line. Everything except letters, digits and spaces is escaped, so it
/// ends neither the string nor its `<style>`.
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

/// The relative URL of a file in the same folder, percent-encoded so that no name becomes a different URL.
pub(crate) fn address(name: &str) -> String {
    let mut address = String::with_capacity(name.len());
    for &byte in name.as_bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' => address.push(char::from(byte)),
            _ => {
                let _ = write!(address, "%{byte:02X}"); // writing to a String cannot fail
            }
        }
    }
    address
}

#[cfg(test)]
mod tests {
    use super::super::tests::text_of;
    use super::{address, string, *};
    use proptest::prelude::*;

    fn escaped(text: &str) -> String {
        let mut written = String::new();
        Html.write_escaped_str(&mut written, text).unwrap();
        written
    }

    #[test]
    fn markup_is_text() {
        assert_eq!(
            escaped("</title><script>'a' & \"b\""),
            "&lt;/title&gt;&lt;script&gt;&#39;a&#39; &amp; &quot;b&quot;"
        );
        assert_eq!(escaped("::a\n ::b::c ##[d] #e"), "&#58;:a\n &#58;:b::c &#35;#[d] #e");
        assert_eq!(
            escaped("a\0b\u{202E}\r\nc\rd\u{1B}[31m Größe 速度"),
            "a\u{FFFD}b\u{FFFD}\nc\nd\u{FFFD}[31m Größe 速度"
        );
    }

    proptest! {
        /// An XML reader gets the original text, in text and in attributes. (Newlines in attributes become
        /// spaces in XML only.)
        #[test]
        fn comes_back(text in "(?s).{0,40}") {
            let text = text.replace(['\u{FFFE}', '\u{FFFF}'], ""); // not allowed in XML
            let page = format!("<p title=\"{0}\">{0}</p>", escaped(&text));
            let tree = roxmltree::Document::parse(&page).unwrap();
            let expected = text_of(&text);
            prop_assert_eq!(tree.root_element().text().unwrap_or_default(), &expected);
            let blanks = expected.replace(['\n', '\t'], " ");
            prop_assert_eq!(tree.root_element().attribute("title"), Some(blanks.as_str()));
        }
    }

    #[test]
    fn nothing_ends_the_string() {
        assert_eq!(string("Servo 5"), "Servo 5");
        assert_eq!(
            string("a\"}</style>\\\r\n\u{202E}"),
            "a\\000022\\00007D\\00003C\\00002Fstyle\\00003E\\00005C \\00FFFD"
        );
    }

    #[test]
    fn addresses_stay_in_the_folder() {
        assert_eq!(address("javascript:alert(1).html"), "javascript%3Aalert%281%29.html");
        assert_eq!(address("a b#c?.md"), "a%20b%23c%3F.md");
        assert_eq!(address("Größe.md"), "Gr%C3%B6%C3%9Fe.md");
    }
}

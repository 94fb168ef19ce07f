//! Characters and names, as XML 1.0 (fifth edition) and Namespaces in XML 1.0 define them.

/// White space.
const BLANK: u8 = 1;
/// Ends a name in a tag, valid or not.
const ENDS_NAME: u8 = 2;
/// An ASCII character that can start a name.
const NAME_START: u8 = 4;
/// An ASCII character that a name can contain.
const NAME: u8 = 8;

/// Ends the value of an attribute, or changes the value when it is resolved.
const STOP: u8 = 16;

/// The classes of each byte.
const CLASSES: [u8; 256] = {
    let mut classes = [0; 256];
    let mut byte = 0;
    while byte < 128 {
        let character = byte as u8 as char;
        let mut class = 0;
        if matches!(character, ' ' | '\t' | '\n' | '\r') {
            class |= BLANK | ENDS_NAME;
        }
        if matches!(character, '=' | '>' | '<' | '/' | '"' | '\'' | '?') {
            class |= ENDS_NAME;
        }
        if matches!(character, '"' | '\'' | '<' | '&' | '\t' | '\n' | '\r') {
            class |= STOP;
        }
        if is_name_start(character) {
            class |= NAME_START;
        }
        if is_name_char(character) {
            class |= NAME;
        }
        classes[byte] = class;
        byte += 1;
    }
    classes
};

/// Whether a byte is white space (XML 1.0 §2.3).
pub(super) const fn is_blank(byte: u8) -> bool {
    CLASSES[byte as usize] & BLANK != 0
}

/// Whether a byte ends a name in a tag, valid or not.
pub(super) const fn ends_name(byte: u8) -> bool {
    CLASSES[byte as usize] & ENDS_NAME != 0
}

/// The number of leading bytes that are ASCII name characters except the colon.
pub(super) fn plain_name_length(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| CLASSES[usize::from(**byte)] & NAME != 0).count()
}

/// The number of leading bytes of a value that are used unchanged.
pub(super) fn plain_value_length(bytes: &[u8]) -> usize {
    bytes.iter().take_while(|byte| CLASSES[usize::from(**byte)] & STOP == 0).count()
}

/// Whether `text` contains only whitespace.
pub(super) fn is_blank_text(text: &str) -> bool {
    text.bytes().all(is_blank)
}

/// Whether XML 1.0 forbids the character in documents (§2.2).
pub(super) const fn is_forbidden(character: char) -> bool {
    matches!(character, '\0'..='\u{8}' | '\u{B}' | '\u{C}' | '\u{E}'..='\u{1F}' | '\u{FFFE}' | '\u{FFFF}')
}

const fn is_name_start(character: char) -> bool {
    matches!(character, 'A'..='Z' | 'a'..='z' | '_' | '\u{C0}'..='\u{D6}' | '\u{D8}'..='\u{F6}' | '\u{F8}'..='\u{2FF}'
        | '\u{370}'..='\u{37D}' | '\u{37F}'..='\u{1FFF}' | '\u{200C}'..='\u{200D}' | '\u{2070}'..='\u{218F}'
        | '\u{2C00}'..='\u{2FEF}' | '\u{3001}'..='\u{D7FF}' | '\u{F900}'..='\u{FDCF}' | '\u{FDF0}'..='\u{FFFD}'
        | '\u{10000}'..='\u{EFFFF}')
}

pub(crate) const fn is_name_char(character: char) -> bool {
    is_name_start(character)
        || matches!(character, '0'..='9' | '-' | '.' | '\u{B7}' | '\u{300}'..='\u{36F}' | '\u{203F}'..='\u{2040}')
}

/// Whether `name` is a name without colon: the local name of an element, a prefix, the name of an entity.
pub(crate) fn is_name(name: &str) -> bool {
    is_plain_name(name.as_bytes()) || is_any_name(name)
}

fn is_plain_name(name: &[u8]) -> bool {
    let is_start = name.first().is_some_and(|&byte| CLASSES[usize::from(byte)] & NAME_START != 0);
    is_start && name.iter().all(|&byte| CLASSES[usize::from(byte)] & NAME != 0)
}

fn is_any_name(name: &str) -> bool {
    let mut characters = name.chars();
    characters.next().is_some_and(is_name_start) && characters.all(is_name_char)
}

/// The length of the prefix with its colon, 0 without prefix; `None` if `name` is not a qualified name.
pub(super) fn prefix_length(name: &str) -> Option<usize> {
    if is_plain_name(name.as_bytes()) {
        return Some(0);
    }
    match name.split_once(':') {
        None => is_name(name).then_some(0),
        Some((prefix, local)) => (is_name(prefix) && is_name(local)).then_some(prefix.len() + 1),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names() {
        for name in ["a", "_", "Größe", "a-1.b", "名"] {
            assert_eq!(prefix_length(name), Some(0), "{name}");
        }
        assert_eq!(prefix_length("q1:a"), Some(3));
        for name in ["", "1a", "-a", "a b", ":a", "a:", "a:b:c", "a:1", "a$"] {
            assert_eq!(prefix_length(name), None, "{name}");
        }
    }
}

//! Names of files that every system can have.

/// Names that Windows reserves for devices, in any case and with any extension (Microsoft, *Naming Files,
/// Paths, and Namespaces*).
const DEVICES: [&str; 6] = ["CON", "PRN", "AUX", "NUL", "CONIN$", "CONOUT$"];

/// The reason why a name without separators is not valid on every system; `None` if it is valid.
pub fn unportable(name: &str) -> Option<&'static str> {
    match name {
        "" | "." | ".." => Some("it points to a different folder"),
        _ if name.contains(is_forbidden) => Some("Windows does not allow its characters"),
        _ if name.ends_with(['.', ' ']) => Some("Windows does not allow a dot or a space at its end"),
        _ if is_device_name(name) => Some("Windows reserves it for a device"),
        _ => None,
    }
}

fn is_forbidden(character: char) -> bool {
    character.is_control() || "<>:\"|?*\\".contains(character)
}

/// The name with `_` for characters that some systems do not allow in file names; without extension.
pub fn portable(name: &str) -> String {
    let name = name.replace(|character: char| is_forbidden(character) || character == '/', "_");
    let mut name = name.trim_end_matches(['.', ' ']).to_owned();
    if name.is_empty() || is_device_name(&name) {
        // Windows checks the part before the first dot
        name.insert(0, '_');
    }
    name
}

/// Whether Windows treats a name as a device: `con`, `AUX.txt`, `com1 .log`.
pub fn is_device_name(name: &str) -> bool {
    let stem = name.split(['.', ':']).next().unwrap_or_default().trim_end_matches(' ').to_ascii_uppercase();
    let port = stem.strip_prefix("COM").or_else(|| stem.strip_prefix("LPT"));
    DEVICES.contains(&stem.as_str())
        || port.is_some_and(|number| {
            matches!(number, "\u{B9}" | "\u{B2}" | "\u{B3}")
                || matches!(number.as_bytes(), [digit] if digit.is_ascii_digit())
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn portable_names_are_valid() {
        let names = ["a:b", "a/b", "CON", "con.x", "..", " ", "", "a. .", "a\\b\u{7}", "PLC", "ü", "a b"];
        let portable = names.map(portable);
        let expected = ["a_b", "a_b", "_CON", "_con.x", "_", "_", "_", "a", "a_b_", "PLC", "ü", "a b"];
        assert_eq!(portable, expected);
        assert!(portable.iter().all(|name| unportable(name).is_none()));
    }
}

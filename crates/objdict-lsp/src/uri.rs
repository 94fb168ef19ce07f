//! Addresses of files: `file:///a%20b.eds` and paths.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use super::protocol::Uri;
use objdict_model::source::absolute;

/// The path of an address, also of a file that is not saved yet; `None` for one that is not on this computer.
pub(super) fn path_of(uri: &str) -> Option<PathBuf> {
    if let Some(name) = uri.strip_prefix("untitled:") {
        return Some(absolute(Path::new(&decoded(name)?)));
    }
    let encoded = uri.strip_prefix("file://")?;
    let encoded = encoded.strip_prefix("localhost").unwrap_or(encoded);
    let text = decoded(encoded.split(['?', '#']).next()?)?;
    let text = match text.as_bytes() {
        // `/C:/folder`
        [b'/', letter, b':', ..] if cfg!(windows) && letter.is_ascii_alphabetic() => &text[1..],
        [b'/', ..] => &text,
        _ => return None,
    };
    Some(absolute(Path::new(text)))
}

/// The address of a path.
pub(super) fn of_path(path: &Path) -> Option<Uri> {
    let text = absolute(path).to_str()?.replace('\\', "/");
    let mut uri = String::from(if text.starts_with('/') { "file://" } else { "file:///" });
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'/' | b'-' | b'_' | b'.' | b'~' => {
                uri.push(byte.into());
            }
            byte => {
                let _ = write!(uri, "%{byte:02X}");
            }
        }
    }
    Some(uri)
}

/// A text without percent signs; `None` where that is not UTF-8.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, behind @ ..] = rest {
        let hex = behind.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
        match hex.filter(|_| *first == b'%').and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &behind[2..];
            }
            None => {
                bytes.push(*first);
                rest = behind;
            }
        }
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn addresses_and_paths_are_the_same() {
        let path = Path::new("/a b/ü#?%/c:d.eds");
        let uri = of_path(path).unwrap();
        assert_eq!(uri, "file:///a%20b/%C3%BC%23%3F%25/c%3Ad.eds");
        assert_eq!(path_of(&uri).unwrap(), path);
        let of = path_of;
        assert_eq!(of("file:///a/../b.eds").unwrap(), Path::new("/b.eds"));
        assert_eq!(of("untitled:Untitled-1").unwrap(), absolute(Path::new("Untitled-1")));
        assert_eq!(of("untitled:/a%20b.dcf").unwrap(), Path::new("/a b.dcf"));
        assert_eq!(of("file://server/share/a.eds"), None);
    }
}

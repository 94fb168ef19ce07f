//! URLs.

use std::fmt::Write;

/// The relative URL of a file in the same folder, percent-encoded so that no name becomes another URL.
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
    use super::address;

    #[test]
    fn addresses_stay_in_the_folder() {
        assert_eq!(address("javascript:alert(1).html"), "javascript%3Aalert%281%29.html");
        assert_eq!(address("a b#c?.md"), "a%20b%23c%3F.md");
        assert_eq!(address("Größe.md"), "Gr%C3%B6%C3%9Fe.md");
    }
}

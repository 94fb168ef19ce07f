//! Words that messages are made of.

use std::fmt::Display;

/// "`a`, `b` and `c`": all items in backticks.
pub(crate) fn listing<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    series(items.into_iter().map(|item| format!("`{item}`")))
}

/// "a, b and c".
pub(crate) fn series<T: Display>(items: impl IntoIterator<Item = T>) -> String {
    let mut text = String::new();
    let mut items = items.into_iter().peekable();
    while let Some(item) = items.next() {
        let separator = match (text.is_empty(), items.peek().is_some()) {
            (true, _) => "",
            (false, true) => ", ",
            (false, false) => " and ",
        };
        text.push_str(&format!("{separator}{item}"));
    }
    text
}

/// "1 entry", "2 entries".
pub(crate) fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// A sub-index as people write it: in decimal where that is the same, else in hex with `h`.
pub(crate) fn sub_index(sub: u8) -> String {
    if sub < 10 { sub.to_string() } else { format!("{sub:X}h") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_are_listed_as_people_write_them() {
        assert_eq!(listing(["a"]), "`a`");
        assert_eq!(listing(["a", "b"]), "`a` and `b`");
        assert_eq!(series(["a", "b", "c"]), "a, b and c");
        assert_eq!(counted(1, "entry", "entries"), "1 entry");
    }
}

//! Which signals are shown.

/// A signal as a user names it: `6064`, `6064:0`, `Position actual value`, each with a node in front as in `drive.6064` or `5.6064`.
#[derive(Clone, Debug)]
pub(crate) struct PlotChoice {
    pub(crate) text: String,
    /// Whether a signal is it.
    pub(crate) is_found: bool,
}

impl PlotChoice {
    pub(crate) fn new(text: &str) -> Self {
        Self { text: text.trim().to_owned(), is_found: false }
    }

    /// Whether it is an entry of a node.
    pub(super) fn is_for(&self, (node_id, node): (u8, &str), entry: (u16, u8), name: &str) -> bool {
        let is_entry =
            |text: &str| is_address(text, entry) || !name.is_empty() && text.eq_ignore_ascii_case(name);
        // names have points too, so each of them may be the one behind the node
        let mut parts = self.text.match_indices('.').map(|(at, _)| self.text.split_at(at));
        let is_node = |text: &str| text == node || text.parse() == Ok(node_id);
        is_entry(&self.text) || parts.any(|(before, behind)| is_node(before) && is_entry(&behind[1..]))
    }
}

/// Whether a text is the address of an entry, with or without its sub-index.
fn is_address(text: &str, (index, sub): (u16, u8)) -> bool {
    let hex = |text: &str| u16::from_str_radix(text.trim_start_matches("0x"), 16).ok();
    match text.split_once(':') {
        Some((before, behind)) => hex(before) == Some(index) && hex(behind) == Some(sub.into()),
        None => text.len() >= 4 && hex(text) == Some(index),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signals_have_several_names() {
        let is_it = |text| PlotChoice::new(text).is_for((5, "drive"), (0x6064, 0), "Pos. actual value");
        for text in [
            "6064",
            "0x6064",
            "6064:0",
            "pos. actual value",
            "5.6064",
            "drive.6064:00",
            "drive.Pos. actual value",
        ] {
            assert!(is_it(text), "{text}");
        }
        for text in ["6065", "6064:1", "6.6064", "motor.6064", "actual value", "", "5.", "."] {
            assert!(!is_it(text), "{text}");
        }
        assert!(!PlotChoice::new("").is_for((5, ""), (0, 0), ""));
    }
}

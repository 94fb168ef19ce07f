//! Which signals are drawn.

use std::str::FromStr;

/// What a user calls a signal: `6064`, `6064:0`, `Position actual value`, and with a node `drive.6064` or `5.Position actual value`.
#[derive(Clone, Debug)]
pub struct PlotChoice {
    /// The text that names the value.
    pub text: String,
}

/// A signal that may be chosen.
#[derive(Clone, Copy, Debug)]
pub(super) struct OfferedSignal<'s> {
    pub(super) node_id: u8,
    pub(super) node: &'s str,
    /// Index and sub-index; `None` for what no entry has.
    pub(super) entry: Option<(u16, u8)>,
    pub(super) name: &'s str,
}

impl PlotChoice {
    pub(super) fn is_for(&self, signal: &OfferedSignal<'_>) -> bool {
        // a name of a node or of an entry may have points itself
        let mut points = self.text.match_indices('.').map(|(at, _)| self.text.split_at(at));
        signal.is_called(&self.text)
            || points.any(|(node, name)| signal.is_of(node) && signal.is_called(&name[1..]))
    }
}

impl OfferedSignal<'_> {
    fn is_of(&self, node: &str) -> bool {
        node.eq_ignore_ascii_case(self.node) || node.parse() == Ok(self.node_id)
    }

    fn is_called(&self, name: &str) -> bool {
        let is_entry = || match (address(name), self.entry) {
            (Some((index, sub)), Some(entry)) => index == entry.0 && sub.is_none_or(|sub| sub == entry.1),
            _ => false,
        };
        name.eq_ignore_ascii_case(self.name) || is_entry()
    }
}

/// An index in hex, with or without a sub-index: `6041`, `1018:1`.
pub fn address(text: &str) -> Option<(u16, Option<u8>)> {
    let (index, sub) = text.split_once(':').map_or((text, None), |(index, sub)| (index, Some(sub)));
    let digits = |text: &'_ str| text.strip_prefix("0x").unwrap_or(text).to_owned();
    let index = u16::from_str_radix(&digits(index), 16).ok()?;
    let sub = match sub {
        Some(sub) => Some(u8::from_str_radix(&digits(sub), 16).ok()?),
        None => None,
    };
    Some((index, sub))
}

impl FromStr for PlotChoice {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, &'static str> {
        let text = text.trim();
        if text.is_empty() {
            return Err("name an entry, as in `6064`, `drive.6064` or `Position actual value`");
        }
        Ok(Self { text: text.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signals_are_found_by_address_name_and_node() {
        let position = OfferedSignal {
            node_id: 5,
            node: "x.drive",
            entry: Some((0x6064, 0)),
            name: "Pos. actual value",
        };
        let is_chosen = |text: &str| text.parse::<PlotChoice>().unwrap().is_for(&position);
        for text in [
            "6064",
            "0x6064",
            "6064:0",
            "5.6064",
            "X.DRIVE.6064:00",
            "pos. actual value",
            "5.Pos. actual value",
        ] {
            assert!(is_chosen(text), "{text}");
        }
        for text in ["6065", "6064:1", "6.6064", "drive.6064", "actual value", "5", "."] {
            assert!(!is_chosen(text), "{text}");
        }
        assert!(" ".parse::<PlotChoice>().is_err());
    }
}

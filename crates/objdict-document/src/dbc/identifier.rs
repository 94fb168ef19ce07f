//! Names of nodes, messages and signals: identifiers of C.

use std::collections::HashSet;

use crate::source::transliterate;

/// The longest name; a longer one is an attribute.
const LONGEST: usize = 32;
/// The longest name in an attribute.
const LONGEST_FULL: usize = 128;

/// A name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct DbcName {
    /// At most 32 characters.
    pub(super) short: String,
    /// The name in full if it is longer.
    pub(super) full: Option<String>,
}

/// The words of a text, joined by `_`; empty if it has no ASCII letter or digit.
pub(super) fn words(text: &str) -> String {
    let mut joined = String::new();
    let plain = |c: char| transliterate(c).map_or_else(|| c.to_string(), str::to_owned);
    for c in text.chars().flat_map(|c| plain(c).chars().collect::<Vec<_>>()) {
        if c.is_ascii_alphanumeric() {
            joined.push(c);
        } else if !joined.is_empty() && !joined.ends_with('_') {
            joined.push('_');
        }
        if joined.len() >= LONGEST_FULL {
            break;
        }
    }
    joined.truncate(joined.trim_end_matches('_').len());
    if joined.starts_with(|c: char| c.is_ascii_digit()) {
        joined.insert(0, '_');
    }
    joined
}

/// The names that are in use.
#[derive(Clone, Debug, Default)]
pub(super) struct DbcNames {
    taken: HashSet<String>,
}

impl DbcNames {
    /// A name of these words. If it is in use, `suffix` is added, which makes it unique or nearly so.
    pub(super) fn claim(&mut self, words: &str, suffix: &str) -> DbcName {
        let full = match words {
            "" => self.free(&format!("x{suffix}"), suffix, LONGEST_FULL),
            words => self.free(words, suffix, LONGEST_FULL),
        };
        if full.len() <= LONGEST {
            self.taken.insert(full.clone());
            return DbcName { short: full, full: None };
        }
        let short = self.free(clip(&full, LONGEST), suffix, LONGEST);
        self.taken.extend([short.clone(), full.clone()]);
        DbcName { short, full: Some(full) }
    }

    fn free(&self, name: &str, suffix: &str, longest: usize) -> String {
        let mut behind = String::new();
        for number in 1_u32.. {
            let candidate = format!("{}{behind}", clip(name, longest - behind.len()));
            if !self.taken.contains(&candidate) {
                return candidate;
            }
            behind = if number == 1 { format!("_{suffix}") } else { format!("_{suffix}_{number}") };
        }
        name.to_owned() // there are fewer names than numbers
    }
}

/// The first bytes of a name, without a trailing `_`.
fn clip(name: &str, length: usize) -> &str {
    name[..name.len().min(length)].trim_end_matches('_')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_become_identifiers() {
        for (text, expected) in [
            ("Position actual value", "Position_actual_value"),
            ("8-bit input", "_8_bit_input"),
            ("Größe [µm]", "Groesse_um"),
            ("  \"; BO_ 1 ", "BO_1"),
            ("速度", ""),
        ] {
            assert_eq!(words(text), expected, "{text}");
        }
    }

    #[test]
    fn long_names_are_cut_and_stay_unique() {
        let mut scope = DbcNames::default();
        let long = "Velocity_demand_value_of_the_first_axis";
        let names = [
            scope.claim(long, "606B_00"),
            scope.claim(&format!("{long}_2"), "6B6B_00"),
            scope.claim(long, "6070_00"),
        ];
        let shown = names.map(|name| (name.short, name.full.unwrap()));
        let full = |text: &str| text.to_owned();
        assert_eq!(shown[0], (full("Velocity_demand_value_of_the_fir"), full(long)));
        assert_eq!(
            shown[1],
            (full("Velocity_demand_value_of_6B6B_00"), full("Velocity_demand_value_of_the_first_axis_2"))
        );
        assert_eq!(shown[2].1, "Velocity_demand_value_of_the_first_axis_6070_00");
        assert_eq!(scope.claim("", "2000_01").short, "x2000_01");
        assert_eq!(scope.claim("", "2000_01").short, "x2000_01_2000_01");
    }
}

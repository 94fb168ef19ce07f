//! Naming rule of CANopenNode tables. Applications use these names, so they must match those of the original
//! generator.

use std::collections::HashSet;

use crate::StackLayout;
use crate::c_words::{distinct, is_reserved};
use crate::names::without_mark;

/// Maximum length of a name. Applications write names in full, so they are only truncated beyond the maximum
/// of the standard (`ParameterName` has up to 241 characters).
const LONGEST: usize = 240;

/// The editor whose names are generated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Naming {
    /// CANopenEditor, for CANopenNode 4.
    Current,
    /// Names from before July 2021: `_` also before and after a word with a digit.
    Before2021,
    /// libEDSsharp and CANopenEditor for CANopenNode 1.3: `-` separates words.
    Legacy,
}

impl From<StackLayout> for Naming {
    fn from(layout: StackLayout) -> Self {
        match layout {
            StackLayout::CanOpenEditor2020 => Self::Before2021,
            _ => Self::Current,
        }
    }
}

/// The C name of an object or entry; empty if the text has no usable character.
///
/// Words are joined in camel case; the first word starts in lower case unless it is an abbreviation. `-`
/// becomes `_`, and `_` separates two abbreviations. Accents of Latin letters are removed; all other
/// characters separate words.
pub(crate) fn cname(name: &str, naming: Naming) -> String {
    let is_old = naming == Naming::Before2021;
    let plain: String = name.chars().take(4 * LONGEST).map(without_mark).collect();
    let plain = if naming == Naming::Legacy { plain } else { plain.replace('-', "_") };
    let mut joined = String::new();
    let mut words = plain.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    while let (Some(word), true) = (words.next(), joined.len() < LONGEST) {
        let meets_digit =
            is_old && (joined.ends_with(is_digit) || !joined.is_empty() && word.starts_with(is_digit));
        if meets_digit || joined.ends_with(is_capital) && word.starts_with(is_capital) {
            joined.push('_');
        }
        match word.char_indices().nth(1).filter(|_| !meets_digit) {
            Some((second, _)) => {
                joined.push_str(&word[..second].to_ascii_uppercase());
                joined.push_str(&word[second..]);
            }
            None => joined.push_str(word), // a single letter keeps its case
        }
    }
    if joined.bytes().all(|byte| byte == b'_') {
        return String::new();
    }
    if joined.starts_with(is_digit) {
        joined.insert(0, '_');
    }
    joined.truncate(LONGEST); // the text is ASCII
    let second_is_small = joined.as_bytes().get(1).is_none_or(u8::is_ascii_lowercase);
    if second_is_small && let Some(first) = joined.get_mut(..1) {
        first.make_ascii_lowercase();
    }
    joined
}

/// The name after an index: `2000_setpoint`, or `2000` without a name.
pub(super) fn behind_index(index: u16, cname: &str) -> String {
    if cname.is_empty() { format!("{index:04X}") } else { format!("{index:04X}_{cname}") }
}

/// The member names of a record.
pub(crate) struct MemberNames {
    naming: Naming,
    taken: HashSet<String>,
}

impl MemberNames {
    pub(crate) fn new(naming: impl Into<Naming>) -> Self {
        Self { naming: naming.into(), taken: HashSet::new() }
    }

    /// Claims the member name for an entry: its own name, or a similar one that is valid and free.
    pub(crate) fn claim(&mut self, name: &str, sub: u8) -> String {
        let cname = cname(name, self.naming);
        let plain = if cname.is_empty() { format!("sub{sub:02X}") } else { cname };
        let plain = match is_reserved(&plain) {
            true if plain.starts_with('_') => format!("x{plain}"), // names of the compiler
            true => format!("{plain}_"),
            false => plain,
        };
        match self.naming {
            Naming::Legacy => numbered(&mut self.taken, &plain),
            _ => distinct(&mut self.taken, plain, &format!("{sub:02X}")),
        }
    }
}

/// A free name as in libEDSsharp: `mode`, `mode1`, `mode2`.
fn numbered(taken: &mut HashSet<String>, name: &str) -> String {
    let mut free = name.to_owned();
    let mut number = 0;
    while !taken.insert(free.clone()) {
        number += 1;
        free = format!("{name}{number}");
    }
    free
}

fn is_capital(c: char) -> bool {
    c.is_ascii_uppercase()
}

fn is_digit(c: char) -> bool {
    c.is_ascii_digit()
}

/// Letters, digits and `_` of a string, for a group or label.
pub(super) fn word(text: &str) -> String {
    let plain: String = text.trim().chars().map(without_mark).collect();
    plain.replace(|c: char| !c.is_ascii_alphanumeric() && c != '_', "_")
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::c_words::RESERVED;

    #[test]
    fn names_are_those_that_applications_write() {
        for (name, expected) in [
            ("Device type", "deviceType"),
            ("COB-ID SYNC message", "COB_ID_SYNCMessage"),
            ("COB-ID time stamp object", "COB_IDTimeStampObject"),
            ("COB-ID EMCY", "COB_ID_EMCY"),
            ("Vendor-ID", "vendor_ID"),
            ("Pre-defined error field", "pre_definedErrorField"),
            ("RPDO communication parameter", "RPDOCommunicationParameter"),
            ("Highest sub-index supported", "highestSub_indexSupported"),
            ("Node-ID of the SDO server", "node_IDOfTheSDOServer"),
            ("Axis X position", "axisXPosition"),
            ("2nd axis", "_2ndAxis"),
            ("X", "x"),
            ("OD_CNT_NMT", "OD_CNT_NMT"),
            ("Größe", "grose"),
            ("速度", ""),
            (" -- ", ""),
        ] {
            assert_eq!(cname(name, Naming::Current), expected, "{name}");
        }
        assert_eq!(cname(&"very long ".repeat(1000), Naming::Current).len(), LONGEST);
        for (name, expected) in [
            ("Cell 1 Temp", "cell_1_Temp"),
            ("RPDO 2 mapped object 4", "RPDO_2_mappedObject_4"),
            ("COB-ID used by PDO", "COB_IDUsedByPDO"),
            ("Device type", "deviceType"),
        ] {
            assert_eq!(cname(name, Naming::Before2021), expected, "{name}");
        }
        for (name, expected) in [
            ("Power-on counter", "powerOnCounter"),
            ("COB-ID SYNC message", "COB_ID_SYNCMessage"),
            ("Vendor-ID", "vendorID"),
            ("Cell 1 Temp", "cell1Temp"),
        ] {
            assert_eq!(cname(name, Naming::Legacy), expected, "{name}");
        }
        let mut members = MemberNames::new(Naming::Legacy);
        assert_eq!([1, 2, 3].map(|sub| members.claim("Mode", sub)), ["mode", "mode1", "mode2"]);
    }

    #[test]
    fn members_are_distinguished() {
        let mut members = MemberNames::new(Naming::Current);
        assert_eq!(members.claim("Mode", 1), "mode");
        assert_eq!(members.claim("mode", 2), "mode_02");
        assert_eq!(members.claim("mode_03", 2), "mode_03");
        assert_eq!(members.claim("Mode", 3), "mode_03_2");
        assert_eq!(members.claim("default", 4), "default_");
        assert_eq!(members.claim("Operator", 5), "operator_");
        assert_eq!(members.claim("", 6), "sub06");
        assert_eq!(members.claim("UINT8_MAX", 7), "UINT8_MAX_");
        assert_eq!(members.claim("OD_CNT_NMT", 8), "OD_CNT_NMT_");
        assert_eq!(members.claim("data", 9), "data");
    }

    proptest! {
        #[test]
        fn any_names_become_valid_and_unique_members(
            names in proptest::collection::vec(prop_oneof![any::<String>(), "[a-bA-B_ -]{0,3}"], 0..40)
        ) {
            let mut members = MemberNames::new(Naming::Current);
            let mut seen = HashSet::new();
            for (name, sub) in names.iter().zip(0_u8..) {
                let member = members.claim(name, sub);
                prop_assert!(member.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_'));
                prop_assert!(!member.starts_with(|c: char| c.is_ascii_digit()));
                let is_word = RESERVED.split_ascii_whitespace().any(|word| word == member);
                prop_assert!(!is_word && !member.starts_with("__"));
                prop_assert!(seen.insert(member));
            }
        }
    }
}

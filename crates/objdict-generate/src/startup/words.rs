//! The reason why a PDO is not served, as text.

use std::collections::BTreeSet;

use super::PdoCause;
use crate::model::{MappedObject, PdoKind};

/// A cause with the affected mapped objects, and advice.
pub(super) fn why(cause: PdoCause, kind: PdoKind, mapped: &BTreeSet<MappedObject>) -> (String, &'static str) {
    let other = match kind {
        PdoKind::Rpdo => PdoKind::Tpdo,
        PdoKind::Tpdo => PdoKind::Rpdo,
    };
    let entries = entries(mapped);
    let be = if mapped.len() > 1 { "are" } else { "is" };
    let text = match cause {
        PdoCause::Number => "the stack counts PDOs in 8 bits".to_owned(),
        PdoCause::NoTransmissionType => "sub-index 2 is not an 8-bit transmission type".to_owned(),
        PdoCause::NoCobId => "sub-index 1 is not a 32-bit COB-ID".to_owned(),
        PdoCause::RtrAllowed => "bit 30 of the COB-ID is clear (RTR allowed)".to_owned(),
        PdoCause::Extended => "the CAN-ID has 29 bits".to_owned(),
        PdoCause::NoCanId | PdoCause::OnNmt => "the CAN-ID is 0".to_owned(),
        PdoCause::NotDispatched => "the stack accepts only CAN-IDs 180h to 57Fh for PDOs".to_owned(),
        PdoCause::Taken => "an RPDO before it has the same CAN-ID, valid or not".to_owned(),
        PdoCause::NoMapping => "the mapping is missing".to_owned(),
        PdoCause::TooMany | PdoCause::Overrun => {
            "the stack maps at most 8 objects and does not support multiplexed PDOs".to_owned()
        }
        PdoCause::NoSlot => "sub-index 0 of the mapping includes missing entries".to_owned(),
        PdoCause::TooLong => "more than 8 bytes are mapped".to_owned(),
        PdoCause::Empty => "nothing is mapped".to_owned(),
        PdoCause::Reserved => "the transmission type is not 0 to 240, 254 or 255".to_owned(),
        PdoCause::NoTrigger => "neither events nor SYNCs nor RTRs trigger its transmission type".to_owned(),
        PdoCause::SyncStart => "the SYNC start value is above 240".to_owned(),
        PdoCause::Dummy => format!("{entries} cannot be mapped as dummy entries"),
        PdoCause::Missing => format!("{entries} {be} missing"),
        PdoCause::Bits => {
            format!("{entries} {be} mapped with a length that is not a multiple of 8 bits")
        }
        PdoCause::Direction => format!("{entries} can be mapped to {other}s only"),
        PdoCause::NotMappable => format!("{entries} cannot be mapped to PDOs"),
        PdoCause::Constant => format!("{entries} {be} in flash"),
        PdoCause::Short => format!("{entries} {be} shorter than their part of the PDO"),
        PdoCause::Size | PdoCause::Length => {
            format!("{entries} {be} not as long as their part of the PDO")
        }
    };
    (text, help(cause))
}

const fn help(cause: PdoCause) -> &'static str {
    match cause {
        PdoCause::Number => "use the first 255 PDOs",
        PdoCause::NoTransmissionType | PdoCause::NoCobId => "describe the entry with this data type",
        PdoCause::RtrAllowed => "set bit 30, as in `$NODEID+0x40000180`",
        PdoCause::Extended => "use an 11-bit CAN-ID",
        PdoCause::NoCanId | PdoCause::OnNmt => "write a CAN-ID, or set bit 31 if the PDO is not in use",
        PdoCause::NotDispatched => "use one of these",
        PdoCause::Taken => "use a unique CAN-ID",
        PdoCause::NoMapping => "describe the mapping parameter, or set bit 31 of the COB-ID",
        PdoCause::TooMany | PdoCause::Overrun | PdoCause::TooLong => "map fewer objects",
        PdoCause::NoSlot => "describe these entries, or correct the number",
        PdoCause::Empty => "set bit 31 of the COB-ID of a PDO that is not in use",
        PdoCause::Reserved => "use one of these",
        PdoCause::NoTrigger => {
            "use a type up to 240 or from 254; 252 and 253 need bit 30 of the COB-ID clear"
        }
        PdoCause::SyncStart => "use a value up to 240",
        PdoCause::Dummy => "map entries of the dictionary",
        PdoCause::Missing => "describe the entries, or correct the mapping",
        PdoCause::Bits => "map entries of whole bytes",
        PdoCause::Direction | PdoCause::NotMappable => {
            "correct the access type or `PDOMapping` of the entries, or the mapping"
        }
        PdoCause::Constant => "correct the access type of the entries or the mapping",
        PdoCause::Short | PdoCause::Size | PdoCause::Length => "correct the length in the mapping",
    }
}

/// The first entry and the number of others.
fn entries(mapped: &BTreeSet<MappedObject>) -> String {
    let first =
        mapped.first().map_or(String::new(), |first| format!("{:04X}h:{:02X}", first.index, first.sub));
    match mapped.len() {
        0 | 1 => first,
        many => format!("{first} and {} more", many - 1),
    }
}

/// Numbers as text: `1, 3 to 50`.
pub(super) fn listed(numbers: &[u16]) -> String {
    let mut ranges: Vec<(u16, u16)> = Vec::new();
    for &number in numbers {
        match ranges.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => ranges.push((number, number)),
        }
    }
    let range = |&(first, last): &(u16, u16)| match last - first {
        0 => first.to_string(),
        1 => format!("{first}, {last}"),
        _ => format!("{first} to {last}"),
    };
    ranges.iter().map(range).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn causes_are_exact_to_the_pdo() {
        assert_eq!(listed(&[1, 2, 4, 5, 6, 9]), "1, 2, 4 to 6, 9");
        let mapped =
            |subs: &[u8]| subs.iter().map(|&sub| MappedObject { index: 0x7001, sub, bits: 8 }).collect();
        let (why, _) = why(PdoCause::Direction, PdoKind::Rpdo, &mapped(&[1]));
        assert_eq!(why, "7001h:01 can be mapped to TPDOs only");
        let (why, _) = super::why(PdoCause::Missing, PdoKind::Tpdo, &mapped(&[2, 1, 3]));
        assert_eq!(why, "7001h:01 and 2 more are missing");
    }
}

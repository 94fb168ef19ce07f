//! Why a PDO is not served, in words.

use std::collections::BTreeSet;

use super::pdos::Cause;
use crate::model::{MappedObject, PdoKind};

/// A cause with the mapped objects that have it, and what to do about it.
pub(super) fn why(cause: Cause, kind: PdoKind, mapped: &BTreeSet<MappedObject>) -> (String, &'static str) {
    let other = match kind {
        PdoKind::Rpdo => PdoKind::Tpdo,
        PdoKind::Tpdo => PdoKind::Rpdo,
    };
    let entries = entries(mapped);
    let be = if mapped.len() > 1 { "are" } else { "is" };
    let text = match cause {
        Cause::Number => "the stack counts PDOs in 8 bits".to_owned(),
        Cause::NoTransmissionType => "sub-index 2 is no transmission type of 8 bits".to_owned(),
        Cause::NoCobId => "sub-index 1 is no COB-ID of 32 bits".to_owned(),
        Cause::RtrAllowed => "bit 30 of the COB-ID is clear (RTR allowed)".to_owned(),
        Cause::Extended => "the CAN-ID has 29 bits".to_owned(),
        Cause::NoCanId | Cause::OnNmt => "the CAN-ID is 0".to_owned(),
        Cause::NotDispatched => "the stack takes only the CAN-IDs 180h to 57Fh for PDOs".to_owned(),
        Cause::Taken => "an RPDO before it has the same CAN-ID, valid or not".to_owned(),
        Cause::NoMapping => "the mapping is missing".to_owned(),
        Cause::TooMany | Cause::Overrun => {
            "the stack maps at most 8 objects and does not support multiplexed PDOs".to_owned()
        }
        Cause::NoSlot => "sub-index 0 of the mapping counts entries that are missing".to_owned(),
        Cause::TooLong => "more than 8 bytes are mapped".to_owned(),
        Cause::Empty => "nothing is mapped".to_owned(),
        Cause::Reserved => "the transmission type is none of 0 to 240, 254 and 255".to_owned(),
        Cause::NoTrigger => "neither events nor SYNCs nor RTRs trigger its transmission type".to_owned(),
        Cause::SyncStart => "the SYNC start value is above 240".to_owned(),
        Cause::Dummy => format!("{entries} cannot be mapped as dummy entries"),
        Cause::Missing => format!("{entries} {be} missing"),
        Cause::Bits => format!("{entries} {be} mapped with a length that is not a multiple of 8 bits"),
        Cause::Direction => format!("{entries} can be mapped to {other}s only"),
        Cause::NotMappable => format!("{entries} cannot be mapped to PDOs"),
        Cause::Constant => format!("{entries} {be} in flash"),
        Cause::Short => format!("{entries} {be} shorter than their part of the PDO"),
        Cause::Size | Cause::Length => format!("{entries} {be} not as long as their part of the PDO"),
    };
    (text, help(cause))
}

const fn help(cause: Cause) -> &'static str {
    match cause {
        Cause::Number => "use the first 255 PDOs",
        Cause::NoTransmissionType | Cause::NoCobId => "describe the entry with this data type",
        Cause::RtrAllowed => "set bit 30, as in `$NODEID+0x40000180`",
        Cause::Extended => "use a CAN-ID of 11 bits",
        Cause::NoCanId | Cause::OnNmt => "write a CAN-ID, or set bit 31 if the PDO is not in use",
        Cause::NotDispatched => "use one of these",
        Cause::Taken => "use a CAN-ID of its own",
        Cause::NoMapping => "describe the mapping parameter, or set bit 31 of the COB-ID",
        Cause::TooMany | Cause::Overrun | Cause::TooLong => "map fewer objects",
        Cause::NoSlot => "describe these entries, or correct the number",
        Cause::Empty => "set bit 31 of the COB-ID of a PDO that is not in use",
        Cause::Reserved => "use one of these",
        Cause::NoTrigger => "use a type up to 240 or from 254; 252 and 253 need bit 30 of the COB-ID clear",
        Cause::SyncStart => "use a value up to 240",
        Cause::Dummy => "map entries of the dictionary",
        Cause::Missing => "describe the entries, or correct the mapping",
        Cause::Bits => "map entries of whole bytes",
        Cause::Direction | Cause::NotMappable => {
            "correct the access type or `PDOMapping` of the entries, or the mapping"
        }
        Cause::Constant => "correct the access type of the entries, or the mapping",
        Cause::Short | Cause::Size | Cause::Length => "correct the length in the mapping",
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
        let (why, _) = why(Cause::Direction, PdoKind::Rpdo, &mapped(&[1]));
        assert_eq!(why, "7001h:01 can be mapped to TPDOs only");
        let (why, _) = super::why(Cause::Missing, PdoKind::Tpdo, &mapped(&[2, 1, 3]));
        assert_eq!(why, "7001h:01 and 2 more are missing");
    }
}

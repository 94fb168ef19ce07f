//! Objects that a setting names and the device does not have.

use super::{Configurator, PdoName, Wrong};
use crate::diagnostic::misspelled;
use crate::model::PdoKind;
use crate::profile;

impl Configurator<'_> {
    /// The problem of an object that the device does not have.
    pub(super) fn no_object(&self, index: u16) -> Wrong {
        let pdo = PdoKind::of_communication(index).or_else(|| PdoKind::of_mapping(index));
        if let Some((kind, number)) = pdo {
            return self.no_pdo(PdoName { kind, number });
        }
        let wanted = format!("{index:04X}");
        let known =
            profile::of_object(self.device, index).map(|(_, facts)| facts.name).find(|name| !name.is_empty());
        let Some(name) = known else {
            let wrong = Wrong::new(format!("the device has no object `{wanted}`"));
            let mut indexes: Vec<String> =
                self.device.objects.keys().map(|index| format!("{index:04X}")).collect();
            // the part of the dictionary is rarely wrong
            indexes.sort_by_key(|known| known.as_bytes().first() != wanted.as_bytes().first());
            let meant = same_digits(&wanted, &indexes);
            return match meant.or_else(|| misspelled(&wanted, indexes.iter().map(String::as_str))) {
                Some(meant) => wrong.help(format!("did you mean `{meant}`?")),
                None => wrong.help("`objdict show` lists the objects"),
            };
        };
        // a known index is meant as it is written
        let wrong = Wrong::new(format!("the device has no object `{wanted}` ({name})"));
        match self.consequence(index) {
            Some(help) => wrong.help(help),
            None => wrong,
        }
    }

    /// What a device without a communication object does not do, and what it has in its place.
    fn consequence(&self, index: u16) -> Option<&'static str> {
        let has = |index| self.device.object(index).is_some();
        Some(match index {
            0x1005 => "the device does not use SYNC",
            0x1006 | 0x1007 if has(0x1005) => "the device consumes SYNC (1005h), but does not produce it",
            0x1006 | 0x1007 | 0x1019 if !has(0x1005) => "the device does not use SYNC",
            0x1019 => "the device uses SYNC (1005h) without a counter",
            0x100C | 0x100D if has(0x1017) => "the device has no guarding; its heartbeat is 1017h",
            0x1017 if has(0x100C) => "the device has no heartbeat producer; guarding is 100Ch and 100Dh",
            0x100C | 0x100D | 0x1017 => {
                "the device has neither guarding (100Ch, 100Dh) nor a heartbeat producer (1017h)"
            }
            0x1010 => "the device does not store parameters by command",
            0x1011 => "the device does not restore its defaults by command",
            0x1012 => "the device does not use TIME",
            0x1014 | 0x1015 => "the CAN-ID of EMCY and its inhibit time cannot be configured",
            0x1016 => "the device does not monitor heartbeats",
            0x1020 => "the device does not keep the date of its configuration",
            0x1028 => "the device does not consume EMCY",
            0x1029 => "the reaction of the device to errors cannot be configured",
            _ => return None,
        })
    }
}

/// Finds an index with two digits swapped, the most common typing error.
fn same_digits<'a>(wanted: &str, indexes: &'a [String]) -> Option<&'a str> {
    let sorted = |text: &str| {
        let mut digits = text.as_bytes().to_vec();
        digits.sort_unstable();
        digits
    };
    let differing = |index: &str| index.bytes().zip(wanted.bytes()).filter(|(a, b)| a != b).count();
    let mut indexes = indexes.iter().map(String::as_str);
    indexes.find(|index| differing(index) == 2 && sorted(index) == sorted(wanted))
}

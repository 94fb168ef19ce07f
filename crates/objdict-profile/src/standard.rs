//! The documents that come with the program.

use std::ops::RangeInclusive;
use std::sync::{Arc, LazyLock};

use super::Profile;
use crate::model::Device;

macro_rules! documents {
    ($($group:ident $number:literal,)*) => {
        /// The documents, each read when it is asked for first.
        static DOCUMENTS: &[(u16, &str, &LazyLock<Arc<Profile>>)] = &[$({
            static PROFILE: LazyLock<Arc<Profile>> = LazyLock::new(|| {
                let text = include_str!(concat!("../data/", stringify!($group), ".toml"));
                read(text, stringify!($group))
            });
            ($number, stringify!($group), &PROFILE)
        },)*];
    };
}

/// Documents below this number are for devices of any profile (CiA 301 and its additions).
const FIRST_DEVICE_PROFILE: u16 = 400;

documents! {
    cia301 301,
    cia302 302,
    cia401 401,
    cia402 402,
    cia404 404,
    cia406 406,
}

/// A document that comes with the program. A test reads them all, so none is empty.
fn read(text: &str, group: &'static str) -> Arc<Profile> {
    let nothing = Profile {
        group,
        document: String::new(),
        title: String::new(),
        version: None,
        number: None,
        repeats: false,
        objects: Vec::new(),
    };
    Arc::new(Profile::read(text, group).unwrap_or(nothing))
}

/// All documents that come with the program, in the order of their numbers.
pub fn standard() -> impl Iterator<Item = &'static Arc<Profile>> {
    DOCUMENTS.iter().map(|(_, _, profile)| &***profile)
}

/// The document of a number, as `401`, `CiA 401` or `cia401` name it.
pub fn named(name: &str) -> Option<&'static Arc<Profile>> {
    let digits = name.trim_start_matches(|c: char| c.is_ascii_alphabetic() || c == ' ' || c == '-');
    let number: u16 = digits.parse().ok()?;
    DOCUMENTS.iter().find(|(of, ..)| *of == number).map(|(_, _, profile)| &***profile)
}

/// The document of a device profile number.
pub fn of_number(number: u16) -> Option<&'static Profile> {
    DOCUMENTS
        .iter()
        .find(|(of, ..)| *of == number)
        .map(|(_, _, profile)| &****profile)
        .filter(|profile| profile.number == Some(number))
}

/// The documents that hold for a device whatever its profile is. That of network managers is not even read for a device
/// that has nothing of one: reading takes longer than the check of a small file.
pub fn for_all(device: &Device) -> impl Iterator<Item = &'static Profile> {
    let is_manager = device.objects.range(OF_MANAGERS).next().is_some();
    let for_all = DOCUMENTS.iter().filter(|(number, ..)| *number < FIRST_DEVICE_PROFILE);
    let for_it = for_all.filter(move |(number, ..)| is_manager || *number != 302);
    for_it.map(|(_, _, profile)| &****profile)
}

/// All that CiA 302 describes lies here, and nothing of it is demanded of a device that has nothing else of it.
const OF_MANAGERS: RangeInclusive<u16> = 0x1F00..=0x1FFF;

/// What an object was for that CiA 301 had before version 4 and has given up since.
pub fn obsolete(index: u16) -> Option<&'static str> {
    Some(match index {
        0x1004 => "number of PDOs supported",
        0x100B => "node-ID",
        0x100E => "COB-ID of the guarding protocol",
        0x100F => "number of SDOs supported",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Need;
    use crate::model::Access;

    #[test]
    fn every_document_is_read() {
        for (number, group, _) in DOCUMENTS {
            let text = std::fs::read_to_string(format!("src/profile/data/{group}.toml")).unwrap();
            let profile = Profile::read(&text, group).unwrap_or_else(|error| {
                let line = error.span.map(|span| text[..span.start as usize].lines().count());
                panic!("{group}.toml:{}: {}", line.unwrap_or_default(), error.message)
            });
            assert!(!profile.objects.is_empty(), "{group}");
            assert_eq!(profile.document, format!("CiA {number}"));
            assert_eq!(named(&number.to_string()).map(|profile| profile.group), Some(*group));
        }
    }

    #[test]
    fn a_device_without_management_needs_no_document_about_it() {
        let profile = named("302").unwrap();
        assert!(profile.objects.iter().all(|facts| OF_MANAGERS.contains(&facts.first)));
        let bare = Device::default();
        assert!(profile.objects.iter().all(|facts| !facts.is_demanded(&bare, 0)));
    }

    #[test]
    fn objects_are_found_by_index() {
        let profile = named("301").unwrap();
        for facts in &profile.objects {
            for index in [facts.first, facts.last] {
                assert_eq!(profile.object(index).map(|found| found.first), Some(facts.first));
            }
            assert_eq!(facts.entry(0).map(|entry| entry.first), Some(0), "{:04X}", facts.first);
            assert_eq!(facts.entry(0xFF), None);
        }
        for index in [0, 0xFFF, 0x1004, 0x101F, 0x1300, 0x1C00, 0x2000, 0xFFFF] {
            assert!(profile.object(index).is_none(), "{index:04X}");
        }
    }

    #[test]
    fn access_types_that_stand_for_each_other() {
        let profile = named("301").unwrap();
        let access = |index, sub: u8, access| {
            let facts = profile.object(index).and_then(|facts| facts.entry(sub));
            facts.map(|facts| facts.accepts_access(access))
        };
        assert_eq!(access(0x1018, 1, Access::Const), Some(true));
        assert_eq!(access(0x1018, 1, Access::Rw), Some(false));
        assert_eq!(access(0x1600, 1, Access::Rww), Some(true));
        assert_eq!(access(0x1600, 1, Access::Wo), Some(false));
        assert_eq!(access(0x1800, 4, Access::Wo), Some(true));
    }

    #[test]
    fn every_device_has_three_objects() {
        let profile = named("301").unwrap();
        let needed = profile.objects.iter().filter(|facts| facts.need == Need::Mandatory);
        assert_eq!(needed.map(|facts| facts.first).collect::<Vec<_>>(), [0x1000, 0x1001, 0x1018]);
    }
}

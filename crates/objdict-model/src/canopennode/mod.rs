//! What CANopenNode 4 demands of an object dictionary, told before its compiler or its start does.
//!
//! The stack takes its services from an object dictionary that is compiled in: it counts the objects of each service, takes
//! those of a range by going on from the first, and reads entries in the width that it expects. One function finds what is
//! wrong; the rules of the group `portability` and the generator of the target `canopennode` both ask it.

mod labels;

use crate::model::{DataType, Device, Object, Place};

pub use labels::Counters;

/// A demand that a description does not meet.
#[derive(Debug)]
pub struct Unmet {
    /// What kind of demand it is.
    pub cause: Cause,
    /// Where.
    pub place: Place,
    /// What is wrong, in the words of a finding.
    pub message: String,
    /// What to do.
    pub help: String,
}

/// What kind of demand it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// There is no object that the stack cannot be compiled without.
    Missing,
    /// There is no error history.
    NoHistory,
    /// There are too many objects or elements for a service.
    Count,
    /// The objects of a service do not follow each other.
    Gap,
    /// An entry is missing or has another size than the stack reads.
    Entry,
    /// A PDO carries bits.
    Bits,
}

impl Cause {
    /// What comes of it, behind "CANopenNode: ".
    pub const fn effect(self) -> &'static str {
        match self {
            Self::Missing | Self::Count => "the stack does not compile with it",
            Self::NoHistory => "it does not start, unless it is configured without the history of errors",
            Self::Gap => "it does not compile, or takes other objects instead",
            Self::Entry => "it does not start, or the service does not work",
            Self::Bits => "the PDO is not valid, unless the stack is configured for the mapping of bits",
        }
    }
}

/// Services that the stack has exactly once.
const ONCE: [(&str, u16); 4] = [("NMT", 0x1000), ("EM", 0x1001), ("EM_PROD", 0x1014), ("HB_PROD", 0x1017)];

/// The most objects of a service. Of PDOs there may be 512, but the stack counts them in a byte.
const MOST: [(&str, usize); 9] = [
    ("SYNC", 1),
    ("TIME", 1),
    ("HB_CONS", 1),
    ("GFC", 1),
    ("SRDO", 64),
    ("SDO_SRV", 128),
    ("SDO_CLI", 128),
    ("RPDO", 255),
    ("TPDO", 255),
];

/// Where the objects of a service begin, one after the other.
const RANGES: [(&str, u16); 8] = [
    ("SDO_SRV", 0x1200),
    ("SDO_CLI", 0x1280),
    ("SRDO", 0x1301),
    ("SRDO", 0x1381),
    ("RPDO", 0x1400),
    ("RPDO", 0x1600),
    ("TPDO", 0x1800),
    ("TPDO", 0x1A00),
];

/// The most elements of 1016h.
const MOST_CONSUMERS: usize = 127;

/// Entries that the stack reads: first and last index, sub-index, bytes, and whether the entry may be missing.
const ENTRIES: &[(u16, u16, u8, u8, bool)] = &[
    (0x1001, 0x1001, 0, 1, false),
    (0x1005, 0x1005, 0, 4, false),
    (0x1006, 0x1006, 0, 4, false),
    (0x1007, 0x1007, 0, 4, false),
    (0x1012, 0x1012, 0, 4, false),
    (0x1014, 0x1014, 0, 4, false),
    (0x1017, 0x1017, 0, 2, false),
    (0x1019, 0x1019, 0, 1, false),
    (0x1200, 0x1200, 1, 4, true),
    (0x1200, 0x1200, 2, 4, true),
    (0x1201, 0x12FF, 0, 1, false),
    (0x1201, 0x12FF, 1, 4, false),
    (0x1201, 0x12FF, 2, 4, false),
    (0x1280, 0x12FF, 3, 1, false),
    (0x1400, 0x15FF, 1, 4, false),
    (0x1400, 0x15FF, 2, 1, false),
    (0x1400, 0x15FF, 5, 2, true),
    (0x1600, 0x17FF, 0, 1, false),
    (0x1800, 0x19FF, 1, 4, false),
    (0x1800, 0x19FF, 2, 1, false),
    (0x1800, 0x19FF, 3, 2, true),
    (0x1800, 0x19FF, 5, 2, true),
    (0x1800, 0x19FF, 6, 1, true),
    (0x1A00, 0x1BFF, 0, 1, false),
];

/// Objects of a description that are compiled in.
pub(crate) fn objects(device: &Device) -> impl Iterator<Item = (u16, &Object)> {
    device.objects.iter().map(|(&index, object)| (index, object)).filter(|(_, object)| !is_disabled(object))
}

fn is_disabled(object: &Object) -> bool {
    object.main.stack.as_ref().is_some_and(|stack| stack.disabled == Some(true))
}

/// Everything that a device lacks; nothing of one that has no objects at all.
pub fn unmet(device: &Device) -> Vec<Unmet> {
    let dictionary = Wanted { device, counters: Counters::new(objects(device)), unmet: Vec::new() };
    if device.objects.is_empty() { Vec::new() } else { dictionary.all() }
}

struct Wanted<'a> {
    device: &'a Device,
    counters: Counters,
    unmet: Vec<Unmet>,
}

impl Wanted<'_> {
    fn all(mut self) -> Vec<Unmet> {
        self.services();
        self.ranges();
        self.entries();
        self.bits();
        self.unmet
    }

    fn object(&self, index: u16) -> Option<&Object> {
        self.device.object(index).filter(|object| !is_disabled(object))
    }

    fn push(&mut self, cause: Cause, place: Place, message: String, help: impl Into<String>) {
        self.unmet.push(Unmet { cause, place, message, help: help.into() });
    }

    fn services(&mut self) {
        for (label, index) in ONCE {
            match self.counters.of(label) {
                [] if self.object(index).is_some() => {
                    let message =
                        format!("no object has the count label `{label}`, which belongs to {index:04X}h");
                    self.push(
                        Cause::Missing,
                        Place::object(index),
                        message,
                        "remove the label that the object has",
                    );
                }
                [] => self.missing(index, format!("{index:04X}h is missing")),
                [_] => {}
                [_, second, ..] => {
                    let message = format!("a second object has the count label `{label}`");
                    self.push(Cause::Count, Place::object(*second), message, "leave it to one object");
                }
            }
        }
        for (label, most) in MOST {
            if let Some(&index) = self.counters.of(label).get(most) {
                let message = format!("there are more than {most} objects with the count label `{label}`");
                self.push(Cause::Count, Place::object(index), message, "describe fewer of them");
            }
        }
        if self.counters.count("SYNC") > 0 && self.object(0x1006).is_none() {
            let help = "describe 1006h; a period of 0 switches the production of SYNC off";
            self.push(
                Cause::Missing,
                Place::object(0x1005),
                "1006h is missing beside 1005h".to_owned(),
                help,
            );
        }
        if self.object(0x1003).is_none() {
            let message = "1003h is missing".to_owned();
            self.push(Cause::NoHistory, Place::device(), message, "describe the object");
        }
        let consumers =
            self.object(0x1016).map(|object| object.entries().filter(|(sub, _)| *sub > 0).count());
        if let Some(consumers) = consumers.filter(|consumers| !(1..=MOST_CONSUMERS).contains(consumers)) {
            let message =
                format!("1016h has {consumers} elements, of 1 to {MOST_CONSUMERS} that it may have");
            self.push(
                Cause::Count,
                Place::object(0x1016),
                message,
                "describe as many as there are consumers",
            );
        }
    }

    fn missing(&mut self, index: u16, message: String) {
        let help = format!("describe {index:04X}h, for the stack is built around it");
        self.push(Cause::Missing, Place::device(), message, help);
    }

    /// Objects that the stack takes one after the other, as many as there are of the service.
    fn ranges(&mut self) {
        let mut told = "";
        for (label, first) in RANGES {
            if told == label {
                continue; // mappings that are missing beside what they belong to
            }
            let of_label = self.counters.of(label).len();
            let Some(missing) = (first..).take(of_label).find(|&index| self.object(index).is_none()) else {
                continue;
            };
            told = label;
            let last = self.counters.of(label).last().copied().unwrap_or(first);
            let message = match missing.checked_sub(first) {
                _ if !(0x1200..0x1400).contains(&first) && first & 0x200 != 0 => {
                    format!("{missing:04X}h is missing, the mapping of {:04X}h", missing - 0x200)
                }
                _ if (0x1381..0x1400).contains(&first) => {
                    format!("{missing:04X}h is missing, the mapping of an SRDO")
                }
                _ => format!("{missing:04X}h is missing, although there is {last:04X}h"),
            };
            let help = "number the objects of a service without a gap, each with its mapping";
            self.push(Cause::Gap, Place::object(last), message, help);
        }
    }

    fn entries(&mut self) {
        let mut wrong = Vec::new();
        for (index, object) in objects(self.device) {
            for &(first, last, sub, bytes, optional) in ENTRIES {
                if (first..=last).contains(&index) {
                    wrong.extend(entry(index, object, sub, bytes, optional));
                }
            }
            let numbers = match index {
                0x1016 => u8::MAX,
                0x1600..=0x17FF | 0x1A00..=0x1BFF => 8,
                _ => continue,
            };
            wrong.extend((1..=numbers).find_map(|sub| entry(index, object, sub, 4, true)));
        }
        self.unmet.append(&mut wrong);
    }

    fn bits(&mut self) {
        for pdo in self.device.pdos() {
            let Some(slot) =
                pdo.used_slots().find(|slot| slot.object.is_some_and(|object| object.bits % 8 != 0))
            else {
                continue;
            };
            let message = format!("{pdo} carries single bits");
            let place = Place::entry(pdo.mapping_index(), slot.sub);
            self.push(Cause::Bits, place, message, "map entries of whole bytes");
        }
    }
}

/// What is wrong with an entry that the stack reads as a number of so many bytes.
fn entry(index: u16, object: &Object, sub: u8, bytes: u8, optional: bool) -> Option<Unmet> {
    let unmet = |place, message, help: String| Some(Unmet { cause: Cause::Entry, place, message, help });
    let Some(entry) = object.entry(sub) else {
        let message = format!("sub-index {sub:02X}h of {index:04X}h is missing");
        let help = format!("describe the entry with {bytes} {}", plural(bytes));
        return if optional { None } else { unmet(Place::object(index), message, help) };
    };
    let length = entry.data_type.and_then(DataType::byte_length)?; // what has no type is told by another rule
    if length == bytes {
        return None;
    }
    let message = format!("the entry has {length} {} and is read as a number of {bytes}", plural(length));
    unmet(Place::entry(index, sub), message, format!("give it a type of {bytes} {}", plural(bytes)))
}

fn plural(bytes: u8) -> &'static str {
    if bytes == 1 { "byte" } else { "bytes" }
}

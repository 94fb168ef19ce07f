//! The requirements of CANopenNode 4 on an object dictionary, checked before compilation and startup.
//!
//! The stack derives its services from an object dictionary that is compiled in: it counts the objects of
//! each service, accesses a service's objects consecutively from the first, and reads entries with a
//! fixed length. One function finds unmet requirements for both the rules of the group `portability` and
//! the generator of the target `canopennode`.

use std::collections::BTreeMap;

use crate::diagnostic::plural;
use crate::model::{Device, Object, Place, TypeKind};

/// A requirement that a description does not meet.
#[derive(Debug)]
pub struct Unmet {
    /// The kind of requirement.
    pub cause: Cause,
    /// The place in the description.
    pub place: Place,
    /// The message of the finding.
    pub message: String,
    /// The help of the finding.
    pub help: String,
    /// The object that would meet the requirement.
    pub missing: Option<u16>,
}

/// The kind of requirement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// A missing object without which the stack does not compile.
    Missing,
    /// The error history is missing.
    NoHistory,
    /// A service has too many objects or elements.
    Count,
    /// The objects of a service are not consecutive.
    Gap,
    /// An entry that the stack reads when it starts is missing or has a different size.
    Start,
    /// A missing or mismatching entry of a service that the stack starts without.
    Entry,
    /// A PDO maps single bits.
    Bits,
}

impl Cause {
    /// The effect, after "CANopenNode: ".
    pub const fn effect(self) -> &'static str {
        match self {
            Self::Missing | Self::Count => "the stack does not compile",
            Self::NoHistory => "the stack does not start unless it is configured without the error history",
            Self::Gap => "the stack does not compile, or uses other objects instead",
            Self::Start => "the stack does not start",
            Self::Entry => "the stack does not start, or the service does not work",
            Self::Bits => "the PDO is not valid unless the stack is configured for mapping of single bits",
        }
    }
}

/// Services that the stack requires exactly once.
const ONCE: [(&str, u16); 4] = [("NMT", 0x1000), ("EM", 0x1001), ("EM_PROD", 0x1014), ("HB_PROD", 0x1017)];

/// The maximum number of objects of a service. CANopen allows 512 PDOs, but the stack counts them in a byte.
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

/// The first of the consecutive objects of a service.
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

/// The maximum number of elements of 1016h.
const MOST_CONSUMERS: usize = 127;

/// The effect of an entry that the stack cannot read. In the default configuration it has no SDO clients, GFC
/// or SRDOs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum EntryNeed {
    /// The stack does not start without it.
    Start,
    /// It may be missing; the stack does not start if its length differs.
    Length,
    /// The service needs it.
    Service,
    /// It may be missing; the service ignores it if its length differs.
    Option,
}

use EntryNeed::{Length, Option as Optional, Service, Start};

/// Entries that the stack reads: first and last index, first and last sub-index, length in bytes. From `CO_EM_init`, `CO_NMT_init`,
/// `CO_HBconsumer_init`, `CO_SYNC_init`, `CO_TIME_init`, `CO_SDOserver_init`, `CO_SDOclient_init`, `PDO_initMapping`, `CO_RPDO_init`,
/// `CO_TPDO_init`, `CO_GFC_init`, `CO_SRDO_config` and `OD_write_1010`.
const ENTRIES: &[(u16, u16, u8, u8, u8, EntryNeed)] = &[
    (0x1001, 0x1001, 0, 0, 1, Start),
    (0x1005, 0x1007, 0, 0, 4, Start),
    (0x1010, 0x1011, 1, 127, 4, Optional),
    (0x1012, 0x1012, 0, 0, 4, Start),
    (0x1014, 0x1014, 0, 0, 4, Start),
    (0x1015, 0x1015, 0, 0, 2, Optional),
    (0x1016, 0x1016, 1, 127, 4, Length),
    (0x1017, 0x1017, 0, 0, 2, Start),
    (0x1019, 0x1019, 0, 0, 1, Start),
    (0x1200, 0x1200, 1, 2, 4, Optional),
    (0x1201, 0x127F, 0, 0, 1, Start),
    (0x1201, 0x127F, 1, 2, 4, Start),
    (0x1280, 0x12FF, 0, 0, 1, Service),
    (0x1280, 0x12FF, 1, 2, 4, Service),
    (0x1280, 0x12FF, 3, 3, 1, Service),
    (0x1300, 0x1300, 0, 0, 1, Service),
    (0x1301, 0x1340, 0, 1, 1, Service),
    (0x1301, 0x1340, 2, 2, 2, Service),
    (0x1301, 0x1340, 3, 4, 1, Service),
    (0x1301, 0x1340, 5, 6, 4, Service),
    (0x1381, 0x13C0, 0, 0, 1, Service),
    (0x1400, 0x15FF, 1, 1, 4, Start),
    (0x1400, 0x15FF, 2, 2, 1, Start),
    (0x1400, 0x15FF, 5, 5, 2, Optional),
    (0x1600, 0x17FF, 0, 0, 1, Start),
    (0x1600, 0x17FF, 1, 8, 4, Length),
    (0x1800, 0x19FF, 1, 1, 4, Start),
    (0x1800, 0x19FF, 2, 2, 1, Start),
    (0x1800, 0x19FF, 3, 3, 2, Optional),
    (0x1800, 0x19FF, 5, 5, 2, Optional),
    (0x1800, 0x19FF, 6, 6, 1, Optional),
    (0x1A00, 0x1BFF, 0, 0, 1, Start),
    (0x1A00, 0x1BFF, 1, 8, 4, Length),
];

/// Whether the stack does not start if it cannot read a value.
pub fn is_read_at_start(index: u16, sub: u8) -> bool {
    let row = ENTRIES.iter().find(|row| (row.0..=row.1).contains(&index) && (row.2..=row.3).contains(&sub));
    row.is_some_and(|row| row.5 == Start || index == 0x1016)
}

/// All unmet requirements of a device; none if the device has no objects at all.
pub fn unmet(device: &Device) -> Vec<Unmet> {
    let dictionary = WantedObject {
        device,
        counters: Counters::new(device.objects.iter().map(|(&index, object)| (index, object))),
        unmet: Vec::new(),
    };
    if device.objects.is_empty() { Vec::new() } else { dictionary.all() }
}

struct WantedObject<'a> {
    device: &'a Device,
    counters: Counters,
    unmet: Vec<Unmet>,
}

impl WantedObject<'_> {
    fn all(mut self) -> Vec<Unmet> {
        self.services();
        self.ranges();
        self.entries();
        self.bits();
        self.unmet
    }

    fn object(&self, index: u16) -> Option<&Object> {
        self.device.object(index)
    }

    fn push(&mut self, cause: Cause, place: Place, message: String, help: impl Into<String>) {
        self.unmet.push(Unmet { cause, place, message, help: help.into(), missing: None });
    }

    /// Reports an object whose description meets a requirement.
    fn lack(&mut self, cause: Cause, place: Place, index: u16, message: String, help: impl Into<String>) {
        self.unmet.push(Unmet { cause, place, message, help: help.into(), missing: Some(index) });
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
                        "remove the count label of the object",
                    );
                }
                [] => self.missing(index, format!("{index:04X}h is missing")),
                [_] => {}
                [_, second, ..] => {
                    let message = format!("more than one object has the count label `{label}`");
                    self.push(
                        Cause::Count,
                        Place::object(*second),
                        message,
                        "remove the count label from all objects but one",
                    );
                }
            }
        }
        for (label, most) in MOST {
            if let Some(&index) = self.counters.of(label).get(most) {
                let message = format!("more than {most} objects have the count label `{label}`");
                self.push(Cause::Count, Place::object(index), message, "describe fewer objects");
            }
        }
        if self.counters.count("SYNC") > 0 && self.object(0x1006).is_none() {
            let help = "describe 1006h; a period of 0 disables the SYNC producer";
            let message = "1005h is described without 1006h".to_owned();
            self.lack(Cause::Missing, Place::object(0x1005), 0x1006, message, help);
        }
        if self.object(0x1003).is_none() {
            let message = "1003h is missing".to_owned();
            self.lack(Cause::NoHistory, Place::device(), 0x1003, message, "describe the object");
        }
        let consumers =
            self.object(0x1016).map(|object| object.entries().filter(|(sub, _)| *sub > 0).count());
        if let Some(consumers) = consumers.filter(|consumers| !(1..=MOST_CONSUMERS).contains(consumers)) {
            let message = format!("1016h has {consumers} elements instead of 1 to {MOST_CONSUMERS}");
            self.push(
                Cause::Count,
                Place::object(0x1016),
                message,
                "describe one element for each monitored node",
            );
        }
    }

    fn missing(&mut self, index: u16, message: String) {
        let help = format!("describe {index:04X}h, which the stack requires");
        self.lack(Cause::Missing, Place::device(), index, message, help);
    }

    /// Ranges of objects that the stack accesses consecutively, by the number of objects of the service.
    fn ranges(&mut self) {
        let mut reported = "";
        for (label, first) in RANGES {
            if reported == label {
                continue; // the communication parameters are also missing
            }
            let of_label = self.counters.of(label).len();
            let Some(missing) = (first..).take(of_label).find(|&index| self.object(index).is_none()) else {
                continue;
            };
            reported = label;
            let last = self.counters.of(label).last().copied().unwrap_or(first);
            let message = match missing.checked_sub(first) {
                _ if !(0x1200..0x1400).contains(&first) && first & 0x200 != 0 => {
                    format!("{missing:04X}h is missing, the mapping of {:04X}h", missing - 0x200)
                }
                _ if (0x1381..0x1400).contains(&first) => {
                    format!("{missing:04X}h is missing, the mapping of an SRDO")
                }
                _ => format!("{missing:04X}h is missing, but {last:04X}h is described"),
            };
            let help = "number the objects of a service consecutively, each with its mapping";
            self.push(Cause::Gap, Place::object(last), message, help);
        }
    }

    fn entries(&mut self) {
        for (&index, object) in &self.device.objects {
            let rows = ENTRIES.iter().filter(|row| (row.0..=row.1).contains(&index));
            for &(_, _, first, last, bytes, need) in rows {
                // the stack reads all existing elements
                let counted = object.entries().map(|(sub, _)| sub).max().filter(|_| index == 0x1016);
                let read = first..=counted.unwrap_or(last);
                let wrong = read.filter_map(|sub| entry(index, object, sub, bytes, need, counted.is_some()));
                // one for all mapped objects
                self.unmet.extend(wrong.take(if last > 2 { 1 } else { 2 }));
            }
        }
    }

    fn bits(&mut self) {
        for pdo in self.device.pdos() {
            let Some(slot) =
                pdo.used_slots().find(|slot| slot.object.is_some_and(|object| object.bits % 8 != 0))
            else {
                continue;
            };
            let message = format!("{pdo} maps single bits");
            let place = Place::entry(pdo.mapping_index(), slot.sub);
            self.push(Cause::Bits, place, message, "map entries of whole bytes");
        }
    }
}

/// The unmet requirement of an entry that the stack reads as a number of `bytes` bytes.
fn entry(
    index: u16,
    object: &Object,
    sub: u8,
    bytes: u8,
    need: EntryNeed,
    is_counted: bool,
) -> Option<Unmet> {
    let cause = if matches!(need, Start | Length) { Cause::Start } else { Cause::Entry };
    let unmet = |place, message, help: String| Some(Unmet { cause, place, message, help, missing: None });
    let Some(entry) = object.entry(sub) else {
        let message = format!("sub-index {sub:02X}h of {index:04X}h is missing");
        let help = format!("describe the entry with {}", plural(bytes.into(), "byte"));
        let is_needed = matches!(need, Start | Service) || is_counted;
        return if is_needed { unmet(Place::object(index), message, help) } else { None };
    };
    let data_type = entry.data_type?; // another rule reports a missing data type
    let found = match (data_type.byte_length(), data_type.kind()) {
        (Some(length), _) if length == bytes => return None,
        (Some(length), _) => format!("the entry has {}", plural(length.into(), "byte")),
        (None, TypeKind::Structure | TypeKind::Defined | TypeKind::Reserved) => return None,
        (None, _) => format!("the entry is a {data_type}"),
    };
    let stack_reads = if data_type.byte_length().is_some() { "" } else { " bytes" };
    let message = format!("{found}, but the stack reads {bytes}{stack_reads}");
    let help = match index {
        0x1201..=0x127F => format!(
            "use a data type of {}, or move an object that is not an SDO server to 2000h to 5FFFh",
            plural(bytes.into(), "byte")
        ),
        _ => format!("use a data type of {}", plural(bytes.into(), "byte")),
    };
    unmet(Place::entry(index, sub), message, help)
}

/// The indexes of each label.
const LABELS: &[(&str, u16, u16)] = &[
    ("NMT", 0x1000, 0x1000),
    ("EM", 0x1001, 0x1001),
    ("SYNC", 0x1005, 0x1005),
    ("SYNC_PROD", 0x1006, 0x1006),
    ("STORAGE", 0x1010, 0x1010),
    ("TIME", 0x1012, 0x1012),
    ("EM_PROD", 0x1014, 0x1014),
    ("HB_CONS", 0x1016, 0x1016),
    ("HB_PROD", 0x1017, 0x1017),
    ("SDO_SRV", 0x1200, 0x127F),
    ("SDO_CLI", 0x1280, 0x12FF),
    ("GFC", 0x1300, 0x1300),
    ("SRDO", 0x1301, 0x1340),
    ("RPDO", 0x1400, 0x15FF),
    ("TPDO", 0x1800, 0x19FF),
];

/// The objects of each label. The labels are in the order of their first objects.
#[derive(Debug, Default)]
pub struct Counters {
    labels: Vec<String>,
    objects: BTreeMap<String, Vec<u16>>,
}

impl Counters {
    /// Counts objects.
    pub fn new<'a>(objects: impl Iterator<Item = (u16, &'a Object)>) -> Self {
        let mut counters = Self::default();
        for (index, object) in objects {
            let Some(label) = label(index, object) else { continue };
            if !counters.objects.contains_key(&label) {
                counters.labels.push(label.clone());
            }
            counters.objects.entry(label).or_default().push(index);
        }
        counters
    }

    /// The objects of a label, by index.
    pub(crate) fn of(&self, label: &str) -> &[u16] {
        self.objects.get(label).map_or(&[], Vec::as_slice)
    }

    /// The number of objects of a label.
    pub fn count(&self, label: &str) -> usize {
        self.of(label).len()
    }

    /// Labels with their counts.
    pub fn iter(&self) -> impl Iterator<Item = (&str, usize)> {
        self.labels.iter().map(|label| (label.as_str(), self.count(label)))
    }
}

/// The label of an object: from the description, even if empty, otherwise derived from the index.
fn label(index: u16, object: &Object) -> Option<String> {
    let stated = object.main.stack.as_ref().and_then(|stack| stack.count_label.as_deref());
    if let Some(stated) = stated {
        let word = stated.trim().replace(|c: char| !c.is_ascii_alphanumeric() && c != '_', "_");
        let is_array = word.starts_with("ARR_"); // an ARRAY counts its elements
        return (!word.is_empty()).then(|| if is_array { format!("{word}_") } else { word });
    }
    let of_index = LABELS.iter().find(|(_, first, last)| (*first..=*last).contains(&index));
    of_index.map(|(label, ..)| (*label).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Entry;

    #[test]
    fn what_the_description_states_comes_first() {
        let stated = |label: &str| {
            let mut main = Entry::default();
            main.stack_mut().count_label = Some(label.into());
            Object { main, ..Object::default() }
        };
        assert_eq!(label(0x1000, &Object::default()).as_deref(), Some("NMT"));
        assert_eq!(label(0x19FF, &Object::default()).as_deref(), Some("TPDO"));
        assert_eq!(label(0x2000, &Object::default()), None);
        assert_eq!(label(0x2000, &stated("my label")).as_deref(), Some("my_label"));
        assert_eq!(label(0x1000, &stated("")), None);
        assert_eq!(label(0x2000, &stated("ARR_1003")).as_deref(), Some("ARR_1003_"));
    }
}

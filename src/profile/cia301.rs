//! The communication objects of CiA 301 version 4.2 with its three corrigenda (§7.5.2). Where an older edition or a
//! corrigendum says something else, both are accepted. The COB-IDs of SDOs are mappable because the document says so.

use super::{EntryFacts, ObjectFacts};
use crate::model::{Access, DataType, ObjectType};

/// What CiA 301 says of a communication object; `None` for an index that it does not define.
pub fn object(index: u16) -> Option<&'static ObjectFacts> {
    let at = OBJECTS.partition_point(|facts| facts.last < index);
    OBJECTS.get(at).filter(|facts| facts.first <= index)
}

/// The objects that every device has.
pub fn mandatory() -> impl Iterator<Item = &'static ObjectFacts> {
    OBJECTS.iter().filter(|facts| facts.mandatory)
}

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

const U8: &[DataType] = &[DataType::UNSIGNED8];
const U16: &[DataType] = &[DataType::UNSIGNED16];
const U32: &[DataType] = &[DataType::UNSIGNED32];
const U64: &[DataType] = &[DataType::UNSIGNED64];
const TEXT: &[DataType] = &[DataType::VISIBLE_STRING];
const OCTETS: &[DataType] = &[DataType::OCTET_STRING];

const RO: &[Access] = &[Access::Ro];
const RW: &[Access] = &[Access::Rw];
const WO: &[Access] = &[Access::Wo];
/// Writable, or fixed by the device or its profile.
const RW_CONST: &[Access] = &[Access::Rw, Access::Const];
const RW_WO: &[Access] = &[Access::Rw, Access::Wo];

const VAR: &[ObjectType] = &[ObjectType::Var];
const DOMAIN: &[ObjectType] = &[ObjectType::Domain];
/// Elements of one type: a tool that takes them for a record reads the same.
const ARRAY: &[ObjectType] = &[ObjectType::Array, ObjectType::Record];
const RECORD: &[ObjectType] = &[ObjectType::Record];
/// A record whose members but sub-index 0 are of one type, or nearly so.
const ALIKE: &[ObjectType] = &[ObjectType::Record, ObjectType::Array];

const fn entries(first: u8, last: u8, name: &'static str, data_types: &'static [DataType]) -> EntryFacts {
    let access = RO;
    EntryFacts { first, last, name, data_types, access, mandatory: false, mappable: false, range: None }
}

const fn entry(sub: u8, name: &'static str, data_types: &'static [DataType]) -> EntryFacts {
    entries(sub, sub, name, data_types)
}

/// Sub-index 0 with the highest sub-indexes that it may state.
const fn highest(low: u8, high: u8) -> EntryFacts {
    let facts = entry(0, "Highest sub-index supported", U8).needed();
    EntryFacts { range: Some((low as u64, high as u64)), ..facts }
}

/// The value of a VAR.
const fn value(data_types: &'static [DataType]) -> EntryFacts {
    entry(0, "", data_types).needed()
}

impl EntryFacts {
    const fn access(self, access: &'static [Access]) -> Self {
        Self { access, ..self }
    }

    const fn needed(self) -> Self {
        Self { mandatory: true, ..self }
    }

    const fn mappable(self) -> Self {
        Self { mappable: true, ..self }
    }
}

macro_rules! objects {
    ($($first:literal $(..= $last:literal)? $name:literal $types:ident $([$mandatory:ident])? { $($entry:expr),* })*) => {
        /// In ascending order of the indexes.
        static OBJECTS: &[ObjectFacts] = &[$(ObjectFacts {
            first: $first,
            last: objects!(@last $first $($last)?),
            name: $name,
            object_types: $types,
            mandatory: objects!(@flag $($mandatory)?),
            entries: &[$($entry),*],
        }),*];
    };
    (@last $first:literal) => { $first };
    (@last $first:literal $last:literal) => { $last };
    (@flag) => { false };
    (@flag mandatory) => { true };
}

objects! {
    0x1000 "Device type" VAR [mandatory] { value(U32) }
    0x1001 "Error register" VAR [mandatory] { value(U8).mappable() }
    0x1002 "Manufacturer status register" VAR { value(U32).mappable() }
    0x1003 "Pre-defined error field" ARRAY {
        highest(0, 0xFE).access(RW_CONST),
        entries(1, 0xFE, "Standard error field", U32)
    }
    0x1005 "COB-ID SYNC message" VAR { value(U32).access(RW_CONST) }
    0x1006 "Communication cycle period" VAR { value(U32).access(RW) }
    0x1007 "Synchronous window length" VAR { value(U32).access(RW) }
    0x1008 "Manufacturer device name" VAR { value(TEXT) }
    0x1009 "Manufacturer hardware version" VAR { value(TEXT) }
    0x100A "Manufacturer software version" VAR { value(TEXT) }
    0x100C "Guard time" VAR { value(U16).access(RW_CONST) }
    0x100D "Life time factor" VAR { value(U8).access(RW_CONST) }
    0x1010 "Store parameters" ARRAY {
        highest(1, 0x7F),
        entry(1, "Save all parameters", U32).access(RW_CONST).needed(),
        entry(2, "Save communication parameters", U32).access(RW_CONST),
        entry(3, "Save application parameters", U32).access(RW_CONST),
        entries(4, 0x7F, "Save manufacturer-defined parameters", U32).access(RW_CONST)
    }
    0x1011 "Restore default parameters" ARRAY {
        highest(1, 0x7F),
        entry(1, "Restore all default parameters", U32).access(RW).needed(),
        entry(2, "Restore communication default parameters", U32).access(RW),
        entry(3, "Restore application default parameters", U32).access(RW),
        entries(4, 0x7F, "Restore manufacturer-defined default parameters", U32).access(RW)
    }
    0x1012 "COB-ID time stamp object" VAR { value(U32).access(RW_CONST) }
    0x1013 "High resolution time stamp" VAR { value(U32).access(&[Access::Rw, Access::Ro, Access::Wo]).mappable() }
    0x1014 "COB-ID EMCY" VAR { value(U32).access(RW_CONST) }
    0x1015 "Inhibit time EMCY" VAR { value(U16).access(RW) }
    0x1016 "Consumer heartbeat time" ARRAY {
        highest(1, 0x7F),
        entry(1, "Consumer heartbeat time", U32).access(RW).needed(),
        entries(2, 0x7F, "Consumer heartbeat time", U32).access(RW)
    }
    0x1017 "Producer heartbeat time" VAR { value(U16).access(RW_CONST) }
    0x1018 "Identity object" ALIKE [mandatory] {
        highest(1, 4),
        entry(1, "Vendor-ID", U32).needed(),
        entry(2, "Product code", U32),
        entry(3, "Revision number", U32),
        entry(4, "Serial number", U32)
    }
    0x1019 "Synchronous counter overflow value" VAR { value(U8).access(RW_CONST) }
    0x1020 "Verify configuration" ARRAY {
        highest(2, 2),
        entry(1, "Configuration date", U32).access(RW).needed(),
        entry(2, "Configuration time", U32).access(RW).needed()
    }
    0x1021 "Store EDS" DOMAIN { value(&[DataType::DOMAIN]) }
    0x1022 "Store format" VAR { value(&[DataType::UNSIGNED8, DataType::UNSIGNED16]) }
    0x1023 "OS command" RECORD {
        highest(3, 3),
        entry(1, "Command", OCTETS).access(RW_WO).needed(),
        entry(2, "Status", U8).needed(),
        entry(3, "Reply", OCTETS).needed()
    }
    0x1024 "OS command mode" VAR { value(U8).access(WO) }
    0x1025 "OS debugger interface" RECORD {
        highest(3, 3),
        entry(1, "Command", OCTETS).access(RW_WO).needed(),
        entry(2, "Status", U8).needed(),
        entry(3, "Reply", OCTETS).needed()
    }
    0x1026 "OS prompt" ARRAY {
        highest(2, 3),
        entry(1, "StdIn", U8).access(WO).needed().mappable(),
        entry(2, "StdOut", U8).needed().mappable(),
        entry(3, "StdErr", U8).mappable()
    }
    0x1027 "Module list" ARRAY {
        highest(0, 0xFE),
        entries(1, 0xFE, "Module", U16)
    }
    0x1028 "Emergency consumer object" ARRAY {
        highest(1, 0x7F),
        entries(1, 0x7F, "Emergency consumer", U32).access(RW_CONST)
    }
    0x1029 "Error behavior object" ARRAY {
        highest(1, 0xFE),
        entry(1, "Communication error", U8).access(RW_CONST).needed(),
        entries(2, 0xFE, "Profile- or manufacturer-specific error", U8).access(RW_CONST)
    }
    0x1200 "SDO server parameter" ALIKE {
        highest(2, 3),
        entry(1, "COB-ID client to server", U32).needed().mappable(),
        entry(2, "COB-ID server to client", U32).needed().mappable(),
        entry(3, "Node-ID of the SDO client", U8).access(RW_CONST)
    }
    0x1201..=0x127F "SDO server parameter" ALIKE {
        highest(2, 3),
        entry(1, "COB-ID client to server", U32).access(RW_CONST).needed().mappable(),
        entry(2, "COB-ID server to client", U32).access(RW_CONST).needed().mappable(),
        entry(3, "Node-ID of the SDO client", U8).access(RW_CONST)
    }
    0x1280..=0x12FF "SDO client parameter" ALIKE {
        highest(3, 3),
        entry(1, "COB-ID client to server", U32).access(RW_CONST).needed().mappable(),
        entry(2, "COB-ID server to client", U32).access(RW_CONST).needed().mappable(),
        entry(3, "Node-ID of the SDO server", U8).access(RW_CONST).needed()
    }
    0x1400..=0x15FF "RPDO communication parameter" RECORD {
        highest(2, 6),
        entry(1, "COB-ID used by RPDO", U32).access(RW_CONST).needed(),
        entry(2, "Transmission type", U8).access(RW_CONST).needed(),
        entry(3, "Inhibit time", U16).access(RW_CONST),
        entry(4, "Reserved", &[]).access(&[]),
        entry(5, "Event timer", U16).access(RW_CONST),
        entry(6, "SYNC start value", U8).access(RW_CONST)
    }
    0x1600..=0x17FF "RPDO mapping parameter" ALIKE {
        entry(0, "Number of mapped application objects in RPDO", U8).access(RW_CONST).needed(),
        entries(1, 64, "Application object", U32).access(RW_CONST)
    }
    0x1800..=0x19FF "TPDO communication parameter" RECORD {
        highest(2, 6),
        entry(1, "COB-ID used by TPDO", U32).access(RW_CONST).needed(),
        entry(2, "Transmission type", U8).access(RW_CONST).needed(),
        entry(3, "Inhibit time", U16).access(RW_CONST),
        entry(4, "Reserved", &[]).access(&[]),
        entry(5, "Event timer", U16).access(RW_CONST),
        entry(6, "SYNC start value", U8).access(RW_CONST)
    }
    0x1A00..=0x1BFF "TPDO mapping parameter" ALIKE {
        entry(0, "Number of mapped application objects in TPDO", U8).access(RW_CONST).needed(),
        entries(1, 64, "Application object", U32).access(RW_CONST)
    }
    0x1FA0..=0x1FCF "Object scanner list" ARRAY {
        highest(1, 0xFE),
        entries(1, 0xFE, "Scan", U32).access(RW_CONST)
    }
    0x1FD0..=0x1FFF "Object dispatching list" ARRAY {
        highest(1, 0xFE),
        entries(1, 0xFE, "Dispatch", U64).access(RW_CONST)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_order_and_found_by_index() {
        for pair in OBJECTS.windows(2) {
            assert!(pair[0].last < pair[1].first, "{:04X}", pair[1].first);
        }
        for facts in OBJECTS {
            for index in [facts.first, facts.last] {
                assert_eq!(object(index).map(|found| found.first), Some(facts.first));
            }
            assert!(facts.entries.windows(2).all(|pair| pair[0].last < pair[1].first), "{:04X}", facts.first);
            assert_eq!(facts.entry(0).map(|entry| entry.first), Some(0), "{:04X}", facts.first);
            assert_eq!(facts.entry(0xFF).map(|entry| entry.first), None);
        }
        for index in [0, 0xFFF, 0x1004, 0x101F, 0x1300, 0x1C00, 0x2000, 0xFFFF] {
            assert!(object(index).is_none(), "{index:04X}");
        }
    }

    #[test]
    fn access_types_that_stand_for_each_other() {
        let access = |index, sub: u8, access| {
            object(index).and_then(|facts| facts.entry(sub)).map(|facts| facts.accepts_access(access))
        };
        assert_eq!(access(0x1018, 1, Access::Const), Some(true));
        assert_eq!(access(0x1018, 1, Access::Rw), Some(false));
        assert_eq!(access(0x1600, 1, Access::Rww), Some(true));
        assert_eq!(access(0x1600, 1, Access::Wo), Some(false));
        assert_eq!(access(0x1800, 4, Access::Wo), Some(true));
    }

    #[test]
    fn every_device_has_three_objects() {
        let indexes: Vec<u16> = mandatory().map(|facts| facts.first).collect();
        assert_eq!(indexes, [0x1000, 0x1001, 0x1018]);
    }
}

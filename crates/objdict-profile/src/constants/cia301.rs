// Generated from `data/cia301.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Confidence::*, Mapping::*, Profile};

pub(super) static PROFILE: Profile = Profile {
    group: "cia301",
    document: Cow::Borrowed("CiA 301"),
    title: Cow::Borrowed("application layer and communication profile"),
    version: Some(Cow::Borrowed("4.2")),
    number: None,
    repeats: false,
    tables: Tables {
        objects: Cow::Borrowed(OBJECTS),
        entries: Cow::Borrowed(ENTRIES),
        bits: Cow::Borrowed(BITS),
        meanings: Cow::Borrowed(MEANINGS),
        conditions: Cow::Borrowed(CONDITIONS),
        object_types: Cow::Borrowed(OBJECT_TYPES),
        data_types: Cow::Borrowed(DATA_TYPES),
        access: Cow::Borrowed(ACCESS),
        values: Cow::Borrowed(VALUES),
        defaults: Cow::Borrowed(DEFAULTS),
        indexes: Cow::Borrowed(INDEXES),
        commands: Cow::Borrowed(COMMANDS),
        transitions: Cow::Borrowed(TRANSITIONS),
        texts: Cow::Borrowed(TEXTS),
        errors: Part(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(43, 11), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(0, 0), about: Part(54, 98), confidence: High }, // 1000h Device type
    ObjectRow { first: 4097, last: 4097, name: Part(253, 14), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(1, 1), source: Part(0, 0), about: Part(267, 96), confidence: High }, // 1001h Error register
    ObjectRow { first: 4098, last: 4098, name: Part(363, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(0, 0), about: Part(391, 45), confidence: High }, // 1002h Manufacturer status register
    ObjectRow { first: 4099, last: 4099, name: Part(493, 23), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(3, 2), source: Part(0, 0), about: Part(516, 106), confidence: High }, // 1003h Pre-defined error field
    ObjectRow { first: 4101, last: 4101, name: Part(709, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0), about: Part(728, 55), confidence: High }, // 1005h COB-ID SYNC message
    ObjectRow { first: 4102, last: 4102, name: Part(786, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(812, 62), confidence: High }, // 1006h Communication cycle period
    ObjectRow { first: 4103, last: 4103, name: Part(874, 25), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0), about: Part(899, 73), confidence: High }, // 1007h Synchronous window length
    ObjectRow { first: 4104, last: 4104, name: Part(972, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0), about: Part(996, 46), confidence: High }, // 1008h Manufacturer device name
    ObjectRow { first: 4105, last: 4105, name: Part(1042, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0), about: Part(1071, 28), confidence: High }, // 1009h Manufacturer hardware version
    ObjectRow { first: 4106, last: 4106, name: Part(1099, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0), about: Part(1128, 28), confidence: High }, // 100Ah Manufacturer software version
    ObjectRow { first: 4108, last: 4108, name: Part(1158, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(8, 1), source: Part(0, 0), about: Part(1168, 103), confidence: High }, // 100Ch Guard time
    ObjectRow { first: 4109, last: 4109, name: Part(1271, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(9, 1), source: Part(0, 0), about: Part(1287, 118), confidence: High }, // 100Dh Life time factor
    ObjectRow { first: 4112, last: 4112, name: Part(1549, 16), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(10, 5), source: Part(0, 0), about: Part(1565, 125), confidence: High }, // 1010h Store parameters
    ObjectRow { first: 4113, last: 4113, name: Part(1873, 26), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(15, 5), source: Part(0, 0), about: Part(1899, 93), confidence: High }, // 1011h Restore default parameters
    ObjectRow { first: 4114, last: 4114, name: Part(2068, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(0, 0), about: Part(2092, 67), confidence: High }, // 1012h COB-ID time stamp object
    ObjectRow { first: 4115, last: 4115, name: Part(2159, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0), about: Part(2185, 64), confidence: High }, // 1013h High resolution time stamp
    ObjectRow { first: 4116, last: 4116, name: Part(2271, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(22, 1), source: Part(0, 0), about: Part(2282, 54), confidence: High }, // 1014h COB-ID EMCY
    ObjectRow { first: 4117, last: 4117, name: Part(2343, 17), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(23, 1), source: Part(0, 0), about: Part(2360, 58), confidence: High }, // 1015h Inhibit time EMCY
    ObjectRow { first: 4118, last: 4118, name: Part(2445, 23), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(24, 3), source: Part(0, 0), about: Part(2468, 98), confidence: High }, // 1016h Consumer heartbeat time
    ObjectRow { first: 4119, last: 4119, name: Part(2566, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(8, 1), source: Part(0, 0), about: Part(2589, 76), confidence: High }, // 1017h Producer heartbeat time
    ObjectRow { first: 4120, last: 4120, name: Part(2742, 15), object_types: Part(3, 2), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(27, 5), source: Part(0, 0), about: Part(2757, 103), confidence: High }, // 1018h Identity object
    ObjectRow { first: 4121, last: 4121, name: Part(2860, 34), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(9, 1), source: Part(0, 0), about: Part(2894, 93), confidence: High }, // 1019h Synchronous counter overflow value
    ObjectRow { first: 4128, last: 4128, name: Part(3023, 20), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(32, 3), source: Part(0, 0), about: Part(3043, 110), confidence: High }, // 1020h Verify configuration
    ObjectRow { first: 4129, last: 4129, name: Part(3153, 9), object_types: Part(5, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 1), source: Part(0, 0), about: Part(3162, 51), confidence: High }, // 1021h Store EDS
    ObjectRow { first: 4130, last: 4130, name: Part(3213, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(36, 1), source: Part(0, 0), about: Part(3225, 31), confidence: High }, // 1022h Store format
    ObjectRow { first: 4131, last: 4131, name: Part(3274, 10), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 4), source: Part(0, 0), about: Part(3284, 82), confidence: High }, // 1023h OS command
    ObjectRow { first: 4132, last: 4132, name: Part(3366, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(41, 1), source: Part(0, 0), about: Part(3381, 72), confidence: High }, // 1024h OS command mode
    ObjectRow { first: 4133, last: 4133, name: Part(3453, 21), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 4), source: Part(0, 0), about: Part(3474, 79), confidence: High }, // 1025h OS debugger interface
    ObjectRow { first: 4134, last: 4134, name: Part(3570, 9), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(42, 4), source: Part(0, 0), about: Part(3579, 77), confidence: High }, // 1026h OS prompt
    ObjectRow { first: 4135, last: 4135, name: Part(3662, 11), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(46, 2), source: Part(0, 0), about: Part(3673, 57), confidence: High }, // 1027h Module list
    ObjectRow { first: 4136, last: 4136, name: Part(3748, 25), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(48, 2), source: Part(0, 0), about: Part(3773, 104), confidence: High }, // 1028h Emergency consumer object
    ObjectRow { first: 4137, last: 4137, name: Part(3992, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(50, 3), source: Part(0, 0), about: Part(4013, 96), confidence: High }, // 1029h Error behavior object
    ObjectRow { first: 4608, last: 4608, name: Part(4203, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(53, 4), source: Part(0, 0), about: Part(4223, 86), confidence: High }, // 1200h SDO server parameter
    ObjectRow { first: 4609, last: 4735, name: Part(4203, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(57, 4), source: Part(0, 0), about: Part(4309, 66), confidence: High }, // 1201h SDO server parameter
    ObjectRow { first: 4736, last: 4863, name: Part(4400, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(61, 4), source: Part(0, 0), about: Part(4420, 90), confidence: High }, // 1280h SDO client parameter
    ObjectRow { first: 5120, last: 5631, name: Part(4726, 28), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(65, 7), source: Part(0, 0), about: Part(4754, 77), confidence: High }, // 1400h RPDO communication parameter
    ObjectRow { first: 5632, last: 6143, name: Part(4921, 22), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 2), source: Part(0, 0), about: Part(4943, 81), confidence: High }, // 1600h RPDO mapping parameter
    ObjectRow { first: 6144, last: 6655, name: Part(5165, 28), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(74, 7), source: Part(0, 0), about: Part(5193, 52), confidence: High }, // 1800h TPDO communication parameter
    ObjectRow { first: 6656, last: 7167, name: Part(5289, 22), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(81, 2), source: Part(0, 0), about: Part(5311, 59), confidence: High }, // 1A00h TPDO mapping parameter
    ObjectRow { first: 8096, last: 8143, name: Part(5395, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(83, 2), source: Part(0, 0), about: Part(5414, 74), confidence: High }, // 1FA0h Object scanner list
    ObjectRow { first: 8144, last: 8191, name: Part(5496, 23), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(85, 2), source: Part(0, 0), about: Part(5519, 83), confidence: High }, // 1FD0h Object dispatching list
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 2) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(2, 7) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(473, 20), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(9, 2) }, // Standard error field
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(11, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(783, 3), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(1156, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1438, 19), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(14, 2) }, // Save all parameters
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(1457, 29), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(14, 2) }, // Save communication parameters
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1486, 27), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(14, 2) }, // Save application parameters
    EntryRow { first: 4, last: 127, mapping: Some(No), need: Optional, name: Part(1513, 36), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(14, 2) }, // Save manufacturer-defined parameters
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1718, 30), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(16, 1) }, // Restore all default parameters
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(1748, 40), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(16, 1) }, // Restore communication default parameters
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1788, 38), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(16, 1) }, // Restore application default parameters
    EntryRow { first: 4, last: 127, mapping: Some(No), need: Optional, name: Part(1826, 47), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(16, 1) }, // Restore manufacturer-defined default parameters
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(17, 4) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(4, 3), values: Part(0, 0), default: None, unit: Part(783, 3), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(21, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(2336, 7), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2445, 23), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(24, 2) }, // Consumer heartbeat time
    EntryRow { first: 2, last: 127, mapping: Some(No), need: Optional, name: Part(2445, 23), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(24, 2) }, // Consumer heartbeat time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2665, 9), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Vendor-ID
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(2674, 12), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Product code
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(2714, 15), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(26, 2) }, // Revision number
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(2729, 13), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Serial number
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2987, 18), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Configuration date
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(3005, 18), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Configuration time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(5, 2), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(4, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3256, 7), data_types: Part(7, 1), access: Part(7, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Command
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(3263, 6), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Status
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Mandatory, name: Part(3269, 5), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Reply
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(9, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(5, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(3553, 5), data_types: Part(1, 1), access: Part(9, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // StdIn
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(3558, 6), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // StdOut
    EntryRow { first: 3, last: 3, mapping: Some(Any), need: Optional, name: Part(3564, 6), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // StdErr
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(3656, 6), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Module
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Optional, name: Part(3730, 18), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(21, 3) }, // Emergency consumer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(6, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3934, 19), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(28, 1) }, // Communication error
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(3953, 39), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(28, 1) }, // Profile- or manufacturer-specific error
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(5, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(4132, 23), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(29, 4) }, // COB-ID client to server
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(4155, 23), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(29, 4) }, // COB-ID server to client
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(4178, 25), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Node-ID of the SDO client
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(5, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(4132, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(29, 4) }, // COB-ID client to server
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(4155, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(29, 4) }, // COB-ID server to client
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(4178, 25), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Node-ID of the SDO client
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(4, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(4132, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(29, 4) }, // COB-ID client to server
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(4155, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(29, 4) }, // COB-ID server to client
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Mandatory, name: Part(4375, 25), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Node-ID of the SDO server
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(7, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4510, 19), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(21, 3) }, // COB-ID used by RPDO
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(4662, 17), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(33, 1) }, // Transmission type
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(4679, 12), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(2336, 7), bits: Part(0, 0) }, // Inhibit time
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(4691, 8), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Reserved
    EntryRow { first: 5, last: 5, mapping: Some(No), need: Optional, name: Part(4699, 11), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(1156, 2), bits: Part(0, 0) }, // Event timer
    EntryRow { first: 6, last: 6, mapping: Some(No), need: Optional, name: Part(4710, 16), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // SYNC start value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(4831, 44), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Number of mapped application objects in RPDO
    EntryRow { first: 1, last: 64, mapping: Some(No), need: Optional, name: Part(4903, 18), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(34, 3) }, // Application object
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(7, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(5055, 19), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(37, 4) }, // COB-ID used by TPDO
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(4662, 17), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(41, 1) }, // Transmission type
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(4679, 12), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(2336, 7), bits: Part(0, 0) }, // Inhibit time
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(4691, 8), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Reserved
    EntryRow { first: 5, last: 5, mapping: Some(No), need: Optional, name: Part(4699, 11), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(1156, 2), bits: Part(0, 0) }, // Event timer
    EntryRow { first: 6, last: 6, mapping: Some(No), need: Optional, name: Part(4710, 16), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // SYNC start value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(5245, 44), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Number of mapped application objects in TPDO
    EntryRow { first: 1, last: 64, mapping: Some(No), need: Optional, name: Part(4903, 18), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(34, 3) }, // Application object
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(6, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(5391, 4), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(42, 3) }, // Scan
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(436, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(6, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(5488, 8), data_types: Part(8, 1), access: Part(1, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Dispatch
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 15, name: Part(0, 21), values: Part(0, 0) }, // device profile number
    BitRow { first: 16, last: 31, name: Part(21, 22), values: Part(0, 0) }, // additional information
    BitRow { first: 0, last: 0, name: Part(152, 13), values: Part(0, 0) }, // generic error
    BitRow { first: 1, last: 1, name: Part(165, 7), values: Part(0, 0) }, // current
    BitRow { first: 2, last: 2, name: Part(172, 7), values: Part(0, 0) }, // voltage
    BitRow { first: 3, last: 3, name: Part(179, 11), values: Part(0, 0) }, // temperature
    BitRow { first: 4, last: 4, name: Part(190, 19), values: Part(0, 0) }, // communication error
    BitRow { first: 5, last: 5, name: Part(209, 23), values: Part(0, 0) }, // device profile-specific
    BitRow { first: 7, last: 7, name: Part(232, 21), values: Part(0, 0) }, // manufacturer-specific
    BitRow { first: 0, last: 15, name: Part(463, 10), values: Part(0, 0) }, // error code
    BitRow { first: 16, last: 31, name: Part(21, 22), values: Part(0, 0) }, // additional information
    BitRow { first: 0, last: 28, name: Part(622, 6), values: Part(0, 0) }, // CAN-ID
    BitRow { first: 29, last: 29, name: Part(628, 5), values: Part(0, 2) }, // frame
    BitRow { first: 30, last: 30, name: Part(667, 8), values: Part(2, 2) }, // producer
    BitRow { first: 0, last: 0, name: Part(1405, 17), values: Part(0, 0) }, // stores on command
    BitRow { first: 1, last: 1, name: Part(1422, 16), values: Part(0, 0) }, // stores by itself
    BitRow { first: 0, last: 0, name: Part(1690, 28), values: Part(0, 0) }, // restores defaults on command
    BitRow { first: 0, last: 28, name: Part(622, 6), values: Part(0, 0) }, // CAN-ID
    BitRow { first: 29, last: 29, name: Part(628, 5), values: Part(0, 2) }, // frame
    BitRow { first: 30, last: 30, name: Part(667, 8), values: Part(4, 2) }, // producer
    BitRow { first: 31, last: 31, name: Part(2026, 8), values: Part(6, 2) }, // consumer
    BitRow { first: 0, last: 28, name: Part(622, 6), values: Part(0, 0) }, // CAN-ID
    BitRow { first: 29, last: 29, name: Part(628, 5), values: Part(0, 2) }, // frame
    BitRow { first: 31, last: 31, name: Part(2249, 8), values: Part(8, 2) }, // validity
    BitRow { first: 0, last: 15, name: Part(2418, 20), values: Part(0, 0) }, // heartbeat time in ms
    BitRow { first: 16, last: 23, name: Part(2438, 7), values: Part(0, 0) }, // node-ID
    BitRow { first: 0, last: 15, name: Part(2686, 14), values: Part(0, 0) }, // minor revision
    BitRow { first: 16, last: 31, name: Part(2700, 14), values: Part(0, 0) }, // major revision
    BitRow { first: 0, last: 7, name: Part(3877, 8), values: Part(10, 3) }, // reaction
    BitRow { first: 0, last: 28, name: Part(622, 6), values: Part(0, 0) }, // CAN-ID
    BitRow { first: 29, last: 29, name: Part(628, 5), values: Part(0, 2) }, // frame
    BitRow { first: 30, last: 30, name: Part(4109, 10), values: Part(13, 2) }, // assignment
    BitRow { first: 31, last: 31, name: Part(2249, 8), values: Part(8, 2) }, // validity
    BitRow { first: 0, last: 7, name: Part(4529, 17), values: Part(15, 3) }, // transmission type
    BitRow { first: 0, last: 7, name: Part(4875, 14), values: Part(0, 0) }, // length in bits
    BitRow { first: 8, last: 15, name: Part(4889, 9), values: Part(0, 0) }, // sub-index
    BitRow { first: 16, last: 31, name: Part(4898, 5), values: Part(0, 0) }, // index
    BitRow { first: 0, last: 28, name: Part(622, 6), values: Part(0, 0) }, // CAN-ID
    BitRow { first: 29, last: 29, name: Part(628, 5), values: Part(0, 2) }, // frame
    BitRow { first: 30, last: 30, name: Part(5024, 13), values: Part(18, 2) }, // remote frames
    BitRow { first: 31, last: 31, name: Part(2249, 8), values: Part(8, 2) }, // validity
    BitRow { first: 0, last: 7, name: Part(4529, 17), values: Part(20, 6) }, // transmission type
    BitRow { first: 0, last: 7, name: Part(4889, 9), values: Part(0, 0) }, // sub-index
    BitRow { first: 8, last: 23, name: Part(4898, 5), values: Part(0, 0) }, // index
    BitRow { first: 24, last: 31, name: Part(5370, 21), values: Part(0, 0) }, // number of sub-indexes
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(633, 17) }, // CAN-ID of 11 bits
    MeaningRow { first: 1, last: 1, text: Part(650, 17) }, // CAN-ID of 29 bits
    MeaningRow { first: 0, last: 0, text: Part(675, 21) }, // does not produce SYNC
    MeaningRow { first: 1, last: 1, text: Part(696, 13) }, // produces SYNC
    MeaningRow { first: 0, last: 0, text: Part(1992, 21) }, // does not produce TIME
    MeaningRow { first: 1, last: 1, text: Part(2013, 13) }, // produces TIME
    MeaningRow { first: 0, last: 0, text: Part(2034, 21) }, // does not consume TIME
    MeaningRow { first: 1, last: 1, text: Part(2055, 13) }, // consumes TIME
    MeaningRow { first: 0, last: 0, text: Part(2257, 5) }, // valid
    MeaningRow { first: 1, last: 1, text: Part(2262, 9) }, // not valid
    MeaningRow { first: 0, last: 0, text: Part(3885, 33) }, // pre-operational, from operational
    MeaningRow { first: 1, last: 1, text: Part(3918, 9) }, // no change
    MeaningRow { first: 2, last: 2, text: Part(3927, 7) }, // stopped
    MeaningRow { first: 0, last: 0, text: Part(4119, 6) }, // static
    MeaningRow { first: 1, last: 1, text: Part(4125, 7) }, // dynamic
    MeaningRow { first: 0, last: 240, text: Part(4546, 38) }, // synchronous: counts with the next SYNC
    MeaningRow { first: 254, last: 254, text: Part(4584, 35) }, // event-driven, as the vendor defines
    MeaningRow { first: 255, last: 255, text: Part(4619, 43) }, // event-driven, as the device profile defines
    MeaningRow { first: 0, last: 0, text: Part(5037, 7) }, // allowed
    MeaningRow { first: 1, last: 1, text: Part(5044, 11) }, // not allowed
    MeaningRow { first: 0, last: 0, text: Part(5074, 27) }, // synchronous, after an event
    MeaningRow { first: 1, last: 240, text: Part(5101, 27) }, // synchronous, every nth SYNC
    MeaningRow { first: 252, last: 252, text: Part(5128, 27) }, // on request, sampled at SYNC
    MeaningRow { first: 253, last: 253, text: Part(5155, 10) }, // on request
    MeaningRow { first: 254, last: 254, text: Part(4584, 35) }, // event-driven, as the vendor defines
    MeaningRow { first: 255, last: 255, text: Part(4619, 43) }, // event-driven, as the device profile defines
];

static COMMANDS: &[CommandRow] = &[
];

static TRANSITIONS: &[TransitionRow] = &[
];

static CONDITIONS: &[Condition] = &[
];

static OBJECT_TYPES: &[ObjectType] = &[Var, Array, Record, Record, Array, Domain, Record];

static DATA_TYPES: &[DataType] = &[DataType(7), DataType(5), DataType(9), DataType(6), DataType(15), DataType(5), DataType(6), DataType(10), DataType(27)];

static ACCESS: &[Access] = &[Ro, Rw, Const, Rw, Rw, Ro, Wo, Rw, Wo, Wo];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[0..=254, 1..=127, 1..=4, 2..=2, 3..=3, 2..=3, 1..=254, 2..=6];

static DEFAULTS: &[Value] = &[];

static INDEXES: &[u16] = &[];

static TEXTS: &str = concat!(
    "device profile number", "additional information", "Device type",
    "Says which device profile the device follows (low word) and what of it the device has (high word).",
    "generic error", "current", "voltage", "temperature", "communication error", "device profile-specific",
    "manufacturer-specific", "Error register",
    "Sums up the errors that are present now, one bit per error class; every EMCY message carries it.",
    "Manufacturer status register", "Status bits whose meaning the vendor defines.",
    "Highest sub-index supported", "error code", "Standard error field", "Pre-defined error field",
    "Lists the errors that were reported with EMCY, the latest first; writing 0 to sub-index 0 clears the list.",
    "CAN-ID", "frame", "CAN-ID of 11 bits", "CAN-ID of 29 bits", "producer", "does not produce SYNC",
    "produces SYNC", "COB-ID SYNC message", "The CAN-ID of SYNC, and whether the device produces it.", "µs",
    "Communication cycle period", "The time between two SYNC messages; 0 switches a producer off.",
    "Synchronous window length", "How long after SYNC synchronous PDOs may still be sent; 0 means no limit.",
    "Manufacturer device name", "The name of the device as the vendor gives it.",
    "Manufacturer hardware version", "The version of the hardware.", "Manufacturer software version",
    "The version of the software.", "ms", "Guard time",
    "The period in which the NMT master asks for the state of the device (node guarding); 0 switches it off.",
    "Life time factor",
    "The number of guard times without a request after which the device reports a life guarding event; 0 switches that off.",
    "stores on command", "stores by itself", "Save all parameters", "Save communication parameters",
    "Save application parameters", "Save manufacturer-defined parameters", "Store parameters",
    "Stores parameters in non-volatile memory when `save` (65766173h) is written; read, it says whether and how the device stores.",
    "restores defaults on command", "Restore all default parameters", "Restore communication default parameters",
    "Restore application default parameters", "Restore manufacturer-defined default parameters",
    "Restore default parameters",
    "Brings the defaults back when `load` (64616F6Ch) is written; they count after the next reset.",
    "does not produce TIME", "produces TIME", "consumer", "does not consume TIME", "consumes TIME",
    "COB-ID time stamp object", "The CAN-ID of TIME, and whether the device produces or consumes it.",
    "High resolution time stamp", "A clock in microseconds, finer than TIME, which a PDO can carry.", "validity",
    "valid", "not valid", "COB-ID EMCY", "The CAN-ID of the EMCY messages that the device sends.", "100 µs",
    "Inhibit time EMCY", "The shortest time between two EMCY messages of the device.", "heartbeat time in ms",
    "node-ID", "Consumer heartbeat time",
    "Which nodes the device watches by their heartbeat, one a sub-index, and how long it waits for one.",
    "Producer heartbeat time", "The time between two heartbeats of the device; 0 switches the heartbeat off.",
    "Vendor-ID", "Product code", "minor revision", "major revision", "Revision number", "Serial number",
    "Identity object",
    "Identifies the device by vendor, product, revision and serial number; LSS selects a device by all four.",
    "Synchronous counter overflow value",
    "The value after which the counter in SYNC starts again at 1; with 0, SYNC carries no counter.",
    "Configuration date", "Configuration time", "Verify configuration",
    "Date and time of the configuration that is stored, so that a configuration manager need not download it again.",
    "Store EDS", "The EDS of the device, stored in the device itself.", "Store format",
    "The format of the EDS in 1021h.", "Command", "Status", "Reply", "OS command",
    "Runs a command of the device's operating system and answers with status and reply.", "OS command mode",
    "Says whether commands of 1023h run at once or are collected in a buffer.", "OS debugger interface",
    "Runs a command of the debugger in the device and answers with status and reply.", "StdIn", "StdOut",
    "StdErr", "OS prompt", "A character console of the device: one character in, one out, one for errors.",
    "Module", "Module list", "Lists the modules that are plugged into a modular device.", "Emergency consumer",
    "Emergency consumer object",
    "The CAN-IDs of the EMCY messages that the device listens to; the sub-index is the node-ID of the sender.",
    "reaction", "pre-operational, from operational", "no change", "stopped", "Communication error",
    "Profile- or manufacturer-specific error", "Error behavior object",
    "The NMT state that the device enters when a serious error occurs, one sub-index a kind of error.",
    "assignment", "static", "dynamic", "COB-ID client to server", "COB-ID server to client",
    "Node-ID of the SDO client", "SDO server parameter",
    "The CAN-IDs of the default SDO server, by which every other entry is read and written.",
    "The CAN-IDs of a further SDO server and the node-ID of its client.", "Node-ID of the SDO server",
    "SDO client parameter",
    "The CAN-IDs of an SDO client of the device and the node-ID of the server that it talks to.",
    "COB-ID used by RPDO", "transmission type", "synchronous: counts with the next SYNC",
    "event-driven, as the vendor defines", "event-driven, as the device profile defines", "Transmission type",
    "Inhibit time", "Reserved", "Event timer", "SYNC start value", "RPDO communication parameter",
    "When the device takes over a received PDO, and under which CAN-ID it arrives.",
    "Number of mapped application objects in RPDO", "length in bits", "sub-index", "index", "Application object",
    "RPDO mapping parameter",
    "Which objects the data of a received PDO is written to, in the order of its bits.", "remote frames",
    "allowed", "not allowed", "COB-ID used by TPDO", "synchronous, after an event",
    "synchronous, every nth SYNC", "on request, sampled at SYNC", "on request", "TPDO communication parameter",
    "When the device sends a PDO, and under which CAN-ID.", "Number of mapped application objects in TPDO",
    "TPDO mapping parameter", "Which objects a sent PDO carries, in the order of its bits.",
    "number of sub-indexes", "Scan", "Object scanner list",
    "Objects that the device sends by multiplex PDOs in source addressing mode.", "Dispatch",
    "Object dispatching list",
    "Where the device puts what it receives by multiplex PDOs in source addressing mode.",
);

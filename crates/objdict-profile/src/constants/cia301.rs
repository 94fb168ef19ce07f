// Generated from `data/cia301.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Mapping::*, Profile};

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
        texts: Cow::Borrowed(TEXTS),
    },
};

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(0, 11), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(0, 0) }, // 1000h Device type
    ObjectRow { first: 4097, last: 4097, name: Part(11, 14), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(1, 1), source: Part(0, 0) }, // 1001h Error register
    ObjectRow { first: 4098, last: 4098, name: Part(25, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(0, 0) }, // 1002h Manufacturer status register
    ObjectRow { first: 4099, last: 4099, name: Part(100, 23), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(3, 2), source: Part(0, 0) }, // 1003h Pre-defined error field
    ObjectRow { first: 4101, last: 4101, name: Part(123, 19), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0) }, // 1005h COB-ID SYNC message
    ObjectRow { first: 4102, last: 4102, name: Part(142, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 1006h Communication cycle period
    ObjectRow { first: 4103, last: 4103, name: Part(168, 25), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 1), source: Part(0, 0) }, // 1007h Synchronous window length
    ObjectRow { first: 4104, last: 4104, name: Part(193, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0) }, // 1008h Manufacturer device name
    ObjectRow { first: 4105, last: 4105, name: Part(217, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0) }, // 1009h Manufacturer hardware version
    ObjectRow { first: 4106, last: 4106, name: Part(246, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(7, 1), source: Part(0, 0) }, // 100Ah Manufacturer software version
    ObjectRow { first: 4108, last: 4108, name: Part(275, 10), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(8, 1), source: Part(0, 0) }, // 100Ch Guard time
    ObjectRow { first: 4109, last: 4109, name: Part(285, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(9, 1), source: Part(0, 0) }, // 100Dh Life time factor
    ObjectRow { first: 4112, last: 4112, name: Part(412, 16), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(10, 5), source: Part(0, 0) }, // 1010h Store parameters
    ObjectRow { first: 4113, last: 4113, name: Part(583, 26), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(15, 5), source: Part(0, 0) }, // 1011h Restore default parameters
    ObjectRow { first: 4114, last: 4114, name: Part(609, 24), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0) }, // 1012h COB-ID time stamp object
    ObjectRow { first: 4115, last: 4115, name: Part(633, 26), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(20, 1), source: Part(0, 0) }, // 1013h High resolution time stamp
    ObjectRow { first: 4116, last: 4116, name: Part(659, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(5, 1), source: Part(0, 0) }, // 1014h COB-ID EMCY
    ObjectRow { first: 4117, last: 4117, name: Part(670, 17), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 1), source: Part(0, 0) }, // 1015h Inhibit time EMCY
    ObjectRow { first: 4118, last: 4118, name: Part(687, 23), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(22, 3), source: Part(0, 0) }, // 1016h Consumer heartbeat time
    ObjectRow { first: 4119, last: 4119, name: Part(710, 23), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(8, 1), source: Part(0, 0) }, // 1017h Producer heartbeat time
    ObjectRow { first: 4120, last: 4120, name: Part(782, 15), object_types: Part(3, 2), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(25, 5), source: Part(0, 0) }, // 1018h Identity object
    ObjectRow { first: 4121, last: 4121, name: Part(797, 34), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(9, 1), source: Part(0, 0) }, // 1019h Synchronous counter overflow value
    ObjectRow { first: 4128, last: 4128, name: Part(867, 20), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(30, 3), source: Part(0, 0) }, // 1020h Verify configuration
    ObjectRow { first: 4129, last: 4129, name: Part(887, 9), object_types: Part(5, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(33, 1), source: Part(0, 0) }, // 1021h Store EDS
    ObjectRow { first: 4130, last: 4130, name: Part(896, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(34, 1), source: Part(0, 0) }, // 1022h Store format
    ObjectRow { first: 4131, last: 4131, name: Part(926, 10), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 4), source: Part(0, 0) }, // 1023h OS command
    ObjectRow { first: 4132, last: 4132, name: Part(936, 15), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(39, 1), source: Part(0, 0) }, // 1024h OS command mode
    ObjectRow { first: 4133, last: 4133, name: Part(951, 21), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(35, 4), source: Part(0, 0) }, // 1025h OS debugger interface
    ObjectRow { first: 4134, last: 4134, name: Part(989, 9), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(40, 4), source: Part(0, 0) }, // 1026h OS prompt
    ObjectRow { first: 4135, last: 4135, name: Part(1004, 11), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(44, 2), source: Part(0, 0) }, // 1027h Module list
    ObjectRow { first: 4136, last: 4136, name: Part(1033, 25), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(46, 2), source: Part(0, 0) }, // 1028h Emergency consumer object
    ObjectRow { first: 4137, last: 4137, name: Part(1116, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(48, 3), source: Part(0, 0) }, // 1029h Error behavior object
    ObjectRow { first: 4608, last: 4608, name: Part(1208, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(51, 4), source: Part(0, 0) }, // 1200h SDO server parameter
    ObjectRow { first: 4609, last: 4735, name: Part(1208, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(55, 4), source: Part(0, 0) }, // 1201h SDO server parameter
    ObjectRow { first: 4736, last: 4863, name: Part(1253, 20), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(59, 4), source: Part(0, 0) }, // 1280h SDO client parameter
    ObjectRow { first: 5120, last: 5631, name: Part(1356, 28), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 7), source: Part(0, 0) }, // 1400h RPDO communication parameter
    ObjectRow { first: 5632, last: 6143, name: Part(1446, 22), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(70, 2), source: Part(0, 0) }, // 1600h RPDO mapping parameter
    ObjectRow { first: 6144, last: 6655, name: Part(1487, 28), object_types: Part(6, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 7), source: Part(0, 0) }, // 1800h TPDO communication parameter
    ObjectRow { first: 6656, last: 7167, name: Part(1559, 22), object_types: Part(3, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(79, 2), source: Part(0, 0) }, // 1A00h TPDO mapping parameter
    ObjectRow { first: 8096, last: 8143, name: Part(1585, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(81, 2), source: Part(0, 0) }, // 1FA0h Object scanner list
    ObjectRow { first: 8144, last: 8191, name: Part(1612, 23), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(83, 2), source: Part(0, 0) }, // 1FD0h Object dispatching list
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(80, 20), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Standard error field
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(301, 19), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Save all parameters
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(320, 29), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Save communication parameters
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(349, 27), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Save application parameters
    EntryRow { first: 4, last: 127, mapping: Some(No), need: Optional, name: Part(376, 36), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Save manufacturer-defined parameters
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(428, 30), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Restore all default parameters
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(458, 40), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Restore communication default parameters
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(498, 38), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Restore application default parameters
    EntryRow { first: 4, last: 127, mapping: Some(No), need: Optional, name: Part(536, 47), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Restore manufacturer-defined default parameters
    EntryRow { first: 0, last: 0, mapping: Some(Any), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(4, 3), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(3, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(687, 23), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Consumer heartbeat time
    EntryRow { first: 2, last: 127, mapping: Some(No), need: Optional, name: Part(687, 23), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Consumer heartbeat time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(733, 9), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Vendor-ID
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(742, 12), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Product code
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(754, 15), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Revision number
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(769, 13), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Serial number
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(3, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(831, 18), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Configuration date
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(849, 18), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Configuration time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(5, 2), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(4, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(908, 7), data_types: Part(7, 1), access: Part(7, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Command
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(915, 6), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Status
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Mandatory, name: Part(921, 5), data_types: Part(7, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Reply
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(9, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(5, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(972, 5), data_types: Part(1, 1), access: Part(9, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // StdIn
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(977, 6), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // StdOut
    EntryRow { first: 3, last: 3, mapping: Some(Any), need: Optional, name: Part(983, 6), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // StdErr
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(998, 6), data_types: Part(3, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Module
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Optional, name: Part(1015, 18), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Emergency consumer
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(6, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1058, 19), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Communication error
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1077, 39), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Profile- or manufacturer-specific error
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(5, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1137, 23), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID client to server
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(1160, 23), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID server to client
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1183, 25), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Node-ID of the SDO client
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(5, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1137, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID client to server
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(1160, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID server to client
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1183, 25), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Node-ID of the SDO client
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(4, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1137, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID client to server
    EntryRow { first: 2, last: 2, mapping: Some(Any), need: Mandatory, name: Part(1160, 23), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID server to client
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Mandatory, name: Part(1228, 25), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Node-ID of the SDO server
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(7, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1273, 19), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID used by RPDO
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(1292, 17), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Transmission type
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1309, 12), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Inhibit time
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(1321, 8), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Reserved
    EntryRow { first: 5, last: 5, mapping: Some(No), need: Optional, name: Part(1329, 11), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Event timer
    EntryRow { first: 6, last: 6, mapping: Some(No), need: Optional, name: Part(1340, 16), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // SYNC start value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1384, 44), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Number of mapped application objects in RPDO
    EntryRow { first: 1, last: 64, mapping: Some(No), need: Optional, name: Part(1428, 18), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Application object
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(7, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1468, 19), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // COB-ID used by TPDO
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(1292, 17), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Transmission type
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1309, 12), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Inhibit time
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(1321, 8), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Reserved
    EntryRow { first: 5, last: 5, mapping: Some(No), need: Optional, name: Part(1329, 11), data_types: Part(3, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Event timer
    EntryRow { first: 6, last: 6, mapping: Some(No), need: Optional, name: Part(1340, 16), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // SYNC start value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1515, 44), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Number of mapped application objects in TPDO
    EntryRow { first: 1, last: 64, mapping: Some(No), need: Optional, name: Part(1428, 18), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Application object
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(6, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(1581, 4), data_types: Part(0, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Scan
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(53, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(6, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(1604, 8), data_types: Part(8, 1), access: Part(1, 2), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Dispatch
];

static BITS: &[BitRow] = &[
];

static MEANINGS: &[MeaningRow] = &[
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
    "Device type", "Error register", "Manufacturer status register", "Highest sub-index supported",
    "Standard error field", "Pre-defined error field", "COB-ID SYNC message", "Communication cycle period",
    "Synchronous window length", "Manufacturer device name", "Manufacturer hardware version",
    "Manufacturer software version", "Guard time", "Life time factor", "Save all parameters",
    "Save communication parameters", "Save application parameters", "Save manufacturer-defined parameters",
    "Store parameters", "Restore all default parameters", "Restore communication default parameters",
    "Restore application default parameters", "Restore manufacturer-defined default parameters",
    "Restore default parameters", "COB-ID time stamp object", "High resolution time stamp", "COB-ID EMCY",
    "Inhibit time EMCY", "Consumer heartbeat time", "Producer heartbeat time", "Vendor-ID", "Product code",
    "Revision number", "Serial number", "Identity object", "Synchronous counter overflow value",
    "Configuration date", "Configuration time", "Verify configuration", "Store EDS", "Store format", "Command",
    "Status", "Reply", "OS command", "OS command mode", "OS debugger interface", "StdIn", "StdOut", "StdErr",
    "OS prompt", "Module", "Module list", "Emergency consumer", "Emergency consumer object",
    "Communication error", "Profile- or manufacturer-specific error", "Error behavior object",
    "COB-ID client to server", "COB-ID server to client", "Node-ID of the SDO client", "SDO server parameter",
    "Node-ID of the SDO server", "SDO client parameter", "COB-ID used by RPDO", "Transmission type",
    "Inhibit time", "Reserved", "Event timer", "SYNC start value", "RPDO communication parameter",
    "Number of mapped application objects in RPDO", "Application object", "RPDO mapping parameter",
    "COB-ID used by TPDO", "TPDO communication parameter", "Number of mapped application objects in TPDO",
    "TPDO mapping parameter", "Scan", "Object scanner list", "Dispatch", "Object dispatching list",
);

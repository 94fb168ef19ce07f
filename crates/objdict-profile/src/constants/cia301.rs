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
        errors: SubList(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4096, 4096, SubList(43, 11), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(0, 1), SubList(0, 0), SubList(54, 98), High) // 1000h Device type
    (4097, 4097, SubList(253, 14), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(1, 1), SubList(0, 0), SubList(267, 96), High) // 1001h Error register
    (4098, 4098, SubList(363, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(2, 1), SubList(0, 0), SubList(391, 45), High) // 1002h Manufacturer status register
    (4099, 4099, SubList(493, 23), SubList(1, 2), Optional, None, SubList(0, 0), SubList(3, 2), SubList(0, 0), SubList(516, 106), High) // 1003h Pre-defined error field
    (4101, 4101, SubList(709, 19), SubList(0, 1), Optional, None, SubList(0, 0), SubList(5, 1), SubList(0, 0), SubList(728, 55), High) // 1005h COB-ID SYNC message
    (4102, 4102, SubList(786, 26), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(812, 62), High) // 1006h Communication cycle period
    (4103, 4103, SubList(874, 25), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(899, 73), High) // 1007h Synchronous window length
    (4104, 4104, SubList(972, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(996, 46), High) // 1008h Manufacturer device name
    (4105, 4105, SubList(1042, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(1071, 28), High) // 1009h Manufacturer hardware version
    (4106, 4106, SubList(1099, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(1128, 28), High) // 100Ah Manufacturer software version
    (4108, 4108, SubList(1158, 10), SubList(0, 1), Optional, None, SubList(0, 0), SubList(8, 1), SubList(0, 0), SubList(1168, 103), High) // 100Ch Guard time
    (4109, 4109, SubList(1271, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(9, 1), SubList(0, 0), SubList(1287, 118), High) // 100Dh Life time factor
    (4112, 4112, SubList(1549, 16), SubList(1, 2), Optional, None, SubList(0, 0), SubList(10, 5), SubList(0, 0), SubList(1565, 125), High) // 1010h Store parameters
    (4113, 4113, SubList(1873, 26), SubList(1, 2), Optional, None, SubList(0, 0), SubList(15, 5), SubList(0, 0), SubList(1899, 93), High) // 1011h Restore default parameters
    (4114, 4114, SubList(2068, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(20, 1), SubList(0, 0), SubList(2092, 67), High) // 1012h COB-ID time stamp object
    (4115, 4115, SubList(2159, 26), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(2185, 64), High) // 1013h High resolution time stamp
    (4116, 4116, SubList(2271, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(22, 1), SubList(0, 0), SubList(2282, 54), High) // 1014h COB-ID EMCY
    (4117, 4117, SubList(2343, 17), SubList(0, 1), Optional, None, SubList(0, 0), SubList(23, 1), SubList(0, 0), SubList(2360, 58), High) // 1015h Inhibit time EMCY
    (4118, 4118, SubList(2445, 23), SubList(1, 2), Optional, None, SubList(0, 0), SubList(24, 3), SubList(0, 0), SubList(2468, 98), High) // 1016h Consumer heartbeat time
    (4119, 4119, SubList(2566, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(8, 1), SubList(0, 0), SubList(2589, 76), High) // 1017h Producer heartbeat time
    (4120, 4120, SubList(2742, 15), SubList(3, 2), Mandatory, None, SubList(0, 0), SubList(27, 5), SubList(0, 0), SubList(2757, 103), High) // 1018h Identity object
    (4121, 4121, SubList(2860, 34), SubList(0, 1), Optional, None, SubList(0, 0), SubList(9, 1), SubList(0, 0), SubList(2894, 93), High) // 1019h Synchronous counter overflow value
    (4128, 4128, SubList(3023, 20), SubList(1, 2), Optional, None, SubList(0, 0), SubList(32, 3), SubList(0, 0), SubList(3043, 110), High) // 1020h Verify configuration
    (4129, 4129, SubList(3153, 9), SubList(5, 1), Optional, None, SubList(0, 0), SubList(35, 1), SubList(0, 0), SubList(3162, 51), High) // 1021h Store EDS
    (4130, 4130, SubList(3213, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(36, 1), SubList(0, 0), SubList(3225, 31), High) // 1022h Store format
    (4131, 4131, SubList(3274, 10), SubList(6, 1), Optional, None, SubList(0, 0), SubList(37, 4), SubList(0, 0), SubList(3284, 82), High) // 1023h OS command
    (4132, 4132, SubList(3366, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(41, 1), SubList(0, 0), SubList(3381, 72), High) // 1024h OS command mode
    (4133, 4133, SubList(3453, 21), SubList(6, 1), Optional, None, SubList(0, 0), SubList(37, 4), SubList(0, 0), SubList(3474, 79), High) // 1025h OS debugger interface
    (4134, 4134, SubList(3570, 9), SubList(1, 2), Optional, None, SubList(0, 0), SubList(42, 4), SubList(0, 0), SubList(3579, 77), High) // 1026h OS prompt
    (4135, 4135, SubList(3662, 11), SubList(1, 2), Optional, None, SubList(0, 0), SubList(46, 2), SubList(0, 0), SubList(3673, 57), High) // 1027h Module list
    (4136, 4136, SubList(3748, 25), SubList(1, 2), Optional, None, SubList(0, 0), SubList(48, 2), SubList(0, 0), SubList(3773, 104), High) // 1028h Emergency consumer object
    (4137, 4137, SubList(3992, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(50, 3), SubList(0, 0), SubList(4013, 96), High) // 1029h Error behavior object
    (4608, 4608, SubList(4203, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(53, 4), SubList(0, 0), SubList(4223, 86), High) // 1200h SDO server parameter
    (4609, 4735, SubList(4203, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(57, 4), SubList(0, 0), SubList(4309, 66), High) // 1201h SDO server parameter
    (4736, 4863, SubList(4400, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(61, 4), SubList(0, 0), SubList(4420, 90), High) // 1280h SDO client parameter
    (5120, 5631, SubList(4726, 28), SubList(6, 1), Optional, None, SubList(0, 0), SubList(65, 7), SubList(0, 0), SubList(4754, 77), High) // 1400h RPDO communication parameter
    (5632, 6143, SubList(4921, 22), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 2), SubList(0, 0), SubList(4943, 81), High) // 1600h RPDO mapping parameter
    (6144, 6655, SubList(5165, 28), SubList(6, 1), Optional, None, SubList(0, 0), SubList(74, 7), SubList(0, 0), SubList(5193, 52), High) // 1800h TPDO communication parameter
    (6656, 7167, SubList(5289, 22), SubList(3, 2), Optional, None, SubList(0, 0), SubList(81, 2), SubList(0, 0), SubList(5311, 59), High) // 1A00h TPDO mapping parameter
    (8096, 8143, SubList(5395, 19), SubList(1, 2), Optional, None, SubList(0, 0), SubList(83, 2), SubList(0, 0), SubList(5414, 74), High) // 1FA0h Object scanner list
    (8144, 8191, SubList(5496, 23), SubList(1, 2), Optional, None, SubList(0, 0), SubList(85, 2), SubList(0, 0), SubList(5519, 83), High) // 1FD0h Object dispatching list
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 2))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(2, 7))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(1, 2), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 254, Some(No), Optional, SubList(473, 20), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(9, 2)) // Standard error field
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(11, 3))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(783, 3), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(3, 1), SubList(1, 2), SubList(0, 0), None, SubList(1156, 2), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1438, 19), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save all parameters
    (2, 2, Some(No), Optional, SubList(1457, 29), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save communication parameters
    (3, 3, Some(No), Optional, SubList(1486, 27), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save application parameters
    (4, 127, Some(No), Optional, SubList(1513, 36), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save manufacturer-defined parameters
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1718, 30), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore all default parameters
    (2, 2, Some(No), Optional, SubList(1748, 40), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore communication default parameters
    (3, 3, Some(No), Optional, SubList(1788, 38), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore application default parameters
    (4, 127, Some(No), Optional, SubList(1826, 47), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore manufacturer-defined default parameters
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(17, 4))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(4, 3), SubList(0, 0), None, SubList(783, 3), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(21, 3))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(3, 1), SubList(3, 1), SubList(0, 0), None, SubList(2336, 7), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2445, 23), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(24, 2)) // Consumer heartbeat time
    (2, 127, Some(No), Optional, SubList(2445, 23), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(24, 2)) // Consumer heartbeat time
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2665, 9), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Vendor-ID
    (2, 2, Some(No), Optional, SubList(2674, 12), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Product code
    (3, 3, Some(No), Optional, SubList(2714, 15), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(26, 2)) // Revision number
    (4, 4, Some(No), Optional, SubList(2729, 13), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Serial number
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2987, 18), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Configuration date
    (2, 2, Some(No), Mandatory, SubList(3005, 18), SubList(0, 1), SubList(3, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Configuration time
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(5, 2), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(4, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3256, 7), SubList(7, 1), SubList(7, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Command
    (2, 2, Some(No), Mandatory, SubList(3263, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Status
    (3, 3, Some(No), Mandatory, SubList(3269, 5), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Reply
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(9, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3553, 5), SubList(1, 1), SubList(9, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // StdIn
    (2, 2, Some(Any), Mandatory, SubList(3558, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // StdOut
    (3, 3, Some(Any), Optional, SubList(3564, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // StdErr
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 254, Some(No), Optional, SubList(3656, 6), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Module
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Optional, SubList(3730, 18), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(21, 3)) // Emergency consumer
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3934, 19), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(28, 1)) // Communication error
    (2, 254, Some(No), Optional, SubList(3953, 39), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(28, 1)) // Profile- or manufacturer-specific error
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(4132, 23), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID client to server
    (2, 2, Some(Any), Mandatory, SubList(4155, 23), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID server to client
    (3, 3, Some(No), Optional, SubList(4178, 25), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Node-ID of the SDO client
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(4132, 23), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID client to server
    (2, 2, Some(Any), Mandatory, SubList(4155, 23), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID server to client
    (3, 3, Some(No), Optional, SubList(4178, 25), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Node-ID of the SDO client
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(4, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(4132, 23), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID client to server
    (2, 2, Some(Any), Mandatory, SubList(4155, 23), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID server to client
    (3, 3, Some(No), Mandatory, SubList(4375, 25), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Node-ID of the SDO server
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(7, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4510, 19), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(21, 3)) // COB-ID used by RPDO
    (2, 2, Some(No), Mandatory, SubList(4662, 17), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(33, 1)) // Transmission type
    (3, 3, Some(No), Optional, SubList(4679, 12), SubList(3, 1), SubList(1, 2), SubList(0, 0), None, SubList(2336, 7), SubList(0, 0)) // Inhibit time
    (4, 4, Some(No), Optional, SubList(4691, 8), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Reserved
    (5, 5, Some(No), Optional, SubList(4699, 11), SubList(3, 1), SubList(1, 2), SubList(0, 0), None, SubList(1156, 2), SubList(0, 0)) // Event timer
    (6, 6, Some(No), Optional, SubList(4710, 16), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // SYNC start value
    (0, 0, Some(No), Mandatory, SubList(4831, 44), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Number of mapped application objects in RPDO
    (1, 64, Some(No), Optional, SubList(4903, 18), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(34, 3)) // Application object
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(7, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5055, 19), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(37, 4)) // COB-ID used by TPDO
    (2, 2, Some(No), Mandatory, SubList(4662, 17), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(41, 1)) // Transmission type
    (3, 3, Some(No), Optional, SubList(4679, 12), SubList(3, 1), SubList(1, 2), SubList(0, 0), None, SubList(2336, 7), SubList(0, 0)) // Inhibit time
    (4, 4, Some(No), Optional, SubList(4691, 8), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Reserved
    (5, 5, Some(No), Optional, SubList(4699, 11), SubList(3, 1), SubList(1, 2), SubList(0, 0), None, SubList(1156, 2), SubList(0, 0)) // Event timer
    (6, 6, Some(No), Optional, SubList(4710, 16), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // SYNC start value
    (0, 0, Some(No), Mandatory, SubList(5245, 44), SubList(1, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Number of mapped application objects in TPDO
    (1, 64, Some(No), Optional, SubList(4903, 18), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(34, 3)) // Application object
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 254, Some(No), Optional, SubList(5391, 4), SubList(0, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(42, 3)) // Scan
    (0, 0, Some(No), Mandatory, SubList(436, 27), SubList(1, 1), SubList(0, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 254, Some(No), Optional, SubList(5488, 8), SubList(8, 1), SubList(1, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Dispatch
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (0, 15, SubList(0, 21), SubList(0, 0)) // device profile number
    (16, 31, SubList(21, 22), SubList(0, 0)) // additional information
    (0, 0, SubList(152, 13), SubList(0, 0)) // generic error
    (1, 1, SubList(165, 7), SubList(0, 0)) // current
    (2, 2, SubList(172, 7), SubList(0, 0)) // voltage
    (3, 3, SubList(179, 11), SubList(0, 0)) // temperature
    (4, 4, SubList(190, 19), SubList(0, 0)) // communication error
    (5, 5, SubList(209, 23), SubList(0, 0)) // device profile-specific
    (7, 7, SubList(232, 21), SubList(0, 0)) // manufacturer-specific
    (0, 15, SubList(463, 10), SubList(0, 0)) // error code
    (16, 31, SubList(21, 22), SubList(0, 0)) // additional information
    (0, 28, SubList(622, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(628, 5), SubList(0, 2)) // frame
    (30, 30, SubList(667, 8), SubList(2, 2)) // producer
    (0, 0, SubList(1405, 17), SubList(0, 0)) // stores on command
    (1, 1, SubList(1422, 16), SubList(0, 0)) // stores by itself
    (0, 0, SubList(1690, 28), SubList(0, 0)) // restores defaults on command
    (0, 28, SubList(622, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(628, 5), SubList(0, 2)) // frame
    (30, 30, SubList(667, 8), SubList(4, 2)) // producer
    (31, 31, SubList(2026, 8), SubList(6, 2)) // consumer
    (0, 28, SubList(622, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(628, 5), SubList(0, 2)) // frame
    (31, 31, SubList(2249, 8), SubList(8, 2)) // validity
    (0, 15, SubList(2418, 20), SubList(0, 0)) // heartbeat time in ms
    (16, 23, SubList(2438, 7), SubList(0, 0)) // node-ID
    (0, 15, SubList(2686, 14), SubList(0, 0)) // minor revision
    (16, 31, SubList(2700, 14), SubList(0, 0)) // major revision
    (0, 7, SubList(3877, 8), SubList(10, 3)) // reaction
    (0, 28, SubList(622, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(628, 5), SubList(0, 2)) // frame
    (30, 30, SubList(4109, 10), SubList(13, 2)) // assignment
    (31, 31, SubList(2249, 8), SubList(8, 2)) // validity
    (0, 7, SubList(4529, 17), SubList(15, 3)) // transmission type
    (0, 7, SubList(4875, 14), SubList(0, 0)) // length in bits
    (8, 15, SubList(4889, 9), SubList(0, 0)) // sub-index
    (16, 31, SubList(4898, 5), SubList(0, 0)) // index
    (0, 28, SubList(622, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(628, 5), SubList(0, 2)) // frame
    (30, 30, SubList(5024, 13), SubList(18, 2)) // remote frames
    (31, 31, SubList(2249, 8), SubList(8, 2)) // validity
    (0, 7, SubList(4529, 17), SubList(20, 6)) // transmission type
    (0, 7, SubList(4889, 9), SubList(0, 0)) // sub-index
    (8, 23, SubList(4898, 5), SubList(0, 0)) // index
    (24, 31, SubList(5370, 21), SubList(0, 0)) // number of sub-indexes
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, SubList(633, 17)) // CAN-ID of 11 bits
    (1, 1, SubList(650, 17)) // CAN-ID of 29 bits
    (0, 0, SubList(675, 21)) // does not produce SYNC
    (1, 1, SubList(696, 13)) // produces SYNC
    (0, 0, SubList(1992, 21)) // does not produce TIME
    (1, 1, SubList(2013, 13)) // produces TIME
    (0, 0, SubList(2034, 21)) // does not consume TIME
    (1, 1, SubList(2055, 13)) // consumes TIME
    (0, 0, SubList(2257, 5)) // valid
    (1, 1, SubList(2262, 9)) // not valid
    (0, 0, SubList(3885, 33)) // pre-operational, from operational
    (1, 1, SubList(3918, 9)) // no change
    (2, 2, SubList(3927, 7)) // stopped
    (0, 0, SubList(4119, 6)) // static
    (1, 1, SubList(4125, 7)) // dynamic
    (0, 240, SubList(4546, 38)) // synchronous: counts with the next SYNC
    (254, 254, SubList(4584, 35)) // event-driven, as the vendor defines
    (255, 255, SubList(4619, 43)) // event-driven, as the device profile defines
    (0, 0, SubList(5037, 7)) // allowed
    (1, 1, SubList(5044, 11)) // not allowed
    (0, 0, SubList(5074, 27)) // synchronous, after an event
    (1, 240, SubList(5101, 27)) // synchronous, every nth SYNC
    (252, 252, SubList(5128, 27)) // on request, sampled at SYNC
    (253, 253, SubList(5155, 10)) // on request
    (254, 254, SubList(4584, 35)) // event-driven, as the vendor defines
    (255, 255, SubList(4619, 43)) // event-driven, as the device profile defines
);

static COMMANDS: &[CommandRow] = &[];

static TRANSITIONS: &[TransitionRow] = &[];

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

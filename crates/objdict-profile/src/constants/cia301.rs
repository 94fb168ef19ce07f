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
    (4099, 4099, SubList(482, 23), SubList(1, 2), Optional, None, SubList(0, 0), SubList(3, 2), SubList(0, 0), SubList(505, 106), High) // 1003h Pre-defined error field
    (4101, 4101, SubList(698, 19), SubList(0, 1), Optional, None, SubList(0, 0), SubList(5, 1), SubList(0, 0), SubList(717, 55), High) // 1005h COB-ID SYNC message
    (4102, 4102, SubList(775, 26), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(801, 62), High) // 1006h Communication cycle period
    (4103, 4103, SubList(863, 25), SubList(0, 1), Optional, None, SubList(0, 0), SubList(6, 1), SubList(0, 0), SubList(888, 73), High) // 1007h Synchronous window length
    (4104, 4104, SubList(961, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(985, 46), High) // 1008h Manufacturer device name
    (4105, 4105, SubList(1031, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(1060, 28), High) // 1009h Manufacturer hardware version
    (4106, 4106, SubList(1088, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(7, 1), SubList(0, 0), SubList(1117, 28), High) // 100Ah Manufacturer software version
    (4108, 4108, SubList(1147, 10), SubList(0, 1), Optional, None, SubList(0, 0), SubList(8, 1), SubList(0, 0), SubList(1157, 103), High) // 100Ch Guard time
    (4109, 4109, SubList(1260, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(9, 1), SubList(0, 0), SubList(1276, 118), High) // 100Dh Life time factor
    (4112, 4112, SubList(1565, 16), SubList(1, 2), Optional, None, SubList(0, 0), SubList(10, 5), SubList(0, 0), SubList(1581, 125), High) // 1010h Store parameters
    (4113, 4113, SubList(1889, 26), SubList(1, 2), Optional, None, SubList(0, 0), SubList(15, 5), SubList(0, 0), SubList(1915, 93), High) // 1011h Restore default parameters
    (4114, 4114, SubList(2084, 24), SubList(0, 1), Optional, None, SubList(0, 0), SubList(20, 1), SubList(0, 0), SubList(2108, 67), High) // 1012h COB-ID time stamp object
    (4115, 4115, SubList(2175, 26), SubList(0, 1), Optional, None, SubList(0, 0), SubList(21, 1), SubList(0, 0), SubList(2201, 64), High) // 1013h High resolution time stamp
    (4116, 4116, SubList(2287, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(22, 1), SubList(0, 0), SubList(2298, 54), High) // 1014h COB-ID EMCY
    (4117, 4117, SubList(2359, 17), SubList(0, 1), Optional, None, SubList(0, 0), SubList(23, 1), SubList(0, 0), SubList(2376, 58), High) // 1015h Inhibit time EMCY
    (4118, 4118, SubList(2461, 23), SubList(1, 2), Optional, None, SubList(0, 0), SubList(24, 3), SubList(0, 0), SubList(2484, 98), High) // 1016h Consumer heartbeat time
    (4119, 4119, SubList(2582, 23), SubList(0, 1), Optional, None, SubList(0, 0), SubList(8, 1), SubList(0, 0), SubList(2605, 76), High) // 1017h Producer heartbeat time
    (4120, 4120, SubList(2758, 15), SubList(3, 2), Mandatory, None, SubList(0, 0), SubList(27, 5), SubList(0, 0), SubList(2773, 103), High) // 1018h Identity object
    (4121, 4121, SubList(2876, 34), SubList(0, 1), Optional, None, SubList(0, 0), SubList(9, 1), SubList(0, 0), SubList(2910, 93), High) // 1019h Synchronous counter overflow value
    (4128, 4128, SubList(3039, 20), SubList(1, 2), Optional, None, SubList(0, 0), SubList(32, 3), SubList(0, 0), SubList(3059, 110), High) // 1020h Verify configuration
    (4129, 4129, SubList(3169, 9), SubList(5, 1), Optional, None, SubList(0, 0), SubList(35, 1), SubList(0, 0), SubList(3178, 51), High) // 1021h Store EDS
    (4130, 4130, SubList(3229, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(36, 1), SubList(0, 0), SubList(3241, 31), High) // 1022h Store format
    (4131, 4131, SubList(3290, 10), SubList(6, 1), Optional, None, SubList(0, 0), SubList(37, 4), SubList(0, 0), SubList(3300, 82), High) // 1023h OS command
    (4132, 4132, SubList(3382, 15), SubList(0, 1), Optional, None, SubList(0, 0), SubList(41, 1), SubList(0, 0), SubList(3397, 72), High) // 1024h OS command mode
    (4133, 4133, SubList(3469, 21), SubList(6, 1), Optional, None, SubList(0, 0), SubList(37, 4), SubList(0, 0), SubList(3490, 79), High) // 1025h OS debugger interface
    (4134, 4134, SubList(3586, 9), SubList(1, 2), Optional, None, SubList(0, 0), SubList(42, 4), SubList(0, 0), SubList(3595, 77), High) // 1026h OS prompt
    (4135, 4135, SubList(3705, 11), SubList(1, 2), Optional, None, SubList(0, 0), SubList(46, 2), SubList(0, 0), SubList(3716, 57), High) // 1027h Module list
    (4136, 4136, SubList(3791, 25), SubList(1, 2), Optional, None, SubList(0, 0), SubList(48, 2), SubList(0, 0), SubList(3816, 104), High) // 1028h Emergency consumer object
    (4137, 4137, SubList(4035, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(50, 3), SubList(0, 0), SubList(4056, 96), High) // 1029h Error behavior object
    (4608, 4608, SubList(4246, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(53, 4), SubList(0, 0), SubList(4266, 86), High) // 1200h SDO server parameter
    (4609, 4735, SubList(4246, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(57, 4), SubList(0, 0), SubList(4352, 66), High) // 1201h SDO server parameter
    (4736, 4863, SubList(4443, 20), SubList(3, 2), Optional, None, SubList(0, 0), SubList(61, 4), SubList(0, 0), SubList(4463, 90), High) // 1280h SDO client parameter
    (5120, 5631, SubList(4769, 28), SubList(6, 1), Optional, None, SubList(0, 0), SubList(65, 7), SubList(0, 0), SubList(4797, 77), High) // 1400h RPDO communication parameter
    (5632, 6143, SubList(4964, 22), SubList(3, 2), Optional, None, SubList(0, 0), SubList(72, 2), SubList(0, 0), SubList(4986, 81), High) // 1600h RPDO mapping parameter
    (6144, 6655, SubList(5208, 28), SubList(6, 1), Optional, None, SubList(0, 0), SubList(74, 7), SubList(0, 0), SubList(5236, 52), High) // 1800h TPDO communication parameter
    (6656, 7167, SubList(5332, 22), SubList(3, 2), Optional, None, SubList(0, 0), SubList(81, 2), SubList(0, 0), SubList(5354, 59), High) // 1A00h TPDO mapping parameter
    (8096, 8143, SubList(5438, 19), SubList(1, 2), Optional, None, SubList(0, 0), SubList(83, 2), SubList(0, 0), SubList(5457, 74), High) // 1FA0h Object scanner list
    (8144, 8191, SubList(5539, 23), SubList(1, 2), Optional, None, SubList(0, 0), SubList(85, 2), SubList(0, 0), SubList(5562, 83), High) // 1FD0h Object dispatching list
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 2))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(2, 7))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(436, 16), SubList(1, 1), SubList(1, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Number of errors
    (1, 254, Some(No), Optional, SubList(462, 20), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(9, 2)) // Standard error field
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(11, 3))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(772, 3), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(3, 1), SubList(2, 2), SubList(0, 0), None, SubList(1145, 2), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1454, 19), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save all parameters
    (2, 2, Some(No), Optional, SubList(1473, 29), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save communication parameters
    (3, 3, Some(No), Optional, SubList(1502, 27), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save application parameters
    (4, 127, Some(No), Optional, SubList(1529, 36), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(14, 2)) // Save manufacturer-defined parameters
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1734, 30), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore all default parameters
    (2, 2, Some(No), Optional, SubList(1764, 40), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore communication default parameters
    (3, 3, Some(No), Optional, SubList(1804, 38), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore application default parameters
    (4, 127, Some(No), Optional, SubList(1842, 47), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(16, 1)) // Restore manufacturer-defined default parameters
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(17, 4))
    (0, 0, Some(Any), Mandatory, SubList(0, 0), SubList(0, 1), SubList(4, 3), SubList(0, 0), None, SubList(772, 3), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(21, 3))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(3, 1), SubList(1, 1), SubList(0, 0), None, SubList(2352, 7), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2461, 23), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(24, 2)) // Consumer heartbeat time
    (2, 127, Some(No), Optional, SubList(2461, 23), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(24, 2)) // Consumer heartbeat time
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2681, 9), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Vendor-ID
    (2, 2, Some(No), Optional, SubList(2690, 12), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Product code
    (3, 3, Some(No), Optional, SubList(2730, 15), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(26, 2)) // Revision number
    (4, 4, Some(No), Optional, SubList(2745, 13), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Serial number
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3003, 18), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Configuration date
    (2, 2, Some(No), Mandatory, SubList(3021, 18), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Configuration time
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(5, 2), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(4, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3272, 7), SubList(7, 1), SubList(7, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Command
    (2, 2, Some(No), Mandatory, SubList(3279, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Status
    (3, 3, Some(No), Mandatory, SubList(3285, 5), SubList(7, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Reply
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(9, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(3569, 5), SubList(1, 1), SubList(9, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // StdIn
    (2, 2, Some(Any), Mandatory, SubList(3574, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // StdOut
    (3, 3, Some(Any), Optional, SubList(3580, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // StdErr
    (0, 0, Some(No), Mandatory, SubList(3672, 27), SubList(1, 1), SubList(0, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Number of connected modules
    (1, 254, Some(No), Optional, SubList(3699, 6), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Module
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Optional, SubList(3773, 18), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(21, 3)) // Emergency consumer
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3977, 19), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(28, 1)) // Communication error
    (2, 254, Some(No), Optional, SubList(3996, 39), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(28, 1)) // Profile- or manufacturer-specific error
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(4175, 23), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID client to server
    (2, 2, Some(Any), Mandatory, SubList(4198, 23), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID server to client
    (3, 3, Some(No), Optional, SubList(4221, 25), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Node-ID of the SDO client
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(4175, 23), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID client to server
    (2, 2, Some(Any), Mandatory, SubList(4198, 23), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID server to client
    (3, 3, Some(No), Optional, SubList(4221, 25), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Node-ID of the SDO client
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(4, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(4175, 23), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID client to server
    (2, 2, Some(Any), Mandatory, SubList(4198, 23), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(29, 4)) // COB-ID server to client
    (3, 3, Some(No), Mandatory, SubList(4418, 25), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Node-ID of the SDO server
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(7, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4553, 19), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(21, 3)) // COB-ID used by RPDO
    (2, 2, Some(No), Mandatory, SubList(4705, 17), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(33, 1)) // Transmission type
    (3, 3, Some(No), Optional, SubList(4722, 12), SubList(3, 1), SubList(2, 2), SubList(0, 0), None, SubList(2352, 7), SubList(0, 0)) // Inhibit time
    (4, 4, Some(No), Optional, SubList(4734, 8), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Reserved
    (5, 5, Some(No), Optional, SubList(4742, 11), SubList(3, 1), SubList(2, 2), SubList(0, 0), None, SubList(1145, 2), SubList(0, 0)) // Event timer
    (6, 6, Some(No), Optional, SubList(4753, 16), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // SYNC start value
    (0, 0, Some(No), Mandatory, SubList(4874, 44), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Number of mapped application objects in RPDO
    (1, 64, Some(No), Optional, SubList(4946, 18), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(34, 3)) // Application object
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(7, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(5098, 19), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(37, 4)) // COB-ID used by TPDO
    (2, 2, Some(No), Mandatory, SubList(4705, 17), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(41, 1)) // Transmission type
    (3, 3, Some(No), Optional, SubList(4722, 12), SubList(3, 1), SubList(2, 2), SubList(0, 0), None, SubList(2352, 7), SubList(0, 0)) // Inhibit time
    (4, 4, Some(No), Optional, SubList(4734, 8), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Reserved
    (5, 5, Some(No), Optional, SubList(4742, 11), SubList(3, 1), SubList(2, 2), SubList(0, 0), None, SubList(1145, 2), SubList(0, 0)) // Event timer
    (6, 6, Some(No), Optional, SubList(4753, 16), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // SYNC start value
    (0, 0, Some(No), Mandatory, SubList(5288, 44), SubList(1, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Number of mapped application objects in TPDO
    (1, 64, Some(No), Optional, SubList(4946, 18), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(34, 3)) // Application object
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 254, Some(No), Optional, SubList(5434, 4), SubList(0, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(42, 3)) // Scan
    (0, 0, Some(No), Mandatory, SubList(1394, 27), SubList(1, 1), SubList(0, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 254, Some(No), Optional, SubList(5531, 8), SubList(8, 1), SubList(2, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Dispatch
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
    (0, 15, SubList(452, 10), SubList(0, 0)) // error code
    (16, 31, SubList(21, 22), SubList(0, 0)) // additional information
    (0, 28, SubList(611, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(617, 5), SubList(0, 2)) // frame
    (30, 30, SubList(656, 8), SubList(2, 2)) // producer
    (0, 0, SubList(1421, 17), SubList(0, 0)) // stores on command
    (1, 1, SubList(1438, 16), SubList(0, 0)) // stores by itself
    (0, 0, SubList(1706, 28), SubList(0, 0)) // restores defaults on command
    (0, 28, SubList(611, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(617, 5), SubList(0, 2)) // frame
    (30, 30, SubList(656, 8), SubList(4, 2)) // producer
    (31, 31, SubList(2042, 8), SubList(6, 2)) // consumer
    (0, 28, SubList(611, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(617, 5), SubList(0, 2)) // frame
    (31, 31, SubList(2265, 8), SubList(8, 2)) // validity
    (0, 15, SubList(2434, 20), SubList(0, 0)) // heartbeat time in ms
    (16, 23, SubList(2454, 7), SubList(0, 0)) // node-ID
    (0, 15, SubList(2702, 14), SubList(0, 0)) // minor revision
    (16, 31, SubList(2716, 14), SubList(0, 0)) // major revision
    (0, 7, SubList(3920, 8), SubList(10, 3)) // reaction
    (0, 28, SubList(611, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(617, 5), SubList(0, 2)) // frame
    (30, 30, SubList(4152, 10), SubList(13, 2)) // assignment
    (31, 31, SubList(2265, 8), SubList(8, 2)) // validity
    (0, 7, SubList(4572, 17), SubList(15, 3)) // transmission type
    (0, 7, SubList(4918, 14), SubList(0, 0)) // length in bits
    (8, 15, SubList(4932, 9), SubList(0, 0)) // sub-index
    (16, 31, SubList(4941, 5), SubList(0, 0)) // index
    (0, 28, SubList(611, 6), SubList(0, 0)) // CAN-ID
    (29, 29, SubList(617, 5), SubList(0, 2)) // frame
    (30, 30, SubList(5067, 13), SubList(18, 2)) // remote frames
    (31, 31, SubList(2265, 8), SubList(8, 2)) // validity
    (0, 7, SubList(4572, 17), SubList(20, 6)) // transmission type
    (0, 7, SubList(4932, 9), SubList(0, 0)) // sub-index
    (8, 23, SubList(4941, 5), SubList(0, 0)) // index
    (24, 31, SubList(5413, 21), SubList(0, 0)) // number of sub-indexes
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, SubList(622, 17)) // CAN-ID of 11 bits
    (1, 1, SubList(639, 17)) // CAN-ID of 29 bits
    (0, 0, SubList(664, 21)) // does not produce SYNC
    (1, 1, SubList(685, 13)) // produces SYNC
    (0, 0, SubList(2008, 21)) // does not produce TIME
    (1, 1, SubList(2029, 13)) // produces TIME
    (0, 0, SubList(2050, 21)) // does not consume TIME
    (1, 1, SubList(2071, 13)) // consumes TIME
    (0, 0, SubList(2273, 5)) // valid
    (1, 1, SubList(2278, 9)) // not valid
    (0, 0, SubList(3928, 33)) // pre-operational, from operational
    (1, 1, SubList(3961, 9)) // no change
    (2, 2, SubList(3970, 7)) // stopped
    (0, 0, SubList(4162, 6)) // static
    (1, 1, SubList(4168, 7)) // dynamic
    (0, 240, SubList(4589, 38)) // synchronous: counts with the next SYNC
    (254, 254, SubList(4627, 35)) // event-driven, as the vendor defines
    (255, 255, SubList(4662, 43)) // event-driven, as the device profile defines
    (0, 0, SubList(5080, 7)) // allowed
    (1, 1, SubList(5087, 11)) // not allowed
    (0, 0, SubList(5117, 27)) // synchronous, after an event
    (1, 240, SubList(5144, 27)) // synchronous, every nth SYNC
    (252, 252, SubList(5171, 27)) // on request, sampled at SYNC
    (253, 253, SubList(5198, 10)) // on request
    (254, 254, SubList(4627, 35)) // event-driven, as the vendor defines
    (255, 255, SubList(4662, 43)) // event-driven, as the device profile defines
);

static COMMANDS: &[CommandRow] = &[];

static TRANSITIONS: &[TransitionRow] = &[];

static CONDITIONS: &[Condition] = &[
];

static OBJECT_TYPES: &[ObjectType] = &[Var, Array, Record, Record, Array, Domain, Record];

static DATA_TYPES: &[DataType] = &[DataType(7), DataType(5), DataType(9), DataType(6), DataType(15), DataType(5), DataType(6), DataType(10), DataType(27)];

static ACCESS: &[Access] = &[Ro, Rw, Rw, Const, Rw, Ro, Wo, Rw, Wo, Wo];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[0..=254, 1..=127, 1..=4, 2..=2, 3..=3, 2..=3, 1..=254, 2..=6];

static DEFAULTS: &[Value] = &[];

static INDEXES: &[u16] = &[];

static TEXTS: &str = concat!(
    "device profile number", "additional information", "Device type",
    "Says which device profile the device follows (low word) and what of it the device has (high word).",
    "generic error", "current", "voltage", "temperature", "communication error", "device profile-specific",
    "manufacturer-specific", "Error register",
    "Sums up the errors that are present now, one bit per error class; every EMCY message carries it.",
    "Manufacturer status register", "Status bits whose meaning the vendor defines.", "Number of errors",
    "error code", "Standard error field", "Pre-defined error field",
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
    "Highest sub-index supported", "stores on command", "stores by itself", "Save all parameters",
    "Save communication parameters", "Save application parameters", "Save manufacturer-defined parameters",
    "Store parameters",
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
    "Number of connected modules", "Module", "Module list",
    "Lists the modules that are plugged into a modular device.", "Emergency consumer",
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

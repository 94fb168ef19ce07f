// Generated from `data/cia406.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Confidence::*, Mapping::*, Profile};

pub(super) static PROFILE: Profile = Profile {
    group: "cia406",
    document: Cow::Borrowed("CiA 406"),
    title: Cow::Borrowed("encoders"),
    version: Some(Cow::Borrowed("3.2")),
    number: Some(406),
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

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4096, 4096, Part(253, 11), Part(0, 0), Optional, None, Part(0, 0), Part(0, 1), Part(264, 12), Part(276, 54), High) // 1000h Device type
    (6144, 6144, Part(330, 30), Part(0, 0), Mandatory, None, Part(0, 0), Part(0, 0), Part(360, 12), Part(372, 92), High) // 1800h TPDO 1 communication parameter
    (6145, 6145, Part(464, 30), Part(0, 0), When(0), None, Part(0, 0), Part(0, 0), Part(494, 43), Part(537, 67), High) // 1801h TPDO 2 communication parameter
    (6656, 6656, Part(604, 24), Part(0, 0), Mandatory, None, Part(0, 0), Part(0, 0), Part(360, 12), Part(628, 41), High) // 1A00h TPDO 1 mapping parameter
    (6657, 6657, Part(669, 24), Part(0, 0), When(1), None, Part(0, 0), Part(0, 0), Part(494, 43), Part(693, 42), High) // 1A01h TPDO 2 mapping parameter
    (24576, 24576, Part(868, 20), Part(0, 1), Mandatory, None, Part(0, 0), Part(1, 1), Part(888, 13), Part(901, 77), High) // 6000h Operating parameters
    (24577, 24577, Part(978, 30), Part(0, 1), Optional, Some(2), Part(0, 0), Part(2, 1), Part(1008, 7), Part(1015, 66), High) // 6001h Measuring units per revolution
    (24578, 24578, Part(1081, 40), Part(0, 1), Optional, None, Part(0, 0), Part(2, 1), Part(1008, 7), Part(1121, 65), High) // 6002h Total measuring range in measuring units
    (24579, 24579, Part(1186, 12), Part(0, 1), Optional, None, Part(0, 0), Part(3, 1), Part(1008, 7), Part(1198, 84), High) // 6003h Preset value
    (24580, 24580, Part(1282, 14), Part(0, 1), When(3), None, Part(0, 0), Part(4, 1), Part(888, 13), Part(1296, 39), High) // 6004h Position value
    (24581, 24581, Part(1451, 38), Part(1, 2), Optional, Some(4), Part(0, 0), Part(5, 5), Part(1489, 18), Part(1507, 86), High) // 6005h Linear encoder measuring step settings
    (24584, 24584, Part(1593, 29), Part(0, 1), Optional, None, Part(0, 0), Part(10, 1), Part(1622, 9), Part(1631, 32), Medium) // 6008h High precision position value
    (24585, 24585, Part(1663, 27), Part(0, 1), Optional, None, Part(0, 0), Part(11, 1), Part(1622, 9), Part(1690, 46), Medium) // 6009h High precision preset value
    (24592, 24592, Part(1736, 38), Part(1, 2), Optional, None, Part(0, 1), Part(12, 3), Part(1008, 7), Part(1774, 60), Medium) // 6010h Preset values for multi-sensor devices
    (24608, 24608, Part(1834, 40), Part(1, 2), When(5), None, Part(0, 0), Part(15, 3), Part(1008, 7), Part(1874, 62), Medium) // 6020h Position values for multi-sensor devices
    (24624, 24624, Part(1936, 11), Part(1, 2), Optional, None, Part(0, 0), Part(18, 3), Part(1622, 9), Part(1947, 26), Medium) // 6030h Speed value
    (24640, 24640, Part(1973, 18), Part(1, 2), Optional, None, Part(0, 0), Part(21, 3), Part(1622, 9), Part(1991, 33), Medium) // 6040h Acceleration value
    (24656, 24656, Part(2024, 10), Part(1, 2), Optional, None, Part(0, 0), Part(24, 3), Part(1622, 9), Part(2034, 25), Medium) // 6050h Jerk value
    (25088, 25088, Part(2061, 12), Part(0, 1), Optional, None, Part(0, 0), Part(27, 1), Part(888, 13), Part(2073, 108), High) // 6200h Cyclic timer
    (25344, 25344, Part(2181, 18), Part(1, 2), Optional, None, Part(0, 0), Part(28, 3), Part(1622, 9), Part(2199, 65), Medium) // 6300h CAM state register
    (25345, 25345, Part(2264, 19), Part(1, 2), Optional, None, Part(1, 1), Part(31, 3), Part(1622, 9), Part(2283, 32), Medium) // 6301h CAM enable register
    (25346, 25346, Part(2315, 21), Part(1, 2), Optional, None, Part(1, 1), Part(34, 3), Part(1622, 9), Part(2336, 41), Medium) // 6302h CAM polarity register
    (25360, 25367, Part(2377, 13), Part(1, 2), Optional, None, Part(0, 0), Part(37, 3), Part(1622, 9), Part(2390, 60), Medium) // 6310h CAM low limit
    (25376, 25383, Part(2450, 14), Part(1, 2), Optional, None, Part(0, 0), Part(40, 3), Part(1622, 9), Part(2464, 58), Medium) // 6320h CAM high limit
    (25392, 25399, Part(2522, 14), Part(1, 2), Optional, None, Part(0, 0), Part(43, 3), Part(1622, 9), Part(2536, 97), Medium) // 6330h CAM hysteresis
    (25600, 25600, Part(2633, 19), Part(1, 2), Optional, None, Part(0, 0), Part(46, 3), Part(1622, 9), Part(2652, 75), Medium) // 6400h Area state register
    (25601, 25601, Part(2727, 19), Part(1, 2), Optional, None, Part(2, 1), Part(49, 3), Part(1622, 9), Part(2746, 37), Medium) // 6401h Work area low limit
    (25602, 25602, Part(2783, 20), Part(1, 2), Optional, None, Part(2, 1), Part(52, 3), Part(1622, 9), Part(2803, 38), Medium) // 6402h Work area high limit
    (25856, 25856, Part(2841, 16), Part(0, 1), Mandatory, None, Part(0, 0), Part(55, 1), Part(888, 13), Part(2857, 52), High) // 6500h Operating status
    (25857, 25857, Part(2909, 41), Part(0, 1), Mandatory, None, Part(0, 0), Part(56, 1), Part(888, 13), Part(2950, 70), High) // 6501h Single-turn resolution and measuring step
    (25858, 25858, Part(3020, 37), Part(0, 1), When(6), Some(2), Part(0, 0), Part(57, 1), Part(888, 13), Part(3057, 49), High) // 6502h Number of distinguishable revolutions
    (25859, 25859, Part(3145, 6), Part(0, 1), Optional, None, Part(0, 0), Part(58, 1), Part(1008, 7), Part(3151, 61), High) // 6503h Alarms
    (25860, 25860, Part(3212, 16), Part(0, 1), Optional, None, Part(0, 0), Part(59, 1), Part(1008, 7), Part(3228, 54), High) // 6504h Supported alarms
    (25861, 25861, Part(3394, 8), Part(0, 1), Optional, None, Part(0, 0), Part(60, 1), Part(1008, 7), Part(3402, 81), High) // 6505h Warnings
    (25862, 25862, Part(3483, 18), Part(0, 1), Optional, None, Part(0, 0), Part(61, 1), Part(1008, 7), Part(3501, 56), High) // 6506h Supported warnings
    (25863, 25863, Part(3602, 28), Part(0, 1), Optional, None, Part(0, 0), Part(62, 1), Part(1008, 7), Part(3630, 52), High) // 6507h Profile and software version
    (25864, 25864, Part(3687, 14), Part(0, 1), Optional, None, Part(0, 0), Part(63, 1), Part(1008, 7), Part(3701, 43), High) // 6508h Operating time
    (25865, 25865, Part(3744, 12), Part(0, 1), Optional, None, Part(0, 0), Part(64, 1), Part(1008, 7), Part(3756, 86), High) // 6509h Offset value
    (25866, 25866, Part(3937, 21), Part(1, 2), Optional, None, Part(0, 0), Part(65, 4), Part(1008, 7), Part(3958, 71), High) // 650Ah Module identification
    (25867, 25867, Part(4029, 13), Part(0, 1), Optional, None, Part(0, 0), Part(56, 1), Part(1008, 7), Part(4042, 47), High) // 650Bh Serial number
    (25868, 25868, Part(4089, 38), Part(1, 2), Optional, None, Part(0, 1), Part(69, 3), Part(1008, 7), Part(4127, 60), High) // 650Ch Offset values for multi-sensor devices
    (25872, 25872, Part(4187, 36), Part(0, 1), Optional, None, Part(0, 0), Part(72, 1), Part(1622, 9), Part(4223, 60), Medium) // 6510h Number of high precision revolutions
    (26623, 26623, Part(253, 11), Part(0, 1), Optional, None, Part(0, 0), Part(73, 1), Part(4283, 15), Part(4298, 70), High) // 67FFh Device type
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, None, Optional, Part(0, 0), Part(0, 0), Part(0, 0), Part(0, 0), None, Part(0, 0), Part(0, 2))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(2, 5))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(2, 2), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(2, 2), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(0, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(1362, 23), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Position measuring step
    (2, 2, Some(No), Optional, Part(1385, 20), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Speed measuring step
    (3, 3, Some(No), Optional, Part(1405, 27), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Acceleration measuring step
    (4, 4, Some(No), Optional, Part(1432, 19), Part(1, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Jerk measuring step
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(5, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(5, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(1736, 38), Part(6, 2), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Preset values for multi-sensor devices
    (2, 254, Some(No), Optional, Part(1736, 38), Part(6, 2), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Preset values for multi-sensor devices
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(1834, 40), Part(6, 2), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Position values for multi-sensor devices
    (2, 254, Some(Tpdo), Optional, Part(1834, 40), Part(6, 2), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Position values for multi-sensor devices
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(1936, 11), Part(8, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Speed value
    (2, 254, Some(Tpdo), Optional, Part(1936, 11), Part(8, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Speed value
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(1973, 18), Part(8, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Acceleration value
    (2, 254, Some(Tpdo), Optional, Part(1973, 18), Part(8, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Acceleration value
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(2024, 10), Part(8, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Jerk value
    (2, 254, Some(Tpdo), Optional, Part(2024, 10), Part(8, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Jerk value
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(2059, 2), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(2181, 18), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM state register
    (2, 254, Some(Tpdo), Optional, Part(2181, 18), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM state register
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, Part(2264, 19), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM enable register
    (2, 254, Some(Any), Optional, Part(2264, 19), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM enable register
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, Part(2315, 21), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM polarity register
    (2, 254, Some(Any), Optional, Part(2315, 21), Part(4, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM polarity register
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(2377, 13), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM low limit
    (2, 254, Some(No), Optional, Part(2377, 13), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM low limit
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(2450, 14), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM high limit
    (2, 254, Some(No), Optional, Part(2450, 14), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM high limit
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(2522, 14), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM hysteresis
    (2, 254, Some(No), Optional, Part(2522, 14), Part(0, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // CAM hysteresis
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, Part(2633, 19), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Area state register
    (2, 254, Some(Tpdo), Optional, Part(2633, 19), Part(4, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Area state register
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(2727, 19), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Work area low limit
    (2, 254, Some(No), Optional, Part(2727, 19), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Work area low limit
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(2783, 20), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Work area high limit
    (2, 254, Some(No), Optional, Part(2783, 20), Part(9, 1), Part(0, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Work area high limit
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(2, 5))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(7, 3))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(7, 3))
    (0, 0, Some(Tpdo), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(10, 7))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(0, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(10, 7))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(17, 2))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(3682, 5), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(9, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(2, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(3842, 25), Part(6, 2), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Manufacturer offset value
    (2, 2, Some(No), Optional, Part(3867, 35), Part(6, 2), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Manufacturer minimum position value
    (3, 3, Some(No), Optional, Part(3902, 35), Part(6, 2), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Manufacturer maximum position value
    (0, 0, Some(No), Mandatory, Part(1335, 27), Part(4, 1), Part(1, 1), Part(1, 1), None, Part(0, 0), Part(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, Part(4089, 38), Part(9, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Offset values for multi-sensor devices
    (2, 254, Some(No), Optional, Part(4089, 38), Part(9, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0)) // Offset values for multi-sensor devices
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(10, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 0))
    (0, 0, Some(No), Mandatory, Part(0, 0), Part(1, 1), Part(1, 1), Part(0, 0), None, Part(0, 0), Part(0, 2))
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (0, 15, Part(0, 21), Part(0, 0)) // device profile number
    (16, 31, Part(21, 4), Part(0, 10)) // type
    (0, 0, Part(735, 13), Part(10, 2)) // code sequence
    (1, 1, Part(774, 32), Part(0, 0)) // commissioning diagnostic control
    (2, 2, Part(806, 24), Part(0, 0)) // scaling function control
    (3, 3, Part(830, 19), Part(0, 0)) // measuring direction
    (12, 15, Part(849, 19), Part(0, 0)) // of the manufacturer
    (0, 0, Part(3106, 14), Part(0, 0)) // position error
    (1, 1, Part(3120, 25), Part(0, 0)) // commissioning diagnostics
    (12, 15, Part(849, 19), Part(0, 0)) // of the manufacturer
    (0, 0, Part(3282, 18), Part(0, 0)) // frequency exceeded
    (1, 1, Part(3300, 21), Part(0, 0)) // light control reserve
    (2, 2, Part(3321, 12), Part(0, 0)) // CPU watchdog
    (3, 3, Part(3333, 20), Part(0, 0)) // operating time limit
    (4, 4, Part(3353, 14), Part(0, 0)) // battery charge
    (5, 5, Part(3367, 27), Part(0, 0)) // reference point not reached
    (12, 15, Part(849, 19), Part(0, 0)) // of the manufacturer
    (0, 15, Part(3557, 22), Part(0, 0)) // version of the profile
    (16, 31, Part(3579, 23), Part(0, 0)) // version of the software
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (1, 1, Part(25, 18)) // single-turn rotary
    (2, 2, Part(43, 17)) // multi-turn rotary
    (3, 3, Part(60, 31)) // single-turn rotary with counter
    (4, 4, Part(91, 18)) // incremental rotary
    (5, 5, Part(109, 31)) // incremental rotary with counter
    (6, 6, Part(140, 18)) // incremental linear
    (7, 7, Part(158, 31)) // incremental linear with counter
    (8, 8, Part(189, 15)) // absolute linear
    (9, 9, Part(204, 34)) // absolute linear with cyclic coding
    (10, 10, Part(238, 15)) // several sensors
    (0, 0, Part(748, 9)) // clockwise
    (1, 1, Part(757, 17)) // counter-clockwise
);

static COMMANDS: &[CommandRow] = &[];

static TRANSITIONS: &[TransitionRow] = &[];

static CONDITIONS: &[Condition] = &[
    Condition::constant("not 1802h", &[Not, Described(6146, None)]),
    Condition::constant("not 1A02h", &[Not, Described(6658, None)]),
    Condition::constant("not 1000h[16..31] in 6..9", &[Not, BitsIn(4096, 0, [16, 31], 1), Range(6, 9)]),
    Condition::constant("1000h[16..31] in 1..9", &[BitsIn(4096, 0, [16, 31], 1), Range(1, 9)]),
    Condition::constant("not 1000h[16..31] in 1..5", &[Not, BitsIn(4096, 0, [16, 31], 1), Range(1, 5)]),
    Condition::constant("1000h[16..31] = 10", &[BitsIn(4096, 0, [16, 31], 1), Range(10, 10)]),
    Condition::constant("1000h[16..31] in 1..5", &[BitsIn(4096, 0, [16, 31], 1), Range(1, 5)]),
];

static OBJECT_TYPES: &[ObjectType] = &[Var, Array, Record];

static DATA_TYPES: &[DataType] = &[DataType(6), DataType(7), DataType(7), DataType(4), DataType(5), DataType(27), DataType(4), DataType(7), DataType(3), DataType(4), DataType(24)];

static ACCESS: &[Access] = &[Rw, Ro];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[1..=4, 1..=254, 1..=3];

static DEFAULTS: &[Value] = &[];

static INDEXES: &[u16] = &[24608, 25344, 25600];

static TEXTS: &str = concat!(
    "device profile number", "type", "single-turn rotary", "multi-turn rotary",
    "single-turn rotary with counter", "incremental rotary", "incremental rotary with counter",
    "incremental linear", "incremental linear with counter", "absolute linear",
    "absolute linear with cyclic coding", "several sensors", "Device type", "book 3.3.2.1",
    "Says that the device is an encoder, and of which type.", "TPDO 1 communication parameter", "book 3.3.2.2",
    "When the first PDO is sent, which carries the position at the intervals of the cyclic timer.",
    "TPDO 2 communication parameter", "book 3.3.2.3; until edition 2 it was TPDO 3",
    "When the second PDO is sent, which carries the position after SYNC.", "TPDO 1 mapping parameter",
    "What the first PDO carries: the position.", "TPDO 2 mapping parameter",
    "What the second PDO carries: the position.", "code sequence", "clockwise", "counter-clockwise",
    "commissioning diagnostic control", "scaling function control", "measuring direction", "of the manufacturer",
    "Operating parameters", "book; manuals",
    "Selects the counting direction, scaling and further functions of the encoder.",
    "Measuring units per revolution", "manuals",
    "How many steps one revolution is divided into, once scaling is on.",
    "Total measuring range in measuring units",
    "How many steps the whole measuring range has, once scaling is on.", "Preset value",
    "The position that the encoder shows at the present shaft angle when this is written.", "Position value",
    "The position, after scaling and preset.", "Highest sub-index supported", "Position measuring step",
    "Speed measuring step", "Acceleration measuring step", "Jerk measuring step",
    "Linear encoder measuring step settings", "manuals; databases",
    "The step sizes in which a linear encoder gives position, speed, acceleration and jerk.",
    "High precision position value", "databases", "The position with up to 64 bits.",
    "High precision preset value", "The preset of the position with up to 64 bits.",
    "Preset values for multi-sensor devices", "The preset of each channel of a device with several sensors.",
    "Position values for multi-sensor devices", "The position of each channel of a device with several sensors.",
    "Speed value", "The speed of each channel.", "Acceleration value", "The acceleration of each channel.",
    "Jerk value", "The jerk of each channel.", "ms", "Cyclic timer",
    "The interval at which the position is sent in the first TPDO; the same as the event timer 1800h sub-index 5.",
    "CAM state register", "The state of the cams, one bit a cam and one sub-index a channel.",
    "CAM enable register", "Switches cams on, one bit a cam.", "CAM polarity register",
    "Inverts the state of cams, one bit a cam.", "CAM low limit",
    "The position at which a cam begins, one sub-index a channel.", "CAM high limit",
    "The position at which a cam ends, one sub-index a channel.", "CAM hysteresis",
    "The distance by which the position must leave a switching point of a cam before it switches back.",
    "Area state register", "Says whether the position is inside the work area, one sub-index a channel.",
    "Work area low limit", "The lowest position of the work area.", "Work area high limit",
    "The highest position of the work area.", "Operating status",
    "The operating parameters (6000h) that are in effect.", "Single-turn resolution and measuring step",
    "The physical steps of one revolution, or the step of a linear encoder.",
    "Number of distinguishable revolutions", "How many revolutions the encoder can distinguish.",
    "position error", "commissioning diagnostics", "Alarms",
    "Malfunctions that make the position unreliable, one bit each.", "Supported alarms",
    "Which bits of the alarms (6503h) the encoder supports.", "frequency exceeded", "light control reserve",
    "CPU watchdog", "operating time limit", "battery charge", "reference point not reached", "Warnings",
    "Deviations from normal operation while the position is still right, one bit each.", "Supported warnings",
    "Which bits of the warnings (6505h) the encoder supports.", "version of the profile",
    "version of the software", "Profile and software version",
    "The version of the profile and that of the software.", "0.1 h", "Operating time",
    "How long the encoder has been in operation.", "Offset value",
    "The offset between the physical position and the shown one, which the preset leads to.",
    "Manufacturer offset value", "Manufacturer minimum position value", "Manufacturer maximum position value",
    "Module identification", "The offset and the lowest and highest position that the vendor has set.",
    "Serial number", "The serial number, as 1018h sub-index 4 has it.", "Offset values for multi-sensor devices",
    "The offset of each channel of a device with several sensors.", "Number of high precision revolutions",
    "How many revolutions the encoder counts with high precision.", "CiA 301 §7.4.1",
    "The device type of this logical device: an encoder, and of which type.",
);

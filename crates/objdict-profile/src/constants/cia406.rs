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
        errors: SubList(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4096, 4096, SubList(253, 11), SubList(0, 0), Optional, None, SubList(0, 0), SubList(0, 1), SubList(264, 12), SubList(276, 54), High) // 1000h Device type
    (6144, 6144, SubList(330, 30), SubList(0, 0), Mandatory, None, SubList(0, 0), SubList(0, 0), SubList(360, 12), SubList(372, 92), High) // 1800h TPDO 1 communication parameter
    (6145, 6145, SubList(464, 30), SubList(0, 0), When(0), None, SubList(0, 0), SubList(0, 0), SubList(494, 43), SubList(537, 67), High) // 1801h TPDO 2 communication parameter
    (6656, 6656, SubList(604, 24), SubList(0, 0), Mandatory, None, SubList(0, 0), SubList(0, 0), SubList(360, 12), SubList(628, 41), High) // 1A00h TPDO 1 mapping parameter
    (6657, 6657, SubList(669, 24), SubList(0, 0), When(1), None, SubList(0, 0), SubList(0, 0), SubList(494, 43), SubList(693, 42), High) // 1A01h TPDO 2 mapping parameter
    (24576, 24576, SubList(868, 20), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(1, 1), SubList(888, 13), SubList(901, 77), High) // 6000h Operating parameters
    (24577, 24577, SubList(978, 30), SubList(0, 1), Optional, Some(2), SubList(0, 0), SubList(2, 1), SubList(1008, 7), SubList(1015, 66), High) // 6001h Measuring units per revolution
    (24578, 24578, SubList(1081, 40), SubList(0, 1), Optional, None, SubList(0, 0), SubList(2, 1), SubList(1008, 7), SubList(1121, 65), High) // 6002h Total measuring range in measuring units
    (24579, 24579, SubList(1186, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(3, 1), SubList(1008, 7), SubList(1198, 84), High) // 6003h Preset value
    (24580, 24580, SubList(1282, 14), SubList(0, 1), When(3), None, SubList(0, 0), SubList(4, 1), SubList(888, 13), SubList(1296, 39), High) // 6004h Position value
    (24581, 24581, SubList(1451, 38), SubList(1, 2), Optional, Some(4), SubList(0, 0), SubList(5, 5), SubList(1489, 18), SubList(1507, 86), High) // 6005h Linear encoder measuring step settings
    (24584, 24584, SubList(1593, 29), SubList(0, 1), Optional, None, SubList(0, 0), SubList(10, 1), SubList(1622, 9), SubList(1631, 32), Medium) // 6008h High precision position value
    (24585, 24585, SubList(1663, 27), SubList(0, 1), Optional, None, SubList(0, 0), SubList(11, 1), SubList(1622, 9), SubList(1690, 46), Medium) // 6009h High precision preset value
    (24592, 24592, SubList(1736, 38), SubList(1, 2), Optional, None, SubList(0, 1), SubList(12, 3), SubList(1008, 7), SubList(1774, 60), Medium) // 6010h Preset values for multi-sensor devices
    (24608, 24608, SubList(1834, 40), SubList(1, 2), When(5), None, SubList(0, 0), SubList(15, 3), SubList(1008, 7), SubList(1874, 62), Medium) // 6020h Position values for multi-sensor devices
    (24624, 24624, SubList(1936, 11), SubList(1, 2), Optional, None, SubList(0, 0), SubList(18, 3), SubList(1622, 9), SubList(1947, 26), Medium) // 6030h Speed value
    (24640, 24640, SubList(1973, 18), SubList(1, 2), Optional, None, SubList(0, 0), SubList(21, 3), SubList(1622, 9), SubList(1991, 33), Medium) // 6040h Acceleration value
    (24656, 24656, SubList(2024, 10), SubList(1, 2), Optional, None, SubList(0, 0), SubList(24, 3), SubList(1622, 9), SubList(2034, 25), Medium) // 6050h Jerk value
    (25088, 25088, SubList(2061, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(27, 1), SubList(888, 13), SubList(2073, 108), High) // 6200h Cyclic timer
    (25344, 25344, SubList(2181, 18), SubList(1, 2), Optional, None, SubList(0, 0), SubList(28, 3), SubList(1622, 9), SubList(2199, 65), Medium) // 6300h CAM state register
    (25345, 25345, SubList(2264, 19), SubList(1, 2), Optional, None, SubList(1, 1), SubList(31, 3), SubList(1622, 9), SubList(2283, 32), Medium) // 6301h CAM enable register
    (25346, 25346, SubList(2315, 21), SubList(1, 2), Optional, None, SubList(1, 1), SubList(34, 3), SubList(1622, 9), SubList(2336, 41), Medium) // 6302h CAM polarity register
    (25360, 25367, SubList(2377, 13), SubList(1, 2), Optional, None, SubList(0, 0), SubList(37, 3), SubList(1622, 9), SubList(2390, 60), Medium) // 6310h CAM low limit
    (25376, 25383, SubList(2450, 14), SubList(1, 2), Optional, None, SubList(0, 0), SubList(40, 3), SubList(1622, 9), SubList(2464, 58), Medium) // 6320h CAM high limit
    (25392, 25399, SubList(2522, 14), SubList(1, 2), Optional, None, SubList(0, 0), SubList(43, 3), SubList(1622, 9), SubList(2536, 97), Medium) // 6330h CAM hysteresis
    (25600, 25600, SubList(2633, 19), SubList(1, 2), Optional, None, SubList(0, 0), SubList(46, 3), SubList(1622, 9), SubList(2652, 75), Medium) // 6400h Area state register
    (25601, 25601, SubList(2727, 19), SubList(1, 2), Optional, None, SubList(2, 1), SubList(49, 3), SubList(1622, 9), SubList(2746, 37), Medium) // 6401h Work area low limit
    (25602, 25602, SubList(2783, 20), SubList(1, 2), Optional, None, SubList(2, 1), SubList(52, 3), SubList(1622, 9), SubList(2803, 38), Medium) // 6402h Work area high limit
    (25856, 25856, SubList(2841, 16), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(55, 1), SubList(888, 13), SubList(2857, 52), High) // 6500h Operating status
    (25857, 25857, SubList(2909, 41), SubList(0, 1), Mandatory, None, SubList(0, 0), SubList(56, 1), SubList(888, 13), SubList(2950, 70), High) // 6501h Single-turn resolution and measuring step
    (25858, 25858, SubList(3020, 37), SubList(0, 1), When(6), Some(2), SubList(0, 0), SubList(57, 1), SubList(888, 13), SubList(3057, 49), High) // 6502h Number of distinguishable revolutions
    (25859, 25859, SubList(3145, 6), SubList(0, 1), Optional, None, SubList(0, 0), SubList(58, 1), SubList(1008, 7), SubList(3151, 61), High) // 6503h Alarms
    (25860, 25860, SubList(3212, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(59, 1), SubList(1008, 7), SubList(3228, 54), High) // 6504h Supported alarms
    (25861, 25861, SubList(3394, 8), SubList(0, 1), Optional, None, SubList(0, 0), SubList(60, 1), SubList(1008, 7), SubList(3402, 81), High) // 6505h Warnings
    (25862, 25862, SubList(3483, 18), SubList(0, 1), Optional, None, SubList(0, 0), SubList(61, 1), SubList(1008, 7), SubList(3501, 56), High) // 6506h Supported warnings
    (25863, 25863, SubList(3602, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(62, 1), SubList(1008, 7), SubList(3630, 52), High) // 6507h Profile and software version
    (25864, 25864, SubList(3687, 14), SubList(0, 1), Optional, None, SubList(0, 0), SubList(63, 1), SubList(1008, 7), SubList(3701, 43), High) // 6508h Operating time
    (25865, 25865, SubList(3744, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(64, 1), SubList(1008, 7), SubList(3756, 86), High) // 6509h Offset value
    (25866, 25866, SubList(3937, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(65, 4), SubList(1008, 7), SubList(3958, 71), High) // 650Ah Module identification
    (25867, 25867, SubList(4029, 13), SubList(0, 1), Optional, None, SubList(0, 0), SubList(56, 1), SubList(1008, 7), SubList(4042, 47), High) // 650Bh Serial number
    (25868, 25868, SubList(4089, 38), SubList(1, 2), Optional, None, SubList(0, 1), SubList(69, 3), SubList(1008, 7), SubList(4127, 60), High) // 650Ch Offset values for multi-sensor devices
    (25872, 25872, SubList(4187, 36), SubList(0, 1), Optional, None, SubList(0, 0), SubList(72, 1), SubList(1622, 9), SubList(4223, 60), Medium) // 6510h Number of high precision revolutions
    (26623, 26623, SubList(253, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(73, 1), SubList(4283, 15), SubList(4298, 70), High) // 67FFh Device type
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, None, Optional, SubList(0, 0), SubList(0, 0), SubList(0, 0), SubList(0, 0), None, SubList(0, 0), SubList(0, 2))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(2, 5))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(2, 2), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(2, 2), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1362, 23), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Position measuring step
    (2, 2, Some(No), Optional, SubList(1385, 20), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Speed measuring step
    (3, 3, Some(No), Optional, SubList(1405, 27), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Acceleration measuring step
    (4, 4, Some(No), Optional, SubList(1432, 19), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Jerk measuring step
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(5, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(5, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1736, 38), SubList(6, 2), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Preset values for multi-sensor devices
    (2, 254, Some(No), Optional, SubList(1736, 38), SubList(6, 2), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Preset values for multi-sensor devices
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1834, 40), SubList(6, 2), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Position values for multi-sensor devices
    (2, 254, Some(Tpdo), Optional, SubList(1834, 40), SubList(6, 2), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Position values for multi-sensor devices
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1936, 11), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Speed value
    (2, 254, Some(Tpdo), Optional, SubList(1936, 11), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Speed value
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(1973, 18), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Acceleration value
    (2, 254, Some(Tpdo), Optional, SubList(1973, 18), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Acceleration value
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2024, 10), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Jerk value
    (2, 254, Some(Tpdo), Optional, SubList(2024, 10), SubList(8, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Jerk value
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(2059, 2), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2181, 18), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM state register
    (2, 254, Some(Tpdo), Optional, SubList(2181, 18), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM state register
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(2264, 19), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM enable register
    (2, 254, Some(Any), Optional, SubList(2264, 19), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM enable register
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Any), Mandatory, SubList(2315, 21), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM polarity register
    (2, 254, Some(Any), Optional, SubList(2315, 21), SubList(4, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM polarity register
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2377, 13), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM low limit
    (2, 254, Some(No), Optional, SubList(2377, 13), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM low limit
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2450, 14), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM high limit
    (2, 254, Some(No), Optional, SubList(2450, 14), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM high limit
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2522, 14), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM hysteresis
    (2, 254, Some(No), Optional, SubList(2522, 14), SubList(0, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // CAM hysteresis
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(Tpdo), Mandatory, SubList(2633, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Area state register
    (2, 254, Some(Tpdo), Optional, SubList(2633, 19), SubList(4, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Area state register
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2727, 19), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Work area low limit
    (2, 254, Some(No), Optional, SubList(2727, 19), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Work area low limit
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2783, 20), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Work area high limit
    (2, 254, Some(No), Optional, SubList(2783, 20), SubList(9, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Work area high limit
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(2, 5))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(7, 3))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(7, 3))
    (0, 0, Some(Tpdo), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(10, 7))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(10, 7))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(17, 2))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(3682, 5), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(3842, 25), SubList(6, 2), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Manufacturer offset value
    (2, 2, Some(No), Optional, SubList(3867, 35), SubList(6, 2), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Manufacturer minimum position value
    (3, 3, Some(No), Optional, SubList(3902, 35), SubList(6, 2), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Manufacturer maximum position value
    (0, 0, Some(No), Mandatory, SubList(1335, 27), SubList(4, 1), SubList(1, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(4089, 38), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Offset values for multi-sensor devices
    (2, 254, Some(No), Optional, SubList(4089, 38), SubList(9, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Offset values for multi-sensor devices
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(10, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 2))
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (0, 15, SubList(0, 21), SubList(0, 0)) // device profile number
    (16, 31, SubList(21, 4), SubList(0, 10)) // type
    (0, 0, SubList(735, 13), SubList(10, 2)) // code sequence
    (1, 1, SubList(774, 32), SubList(0, 0)) // commissioning diagnostic control
    (2, 2, SubList(806, 24), SubList(0, 0)) // scaling function control
    (3, 3, SubList(830, 19), SubList(0, 0)) // measuring direction
    (12, 15, SubList(849, 19), SubList(0, 0)) // of the manufacturer
    (0, 0, SubList(3106, 14), SubList(0, 0)) // position error
    (1, 1, SubList(3120, 25), SubList(0, 0)) // commissioning diagnostics
    (12, 15, SubList(849, 19), SubList(0, 0)) // of the manufacturer
    (0, 0, SubList(3282, 18), SubList(0, 0)) // frequency exceeded
    (1, 1, SubList(3300, 21), SubList(0, 0)) // light control reserve
    (2, 2, SubList(3321, 12), SubList(0, 0)) // CPU watchdog
    (3, 3, SubList(3333, 20), SubList(0, 0)) // operating time limit
    (4, 4, SubList(3353, 14), SubList(0, 0)) // battery charge
    (5, 5, SubList(3367, 27), SubList(0, 0)) // reference point not reached
    (12, 15, SubList(849, 19), SubList(0, 0)) // of the manufacturer
    (0, 15, SubList(3557, 22), SubList(0, 0)) // version of the profile
    (16, 31, SubList(3579, 23), SubList(0, 0)) // version of the software
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (1, 1, SubList(25, 18)) // single-turn rotary
    (2, 2, SubList(43, 17)) // multi-turn rotary
    (3, 3, SubList(60, 31)) // single-turn rotary with counter
    (4, 4, SubList(91, 18)) // incremental rotary
    (5, 5, SubList(109, 31)) // incremental rotary with counter
    (6, 6, SubList(140, 18)) // incremental linear
    (7, 7, SubList(158, 31)) // incremental linear with counter
    (8, 8, SubList(189, 15)) // absolute linear
    (9, 9, SubList(204, 34)) // absolute linear with cyclic coding
    (10, 10, SubList(238, 15)) // several sensors
    (0, 0, SubList(748, 9)) // clockwise
    (1, 1, SubList(757, 17)) // counter-clockwise
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

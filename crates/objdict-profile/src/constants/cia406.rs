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

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(253, 11), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(264, 12), about: Part(276, 54), confidence: High }, // 1000h Device type
    ObjectRow { first: 6144, last: 6144, name: Part(330, 30), object_types: Part(0, 0), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(360, 12), about: Part(372, 92), confidence: High }, // 1800h TPDO 1 communication parameter
    ObjectRow { first: 6145, last: 6145, name: Part(464, 30), object_types: Part(0, 0), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(494, 43), about: Part(537, 67), confidence: High }, // 1801h TPDO 2 communication parameter
    ObjectRow { first: 6656, last: 6656, name: Part(604, 24), object_types: Part(0, 0), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(360, 12), about: Part(628, 41), confidence: High }, // 1A00h TPDO 1 mapping parameter
    ObjectRow { first: 6657, last: 6657, name: Part(669, 24), object_types: Part(0, 0), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(494, 43), about: Part(693, 42), confidence: High }, // 1A01h TPDO 2 mapping parameter
    ObjectRow { first: 24576, last: 24576, name: Part(868, 20), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(1, 1), source: Part(888, 13), about: Part(901, 77), confidence: High }, // 6000h Operating parameters
    ObjectRow { first: 24577, last: 24577, name: Part(978, 30), object_types: Part(0, 1), need: Optional, only: Some(2), as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(1008, 7), about: Part(1015, 66), confidence: High }, // 6001h Measuring units per revolution
    ObjectRow { first: 24578, last: 24578, name: Part(1081, 40), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(1008, 7), about: Part(1121, 65), confidence: High }, // 6002h Total measuring range in measuring units
    ObjectRow { first: 24579, last: 24579, name: Part(1186, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(3, 1), source: Part(1008, 7), about: Part(1198, 84), confidence: High }, // 6003h Preset value
    ObjectRow { first: 24580, last: 24580, name: Part(1282, 14), object_types: Part(0, 1), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(4, 1), source: Part(888, 13), about: Part(1296, 39), confidence: High }, // 6004h Position value
    ObjectRow { first: 24581, last: 24581, name: Part(1451, 38), object_types: Part(1, 2), need: Optional, only: Some(4), as_many_as: Part(0, 0), entries: Part(5, 5), source: Part(1489, 18), about: Part(1507, 86), confidence: High }, // 6005h Linear encoder measuring step settings
    ObjectRow { first: 24584, last: 24584, name: Part(1593, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(10, 1), source: Part(1622, 9), about: Part(1631, 32), confidence: Medium }, // 6008h High precision position value
    ObjectRow { first: 24585, last: 24585, name: Part(1663, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(11, 1), source: Part(1622, 9), about: Part(1690, 46), confidence: Medium }, // 6009h High precision preset value
    ObjectRow { first: 24592, last: 24592, name: Part(1736, 38), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(12, 3), source: Part(1008, 7), about: Part(1774, 60), confidence: Medium }, // 6010h Preset values for multi-sensor devices
    ObjectRow { first: 24608, last: 24608, name: Part(1834, 40), object_types: Part(1, 2), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(15, 3), source: Part(1008, 7), about: Part(1874, 62), confidence: Medium }, // 6020h Position values for multi-sensor devices
    ObjectRow { first: 24624, last: 24624, name: Part(1936, 11), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(18, 3), source: Part(1622, 9), about: Part(1947, 26), confidence: Medium }, // 6030h Speed value
    ObjectRow { first: 24640, last: 24640, name: Part(1973, 18), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 3), source: Part(1622, 9), about: Part(1991, 33), confidence: Medium }, // 6040h Acceleration value
    ObjectRow { first: 24656, last: 24656, name: Part(2024, 10), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(24, 3), source: Part(1622, 9), about: Part(2034, 25), confidence: Medium }, // 6050h Jerk value
    ObjectRow { first: 25088, last: 25088, name: Part(2061, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(27, 1), source: Part(888, 13), about: Part(2073, 108), confidence: High }, // 6200h Cyclic timer
    ObjectRow { first: 25344, last: 25344, name: Part(2181, 18), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(28, 3), source: Part(1622, 9), about: Part(2199, 65), confidence: Medium }, // 6300h CAM state register
    ObjectRow { first: 25345, last: 25345, name: Part(2264, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(31, 3), source: Part(1622, 9), about: Part(2283, 32), confidence: Medium }, // 6301h CAM enable register
    ObjectRow { first: 25346, last: 25346, name: Part(2315, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(34, 3), source: Part(1622, 9), about: Part(2336, 41), confidence: Medium }, // 6302h CAM polarity register
    ObjectRow { first: 25360, last: 25367, name: Part(2377, 13), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 3), source: Part(1622, 9), about: Part(2390, 60), confidence: Medium }, // 6310h CAM low limit
    ObjectRow { first: 25376, last: 25383, name: Part(2450, 14), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(40, 3), source: Part(1622, 9), about: Part(2464, 58), confidence: Medium }, // 6320h CAM high limit
    ObjectRow { first: 25392, last: 25399, name: Part(2522, 14), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(43, 3), source: Part(1622, 9), about: Part(2536, 97), confidence: Medium }, // 6330h CAM hysteresis
    ObjectRow { first: 25600, last: 25600, name: Part(2633, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(46, 3), source: Part(1622, 9), about: Part(2652, 75), confidence: Medium }, // 6400h Area state register
    ObjectRow { first: 25601, last: 25601, name: Part(2727, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(49, 3), source: Part(1622, 9), about: Part(2746, 37), confidence: Medium }, // 6401h Work area low limit
    ObjectRow { first: 25602, last: 25602, name: Part(2783, 20), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(52, 3), source: Part(1622, 9), about: Part(2803, 38), confidence: Medium }, // 6402h Work area high limit
    ObjectRow { first: 25856, last: 25856, name: Part(2841, 16), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(55, 1), source: Part(888, 13), about: Part(2857, 52), confidence: High }, // 6500h Operating status
    ObjectRow { first: 25857, last: 25857, name: Part(2909, 41), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(888, 13), about: Part(2950, 70), confidence: High }, // 6501h Single-turn resolution and measuring step
    ObjectRow { first: 25858, last: 25858, name: Part(3020, 37), object_types: Part(0, 1), need: When(6), only: Some(2), as_many_as: Part(0, 0), entries: Part(57, 1), source: Part(888, 13), about: Part(3057, 49), confidence: High }, // 6502h Number of distinguishable revolutions
    ObjectRow { first: 25859, last: 25859, name: Part(3145, 6), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(58, 1), source: Part(1008, 7), about: Part(3151, 61), confidence: High }, // 6503h Alarms
    ObjectRow { first: 25860, last: 25860, name: Part(3212, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(59, 1), source: Part(1008, 7), about: Part(3228, 54), confidence: High }, // 6504h Supported alarms
    ObjectRow { first: 25861, last: 25861, name: Part(3394, 8), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(60, 1), source: Part(1008, 7), about: Part(3402, 81), confidence: High }, // 6505h Warnings
    ObjectRow { first: 25862, last: 25862, name: Part(3483, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(61, 1), source: Part(1008, 7), about: Part(3501, 56), confidence: High }, // 6506h Supported warnings
    ObjectRow { first: 25863, last: 25863, name: Part(3602, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(62, 1), source: Part(1008, 7), about: Part(3630, 52), confidence: High }, // 6507h Profile and software version
    ObjectRow { first: 25864, last: 25864, name: Part(3687, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 1), source: Part(1008, 7), about: Part(3701, 43), confidence: High }, // 6508h Operating time
    ObjectRow { first: 25865, last: 25865, name: Part(3744, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(64, 1), source: Part(1008, 7), about: Part(3756, 86), confidence: High }, // 6509h Offset value
    ObjectRow { first: 25866, last: 25866, name: Part(3937, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(65, 4), source: Part(1008, 7), about: Part(3958, 71), confidence: High }, // 650Ah Module identification
    ObjectRow { first: 25867, last: 25867, name: Part(4029, 13), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(1008, 7), about: Part(4042, 47), confidence: High }, // 650Bh Serial number
    ObjectRow { first: 25868, last: 25868, name: Part(4089, 38), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(69, 3), source: Part(1008, 7), about: Part(4127, 60), confidence: High }, // 650Ch Offset values for multi-sensor devices
    ObjectRow { first: 25872, last: 25872, name: Part(4187, 36), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 1), source: Part(1622, 9), about: Part(4223, 60), confidence: Medium }, // 6510h Number of high precision revolutions
    ObjectRow { first: 26623, last: 26623, name: Part(253, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(73, 1), source: Part(4283, 15), about: Part(4298, 70), confidence: High }, // 67FFh Device type
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: None, need: Optional, name: Part(0, 0), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 2) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(2, 5) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(2, 2), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(2, 2), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1362, 23), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Position measuring step
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(1385, 20), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Speed measuring step
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1405, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Acceleration measuring step
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(1432, 19), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Jerk measuring step
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1736, 38), data_types: Part(6, 2), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Preset values for multi-sensor devices
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1736, 38), data_types: Part(6, 2), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Preset values for multi-sensor devices
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1834, 40), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Position values for multi-sensor devices
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1834, 40), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Position values for multi-sensor devices
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1936, 11), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Speed value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1936, 11), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Speed value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1973, 18), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Acceleration value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1973, 18), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Acceleration value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2024, 10), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Jerk value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(2024, 10), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Jerk value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(2059, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2181, 18), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM state register
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(2181, 18), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM state register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(2264, 19), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM enable register
    EntryRow { first: 2, last: 254, mapping: Some(Any), need: Optional, name: Part(2264, 19), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM enable register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(2315, 21), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM polarity register
    EntryRow { first: 2, last: 254, mapping: Some(Any), need: Optional, name: Part(2315, 21), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM polarity register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2377, 13), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM low limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2377, 13), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM low limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2450, 14), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM high limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2450, 14), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM high limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2522, 14), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM hysteresis
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2522, 14), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // CAM hysteresis
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(2633, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Area state register
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(2633, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Area state register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2727, 19), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Work area low limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2727, 19), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Work area low limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2783, 20), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Work area high limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2783, 20), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Work area high limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(2, 5) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(7, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(7, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(10, 7) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(10, 7) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(17, 2) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(3682, 5), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(3842, 25), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Manufacturer offset value
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(3867, 35), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Manufacturer minimum position value
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(3902, 35), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Manufacturer maximum position value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(1335, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4089, 38), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Offset values for multi-sensor devices
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(4089, 38), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Offset values for multi-sensor devices
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(10, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 2) },
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 15, name: Part(0, 21), values: Part(0, 0) }, // device profile number
    BitRow { first: 16, last: 31, name: Part(21, 4), values: Part(0, 10) }, // type
    BitRow { first: 0, last: 0, name: Part(735, 13), values: Part(10, 2) }, // code sequence
    BitRow { first: 1, last: 1, name: Part(774, 32), values: Part(0, 0) }, // commissioning diagnostic control
    BitRow { first: 2, last: 2, name: Part(806, 24), values: Part(0, 0) }, // scaling function control
    BitRow { first: 3, last: 3, name: Part(830, 19), values: Part(0, 0) }, // measuring direction
    BitRow { first: 12, last: 15, name: Part(849, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(3106, 14), values: Part(0, 0) }, // position error
    BitRow { first: 1, last: 1, name: Part(3120, 25), values: Part(0, 0) }, // commissioning diagnostics
    BitRow { first: 12, last: 15, name: Part(849, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(3282, 18), values: Part(0, 0) }, // frequency exceeded
    BitRow { first: 1, last: 1, name: Part(3300, 21), values: Part(0, 0) }, // light control reserve
    BitRow { first: 2, last: 2, name: Part(3321, 12), values: Part(0, 0) }, // CPU watchdog
    BitRow { first: 3, last: 3, name: Part(3333, 20), values: Part(0, 0) }, // operating time limit
    BitRow { first: 4, last: 4, name: Part(3353, 14), values: Part(0, 0) }, // battery charge
    BitRow { first: 5, last: 5, name: Part(3367, 27), values: Part(0, 0) }, // reference point not reached
    BitRow { first: 12, last: 15, name: Part(849, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(3557, 22), values: Part(0, 0) }, // version of the profile
    BitRow { first: 16, last: 31, name: Part(3579, 23), values: Part(0, 0) }, // version of the software
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 1, last: 1, text: Part(25, 18) }, // single-turn rotary
    MeaningRow { first: 2, last: 2, text: Part(43, 17) }, // multi-turn rotary
    MeaningRow { first: 3, last: 3, text: Part(60, 31) }, // single-turn rotary with counter
    MeaningRow { first: 4, last: 4, text: Part(91, 18) }, // incremental rotary
    MeaningRow { first: 5, last: 5, text: Part(109, 31) }, // incremental rotary with counter
    MeaningRow { first: 6, last: 6, text: Part(140, 18) }, // incremental linear
    MeaningRow { first: 7, last: 7, text: Part(158, 31) }, // incremental linear with counter
    MeaningRow { first: 8, last: 8, text: Part(189, 15) }, // absolute linear
    MeaningRow { first: 9, last: 9, text: Part(204, 34) }, // absolute linear with cyclic coding
    MeaningRow { first: 10, last: 10, text: Part(238, 15) }, // several sensors
    MeaningRow { first: 0, last: 0, text: Part(748, 9) }, // clockwise
    MeaningRow { first: 1, last: 1, text: Part(757, 17) }, // counter-clockwise
];

static COMMANDS: &[CommandRow] = &[
];

static TRANSITIONS: &[TransitionRow] = &[
];

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

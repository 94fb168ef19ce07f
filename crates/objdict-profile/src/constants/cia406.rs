// Generated from `data/cia406.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Mapping::*, Profile};

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
        texts: Cow::Borrowed(TEXTS),
    },
};

static OBJECTS: &[ObjectRow] = &[
    ObjectRow { first: 4096, last: 4096, name: Part(253, 11), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(264, 12) }, // 1000h Device type
    ObjectRow { first: 6144, last: 6144, name: Part(276, 30), object_types: Part(0, 0), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(306, 12) }, // 1800h TPDO 1 communication parameter
    ObjectRow { first: 6145, last: 6145, name: Part(318, 30), object_types: Part(0, 0), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(348, 43) }, // 1801h TPDO 2 communication parameter
    ObjectRow { first: 6656, last: 6656, name: Part(391, 24), object_types: Part(0, 0), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(306, 12) }, // 1A00h TPDO 1 mapping parameter
    ObjectRow { first: 6657, last: 6657, name: Part(415, 24), object_types: Part(0, 0), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(348, 43) }, // 1A01h TPDO 2 mapping parameter
    ObjectRow { first: 24576, last: 24576, name: Part(619, 20), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(1, 1), source: Part(639, 13) }, // 6000h Operating parameters
    ObjectRow { first: 24577, last: 24577, name: Part(652, 30), object_types: Part(0, 1), need: Optional, only: Some(2), as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(682, 7) }, // 6001h Measuring units per revolution
    ObjectRow { first: 24578, last: 24578, name: Part(689, 40), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(2, 1), source: Part(682, 7) }, // 6002h Total measuring range in measuring units
    ObjectRow { first: 24579, last: 24579, name: Part(729, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(3, 1), source: Part(682, 7) }, // 6003h Preset value
    ObjectRow { first: 24580, last: 24580, name: Part(741, 14), object_types: Part(0, 1), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(4, 1), source: Part(639, 13) }, // 6004h Position value
    ObjectRow { first: 24581, last: 24581, name: Part(871, 38), object_types: Part(1, 2), need: Optional, only: Some(4), as_many_as: Part(0, 0), entries: Part(5, 5), source: Part(909, 18) }, // 6005h Linear encoder measuring step settings
    ObjectRow { first: 24584, last: 24584, name: Part(927, 29), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(10, 1), source: Part(956, 9) }, // 6008h High precision position value
    ObjectRow { first: 24585, last: 24585, name: Part(965, 27), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(11, 1), source: Part(956, 9) }, // 6009h High precision preset value
    ObjectRow { first: 24592, last: 24592, name: Part(992, 38), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(12, 3), source: Part(682, 7) }, // 6010h Preset values for multi-sensor devices
    ObjectRow { first: 24608, last: 24608, name: Part(1030, 40), object_types: Part(1, 2), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(15, 3), source: Part(682, 7) }, // 6020h Position values for multi-sensor devices
    ObjectRow { first: 24624, last: 24624, name: Part(1070, 11), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(18, 3), source: Part(956, 9) }, // 6030h Speed value
    ObjectRow { first: 24640, last: 24640, name: Part(1081, 18), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 3), source: Part(956, 9) }, // 6040h Acceleration value
    ObjectRow { first: 24656, last: 24656, name: Part(1099, 10), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(24, 3), source: Part(956, 9) }, // 6050h Jerk value
    ObjectRow { first: 25088, last: 25088, name: Part(1109, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(27, 1), source: Part(639, 13) }, // 6200h Cyclic timer
    ObjectRow { first: 25344, last: 25344, name: Part(1121, 18), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(28, 3), source: Part(956, 9) }, // 6300h CAM state register
    ObjectRow { first: 25345, last: 25345, name: Part(1139, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(31, 3), source: Part(956, 9) }, // 6301h CAM enable register
    ObjectRow { first: 25346, last: 25346, name: Part(1158, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(1, 1), entries: Part(34, 3), source: Part(956, 9) }, // 6302h CAM polarity register
    ObjectRow { first: 25360, last: 25367, name: Part(1179, 13), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(37, 3), source: Part(956, 9) }, // 6310h CAM low limit
    ObjectRow { first: 25376, last: 25383, name: Part(1192, 14), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(40, 3), source: Part(956, 9) }, // 6320h CAM high limit
    ObjectRow { first: 25392, last: 25399, name: Part(1206, 14), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(43, 3), source: Part(956, 9) }, // 6330h CAM hysteresis
    ObjectRow { first: 25600, last: 25600, name: Part(1220, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(46, 3), source: Part(956, 9) }, // 6400h Area state register
    ObjectRow { first: 25601, last: 25601, name: Part(1239, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(49, 3), source: Part(956, 9) }, // 6401h Work area low limit
    ObjectRow { first: 25602, last: 25602, name: Part(1258, 20), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(2, 1), entries: Part(52, 3), source: Part(956, 9) }, // 6402h Work area high limit
    ObjectRow { first: 25856, last: 25856, name: Part(1278, 16), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(55, 1), source: Part(639, 13) }, // 6500h Operating status
    ObjectRow { first: 25857, last: 25857, name: Part(1294, 41), object_types: Part(0, 1), need: Mandatory, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(639, 13) }, // 6501h Single-turn resolution and measuring step
    ObjectRow { first: 25858, last: 25858, name: Part(1335, 37), object_types: Part(0, 1), need: When(6), only: Some(2), as_many_as: Part(0, 0), entries: Part(57, 1), source: Part(639, 13) }, // 6502h Number of distinguishable revolutions
    ObjectRow { first: 25859, last: 25859, name: Part(1411, 6), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(58, 1), source: Part(682, 7) }, // 6503h Alarms
    ObjectRow { first: 25860, last: 25860, name: Part(1417, 16), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(59, 1), source: Part(682, 7) }, // 6504h Supported alarms
    ObjectRow { first: 25861, last: 25861, name: Part(1545, 8), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(60, 1), source: Part(682, 7) }, // 6505h Warnings
    ObjectRow { first: 25862, last: 25862, name: Part(1553, 18), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(61, 1), source: Part(682, 7) }, // 6506h Supported warnings
    ObjectRow { first: 25863, last: 25863, name: Part(1616, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(62, 1), source: Part(682, 7) }, // 6507h Profile and software version
    ObjectRow { first: 25864, last: 25864, name: Part(1644, 14), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(682, 7) }, // 6508h Operating time
    ObjectRow { first: 25865, last: 25865, name: Part(1658, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 1), source: Part(682, 7) }, // 6509h Offset value
    ObjectRow { first: 25866, last: 25866, name: Part(1765, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(64, 4), source: Part(682, 7) }, // 650Ah Module identification
    ObjectRow { first: 25867, last: 25867, name: Part(1786, 13), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(56, 1), source: Part(682, 7) }, // 650Bh Serial number
    ObjectRow { first: 25868, last: 25868, name: Part(1799, 38), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 1), entries: Part(68, 3), source: Part(682, 7) }, // 650Ch Offset values for multi-sensor devices
    ObjectRow { first: 25872, last: 25872, name: Part(1837, 36), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(71, 1), source: Part(956, 9) }, // 6510h Number of high precision revolutions
    ObjectRow { first: 26623, last: 26623, name: Part(253, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(72, 1), source: Part(1873, 15) }, // 67FFh Device type
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: None, need: Optional, name: Part(0, 0), data_types: Part(0, 0), access: Part(0, 0), values: Part(0, 0), default: None, bits: Part(0, 2) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(2, 5) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(2, 2), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(2, 2), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(782, 23), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Position measuring step
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(805, 20), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Speed measuring step
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(825, 27), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Acceleration measuring step
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Optional, name: Part(852, 19), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Jerk measuring step
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(5, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(992, 38), data_types: Part(6, 2), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Preset values for multi-sensor devices
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(992, 38), data_types: Part(6, 2), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Preset values for multi-sensor devices
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1030, 40), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Position values for multi-sensor devices
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1030, 40), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Position values for multi-sensor devices
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1070, 11), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Speed value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1070, 11), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Speed value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1081, 18), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Acceleration value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1081, 18), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Acceleration value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1099, 10), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Jerk value
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1099, 10), data_types: Part(8, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Jerk value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1121, 18), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM state register
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1121, 18), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM state register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1139, 19), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM enable register
    EntryRow { first: 2, last: 254, mapping: Some(Any), need: Optional, name: Part(1139, 19), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM enable register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Any), need: Mandatory, name: Part(1158, 21), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM polarity register
    EntryRow { first: 2, last: 254, mapping: Some(Any), need: Optional, name: Part(1158, 21), data_types: Part(4, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM polarity register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1179, 13), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM low limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1179, 13), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM low limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1192, 14), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM high limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1192, 14), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM high limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1206, 14), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM hysteresis
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1206, 14), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // CAM hysteresis
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(Tpdo), need: Mandatory, name: Part(1220, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Area state register
    EntryRow { first: 2, last: 254, mapping: Some(Tpdo), need: Optional, name: Part(1220, 19), data_types: Part(4, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Area state register
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1239, 19), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Work area low limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1239, 19), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Work area low limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1258, 20), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Work area high limit
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1258, 20), data_types: Part(9, 1), access: Part(0, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Work area high limit
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(2, 5) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(7, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(7, 3) },
    EntryRow { first: 0, last: 0, mapping: Some(Tpdo), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(10, 7) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(10, 7) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(17, 2) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(2, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1670, 25), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Manufacturer offset value
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(1695, 35), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Manufacturer minimum position value
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Optional, name: Part(1730, 35), data_types: Part(6, 2), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Manufacturer maximum position value
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(755, 27), data_types: Part(4, 1), access: Part(1, 1), values: Part(1, 1), default: None, bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1799, 38), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Offset values for multi-sensor devices
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1799, 38), data_types: Part(9, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) }, // Offset values for multi-sensor devices
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(10, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(1, 1), access: Part(1, 1), values: Part(0, 0), default: None, bits: Part(0, 2) },
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 15, name: Part(0, 21), values: Part(0, 0) }, // device profile number
    BitRow { first: 16, last: 31, name: Part(21, 4), values: Part(0, 10) }, // type
    BitRow { first: 0, last: 0, name: Part(439, 13), values: Part(10, 2) }, // code sequence
    BitRow { first: 1, last: 1, name: Part(525, 32), values: Part(0, 0) }, // commissioning diagnostic control
    BitRow { first: 2, last: 2, name: Part(557, 24), values: Part(0, 0) }, // scaling function control
    BitRow { first: 3, last: 3, name: Part(581, 19), values: Part(0, 0) }, // measuring direction
    BitRow { first: 12, last: 15, name: Part(600, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(1372, 14), values: Part(0, 0) }, // position error
    BitRow { first: 1, last: 1, name: Part(1386, 25), values: Part(0, 0) }, // commissioning diagnostics
    BitRow { first: 12, last: 15, name: Part(600, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 0, name: Part(1433, 18), values: Part(0, 0) }, // frequency exceeded
    BitRow { first: 1, last: 1, name: Part(1451, 21), values: Part(0, 0) }, // light control reserve
    BitRow { first: 2, last: 2, name: Part(1472, 12), values: Part(0, 0) }, // CPU watchdog
    BitRow { first: 3, last: 3, name: Part(1484, 20), values: Part(0, 0) }, // operating time limit
    BitRow { first: 4, last: 4, name: Part(1504, 14), values: Part(0, 0) }, // battery charge
    BitRow { first: 5, last: 5, name: Part(1518, 27), values: Part(0, 0) }, // reference point not reached
    BitRow { first: 12, last: 15, name: Part(600, 19), values: Part(0, 0) }, // of the manufacturer
    BitRow { first: 0, last: 15, name: Part(1571, 22), values: Part(0, 0) }, // version of the profile
    BitRow { first: 16, last: 31, name: Part(1593, 23), values: Part(0, 0) }, // version of the software
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
    MeaningRow { first: 0, last: 0, text: Part(452, 56) }, // clockwise (manuals; the book has it the other way round)
    MeaningRow { first: 1, last: 1, text: Part(508, 17) }, // counter-clockwise
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
    "TPDO 1 communication parameter", "book 3.3.2.2", "TPDO 2 communication parameter",
    "book 3.3.2.3; until edition 2 it was TPDO 3", "TPDO 1 mapping parameter", "TPDO 2 mapping parameter",
    "code sequence", "clockwise (manuals; the book has it the other way round)", "counter-clockwise",
    "commissioning diagnostic control", "scaling function control", "measuring direction", "of the manufacturer",
    "Operating parameters", "book; manuals", "Measuring units per revolution", "manuals",
    "Total measuring range in measuring units", "Preset value", "Position value", "Highest sub-index supported",
    "Position measuring step", "Speed measuring step", "Acceleration measuring step", "Jerk measuring step",
    "Linear encoder measuring step settings", "manuals; databases", "High precision position value", "databases",
    "High precision preset value", "Preset values for multi-sensor devices",
    "Position values for multi-sensor devices", "Speed value", "Acceleration value", "Jerk value",
    "Cyclic timer", "CAM state register", "CAM enable register", "CAM polarity register", "CAM low limit",
    "CAM high limit", "CAM hysteresis", "Area state register", "Work area low limit", "Work area high limit",
    "Operating status", "Single-turn resolution and measuring step", "Number of distinguishable revolutions",
    "position error", "commissioning diagnostics", "Alarms", "Supported alarms", "frequency exceeded",
    "light control reserve", "CPU watchdog", "operating time limit", "battery charge",
    "reference point not reached", "Warnings", "Supported warnings", "version of the profile",
    "version of the software", "Profile and software version", "Operating time", "Offset value",
    "Manufacturer offset value", "Manufacturer minimum position value", "Manufacturer maximum position value",
    "Module identification", "Serial number", "Offset values for multi-sensor devices",
    "Number of high precision revolutions", "CiA 301 §7.4.1",
);

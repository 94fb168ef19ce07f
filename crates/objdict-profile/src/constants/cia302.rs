// Generated from `data/cia302.toml` by `cargo xtask profiles`: edit that file.

#![allow(unused_imports, reason = "not every document has facts of every kind")]

use std::borrow::Cow;

use crate::model::{Access, Access::*, DataType, ObjectType, ObjectType::*, Value, Value::*};
use crate::tables::{NeedRow::*, Term::*, *};
use crate::{Condition, Confidence::*, Mapping::*, Profile};

pub(super) static PROFILE: Profile = Profile {
    group: "cia302",
    document: Cow::Borrowed("CiA 302"),
    title: Cow::Borrowed("additional application layer functions"),
    version: Some(Cow::Borrowed("4.1")),
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
    ObjectRow { first: 7936, last: 7936, name: Part(0, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(11, 4), about: Part(15, 56), confidence: High }, // 1F00h Request SDO
    ObjectRow { first: 7937, last: 7937, name: Part(71, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 1), source: Part(11, 4), about: Part(82, 43), confidence: High }, // 1F01h Release SDO
    ObjectRow { first: 7938, last: 7938, name: Part(148, 19), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(1, 2), source: Part(11, 4), about: Part(167, 46), confidence: High }, // 1F02h SDO manager COB-IDs
    ObjectRow { first: 7939, last: 7939, name: Part(213, 22), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(3, 3), source: Part(11, 4), about: Part(262, 111), confidence: High }, // 1F03h SDO connections part 1
    ObjectRow { first: 7940, last: 7940, name: Part(373, 22), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(6, 3), source: Part(11, 4), about: Part(395, 59), confidence: High }, // 1F04h SDO connections part 2
    ObjectRow { first: 7941, last: 7941, name: Part(454, 22), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(9, 3), source: Part(11, 4), about: Part(476, 59), confidence: High }, // 1F05h SDO connections part 3
    ObjectRow { first: 7942, last: 7942, name: Part(535, 22), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(12, 3), source: Part(11, 4), about: Part(557, 60), confidence: High }, // 1F06h SDO connections part 4
    ObjectRow { first: 7952, last: 7952, name: Part(617, 28), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(15, 1), source: Part(11, 4), about: Part(645, 59), confidence: High }, // 1F10h Dynamic SDO connection state
    ObjectRow { first: 7953, last: 7953, name: Part(704, 12), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(16, 1), source: Part(11, 4), about: Part(716, 81), confidence: High }, // 1F11h Slave failed
    ObjectRow { first: 7968, last: 7968, name: Part(797, 9), object_types: Part(1, 2), need: When(0), only: None, as_many_as: Part(0, 0), entries: Part(17, 2), source: Part(11, 4), about: Part(806, 95), confidence: High }, // 1F20h Store DCF
    ObjectRow { first: 7969, last: 7969, name: Part(901, 21), object_types: Part(1, 2), need: When(1), only: None, as_many_as: Part(0, 0), entries: Part(19, 2), source: Part(11, 4), about: Part(922, 52), confidence: High }, // 1F21h Storage format of DCF
    ObjectRow { first: 7970, last: 7970, name: Part(974, 11), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(21, 2), source: Part(11, 4), about: Part(985, 114), confidence: High }, // 1F22h Concise DCF
    ObjectRow { first: 7971, last: 7971, name: Part(1099, 22), object_types: Part(1, 2), need: When(2), only: None, as_many_as: Part(0, 0), entries: Part(23, 2), source: Part(11, 4), about: Part(1121, 72), confidence: High }, // 1F23h Store EDS of NMT slave
    ObjectRow { first: 7972, last: 7972, name: Part(1193, 21), object_types: Part(1, 2), need: When(3), only: None, as_many_as: Part(0, 0), entries: Part(25, 2), source: Part(11, 4), about: Part(1214, 57), confidence: High }, // 1F24h Storage format of EDS
    ObjectRow { first: 7973, last: 7973, name: Part(1271, 15), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(27, 3), source: Part(11, 4), about: Part(1295, 82), confidence: High }, // 1F25h Configure slave
    ObjectRow { first: 7974, last: 7974, name: Part(1377, 27), object_types: Part(1, 2), need: When(4), only: None, as_many_as: Part(0, 0), entries: Part(30, 2), source: Part(11, 4), about: Part(1404, 97), confidence: High }, // 1F26h Expected configuration date
    ObjectRow { first: 7975, last: 7975, name: Part(1501, 27), object_types: Part(1, 2), need: When(5), only: None, as_many_as: Part(0, 0), entries: Part(32, 2), source: Part(11, 4), about: Part(1528, 97), confidence: High }, // 1F27h Expected configuration time
    ObjectRow { first: 8016, last: 8016, name: Part(1625, 12), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(34, 3), source: Part(11, 4), about: Part(1637, 47), confidence: High }, // 1F50h Program data
    ObjectRow { first: 8017, last: 8017, name: Part(1684, 15), object_types: Part(1, 2), need: When(6), only: None, as_many_as: Part(0, 1), entries: Part(37, 3), source: Part(11, 4), about: Part(1699, 54), confidence: High }, // 1F51h Program control
    ObjectRow { first: 8018, last: 8018, name: Part(1803, 27), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(40, 3), source: Part(11, 4), about: Part(1830, 56), confidence: High }, // 1F52h Verify application software
    ObjectRow { first: 8019, last: 8019, name: Part(1886, 34), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(43, 2), source: Part(11, 4), about: Part(1920, 84), confidence: High }, // 1F53h Expected application software date
    ObjectRow { first: 8020, last: 8020, name: Part(2004, 34), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(45, 2), source: Part(11, 4), about: Part(2038, 84), confidence: High }, // 1F54h Expected application software time
    ObjectRow { first: 8021, last: 8021, name: Part(2122, 32), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(47, 2), source: Part(2154, 7), about: Part(2161, 94), confidence: Medium }, // 1F55h Expected software identification
    ObjectRow { first: 8022, last: 8022, name: Part(2255, 31), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(49, 3), source: Part(2154, 7), about: Part(2286, 58), confidence: Medium }, // 1F56h Program software identification
    ObjectRow { first: 8023, last: 8023, name: Part(2344, 27), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(52, 3), source: Part(2154, 7), about: Part(2556, 68), confidence: Medium }, // 1F57h Flash status identification
    ObjectRow { first: 8024, last: 8024, name: Part(2624, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(55, 2), source: Part(2154, 7), about: Part(2645, 83), confidence: Medium }, // 1F58h Program data of nodes
    ObjectRow { first: 8032, last: 8032, name: Part(2728, 24), object_types: Part(0, 0), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(0, 0), source: Part(2752, 9), about: Part(2761, 42), confidence: Medium }, // 1F60h Redundancy configuration
    ObjectRow { first: 8048, last: 8048, name: Part(2859, 15), object_types: Part(3, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(57, 3), source: Part(11, 4), about: Part(2874, 59), confidence: High }, // 1F70h Process picture
    ObjectRow { first: 8064, last: 8064, name: Part(3151, 11), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(60, 1), source: Part(11, 4), about: Part(3162, 82), confidence: High }, // 1F80h NMT startup
    ObjectRow { first: 8065, last: 8065, name: Part(3244, 20), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(61, 2), source: Part(11, 4), about: Part(3449, 115), confidence: High }, // 1F81h NMT slave assignment
    ObjectRow { first: 8066, last: 8066, name: Part(3564, 11), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(63, 3), source: Part(11, 4), about: Part(3575, 97), confidence: High }, // 1F82h Request NMT
    ObjectRow { first: 8067, last: 8067, name: Part(3672, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(66, 3), source: Part(11, 4), about: Part(3693, 69), confidence: High }, // 1F83h Request node guarding
    ObjectRow { first: 8068, last: 8068, name: Part(3762, 26), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(69, 2), source: Part(11, 4), about: Part(3788, 97), confidence: High }, // 1F84h Device type identification
    ObjectRow { first: 8069, last: 8069, name: Part(3885, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(71, 2), source: Part(11, 4), about: Part(3906, 87), confidence: High }, // 1F85h Vendor identification
    ObjectRow { first: 8070, last: 8070, name: Part(3993, 12), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(73, 2), source: Part(11, 4), about: Part(4005, 90), confidence: High }, // 1F86h Product code
    ObjectRow { first: 8071, last: 8071, name: Part(4095, 15), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(75, 2), source: Part(11, 4), about: Part(4110, 93), confidence: High }, // 1F87h Revision number
    ObjectRow { first: 8072, last: 8072, name: Part(4203, 13), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(77, 2), source: Part(11, 4), about: Part(4216, 91), confidence: High }, // 1F88h Serial number
    ObjectRow { first: 8073, last: 8073, name: Part(4309, 9), object_types: Part(0, 1), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(79, 1), source: Part(11, 4), about: Part(4318, 69), confidence: High }, // 1F89h Boot time
    ObjectRow { first: 8074, last: 8074, name: Part(4387, 21), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(80, 2), source: Part(2154, 7), about: Part(4408, 84), confidence: Medium }, // 1F8Ah Restore configuration
    ObjectRow { first: 8080, last: 8080, name: Part(4671, 35), object_types: Part(0, 0), need: When(7), only: None, as_many_as: Part(0, 0), entries: Part(82, 7), source: Part(4706, 15), about: Part(4721, 72), confidence: High }, // 1F90h NMT flying master timing parameters
    ObjectRow { first: 8081, last: 8081, name: Part(4908, 37), object_types: Part(1, 2), need: Optional, only: None, as_many_as: Part(0, 0), entries: Part(89, 4), source: Part(4706, 15), about: Part(4945, 81), confidence: High }, // 1F91h Self-starting nodes timing parameters
];

static ENTRIES: &[EntryRow] = &[
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(125, 17), data_types: Part(1, 1), access: Part(1, 2), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Number of entries
    EntryRow { first: 1, last: 254, mapping: Some(No), need: Optional, name: Part(142, 6), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(0), unit: Part(0, 0), bits: Part(0, 0) }, // COB-ID
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Optional, name: Part(213, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 1
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(213, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 1
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Optional, name: Part(373, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 2
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(373, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 2
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Optional, name: Part(454, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 3
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(454, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 3
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(0, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Optional, name: Part(535, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 4
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(535, 22), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // SDO connections part 4
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(2, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(797, 9), data_types: Part(3, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Store DCF
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(901, 21), data_types: Part(1, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Storage format of DCF
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(974, 11), data_types: Part(3, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Concise DCF
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(1099, 22), data_types: Part(3, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Store EDS of NMT slave
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(1193, 21), data_types: Part(1, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Storage format of EDS
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(1271, 15), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Configure slave
    EntryRow { first: 128, last: 128, mapping: Some(No), need: Optional, name: Part(1286, 9), data_types: Part(0, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // All nodes
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(1377, 27), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Expected configuration date
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(1501, 27), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Expected configuration time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1625, 12), data_types: Part(3, 1), access: Part(7, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program data
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1625, 12), data_types: Part(3, 1), access: Part(7, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program data
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(1684, 15), data_types: Part(1, 1), access: Part(7, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program control
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(1684, 15), data_types: Part(1, 1), access: Part(7, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program control
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(4, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Optional, name: Part(1753, 25), data_types: Part(0, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Application software date
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Optional, name: Part(1778, 25), data_types: Part(0, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Application software time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(1886, 34), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Expected application software date
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(2004, 34), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Expected application software time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(2122, 32), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Expected software identification
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2255, 31), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program software identification
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2255, 31), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program software identification
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(3, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2344, 27), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 3) }, // Flash status identification
    EntryRow { first: 2, last: 254, mapping: Some(No), need: Optional, name: Part(2344, 27), data_types: Part(0, 1), access: Part(4, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 3) }, // Flash status identification
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(2624, 21), data_types: Part(3, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Program data of nodes
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(125, 17), data_types: Part(1, 1), access: Part(4, 1), values: Part(4, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Number of entries
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(2825, 14), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(3, 2) }, // Selected range
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(2839, 20), data_types: Part(3, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Process image domain
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(5, 2), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(5, 7) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(3244, 20), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(12, 9) }, // NMT slave assignment
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(3564, 11), data_types: Part(1, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Request NMT
    EntryRow { first: 128, last: 128, mapping: Some(No), need: Optional, name: Part(1286, 9), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // All nodes
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(2, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(3672, 21), data_types: Part(1, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Request node guarding
    EntryRow { first: 128, last: 128, mapping: Some(No), need: Optional, name: Part(1286, 9), data_types: Part(1, 1), access: Part(0, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // All nodes
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(3762, 26), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Device type identification
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(3885, 21), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Vendor identification
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(3993, 12), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Product code
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(4095, 15), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Revision number
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(4203, 13), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(0, 0), bits: Part(0, 0) }, // Serial number
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(0, 0), data_types: Part(0, 1), access: Part(3, 1), values: Part(0, 0), default: Some(1), unit: Part(4307, 2), bits: Part(0, 0) },
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(235, 27), data_types: Part(1, 1), access: Part(4, 1), values: Part(1, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Highest sub-index supported
    EntryRow { first: 1, last: 127, mapping: Some(No), need: Mandatory, name: Part(4387, 21), data_types: Part(1, 1), access: Part(3, 1), values: Part(0, 0), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Restore configuration
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(125, 17), data_types: Part(1, 1), access: Part(4, 1), values: Part(5, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Number of entries
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4492, 42), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(2), unit: Part(4307, 2), bits: Part(0, 0) }, // Timeout for detection of active NMT master
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(4534, 33), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(3), unit: Part(4307, 2), bits: Part(0, 0) }, // NMT master negotiation time delay
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Mandatory, name: Part(4567, 25), data_types: Part(4, 2), access: Part(9, 2), values: Part(6, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // NMT master priority level
    EntryRow { first: 4, last: 4, mapping: Some(No), need: Mandatory, name: Part(4592, 18), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(4), unit: Part(4307, 2), bits: Part(0, 0) }, // Priority time slot
    EntryRow { first: 5, last: 5, mapping: Some(No), need: Mandatory, name: Part(4610, 24), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(5), unit: Part(4307, 2), bits: Part(0, 0) }, // CANopen device time slot
    EntryRow { first: 6, last: 6, mapping: Some(No), need: Mandatory, name: Part(4634, 37), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: None, unit: Part(4307, 2), bits: Part(0, 0) }, // Multiple NMT master detect cycle time
    EntryRow { first: 0, last: 0, mapping: Some(No), need: Mandatory, name: Part(125, 17), data_types: Part(1, 1), access: Part(4, 1), values: Part(7, 1), default: None, unit: Part(0, 0), bits: Part(0, 0) }, // Number of entries
    EntryRow { first: 1, last: 1, mapping: Some(No), need: Mandatory, name: Part(4793, 53), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(2), unit: Part(4307, 2), bits: Part(0, 0) }, // Timeout for detection of an NMT master capable device
    EntryRow { first: 2, last: 2, mapping: Some(No), need: Mandatory, name: Part(4846, 48), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(3), unit: Part(4307, 2), bits: Part(0, 0) }, // Delay time for NMT master capable device request
    EntryRow { first: 3, last: 3, mapping: Some(No), need: Mandatory, name: Part(4894, 14), data_types: Part(2, 1), access: Part(9, 2), values: Part(0, 0), default: Some(6), unit: Part(4307, 2), bits: Part(0, 0) }, // Node time slot
];

static BITS: &[BitRow] = &[
    BitRow { first: 0, last: 0, name: Part(2371, 28), values: Part(0, 0) }, // program download in progress
    BitRow { first: 1, last: 7, name: Part(2399, 5), values: Part(0, 9) }, // error
    BitRow { first: 16, last: 31, name: Part(2531, 25), values: Part(0, 0) }, // error of the manufacturer
    BitRow { first: 0, last: 15, name: Part(2803, 7), values: Part(0, 0) }, // segment
    BitRow { first: 16, last: 31, name: Part(2810, 15), values: Part(0, 0) }, // length in bytes
    BitRow { first: 0, last: 0, name: Part(2933, 10), values: Part(9, 2) }, // NMT master
    BitRow { first: 1, last: 1, name: Part(2948, 12), values: Part(11, 2) }, // start slaves
    BitRow { first: 2, last: 2, name: Part(2981, 17), values: Part(13, 2) }, // enter operational
    BitRow { first: 3, last: 3, name: Part(3016, 19), values: Part(15, 2) }, // start slaves at all
    BitRow { first: 4, last: 4, name: Part(3035, 26), values: Part(17, 2) }, // error of a mandatory slave
    BitRow { first: 5, last: 5, name: Part(3091, 13), values: Part(9, 2) }, // flying master
    BitRow { first: 6, last: 6, name: Part(3104, 47), values: Part(9, 2) }, // stop all nodes on an error of a mandatory slave
    BitRow { first: 0, last: 0, name: Part(3264, 20), values: Part(0, 0) }, // slave of this master
    BitRow { first: 2, last: 2, name: Part(3284, 18), values: Part(0, 0) }, // boot and configure
    BitRow { first: 3, last: 3, name: Part(3302, 9), values: Part(0, 0) }, // mandatory
    BitRow { first: 4, last: 4, name: Part(3311, 47), values: Part(0, 0) }, // no reset of its communication while operational
    BitRow { first: 5, last: 5, name: Part(3358, 19), values: Part(0, 0) }, // verify its software
    BitRow { first: 6, last: 6, name: Part(3377, 19), values: Part(0, 0) }, // update its software
    BitRow { first: 7, last: 7, name: Part(3396, 25), values: Part(0, 0) }, // restore its configuration
    BitRow { first: 8, last: 15, name: Part(3421, 12), values: Part(0, 0) }, // retry factor
    BitRow { first: 16, last: 31, name: Part(3433, 16), values: Part(0, 0) }, // guard time in ms
];

static MEANINGS: &[MeaningRow] = &[
    MeaningRow { first: 0, last: 0, text: Part(2404, 4) }, // none
    MeaningRow { first: 1, last: 1, text: Part(2408, 16) }, // no valid program
    MeaningRow { first: 2, last: 2, text: Part(2424, 14) }, // unknown format
    MeaningRow { first: 3, last: 3, text: Part(2438, 14) }, // wrong checksum
    MeaningRow { first: 4, last: 4, text: Part(2452, 17) }, // flash not cleared
    MeaningRow { first: 5, last: 5, text: Part(2469, 17) }, // flash write error
    MeaningRow { first: 6, last: 6, text: Part(2486, 13) }, // wrong address
    MeaningRow { first: 7, last: 7, text: Part(2499, 13) }, // flash secured
    MeaningRow { first: 63, last: 63, text: Part(2512, 19) }, // of the manufacturer
    MeaningRow { first: 0, last: 0, text: Part(2943, 2) }, // no
    MeaningRow { first: 1, last: 1, text: Part(2945, 3) }, // yes
    MeaningRow { first: 0, last: 0, text: Part(2960, 10) }, // one by one
    MeaningRow { first: 1, last: 1, text: Part(2970, 11) }, // all at once
    MeaningRow { first: 0, last: 0, text: Part(2998, 9) }, // by itself
    MeaningRow { first: 1, last: 1, text: Part(3007, 9) }, // when told
    MeaningRow { first: 0, last: 0, text: Part(2945, 3) }, // yes
    MeaningRow { first: 1, last: 1, text: Part(2943, 2) }, // no
    MeaningRow { first: 0, last: 0, text: Part(3061, 15) }, // that slave only
    MeaningRow { first: 1, last: 1, text: Part(3076, 15) }, // reset all nodes
];

static COMMANDS: &[CommandRow] = &[
];

static TRANSITIONS: &[TransitionRow] = &[
];

static CONDITIONS: &[Condition] = &[
    Condition::constant("1F21h", &[Described(7969, None)]),
    Condition::constant("1F20h", &[Described(7968, None)]),
    Condition::constant("1F24h", &[Described(7972, None)]),
    Condition::constant("1F23h", &[Described(7971, None)]),
    Condition::constant("1F27h", &[Described(7975, None)]),
    Condition::constant("1F26h", &[Described(7974, None)]),
    Condition::constant("1F50h", &[Described(8016, None)]),
    Condition::constant("1F80h[5]", &[BitsIn(8064, 0, [5, 5], 1), Range(1, 170141183460469231731687303715884105727)]),
];

static OBJECT_TYPES: &[ObjectType] = &[Var, Array, Record, Record];

static DATA_TYPES: &[DataType] = &[DataType(7), DataType(5), DataType(6), DataType(15), DataType(6), DataType(5)];

static ACCESS: &[Access] = &[Wo, Ro, Rw, Rw, Ro, Rw, Ro, Rw, Wo, Rw, Const];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[0..=254, 127..=127, 128..=128, 1..=254, 2..=2, 6..=6, 0..=2, 3..=3];

static DEFAULTS: &[Value] = &[Unsigned(2147483648), Unsigned(0), Unsigned(100), Unsigned(500), Unsigned(1500), Unsigned(10), Unsigned(15)];

static INDEXES: &[u16] = &[8016];

static TEXTS: &str = concat!(
    "Request SDO", "book", "Asks the SDO manager for an SDO channel to another node.", "Release SDO",
    "Gives SDO channels back to the SDO manager.", "Number of entries", "COB-ID", "SDO manager COB-IDs",
    "The COB-IDs that the SDO manager may hand out.", "SDO connections part 1", "Highest sub-index supported",
    "The SDO connections 1 to 254 of the network: client and server node, and which of their parameter sets is used.",
    "SDO connections part 2", "The SDO connections 255 to 508 of the network, as in 1F03h.",
    "SDO connections part 3", "The SDO connections 509 to 762 of the network, as in 1F03h.",
    "SDO connections part 4", "The SDO connections 763 to 1016 of the network, as in 1F03h.",
    "Dynamic SDO connection state", "The state of the SDO connections that the device requested.",
    "Slave failed", "Reports a node that failed, so that the manager's channels to it can be released.",
    "Store DCF",
    "The complete DCF of each node, kept by the configuration manager; the sub-index is the node-ID.",
    "Storage format of DCF", "The format of the DCFs in 1F20h, a sub-index a node.", "Concise DCF",
    "The configuration of each node as concise DCF, a stream of the writes that it needs; the sub-index is the node-ID.",
    "Store EDS of NMT slave", "The EDS of each node, kept by the manager; the sub-index is the node-ID.",
    "Storage format of EDS", "The format of the EDS files in 1F23h, a sub-index a node.", "Configure slave",
    "All nodes", "Starts the configuration of a node, or of all, when `conf` (666E6F63h) is written.",
    "Expected configuration date",
    "The configuration date that 1020h of each node must have, else it is configured; 0 means unknown.",
    "Expected configuration time",
    "The configuration time that 1020h of each node must have, else it is configured; 0 means unknown.",
    "Program data", "Takes programs for the device, one a sub-index.", "Program control",
    "Starts, stops, resets or clears the programs in 1F50h.", "Application software date",
    "Application software time", "Verify application software",
    "Date and time of the application software in the device.", "Expected application software date",
    "The software date that 1F52h of each node must have, else its program is downloaded.",
    "Expected application software time",
    "The software time that 1F52h of each node must have, else its program is downloaded.",
    "Expected software identification", "manuals",
    "The software identification that 1F56h of each node must have; 0 means that it is not checked.",
    "Program software identification", "Identifies the programs in 1F50h, for example by checksum.",
    "Flash status identification", "program download in progress", "error", "none", "no valid program",
    "unknown format", "wrong checksum", "flash not cleared", "flash write error", "wrong address",
    "flash secured", "of the manufacturer", "error of the manufacturer",
    "Whether a program is being written, and how the last download ended.", "Program data of nodes",
    "The programs that the manager downloads to the nodes; the sub-index is the node-ID.",
    "Redundancy configuration", "databases", "The parameters of two redundant CAN lines.", "segment",
    "length in bytes", "Selected range", "Process image domain", "Process picture",
    "Reads and writes a range of network variables as one block.", "NMT master", "no", "yes", "start slaves",
    "one by one", "all at once", "enter operational", "by itself", "when told", "start slaves at all",
    "error of a mandatory slave", "that slave only", "reset all nodes", "flying master",
    "stop all nodes on an error of a mandatory slave", "NMT startup",
    "How the device starts: whether it is the NMT master, and what it starts by itself.", "NMT slave assignment",
    "slave of this master", "boot and configure", "mandatory", "no reset of its communication while operational",
    "verify its software", "update its software", "restore its configuration", "retry factor",
    "guard time in ms",
    "Which nodes the NMT master manages, and how it boots, checks and guards each of them; the sub-index is the node-ID.",
    "Request NMT",
    "Asks the NMT master to change the state of a node, or of all; read, it is the state of that node.",
    "Request node guarding", "Asks the NMT master to start or stop guarding a node, or all of them.",
    "Device type identification",
    "The device type (1000h) that the NMT master expects of each node; 0 means that it is not checked.",
    "Vendor identification",
    "The vendor-ID that the NMT master expects of each node; 0 means that it is not checked.", "Product code",
    "The product code that the NMT master expects of each node; 0 means that it is not checked.",
    "Revision number",
    "The revision number that the NMT master expects of each node; 0 means that it is not checked.",
    "Serial number",
    "The serial number that the NMT master expects of each node; 0 means that it is not checked.", "ms",
    "Boot time", "How long the NMT master waits for mandatory nodes before it gives up.",
    "Restore configuration",
    "The sub-index of 1011h that the NMT master writes to a node before it configures it.",
    "Timeout for detection of active NMT master", "NMT master negotiation time delay",
    "NMT master priority level", "Priority time slot", "CANopen device time slot",
    "Multiple NMT master detect cycle time", "NMT flying master timing parameters", "book; databases",
    "The times in which several possible NMT masters agree on the active one.",
    "Timeout for detection of an NMT master capable device", "Delay time for NMT master capable device request",
    "Node time slot", "Self-starting nodes timing parameters",
    "The times in which self-starting devices find out whether there is an NMT master.",
);

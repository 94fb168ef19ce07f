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
        errors: SubList(0, 0),
        machine: None,
    },
};

static OBJECTS: &[ObjectRow] = table!(ObjectRow { first, last, name, object_types, need, only, as_many_as, entries, source, about, confidence }:
    (4138, 4138, SubList(7, 16), SubList(0, 1), Optional, None, SubList(0, 0), SubList(0, 1), SubList(23, 9), SubList(32, 76), High) // 102Ah NMT inhibit time
    (7936, 7936, SubList(108, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(1, 1), SubList(119, 4), SubList(123, 56), High) // 1F00h Request SDO
    (7937, 7937, SubList(179, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(1, 1), SubList(119, 4), SubList(190, 43), High) // 1F01h Release SDO
    (7938, 7938, SubList(256, 19), SubList(1, 2), Optional, None, SubList(0, 0), SubList(2, 2), SubList(119, 4), SubList(275, 46), High) // 1F02h SDO manager COB-IDs
    (7939, 7939, SubList(321, 22), SubList(1, 2), Optional, None, SubList(0, 0), SubList(4, 3), SubList(119, 4), SubList(370, 111), High) // 1F03h SDO connections part 1
    (7940, 7940, SubList(481, 22), SubList(1, 2), Optional, None, SubList(0, 0), SubList(7, 3), SubList(119, 4), SubList(503, 59), High) // 1F04h SDO connections part 2
    (7941, 7941, SubList(562, 22), SubList(1, 2), Optional, None, SubList(0, 0), SubList(10, 3), SubList(119, 4), SubList(584, 59), High) // 1F05h SDO connections part 3
    (7942, 7942, SubList(643, 22), SubList(1, 2), Optional, None, SubList(0, 0), SubList(13, 3), SubList(119, 4), SubList(665, 60), High) // 1F06h SDO connections part 4
    (7952, 7952, SubList(725, 28), SubList(0, 1), Optional, None, SubList(0, 0), SubList(16, 1), SubList(119, 4), SubList(753, 59), High) // 1F10h Dynamic SDO connection state
    (7953, 7953, SubList(812, 12), SubList(0, 1), Optional, None, SubList(0, 0), SubList(17, 1), SubList(119, 4), SubList(824, 81), High) // 1F11h Slave failed
    (7968, 7968, SubList(905, 9), SubList(1, 2), When(0), None, SubList(0, 0), SubList(18, 2), SubList(119, 4), SubList(914, 95), High) // 1F20h Store DCF
    (7969, 7969, SubList(1009, 21), SubList(1, 2), When(1), None, SubList(0, 0), SubList(20, 2), SubList(119, 4), SubList(1030, 52), High) // 1F21h Storage format of DCF
    (7970, 7970, SubList(1082, 11), SubList(1, 2), Optional, None, SubList(0, 0), SubList(22, 2), SubList(119, 4), SubList(1093, 114), High) // 1F22h Concise DCF
    (7971, 7971, SubList(1207, 22), SubList(1, 2), When(2), None, SubList(0, 0), SubList(24, 2), SubList(119, 4), SubList(1229, 72), High) // 1F23h Store EDS of NMT slave
    (7972, 7972, SubList(1301, 21), SubList(1, 2), When(3), None, SubList(0, 0), SubList(26, 2), SubList(119, 4), SubList(1322, 57), High) // 1F24h Storage format of EDS
    (7973, 7973, SubList(1379, 15), SubList(1, 2), Optional, None, SubList(0, 0), SubList(28, 3), SubList(119, 4), SubList(1403, 82), High) // 1F25h Configure slave
    (7974, 7974, SubList(1485, 27), SubList(1, 2), When(4), None, SubList(0, 0), SubList(31, 2), SubList(119, 4), SubList(1512, 97), High) // 1F26h Expected configuration date
    (7975, 7975, SubList(1609, 27), SubList(1, 2), When(5), None, SubList(0, 0), SubList(33, 2), SubList(119, 4), SubList(1636, 97), High) // 1F27h Expected configuration time
    (8016, 8016, SubList(1733, 12), SubList(1, 2), Optional, None, SubList(0, 0), SubList(35, 3), SubList(119, 4), SubList(1745, 47), High) // 1F50h Program data
    (8017, 8017, SubList(1792, 15), SubList(1, 2), When(6), None, SubList(0, 1), SubList(38, 3), SubList(119, 4), SubList(1865, 54), High) // 1F51h Program control
    (8018, 8018, SubList(1969, 27), SubList(1, 2), Optional, None, SubList(0, 0), SubList(41, 3), SubList(119, 4), SubList(1996, 56), High) // 1F52h Verify application software
    (8019, 8019, SubList(2052, 34), SubList(1, 2), Optional, None, SubList(0, 0), SubList(44, 2), SubList(119, 4), SubList(2086, 84), High) // 1F53h Expected application software date
    (8020, 8020, SubList(2170, 34), SubList(1, 2), Optional, None, SubList(0, 0), SubList(46, 2), SubList(119, 4), SubList(2204, 84), High) // 1F54h Expected application software time
    (8021, 8021, SubList(2288, 32), SubList(1, 2), Optional, None, SubList(0, 0), SubList(48, 2), SubList(2320, 7), SubList(2327, 94), Medium) // 1F55h Expected software identification
    (8022, 8022, SubList(2421, 31), SubList(1, 2), Optional, None, SubList(0, 0), SubList(50, 3), SubList(2320, 7), SubList(2452, 58), Medium) // 1F56h Program software identification
    (8023, 8023, SubList(2510, 27), SubList(1, 2), Optional, None, SubList(0, 0), SubList(53, 3), SubList(2320, 7), SubList(2722, 68), Medium) // 1F57h Flash status identification
    (8024, 8024, SubList(2790, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(56, 2), SubList(2320, 7), SubList(2811, 83), Medium) // 1F58h Program data of nodes
    (8032, 8032, SubList(3064, 24), SubList(1, 2), Optional, None, SubList(0, 0), SubList(58, 6), SubList(23, 9), SubList(3088, 42), Medium) // 1F60h Redundancy configuration
    (8048, 8048, SubList(3186, 15), SubList(3, 1), Optional, None, SubList(0, 0), SubList(64, 3), SubList(119, 4), SubList(3201, 59), High) // 1F70h Process picture
    (8064, 8064, SubList(3478, 11), SubList(0, 1), Optional, None, SubList(0, 0), SubList(67, 1), SubList(119, 4), SubList(3489, 82), High) // 1F80h NMT startup
    (8065, 8065, SubList(3571, 20), SubList(1, 2), Optional, None, SubList(0, 0), SubList(68, 2), SubList(119, 4), SubList(3776, 115), High) // 1F81h NMT slave assignment
    (8066, 8066, SubList(3891, 11), SubList(1, 2), Optional, None, SubList(0, 0), SubList(70, 3), SubList(119, 4), SubList(3902, 97), High) // 1F82h Request NMT
    (8067, 8067, SubList(3999, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(73, 3), SubList(119, 4), SubList(4020, 69), High) // 1F83h Request node guarding
    (8068, 8068, SubList(4089, 26), SubList(1, 2), Optional, None, SubList(0, 0), SubList(76, 2), SubList(119, 4), SubList(4115, 97), High) // 1F84h Device type identification
    (8069, 8069, SubList(4212, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(78, 2), SubList(119, 4), SubList(4233, 87), High) // 1F85h Vendor identification
    (8070, 8070, SubList(4320, 12), SubList(1, 2), Optional, None, SubList(0, 0), SubList(80, 2), SubList(119, 4), SubList(4332, 90), High) // 1F86h Product code
    (8071, 8071, SubList(4422, 15), SubList(1, 2), Optional, None, SubList(0, 0), SubList(82, 2), SubList(119, 4), SubList(4437, 93), High) // 1F87h Revision number
    (8072, 8072, SubList(4530, 13), SubList(1, 2), Optional, None, SubList(0, 0), SubList(84, 2), SubList(119, 4), SubList(4543, 91), High) // 1F88h Serial number
    (8073, 8073, SubList(4636, 9), SubList(0, 1), Optional, None, SubList(0, 0), SubList(86, 1), SubList(119, 4), SubList(4645, 69), High) // 1F89h Boot time
    (8074, 8074, SubList(4714, 21), SubList(1, 2), Optional, None, SubList(0, 0), SubList(87, 2), SubList(2320, 7), SubList(4735, 84), Medium) // 1F8Ah Restore configuration
    (8080, 8080, SubList(4998, 35), SubList(0, 0), When(7), None, SubList(0, 0), SubList(89, 7), SubList(5033, 15), SubList(5048, 72), High) // 1F90h NMT flying master timing parameters
    (8081, 8081, SubList(5235, 37), SubList(1, 2), Optional, None, SubList(0, 0), SubList(96, 4), SubList(5033, 15), SubList(5272, 81), High) // 1F91h Self-starting nodes timing parameters
);

static ENTRIES: &[EntryRow] = table!(EntryRow { first, last, mapping, need, name, data_types, access, values, default, unit, bits }:
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 7), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(233, 17), SubList(2, 1), SubList(2, 2), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Number of entries
    (1, 254, Some(No), Optional, SubList(250, 6), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(1), SubList(0, 0), SubList(0, 0)) // COB-ID
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Optional, SubList(321, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 1
    (2, 254, Some(No), Optional, SubList(321, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 1
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Optional, SubList(481, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 2
    (2, 254, Some(No), Optional, SubList(481, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 2
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Optional, SubList(562, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 3
    (2, 254, Some(No), Optional, SubList(562, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 3
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(0, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Optional, SubList(643, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 4
    (2, 254, Some(No), Optional, SubList(643, 22), SubList(1, 1), SubList(4, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // SDO connections part 4
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(0, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(905, 9), SubList(3, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Store DCF
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1009, 21), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Storage format of DCF
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1082, 11), SubList(3, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Concise DCF
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1207, 22), SubList(3, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Store EDS of NMT slave
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1301, 21), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Storage format of EDS
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1379, 15), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Configure slave
    (128, 128, Some(No), Optional, SubList(1394, 9), SubList(1, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // All nodes
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1485, 27), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Expected configuration date
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(1609, 27), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Expected configuration time
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1733, 12), SubList(3, 1), SubList(7, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Program data
    (2, 254, Some(No), Optional, SubList(1733, 12), SubList(3, 1), SubList(7, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Program data
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(1792, 15), SubList(2, 1), SubList(7, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 1)) // Program control
    (2, 254, Some(No), Optional, SubList(1792, 15), SubList(2, 1), SubList(7, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 1)) // Program control
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(4, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Optional, SubList(1919, 25), SubList(1, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Application software date
    (2, 2, Some(No), Optional, SubList(1944, 25), SubList(1, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Application software time
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(2052, 34), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Expected application software date
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(2170, 34), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Expected application software time
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(2288, 32), SubList(1, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Expected software identification
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2421, 31), SubList(1, 1), SubList(4, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Program software identification
    (2, 254, Some(No), Optional, SubList(2421, 31), SubList(1, 1), SubList(4, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Program software identification
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(3, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 1, Some(No), Mandatory, SubList(2510, 27), SubList(1, 1), SubList(4, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // Flash status identification
    (2, 254, Some(No), Optional, SubList(2510, 27), SubList(1, 1), SubList(4, 1), SubList(0, 0), None, SubList(0, 0), SubList(1, 3)) // Flash status identification
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(2790, 21), SubList(3, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Program data of nodes
    (0, 0, Some(No), Mandatory, SubList(233, 17), SubList(2, 1), SubList(4, 1), SubList(5, 1), None, SubList(0, 0), SubList(0, 0)) // Number of entries
    (1, 1, Some(No), Mandatory, SubList(2894, 21), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Maximum Tx delay time
    (2, 2, Some(No), Mandatory, SubList(2915, 40), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Heartbeat evaluation time after power on
    (3, 3, Some(No), Mandatory, SubList(2955, 51), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Heartbeat evaluation time after reset communication
    (4, 4, Some(No), Mandatory, SubList(3006, 31), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Channel error counter threshold
    (5, 5, Some(No), Mandatory, SubList(3037, 27), SubList(2, 1), SubList(4, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Channel error counter value
    (0, 0, Some(No), Mandatory, SubList(233, 17), SubList(2, 1), SubList(4, 1), SubList(4, 1), None, SubList(0, 0), SubList(0, 0)) // Number of entries
    (1, 1, Some(No), Mandatory, SubList(3152, 14), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(4, 2)) // Selected range
    (2, 2, Some(No), Mandatory, SubList(3166, 20), SubList(3, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Process image domain
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(5, 2), SubList(0, 0), None, SubList(0, 0), SubList(6, 7))
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(3571, 20), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(13, 9)) // NMT slave assignment
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(3891, 11), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Request NMT
    (128, 128, Some(No), Optional, SubList(1394, 9), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // All nodes
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(2, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(3999, 21), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Request node guarding
    (128, 128, Some(No), Optional, SubList(1394, 9), SubList(2, 1), SubList(1, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // All nodes
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(4089, 26), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Device type identification
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(4212, 21), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Vendor identification
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(4320, 12), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Product code
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(4422, 15), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Revision number
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(4530, 13), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(0, 0), SubList(0, 0)) // Serial number
    (0, 0, Some(No), Mandatory, SubList(0, 0), SubList(1, 1), SubList(0, 1), SubList(0, 0), Some(0), SubList(4634, 2), SubList(0, 0))
    (0, 0, Some(No), Mandatory, SubList(343, 27), SubList(2, 1), SubList(4, 1), SubList(1, 1), None, SubList(0, 0), SubList(0, 0)) // Highest sub-index supported
    (1, 127, Some(No), Mandatory, SubList(4714, 21), SubList(2, 1), SubList(0, 1), SubList(0, 0), None, SubList(0, 0), SubList(0, 0)) // Restore configuration
    (0, 0, Some(No), Mandatory, SubList(233, 17), SubList(2, 1), SubList(4, 1), SubList(6, 1), None, SubList(0, 0), SubList(0, 0)) // Number of entries
    (1, 1, Some(No), Mandatory, SubList(4819, 42), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(2), SubList(4634, 2), SubList(0, 0)) // Timeout for detection of active NMT master
    (2, 2, Some(No), Mandatory, SubList(4861, 33), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(3), SubList(4634, 2), SubList(0, 0)) // NMT master negotiation time delay
    (3, 3, Some(No), Mandatory, SubList(4894, 25), SubList(4, 2), SubList(9, 2), SubList(7, 1), None, SubList(0, 0), SubList(0, 0)) // NMT master priority level
    (4, 4, Some(No), Mandatory, SubList(4919, 18), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(4), SubList(4634, 2), SubList(0, 0)) // Priority time slot
    (5, 5, Some(No), Mandatory, SubList(4937, 24), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(5), SubList(4634, 2), SubList(0, 0)) // CANopen device time slot
    (6, 6, Some(No), Mandatory, SubList(4961, 37), SubList(0, 1), SubList(9, 2), SubList(0, 0), None, SubList(4634, 2), SubList(0, 0)) // Multiple NMT master detect cycle time
    (0, 0, Some(No), Mandatory, SubList(233, 17), SubList(2, 1), SubList(4, 1), SubList(8, 1), None, SubList(0, 0), SubList(0, 0)) // Number of entries
    (1, 1, Some(No), Mandatory, SubList(5120, 53), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(2), SubList(4634, 2), SubList(0, 0)) // Timeout for detection of an NMT master capable device
    (2, 2, Some(No), Mandatory, SubList(5173, 48), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(3), SubList(4634, 2), SubList(0, 0)) // Delay time for NMT master capable device request
    (3, 3, Some(No), Mandatory, SubList(5221, 14), SubList(0, 1), SubList(9, 2), SubList(0, 0), Some(6), SubList(4634, 2), SubList(0, 0)) // Node time slot
);

static BITS: &[BitRow] = table!(BitRow { first, last, name, values }:
    (0, 7, SubList(1807, 7), SubList(0, 4)) // command
    (0, 0, SubList(2537, 28), SubList(0, 0)) // program download in progress
    (1, 7, SubList(2565, 5), SubList(4, 9)) // error
    (16, 31, SubList(2697, 25), SubList(0, 0)) // error of the manufacturer
    (0, 15, SubList(3130, 7), SubList(0, 0)) // segment
    (16, 31, SubList(3137, 15), SubList(0, 0)) // length in bytes
    (0, 0, SubList(3260, 10), SubList(13, 2)) // NMT master
    (1, 1, SubList(3275, 12), SubList(15, 2)) // start slaves
    (2, 2, SubList(3308, 17), SubList(17, 2)) // enter operational
    (3, 3, SubList(3343, 19), SubList(19, 2)) // start slaves at all
    (4, 4, SubList(3362, 26), SubList(21, 2)) // error of a mandatory slave
    (5, 5, SubList(3418, 13), SubList(13, 2)) // flying master
    (6, 6, SubList(3431, 47), SubList(13, 2)) // stop all nodes on an error of a mandatory slave
    (0, 0, SubList(3591, 20), SubList(0, 0)) // slave of this master
    (2, 2, SubList(3611, 18), SubList(0, 0)) // boot and configure
    (3, 3, SubList(3629, 9), SubList(0, 0)) // mandatory
    (4, 4, SubList(3638, 47), SubList(0, 0)) // no reset of its communication while operational
    (5, 5, SubList(3685, 19), SubList(0, 0)) // verify its software
    (6, 6, SubList(3704, 19), SubList(0, 0)) // update its software
    (7, 7, SubList(3723, 25), SubList(0, 0)) // restore its configuration
    (8, 15, SubList(3748, 12), SubList(0, 0)) // retry factor
    (16, 31, SubList(3760, 16), SubList(0, 0)) // guard time in ms
);

static MEANINGS: &[MeaningRow] = table!(MeaningRow { first, last, text }:
    (0, 0, SubList(1814, 12)) // stop program
    (1, 1, SubList(1826, 13)) // start program
    (2, 2, SubList(1839, 13)) // reset program
    (3, 3, SubList(1852, 13)) // clear program
    (0, 0, SubList(2570, 4)) // none
    (1, 1, SubList(2574, 16)) // no valid program
    (2, 2, SubList(2590, 14)) // unknown format
    (3, 3, SubList(2604, 14)) // wrong checksum
    (4, 4, SubList(2618, 17)) // flash not cleared
    (5, 5, SubList(2635, 17)) // flash write error
    (6, 6, SubList(2652, 13)) // wrong address
    (7, 7, SubList(2665, 13)) // flash secured
    (63, 63, SubList(2678, 19)) // of the manufacturer
    (0, 0, SubList(3270, 2)) // no
    (1, 1, SubList(3272, 3)) // yes
    (0, 0, SubList(3287, 10)) // one by one
    (1, 1, SubList(3297, 11)) // all at once
    (0, 0, SubList(3325, 9)) // by itself
    (1, 1, SubList(3334, 9)) // when told
    (0, 0, SubList(3272, 3)) // yes
    (1, 1, SubList(3270, 2)) // no
    (0, 0, SubList(3388, 15)) // that slave only
    (1, 1, SubList(3403, 15)) // reset all nodes
);

static COMMANDS: &[CommandRow] = &[];

static TRANSITIONS: &[TransitionRow] = &[];

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

static DATA_TYPES: &[DataType] = &[DataType(6), DataType(7), DataType(5), DataType(15), DataType(6), DataType(5)];

static ACCESS: &[Access] = &[Rw, Wo, Ro, Rw, Ro, Rw, Ro, Rw, Wo, Rw, Const];

static VALUES: &[std::ops::RangeInclusive<i128>] = &[0..=254, 127..=127, 128..=128, 1..=254, 2..=2, 5..=5, 6..=6, 0..=2, 3..=3];

static DEFAULTS: &[Value] = &[Unsigned(0), Unsigned(2147483648), Unsigned(100), Unsigned(500), Unsigned(1500), Unsigned(10), Unsigned(15)];

static INDEXES: &[u16] = &[8016];

static TEXTS: &str = concat!(
    "100 µs", "NMT inhibit time", "databases",
    "The shortest time between two NMT commands of the manager; 0 means no limit.", "Request SDO", "book",
    "Asks the SDO manager for an SDO channel to another node.", "Release SDO",
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
    "Program data", "Takes programs for the device, one a sub-index.", "Program control", "command",
    "stop program", "start program", "reset program", "clear program",
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
    "Maximum Tx delay time", "Heartbeat evaluation time after power on",
    "Heartbeat evaluation time after reset communication", "Channel error counter threshold",
    "Channel error counter value", "Redundancy configuration", "The parameters of two redundant CAN lines.",
    "segment", "length in bytes", "Selected range", "Process image domain", "Process picture",
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

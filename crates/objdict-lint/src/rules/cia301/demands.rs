//! The requirements of CiA 301: one row for each rule that uses a check of [`crate::demands`].

use crate::demands::{
    sub_0_out_of_range, undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping, wrong_object_type,
};
use crate::rule::rules;

rules! {
    source: "CiA 301 §7.5.2";

    "cia301/mapped-communication-object", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "a communication object that cannot be mapped to a PDO is marked as mappable",
    checks: "Reports a communication object of CiA 301 with `PDOMapping` set. Exceptions are 1001h, 1002h, 1013h, 1026h and the COB-IDs of SDOs, which CiA 301 declares mappable.",
    why: "A configuration tool offers the object for mapping. The device rejects the mapping, or a received PDO changes its communication settings.",
    example: "`[1017]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`.",

    "cia301/sub-0-out-of-range", Warning, Against(sub_0_out_of_range);
    summary: "the highest sub-index of a communication object is out of range",
    checks: "Sub-index 0 must be in the range of CiA 301: 1 to 4 for 1018h, 1 to 127 for 1010h, 1011h, 1016h and 1028h, 2 to 6 for PDO communication parameters, 3 for SDO clients. Missing, surplus and undescribed sub-indexes have their own rules. So does the number of objects of a PDO mapping.",
    why: "Managers read sub-index 0 first and access no sub-index above it.",
    example: "`[1016]` with only `[1016sub0]`, which has `DefaultValue=0`",
    remedy: "Describe the entries, or remove an object without entries.",
    source: "CiA 301 §7.4.7.2, §7.5.2",

    "cia301/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "a communication object has a sub-index that CiA 301 does not define",
    checks: "Reports sub-indexes that CiA 301 does not define for 1000h to 1029h, the SDO and PDO parameters and the scanner and dispatching lists. FFh, which describes the structure of the object, is always allowed.",
    why: "CiA defines the meaning of these objects and may assign the sub-index in a later edition. Tools that know the object do not show it.",
    example: "`[1018sub5]`",
    remedy: "Move vendor-specific entries to 2000h to 5FFFh.",

    "cia301/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "a communication object has an access type that CiA 301 does not allow",
    checks: "The rule compares access types with CiA 301, entry by entry: 1000h to 1029h, the SDO and PDO parameters and the scanner and dispatching lists. `ro` and `const` are equivalent, because editions of CiA 301 swapped them. `rwr` and `rww` are treated as `rw`. Parameters that a profile can fix may be `const`.",
    why: "A tool offers to write an entry that the device rejects, or omits one that it must write. A read-only heartbeat time cannot be set, and a writable device type is meaningless.",
    example: "`[1000]` with `AccessType=rw`",
    remedy: "Use an access type of the standard, in the description and in the device.",

    "cia301/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "a communication object has a different data type than in CiA 301",
    checks: "The rule compares data types with CiA 301, entry by entry: 1000h to 1029h, the SDO and PDO parameters and the scanner and dispatching lists. Where editions of CiA 301 differ, both types are accepted: 1022h is UNSIGNED8 or UNSIGNED16. Sub-index 0 has its own rule.",
    why: "Managers write these objects with the length that CiA 301 defines. A device with a different length responds with an abort, and the boot-up of the node stops.",
    example: "`[1017]` with `DataType=0x0007`",
    remedy: "Use the data type of the standard, in the description and in the device.",

    "cia301/wrong-object-type", Error, Against(wrong_object_type);
    summary: "a communication object has a different object type than in CiA 301",
    checks: "The rule compares object types with CiA 301: 1000h to 1029h, the SDO and PDO parameters and the scanner and dispatching lists. An ARRAY instead of a RECORD whose members have one type, or the reverse, is a warning. The sub-indexes are the same, and devices of well-known vendors have an identity object of object type ARRAY.",
    why: "A tool that knows the object accesses the sub-indexes of the standard and does not find them.",
    example: "`[1017]` with `ObjectType=0x9`",
    remedy: "Use the object type of the standard.",
}

//! What CiA 301 demands: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    sub_0_out_of_range, undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping, wrong_object_type,
};
use crate::rule::demands;

demands! {
    "cia301/mapped-communication-object", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "a communication object that no PDO may carry is marked as mappable",
    checks: "Whether `PDOMapping` is set at a communication object of CiA 301 other than 1001h, 1002h, 1013h, 1026h and the COB-IDs of SDOs, which CiA 301 calls mappable although nobody maps them.",
    why: "A configuration tool offers the object for a PDO; the device refuses the mapping, or a received PDO changes the communication of the node.",
    example: "`[1017]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`.",
    source: "CiA 301 §7.5.2",

    "cia301/sub-0-out-of-range", Warning, Against(sub_0_out_of_range);
    summary: "sub-index 0 of a communication object states an impossible highest sub-index",
    checks: "Whether the value of sub-index 0 lies in the range that CiA 301 gives it: 1 to 4 for 1018h, 1 to 127 for 1010h, 1011h, 1016h and 1028h, 2 to 6 for PDO communication parameters, 3 for SDO clients. It is silent where another rule has it: sub-indexes that are missing or too many, or a highest one that is not described. What a PDO mapping states is the matter of another rule.",
    why: "Managers read sub-index 0 before the others and stop at what it says.",
    example: "`[1016]` with `[1016sub0]` only, and `DefaultValue=0` there",
    remedy: "Describe the entries, or leave out an object that has none.",
    source: "CiA 301 §7.4.7.2, §7.5.2",

    "cia301/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "a communication object has a sub-index that CiA 301 does not define",
    checks: "Whether each sub-index of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists is one that the standard defines. FFh, which describes the object itself, may always be there.",
    why: "The meaning of these objects belongs to CiA; a later edition may give the sub-index another one. Tools that know the object do not show it.",
    example: "`[1018sub5]`",
    remedy: "Put what is your own into 2000h to 5FFFh.",
    source: "CiA 301 §7.5.2",

    "cia301/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "a communication object has an access type that CiA 301 does not allow",
    checks: "The access types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists, entry by entry. `ro` and `const` stand for each other, for the editions of CiA 301 exchanged them; `rwr` and `rww` count as `rw`; parameters that a profile may fix can be `const`.",
    why: "A tool offers to write what the device refuses, or does not write what it must: a heartbeat time that is read-only cannot be set, a device type that can be written means nothing.",
    example: "`[1000]` with `AccessType=rw`",
    remedy: "Use an access type of the standard, in the description and in the device.",
    source: "CiA 301 §7.5.2",

    "cia301/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "a communication object has another data type than CiA 301 gives it",
    checks: "The data types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists, entry by entry. Where editions of CiA 301 differ, both types are accepted: 1022h is UNSIGNED8 or UNSIGNED16. Sub-index 0 is the matter of a rule of its own.",
    why: "Managers write these objects with the length that CiA 301 gives them. A device with another length answers with an abort, and the boot-up ends there.",
    example: "`[1017]` with `DataType=0x0007`",
    remedy: "Use the data type of the standard, in the description and in the device.",
    source: "CiA 301 §7.5.2",

    "cia301/wrong-object-type", Error, Against(wrong_object_type);
    summary: "a communication object has another object type than CiA 301 gives it",
    checks: "The object types of 1000h to 1029h, of the SDO and PDO parameters and of the scanner and dispatching lists. An ARRAY where CiA 301 has a RECORD of alike members, or the reverse, is a warning: the sub-indexes are the same, and devices of well-known makers have an identity object of object type ARRAY.",
    why: "A tool that knows the object takes the sub-indexes of the standard for granted and does not find them.",
    example: "`[1017]` with `ObjectType=0x9`",
    remedy: "Use the object type of the standard.",
    source: "CiA 301 §7.5.2",
}

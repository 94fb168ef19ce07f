//! The requirements of CiA 302: one row for each rule that uses a check of [`crate::demands`].

use crate::demands::{
    different_channel_count, missing_entry, missing_object, reserved_bits, sub_0_out_of_range,
    undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping, wrong_object_type, wrong_value,
};
use crate::rule::rules;

rules! {
    source: "CiA 302-2, the object descriptions";

    "cia302/different-program-count", Error, Against(different_channel_count);
    summary: "1F51h and 1F50h have a different number of programs",
    checks: "Program control (1F51h) must have as many sub-indexes as program data (1F50h).",
    why: "A downloaded program cannot be started, or a program that can be started cannot be downloaded.",
    example: "`[1F50sub0]` with `DefaultValue=2` and `[1F51sub0]` with `DefaultValue=1`",
    remedy: "Describe an entry of 1F51h for each program of 1F50h.",
    source: "CiA 302-3 (1F50h, 1F51h)",

    "cia302/missing-object", Error, Demand(missing_object);
    summary: "an object that CiA 302 requires together with another object is missing",
    checks: "Objects that belong together must all be described. 1F20h and 1F21h, 1F23h and 1F24h, 1F26h and 1F27h each require the other. 1F50h requires 1F51h, but not the reverse. 1F90h is required if bit 5 of 1F80h makes the device a flying master. Modular devices are not checked, because a module may provide the object.",
    why: "A stored DCF without its format cannot be read. An expected date without a time is only half of the comparison. A program cannot be started without its control object.",
    example: "`[1F20]` without `[1F21]`",
    remedy: "Describe the missing object and implement it in the device.",
    source: "CiA 302-2 (1F20h to 1F27h, 1F80h, 1F90h); CiA 302-3 (1F50h, 1F51h)",

    "cia302/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that CiA 302 requires is missing",
    checks: "Lists of nodes and of programs must have an entry, and 1F70h, 1F90h and 1F91h must be complete.",
    why: "The manager reads an entry for each node. Reading a missing entry results in an abort, and the boot procedure stops.",
    example: "`[1F90]` without `[1F90sub3]`, the priority of the master",
    remedy: "Describe the sub-index. `CompactSubObj=127` describes a list of nodes in one line.",

    "cia302/reserved-bits", Warning, Expected(reserved_bits), fix Unsafe;
    summary: "a reserved bit of 1F80h or 1F81h is set",
    checks: "Only defined bits may be set in 1F80h (0 to 6), in entries of 1F81h (all but 1) and in 1F57h.",
    why: "A device rejects an unsupported bit with abort code 0609 0030h. A later edition may define the bit.",
    example: "`[1F80]` with `DefaultValue=0x00000080`",
    remedy: "Clear the bit.",
    source: "CiA 302-2 (1F80h, 1F81h); CiA 302-3 (1F57h)",

    "cia302/sub-0-out-of-range", Warning, Against(sub_0_out_of_range);
    summary: "the size of a list of nodes differs from CiA 302",
    checks: "Sub-index 0 of a list of nodes must be 127. For lists with an entry for all nodes (1F25h, 1F82h, 1F83h) it must be 128, but `CompactSubObj` may be 127 too. Sub-index 0 of other objects must be in its range. Missing, surplus and undescribed sub-indexes have their own rules.",
    why: "A manager with a shorter list ignores the remaining nodes, and a configuration tool offers no entries for them.",
    example: "`[1F81sub0]` with `DefaultValue=32` and sub-indexes up to 32",
    remedy: "Describe all 127 entries; `CompactSubObj=127` does so in one line. A device with memory for fewer nodes rejects the other entries.",

    "cia302/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object has a sub-index that CiA 302 does not define",
    checks: "Reports sub-indexes of 1F00h to 1F91h that CiA 302 does not define. Lists of nodes may have 1 to 127 (the node-IDs). Lists with an entry for all nodes may also have 128.",
    why: "Node 128 does not exist. A tool that shows a list of nodes does not show the entry.",
    example: "`[1F81sub80]`",
    remedy: "Remove the entry. Vendor-specific entries belong in 2000h to 5FFFh.",

    "cia302/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "an entry has an access type that CiA 302 does not allow",
    checks: "The rule compares the access types of 102Ah and of 1F00h to 1F91h with CiA 302. `ro` and `const` are equivalent; `rwr` and `rww` are treated as `rw`. A startup value or a flying master that is not configurable may be constant.",
    why: "A tool cannot store the node configuration in a read-only 1F22h or write a read-only request.",
    example: "`[1F25sub1]` with `AccessType=ro`, although the configuration request is written",
    remedy: "Use the access type of the document, in the description and in the device.",
    source: "CiA 302-2 and 302-3, the object descriptions",

    "cia302/wrong-data-type", Warning, Expected(wrong_data_type), fix Unsafe;
    summary: "an entry has a different data type than in CiA 302",
    checks: "The rule compares the data types of 102Ah and of 1F00h to 1F91h with CiA 302. Where sources differ, as for the priority level of a flying master, all of their types are accepted. DOMAIN or INTEGER8 for 1F21h, an error of two well-known databases, is not accepted.",
    why: "A manager writes a request with the length of the document, and a device with a different length rejects it. A widespread generator of manager descriptions uses UNSIGNED8 for 1F25h, although the request `conf` has four bytes. Some drives describe programs as OCTET_STRING, which is harmless. The finding is therefore a warning.",
    example: "`[1F50sub1]` with `DataType=0x0007` instead of DOMAIN, `0x000F`",
    remedy: "Use the data type of the document, in the description and in the device.",
    source: "CiA 302-2 and 302-3, the object descriptions",

    "cia302/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "an object of CiA 302 is marked as mappable",
    checks: "Reports 102Ah and entries of 1F00h to 1F91h with `PDOMapping` set. All of them are configuration entries and cannot be mapped to a PDO.",
    why: "A configuration tool offers the entry for mapping, and the device rejects it.",
    example: "`[1F80]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`.",

    "cia302/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object has a different object type than in CiA 302",
    checks: "The rule compares the object types of 102Ah and of 1F00h to 1F91h with CiA 302. A RECORD instead of an ARRAY is a warning, because all its entries are accessible.",
    why: "A VAR has no entries for the nodes, so the manager cannot access them.",
    example: "`[1F22]` with `ObjectType=0x7`",
    remedy: "Use the object type of the document; a list of nodes is an ARRAY.",

    "cia302/wrong-value", Error, Expected(wrong_value);
    summary: "an entry has a value that CiA 302 does not define",
    checks: "The priority level of a flying master, 1F90h sub-index 3, must be 0, 1 or 2.",
    why: "The master sends its priority during the negotiation, and the other masters cannot interpret it.",
    example: "`[1F90sub3]` with `DefaultValue=3`",
    remedy: "Write 0 for a high, 1 for a medium or 2 for a low priority.",
    source: "CiA 302-2 (1F90h)",
}

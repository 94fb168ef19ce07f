//! What CiA 302 demands: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    different_channel_count, missing_entry, missing_object, reserved_bits, sub_0_out_of_range,
    undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping, wrong_object_type, wrong_value,
};
use crate::rule::demands;

demands! {
    "cia302/different-program-count", Error, Against(different_channel_count);
    summary: "1F51h does not control as many programs as 1F50h has",
    checks: "Whether program control (1F51h) has as many sub-indexes as program data (1F50h).",
    why: "A program that was downloaded cannot be started, or what is started is not there.",
    example: "`[1F50sub0]` with `DefaultValue=2`, `[1F51sub0]` with `DefaultValue=1`",
    remedy: "Describe an entry of 1F51h for each program of 1F50h.",
    source: "CiA 302-3 (1F50h, 1F51h)",

    "cia302/missing-object", Error, Applied(missing_object);
    summary: "an object that CiA 302 demands beside another one is missing",
    checks: "Whether what belongs together is there: 1F20h with 1F21h, 1F23h with 1F24h, 1F26h with 1F27h, 1F51h with 1F50h, and 1F90h when bit 5 of 1F80h makes the device a flying master. What a module may bring is not missed.",
    why: "A stored DCF without its format cannot be read, an expected date without a time is compared with half of what the node has, and a program that nobody can start stays where it is.",
    example: "`[1F20]` and no `[1F21]`",
    remedy: "Describe the other object too, and build it into the device.",
    source: "CiA 302-2 (1F20h to 1F27h, 1F80h, 1F90h); CiA 302-3 (1F50h, 1F51h)",

    "cia302/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that CiA 302 demands is missing",
    checks: "Whether lists of nodes and of programs have an entry, and whether 1F70h, 1F90h and 1F91h are complete.",
    why: "The manager reads an entry for each node that it finds. One that is missing answers with an abort, and the boot procedure stops.",
    example: "`[1F90]` without `[1F90sub3]`, the priority of the master",
    remedy: "Describe the sub-index. `CompactSubObj=127` describes a list of nodes in one line.",
    source: "CiA 302-2, the object descriptions",

    "cia302/reserved-bits", Warning, Expected(reserved_bits), fix Unsafe;
    summary: "a reserved bit of 1F80h or 1F81h is set",
    checks: "Whether only bits are set in 1F80h (0 to 6), in entries of 1F81h (all but 1) and in 1F57h that the document defines.",
    why: "A device answers with abort code 0609 0030h when a bit is written that it does not support; a later edition may give the bit a meaning.",
    example: "`[1F80]` with `DefaultValue=0x00000080`",
    remedy: "Clear the bit.",
    source: "CiA 302-2 (1F80h, 1F81h); CiA 302-3 (1F57h)",

    "cia302/sub-0-out-of-range", Warning, Against(sub_0_out_of_range);
    summary: "a list of nodes has not the size that CiA 302 gives it",
    checks: "Whether sub-index 0 of a list of nodes is 127, or 128 where there is an entry for all nodes (1F25h, 1F82h, 1F83h), and whether that of other objects lies in its range. It is silent where another rule has it: sub-indexes that are missing or too many, or a highest one that is not described.",
    why: "A manager that is told of fewer nodes does not look for the others; a configuration tool offers no entry for them.",
    example: "`[1F81sub0]` with `DefaultValue=32`, and sub-indexes up to 32",
    remedy: "Describe all 127 entries; `CompactSubObj=127` does it in one line. A device with room for fewer nodes refuses to write the others.",
    source: "CiA 302-2, the object descriptions",

    "cia302/undefined-sub-index", Error, Against(undefined_sub_index);
    summary: "an object has a sub-index that CiA 302 does not define",
    checks: "Whether each sub-index of 1F00h to 1F91h is one that the document defines: 1 to 127 in lists of nodes, for that is how high node-IDs go, 128 in those that have an entry for all nodes.",
    why: "There is no node 128. A tool that shows a list of nodes does not show the entry.",
    example: "`[1F81sub80]`",
    remedy: "Leave the entry out. What is your own belongs into 2000h to 5FFFh.",
    source: "CiA 302-2, the object descriptions",

    "cia302/wrong-access", Error, Expected(wrong_access), fix Unsafe;
    summary: "an entry of CiA 302 has an access type that the document does not allow",
    checks: "The access types of 1F00h to 1F91h. `ro` and `const` stand for each other; `rwr` and `rww` count as `rw`; a startup value or a flying master that cannot be configured may be constant.",
    why: "A tool that finds 1F22h read-only does not store the configuration of the nodes there, and a request that is read-only cannot be made.",
    example: "`[1F25sub1]` with `AccessType=ro`; the request to configure a node is written",
    remedy: "Use the access type of the document, in the description and in the device.",
    source: "CiA 302-2 and 302-3, the object descriptions",

    "cia302/wrong-data-type", Warning, Expected(wrong_data_type), fix Unsafe;
    summary: "an entry of CiA 302 has another data type",
    checks: "The data types of 1F00h to 1F91h. Where sources disagree, as on the priority level of a flying master, all of them are right. Two well-known databases make mistakes here, DOMAIN or INTEGER8 for 1F21h, which are not.",
    why: "A manager writes a request with the length of the document, and a device that has another one refuses it. A widespread generator of manager descriptions has 1F25h as UNSIGNED8, though the request `conf` has four bytes; some drives have programs as OCTET_STRING, which does no harm. So it is a warning.",
    example: "`[1F50sub1]` with `DataType=0x0007`; it is a DOMAIN, `0x000F`",
    remedy: "Use the data type of the document, in the description and in the device.",
    source: "CiA 302-2 and 302-3, the object descriptions",

    "cia302/wrong-mapping", Warning, Against(wrong_mapping), fix Unsafe;
    summary: "an object of CiA 302 is marked as mappable",
    checks: "Whether `PDOMapping` is set at an entry of 1F00h to 1F91h. All of them are for configuration, and no PDO carries them.",
    why: "A configuration tool offers it for a PDO, and the device refuses the mapping.",
    example: "`[1F80]` with `PDOMapping=1`",
    remedy: "Write `PDOMapping=0`.",
    source: "CiA 302-2, the object descriptions",

    "cia302/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of CiA 302 is of another object type",
    checks: "The object types of 1F00h to 1F91h. A RECORD in place of an ARRAY is a warning, for all its entries can be reached.",
    why: "A VAR has no entry for a node, so the manager finds nothing there.",
    example: "`[1F22]` with `ObjectType=0x7`",
    remedy: "Use the object type of the document; a list of nodes is an ARRAY.",
    source: "CiA 302-2, the object descriptions",

    "cia302/wrong-value", Error, Expected(wrong_value);
    summary: "an entry of CiA 302 has a value that means nothing",
    checks: "Whether the priority level of a flying master, 1F90h sub-index 3, is 0, 1 or 2.",
    why: "The master sends its priority in the negotiation, and the others do not understand it.",
    example: "`[1F90sub3]` with `DefaultValue=3`",
    remedy: "Write 0 for a high, 1 for a medium or 2 for a low priority.",
    source: "CiA 302-2 (1F90h)",
}

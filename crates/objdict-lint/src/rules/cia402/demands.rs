//! The requirements of CiA 402: one row per rule that uses a check of [`crate::demands`].

use crate::demands::{
    missing_entry, missing_object, undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping,
    wrong_object_type, wrong_value,
};
use crate::rule::rules;

rules! {
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16";

    "cia402/missing-object", Error, Demand(missing_object);
    summary: "an object that CiA 402 requires in a drive is missing",
    checks: "A drive must have the controlword 6040h, the statusword 6041h and the mandatory objects of each mode that 6502h (supported drive modes) indicates. These are 6042h to 6044h, 6046h and 6048h for velocity; 607Ah, 6081h, 6083h and 6064h for profile position; 60FFh, 606Ch and 6083h for profile velocity; 6071h, 6077h and 6087h for torque; 6098h and 6099h for homing; the targets, 6064h and 60C2h for the cyclic modes. Further axes, 800h indexes apart, are checked like the first. Objects that a module of a modular device may add are not reported.",
    why: "A master controls the drive with 6040h and 6041h and writes the objects of the mode. If one is missing, the SDO transfer is aborted and the axis does not move.",
    example: "`DefaultValue=0x00000005` in `[6502]`, which is profile position and profile velocity, without `[60FF]`",
    remedy: "Describe the object, or clear the bit of the mode in 6502h. None of the real drives examined lacks an object of its modes; only example files of stacks lack 6040h or 6041h.",
    source: "CiA 402-2, the object descriptions of the modes; IEC 61800-7-201",

    "cia402/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that CiA 402 requires is missing from a drive's object",
    checks: "The records and arrays of a drive must have the sub-indexes that CiA 402 makes mandatory: both limits of 607Bh and 607Dh, both speeds of 6099h, numerator and divisor of the factors, value and index of 60C2h.",
    why: "A factor without its divisor or a range with one limit is meaningless.",
    example: "`[6099]` with `[6099sub0]` and `[6099sub1]` only",
    remedy: "Describe the missing sub-index.",

    "cia402/undefined-sub-index", Warning, Against(undefined_sub_index);
    summary: "an object of a drive has a sub-index that CiA 402 does not define",
    checks: "Reports sub-indexes that CiA 402 does not define, in objects that it defines. Manufacturer-specific parameter sets (60F6h, 60F7h, 60F9h, 60FBh, 6410h, 6510h) may have any.",
    why: "A later version may define the sub-index. A master that relies on sub-index 0 reads one value too many.",
    example: "`[607Dsub3]`",
    remedy: "Move manufacturer-specific values to an object from 2000h on.",

    "cia402/wrong-access", Warning, Expected(wrong_access), fix Unsafe;
    summary: "the access type of a drive's entry differs from CiA 402",
    checks: "The rule compares access types with CiA 402 for the objects that it defines. `rwr` and `rww` are treated as `rw`. 6060h may be `wo`, as in version 2. Ratings, resolutions and factors that a drive cannot change may be `ro`.",
    why: "A master gets an SDO abort if it writes a read-only entry or reads back a write-only one.",
    example: "`AccessType=wo` in `[6040]`",
    remedy: "Correct the access type. Option codes that are `ro` because the drive has only one reaction violate the document but do no harm unless a master writes them. The finding is therefore a warning.",

    "cia402/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "the data type of a drive's entry differs from CiA 402",
    checks: "The rule compares data types with CiA 402 for the objects that it defines. `cia306/sub-0-type` checks sub-index 0.",
    why: "A master reads and writes the value with the type of the profile. If the length differs, the device aborts the transfer and rejects the mapping. If the sign differs, a negative speed becomes the largest positive one. Every third of the real drives examined has such an entry, mostly 608Fh and 6090h as INTEGER32 or 60FFh as UNSIGNED32, and each of them violates the document.",
    example: "`DataType=0x0007` in `[60FF]`: UNSIGNED32 instead of INTEGER32",
    remedy: "Correct the data type, in the device too. Alternatively, move a manufacturer-specific object out of the range of the profile.",

    "cia402/wrong-mapping", Note, Against(wrong_mapping), fix Unsafe;
    summary: "a drive's entry is marked as mappable, although CiA 402 keeps it out of PDOs",
    checks: "Reports objects that are marked as mappable but that CiA 402 keeps out of PDOs: option codes, names and dates of the motor and the drive, the device types of axes. Parameters that the document keeps out but many drives allow are not checked.",
    why: "Tools offer the entry for mapping, and the drive would have to apply it with every SYNC.",
    example: "`PDOMapping=1` in `[605A]`",
    remedy: "Write `PDOMapping=0`, unless the drive can really map the entry.",

    "cia402/wrong-object-type", Error, Against(wrong_object_type);
    summary: "the object type of a drive's object differs from CiA 402",
    checks: "The rule compares object types with CiA 402 for the objects that it defines. A RECORD instead of an ARRAY, as in many drives for pairs such as 6099h, is a warning because its sub-indexes are the same.",
    why: "A VAR has its value at sub-index 0, but a master reads sub-index 1.",
    example: "`ObjectType=0x7` in `[607D]`",
    remedy: "Use the object type of CiA 402.",

    "cia402/wrong-value", Error, Expected(wrong_value);
    summary: "an entry of a drive has a value that CiA 402 reserves",
    checks: "Reports a configured or default value that CiA 402 does not define, unless it is manufacturer-specific. The rule checks option codes 6007h and 605Ah to 605Eh, modes 6060h and 6061h, profile types 6086h and 6088h, homing method 6098h, jerk use 60A3h, index of the interpolation time 60C2h, buffer organization 60C4h.",
    why: "The drive rejects the value or reacts in an undefined way, such as a quick stop that does not stop.",
    example: "`DefaultValue=9` in `[605A]`, where 8 is the last defined value",
    remedy: "Use a defined value or a negative one, which is manufacturer-specific.",
}

//! What CiA 402 demands: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{
    missing_entry, missing_object, undefined_sub_index, wrong_access, wrong_data_type, wrong_mapping,
    wrong_object_type, wrong_value,
};
use crate::rule::demands;

demands! {
    "cia402/missing-object", Error, Applied(missing_object);
    summary: "an object that a drive has to have is missing",
    checks: "Whether a drive has the controlword 6040h and the statusword 6041h, and, for each mode that 6502h (supported drive modes) says it has, the objects that the mode cannot do without: 6042h to 6044h, 6046h and 6048h for velocity; 607Ah, 6081h, 6083h and 6064h for profile position; 60FFh, 606Ch and 6083h for profile velocity; 6071h, 6077h and 6087h for torque; 6098h and 6099h for homing; the targets, 6064h and 60C2h for the cyclic modes. Further axes, 800h indexes apart, are looked at like the first. What a module may bring is not missed.",
    why: "A master walks the drive through its states with 6040h and 6041h, and writes the objects of the mode; where one is missing, the SDO transfer is aborted and the axis stays where it is.",
    example: "`DefaultValue=0x00000005` in `[6502]`, which is profile position and profile velocity, and no `[60FF]`",
    remedy: "Describe the object, or take the bit of the mode out of 6502h. Of the real drives that were looked at none lacks an object of its modes; those that lack the words are examples of stacks.",
    source: "CiA 402-2, the object descriptions of the modes; IEC 61800-7-201",

    "cia402/missing-sub-index", Error, Against(missing_entry);
    summary: "a sub-index that an object of a drive has to have is missing",
    checks: "Whether the records and arrays of a drive have the sub-indexes that CiA 402 makes mandatory: both limits of 607Bh and 607Dh, both speeds of 6099h, numerator and divisor of the factors, value and index of 60C2h.",
    why: "A factor without its divisor, or a range with one end, means nothing.",
    example: "`[6099]` with `[6099sub0]` and `[6099sub1]` only",
    remedy: "Describe the missing sub-index.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",

    "cia402/undefined-sub-index", Warning, Against(undefined_sub_index);
    summary: "an object of a drive has a sub-index that CiA 402 does not define",
    checks: "Whether the objects that CiA 402 defines have only its sub-indexes. Parameter sets that it leaves to the manufacturer (60F6h, 60F7h, 60F9h, 60FBh, 6410h, 6510h) may have any.",
    why: "A later version may give the sub-index a meaning, and a master that counts on sub-index 0 reads one value too many.",
    example: "`[607Dsub3]`",
    remedy: "Put what is your own into an object from 2000h on.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",

    "cia402/wrong-access", Warning, Expected(wrong_access), fix Unsafe;
    summary: "an entry of a drive has another access type than CiA 402 gives it",
    checks: "The access types of the objects that CiA 402 defines. `rwr` and `rww` count as `rw`. 6060h may be `wo`, as version 2 had it; ratings, resolutions and factors that a drive cannot change may be `ro`.",
    why: "A master that writes what is read-only, or reads back what is write-only, is refused.",
    example: "`AccessType=wo` in `[6040]`",
    remedy: "Correct the access type. Option codes that are `ro` because the drive knows one reaction only are against the document, but harmless where nobody writes them; hence a warning.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",

    "cia402/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "an entry of a drive has another data type than CiA 402 gives it",
    checks: "The data types of the objects that CiA 402 defines; sub-index 0 is the matter of `cia306/sub-0-type`.",
    why: "A master reads and writes the value with the type of the profile: with another length the transfer is aborted and the mapping is refused; with another sign a speed backwards becomes the largest speed forwards. Of the real drives that were looked at every third has such an entry, mostly 608Fh and 6090h as INTEGER32 or 60FFh as UNSIGNED32, and each of them was against the document.",
    example: "`DataType=0x0007` in `[60FF]`, which is UNSIGNED32 in the place of INTEGER32",
    remedy: "Correct the data type, in the device too; or move an object of your own out of the range of the profile.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",

    "cia402/wrong-mapping", Note, Against(wrong_mapping), fix Unsafe;
    summary: "an entry of a drive that no PDO should carry is marked as mappable",
    checks: "Whether objects that CiA 402 keeps out of PDOs are marked as mappable: option codes, the motor and the drive by name and date, the device types of axes. Parameters that the document keeps out but many drives let in are not looked at.",
    why: "Tools offer the entry for mapping, and the drive is asked to do with every SYNC what is meant to be done once.",
    example: "`PDOMapping=1` in `[605A]`",
    remedy: "Write `PDOMapping=0`, unless the drive really can do it.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",

    "cia402/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of a drive has another object type than CiA 402 gives it",
    checks: "The object types of the objects that CiA 402 defines. A RECORD in the place of an ARRAY, which many drives have for pairs such as 6099h, is a warning: it is found by the same sub-indexes.",
    why: "A VAR in the place of an ARRAY has its value at another sub-index than a master asks for.",
    example: "`ObjectType=0x7` in `[607D]`",
    remedy: "Give the object the type that CiA 402 says.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",

    "cia402/wrong-value", Error, Expected(wrong_value);
    summary: "an entry of a drive has a value that CiA 402 reserves",
    checks: "Whether the value of an entry, configured or default, is one that CiA 402 defines or leaves to the manufacturer: option codes 6007h and 605Ah to 605Eh, modes 6060h and 6061h, profile types 6086h and 6088h, homing method 6098h, jerk use 60A3h, index of the interpolation time 60C2h, buffer organization 60C4h.",
    why: "A drive refuses the value, or does what its maker thought of and nobody else knows: a quick stop that does not stop.",
    example: "`DefaultValue=9` in `[605A]`, where 8 is the last that is defined",
    remedy: "Use a defined value, or a negative one, which belongs to the manufacturer.",
    source: "CiA 402-2, IEC 61800-7-201 §7 to §16",
}

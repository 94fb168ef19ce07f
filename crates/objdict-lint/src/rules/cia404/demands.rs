//! The requirements of CiA 404: one row per rule that uses a check of [`crate::demands`].

use crate::demands::{undefined_sub_index, wrong_access, wrong_data_type, wrong_object_type};
use crate::rule::rules;

rules! {
    source: "CiA 404-1, the object descriptions";

    "cia404/undefined-sub-index", Warning, Against(undefined_sub_index);
    summary: "an object of a measuring device has more channels than CiA 404 defines",
    checks: "The objects that CiA 404 defines must have only channels 1 to 199.",
    why: "Sub-indexes above C7h are not channels, so tools do not look for values there.",
    example: "`[7130subC8]`",
    remedy: "Move manufacturer-specific values to an object from 2000h on.",

    "cia404/wrong-access", Warning, Expected(wrong_access), fix Unsafe;
    summary: "the access type of a measuring device's channel differs from CiA 404",
    checks: "The rule compares access types with CiA 404 for the objects that it defines, where two sources agree. `rwr` and `rww` are treated as `rw`.",
    why: "Tools offer to write a measured value that is not `ro`, and a limit that is `ro` cannot be set.",
    example: "`AccessType=rw` in `[7130sub1]`",
    remedy: "Correct the access type.",

    "cia404/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "the data type of a measuring device's channel differs from CiA 404",
    checks: "The rule compares data types with CiA 404 for the objects that it defines. Field values and process values are REAL32 from 6000h on, INTEGER16 from 7000h, INTEGER24 from 8000h and INTEGER32 from 9000h. Objects for which the sources disagree are not checked.",
    why: "The index determines the type: a master that reads 7130h interprets two bytes as INTEGER16.",
    example: "`DataType=0x0008` in `[7130sub1]`: REAL32 in the range of INTEGER16",
    remedy: "Move the object to the range of its type, such as 6130h for REAL32, or correct the type.",

    "cia404/wrong-object-type", Error, Against(wrong_object_type);
    summary: "the object type of a measuring device's object differs from CiA 404",
    checks: "The rule compares object types with CiA 404 for the objects that it defines. A RECORD instead of an ARRAY is a warning because its channels have the same sub-indexes.",
    why: "A VAR has its value at sub-index 0, but a master reads sub-index 1.",
    example: "`ObjectType=0x7` in `[7130]`",
    remedy: "Make it an ARRAY with one sub-index per channel, even for a single channel.",
}

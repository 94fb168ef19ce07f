//! What CiA 404 demands: a row for each rule that is a page for a look of [`crate::demands`].

use crate::demands::{undefined_sub_index, wrong_access, wrong_data_type, wrong_object_type};
use crate::rule::demands;

demands! {
    "cia404/undefined-sub-index", Warning, Against(undefined_sub_index);
    summary: "an object of a measuring device has more channels than CiA 404 knows",
    checks: "Whether the objects that CiA 404 defines have channels 1 to 199 only.",
    why: "Sub-indexes above C7h are no channels, so no tool looks for values there.",
    example: "`[7130subC8]`",
    remedy: "Put what is your own into an object from 2000h on.",
    source: "CiA 404-1, the object descriptions",

    "cia404/wrong-access", Warning, Expected(wrong_access), fix Unsafe;
    summary: "a channel of a measuring device has another access type than CiA 404 gives it",
    checks: "The access types of the objects that CiA 404 defines, where two sources agree. `rwr` and `rww` count as `rw`.",
    why: "A measured value that can be written is no measured value, and a limit that cannot be written is set by nobody.",
    example: "`AccessType=rw` in `[7130sub1]`",
    remedy: "Correct the access type.",
    source: "CiA 404-1, the object descriptions",

    "cia404/wrong-data-type", Error, Expected(wrong_data_type), fix Unsafe;
    summary: "a channel of a measuring device has another data type than CiA 404 gives it",
    checks: "The data types of the objects that CiA 404 defines. Field values and process values are REAL32 from 6000h on, INTEGER16 from 7000h, INTEGER24 from 8000h and INTEGER32 from 9000h. Objects for which our sources do not agree are not looked at.",
    why: "The index says the type: a master that reads 7130h takes two bytes for an INTEGER16.",
    example: "`DataType=0x0008` in `[7130sub1]`, which is REAL32 in the range of INTEGER16",
    remedy: "Move the object to the range of its type, such as 6130h for REAL32, or correct the type.",
    source: "CiA 404-1, the object descriptions",

    "cia404/wrong-object-type", Error, Against(wrong_object_type);
    summary: "an object of a measuring device has another object type than CiA 404 gives it",
    checks: "The object types of the objects that CiA 404 defines. A RECORD in the place of an ARRAY is a warning: its channels are found by the same sub-indexes.",
    why: "A VAR in the place of an ARRAY has its value at another sub-index than a master asks for.",
    example: "`ObjectType=0x7` in `[7130]`",
    remedy: "Make it an ARRAY with a sub-index for each channel, also where there is one channel only.",
    source: "CiA 404-1, the object descriptions",
}

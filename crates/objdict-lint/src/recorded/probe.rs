//! The rules about the responses of a device.

use objdict_model::diagnostic::text_rules;

text_rules! {
    source: "CiA 301 §7.2.4.3.17";

    "probe/absent" = ABSENT, Error;
    summary: "the device lacks an entry of its description",
    checks: "The device must not respond to a request for a described entry with 0602 0000h (no object) or 0609 0011h (no sub-index). Sub-indexes above the device's own highest sub-index belong to `probe/highest-sub-index`. Sub-indexes of the error history (1003h) are empty if there is no error.",
    why: "A tool that configures the device from its description fails at this entry.",
    example: "1017h is described, and reading it is aborted with 0602 0000h",
    remedy: "Remove the entry from the description, or add it to the device.",

    "probe/undescribed" = UNDESCRIBED, Warning;
    summary: "the device has an entry that is not described",
    checks: "Each entry that responds with a value or accepts one must be in the description.",
    why: "Tools cannot use the entry, and the description belongs to a different firmware version.",
    example: "1018h has four entries in the description, and sub-index 5 answers",
    remedy: "Describe the entry, or respond with 0602 0000h or 0609 0011h.",
    source: "CiA 306-1 §4.6.3",

    "probe/no-answer" = NO_ANSWER, Error;
    summary: "a request gets no response",
    checks: "The device must respond to each request with a value or an abort code.",
    why: "Clients wait until they time out and then stop or retry.",
    example: "a server that ignores requests for entries that it does not have",
    remedy: "Respond to each request; an abort code gives the reason. If nothing responds, check node-ID and bit rate.",
    source: "CiA 301 §7.2.4.2",

    "probe/wrong-size" = WRONG_SIZE, Error;
    summary: "a value's size differs from its data type",
    checks: "Each value must have the number of bytes that its `DataType` requires.",
    why: "A client that reads the entry by its description reads a wrong number or rejects the response; a PDO that maps it has a different length.",
    example: "two bytes for an entry that is described as UNSIGNED32",
    remedy: "Correct `DataType` or the device's response.",
    source: "CiA 301 §7.2.4.3.6",

    "probe/invalid-value" = INVALID_VALUE, Error;
    summary: "a value is not valid for its data type",
    checks: "A BOOLEAN must be 0 or 1, and a VISIBLE_STRING must be ASCII. A UNICODE_STRING must have whole characters, and a REAL must be a number. A string that a test bench recorded must be a value of the type.",
    why: "The entry's type differs from the description, or the device has no value there.",
    example: "the byte 2 for a BOOLEAN",
    remedy: "Correct `DataType` or the device's value.",
    source: "CiA 301 §7.1.4",

    "probe/outside-limits" = OUTSIDE_LIMITS, Error;
    summary: "a value is outside its limits",
    checks: "Each value read must be within `LowLimit` and `HighLimit`.",
    why: "A tool that reads all values and writes them back gets an abort.",
    example: "120 for an entry with `HighLimit=100`",
    remedy: "Correct the limits or the device's value.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/other-value" = OTHER_VALUE, Error;
    summary: "a constant differs from its described value",
    checks: "Entries with `AccessType=const` must have their described values. So must the device type (1000h) and the vendor-ID, product code and revision number (1018h).",
    why: "The description belongs to a different device or version; a manager that compares the identity does not start the node.",
    example: "the revision number 00010002h where 00010001h is described",
    remedy: "Use the description of this version, or correct the value.",
    source: "CiA 301 §7.5.2.19; CiA 302-2 §5.3",

    "probe/other-default" = OTHER_DEFAULT, Warning;
    summary: "a value differs from the described one",
    checks: "An entry must have its `DefaultValue`, or in a DCF its `ParameterValue`. Mappable entries carry process data and are not compared, and neither are errors (1001h to 1003h), commands and the serial number. An entry that was written before is compared with the written value (`probe/other-than-written`). After a reset it is compared with the default again, unless the parameters were saved (1010h).",
    why: "If defaults differ from the description, a tool skips downloads that are needed. The value may also have been changed and stored; in this case, restore the defaults (1011h) before probing.",
    example: "1000 ms in 1017h where 500 ms are described",
    remedy: "Correct the description, restore the defaults of the device, or configure it.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/highest-sub-index" = HIGHEST_SUB_INDEX, Error;
    summary: "an object's number of sub-indexes differs from the description",
    checks: "Sub-index 0 of an array or record must have the described value if it is not writable.",
    why: "Clients read or configure the sub-indexes up to this number.",
    example: "1018h with a highest sub-index of 3 where 4 is described",
    remedy: "Correct the description or the device's value.",
    source: "CiA 301 §7.4.2",

    "probe/not-readable" = NOT_READABLE, Error;
    summary: "an entry described as readable is not readable",
    checks: "Reading an entry with a readable `AccessType` must not be aborted. 0800 0024h (no data) and 060A 0023h (not available) are accepted if the description has no value, and in the error history (1003h).",
    why: "A tool that reads the device from its description reports an error.",
    example: "`AccessType=rw`, and reading is aborted with 0601 0001h (write-only)",
    remedy: "Correct `AccessType` or the device.",

    "probe/readable" = READABLE, Warning;
    summary: "an entry described as write-only is readable",
    checks: "Reading an entry with `AccessType=wo` must be aborted.",
    why: "Tools cannot show the value, and a write-only value may be secret.",
    example: "`AccessType=wo`, and reading it returns four bytes",
    remedy: "Write `AccessType=rw`, or abort with 0601 0001h.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/not-writable" = NOT_WRITABLE, Error;
    summary: "an entry described as writable is not writable",
    checks: "Writing an entry with a writable `AccessType` must not be aborted with 0601 0002h (read-only) or 0601 0000h (unsupported access).",
    why: "The configuration of the node fails at this entry.",
    example: "`AccessType=rw`, and writing is aborted with 0601 0002h",
    remedy: "Write `AccessType=ro`, or make the entry writable.",

    "probe/writable" = WRITABLE, Error;
    summary: "an entry described as not writable is writable",
    checks: "Writing an entry with `AccessType` ro or const must be aborted.",
    why: "Any client can change values that the description declares fixed; a tool cannot set values that are parameters.",
    example: "`AccessType=const`, and writing it is accepted",
    remedy: "Abort with 0601 0002h, or write `AccessType=rw`.",

    "probe/refused-value" = REFUSED_VALUE, Warning;
    summary: "a value within the limits is rejected",
    checks: "The device must accept values of the right size within `LowLimit` and `HighLimit`. Communication objects (1000h to 1FFFh) have further conditions and are not checked.",
    why: "The limits in the description are wider than the device's limits, or the device has a condition that the description does not state.",
    example: "`HighLimit=200`, and 150 is aborted with 0609 0031h",
    remedy: "Correct the limits.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/unchecked-size" = UNCHECKED_SIZE, Warning;
    summary: "a value of the wrong size is accepted",
    checks: "Writing a value with more or fewer bytes than its data type must be aborted.",
    why: "A client with a wrong description writes a different value than intended.",
    example: "three bytes are accepted for an UNSIGNED16",
    remedy: "Abort with 0607 0012h or 0607 0013h, or correct `DataType`.",

    "probe/unchecked-limit" = UNCHECKED_LIMIT, Warning;
    summary: "a value outside the limits is accepted",
    checks: "Writing a value below `LowLimit` or above `HighLimit` must be aborted.",
    why: "The limits in the description are narrower than the device's limits, or the device does not check them.",
    example: "`HighLimit=100`, and 101 is accepted",
    remedy: "Abort with 0609 0031h or 0609 0032h, or correct the limits.",

    "probe/wrong-abort" = WRONG_ABORT, Warning;
    summary: "a request is aborted with the wrong abort code",
    checks: "A request that must be aborted must get the abort code for its reason: 0602 0000h, 0609 0011h, 0601 0001h or 0601 0002h. The codes for sizes are 0607 0010h, 0607 0012h and 0607 0013h. The codes for limits are 0609 0030h, 0609 0031h and 0609 0032h.",
    why: "Users and tools search for the wrong cause.",
    example: "writing 1000h is aborted with 0800 0000h instead of 0601 0002h",
    remedy: "Abort with the code for the reason.",

    "probe/other-than-written" = OTHER_THAN_WRITTEN, Warning;
    summary: "an entry's value differs from the value written",
    checks: "Reading an entry must return the value that was last written and accepted. Mappable entries, commands and communication objects are not compared. Neither are values written before a reset of the node (NMT commands 81h and 82h, boot-up).",
    why: "The device silently rounds or limits the value or does not store it.",
    example: "150 is written and accepted, and 100 is read",
    remedy: "Reject values that cannot be stored, or describe the access as write-only.",
    source: "CiA 301 §7.2.4.1",
}

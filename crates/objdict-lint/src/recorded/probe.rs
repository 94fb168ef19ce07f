//! The rules about the answers of a device.

use objdict_model::diagnostic::text_rules;

text_rules! {
    source: "CiA 301 §7.2.4.3.17";

    "probe/absent" = ABSENT, Error;
    summary: "the device lacks an entry of its description",
    checks: "Whether the device answers no request for a described entry with 0602 0000h (no object) or 0609 0011h (no sub-index). Sub-indexes above the highest one that the device itself states belong to `probe/highest-sub-index`, those of the error history (1003h) are empty as long as there is no error.",
    why: "A tool that configures the device by its description fails at this entry.",
    example: "1017h is described, and reading it is aborted with 0602 0000h",
    remedy: "Remove the entry from the description, or add it to the device.",

    "probe/undescribed" = UNDESCRIBED, Warning;
    summary: "the device has an entry that is not described",
    checks: "Whether an entry that answers with a value, or takes one, is in the description.",
    why: "Tools cannot use the entry, and the description is that of another version of the firmware.",
    example: "1018h has four entries in the description, and sub-index 5 answers",
    remedy: "Describe the entry, or answer with 0602 0000h or 0609 0011h.",
    source: "CiA 306-1 §4.6.3",

    "probe/no-answer" = NO_ANSWER, Error;
    summary: "a request has no answer",
    checks: "Whether the device answers each request, with a value or with an abort code.",
    why: "Clients wait until they time out, and then stop or try again.",
    example: "a server that ignores requests for entries that it does not have",
    remedy: "Answer each request; an abort code gives the reason. If nothing answers, check node-ID and bit rate.",
    source: "CiA 301 §7.2.4.2",

    "probe/wrong-size" = WRONG_SIZE, Error;
    summary: "a value has another size than its data type",
    checks: "Whether each value has as many bytes as its `DataType`.",
    why: "A client that reads the entry by its description takes a wrong number, or rejects the answer; a PDO that maps it has another length.",
    example: "two bytes for an entry that is described as UNSIGNED32",
    remedy: "Correct `DataType`, or the answer of the device.",
    source: "CiA 301 §7.2.4.3.6",

    "probe/invalid-value" = INVALID_VALUE, Error;
    summary: "a value is not valid for its data type",
    checks: "Whether a BOOLEAN is 0 or 1, a VISIBLE_STRING is ASCII, a UNICODE_STRING has whole characters, a REAL is a number, and a text of a bench is a value of the type.",
    why: "The entry has another type than it is described with, or the device has no value there.",
    example: "the byte 2 for a BOOLEAN",
    remedy: "Correct `DataType`, or the value of the device.",
    source: "CiA 301 §7.1.4",

    "probe/outside-limits" = OUTSIDE_LIMITS, Error;
    summary: "a value is outside its limits",
    checks: "Whether each value that is read is within `LowLimit` and `HighLimit`.",
    why: "A tool that reads all values and writes them back is refused.",
    example: "120 for an entry with `HighLimit=100`",
    remedy: "Correct the limits, or the value of the device.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/other-value" = OTHER_VALUE, Error;
    summary: "a constant has another value than described",
    checks: "Whether entries with `AccessType=const`, the device type (1000h) and vendor-ID, product code and revision number (1018h) have their described values.",
    why: "The description belongs to another device or version; a manager that compares the identity does not start the node.",
    example: "the revision number 00010002h where 00010001h is described",
    remedy: "Use the description of this version, or correct the value.",
    source: "CiA 301 §7.5.2.19; CiA 302-2 §5.3",

    "probe/other-default" = OTHER_DEFAULT, Warning;
    summary: "a value differs from the described one",
    checks: "Whether entries have their `DefaultValue`, or in a DCF their `ParameterValue`. Entries that can be mapped carry process data and are not compared, nor are errors (1001h to 1003h), commands and the serial number. An entry that was written before is compared with what was written (`probe/other-than-written`), and after a reset with the default again, unless the parameters were saved (1010h).",
    why: "Defaults that differ from the description make a tool skip downloads that are needed. The value may also have been changed and stored, then restore the defaults (1011h) before probing.",
    example: "1000 ms in 1017h where 500 ms are described",
    remedy: "Correct the description, restore the defaults of the device, or configure it.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/highest-sub-index" = HIGHEST_SUB_INDEX, Error;
    summary: "an object has another number of sub-indexes than described",
    checks: "Whether sub-index 0 of arrays and records has the described value, if it is not writable.",
    why: "Clients read or configure the sub-indexes up to this number.",
    example: "1018h with a highest sub-index of 3 where 4 is described",
    remedy: "Correct the description, or the value of the device.",
    source: "CiA 301 §7.4.2",

    "probe/not-readable" = NOT_READABLE, Error;
    summary: "an entry that is described as readable is not",
    checks: "Whether reading an entry with a readable `AccessType` is not aborted. 0800 0024h (no data) and 060A 0023h (not available) are right where the description has no value and in the error history (1003h).",
    why: "A tool that reads the device by its description reports an error.",
    example: "`AccessType=rw`, and reading is aborted with 0601 0001h (write-only)",
    remedy: "Correct `AccessType`, or the device.",

    "probe/readable" = READABLE, Warning;
    summary: "an entry that is described as write-only is readable",
    checks: "Whether reading an entry with `AccessType=wo` is aborted.",
    why: "Tools cannot show the value, and what is not to be read may be secret.",
    example: "`AccessType=wo`, and reading it returns four bytes",
    remedy: "Write `AccessType=rw`, or abort with 0601 0001h.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/not-writable" = NOT_WRITABLE, Error;
    summary: "an entry that is described as writable is not",
    checks: "Whether writing an entry with a writable `AccessType` is not aborted with 0601 0002h (read-only) or 0601 0000h (unsupported access).",
    why: "The configuration of the node fails at this entry.",
    example: "`AccessType=rw`, and writing is aborted with 0601 0002h",
    remedy: "Write `AccessType=ro`, or make the entry writable.",

    "probe/writable" = WRITABLE, Error;
    summary: "an entry that is described as not writable is",
    checks: "Whether writing an entry with `AccessType` ro or const is aborted.",
    why: "Any client can change what the description says is fixed; a tool cannot set what is a parameter.",
    example: "`AccessType=const`, and writing it is accepted",
    remedy: "Abort with 0601 0002h, or write `AccessType=rw`.",

    "probe/refused-value" = REFUSED_VALUE, Warning;
    summary: "a value within the limits is refused",
    checks: "Whether values of the right size and within `LowLimit` and `HighLimit` are accepted. Objects of communication (1000h to 1FFFh) have further conditions and are not checked.",
    why: "The limits in the description are wider than those of the device, or the device has a condition that the description does not state.",
    example: "`HighLimit=200`, and 150 is aborted with 0609 0031h",
    remedy: "Correct the limits.",
    source: "CiA 306-1 §4.6.3.2",

    "probe/unchecked-size" = UNCHECKED_SIZE, Warning;
    summary: "a value of the wrong size is accepted",
    checks: "Whether writing a value with more or fewer bytes than its data type is aborted.",
    why: "A client with a wrong description changes the value to another one than it means.",
    example: "three bytes are accepted for an UNSIGNED16",
    remedy: "Abort with 0607 0012h or 0607 0013h, or correct `DataType`.",

    "probe/unchecked-limit" = UNCHECKED_LIMIT, Warning;
    summary: "a value outside the limits is accepted",
    checks: "Whether writing a value below `LowLimit` or above `HighLimit` is aborted.",
    why: "The limits in the description are narrower than those of the device, or the device does not check them.",
    example: "`HighLimit=100`, and 101 is accepted",
    remedy: "Abort with 0609 0031h or 0609 0032h, or correct the limits.",

    "probe/wrong-abort" = WRONG_ABORT, Warning;
    summary: "a request is refused with another abort code",
    checks: "Whether what must be refused is refused with the code for its reason: 0602 0000h, 0609 0011h, 0601 0001h, 0601 0002h, for sizes 0607 0010h, 0607 0012h or 0607 0013h, for limits 0609 0030h, 0609 0031h or 0609 0032h.",
    why: "Users and tools search for the wrong cause.",
    example: "writing 1000h is aborted with 0800 0000h instead of 0601 0002h",
    remedy: "Abort with the code for the reason.",

    "probe/other-than-written" = OTHER_THAN_WRITTEN, Warning;
    summary: "an entry has another value than was written",
    checks: "Whether reading an entry returns what was last written and accepted. Entries that can be mapped, commands and objects of communication are not compared, nor is what was written before a reset of the node (NMT commands 81h and 82h, boot-up).",
    why: "The device rounds or limits the value without a word, or does not store it.",
    example: "150 is written and accepted, and 100 is read",
    remedy: "Refuse values that cannot be stored, or describe the access as write-only.",
    source: "CiA 301 §7.2.4.1",
}

//! The rules of the group `portability` about the text of a file.

use crate::diagnostic::text_rules;

text_rules! {
    source: "python-canopen 2.4.1";

    "portability/bare-node-id" = BARE_NODE_ID, Note, fix Safe;
    summary: "a value is `$NODEID` without a number",
    checks: "Reports a value that is only `$NODEID`, without a number.",
    why: "CiA 306 allows this. python-canopen removes `$NODEID`, parses the empty rest as a number and drops the value.",
    example: "`DefaultValue=$NODEID`",
    remedy: "Write `$NODEID+0`.",

    "portability/blanks-after-section" = BLANKS_AFTER_SECTION, Warning, fix Safe;
    summary: "a section header is followed by spaces",
    checks: "Spaces or tabs must not follow a section header. The first one is shown, the others are counted.",
    why: "node-canopen mistakes such a line for a key and reads the keys below into the previous section.",
    example: "`[2240] ` with a space behind it",
    remedy: "Remove the spaces.",
    source: "node-canopen 6.2.1",

    "portability/commented-section" = COMMENTED_SECTION, Warning, fix Safe;
    summary: "keys follow a section header in a comment",
    checks: "A comment of the form `;[name]` must not be followed by a key before the next header. The first one is shown, the others are counted.",
    why: "CANopenEditor removes the `;` before it looks for a header, so the keys below are read into the commented section.",
    example: "`;[1018sub5]` above the keys of the section before",
    remedy: "Write `; [1018sub5]`.",
    source: "CANopenEditor of 2026",

    "portability/dummy-usage" = DUMMY_USAGE, Error, fix Safe;
    summary: "`[DummyUsage]` does not list all types",
    checks: "`[DummyUsage]` must have the keys `Dummy0001` to `Dummy0007`.",
    why: "A missing key means 0. python-canopen reads all seven keys and fails if one is missing.",
    example: "`[DummyUsage]` with `Dummy0005=1` alone",
    remedy: "Add the other keys with 0.",

    "portability/empty-key" = EMPTY_KEY, Error, fix Safe;
    summary: "a key has no value",
    checks: "`ObjectType`, `PDOMapping`, `ObjFlags` and `CompactSubObj` must have a value, and so must the numbers of `[DeviceInfo]`. `AccessType` and `DefaultValue` of an ARRAY or RECORD must have one too. Each key of objects is reported once, at its first place.",
    why: "An empty key is the same as a missing one. python-canopen parses the first two and the numbers of `[DeviceInfo]` and fails; CANopenEditor parses all of an object and skips it. node-canopen mistakes the last two for keys of a value and fails.",
    example: "`PDOMapping=`",
    remedy: "Remove the line.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026, node-canopen 6.2.1",

    "portability/hash-in-text" = HASH_IN_TEXT, Warning;
    summary: "a string contains a `#` after a space",
    checks: "Reports a name, string or other text that contains a `#` after a space.",
    why: "CiA 306 has comments only in separate lines. dcf-tools ends the text before the `#`.",
    example: "`ParameterName=Motor #1`",
    remedy: "Write `Motor no. 1`, or `Motor#1`.",
    source: "dcf-tools 2.4.2",

    "portability/hex-baud-rate" = HEX_BAUD_RATE, Error, fix Safe;
    summary: "the bit rate of a node is written in hex",
    checks: "`Baudrate` in `[DeviceComissioning]` must be a decimal number.",
    why: "CiA 306 allows hex numbers everywhere. python-canopen parses the bit rate as decimal and fails.",
    example: "`Baudrate=0xFA`",
    remedy: "Write the number in decimal.",

    "portability/hex-count" = HEX_COUNT, Error, fix Safe;
    summary: "a count is written in hex",
    checks: "`SupportedObjects` of an object list and `NrOfEntries` of `[xxxxName]` and `[xxxxValue]` must be decimal numbers.",
    why: "CiA 306 allows hex numbers everywhere. dcf-tools parses these counts as decimal and rejects the file; python-canopen fails at the count of `[xxxxName]`.",
    example: "`SupportedObjects=0x12`",
    remedy: "Write the number in decimal.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",

    "portability/hex-flag" = HEX_FLAG, Error, fix Safe;
    summary: "a flag is written in hex",
    checks: "Keys of `[DeviceInfo]` and `[DummyUsage]` with value 0 or 1 must be written as `0` or `1`.",
    why: "CANopenEditor reads everything but `1` as no. python-canopen and dcf-tools fail at a hex number in `[DummyUsage]`.",
    example: "`BaudRate_250=0x1`",
    remedy: "Write `0` or `1`.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/key-case" = KEY_CASE, Error, fix Safe;
    summary: "the case of a key differs from the standard",
    checks: "Each key must have the case of the standard. The first one is shown, the others are counted.",
    why: "CiA 306 ignores case. python-canopen and CANopenEditor compare case-sensitively and do not find the key: python-canopen fails if the key is a name, data type or access, and CANopenEditor skips the object.",
    example: "`parametername=Speed`",
    remedy: "Write `ParameterName`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/limit-not-read" = LIMIT_NOT_READ, Note;
    summary: "a tool does not read a limit",
    checks: "Reports a limit that is a formula, a REAL with a decimal point, or of type INTEGER24, 40, 48 or 56. The first one is shown, the others are counted.",
    why: "python-canopen reads limits of 8, 16, 32 and 64 bits and ignores others: it then accepts any value.",
    example: "`HighLimit=1.5` of a REAL32",
    remedy: "Check the value in the application.",

    "portability/negative-hex" = NEGATIVE_HEX, Error, fix Safe;
    summary: "a value is a negative hex number",
    checks: "An integer value must not have both a sign and hex notation. The first one is shown, the others are counted.",
    why: "node-canopen converts the text with JavaScript's number syntax, where hex numbers have no sign: it reads 0 and rejects the file if the integer has 64 bits.",
    example: "`DefaultValue=-0x10`",
    remedy: "Write the number in decimal.",
    source: "node-canopen 6.2.1",

    "portability/real-as-decimal" = REAL_AS_DECIMAL, Error, fix Safe;
    summary: "a REAL is written as a decimal number",
    checks: "A value or limit of a REAL32 or REAL64 must be the hex digits of its bits, or 0. The first one is shown, the others are counted.",
    why: "CiA 306 does not define the notation of a REAL. dcf-tools reads bits: it rejects `1.5` and `-2` and reads `2` as 2.8e-45. python-canopen reads numbers, so only `0` works for both.",
    example: "`DefaultValue=1.5`",
    remedy: "Write `0x3FC00000` in a separate copy for dcf-tools. The fix does so unless python-canopen also reads the file.",
    source: "dcf-tools 2.4.2",

    "portability/section-case" = SECTION_CASE, Error, fix Safe;
    summary: "the case of a section name differs from the standard",
    checks: "Each section name must have the case of the standard; hex digits of an index may have any case. The first one is shown, the others are counted.",
    why: "CiA 306 ignores case. python-canopen and CANopenEditor compare case-sensitively: they do not find sub-indexes in `[1018SUB1]`, and without `[DeviceInfo]` CANopenEditor does not open the file.",
    example: "`[1018SUB1]`, `[deviceinfo]`",
    remedy: "Write `[1018sub1]`, `[DeviceInfo]`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/semicolon-in-text" = SEMICOLON_IN_TEXT, Warning;
    summary: "a string contains a `;` after a space",
    checks: "Reports a name, string or other text that contains a `;` after a space.",
    why: "CiA 306 has comments only in separate lines. dcf-tools and python-canopen end the text before the `;`.",
    example: "`ParameterName=Speed ; rpm`",
    remedy: "Write `Speed, rpm`.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",

    "portability/sparse-names" = SPARSE_NAMES, Error, fix Safe;
    summary: "the names of a compact object have a gap",
    checks: "`[xxxxName]` must name all sub-indexes from 1 to the number of names.",
    why: "CiA 306 allows missing names, which have a default. python-canopen reads the given number of names from 1 on and fails at the gap.",
    example: "`NrOfEntries=2` with `1=Left` and `3=Right`",
    remedy: "Add the missing names with the default of the standard: the name of the object followed by the sub-index.",

    "portability/sub-before-object" = SUB_BEFORE_OBJECT, Error;
    summary: "a sub-index is before its object",
    checks: "The section of an object must be above the sections of its sub-indexes and above its `[xxxxName]`.",
    why: "CiA 306 requires no order. python-canopen fails at a sub-index whose object is below it, and CANopenEditor skips it.",
    example: "`[2000sub0]` above `[2000]`",
    remedy: "Move the object above its sub-indexes.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",

    "portability/unloadable" = UNLOADABLE, Error;
    summary: "a reader that creates a dictionary from the file stops",
    checks: "Each line of the object lists needs a section with a name. Each structure needs either `SubNumber` or `CompactSubObj`. Each entry needs a data type and an access of CiA 301, and its values must begin as values of its type. The node-ID must be valid, and `LSS_SerialNumber` requires 1018h:04. The first place where the reader stops is shown.",
    why: "The C library of Lely core reads a file at run time, as the dictionary of a master or a slave. It does not load the file at all if an entry is not as expected. It knows neither the data types of the device nor `$NODEID` without a number.",
    example: "`LSS_SerialNumber=0` without `[1018sub4]`; `AccessType=r/w`",
    remedy: "Correct the entry, or use a copy without it for the tool.",
    source: "Lely core 2.4, src/co/dcf.c",

    "portability/unquoted-string" = UNQUOTED_STRING, Error;
    summary: "a string has no quotes",
    checks: "A value of type VISIBLE_STRING or UNICODE_STRING must be in quotes. The first one is shown, the others are counted.",
    why: "CiA 306 and all other tools use strings without quotes. dcf2dev of dcf-tools parses the text as a Python literal and fails; dcfchk and dcfgen do not read it.",
    example: "`DefaultValue=Pump controller`",
    remedy: "Put the text in quotes in a separate copy for dcf2dev.",
    source: "dcf-tools 2.4.2",
}

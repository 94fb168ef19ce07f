//! What the rules of the group `portability` about the text are.

use crate::diagnostic::{RuleInfo, text_rule};

/// Every rule of this module.
pub static RULES: &[&RuleInfo] = &[
    &BARE_NODE_ID,
    &COMMENTED_SECTION,
    &DUMMY_USAGE,
    &EMPTY_KEY,
    &HASH_IN_TEXT,
    &HEX_BAUD_RATE,
    &HEX_COUNT,
    &HEX_FLAG,
    &KEY_CASE,
    &LIMIT_NOT_READ,
    &REAL_AS_DECIMAL,
    &SECTION_CASE,
    &SEMICOLON_IN_TEXT,
    &SPARSE_NAMES,
    &SUB_BEFORE_OBJECT,
    &UNQUOTED_STRING,
];

text_rule! {
    BARE_NODE_ID = "portability/bare-node-id", Note, fix Safe;
    summary: "the node-ID is a value without a number to add",
    checks: "Whether a value is `$NODEID` alone.",
    why: "CiA 306 allows it. python-canopen removes `$NODEID` and makes a number of what is left: of nothing, so the value is lost.",
    example: "`DefaultValue=$NODEID`",
    remedy: "Write `$NODEID+0`.",
    source: "python-canopen 2.4.1",
}

text_rule! {
    COMMENTED_SECTION = "portability/commented-section", Warning, fix Safe;
    summary: "the header of a section stands in a comment, and keys follow",
    checks: "Whether a comment is `;[name]` and a key follows before the next header. The first one is shown, the others are counted.",
    why: "CANopenEditor removes the `;` before it looks for a header, so the keys below go to the section in the comment.",
    example: "`;[1018sub5]` above the keys of the section before",
    remedy: "Write `; [1018sub5]`.",
    source: "CANopenEditor of 2026",
}

text_rule! {
    DUMMY_USAGE = "portability/dummy-usage", Warning, fix Safe;
    summary: "`[DummyUsage]` does not speak of all types",
    checks: "Whether `[DummyUsage]` has the keys `Dummy0001` to `Dummy0007`.",
    why: "A missing key means 0. python-canopen asks for all seven and stops where one is missing.",
    example: "`[DummyUsage]` with `Dummy0005=1` alone",
    remedy: "Add the other keys with 0.",
    source: "python-canopen 2.4.1",
}

text_rule! {
    EMPTY_KEY = "portability/empty-key", Warning, fix Safe;
    summary: "a key of an object has no value",
    checks: "Whether `ObjectType`, `PDOMapping`, `ObjFlags` or `CompactSubObj` stands without a value. Each key is reported once, at its first place.",
    why: "An empty key means what its absence means. python-canopen makes a number of the first two and stops there; CANopenEditor makes one of each and skips the object.",
    example: "`PDOMapping=`",
    remedy: "Remove the line.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

text_rule! {
    HASH_IN_TEXT = "portability/hash-in-text", Warning;
    summary: "a text has a `#` behind a blank",
    checks: "Whether a name, a string or another text has a `#` with a blank before it.",
    why: "CiA 306 has comments in lines of their own only. To dcf-tools the text ends before the `#`.",
    example: "`ParameterName=Motor #1`",
    remedy: "Write `Motor no. 1`, or `Motor#1`.",
    source: "dcf-tools 2.4.2",
}

text_rule! {
    HEX_BAUD_RATE = "portability/hex-baud-rate", Warning, fix Safe;
    summary: "the bit rate of a node is written in hex",
    checks: "Whether `Baudrate` in `[DeviceComissioning]` is a decimal number.",
    why: "CiA 306 allows hex numbers everywhere. python-canopen reads this one in decimal and stops.",
    example: "`Baudrate=0xFA`",
    remedy: "Write the number in decimal.",
    source: "python-canopen 2.4.1",
}

text_rule! {
    HEX_COUNT = "portability/hex-count", Warning, fix Safe;
    summary: "a count is written in hex",
    checks: "Whether `SupportedObjects` of an object list and `NrOfEntries` of `[xxxxName]` and `[xxxxValue]` are decimal numbers.",
    why: "CiA 306 allows hex numbers everywhere. dcf-tools reads these in decimal and refuses the file, python-canopen stops at that of `[xxxxName]`.",
    example: "`SupportedObjects=0x12`",
    remedy: "Write the number in decimal.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

text_rule! {
    HEX_FLAG = "portability/hex-flag", Warning, fix Safe;
    summary: "a yes or no is written in hex",
    checks: "Whether the keys of `[DeviceInfo]` and `[DummyUsage]` that are 0 or 1 are written so.",
    why: "CANopenEditor takes everything but `1` for no. python-canopen and dcf-tools stop at a hex number in `[DummyUsage]`.",
    example: "`BaudRate_250=0x1`",
    remedy: "Write `0` or `1`.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026",
}

text_rule! {
    KEY_CASE = "portability/key-case", Warning, fix Safe;
    summary: "a key is not written as the standard has it",
    checks: "Whether each key has the capital and small letters of the standard. The first one is shown, the others are counted.",
    why: "The case of letters is free. python-canopen and CANopenEditor compare letter by letter, so they do not see the key: python-canopen stops where it is a name, data type or access, CANopenEditor skips the object.",
    example: "`parametername=Speed`",
    remedy: "Write `ParameterName`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

text_rule! {
    LIMIT_NOT_READ = "portability/limit-not-read", Note;
    summary: "a limit that a tool does not read",
    checks: "Whether a limit is a formula, a REAL with a decimal point, or one of an INTEGER24, 40, 48 or 56. The first one is shown, the others are counted.",
    why: "python-canopen reads limits as numbers of 8, 16, 32 and 64 bits and forgets what is none: any value is allowed then.",
    example: "`HighLimit=1.5` of a REAL32",
    remedy: "Check the value where it is written.",
    source: "python-canopen 2.4.1",
}

text_rule! {
    REAL_AS_DECIMAL = "portability/real-as-decimal", Warning;
    summary: "a REAL is written as a number",
    checks: "Whether a value or limit of a REAL32 or REAL64 is something else than the hex digits of its bits, or 0. The first one is shown, the others are counted.",
    why: "CiA 306 does not say how a REAL is written. dcf-tools takes it for bits: it refuses `1.5`, and reads `2` as 2.8e-45. python-canopen reads numbers, so no spelling but `0` is right for both.",
    example: "`DefaultValue=1.5`",
    remedy: "Write `0x3FC00000` in a copy for dcf-tools alone.",
    source: "dcf-tools 2.4.2",
}

text_rule! {
    SECTION_CASE = "portability/section-case", Warning, fix Safe;
    summary: "a section is not named as the standard has it",
    checks: "Whether each name of a section has the capital and small letters of the standard; the digits of an index are free. The first one is shown, the others are counted.",
    why: "The case of letters is free. python-canopen and CANopenEditor compare letter by letter: sub-indexes in `[1018SUB1]` are gone, and without `[DeviceInfo]` CANopenEditor does not open the file.",
    example: "`[1018SUB1]`, `[deviceinfo]`",
    remedy: "Write `[1018sub1]`, `[DeviceInfo]`.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

text_rule! {
    SEMICOLON_IN_TEXT = "portability/semicolon-in-text", Warning;
    summary: "a text has a `;` behind a blank",
    checks: "Whether a name, a string or another text has a `;` with a blank before it.",
    why: "CiA 306 has comments in lines of their own only. To dcf-tools and python-canopen the text ends before the `;`.",
    example: "`ParameterName=Speed ; rpm`",
    remedy: "Write `Speed, rpm`.",
    source: "dcf-tools 2.4.2, python-canopen 2.4.1",
}

text_rule! {
    SPARSE_NAMES = "portability/sparse-names", Warning, fix Safe;
    summary: "the names of a compact object have a gap",
    checks: "Whether `[xxxxName]` names all sub-indexes from 1 to as many as it has names.",
    why: "CiA 306 lets a name out where the standard one will do. python-canopen asks for as many names as there are, from 1 on, and stops at the gap.",
    example: "`NrOfEntries=2` with `1=Left` and `3=Right`",
    remedy: "Name the others too, as the standard does: the name of the object with the sub-index behind it.",
    source: "python-canopen 2.4.1",
}

text_rule! {
    SUB_BEFORE_OBJECT = "portability/sub-before-object", Warning;
    summary: "a sub-index stands before its object",
    checks: "Whether the section of each object stands above those of its sub-indexes, and above its `[xxxxName]`.",
    why: "CiA 306 asks for no order. python-canopen stops at a sub-index whose object it has not met, CANopenEditor skips it.",
    example: "`[2000sub0]` above `[2000]`",
    remedy: "Put the object above its sub-indexes.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

text_rule! {
    UNQUOTED_STRING = "portability/unquoted-string", Warning;
    summary: "a string has no quotes",
    checks: "Whether a value of type VISIBLE_STRING or UNICODE_STRING stands in quotes. The first one is shown, the others are counted.",
    why: "CiA 306 has strings without quotes, and so have all other tools. dcf2dev of dcf-tools takes the text for a literal of Python and stops; dcfchk and dcfgen do not look at it.",
    example: "`DefaultValue=Pump controller`",
    remedy: "Put the text in quotes in a copy for dcf2dev alone.",
    source: "dcf-tools 2.4.2",
}

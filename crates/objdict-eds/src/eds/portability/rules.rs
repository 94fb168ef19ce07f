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
    /// the node-ID is a value without a number to add
    ///
    /// ## What it checks
    /// Whether a value is `$NODEID` alone.
    ///
    /// ## Why it matters
    /// CiA 306 allows it. python-canopen removes `$NODEID` and makes a number of what is left: of nothing, so the value is lost.
    ///
    /// ## Example
    /// `DefaultValue=$NODEID`
    ///
    /// ## How to mend
    /// Write `$NODEID+0`.
    ///
    /// ## Source
    /// python-canopen 2.4.1
    BARE_NODE_ID = "portability/bare-node-id", Note, fix Safe
}

text_rule! {
    /// the header of a section stands in a comment, and keys follow
    ///
    /// ## What it checks
    /// Whether a comment is `;[name]` and a key follows before the next header. The first one is shown, the others are counted.
    ///
    /// ## Why it matters
    /// CANopenEditor removes the `;` before it looks for a header, so the keys below go to the section in the comment.
    ///
    /// ## Example
    /// `;[1018sub5]` above the keys of the section before
    ///
    /// ## How to mend
    /// Write `; [1018sub5]`.
    ///
    /// ## Source
    /// CANopenEditor of 2026
    COMMENTED_SECTION = "portability/commented-section", Warning, fix Safe
}

text_rule! {
    /// `[DummyUsage]` does not speak of all types
    ///
    /// ## What it checks
    /// Whether `[DummyUsage]` has the keys `Dummy0001` to `Dummy0007`.
    ///
    /// ## Why it matters
    /// A missing key means 0. python-canopen asks for all seven and stops where one is missing.
    ///
    /// ## Example
    /// `[DummyUsage]` with `Dummy0005=1` alone
    ///
    /// ## How to mend
    /// Add the other keys with 0.
    ///
    /// ## Source
    /// python-canopen 2.4.1
    DUMMY_USAGE = "portability/dummy-usage", Warning, fix Safe
}

text_rule! {
    /// a key of an object has no value
    ///
    /// ## What it checks
    /// Whether `ObjectType`, `PDOMapping`, `ObjFlags` or `CompactSubObj` stands without a value. Each key is reported once, at its first place.
    ///
    /// ## Why it matters
    /// An empty key means what its absence means. python-canopen makes a number of the first two and stops there; CANopenEditor makes one of each and skips the object.
    ///
    /// ## Example
    /// `PDOMapping=`
    ///
    /// ## How to mend
    /// Remove the line.
    ///
    /// ## Source
    /// python-canopen 2.4.1, CANopenEditor of 2026
    EMPTY_KEY = "portability/empty-key", Warning, fix Safe
}

text_rule! {
    /// a text has a `#` behind a blank
    ///
    /// ## What it checks
    /// Whether a name, a string or another text has a `#` with a blank before it.
    ///
    /// ## Why it matters
    /// CiA 306 has comments in lines of their own only. To dcf-tools the text ends before the `#`.
    ///
    /// ## Example
    /// `ParameterName=Motor #1`
    ///
    /// ## How to mend
    /// Write `Motor no. 1`, or `Motor#1`.
    ///
    /// ## Source
    /// dcf-tools 2.4.2
    HASH_IN_TEXT = "portability/hash-in-text", Warning
}

text_rule! {
    /// the bit rate of a node is written in hex
    ///
    /// ## What it checks
    /// Whether `Baudrate` in `[DeviceComissioning]` is a decimal number.
    ///
    /// ## Why it matters
    /// CiA 306 allows hex numbers everywhere. python-canopen reads this one in decimal and stops.
    ///
    /// ## Example
    /// `Baudrate=0xFA`
    ///
    /// ## How to mend
    /// Write the number in decimal.
    ///
    /// ## Source
    /// python-canopen 2.4.1
    HEX_BAUD_RATE = "portability/hex-baud-rate", Warning, fix Safe
}

text_rule! {
    /// a count is written in hex
    ///
    /// ## What it checks
    /// Whether `SupportedObjects` of an object list and `NrOfEntries` of `[xxxxName]` and `[xxxxValue]` are decimal numbers.
    ///
    /// ## Why it matters
    /// CiA 306 allows hex numbers everywhere. dcf-tools reads these in decimal and refuses the file, python-canopen stops at that of `[xxxxName]`.
    ///
    /// ## Example
    /// `SupportedObjects=0x12`
    ///
    /// ## How to mend
    /// Write the number in decimal.
    ///
    /// ## Source
    /// dcf-tools 2.4.2, python-canopen 2.4.1
    HEX_COUNT = "portability/hex-count", Warning, fix Safe
}

text_rule! {
    /// a yes or no is written in hex
    ///
    /// ## What it checks
    /// Whether the keys of `[DeviceInfo]` and `[DummyUsage]` that are 0 or 1 are written so.
    ///
    /// ## Why it matters
    /// CANopenEditor takes everything but `1` for no. python-canopen and dcf-tools stop at a hex number in `[DummyUsage]`.
    ///
    /// ## Example
    /// `BaudRate_250=0x1`
    ///
    /// ## How to mend
    /// Write `0` or `1`.
    ///
    /// ## Source
    /// dcf-tools 2.4.2, python-canopen 2.4.1, CANopenEditor of 2026
    HEX_FLAG = "portability/hex-flag", Warning, fix Safe
}

text_rule! {
    /// a key is not written as the standard has it
    ///
    /// ## What it checks
    /// Whether each key has the capital and small letters of the standard. The first one is shown, the others are counted.
    ///
    /// ## Why it matters
    /// The case of letters is free. python-canopen and CANopenEditor compare letter by letter, so they do not see the key: python-canopen stops where it is a name, data type or access, CANopenEditor skips the object.
    ///
    /// ## Example
    /// `parametername=Speed`
    ///
    /// ## How to mend
    /// Write `ParameterName`.
    ///
    /// ## Source
    /// python-canopen 2.4.1, CANopenEditor of 2026
    KEY_CASE = "portability/key-case", Warning, fix Safe
}

text_rule! {
    /// a limit that a tool does not read
    ///
    /// ## What it checks
    /// Whether a limit is a formula, a REAL with a decimal point, or one of an INTEGER24, 40, 48 or 56. The first one is shown, the others are counted.
    ///
    /// ## Why it matters
    /// python-canopen reads limits as numbers of 8, 16, 32 and 64 bits and forgets what is none: any value is allowed then.
    ///
    /// ## Example
    /// `HighLimit=1.5` of a REAL32
    ///
    /// ## How to mend
    /// Check the value where it is written.
    ///
    /// ## Source
    /// python-canopen 2.4.1
    LIMIT_NOT_READ = "portability/limit-not-read", Note
}

text_rule! {
    /// a REAL is written as a number
    ///
    /// ## What it checks
    /// Whether a value or limit of a REAL32 or REAL64 is something else than the hex digits of its bits, or 0. The first one is shown, the others are counted.
    ///
    /// ## Why it matters
    /// CiA 306 does not say how a REAL is written. dcf-tools takes it for bits: it refuses `1.5`, and reads `2` as 2.8e-45. python-canopen reads numbers, so no spelling but `0` is right for both.
    ///
    /// ## Example
    /// `DefaultValue=1.5`
    ///
    /// ## How to mend
    /// Write `0x3FC00000` in a copy for dcf-tools alone.
    ///
    /// ## Source
    /// dcf-tools 2.4.2
    REAL_AS_DECIMAL = "portability/real-as-decimal", Warning
}

text_rule! {
    /// a section is not named as the standard has it
    ///
    /// ## What it checks
    /// Whether each name of a section has the capital and small letters of the standard; the digits of an index are free. The first one is shown, the others are counted.
    ///
    /// ## Why it matters
    /// The case of letters is free. python-canopen and CANopenEditor compare letter by letter: sub-indexes in `[1018SUB1]` are gone, and without `[DeviceInfo]` CANopenEditor does not open the file.
    ///
    /// ## Example
    /// `[1018SUB1]`, `[deviceinfo]`
    ///
    /// ## How to mend
    /// Write `[1018sub1]`, `[DeviceInfo]`.
    ///
    /// ## Source
    /// python-canopen 2.4.1, CANopenEditor of 2026
    SECTION_CASE = "portability/section-case", Warning, fix Safe
}

text_rule! {
    /// a text has a `;` behind a blank
    ///
    /// ## What it checks
    /// Whether a name, a string or another text has a `;` with a blank before it.
    ///
    /// ## Why it matters
    /// CiA 306 has comments in lines of their own only. To dcf-tools and python-canopen the text ends before the `;`.
    ///
    /// ## Example
    /// `ParameterName=Speed ; rpm`
    ///
    /// ## How to mend
    /// Write `Speed, rpm`.
    ///
    /// ## Source
    /// dcf-tools 2.4.2, python-canopen 2.4.1
    SEMICOLON_IN_TEXT = "portability/semicolon-in-text", Warning
}

text_rule! {
    /// the names of a compact object have a gap
    ///
    /// ## What it checks
    /// Whether `[xxxxName]` names all sub-indexes from 1 to as many as it has names.
    ///
    /// ## Why it matters
    /// CiA 306 lets a name out where the standard one will do. python-canopen asks for as many names as there are, from 1 on, and stops at the gap.
    ///
    /// ## Example
    /// `NrOfEntries=2` with `1=Left` and `3=Right`
    ///
    /// ## How to mend
    /// Name the others too, as the standard does: the name of the object with the sub-index behind it.
    ///
    /// ## Source
    /// python-canopen 2.4.1
    SPARSE_NAMES = "portability/sparse-names", Warning, fix Safe
}

text_rule! {
    /// a sub-index stands before its object
    ///
    /// ## What it checks
    /// Whether the section of each object stands above those of its sub-indexes, and above its `[xxxxName]`.
    ///
    /// ## Why it matters
    /// CiA 306 asks for no order. python-canopen stops at a sub-index whose object it has not met, CANopenEditor skips it.
    ///
    /// ## Example
    /// `[2000sub0]` above `[2000]`
    ///
    /// ## How to mend
    /// Put the object above its sub-indexes.
    ///
    /// ## Source
    /// python-canopen 2.4.1, CANopenEditor of 2026
    SUB_BEFORE_OBJECT = "portability/sub-before-object", Warning
}

text_rule! {
    /// a string has no quotes
    ///
    /// ## What it checks
    /// Whether a value of type VISIBLE_STRING or UNICODE_STRING stands in quotes. The first one is shown, the others are counted.
    ///
    /// ## Why it matters
    /// CiA 306 has strings without quotes, and so have all other tools. dcf2dev of dcf-tools takes the text for a literal of Python and stops; dcfchk and dcfgen do not look at it.
    ///
    /// ## Example
    /// `DefaultValue=Pump controller`
    ///
    /// ## How to mend
    /// Put the text in quotes in a copy for dcf2dev alone.
    ///
    /// ## Source
    /// dcf-tools 2.4.2
    UNQUOTED_STRING = "portability/unquoted-string", Warning
}

//! The rules about spelling and structure that only the text of an EDS or DCF can show.

mod raise;

use super::file_name::FILE_NAME;
pub(crate) use super::quirks::quirks;
use crate::diagnostic::{RuleInfo, text_rule};
pub(super) use raise::{
    Twin, duplicate_key, duplicate_section, invalid_list_entry, list_numbering, quoted_name,
    section_spelling, stray_compact_entry, stray_compact_section, unknown_key, unknown_section, wrong_count,
};

/// Every rule of this module.
pub(crate) static RULES: &[&RuleInfo] = &[
    &DUPLICATE_SECTION,
    &DUPLICATE_KEY,
    &UNKNOWN_SECTION,
    &UNKNOWN_KEY,
    &SECTION_SPELLING,
    &COMMISSIONING_SPELLING,
    &STRAY_COMPACT_SECTION,
    &WRONG_COUNT,
    &LIST_NUMBERING,
    &INVALID_LIST_ENTRY,
    &OCTAL_NUMBER,
    &LEADING_ZERO,
    &NODE_ID_LAST,
    &FORMULA_SPELLING,
    &TRAILING_COMMENT,
    &NUMBER_SUFFIX,
    &REAL_AS_BITS,
    &TWOS_COMPLEMENT,
    &QUOTED_STRING,
    &BOOLEAN_WORD,
    &DECORATED_BYTES,
    &FILE_NAME,
];

text_rule! {
    /// a section stands twice
    ///
    /// ## What it checks
    /// Whether a section name occurs once, whatever the case of its letters and leading zeros in it. The first section is the one that is read; lists are read on.
    ///
    /// ## Why it matters
    /// Some tools take the first one, some the last one, some refuse the file: the device has two dictionaries.
    ///
    /// ## Example
    /// `[1018sub1]` and further down `[1018SUB01]`
    ///
    /// ## How to mend
    /// Keep one of them.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    DUPLICATE_SECTION = "cia306/duplicate-section", Error, fix Unsafe
}

text_rule! {
    /// a key stands twice in a section
    ///
    /// ## What it checks
    /// Whether a key occurs once in its section, whatever the case of its letters. The first one is read. Two equal lines are a warning only.
    ///
    /// ## Why it matters
    /// Some tools take the first value, some the last one, some refuse the file.
    ///
    /// ## Example
    /// `DefaultValue=4` and two lines below `DefaultValue=5`
    ///
    /// ## How to mend
    /// Keep one of them.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    DUPLICATE_KEY = "cia306/duplicate-key", Error, fix Unsafe
}

text_rule! {
    /// a section that the standard does not have
    ///
    /// ## What it checks
    /// Whether each section is one of CiA 306-1 or CiA 306-3. Others are kept.
    ///
    /// ## Why it matters
    /// The standard allows them, dcf-tools refuses them. Perhaps the name is misspelt.
    ///
    /// ## Example
    /// `[ToolInfos]`
    ///
    /// ## How to mend
    /// Check the spelling; remove the section if the tools of your users do not need it.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    UNKNOWN_SECTION = "cia306/unknown-section", Note
}

text_rule! {
    /// a key that its section does not have
    ///
    /// ## What it checks
    /// Whether the standard has the key, and has it in this section. Others are kept.
    ///
    /// ## Why it matters
    /// The standard allows them, dcf-tools refuses them. Perhaps the name is misspelt, and then its value is lost.
    ///
    /// ## Example
    /// `Supported Objects=3`
    ///
    /// ## How to mend
    /// Check the spelling; remove the key if the tools of your users do not need it.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    UNKNOWN_KEY = "cia306/unknown-key", Note, fix Unsafe
}

text_rule! {
    /// the name of an object's section is misspelt
    ///
    /// ## What it checks
    /// Whether the names of objects are an index in hex without `0x` and leading zeros, and `sub` with a sub-index in hex without leading zeros. What can be understood is read. Leading zeros, which many readers understand too, are a warning, everything else is an error.
    ///
    /// ## Why it matters
    /// Other tools read another object, or none.
    ///
    /// ## Example
    /// `[1018sub01]`, `[0x1000]`, `[1003sub100]`
    ///
    /// ## How to mend
    /// Write `[1018sub1]`, `[1000]`.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.2
    SECTION_SPELLING = "cia306/section-spelling", Warning, fix Safe
}

text_rule! {
    /// `DeviceComissioning` is spelt with two m
    ///
    /// ## What it checks
    /// Whether the section is called `DeviceComissioning`, as the standard misspells it. Both are read.
    ///
    /// ## Why it matters
    /// python-canopen, dcf-tools and others only know the name of the standard: the node-ID is lost to them.
    ///
    /// ## Example
    /// `[DeviceCommissioning]`
    ///
    /// ## How to mend
    /// Write `[DeviceComissioning]`.
    ///
    /// ## Source
    /// CiA 306-1 §5.4
    COMMISSIONING_SPELLING = "cia306/commissioning-spelling", Warning, fix Safe
}

text_rule! {
    /// names, values or denotations of an object that is not stored compactly
    ///
    /// ## What it checks
    /// Whether an object with `CompactSubObj` belongs to each `[xxxxName]`, `[xxxxValue]` and `[xxxxDenotation]`, and whether their numbers are 1 to `CompactSubObj`.
    ///
    /// ## Why it matters
    /// The names and values apply to nothing.
    ///
    /// ## Example
    /// `[2000Value]` beside a `[2000]` with `SubNumber`
    ///
    /// ## How to mend
    /// Give the object `CompactSubObj`, or write the values into its sub-indexes.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.4.2
    STRAY_COMPACT_SECTION = "cia306/stray-compact-section", Error
}

text_rule! {
    /// a count is not the number of what it counts
    ///
    /// ## What it checks
    /// Whether `SupportedObjects`, `NrOfEntries`, `Lines`, `ObjectLinks`, `NrOfSeg` and `Items` are the number of numbered keys that follow. All keys are read, whatever the count says.
    ///
    /// ## Why it matters
    /// Tools that trust the count do not see the objects behind it.
    ///
    /// ## Example
    /// `SupportedObjects=3` with four entries
    ///
    /// ## How to mend
    /// Write the right number.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    WRONG_COUNT = "cia306/wrong-count", Error, fix Safe
}

text_rule! {
    /// the keys of a list are not 1, 2, 3 …
    ///
    /// ## What it checks
    /// Whether a list's keys are decimal numbers from 1 without gaps.
    ///
    /// ## Why it matters
    /// Tools that count from 1 stop at the gap.
    ///
    /// ## Example
    /// `1=0x1000`, `2=0x1001`, `4=0x1018`
    ///
    /// ## How to mend
    /// Number the entries again.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    LIST_NUMBERING = "cia306/list-numbering", Error, fix Safe
}

text_rule! {
    /// an entry of a list is no index
    ///
    /// ## What it checks
    /// Whether each value of an object list is an index from 1h to FFFFh.
    ///
    /// ## Why it matters
    /// The object that was meant is in no list, so many tools do not see it.
    ///
    /// ## Example
    /// `3=0x10180`
    ///
    /// ## How to mend
    /// Write the index in hex: `3=0x1018`.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.1
    INVALID_LIST_ENTRY = "cia306/invalid-list-entry", Error
}

text_rule! {
    /// a number with a leading zero is octal
    ///
    /// ## What it checks
    /// Whether a number starts with `0` and would be another one in decimal. It is read as octal.
    ///
    /// ## Why it matters
    /// The standard says octal, .NET tools and npm's canopen read decimal, python-canopen refuses it.
    ///
    /// ## Example
    /// `DefaultValue=010` is 8
    ///
    /// ## How to mend
    /// Write the number that you mean in decimal or hex.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    OCTAL_NUMBER = "cia306/octal-number", Warning, fix Safe
}

text_rule! {
    /// a number has a leading zero
    ///
    /// ## What it checks
    /// Whether a decimal number starts with `0` and is the same in octal.
    ///
    /// ## Why it matters
    /// Python's readers refuse the number.
    ///
    /// ## Example
    /// `FileRevision=07`
    ///
    /// ## How to mend
    /// Write `7`.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    LEADING_ZERO = "cia306/leading-zero", Note, fix Safe
}

text_rule! {
    /// `$NODEID` does not come first
    ///
    /// ## What it checks
    /// Whether a formula starts with `$NODEID`. The other order is understood.
    ///
    /// ## Why it matters
    /// The standard takes such a text for no formula. dcf-tools refuses the file, the C parser of Lely reads the number alone and forgets the node-ID.
    ///
    /// ## Example
    /// `DefaultValue=0x180+$NODEID`
    ///
    /// ## How to mend
    /// Write `$NODEID+0x180`.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    NODE_ID_LAST = "cia306/node-id-last", Warning, fix Safe
}

text_rule! {
    /// a formula has blanks or lower-case letters
    ///
    /// ## What it checks
    /// Whether formulas are spelt `$NODEID+number`.
    ///
    /// ## Why it matters
    /// Some tools compare letter by letter.
    ///
    /// ## Example
    /// `$NodeId + 0x180`
    ///
    /// ## How to mend
    /// Write `$NODEID+0x180`.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    FORMULA_SPELLING = "cia306/formula-spelling", Note, fix Safe
}

text_rule! {
    /// a comment stands behind a number or keyword
    ///
    /// ## What it checks
    /// Whether `;`, `#` or `//` follows a value that cannot hold it. In names and strings they are text.
    ///
    /// ## Why it matters
    /// The standard has no such comments: to other tools the whole text is the value, and it is no number.
    ///
    /// ## Example
    /// `DataType=0x0007 ; UNSIGNED32`
    ///
    /// ## How to mend
    /// Put the comment on a line of its own.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    TRAILING_COMMENT = "cia306/trailing-comment", Warning, fix Safe
}

text_rule! {
    /// a number has a suffix of the C language
    ///
    /// ## What it checks
    /// Whether `L`, `LL`, `U` or `f` follows a number. It is read without it.
    ///
    /// ## Why it matters
    /// An EDS knows no suffixes; five of six other tools refuse the file.
    ///
    /// ## Example
    /// `DefaultValue=0x1234567890ABCDEFLL`
    ///
    /// ## How to mend
    /// Remove the suffix.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    NUMBER_SUFFIX = "cia306/number-suffix", Warning, fix Safe
}

text_rule! {
    /// a REAL is written as the hex digits of its bits
    ///
    /// ## What it checks
    /// Whether a REAL32 or REAL64 is a hex number. It is read as the bits of IEEE 754.
    ///
    /// ## Why it matters
    /// The standard does not say how a REAL is written. Lely reads bits, python-canopen and npm's canopen do not.
    ///
    /// ## Example
    /// `DefaultValue=0x3F800000`
    ///
    /// ## How to mend
    /// Write `1.0`, unless the file is for Lely.
    ///
    /// ## Source
    /// CiA 306-1 §4.3 is silent
    REAL_AS_BITS = "cia306/real-as-bits", Note, fix Unsafe
}

text_rule! {
    /// a negative number is written as two's complement
    ///
    /// ## What it checks
    /// Whether a hex number of a signed type has its sign bit set. It is read as the negative number.
    ///
    /// ## Why it matters
    /// Lely reads the largest positive number instead, dcf-tools and npm's canopen refuse it.
    ///
    /// ## Example
    /// `LowLimit=0x80000000` of an INTEGER32
    ///
    /// ## How to mend
    /// Write `-2147483648`.
    ///
    /// ## Source
    /// CiA 306-1 §4.3 is silent
    TWOS_COMPLEMENT = "cia306/twos-complement", Note, fix Safe
}

text_rule! {
    /// a string stands in quotes
    ///
    /// ## What it checks
    /// Whether the value of a string type starts and ends with `"`; it is read without them. Names and other texts about the device are reported too, but read with their quotes.
    ///
    /// ## Why it matters
    /// An EDS stores strings without quotes. python-canopen and others make the quotes a part of the text.
    ///
    /// ## Example
    /// `DefaultValue="IO block"`
    ///
    /// ## How to mend
    /// Remove the quotes, unless the file is for Lely's dcfgen.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    QUOTED_STRING = "cia306/quoted-string", Warning, fix Unsafe
}

text_rule! {
    /// a BOOLEAN is written as a word
    ///
    /// ## What it checks
    /// Whether a BOOLEAN is `true` or `false`.
    ///
    /// ## Why it matters
    /// An EDS has 0 and 1; other tools refuse the words.
    ///
    /// ## Example
    /// `DefaultValue=true`
    ///
    /// ## How to mend
    /// Write `1`.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    BOOLEAN_WORD = "cia306/boolean-word", Warning, fix Safe
}

text_rule! {
    /// bytes are not written as plain hex digits
    ///
    /// ## What it checks
    /// Whether the value of an OCTET_STRING or DOMAIN has a `0x` before or blanks between its hex digits.
    ///
    /// ## Why it matters
    /// The standard has two digits a byte and nothing else; other tools lose the value.
    ///
    /// ## Example
    /// `DefaultValue=0x01 A1 05`
    ///
    /// ## How to mend
    /// Write `01A105`.
    ///
    /// ## Source
    /// CiA 306-1 §4.3
    DECORATED_BYTES = "cia306/decorated-bytes", Warning, fix Safe
}

//! The rules about an INI file's lines. Only the text can show them, so they are raised here and not by the linter.

pub mod lines;

pub use self::lines::check;
use crate::diagnostic::{RuleInfo, text_rule};

/// Every rule of this module.
pub static RULES: &[&RuleInfo] = &[
    &BYTE_ORDER_MARK,
    &NOT_ASCII,
    &CONTROL_CHARACTER,
    &LINE_TOO_LONG,
    &MIXED_LINE_ENDS,
    &JUNK_LINE,
    &COMMENT_STYLE,
    &BLANK_BEFORE_EQUALS,
    &INDENTED_SECTION,
    &UNCLOSED_SECTION,
    &TEXT_AFTER_SECTION,
    &BLANKS_IN_SECTION_NAME,
    &KEY_BEFORE_SECTION,
    &NO_SECTION,
];

text_rule! {
    BYTE_ORDER_MARK = "cia306/byte-order-mark", Warning, fix Unsafe;
    summary: "the file starts with a byte order mark",
    checks: "Whether bytes EF BB BF (UTF-8), FF FE or FE FF (UTF-16) stand before the text.",
    why: "An EDS is an ISO 646 file. python-canopen, dcf-tools and others take the mark for a part of the first line and then find no section at all.",
    example: "`EF BB BF [FileInfo]`",
    remedy: "Save the file as plain ASCII or as UTF-8 without byte order mark.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    NOT_ASCII = "cia306/not-ascii", Warning, fix Unsafe;
    summary: "the file has characters that ISO 646 does not have",
    checks: "Whether all characters, in values, names and comments, are seven-bit ones. The first one is shown.",
    why: "Nothing in the file says which encoding it is in, so each tool shows other letters, or refuses the file.",
    example: "`ParameterName=Temperature in °C`",
    remedy: "Write `deg C`, `ue`, `u` for `°C`, `ü`, `µ`.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    CONTROL_CHARACTER = "cia306/control-character", Error, fix Unsafe;
    summary: "a line has a control character",
    checks: "Whether there are characters below 20h other than line ends and tabs, such as NUL or Ctrl-Z.",
    why: "Tools end the text, the line or the file there, each in its own way.",
    example: "A NUL byte behind `[1000]`.",
    remedy: "Remove the character.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    LINE_TOO_LONG = "cia306/line-too-long", Warning;
    summary: "a line is longer than 255 characters",
    checks: "The length of each line without its line end. So a `ParameterName` has at most 241 characters, a `Description` 243, a `VendorName` 244.",
    why: "A tool may read lines into a buffer of 256 characters, and then takes the rest for another line.",
    example: "A DOMAIN with 300 hex digits as its `ParameterValue`.",
    remedy: "Shorten the text; for the data of a DOMAIN use `DownloadFile`.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    MIXED_LINE_ENDS = "cia306/mixed-line-ends", Note, fix Unsafe;
    summary: "the file mixes line ends",
    checks: "Whether all lines end alike, with LF or with CR LF. A lone CR is reported too.",
    why: "The file went through tools that do not agree about its lines; version control shows changes that nobody made.",
    example: "Lines with CR LF, and between them one that a script added with LF.",
    remedy: "Save the file with one kind of line end.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    JUNK_LINE = "cia306/junk-line", Error, fix Unsafe;
    summary: "a line is no section, no key and no comment",
    checks: "Whether each line that is not empty is `[section]`, `key=value` or a comment.",
    why: "Some tools stop here, others glue the line to the next key. Marks that a merge left behind mean that the file holds two versions at once.",
    example: "`<<<<<<< HEAD`",
    remedy: "Remove the line, or put a `;` before it.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    COMMENT_STYLE = "cia306/comment-style", Warning, fix Safe;
    summary: "a comment does not start with `;` in the first column",
    checks: "Comment lines that start with `#` or `//`, or have blanks before the `;`. The first one is shown.",
    why: "The standard knows only `;` in column 1. Other tools read such a line as a key or fail.",
    example: "`# device type`",
    remedy: "Write `; device type`.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    BLANK_BEFORE_EQUALS = "cia306/blank-before-equals", Note, fix Safe;
    summary: "blanks stand before the `=` or before the key",
    checks: "Whether each key starts in column 1 and the `=` follows it at once. The first line that does not is shown.",
    why: "The standard wants the `=` directly behind the key; a simple reader takes the blank for a part of the key.",
    example: "`NrOfRXPDO = 5`",
    remedy: "Write `NrOfRXPDO=5`.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    INDENTED_SECTION = "cia306/indented-section", Warning, fix Safe;
    summary: "a section header does not start in the first column",
    checks: "Whether blanks stand before a `[`.",
    why: "The standard wants the `[` in column 1. A tool that does not see the header gives the keys below to the section before.",
    example: "` [1000]`",
    remedy: "Remove the blanks.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    UNCLOSED_SECTION = "cia306/unclosed-section", Error, fix Unsafe;
    summary: "a section header has no `]`",
    checks: "Whether each line that starts with `[` has a `]`. The section is read as if it had one.",
    why: "Some tools read on to the next `]`, and a whole section is gone.",
    example: "`[1018sub1`",
    remedy: "Add the `]`.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    TEXT_AFTER_SECTION = "cia306/text-after-section", Warning, fix Unsafe;
    summary: "text stands behind a section header",
    checks: "Whether something else than blanks follows the `]`.",
    why: "The standard has no comments behind a header; tools refuse the line or read another name.",
    example: "`[1200] ; first SDO server`",
    remedy: "Put the text in a comment line of its own.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    BLANKS_IN_SECTION_NAME = "cia306/blanks-in-section-name", Warning, fix Safe;
    summary: "blanks stand inside the brackets of a section header",
    checks: "Whether the name follows the `[` at once and the `]` follows the name.",
    why: "A tool that does not trim the name does not know the section.",
    example: "`[ 1000 ]`",
    remedy: "Write `[1000]`.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    KEY_BEFORE_SECTION = "cia306/key-before-section", Error;
    summary: "a key stands before the first section",
    checks: "Whether a section header comes before all keys.",
    why: "The key belongs to nothing. Python's reader refuses the whole file.",
    example: "`FileName=drive.eds` as the first line",
    remedy: "Add the missing header, most likely `[FileInfo]`, above it.",
    source: "CiA 306-1 §4.2",
}

text_rule! {
    NO_SECTION = "cia306/no-section", Error;
    summary: "the file has no section",
    checks: "Whether there is any `[section]` at all.",
    why: "It is no EDS and no DCF.",
    example: "An empty file.",
    remedy: "Check the file name and how the file came here.",
    source: "CiA 306-1 §4.2",
}

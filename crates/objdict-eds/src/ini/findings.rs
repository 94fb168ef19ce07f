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
    /// the file starts with a byte order mark
    ///
    /// ## What it checks
    /// Whether bytes EF BB BF (UTF-8), FF FE or FE FF (UTF-16) stand before the text.
    ///
    /// ## Why it matters
    /// An EDS is an ISO 646 file. python-canopen, dcf-tools and others take the mark for a part of the first line and then find no section at all.
    ///
    /// ## Example
    /// `EF BB BF [FileInfo]`
    ///
    /// ## How to mend
    /// Save the file as plain ASCII or as UTF-8 without byte order mark.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    BYTE_ORDER_MARK = "cia306/byte-order-mark", Warning, fix Unsafe
}

text_rule! {
    /// the file has characters that ISO 646 does not have
    ///
    /// ## What it checks
    /// Whether all characters, in values, names and comments, are seven-bit ones. The first one is shown.
    ///
    /// ## Why it matters
    /// Nothing in the file says which encoding it is in, so each tool shows other letters, or refuses the file.
    ///
    /// ## Example
    /// `ParameterName=Temperature in °C`
    ///
    /// ## How to mend
    /// Write `deg C`, `ue`, `u` for `°C`, `ü`, `µ`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    NOT_ASCII = "cia306/not-ascii", Warning, fix Unsafe
}

text_rule! {
    /// a line has a control character
    ///
    /// ## What it checks
    /// Whether there are characters below 20h other than line ends and tabs, such as NUL or Ctrl-Z.
    ///
    /// ## Why it matters
    /// Tools end the text, the line or the file there, each in its own way.
    ///
    /// ## Example
    /// A NUL byte behind `[1000]`.
    ///
    /// ## How to mend
    /// Remove the character.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    CONTROL_CHARACTER = "cia306/control-character", Error, fix Unsafe
}

text_rule! {
    /// a line is longer than 255 characters
    ///
    /// ## What it checks
    /// The length of each line without its line end. So a `ParameterName` has at most 241 characters, a `Description` 243, a `VendorName` 244.
    ///
    /// ## Why it matters
    /// A tool may read lines into a buffer of 256 characters, and then takes the rest for another line.
    ///
    /// ## Example
    /// A DOMAIN with 300 hex digits as its `ParameterValue`.
    ///
    /// ## How to mend
    /// Shorten the text; for the data of a DOMAIN use `DownloadFile`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    LINE_TOO_LONG = "cia306/line-too-long", Warning
}

text_rule! {
    /// the file mixes line ends
    ///
    /// ## What it checks
    /// Whether all lines end alike, with LF or with CR LF. A lone CR is reported too.
    ///
    /// ## Why it matters
    /// The file went through tools that do not agree about its lines; version control shows changes that nobody made.
    ///
    /// ## Example
    /// Lines with CR LF, and between them one that a script added with LF.
    ///
    /// ## How to mend
    /// Save the file with one kind of line end.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    MIXED_LINE_ENDS = "cia306/mixed-line-ends", Note, fix Unsafe
}

text_rule! {
    /// a line is no section, no key and no comment
    ///
    /// ## What it checks
    /// Whether each line that is not empty is `[section]`, `key=value` or a comment.
    ///
    /// ## Why it matters
    /// Some tools stop here, others glue the line to the next key. Marks that a merge left behind mean that the file holds two versions at once.
    ///
    /// ## Example
    /// `<<<<<<< HEAD`
    ///
    /// ## How to mend
    /// Remove the line, or put a `;` before it.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    JUNK_LINE = "cia306/junk-line", Error, fix Unsafe
}

text_rule! {
    /// a comment does not start with `;` in the first column
    ///
    /// ## What it checks
    /// Comment lines that start with `#` or `//`, or have blanks before the `;`. The first one is shown.
    ///
    /// ## Why it matters
    /// The standard knows only `;` in column 1. Other tools read such a line as a key or fail.
    ///
    /// ## Example
    /// `# device type`
    ///
    /// ## How to mend
    /// Write `; device type`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    COMMENT_STYLE = "cia306/comment-style", Warning, fix Safe
}

text_rule! {
    /// blanks stand before the `=` or before the key
    ///
    /// ## What it checks
    /// Whether each key starts in column 1 and the `=` follows it at once. The first line that does not is shown.
    ///
    /// ## Why it matters
    /// The standard wants the `=` directly behind the key; a simple reader takes the blank for a part of the key.
    ///
    /// ## Example
    /// `NrOfRXPDO = 5`
    ///
    /// ## How to mend
    /// Write `NrOfRXPDO=5`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    BLANK_BEFORE_EQUALS = "cia306/blank-before-equals", Note, fix Safe
}

text_rule! {
    /// a section header does not start in the first column
    ///
    /// ## What it checks
    /// Whether blanks stand before a `[`.
    ///
    /// ## Why it matters
    /// The standard wants the `[` in column 1. A tool that does not see the header gives the keys below to the section before.
    ///
    /// ## Example
    /// ` [1000]`
    ///
    /// ## How to mend
    /// Remove the blanks.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    INDENTED_SECTION = "cia306/indented-section", Warning, fix Safe
}

text_rule! {
    /// a section header has no `]`
    ///
    /// ## What it checks
    /// Whether each line that starts with `[` has a `]`. The section is read as if it had one.
    ///
    /// ## Why it matters
    /// Some tools read on to the next `]`, and a whole section is gone.
    ///
    /// ## Example
    /// `[1018sub1`
    ///
    /// ## How to mend
    /// Add the `]`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    UNCLOSED_SECTION = "cia306/unclosed-section", Error, fix Unsafe
}

text_rule! {
    /// text stands behind a section header
    ///
    /// ## What it checks
    /// Whether something else than blanks follows the `]`.
    ///
    /// ## Why it matters
    /// The standard has no comments behind a header; tools refuse the line or read another name.
    ///
    /// ## Example
    /// `[1200] ; first SDO server`
    ///
    /// ## How to mend
    /// Put the text in a comment line of its own.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    TEXT_AFTER_SECTION = "cia306/text-after-section", Warning, fix Unsafe
}

text_rule! {
    /// blanks stand inside the brackets of a section header
    ///
    /// ## What it checks
    /// Whether the name follows the `[` at once and the `]` follows the name.
    ///
    /// ## Why it matters
    /// A tool that does not trim the name does not know the section.
    ///
    /// ## Example
    /// `[ 1000 ]`
    ///
    /// ## How to mend
    /// Write `[1000]`.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    BLANKS_IN_SECTION_NAME = "cia306/blanks-in-section-name", Warning, fix Safe
}

text_rule! {
    /// a key stands before the first section
    ///
    /// ## What it checks
    /// Whether a section header comes before all keys.
    ///
    /// ## Why it matters
    /// The key belongs to nothing. Python's reader refuses the whole file.
    ///
    /// ## Example
    /// `FileName=drive.eds` as the first line
    ///
    /// ## How to mend
    /// Add the missing header, most likely `[FileInfo]`, above it.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    KEY_BEFORE_SECTION = "cia306/key-before-section", Error
}

text_rule! {
    /// the file has no section
    ///
    /// ## What it checks
    /// Whether there is any `[section]` at all.
    ///
    /// ## Why it matters
    /// It is no EDS and no DCF.
    ///
    /// ## Example
    /// An empty file.
    ///
    /// ## How to mend
    /// Check the file name and how the file came here.
    ///
    /// ## Source
    /// CiA 306-1 §4.2
    NO_SECTION = "cia306/no-section", Error
}

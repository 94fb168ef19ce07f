//! The rules about the lines of an INI file. They need the text, so the reader reports them and not the
//! linter.

pub mod lines;

use crate::diagnostic::text_rules;

text_rules! {
    source: "CiA 306-1 §4.2";

    "cia306/byte-order-mark" = BYTE_ORDER_MARK, Warning, fix Mixed;
    summary: "the file starts with a byte order mark",
    checks: "The bytes EF BB BF (UTF-8), FF FE or FE FF (UTF-16) must not precede the text.",
    why: "An EDS is an ISO 646 file. python-canopen, dcf-tools and others read the mark as part of the first line and then find no section.",
    example: "`EF BB BF [FileInfo]`",
    remedy: "Save the file as plain ASCII or as UTF-8 without byte order mark.",

    "cia306/not-ascii" = NOT_ASCII, Warning, fix Mixed;
    summary: "the file contains characters outside ISO 646",
    checks: "All characters in values, names and comments must be 7-bit characters. Only the first other one is shown.",
    why: "The file does not declare its encoding, so tools show different characters or reject the file.",
    example: "`ParameterName=Temperature in °C`",
    remedy: "Write `deg C`, `ue`, `u` instead of `°C`, `ü`, `µ`.",

    "cia306/control-character" = CONTROL_CHARACTER, Error, fix Mixed;
    summary: "a line contains a control character",
    checks: "Reports characters below 20h other than line ends and tabs, such as NUL or Ctrl-Z.",
    why: "Depending on the tool, the text, the line or the file ends there.",
    example: "A NUL byte after `[1000]`.",
    remedy: "Remove the character.",

    "cia306/line-too-long" = LINE_TOO_LONG, Warning;
    summary: "a line is longer than 255 characters",
    checks: "A line may have at most 255 characters without its line end. A `ParameterName` can therefore have at most 241 characters, a `Description` 243, a `VendorName` 244.",
    why: "A tool may read lines into a buffer of 256 characters and read the rest as a separate line.",
    example: "A DOMAIN with 300 hex digits as its `ParameterValue`.",
    remedy: "Shorten the text; use `DownloadFile` for the data of a DOMAIN.",

    "cia306/mixed-line-ends" = MIXED_LINE_ENDS, Note, fix Mixed;
    summary: "the file mixes line ends",
    checks: "All lines must end with LF, or all with CR LF. A lone CR is also reported.",
    why: "Tools with different line ends edited the file; version control shows unchanged lines as changed.",
    example: "Lines with CR LF, and one line with LF that a script added.",
    remedy: "Save the file with one kind of line end.",

    // the line is the header of a section that is not read, or a key that its section lacks
    "cia306/junk-line" = JUNK_LINE, Error, fix Mixed,
        explains Header [
            "key-before-section", "duplicate-key", "missing-header", "unknown-key", "unsupported-key", "missing-section",
            "listed-object-missing", "sub-without-object", "sub-number-mismatch", "missing-sub-0",
            "missing-sub-index", "wrong-highest-sub-index", "mapped-object-missing", "gap-in-mapping", "gap-in-array",
            "wrong-mapping-count", "incomplete-pdo-parameter", "incomplete-sdo-parameter"
        ],
        explains Section [
            "missing-key", "missing-name", "missing-file-info-key", "missing-device-info-key",
            "missing-module-info", "eds-version", "single-limit", "pdo-parameter-without-value",
            "wrong-highest-sub-index", "wrong-count", "list-numbering"
        ],
        explains Value ["object-not-listed"],
        stops "*";
    summary: "a line is not a section, key or comment",
    checks: "Each non-empty line must be `[section]`, `key=value` or a comment. Continuation lines of a wrapped comment are ignored. So is text before the header of a section of the standard or before the first section.",
    why: "Some tools stop here; others append the line to the previous value. Merge conflict markers mean that the file contains two versions: then only the markers are reported and nothing is fixed.",
    example: "`<<<<<<< HEAD`",
    remedy: "Remove the line, or put a `;` before it.",

    "cia306/comment-style" = COMMENT_STYLE, Warning, fix Safe;
    summary: "a comment does not start with `;` in the first column",
    checks: "Reports comment lines that start with `#` or `//`, or have spaces before the `;`. Only the first one is shown.",
    why: "The standard defines only `;` in column 1. Other tools read such a line as a key or fail.",
    example: "`# device type`",
    remedy: "Write `; device type`.",

    "cia306/blank-before-equals" = BLANK_BEFORE_EQUALS, Note, fix Safe;
    summary: "spaces precede the `=` or the key",
    checks: "Each key must start in column 1, directly followed by `=`. Only the first such line is shown.",
    why: "The standard requires the `=` directly after the key; a simple reader treats the space as part of the key.",
    example: "`NrOfRXPDO = 5`",
    remedy: "Write `NrOfRXPDO=5`.",

    "cia306/indented-section" = INDENTED_SECTION, Warning, fix Safe;
    summary: "a section header does not start in the first column",
    checks: "The `[` of a section header must not be preceded by spaces.",
    why: "The standard requires the `[` in column 1. A tool that does not recognise the header adds the keys below to the previous section.",
    example: "` [1000]`",
    remedy: "Remove the spaces.",

    "cia306/unclosed-section" = UNCLOSED_SECTION, Error, fix Unsafe;
    summary: "a section header has no `]`",
    checks: "Each line that starts with `[` needs a `]`. The section is read as if the `]` were present.",
    why: "Some tools read on to the next `]`, and a whole section is lost.",
    example: "`[1018sub1`",
    remedy: "Add the `]`.",

    "cia306/text-after-section" = TEXT_AFTER_SECTION, Warning, fix Mixed;
    summary: "text follows a section header",
    checks: "Only spaces may follow the `]`.",
    why: "The standard does not allow comments after a header; tools reject the line or read a different name.",
    example: "`[1200] ; first SDO server`",
    remedy: "Put the text in a separate comment line.",

    "cia306/blanks-in-section-name" = BLANKS_IN_SECTION_NAME, Warning, fix Safe;
    summary: "a section header has spaces inside the brackets",
    checks: "The name must directly follow the `[`, and the `]` must directly follow the name.",
    why: "A tool that does not trim the name does not recognise the section.",
    example: "`[ 1000 ]`",
    remedy: "Write `[1000]`.",

    "cia306/key-before-section" = KEY_BEFORE_SECTION, Error, fix Safe;
    summary: "a key precedes the first section",
    checks: "A section header must precede all keys.",
    why: "The key does not belong to any section. Python's reader rejects the whole file.",
    example: "`FileName=drive.eds` as the first line",
    remedy: "Add the missing header, probably `[FileInfo]`, above the key.",

    "cia306/no-section" = NO_SECTION, Error;
    summary: "the file has no section",
    checks: "The file must have at least one `[section]`.",
    why: "The file is not an EDS or DCF.",
    example: "An empty file.",
    remedy: "Check the file name and the origin of the file.",
}

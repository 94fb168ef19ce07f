//! The rules about an INI file's lines. Only the text can show them, so they are raised here and not by the linter.

use super::{Document, Line, LineKind};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Severity, counted, text_rule};
use crate::source::{Encoding, Span};

/// Every rule of this module.
pub(crate) static RULES: &[&RuleInfo] = &[
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

/// The most characters that a line may have, its line end not counted.
const MAX_LINE: usize = 255;

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
    BYTE_ORDER_MARK = "cia306/byte-order-mark", Warning
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
    NOT_ASCII = "cia306/not-ascii", Warning
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
    CONTROL_CHARACTER = "cia306/control-character", Error
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
    MIXED_LINE_ENDS = "cia306/mixed-line-ends", Note
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
    JUNK_LINE = "cia306/junk-line", Error
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
    COMMENT_STYLE = "cia306/comment-style", Warning
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
    BLANK_BEFORE_EQUALS = "cia306/blank-before-equals", Note
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
    INDENTED_SECTION = "cia306/indented-section", Warning
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
    UNCLOSED_SECTION = "cia306/unclosed-section", Error
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
    TEXT_AFTER_SECTION = "cia306/text-after-section", Warning
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
    BLANKS_IN_SECTION_NAME = "cia306/blanks-in-section-name", Warning
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

/// Adds what the lines of `document` show.
pub(crate) fn check(document: &Document, findings: &mut Findings) {
    check_characters(document, findings);
    let mut lines = LineCheck {
        text: document.text(),
        first_section: None,
        line_end: None,
        comment: None,
        blank: None,
        findings,
    };
    for line in document.lines() {
        lines.check(&line);
    }
    lines.finish();
}

fn check_characters(document: &Document, findings: &mut Findings) {
    let text = document.text();
    let encoding = document.source().encoding();
    if matches!(encoding, Encoding::Utf8Bom | Encoding::Utf16Le | Encoding::Utf16Be) {
        let wide = encoding != Encoding::Utf8Bom;
        let message = format!("the file starts with the byte order mark of {encoding}");
        let finding = Diagnostic::new(&BYTE_ORDER_MARK, Span::empty(0), message)
            .severity(if wide { Severity::Error } else { Severity::Warning })
            .help("save the file as ASCII or as UTF-8 without byte order mark");
        findings.push(finding);
    }
    if !text.is_ascii() {
        let others = text.chars().filter(|c| !c.is_ascii()).count();
        let (at, first) = text.char_indices().find(|(_, c)| !c.is_ascii()).unwrap_or_default();
        let span = Span::new(at as u32, (at + first.len_utf8()) as u32);
        let message = match others {
            1 => format!("`{first}` is not in ISO 646; the file is read as {encoding}"),
            _ => format!(
                "{others} characters are not in ISO 646, `{first}` is the first; the file is read as {encoding}"
            ),
        };
        findings.push(
            Diagnostic::new(&NOT_ASCII, span, message)
                .help("use seven-bit characters, such as `deg C` or `ue`"),
        );
    }
    let is_control = |byte: &u8| *byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r') || *byte == 0x7F;
    // without an early exit the loop over a chunk is a few vector instructions
    let has_control = |chunk: &[u8]| chunk.iter().fold(false, |found, byte| found | is_control(byte));
    if text.as_bytes().chunks(4096).any(has_control) {
        for line in document.lines() {
            let bytes = line.span.of(text).as_bytes();
            if let Some(at) = bytes.iter().position(is_control) {
                let start = line.span.start + at as u32;
                let message = format!("control character {:02X}h", bytes[at]);
                let finding = Diagnostic::new(&CONTROL_CHARACTER, Span::new(start, start + 1), message);
                findings.push(finding.help("remove it"));
            }
        }
    }
}

/// Style findings that would be on every line of a file are made once, for the first line, with the number of lines.
struct LineCheck<'a> {
    text: &'a str,
    first_section: Option<Span>,
    /// The first line end of the file; empty when another one was met and reported.
    line_end: Option<&'a str>,
    comment: Option<(Span, u32)>,
    blank: Option<(Span, u32)>,
    findings: &'a mut Findings,
}

fn count(counter: &mut Option<(Span, u32)>, span: Span) {
    counter.get_or_insert((span, 0)).1 += 1;
}

impl LineCheck<'_> {
    fn check(&mut self, line: &Line) {
        self.check_line_end(line);
        if line.span.len() as usize > MAX_LINE {
            self.check_length(line);
        }
        match line.kind {
            LineKind::Blank => {}
            LineKind::Comment => {
                if !line.span.of(self.text).starts_with(';') {
                    count(&mut self.comment, line.span);
                }
            }
            LineKind::Junk => self.junk(line),
            LineKind::Section { name } => self.section(line, name),
            LineKind::Entry { key, .. } => {
                if self.first_section.is_none() {
                    self.key_before_section(key);
                }
                let equals_follows = self.text.as_bytes().get(key.end as usize) == Some(&b'=');
                if key.start != line.span.start || !equals_follows {
                    count(&mut self.blank, Span::new(line.span.start, key.end + 1));
                }
            }
        }
    }

    fn check_line_end(&mut self, line: &Line) {
        let span = Span::new(line.span.end, line.next);
        let line_end = span.of(self.text);
        let first = *self.line_end.get_or_insert(line_end);
        if first.is_empty() || line_end.is_empty() || (line_end == first && line_end != "\r") {
            return;
        }
        let message = match line_end {
            "\r" => "the line ends with CR alone",
            "\n" => "the line ends with LF, the lines before end with CR LF",
            _ => "the line ends with CR LF, the lines before end with LF",
        };
        let finding = Diagnostic::new(&MIXED_LINE_ENDS, span, message);
        self.findings.push(finding.help("use CR LF or LF in the whole file"));
        self.line_end = Some("");
    }

    fn check_length(&mut self, line: &Line) {
        let length = line.span.of(self.text).chars().count();
        if length > MAX_LINE {
            let message = format!("the line has {length} characters, {MAX_LINE} are allowed");
            let finding = Diagnostic::new(&LINE_TOO_LONG, Span::empty(line.span.start), message);
            self.findings.push(match line.kind {
                LineKind::Entry { key, .. } => {
                    let key = key.of(self.text);
                    let most = MAX_LINE.saturating_sub(key.chars().count() + 1);
                    finding.help(format!("shorten the value: `{key}` has room for {most} characters"))
                }
                _ => finding.help("shorten it"),
            });
        }
    }

    fn junk(&mut self, line: &Line) {
        let text = line.span.of(self.text).trim();
        let is_merge = ["<<<<<<<", "=======", ">>>>>>>", "|||||||"].iter().any(|mark| text.starts_with(mark));
        let shown: String = text.chars().take(40).collect();
        let finding =
            Diagnostic::new(&JUNK_LINE, line.span, format!("`{shown}` is no section, key or comment"));
        self.findings.push(if is_merge {
            finding.help(
                "a merge left this mark: choose one of the two versions and remove the other with the marks",
            )
        } else {
            finding.help("remove the line, or put a `;` before it")
        });
    }

    fn section(&mut self, line: &Line, name: Span) {
        self.first_section.get_or_insert(line.span);
        let text = line.span.of(self.text);
        let indent = text.find('[').unwrap_or_default() as u32;
        if indent > 0 {
            let span = Span::new(line.span.start, line.span.start + indent);
            let finding = Diagnostic::new(&INDENTED_SECTION, span, "blanks before the section header");
            self.findings.push(finding.help("start the `[` in the first column"));
        }
        let Some(close) = text.find(']') else {
            let finding =
                Diagnostic::new(&UNCLOSED_SECTION, line.span, format!("`{}` has no `]`", text.trim()));
            self.findings.push(finding.help("add the `]`"));
            return;
        };
        let close = line.span.start + close as u32;
        let behind = Span::new(close + 1, line.span.end);
        if !behind.of(self.text).trim().is_empty() {
            let message = format!("`{}` stands behind the section header", behind.of(self.text).trim());
            let finding = Diagnostic::new(&TEXT_AFTER_SECTION, behind, message);
            self.findings.push(finding.help("put it in a comment line of its own"));
        }
        if name.start != line.span.start + indent + 1 || name.end != close {
            let span = Span::new(line.span.start + indent, close + 1);
            let finding = Diagnostic::new(&BLANKS_IN_SECTION_NAME, span, "blanks inside the brackets");
            self.findings.push(finding.help(format!("write `[{}]`", name.of(self.text))));
        }
    }

    fn key_before_section(&mut self, key: Span) {
        let message = format!("`{}` stands before the first section", key.of(self.text));
        let finding = Diagnostic::new(&KEY_BEFORE_SECTION, key, message);
        self.findings.push(finding.help("put the section's header above it"));
        // one cause: the missing header
        self.first_section = Some(key);
    }

    fn finish(self) {
        if let Some((span, lines)) = self.comment {
            let lines = counted(lines as usize, "comment line does", "comment lines do");
            let message = format!("{lines} not start with `;` in the first column");
            self.findings
                .push(Diagnostic::new(&COMMENT_STYLE, span, message).help("start a comment line with `;`"));
        }
        if let Some((span, lines)) = self.blank {
            let lines = counted(lines as usize, "line has", "lines have");
            let message = format!("{lines} blanks before the key or the `=`");
            self.findings
                .push(Diagnostic::new(&BLANK_BEFORE_EQUALS, span, message).help("write `key=value`"));
        }
        if self.first_section.is_none() {
            let finding = Diagnostic::new(&NO_SECTION, Span::empty(0), "the file has no section");
            self.findings.push(finding.help("this is no EDS or DCF; check the file name"));
        }
    }
}

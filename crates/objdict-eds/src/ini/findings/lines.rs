//! Findings about the lines of a document.

use super::{
    BLANK_BEFORE_EQUALS, BLANKS_IN_SECTION_NAME, BYTE_ORDER_MARK, COMMENT_STYLE, CONTROL_CHARACTER,
    INDENTED_SECTION, JUNK_LINE, KEY_BEFORE_SECTION, LINE_TOO_LONG, MIXED_LINE_ENDS, NO_SECTION, NOT_ASCII,
    TEXT_AFTER_SECTION, UNCLOSED_SECTION,
};
use crate::diagnostic::{Change, Diagnostic, Findings, Fix, Severity, Tidy, counted, say};
use crate::ini::{Document, EditedSpan, Line, LineKind};
use crate::source::{Encoding, Span};

/// The maximum length of a line in characters, without its line end.
const MAX_LINE: usize = 255;

/// Adds the findings about the lines of `document`.
pub fn check(document: &Document, findings: &mut Findings) {
    check_characters(document, findings);
    let mut lines = LineCheck::new(document.text(), findings);
    let mut all = document.lines();
    while let Some(line) = all.advance() {
        lines.check(&line);
    }
    lines.finish();
}

/// Whether the document still has no findings, like the document `before` an edit: only the lines of the edit
/// are checked. `false` means undecided.
pub fn stays_clean(document: &Document, before: &Document, edited: EditedSpan) -> bool {
    let text = document.text();
    let (first, section) = (document.lines().next(), document.headers().next());
    let Some((first, section)) = first.zip(section) else { return false };
    let mut changed = document.changed_lines(edited).peekable();
    let is_behind = changed.peek().is_none_or(|line| line.span.start >= section.next.max(first.next));
    if document.source().encoding() != before.source().encoding() || !is_behind {
        return false;
    }
    let mut findings = Findings::new();
    let mut lines = LineCheck::new(text, &mut findings);
    (lines.first_section, lines.line_end) = (Some(section.span), Some(LineEnd::of(text, &first)));
    for line in changed {
        let bytes = line.span.of(text).as_bytes();
        if !bytes.is_ascii() || bytes.iter().any(is_control) {
            return false;
        }
        lines.check(&line);
    }
    lines.finish();
    findings.is_empty()
}

fn check_characters(document: &Document, findings: &mut Findings) {
    let text = document.text();
    let encoding = document.source().encoding();
    if matches!(encoding, Encoding::Utf8Bom | Encoding::Utf16Le | Encoding::Utf16Be) {
        let wide = encoding != Encoding::Utf8Bom;
        let message = say!("the file starts with a byte order mark of {}", encoding);
        let finding = Diagnostic::new(&BYTE_ORDER_MARK, Span::empty(0), message)
            .severity(if wide { Severity::Error } else { Severity::Warning })
            .help("save the file as ASCII or as UTF-8 without byte order mark");
        let title = "save the file as UTF-8 without byte order mark";
        // without the byte order mark, a tool may decode other characters in its own encoding
        let fix = if wide || text.is_ascii() { Fix::safe(title) } else { Fix::risky(title) };
        findings.push(finding.fix(fix.with(Change::Encode(Encoding::Utf8))));
    }
    if !text.is_ascii() {
        let others = text.chars().filter(|c| !c.is_ascii()).count();
        let (at, first) = text.char_indices().find(|(_, c)| !c.is_ascii()).unwrap_or_default();
        let span = Span::new(at as u32, (at + first.len_utf8()) as u32);
        let message = match others {
            1 => say!("`{}` is not an ISO 646 character; the file is read as {}", first, encoding),
            _ => say!(
                "{} characters are not in ISO 646, starting with `{}`; the file is read as {}",
                others,
                first,
                encoding
            ),
        };
        findings.push(
            Diagnostic::new(&NOT_ASCII, span, message)
                .help("use 7-bit characters, such as `deg C` or `ue`")
                .fix(Fix::risky("write 7-bit characters").with(Change::Tidy(Tidy::Iso646))),
        );
    }
    // without an early exit, the compiler vectorises the loop over a chunk
    let has_control = |chunk: &[u8]| chunk.iter().fold(false, |found, byte| found | is_control(byte));
    if text.as_bytes().chunks(4096).any(has_control) {
        for line in document.lines() {
            let bytes = line.span.of(text).as_bytes();
            if let Some(at) = bytes.iter().position(is_control) {
                let start = line.span.start + at as u32;
                let message = say!("control character {:02X}h", bytes[at]);
                let finding = Diagnostic::new(&CONTROL_CHARACTER, Span::new(start, start + 1), message);
                findings.push(finding.help("remove the character").fix(without_controls(&line, text)));
            }
        }
    }
}

/// Removes all control characters from a line in one edit. In an otherwise blank line this is safe.
fn without_controls(line: &Line, text: &str) -> Fix {
    let title = "remove the control characters from the line";
    let fix = if line.kind == LineKind::Blank { Fix::safe(title) } else { Fix::risky(title) };
    let bytes = line.span.of(text).as_bytes();
    let first = bytes.iter().position(is_control).unwrap_or_default() as u32;
    let end = bytes.iter().rposition(is_control).map_or(first, |last| last as u32 + 1);
    let span = Span::new(line.span.start + first, line.span.start + end);
    let rest = span.of(text).chars().filter(|c| !u8::try_from(*c).is_ok_and(|byte| is_control(&byte)));
    fix.replace(span, rest.collect::<String>())
}

fn is_control(byte: &u8) -> bool {
    *byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r') || *byte == 0x7F
}

/// Style findings that may affect every line are reported once, at the first line, with the number of lines.
struct LineCheck<'a> {
    text: &'a str,
    first_section: Option<Span>,
    /// The first line end of the file.
    line_end: Option<LineEnd>,
    /// The first line with a different line end.
    mixed: Option<Diagnostic>,
    /// Whether a line ends with a lone CR.
    lone_cr: bool,
    comment: Option<(Span, u32)>,
    blank: Option<(Span, u32)>,
    findings: &'a mut Findings,
}

/// The characters at the end of a line.
#[derive(Clone, Copy, PartialEq, Eq)]
enum LineEnd {
    None,
    Lf,
    Cr,
    CrLf,
}

impl LineEnd {
    fn of(text: &str, line: &Line) -> Self {
        match (line.next - line.span.end, text.as_bytes().get(line.span.end as usize)) {
            (2, _) => Self::CrLf,
            (_, Some(b'\n')) => Self::Lf,
            (_, Some(_)) => Self::Cr,
            (_, None) => Self::None,
        }
    }
}

fn count(counter: &mut Option<(Span, u32)>, span: Span) {
    counter.get_or_insert((span, 0)).1 += 1;
}

impl<'a> LineCheck<'a> {
    fn new(text: &'a str, findings: &'a mut Findings) -> Self {
        Self {
            text,
            first_section: None,
            line_end: None,
            mixed: None,
            lone_cr: false,
            comment: None,
            blank: None,
            findings,
        }
    }
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

    #[inline]
    fn check_line_end(&mut self, line: &Line) {
        let line_end = LineEnd::of(self.text, line);
        self.lone_cr |= line_end == LineEnd::Cr;
        let first = *self.line_end.get_or_insert(line_end);
        if line_end != first || line_end == LineEnd::Cr {
            self.check_other_line_end(line, line_end);
        }
    }

    fn check_other_line_end(&mut self, line: &Line, line_end: LineEnd) {
        let message = match line_end {
            LineEnd::None => return,
            LineEnd::Cr => "the line ends with a lone CR",
            LineEnd::Lf => "the line ends with LF, but the previous lines with CR LF",
            LineEnd::CrLf => "the line ends with CR LF, but the previous lines with LF",
        };
        if self.mixed.is_none() {
            let finding = Diagnostic::new(&MIXED_LINE_ENDS, Span::new(line.span.end, line.next), message);
            self.mixed = Some(finding.help("use CR LF or LF in the whole file"));
        }
    }

    fn check_length(&mut self, line: &Line) {
        let length = line.span.of(self.text).chars().count();
        if length > MAX_LINE {
            let message = say!("the line has {} characters, but at most {} are allowed", length, MAX_LINE);
            let finding = Diagnostic::new(&LINE_TOO_LONG, Span::empty(line.span.start), message);
            self.findings.push(match line.kind {
                LineKind::Entry { key, .. } => {
                    let key = key.of(self.text);
                    let most = MAX_LINE.saturating_sub(key.chars().count() + 1);
                    finding.help(say!("shorten the value of `{}` to {} characters", key, most))
                }
                _ => finding.help("shorten the line"),
            });
        }
    }

    fn junk(&mut self, line: &Line) {
        let text = line.span.of(self.text).trim();
        let shown: String = text.chars().take(40).collect();
        let finding =
            Diagnostic::new(&JUNK_LINE, line.span, say!("`{}` is not a section, key or comment", shown));
        self.findings.push(if is_merge_mark(text) {
            finding.help("resolve the merge conflict: keep one of the two versions and remove the markers")
        } else if let Some(before) = before_header(text) {
            let start = line.span.of(self.text).find(before).unwrap_or_default() as u32 + line.span.start;
            let before = Span::new(line.span.start, start + before.len() as u32);
            without_text(finding, before, self.text, Fix::risky)
        } else {
            let title = "change the line to a comment";
            // without its possible header, a section would be read as part of the previous one
            let fix = if text.contains(['[', ']']) { Fix::risky(title) } else { Fix::safe(title) };
            let fix = fix.with(Change::CommentOut(line.span));
            finding.help("remove the line, or put a `;` before it").fix(fix)
        });
    }

    fn section(&mut self, line: &Line, name: Span) {
        self.first_section.get_or_insert(line.span);
        let text = line.span.of(self.text);
        if text.ends_with(']') && name.start == line.span.start + 1 && name.end + 1 == line.span.end {
            return;
        }
        let indent = text.find('[').unwrap_or_default() as u32;
        let span = Span::new(line.span.start, line.span.start + indent);
        if !span.of(self.text).trim_matches([' ', '\t', '\0', '\u{1A}']).is_empty() {
            let message = say!("`{}` precedes the section header", span.of(self.text).trim());
            let finding = Diagnostic::new(&JUNK_LINE, span, message);
            let finding = without_text(finding, span, self.text, Fix::safe);
            // the section is read, unless there is a second version of it
            self.findings.push(if is_merge_mark(text) { finding } else { finding.understood() });
        } else if indent > 0 {
            let finding = Diagnostic::new(&INDENTED_SECTION, span, "spaces before the section header");
            let fix = Fix::safe("remove the spaces").replace(span, "");
            self.findings.push(finding.help("write the `[` in the first column").fix(fix));
        }
        // a bracket in the junk before the header ends nothing
        let Some(close) = text[indent as usize..].find(']').map(|length| indent as usize + length) else {
            let finding = Diagnostic::new(&UNCLOSED_SECTION, line.span, say!("`{}` has no `]`", text.trim()));
            let fix = Fix::risky("add the `]`").replace(Span::empty(name.end), "]");
            self.findings.push(finding.help("add the `]`").fix(fix));
            return;
        };
        let close = line.span.start + close as u32;
        let behind = Span::new(close + 1, line.span.end);
        if !behind.of(self.text).trim().is_empty() {
            let message = say!("`{}` follows the section header", behind.of(self.text).trim());
            let finding = Diagnostic::new(&TEXT_AFTER_SECTION, behind, message);
            let fix = comment_above(behind, behind.of(self.text).trim());
            self.findings.push(finding.help("put the text in a separate comment line").fix(fix));
        }
        if name.start != line.span.start + indent + 1 || name.end != close {
            let span = Span::new(line.span.start + indent, close + 1);
            let finding = Diagnostic::new(&BLANKS_IN_SECTION_NAME, span, "spaces inside the brackets");
            let written = format!("[{}]", name.of(self.text));
            let title = say!("write `{}`", written);
            self.findings.push(finding.help(title.clone()).fix(Fix::safe(title).replace(span, written)));
        }
    }

    fn key_before_section(&mut self, key: Span) {
        let message = say!("`{}` precedes the first section", key.of(self.text));
        let finding = Diagnostic::new(&KEY_BEFORE_SECTION, key, message);
        self.findings.push(finding.help("add the section header above the key"));
        // later keys have the same cause: the missing header
        self.first_section = Some(key);
    }

    fn finish(self) {
        if let Some(finding) = self.mixed {
            let title = "use the same line end in all lines";
            // some tools do not treat a lone CR as line end
            let fix = if self.lone_cr { Fix::risky(title) } else { Fix::safe(title) };
            self.findings.push(finding.fix(fix.with(Change::Tidy(Tidy::LineEnds))));
        }
        if let Some((span, lines)) = self.comment {
            let lines = counted(lines as usize, "comment line does", "comment lines do");
            let message = say!("{} not start with `;` in the first column", lines);
            let fix = Fix::safe("start all comment lines with `;`").with(Change::Tidy(Tidy::Comments));
            let finding = Diagnostic::new(&COMMENT_STYLE, span, message);
            self.findings.push(finding.help("start a comment line with `;`").fix(fix));
        }
        if let Some((span, lines)) = self.blank {
            let lines = counted(lines as usize, "line has", "lines have");
            let message = say!("{} spaces before the key or the `=`", lines);
            let fix = Fix::safe("remove the spaces before all keys and `=`").with(Change::Tidy(Tidy::Keys));
            let finding = Diagnostic::new(&BLANK_BEFORE_EQUALS, span, message);
            self.findings.push(finding.help("remove the spaces before the key and the `=`").fix(fix));
        }
        if self.first_section.is_none() {
            let finding = Diagnostic::new(&NO_SECTION, Span::empty(0), "the file has no section");
            self.findings.push(finding.help("check the file name: the file is not an EDS or DCF"));
        }
    }
}

/// Whether a line is a conflict marker of a merge.
pub(crate) fn is_merge_mark(line: &str) -> bool {
    ["<<<<<<<", "=======", ">>>>>>>", "|||||||"].iter().any(|mark| line.trim_start().starts_with(mark))
}

/// The text before a section header in the same line.
fn before_header(text: &str) -> Option<&str> {
    let (before, name) = text.strip_suffix(']')?.rsplit_once('[')?;
    (!name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphanumeric())).then_some(before)
}

/// A finding about text before a section header, with a fix that moves it to a comment.
fn without_text(finding: Diagnostic, before: Span, text: &str, kind: fn(&'static str) -> Fix) -> Diagnostic {
    let comment = Change::Comment(before, before.of(text).trim().to_owned());
    let fix = kind("put the text before the header in a separate comment line");
    finding.help("remove the text before the header").fix(fix.replace(before, "").with(comment))
}

/// Moves text after a section header to a comment above it. Text that does not look like a comment may have
/// another purpose.
fn comment_above(span: Span, text: &str) -> Fix {
    let title = "put the text in a separate comment line";
    let is_comment = text.starts_with([';', '#']) || text.starts_with("//");
    let comment = text.trim_start_matches([';', '#', '/']).trim();
    let fix = if is_comment { Fix::safe(title) } else { Fix::risky(title) };
    let fix = fix.replace(span, "");
    if comment.is_empty() { fix } else { fix.with(Change::Comment(span, comment.to_owned())) }
}

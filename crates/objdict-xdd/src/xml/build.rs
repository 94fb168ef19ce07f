//! Builds the tree from a text. The builder never stops: after malformed markup it continues where the author
//! most likely intended the markup to end.

use quick_xml::Reader;

use super::chars::{is_blank, is_forbidden, is_name};
use super::findings::{self as rules, shown};
use super::markup::Markup;
use super::names::Name;
use super::namespaces::Namespaces;
use super::parts::{NONE, Parts, Record};
use super::prolog;
use super::tag::{RawAttribute, name_length};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Severity};
use crate::source::{SourceFile, Span};

/// The maximum depth of elements.
const MAX_DEPTH: usize = 256;

/// The maximum number of elements of a tree.
const MAX_ELEMENTS: usize = 4_000_000;

/// The maximum length of a name in bytes; the length field also contains a flag.
pub(super) const MAX_NAME: usize = 32_000;

/// The tree of a source.
pub(super) fn build(source: &SourceFile, findings: &mut Findings) -> Parts {
    let mut builder = TreeBuilder::new(source, findings);
    builder.check_characters();
    builder.read();
    builder.finish()
}

pub(super) struct TreeBuilder<'a, 'f> {
    source: &'a SourceFile,
    pub(super) text: &'a str,
    findings: &'f mut Findings,
    pub(super) parts: Parts,
    pub(super) namespaces: Namespaces<'a>,
    /// The attributes of the current tag.
    pub(super) raw: Vec<RawAttribute>,
    /// The open elements, from the root to the innermost.
    pub(super) open: Vec<OpenElement>,
    pub(super) skip: Option<Skip>,
    /// The encoding that the XML declaration names.
    pub(super) encoding: Option<Span>,
    pub(super) has_document_type: bool,
    /// Whether the text contains `&`.
    pub(super) has_references: bool,
    /// Whether the text contains `]]>`.
    pub(super) has_section_ends: bool,
    /// The number of bytes that entities of the document added.
    pub(super) expanded: usize,
    /// The kinds of [`Markup`] without an end in the rest of the text.
    endless: [bool; 3],
    has_endless_type: bool,
    is_stopped: bool,
    /// Whether content was omitted because of a limit.
    is_limited: bool,
}

/// An element whose end tag has not been read yet.
pub(super) struct OpenElement {
    id: u32,
    last_child: u32,
    namespaces: usize,
    name: Span,
}

/// A branch of the document that is skipped.
pub(super) struct Skip {
    start: usize,
    depth: usize,
}

impl<'a, 'f> TreeBuilder<'a, 'f> {
    fn new(source: &'a SourceFile, findings: &'f mut Findings) -> Self {
        let text = source.text();
        let parts = Parts { is_complete: true, ..Parts::default() };
        Self {
            source,
            text,
            findings,
            parts,
            namespaces: Namespaces::new(),
            raw: Vec::new(),
            open: Vec::new(),
            skip: None,
            encoding: None,
            has_document_type: false,
            has_references: memchr::memchr(b'&', text.as_bytes()).is_some(),
            has_section_ends: memchr::memmem::find(text.as_bytes(), b"]]>").is_some(),
            expanded: 0,
            endless: [false; 3],
            has_endless_type: false,
            is_stopped: false,
            is_limited: false,
        }
    }

    pub(super) fn report(&mut self, rule: &'static RuleInfo, make: impl FnOnce() -> Diagnostic) {
        // a finding that is only counted needs no message
        let is_full = self.findings.is_full(rule);
        let mut finding = if is_full { Diagnostic::new(rule, Span::default(), "") } else { make() };
        if !is_full && finding.help.is_none() {
            finding = finding.help(rules::advice(rule));
        }
        self.parts.is_complete &= finding.severity != Severity::Error;
        self.findings.push(finding);
    }

    /// Reports a rule at a place, with a message based on the text there.
    pub(super) fn defect(
        &mut self,
        rule: &'static RuleInfo,
        span: Span,
        message: impl FnOnce(&str) -> String,
    ) {
        let text = self.text;
        self.report(rule, || Diagnostic::new(rule, span, message(&shown(span.of(text)))));
    }

    /// Whether the current branch is skipped.
    pub(super) fn is_skipping(&self) -> bool {
        self.skip.is_some()
    }

    pub(super) fn span(start: usize, end: usize) -> Span {
        Span::new(start as u32, end as u32)
    }

    /// The position of the first match of `needle` in the text from `start` on.
    pub(super) fn find(&self, start: usize, needle: impl Fn(u8) -> bool) -> usize {
        let rest = self.text.as_bytes().get(start..).unwrap_or_default();
        rest.iter().position(|&byte| needle(byte)).map_or(self.text.len(), |length| start + length)
    }

    fn check_characters(&mut self) {
        let bytes = self.text.as_bytes();
        let is_control = |byte: u8| byte < 0x20 && !matches!(byte, b'\t' | b'\n' | b'\r');
        let has_control = bytes.iter().fold(false, |found, &byte| found | is_control(byte));
        let has_nonsense = || memchr::memmem::find(bytes, b"\xEF\xBF").is_some();
        if !has_control && !has_nonsense() {
            return;
        }
        for (at, character) in self.text.char_indices().filter(|&(_, character)| is_forbidden(character)) {
            let span = Self::span(at, at + character.len_utf8());
            self.defect(&rules::FORBIDDEN_CHARACTER, span, |_| {
                format!("XML forbids the character U+{:04X}", u32::from(character))
            });
        }
    }

    fn read(&mut self) {
        let bytes = self.text.as_bytes();
        let mut at = if self.text.starts_with('\u{FEFF}') { 3 } else { 0 };
        while !self.is_stopped {
            at = match (bytes.get(at), bytes.get(at + 1)) {
                (None, _) => break,
                (Some(b'<'), Some(b'!' | b'?')) => self.markup(at),
                (Some(b'<'), Some(b'/')) => self.end_tag(at),
                (Some(b'<'), _) => self.start_tag(at),
                _ => self.run(at),
            };
        }
        if !self.is_stopped {
            self.close_all();
        }
    }

    /// Records that the innermost element may contain text.
    pub(super) fn mark_text(&mut self) {
        if let Some(record) = self.open.last().and_then(|open| self.parts.elements.get_mut(open.id as usize))
        {
            record.has_text = true;
        }
    }

    fn stop(&mut self, at: usize) {
        self.is_stopped = true;
        while !self.open.is_empty() {
            self.close(at, at);
        }
    }

    pub(super) fn limit(&mut self, at: usize, message: String) {
        self.is_limited = true;
        self.defect(&rules::LIMIT, Span::empty(at as u32), |_| message);
    }

    /// Reads markup that starts with `<!` or `<?`; returns where to continue.
    fn markup(&mut self, start: usize) -> usize {
        let rest = &self.text.as_bytes()[start..];
        let Some(markup) = Markup::at(rest) else {
            let is_type = rest.get(..9).is_some_and(|mark| mark.eq_ignore_ascii_case(b"<!DOCTYPE"));
            return if is_type { self.type_at(start) } else { self.unknown_markup(start) };
        };
        // a failed search is not repeated: that would need quadratic time
        let is_endless = &mut self.endless[markup as usize];
        let length = if *is_endless { None } else { markup.length(rest) };
        *is_endless = length.is_none();
        let is_closed = |length: &usize| *length > "<?>".len();
        let Some(end) = length.filter(is_closed).map(|length| start + length) else {
            return self.unclosed_markup(start, markup);
        };
        match markup {
            Markup::Comment => self.comment(start, end),
            Markup::Instruction => self.instruction(start, end),
            Markup::Section => {
                self.mark_text();
                self.outside_root(start, end);
            }
        }
        end
    }

    /// Reads the document type at `start`, which ends where quick-xml finds its end; returns where to continue.
    fn type_at(&mut self, start: usize) -> usize {
        let mut reader = Reader::from_str(&self.text[start..]);
        let is_read = !self.has_endless_type && reader.read_event().is_ok();
        let end = self.text.len() - reader.get_ref().len();
        self.has_endless_type |= end == start;
        let end = if end > start { end } else { self.find(start + 9, |byte| byte == b'<') };
        self.document_type(start, end);
        if is_read { end } else { self.pass_over(start, end) }
    }

    /// Records that the text from `start` to `end` is neither markup nor character data.
    pub(super) fn pass_over(&mut self, start: usize, end: usize) -> usize {
        if !self.is_skipping() && !self.open.is_empty() {
            self.mark_text();
            self.parts.damage.push(Self::span(start, end));
        }
        end
    }

    fn unclosed_markup(&mut self, start: usize, markup: Markup) -> usize {
        let (mark, end_mark) = markup.marks();
        let behind = start + mark.len();
        let (what, end) = match markup {
            Markup::Comment => ("comment", self.find(behind, |byte| byte == b'<')),
            Markup::Instruction => ("processing instruction", self.find(behind, |byte| byte == b'<')),
            Markup::Section => ("CDATA section", behind),
        };
        if !self.is_skipping() {
            let span = Self::span(start, start + self.text[start..end].trim_ascii_end().len());
            self.defect(&rules::UNCLOSED_MARKUP, span, |_| format!("the {what} has no `{end_mark}`"));
        }
        self.pass_over(start, end)
    }

    fn unknown_markup(&mut self, start: usize) -> usize {
        let stop = self.find(start + 1, |byte| matches!(byte, b'<' | b'>'));
        let end = if self.text.as_bytes().get(stop) == Some(&b'>') { stop + 1 } else { stop };
        if !self.is_skipping() {
            let span = Self::span(start, end);
            self.defect(&rules::UNKNOWN_MARKUP, span, |text| format!("`{text}` is not valid XML markup"));
        }
        self.pass_over(start, end)
    }

    /// Reads the start tag at `start`; returns where to continue.
    fn start_tag(&mut self, start: usize) -> usize {
        let name = start + 1..start + 1 + name_length(&self.text.as_bytes()[start + 1..]);
        let is_tag = !name.is_empty() && (is_name_start(self.text, name.start) || self.has_tag_end(name.end));
        if !is_tag {
            return self.lone_less_than(start);
        }
        let is_read = self.may_open(start, name.len());
        let first = self.parts.attributes.len();
        let plain = if is_read { self.plain_attributes(name.end) } else { None };
        let (end, is_empty) = plain.unwrap_or_else(|| self.tag(name.clone(), is_read));
        if !is_read {
            self.skip_tag(start, end, is_empty);
            return end;
        }
        let id = self.parts.elements.len() as u32;
        let parent = self.open.last_mut();
        let parent_id = parent.as_ref().map_or(NONE, |parent| parent.id);
        let last = parent.map_or(NONE, |parent| std::mem::replace(&mut parent.last_child, id));
        if let Some(last) = self.parts.elements.get_mut(last as usize) {
            last.next = id;
        }
        let namespaces = self.namespaces.mark();
        self.parts.elements.push(Record {
            start: start as u32,
            tag_end: end as u32,
            inner_end: end as u32,
            end: end as u32,
            parent: parent_id,
            next: NONE,
            attributes: first as u32,
            namespace: NONE,
            name_length: name.len() as u16,
            prefix_length: 0,
            tag: Name::OTHER,
            has_text: false,
        });
        match plain {
            Some(_) => self.name_element(name.clone()),
            None => self.attributes(name.clone()),
        }
        if is_empty {
            self.namespaces.forget(namespaces);
        } else {
            self.open.push(OpenElement {
                id,
                last_child: NONE,
                namespaces,
                name: Self::span(name.start, name.end),
            });
        }
        end
    }

    /// Whether the next `<` or `>` is a `>`.
    fn has_tag_end(&self, at: usize) -> bool {
        let stop = self.find(at, |byte| matches!(byte, b'<' | b'>'));
        self.text.as_bytes().get(stop) == Some(&b'>')
    }

    fn lone_less_than(&mut self, start: usize) -> usize {
        if self.open.is_empty() {
            self.outside_root(start, start + 1);
        } else if !self.is_skipping() {
            self.mark_text();
            let span = Self::span(start, start + 1);
            self.report(&rules::LONE_LESS_THAN, || {
                Diagnostic::new(&rules::LONE_LESS_THAN, span, "the `<` does not start a tag")
                    .help("write `&lt;`")
            });
        }
        start + 1
    }

    /// Whether an element that starts at `start` is read and not skipped.
    fn may_open(&mut self, start: usize, name_length: usize) -> bool {
        if self.is_skipping() {
            return false;
        }
        if self.open.is_empty() && !self.parts.elements.is_empty() {
            let first = Self::span(0, 1 + self.parts.elements[0].name_length as usize);
            let first = Span::new(self.parts.elements[0].start, self.parts.elements[0].start + first.end);
            let second = Self::span(start, start + 1 + name_length);
            self.report(&rules::SECOND_ROOT, || {
                Diagnostic::new(&rules::SECOND_ROOT, second, "a second element follows the root")
                    .label(first, "the root")
            });
            return false;
        }
        if self.open.len() >= MAX_DEPTH {
            self.limit(start, format!("elements are nested more than {MAX_DEPTH} deep"));
            return false;
        }
        if name_length > MAX_NAME {
            self.limit(start, format!("a name has more than {MAX_NAME} bytes"));
            return false;
        }
        if self.parts.elements.len() >= MAX_ELEMENTS {
            self.limit(start, format!("the file has more than {MAX_ELEMENTS} elements"));
            self.stop(start);
            return false;
        }
        true
    }

    fn skip_tag(&mut self, start: usize, end: usize, is_empty: bool) {
        match &mut self.skip {
            Some(skip) if !is_empty => skip.depth += 1,
            Some(_) => {}
            None if is_empty => {
                self.pass_over(start, end);
            }
            None => self.skip = Some(Skip { start, depth: 1 }),
        }
    }

    /// Reads the end tag at `start`; returns where to continue.
    fn end_tag(&mut self, start: usize) -> usize {
        let bytes = self.text.as_bytes();
        if let (Some(open), None) = (self.open.last(), &self.skip) {
            let name = &bytes[open.name.start as usize..open.name.end as usize];
            let end = start + 2 + name.len();
            if bytes.get(start + 2..end) == Some(name) && bytes.get(end) == Some(&b'>') {
                self.close(start, end + 1);
                return end + 1;
            }
        }
        let name = start + 2..start + 2 + name_length(&self.text.as_bytes()[start + 2..]);
        let behind = self.find(name.end, |byte| !is_blank(byte));
        let stop = self.find(behind, |byte| matches!(byte, b'<' | b'>'));
        let is_closed = self.text.as_bytes().get(stop) == Some(&b'>');
        let end = if is_closed { stop + 1 } else { stop };
        if let Some(skip) = &mut self.skip {
            skip.depth -= 1;
            if skip.depth == 0 {
                let from = skip.start;
                self.skip = None;
                self.pass_over(from, end);
            }
            return end;
        }
        let text = self.text;
        if !is_closed {
            self.defect(&rules::UNCLOSED_TAG, Self::span(start, name.end), |_| {
                format!("the end tag `</{}` has no `>`", shown(&text[name.clone()]))
            });
        } else if behind < stop {
            let junk = Self::span(behind, stop);
            self.defect(&rules::JUNK_IN_TAG, junk, |junk| format!("unexpected `{junk}` in an end tag"));
        }
        self.close_by(Self::span(start, end), &text[name]);
        end
    }

    /// Closes the elements that an end tag closes.
    fn close_by(&mut self, tag: Span, name: &'a str) {
        let text = self.text;
        let found = self.open.iter().rposition(|open| open.name.of(text) == name);
        if let Some(depth) = found {
            while self.open.len() > depth + 1 {
                self.report_unclosed(|| {
                    let around = format!("`</{}>` ends the parent element", shown(name));
                    (tag, around)
                });
                self.close(tag.start as usize, tag.start as usize);
            }
            return self.close(tag.start as usize, tag.end as usize);
        }
        let start = self.open.last().map(|open| open.name);
        let meant = start.filter(|start| local_name(start.of(text)).eq_ignore_ascii_case(local_name(name)));
        self.report(&rules::STRAY_END_TAG, || match meant {
            Some(start) => {
                let message = format!("the end tag `</{}>` differs from its start tag", shown(name));
                Diagnostic::new(&rules::STRAY_END_TAG, tag, message).label(start, "the start tag")
            }
            None => {
                let message = format!("the end tag `</{}>` has no start tag", shown(name));
                Diagnostic::new(&rules::STRAY_END_TAG, tag, message)
            }
        });
        match meant {
            Some(_) => self.close(tag.start as usize, tag.end as usize),
            None => {
                self.pass_over(tag.start as usize, tag.end as usize);
            }
        }
    }

    fn report_unclosed(&mut self, end: impl FnOnce() -> (Span, String)) {
        let Some(open) = self.open.last() else { return };
        let name = open.name;
        let text = self.text;
        self.report(&rules::UNCLOSED_ELEMENT, || {
            let (span, label) = end();
            let message = format!("the element `{}` has no end tag", shown(name.of(text)));
            Diagnostic::new(&rules::UNCLOSED_ELEMENT, Span::new(name.start - 1, name.end), message)
                .label(span, label)
        });
    }

    /// Closes the innermost element.
    fn close(&mut self, inner_end: usize, end: usize) {
        let Some(open) = self.open.pop() else { return };
        self.namespaces.forget(open.namespaces);
        if let Some(record) = self.parts.elements.get_mut(open.id as usize) {
            record.inner_end = inner_end as u32;
            record.end = end as u32;
        }
    }

    /// Closes the elements that are open at the end of the file.
    fn close_all(&mut self) {
        let end = self.text.len();
        if let Some(skip) = self.skip.take() {
            self.pass_over(skip.start, end);
        }
        while !self.open.is_empty() {
            self.report_unclosed(|| (Self::span(end, end), "the file ends here".to_owned()));
            self.close(end, end);
        }
    }

    fn finish(mut self) -> Parts {
        if self.parts.elements.is_empty() && !self.is_limited {
            self.defect(&rules::NO_ROOT, Span::empty(0), |_| "the file has no elements".to_owned());
        }
        let declared = self.encoding.map(|span| span.of(self.text));
        if let Some(message) = prolog::encoding_defect(declared, self.source.encoding(), self.text) {
            self.defect(&rules::ENCODING, self.encoding.unwrap_or_default(), |_| message);
        }
        self.parts.namespaces = self.namespaces.into_uris();
        self.parts.elements.shrink_to_fit();
        self.parts.attributes.shrink_to_fit();
        self.parts
    }
}

fn is_name_start(text: &str, at: usize) -> bool {
    text[at..].chars().next().is_some_and(|first| is_name(first.encode_utf8(&mut [0; 4])))
}

fn local_name(name: &str) -> &str {
    name.rsplit(':').next().unwrap_or(name)
}

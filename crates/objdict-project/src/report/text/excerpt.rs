//! The source lines of a finding, as requested by miette. The source's own line table is used; miette's stock sources
//! search the whole text for every label.

use std::borrow::Cow;

use miette::{LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};

use objdict_model::diagnostic::{one_line, visible};
use objdict_model::source::{SourceFile, Span};

/// The maximum number of bytes shown of a line; a longer one is reduced to a window around the label.
const MAX_LINE: usize = 300;

/// The maximum number of underlined bytes of a line.
const MAX_LABEL: usize = 120;

/// Bytes to either side of a label that are shown of a line that is too long.
const MARGIN: usize = 60;

/// A source as it can be shown.
#[derive(Debug)]
pub(super) struct Excerpts<'a> {
    source: &'a SourceFile,
    name: String,
    text: Cow<'a, str>,
}

/// A source with labels in it.
pub(super) type Excerpted<'a> = (Excerpts<'a>, Vec<LabeledSpan>);

impl<'a> Excerpts<'a> {
    pub(super) fn new(source: &'a SourceFile) -> Self {
        Self { source, name: one_line(source.name()), text: visible_text(source.text()) }
    }

    /// The name of the source in reports.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// The underlined part of a span: within its first line, and limited in length.
    pub(super) fn cut(&self, span: Span) -> std::ops::Range<usize> {
        let start = self.floor((span.start as usize).min(self.text.len()));
        let limit = (span.end as usize).clamp(start, start.saturating_add(MAX_LABEL).min(self.text.len()));
        let end = self.floor(limit);
        let line_end = memchr::memchr2(b'\n', b'\r', &self.text.as_bytes()[start..end]);
        start..line_end.map_or(end, |length| start + length)
    }

    /// The last character boundary up to `at`.
    fn floor(&self, mut at: usize) -> usize {
        while !self.text.is_char_boundary(at) {
            at -= 1;
        }
        at
    }

    /// The bytes of a line, numbered from 0, and their end without the line end.
    fn line(&self, line: usize) -> (usize, usize) {
        let span = self.source.lines().line_span(&self.text, line);
        (span.start as usize, span.end as usize)
    }

    /// The bytes to show for `start..end` with this many lines around it; whole lines unless they are too
    /// long.
    fn window(&self, start: usize, end: usize, before: usize, after: usize) -> Option<(usize, usize)> {
        let lines = self.source.lines();
        let (first, last) = (lines.line_of(&self.text, start as u32), lines.line_of(&self.text, end as u32));
        let is_long = |(start, end): &(usize, usize)| end - start > MAX_LINE;
        if end - start > MAX_LINE && (first..=last).any(|line| is_long(&self.line(line))) {
            return None;
        }
        // lines of a source that has some of a file may be far from each other there
        let is_beside = |line: usize, other: usize| {
            lines.number(line).abs_diff(lines.number(other)) as usize == line.abs_diff(other)
        };
        let first_line = self.line(first);
        let mut from = first_line.0;
        if is_long(&first_line) {
            from = self.floor(start.saturating_sub(MARGIN).max(from));
        } else {
            let above = (first.saturating_sub(before)..first).rev();
            let above = above.take_while(|line| is_beside(*line, first)).map(|line| self.line(line));
            from = above.take_while(|line| !is_long(line)).last().map_or(from, |line| line.0);
        }
        let last_line = if last == first { first_line } else { self.line(last) };
        let mut to = last_line.1;
        if is_long(&last_line) {
            to = self.floor((end + MARGIN).min(to));
        } else {
            let below = last + 1..(last + 1 + after).min(lines.line_count());
            let below = below.take_while(|line| is_beside(*line, last)).map(|line| self.line(line));
            to = below.take_while(|line| !is_long(line)).last().map_or(to, |line| line.1);
        }
        Some((from, to))
    }
}

impl SourceCode for Excerpts<'_> {
    fn read_span<'a>(
        &'a self,
        span: &SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        let (start, end) = (span.offset(), span.offset() + span.len());
        if end > self.text.len() {
            return Err(MietteError::OutOfBounds);
        }
        let (from, to) = if lines_before == 0 && lines_after == 0 {
            (start, end)
        } else {
            self.window(start, end, lines_before, lines_after).ok_or(MietteError::OutOfBounds)?
        };
        let lines = self.source.lines();
        let at = lines.line_column(&self.text, from as u32);
        let [first, last] =
            [from, to.saturating_sub(1).max(from)].map(|at| lines.line_of(&self.text, at as u32));
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            &self.text.as_bytes()[from..to],
            (from, to - from).into(),
            at.line.saturating_sub(1) as usize,
            at.column as usize - 1,
            last + 1 - first,
        )))
    }
}

/// The text with every terminal control character replaced by one of the same length, so that all offsets remain; a
/// lone CR is shown as a line end.
fn visible_text(text: &str) -> Cow<'_, str> {
    let is_odd = |byte: u8| (byte.wrapping_sub(b' ') > b'~' - b' ') & !matches!(byte, b'\t' | b'\n' | b'\r');
    let bytes = text.as_bytes();
    // without an early exit, the compiler vectorises the loop over a chunk
    let has_odd = |chunk: &[u8]| chunk.iter().fold(false, |found, byte| found | is_odd(*byte));
    let has_lone_cr = || memchr::memchr_iter(b'\r', bytes).any(|at| bytes.get(at + 1) != Some(&b'\n'));
    if !bytes.chunks(4096).any(has_odd) && !has_lone_cr() {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    let mut characters = text.chars().peekable();
    while let Some(character) = characters.next() {
        shown.push(match character {
            '\r' if characters.peek() != Some(&'\n') => '\n',
            '\r' | '\n' => character,
            _ => match (visible(character), character.len_utf8()) {
                (char::REPLACEMENT_CHARACTER, 1) => '?',
                (char::REPLACEMENT_CHARACTER, 2) => '¿',
                (shown, _) => shown,
            },
        });
    }
    Cow::Owned(shown)
}

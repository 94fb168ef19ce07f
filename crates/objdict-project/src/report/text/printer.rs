//! Draws findings from miette's interface: their source lines, with marks under them. It looks like miette's own
//! report; a label remains within its line, because `Excerpts` truncates it.

use std::fmt::{self, Display, Write};
use std::ops::Range;

use miette::{Diagnostic, LabeledSpan, Severity, SourceCode, SourceSpan, SpanContents};

use super::excerpt::Excerpted;
use super::wrap;
use objdict_model::diagnostic::one_line;

/// The maximum number of characters shown of a message.
const MAX_MESSAGE: usize = 600;

/// The width of a report that is not written to a terminal.
pub(super) const WIDTH: usize = 80;

/// Columns from one tab stop to the next.
const TAB: usize = 4;

/// The styles of labels, in turn: purple, yellow, green, all bold.
const LABELS: [&str; 3] = ["35;1", "33;1", "32;1"];

/// A text in a terminal style; `None` without colours.
struct Styled<T>(Option<&'static str>, T);

impl<T: Display> Display for Styled<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(style) => write!(f, "\u{1B}[{style}m{}\u{1B}[0m", self.1),
            None => self.1.fmt(f),
        }
    }
}

/// Draws findings, with colours or without.
#[derive(Debug)]
pub(super) struct Printer {
    pub(super) colour: bool,
    /// The maximum width of a line in columns before its text is wrapped.
    pub(super) width: usize,
}

/// A label under a line.
struct Mark<'a> {
    label: &'a LabeledSpan,
    style: &'static str,
    /// The columns that are underlined.
    start: usize,
    end: usize,
}

impl Mark<'_> {
    /// The column at which the connector to a label's text starts.
    fn middle(&self) -> usize {
        usize::midpoint(self.start, self.end)
    }
}

impl Printer {
    fn styled<T>(&self, style: &'static str, text: T) -> Styled<T> {
        Styled(self.colour.then_some(style), text)
    }

    /// Draws a finding, with related places in other files below its own lines.
    pub(super) fn draw(
        &self,
        out: &mut String,
        diagnostic: &dyn Diagnostic,
        others: &[Excerpted<'_>],
    ) -> fmt::Result {
        let (icon, word, style) = match diagnostic.severity() {
            Some(Severity::Advice) => ('☞', "note", "36"),
            Some(Severity::Warning) => ('⚠', "warning", "33"),
            Some(Severity::Error) | None => ('×', "error", "31"),
        };
        if let Some(code) = diagnostic.code() {
            writeln!(out, "{}\n", self.styled(style, code))?;
        }
        let message = format!("{word}: {diagnostic}");
        for (number, line) in wrap::lines(&message, self.width - "  × ".chars().count()).iter().enumerate() {
            let line = match line.strip_prefix(word).filter(|_| number == 0) {
                Some(rest) => format!("{}{rest}", self.styled(style, word)),
                None => line.to_string(),
            };
            writeln!(out, "  {} {line}", self.styled(style, if number == 0 { icon } else { '│' }))?;
        }
        if let (Some(source), Some(labels)) = (diagnostic.source_code(), diagnostic.labels()) {
            self.draw_excerpts(out, source, &mut labels.collect::<Vec<_>>())?;
        }
        for (source, labels) in others {
            self.draw_excerpts(out, source, &mut labels.clone())?;
        }
        let Some(help) = diagnostic.help() else { return Ok(()) };
        const HELP: &str = "  help: ";
        for (number, line) in wrap::lines(&help.to_string(), self.width - HELP.len()).iter().enumerate() {
            match number {
                0 => writeln!(out, "{}{line}", self.styled("36", HELP))?,
                _ => writeln!(out, "{:width$}{line}", "", width = HELP.len())?,
            }
        }
        Ok(())
    }

    /// The labels with the lines around them; labels that are near each other are shown together.
    fn draw_excerpts(
        &self,
        out: &mut String,
        source: &dyn SourceCode,
        labels: &mut [LabeledSpan],
    ) -> fmt::Result {
        labels.sort_by_key(LabeledSpan::offset);
        let read = |span: SourceSpan| source.read_span(&span, 1, 1).map(|contents| (span, contents));
        let mut excerpts = Vec::<(SourceSpan, Box<dyn SpanContents<'_> + '_>)>::new();
        for label in &*labels {
            let excerpt = read(*label.inner()).map_err(|_| fmt::Error)?;
            let near =
                excerpts.last().filter(|(_, last)| last.line() + last.line_count() >= excerpt.1.line());
            let joint = near.and_then(|(span, _)| {
                let end = (span.offset() + span.len()).max(label.offset() + label.len());
                read((span.offset(), end - span.offset()).into()).ok()
            });
            if let Some(joint) = joint {
                excerpts.pop();
                excerpts.push(joint);
            } else {
                excerpts.push(excerpt);
            }
        }
        for (span, contents) in excerpts {
            let is_within = |label: &&LabeledSpan| {
                span.offset() <= label.offset() && label.offset() + label.len() <= span.offset() + span.len()
            };
            let mut within = labels.iter().filter(is_within);
            let first = within.clone().find(|label| label.primary()).or_else(|| within.next());
            let place =
                source.read_span(first.map_or(&span, LabeledSpan::inner), 0, 0).map_err(|_| fmt::Error)?;
            self.draw_excerpt(out, &*contents, &*place, labels)?;
        }
        Ok(())
    }

    /// Lines with the labels in them, below the place of the first.
    fn draw_excerpt(
        &self,
        out: &mut String,
        contents: &dyn SpanContents<'_>,
        place: &dyn SpanContents<'_>,
        labels: &[LabeledSpan],
    ) -> fmt::Result {
        let text = String::from_utf8_lossy(contents.data());
        let lines = || text.split_inclusive('\n').zip(contents.line() + 1..);
        let width = lines().last().map_or(1, |(_, number)| number.ilog10() as usize + 1);
        let (name, line, column) = (place.name().unwrap_or_default(), place.line() + 1, place.column() + 1);
        let place = format!("{name}:{line}:{column}");
        writeln!(out, "  {:width$}╭─[{}]", "", self.styled("36;1;4", place))?;
        let mut offset = contents.span().offset();
        let marked = lines().map(|(line, number)| {
            let shown = line.strip_suffix('\n').map_or(line, |line| line.strip_suffix('\r').unwrap_or(line));
            let marks = marks(labels, shown, offset..offset + line.len());
            offset += line.len();
            (shown, number, marks)
        });
        let mut marked: Vec<_> = marked.collect();
        let pane = Pane::new(self.width.saturating_sub(width + "  │ …".chars().count()), &marked);
        for (shown, number, marks) in &mut marked {
            write!(out, " {} │ ", self.styled("2", format_args!("{number:width$}")))?;
            pane.draw(out, shown, !marks.is_empty());
            pane.fit(marks);
            self.draw_marks(out, width, marks)?;
        }
        writeln!(out, "  {:width$}╰────", "")
    }

    /// The line under labels, and a line with the text of each.
    fn draw_marks(&self, out: &mut String, width: usize, marks: &[Mark<'_>]) -> fmt::Result {
        if marks.is_empty() {
            return Ok(());
        }
        write!(out, " {:width$} · ", "")?;
        let mut column = 0;
        for mark in marks {
            let Mark { label, style, start, end } = *mark;
            let middle = match label.label() {
                _ if label.is_empty() => '▲',
                Some(_) => '┬',
                None => '─',
            };
            let (indent, left, right) = (start - column, mark.middle() - start, end - mark.middle() - 1);
            let line = format!("{:indent$}{:─<left$}{middle}{:─<right$}", "", "", "");
            write!(out, "{}", self.styled(style, line))?;
            column = end;
        }
        out.push('\n');
        for mark in marks.iter().rev() {
            let Some(text) = mark.label.label() else { continue };
            write!(out, " {:width$} · ", "")?;
            let mut column = 0;
            for other in marks.iter().take_while(|other| other.start != mark.start) {
                let indent = other.middle() - column;
                write!(out, "{:indent$}{}", "", self.styled(other.style, '│'))?;
                column = other.middle() + 1;
            }
            let (indent, text) = (mark.middle() - column, self.styled(mark.style, text));
            writeln!(out, "{:indent$}{}", "", self.styled(mark.style, format!("╰── {text}")))?;
        }
        Ok(())
    }
}

/// The labels within a line, whose text and position are given.
fn marks<'a>(labels: &'a [LabeledSpan], line: &str, place: Range<usize>) -> Vec<Mark<'a>> {
    let mut from = 0;
    let mut marks = Vec::new();
    for (label, style) in labels.iter().zip(LABELS.into_iter().cycle()) {
        let (first, last) = (label.offset(), label.offset() + label.len());
        if place.contains(&first) && last <= place.end {
            let start = column_of(line, first - place.start).max(from);
            from = column_of(line, last - place.start).max(start + 1);
            marks.push(Mark { label, style, start, end: from });
        }
    }
    marks
}

/// The visible columns of long lines: those of the labels, and as many around them as fit.
struct Pane {
    /// The first column.
    from: usize,
    /// The column after the last one.
    to: usize,
}

impl Pane {
    fn new(room: usize, lines: &[(&str, usize, Vec<Mark<'_>>)]) -> Self {
        let marks = || lines.iter().flat_map(|(.., marks)| marks);
        let first = marks().map(|mark| mark.start).min().unwrap_or(0);
        let last = marks().map(|mark| mark.end).max().unwrap_or(0);
        let around = room.saturating_sub(last - first) / 2;
        let from = if last < room { 0 } else { first.saturating_sub(around) };
        Self { from, to: from + room }
    }

    /// Draws a part of a line, with spaces for tabs and `…` for hidden text. A short line without labels is
    /// shown from its start.
    fn draw(&self, out: &mut String, line: &str, has_marks: bool) {
        let is_short = !has_marks && column_of(line, line.len()) <= self.to - self.from;
        let (from, to) = if is_short { (0, self.to) } else { (self.from, self.to) };
        let mut column = 0;
        for character in line.chars() {
            let width = columns(column, character);
            let mut buffer = [0; 4];
            let shown = match character {
                _ if column + width <= from || column > to => "",
                _ if column < from || column == from && from > 0 || column + width > to => "…",
                '\t' => &"    "[..width],
                _ => character.encode_utf8(&mut buffer),
            };
            out.push_str(shown);
            column += width;
        }
        out.push('\n');
    }

    /// Moves labels to where their texts are shown.
    fn fit(&self, marks: &mut [Mark<'_>]) {
        let mut next = 0;
        for mark in marks {
            mark.start = (mark.start.clamp(self.from, self.to) - self.from).max(next);
            mark.end = (mark.end.clamp(self.from, self.to) - self.from).max(mark.start + 1);
            next = mark.end;
        }
    }
}

/// The width of a character in this column.
fn columns(column: usize, character: char) -> usize {
    if character == '\t' { TAB - column % TAB } else { wrap::columns(character) }
}

/// The column of a byte in a line; the line end is after the text.
fn column_of(line: &str, at: usize) -> usize {
    let text = line.get(..at).unwrap_or(line);
    let column = text.chars().fold(0, |column, character| column + columns(column, character));
    column + usize::from(at > line.len())
}

/// A message without control characters and truncated, because it may quote anything in a file.
pub(super) fn shown(message: &str) -> String {
    match message.char_indices().nth(MAX_MESSAGE) {
        Some((end, _)) => one_line(&message[..end]) + "…",
        None => one_line(message),
    }
}

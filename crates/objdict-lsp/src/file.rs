//! A file that a request is about.

use std::rc::Rc;

use super::analysis::Analysis;
use super::position::{ColumnUnit, Positions};
use super::protocol::{Position, TextEdit, Uri, WorkspaceEdit};
use objdict_format::Description;
use objdict_model::diagnostic::At;
use objdict_model::model::Place;
use objdict_model::source::{Edits, SourceFile, Span};
use objdict_project::line_diff::{LineChange, changes};

/// A file with its findings, and how its positions are counted.
#[derive(Clone)]
pub(super) struct CheckedFile {
    pub(super) analysis: Rc<Analysis>,
    pub(super) uri: Uri,
    pub(super) unit: ColumnUnit,
}

impl CheckedFile {
    pub(super) fn source(&self) -> &SourceFile {
        self.analysis.subject().source()
    }

    /// The name without its folders.
    pub(super) fn name(&self) -> &str {
        self.source().name().rsplit(['/', '\\']).next().unwrap_or_default()
    }

    /// The file with another text, which is read and checked; buffers count only where files are read in front of them.
    pub(super) fn again(&self, text: &str) -> Self {
        Self { analysis: Rc::new(self.analysis.again(text)), ..self.clone() }
    }

    /// The same with edits of its text; `None` where they overlap.
    pub(super) fn again_with(&self, edits: &[(Span, String)]) -> Option<Self> {
        let mut edited = Edits::new(self.source());
        edits.iter().for_each(|(span, new)| edited.replace(*span, new.as_str()));
        Some(self.again(&edited.text().ok()?))
    }

    pub(super) fn text(&self) -> &str {
        self.source().text()
    }

    pub(super) fn description(&self) -> Option<&Description> {
        self.analysis.description()
    }

    pub(super) fn positions(&self) -> Positions<'_> {
        Positions::new(self.source(), self.unit)
    }

    pub(super) fn offset(&self, position: Position) -> u32 {
        self.positions().offset(position)
    }

    /// The place in the model that an offset belongs to.
    pub(super) fn place(&self, offset: u32) -> Option<Place> {
        let at = At::Span(Span::empty(offset));
        self.description()?.place_of(&at).map(std::borrow::Cow::into_owned)
    }

    /// Edits of this file.
    pub(super) fn workspace_edit(&self, edits: Vec<TextEdit>) -> WorkspaceEdit {
        WorkspaceEdit::new(std::iter::once((self.uri.clone(), edits)).collect())
    }

    /// The edits of a fix, or of other spans with their new texts.
    pub(super) fn edits(&self, edits: Vec<(Span, String)>) -> Vec<TextEdit> {
        edits.into_iter().map(|edit| self.positions().edit(edit)).collect()
    }

    /// The edits that make another text of this one: those of the lines that differ.
    pub(super) fn edits_to(&self, text: &str) -> Vec<TextEdit> {
        let old: Vec<&str> = self.text().split_inclusive('\n').collect();
        let new: Vec<&str> = text.split_inclusive('\n').collect();
        let starts: Vec<usize> = std::iter::once(0)
            .chain(old.iter().scan(0, |at, line| {
                *at += line.len();
                Some(*at)
            }))
            .collect();
        let edit = |change: LineChange| {
            let span = Span::new(starts[change.old.start] as u32, starts[change.old.end] as u32);
            (span, new[change.new].concat())
        };
        self.edits(hunks(changes(&old, &new)).into_iter().map(edit).collect())
    }

    /// The word around an offset, of the characters that rules and indexes have.
    pub(super) fn word(&self, offset: u32) -> Span {
        let text = self.text();
        let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '/' | '-' | '_' | '.' | '$');
        let at = offset as usize;
        let (Some(before), Some(behind)) = (text.get(..at), text.get(at..)) else {
            return Span::empty(offset);
        };
        let start = before.trim_end_matches(is_part).len();
        let end = at + behind.len() - behind.trim_start_matches(is_part).len();
        Span::new(start as u32, end as u32)
    }
}

/// So many changes of a text are edits of their own.
const FEW: usize = 100;
/// Of more changes, those with fewer lines between them are one edit of at most `MOST_LINES`: editors need a millisecond for each.
const NEAR: usize = 16;
const MOST_LINES: usize = 256;

/// Many changes as few: neighbours together with the lines between them.
fn hunks(changes: Vec<LineChange>) -> Vec<LineChange> {
    if changes.len() <= FEW {
        return changes;
    }
    let mut hunks: Vec<LineChange> = Vec::new();
    for change in changes {
        let is_near = |last: &&mut LineChange| {
            change.old.start - last.old.end < NEAR && change.old.end - last.old.start <= MOST_LINES
        };
        match hunks.last_mut().filter(is_near) {
            Some(last) => (last.old.end, last.new.end) = (change.old.end, change.new.end),
            None => hunks.push(change),
        }
    }
    hunks
}

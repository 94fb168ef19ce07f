//! The patches applied to a description, and their results.

use std::sync::Arc;

use super::Patch;
use objdict_model::diagnostic::{At, Findings, Severity};
use objdict_model::model::{Part, Place};
use objdict_model::source::Span;

/// The patches applied to a description.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct Patched {
    /// The patches that are for it.
    pub patches: Vec<Arc<Patch>>,
    /// All given patches, for the other devices of the file.
    pub given: Vec<Arc<Patch>>,
    /// The findings of applying them, patch by patch; their places are spans of the patch.
    pub findings: Vec<Findings>,
    /// The changes: the place in the model, the patch and the span in it.
    pub causes: Vec<(Place, usize, Span)>,
}

impl Patched {
    /// Whether a patch could not be applied.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|findings| findings.worst() == Some(Severity::Error))
    }

    /// The patches, each with the findings of applying it.
    pub fn by_patch(&self) -> impl Iterator<Item = (&Patch, &Findings)> {
        self.patches.iter().map(|patch| &**patch).zip(&self.findings)
    }

    /// The problems, a line each: the patch with line and column, the severity, the rule and the message.
    pub fn lines(&self) -> Vec<String> {
        self.by_patch().flat_map(|(patch, findings)| lines(patch, findings)).collect()
    }

    /// The patch that changed a place of the model, and the span in it.
    pub fn cause_of(&self, place: &Place) -> Option<(usize, Span)> {
        let is_it = |cause: &Place| {
            let is_part = cause.part == place.part
                || cause.field.is_none()
                    && cause.part.object().is_some()
                    && cause.part == object_of(&place.part);
            is_part && (cause.field.is_none() || place.field.is_none() || cause.field == place.field)
        };
        self.causes.iter().rev().find(|(cause, ..)| is_it(cause)).map(|&(_, patch, span)| (patch, span))
    }
}

/// The findings of applying a patch, one line each.
pub(super) fn lines(patch: &Patch, findings: &Findings) -> Vec<String> {
    let span = |at: &At| match at {
        At::Span(span) => *span,
        _ => Span::default(),
    };
    findings.iter().map(|finding| finding.line(patch.source(), span)).collect()
}

/// The object that a part belongs to.
fn object_of(part: &Part) -> Part {
    part.object().map_or_else(|| part.clone(), Part::Object)
}

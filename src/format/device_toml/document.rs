//! The text of a device: places in it, and edits of it.

use std::sync::OnceLock;

use super::places::Places;
use crate::model::Place;
use crate::source::{SourceFile, Span};

/// A text with what finds places in it.
#[derive(Debug)]
pub(in crate::format) struct Document {
    source: SourceFile,
    places: OnceLock<Places>,
}

impl Document {
    pub(in crate::format) fn new(source: SourceFile) -> Self {
        Self { source, places: OnceLock::new() }
    }

    pub(in crate::format) fn source(&self) -> &SourceFile {
        &self.source
    }

    pub(super) fn places(&self) -> &Places {
        self.places.get_or_init(|| Places::new(self.source.text()))
    }

    /// The span of a place of the model.
    pub(in crate::format) fn locate(&self, place: &Place) -> Option<Span> {
        self.places().locate(place)
    }

    /// The part of the model at a byte.
    pub(in crate::format) fn place_at(&self, at: u32) -> Option<Place> {
        self.places().place_at(at)
    }
}

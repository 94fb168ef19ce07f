//! The text of a device: places in it, edits of it, and its variants.

use std::sync::{Arc, OnceLock};

use super::places::Places;
use crate::diagnostic::Findings;
use crate::model::{Device, Place};
use crate::source::{SourceFile, Span};

/// A text, or a variant of it, with what finds places in it.
#[derive(Debug)]
pub(in crate::format) struct Document {
    source: Arc<SourceFile>,
    variant: Option<String>,
    places: OnceLock<Places>,
}

impl Document {
    /// A text and the device that it describes.
    pub(in crate::format) fn read(source: SourceFile) -> (Self, Device, Findings) {
        let (device, findings) = super::read(source.text());
        (Self { source: Arc::new(source), variant: None, places: OnceLock::new() }, device, findings)
    }

    /// The same text as that of a variant, and the device that this describes.
    pub(in crate::format) fn read_variant(&self, variant: String) -> (Self, Device, Findings) {
        let (device, findings) = super::read_variant(self.source.text(), &variant);
        let source = Arc::clone(&self.source);
        (Self { source, variant: Some(variant), places: OnceLock::new() }, device, findings)
    }

    /// The names of the variants in the text.
    pub(in crate::format) fn variants(&self) -> Vec<String> {
        super::variants_of(self.source.text())
    }

    /// The variant that it is read as.
    pub(in crate::format) fn variant(&self) -> Option<&str> {
        self.variant.as_deref()
    }

    pub(in crate::format) fn source(&self) -> &SourceFile {
        &self.source
    }

    pub(super) fn places(&self) -> &Places {
        self.places.get_or_init(|| {
            let tree = super::merged(self.source.text(), self.variant(), &mut Findings::new());
            tree.map(|merged| Places::new(&merged.tree)).unwrap_or_default()
        })
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

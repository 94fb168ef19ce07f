//! The text of a device: places in it, edits of it, and its variants.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use super::extends::{self, Base};
use super::places::Places;
use objdict_model::diagnostic::Findings;
use objdict_model::model::{Device, Place};
use objdict_model::source::{SourceFile, Span};

/// A text, or a variant of it, with what finds places in it.
#[derive(Debug)]
pub(crate) struct Document {
    source: Arc<SourceFile>,
    base: Option<Arc<Base>>,
    variant: Option<String>,
    places: OnceLock<Places>,
}

impl Document {
    /// A text and the device that it describes.
    pub(crate) fn read(source: SourceFile) -> (Self, Device, Findings) {
        let mut findings = Findings::new();
        let base = extends::read(source.text(), source.name(), &mut findings).map(Arc::new);
        let device = super::read_on(source.text(), base.as_deref(), &mut findings);
        let source = Arc::new(source);
        (Self { source, base, variant: None, places: OnceLock::new() }, device, findings)
    }

    /// The same text as that of a variant, and the device that this describes.
    pub(crate) fn read_variant(&self, variant: String) -> (Self, Device, Findings) {
        let (device, findings) = super::read_variant(self.source.text(), self.base.as_deref(), &variant);
        let (source, base) = (Arc::clone(&self.source), self.base.clone());
        (Self { source, base, variant: Some(variant), places: OnceLock::new() }, device, findings)
    }

    /// The names of the variants in the text.
    pub(crate) fn variants(&self) -> Vec<String> {
        super::variants_of(self.source.text())
    }

    /// The variant that it is read as.
    pub(crate) fn variant(&self) -> Option<&str> {
        self.variant.as_deref()
    }

    /// What the text extends, and where it says so.
    pub(crate) fn extended(&self) -> Option<(&str, Span)> {
        self.base.as_ref().map(|base| (base.name.as_str(), base.span))
    }

    /// The files that the text extends, the nearest first.
    pub(crate) fn extended_files(&self) -> &[PathBuf] {
        self.base.as_ref().map(|base| &base.files[..]).unwrap_or_default()
    }

    pub(crate) fn source(&self) -> &SourceFile {
        &self.source
    }

    pub(super) fn places(&self) -> &Places {
        self.places.get_or_init(|| {
            let tree =
                super::merged(self.source.text(), self.base.as_deref(), self.variant(), &mut Findings::new());
            tree.map(|merged| Places::new(&merged.tree)).unwrap_or_default()
        })
    }

    /// The span of a place of the model.
    pub(crate) fn locate(&self, place: &Place) -> Option<Span> {
        self.places().locate(place)
    }

    /// The part of the model at a byte.
    pub(crate) fn place_at(&self, at: u32) -> Option<Place> {
        self.places().place_at(at)
    }
}

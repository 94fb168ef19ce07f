//! The text of a device: its positions, its edits, and its variants.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use super::edits::TomlEditor;
use super::extends::{self, Base};
use super::mentions;
use super::places::KeyPlaces;
use crate::mention::Mention;
use crate::text::{DescriptionText, NodeOfType, ReadText, TextEdits};
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::model::{Device, Place};
use objdict_model::source::{EditError, Edits, SourceFile, Span};

/// A text, or a variant in it, with its positions.
#[derive(Debug)]
struct TomlText {
    source: Arc<SourceFile>,
    base: Option<Arc<Base>>,
    variant: Option<String>,
    /// The names of its variants.
    variants: OnceLock<Vec<String>>,
    places: OnceLock<KeyPlaces>,
}

/// Reads a text and its device.
pub(crate) fn read(source: SourceFile) -> ReadText {
    let mut findings = Findings::new();
    let base = extends::read(source.text(), source.name(), &mut findings).map(Arc::new);
    let device = super::read_on(source.text(), base.as_deref(), &mut findings);
    (Box::new(TomlText::new(Arc::new(source), base, None)), device, findings)
}

impl TomlText {
    fn new(source: Arc<SourceFile>, base: Option<Arc<Base>>, variant: Option<String>) -> Self {
        Self { source, base, variant, variants: OnceLock::new(), places: OnceLock::new() }
    }

    fn places(&self) -> &KeyPlaces {
        self.places.get_or_init(|| {
            let tree =
                super::merged(self.source.text(), self.base.as_deref(), self.variant(), &mut Findings::new());
            tree.map(|merged| KeyPlaces::new(&merged.tree)).unwrap_or_default()
        })
    }

    fn editor(&self) -> TomlEditor<'_> {
        TomlEditor { text: self.source.text(), places: self.places() }
    }

    /// The bytes of the text with edits; `None` if the text does not fully define the device.
    fn edited(&self, edits: TextEdits) -> Option<Result<Vec<u8>, EditError>> {
        let mut edited = Edits::new(&self.source);
        edits.into_iter().for_each(|(span, text)| edited.replace(span, text));
        (self.variant.is_none() && self.base.is_none()).then(|| edited.to_bytes())
    }
}

impl DescriptionText for TomlText {
    fn source(&self) -> &SourceFile {
        &self.source
    }

    fn locate(&self, place: &Place) -> Option<Span> {
        self.places().locate(place)
    }

    fn place_at(&self, at: u32) -> Option<Place> {
        self.places().place_at(at)
    }

    fn sibling(&self, number: usize) -> Option<ReadText> {
        let variant = self.variants().get(number.checked_sub(1)?)?;
        let (device, findings) = super::read_variant(self.source.text(), self.base.as_deref(), variant);
        let text = Self::new(Arc::clone(&self.source), self.base.clone(), Some(variant.clone()));
        Some((Box::new(text), device, findings))
    }

    fn variants(&self) -> &[String] {
        self.variants.get_or_init(|| super::variants_of(self.source.text()))
    }

    fn variant(&self) -> Option<&str> {
        self.variant.as_deref()
    }

    fn extended(&self) -> Option<(&str, Span)> {
        self.base.as_ref().map(|base| (base.name.as_str(), base.span))
    }

    fn extended_files(&self) -> &[PathBuf] {
        self.base.as_ref().map(|base| &base.files[..]).unwrap_or_default()
    }

    fn mentions(&self) -> Option<Vec<Mention>> {
        Some(mentions::of(self.source.text()))
    }

    fn edits(&self, device: &Device, changes: &[Change]) -> Option<TextEdits> {
        self.editor().edits(device, changes)
    }

    fn can_take(&self, edits: &TextEdits) -> bool {
        self.editor().is_toml(edits)
    }

    fn of_node(&self, file_name: &str, node: Option<NodeOfType<'_>>) -> Option<Result<Vec<u8>, EditError>> {
        let edits = match node {
            Some((node, _)) => self.editor().to_node(file_name, node),
            None => self.editor().to_type(file_name),
        };
        self.edited(edits?)
    }

    fn arranged<'a>(&'a self, _: &'a Device) -> Option<Box<dyn Iterator<Item = String> + 'a>> {
        Some(Box::new(std::iter::once_with(|| self.editor().arranged())))
    }
}

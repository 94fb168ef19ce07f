//! The text of a description, in the syntax of its format: what each syntax implements beside its reader.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::path::PathBuf;

use objdict_eds::{eds::SectionStarts, ini};
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::model::{Commissioning, Device, Objects, Place};
use objdict_model::source::{EditError, SourceFile, Span};
#[cfg(feature = "xdd")]
use objdict_xdd::xml::Tree;

/// A text that was read, the device that it describes, and what the reader found.
pub(crate) type ReadText = (Box<dyn DescriptionText>, Device, Findings);

/// Edits: each span with its replacement.
pub(crate) type TextEdits = Vec<(Span, String)>;

/// A node, and the name of the EDS of the type that it is made from.
pub(crate) type NodeOfType<'a> = (&'a Commissioning, Option<&'a str>);

/// What was read of an INI file.
#[derive(Clone, Copy)]
pub(crate) struct LinesBefore<'a> {
    pub(crate) document: &'a ini::Document,
    pub(crate) plain: &'a Objects,
    pub(crate) sections: &'a SectionStarts,
    /// Whether its lines were checked and nothing was found in them.
    pub(crate) is_clean: bool,
}

/// A text that was read as one of its devices. What a syntax does not have, such as variants, it leaves as it is here.
pub(crate) trait DescriptionText: Debug + Send + Sync {
    /// The source.
    fn source(&self) -> &SourceFile;

    /// The span of a place of the model.
    fn locate(&self, place: &Place) -> Option<Span>;

    /// The place in the model at a byte.
    fn place_at(&self, _at: u32) -> Option<Place> {
        None
    }

    /// Where the objects of the dictionary are written, by index, in the order of the text; an object may have several spans. Empty
    /// where that is not known.
    fn objects(&self) -> Vec<(u16, Span)> {
        Vec::new()
    }

    /// How many devices it describes, without variants.
    fn device_count(&self) -> usize {
        1
    }

    /// The same text as another of its devices or variants, counted from 0; `None` where there are fewer.
    fn sibling(&self, _number: usize) -> Option<ReadText> {
        None
    }

    /// The names of its variants, which are the siblings behind the first.
    fn variants(&self) -> Vec<String> {
        Vec::new()
    }

    /// The variant that it was read as.
    fn variant(&self) -> Option<&str> {
        None
    }

    /// The file that it extends, with the span of the name.
    fn extended(&self) -> Option<(&str, Span)> {
        None
    }

    /// The files that it extends, the nearest first.
    fn extended_files(&self) -> &[PathBuf] {
        &[]
    }

    /// Where it names its objects, if it is a `device.toml`.
    #[cfg(feature = "full")]
    fn mentions(&self) -> Option<Vec<crate::mention::Mention>> {
        None
    }

    /// It as lines, if it is an INI file.
    fn lines(&self) -> Option<&ini::Document> {
        None
    }

    /// What was read of its lines, for reading them again with edits.
    fn read_lines(&self) -> Option<LinesBefore<'_>> {
        None
    }

    /// It as elements, if it is XML of CiA 311.
    #[cfg(feature = "xdd")]
    fn tree(&self) -> Option<&Tree> {
        None
    }

    /// Whether it is a project of another program, which is never changed.
    fn is_project(&self) -> bool {
        false
    }

    /// Whether it is a network of devices.
    fn is_network(&self) -> bool {
        false
    }

    /// What validation with the schema of its format refuses.
    fn violations(&self) -> Findings {
        Findings::new()
    }

    /// What it shows beyond what its reader found.
    fn findings(&self) -> Findings {
        Findings::new()
    }

    /// The edits that make changes of the device; `None` where it has no place for one of them.
    fn edits(&self, _device: &Device, _changes: &[Change]) -> Option<TextEdits> {
        None
    }

    /// Whether it can be read with edits, where making them does not show that.
    fn can_take(&self, _edits: &TextEdits) -> bool {
        true
    }

    /// Its bytes as the description of a node, or without one of a type, in a file of this name; `None` where edits do not make
    /// that of it.
    fn of_node(&self, _file_name: &str, _node: Option<NodeOfType<'_>>) -> Option<Result<Vec<u8>, EditError>> {
        None
    }

    /// It in canonical order and spelling, the most thorough first; what is read of it may differ.
    #[cfg(feature = "full")]
    fn arranged<'a>(&'a self, _device: &'a Device) -> Option<Box<dyn Iterator<Item = String> + 'a>> {
        None
    }
}

/// Whether validation refuses nothing in a text that it does not refuse in another one of this description.
pub(crate) fn is_as_valid(text: &dyn DescriptionText, other: &dyn DescriptionText) -> bool {
    let count = |text: &dyn DescriptionText| {
        let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
        text.violations().iter().for_each(|found| *counts.entry(found.rule.id).or_default() += 1);
        counts
    };
    let now = count(text);
    now.is_empty() || {
        let before = count(other);
        now.iter().all(|(rule, now)| before.get(rule).is_some_and(|before| now <= before))
    }
}

/// A device with what a conversion carried in it at its place again; without JSON and XDD nothing is carried.
pub(crate) fn restored((device, findings): (Device, Findings)) -> (Device, Findings) {
    #[cfg(feature = "full")]
    let (device, findings) = crate::embedded::restore(device, findings);
    (device, findings)
}

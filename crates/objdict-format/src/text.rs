//! The text of a description, in the syntax of its format: the interface of each syntax in addition to its
//! reader.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::path::PathBuf;

use objdict_eds::{eds::SectionStarts, ini};
use objdict_model::diagnostic::{Change, Findings};
use objdict_model::model::{Commissioning, Device, Objects, Place};
use objdict_model::source::{EditError, SourceFile, Span};
#[cfg(feature = "xdd")]
use objdict_xdd::xml::Tree;

/// A parsed text, its device, and the findings of the reader.
pub(crate) type ReadText = (Box<dyn DescriptionText>, Device, Findings);

/// Edits: each span with its replacement.
pub(crate) type TextEdits = Vec<(Span, String)>;

/// A node, and the file name of its type's EDS.
pub(crate) type NodeOfType<'a> = (&'a Commissioning, Option<&'a str>);

/// The previous result for an INI file.
#[derive(Clone, Copy)]
pub(crate) struct LinesBefore<'a> {
    pub(crate) document: &'a ini::Document,
    pub(crate) plain: &'a Objects,
    pub(crate) sections: &'a SectionStarts,
    /// Whether its lines were checked without findings.
    pub(crate) is_clean: bool,
}

/// A text, parsed as one of its devices. Syntaxes keep the defaults here for unsupported features, such as
/// variants.
pub(crate) trait DescriptionText: Debug + Send + Sync {
    /// The source.
    fn source(&self) -> &SourceFile;

    /// The span of a place of the model.
    fn locate(&self, place: &Place) -> Option<Span>;

    /// The place in the model at a byte.
    fn place_at(&self, _at: u32) -> Option<Place> {
        None
    }

    /// The spans of dictionary objects, by index, in text order; an object may have several. Empty if unknown.
    fn objects(&self) -> Vec<(u16, Span)> {
        Vec::new()
    }

    /// How many devices it describes, without variants.
    fn device_count(&self) -> usize {
        1
    }

    /// The same text as a different device or variant, by number from 0; `None` if there are fewer.
    fn sibling(&self, _number: usize) -> Option<ReadText> {
        None
    }

    /// The names of its variants, which are the siblings after the first.
    fn variants(&self) -> &[String] {
        &[]
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

    /// Its references to objects, if it is a `device.toml`.
    #[cfg(feature = "full")]
    fn mentions(&self) -> Option<Vec<crate::mention::Mention>> {
        None
    }

    /// It as lines, if it is an INI file.
    fn lines(&self) -> Option<&ini::Document> {
        None
    }

    /// The result of reading its lines, for reading them again with edits.
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

    /// The violations of its format's schema.
    fn violations(&self) -> Findings {
        Findings::new()
    }

    /// Findings in addition to those of its reader.
    fn findings(&self) -> Findings {
        Findings::new()
    }

    /// The edits for changes of the device; `None` if one cannot be expressed.
    fn edits(&self, _device: &Device, _changes: &[Change]) -> Option<TextEdits> {
        None
    }

    /// Whether it can be read with edits, where making them does not show that.
    fn can_take(&self, _edits: &TextEdits) -> bool {
        true
    }

    /// Its bytes as the description of a node, or without one of a type, in a file of this name; `None` if edits cannot
    /// produce that.
    fn of_node(&self, _file_name: &str, _node: Option<NodeOfType<'_>>) -> Option<Result<Vec<u8>, EditError>> {
        None
    }

    /// The text in canonical order and spelling, the most thorough version first; the content may change.
    #[cfg(feature = "full")]
    fn arranged<'a>(&'a self, _device: &'a Device) -> Option<Box<dyn Iterator<Item = String> + 'a>> {
        None
    }
}

/// Whether a text has no violations that another text of this description does not have.
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

/// A device with its embedded content restored; without JSON and XDD nothing is embedded.
pub(crate) fn restored((device, findings): (Device, Findings)) -> (Device, Findings) {
    #[cfg(feature = "full")]
    let (device, findings) = crate::embedded::restore(device, findings);
    (device, findings)
}
